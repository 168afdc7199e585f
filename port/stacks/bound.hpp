// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far an export is from the plan: bounds for all times, from the control points of the difference.
#ifndef TERN_STACKS_BOUND_HPP
#define TERN_STACKS_BOUND_HPP

#include "tern_stacks/stacks.hpp"

namespace tern {

/// Widens `error` by a curve that is flown from `begin` on, seconds since the plan's beginning; its control points are
/// relative to `origin`. The part after the plan's end does not count.
void widen_by_curve(const Trajectory& plan, const Segment& flown, const Vec3& origin, double begin,
                    ExportError& error) noexcept;

/// Widens `error` by a yaw polynomial from `begin` on, with the Bernstein coefficients `points`, rad. A null plan makes
/// no error.
void widen_by_yaw(const YawPlan* plan, const double (&points)[kControlPoints], double begin, double duration,
                  ExportError& error) noexcept;

}  // namespace tern

#endif
