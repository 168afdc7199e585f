// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A yaw plan over one segment as a polynomial of degree 7.
#ifndef TERN_STACKS_YAW_PIECE_HPP
#define TERN_STACKS_YAW_PIECE_HPP

#include "tern/yaw.hpp"

namespace tern {

/// Bernstein coefficients, rad, over [begin, begin + duration]: they agree with the plan in angle, rate and
/// acceleration at both ends, and in angle at a third and two thirds. A null plan is yaw 0.
void yaw_piece(const YawPlan* plan, double begin, double duration, double (&points)[kControlPoints]) noexcept;

}  // namespace tern

#endif
