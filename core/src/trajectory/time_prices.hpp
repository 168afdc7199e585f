// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What time is worth to each segment: the derivative of a programme's optimal snap with respect to the durations.
#ifndef TERN_TRAJECTORY_TIME_PRICES_HPP
#define TERN_TRAJECTORY_TIME_PRICES_HPP

#include "trajectory/programme.hpp"

namespace tern {

/// prices[i] = -T_i dJ/dT_i in m^2/s^7, where J is the least integral of squared snap that the rows allow: by how much
/// J falls per relative growth of segment i's duration. By the envelope theorem this is the derivative of the
/// Lagrangian with the joints' states and the multipliers fixed, so it takes no further solve. An active row that
/// presses on a segment raises its price. A price is negative if a shorter segment would have less snap. `points`: the
/// solution's control points.
void time_prices(const Chain& chain, const QpProblem& problem, const QpSolution& solution, const ProgrammeScale& scale,
                 const Vec3 (*points)[kControlPoints], double* prices) noexcept;

}  // namespace tern

#endif
