// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rows of a limit on body rates: what they are in a programme, and what a solution says about them.
#ifndef TERN_TRAJECTORY_TURNING_ROWS_HPP
#define TERN_TRAJECTORY_TURNING_ROWS_HPP

#include "trajectory/programme.hpp"

namespace tern {

/// The jerk point nearest in time to an acceleration point of the segment.
constexpr int nearest_jerk_point(int acceleration_point) {
  constexpr int kJerks = kJerkPoints - 1;
  constexpr int kAccelerations = kAccelerationPoints - 1;
  return (2 * kJerks * acceleration_point + kAccelerations) / (2 * kAccelerations);
}

/// Adds the planes and groups for `count` segments: a plane below the thrust at the acceleration points nearest to each
/// instant, and four around the jerk there. The points from `accelerations` and from `jerks` on are those of their
/// order.
void add_turning_rows(const Turning& turning, int count, int accelerations, int jerks, ProgrammeScale& scale,
                      QpProblem& problem) noexcept;

/// Sets the shares from what the rows cost the solution. A bound on jerk that costs more than the one on thrust asks
/// for more of both.
void share_turning(const QpProblem& problem, const QpSolution& solution, const ProgrammeScale& scale, int count,
                   Turning& turning) noexcept;

}  // namespace tern

#endif
