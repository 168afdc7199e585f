// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rest of the plan that is being flown, Request::previous. It is flown if the planner finds no plan that arrives
// earlier. A rest that leads to the goal is the previous plan itself, from a time on it: nothing is cut, so nothing is
// rounded. Only a rest that a new plan leads on from is made anew.
#ifndef TERN_PLANNER_PREVIOUS_HPP
#define TERN_PLANNER_PREVIOUS_HPP

#include <cstdint>

#include "tern/grid.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// The least remainder of the last segment that is made anew, seconds.
constexpr double kLeastRest = 1e-3;

/// The rest of a plan. Plain data.
struct Previous {
  bool tried;
  bool meets_goal;                 ///< something is left, and it ends at the goal of the current plan, in its motion
  Vec3 jerk;                       ///< at the beginning of the rest, m/s^3
  int count;                       ///< segments of a rest that ends elsewhere; 0 if nothing is left to fly
  Segment segments[kMaxSegments];  ///< of that rest, relative to the requested start
  Trajectory plan;                 ///< the whole previous plan
};

/// True if its numbers are sound: counts in range, durations above 0, everything finite.
bool is_trajectory(const Trajectory& plan) noexcept;

/// True if request.previous is a valid trajectory whose state at request.previous_time is request.start, bit for bit.
bool previous_fits(const Request& request) noexcept;

/// Takes what is left of request.previous, if there is one, at request.previous_time. previous_fits() must be true.
/// Tries nothing yet.
///
/// If the rest ends elsewhere than at the goal, makes its segments anew from the states at their joints, relative to
/// the requested start, so they are rounded like any other plan from there. Each is placed by how far it moves: its
/// rounding does not depend on where in the plan it lies, nor on how little is left of the first one. If less than
/// kLeastRest is left of the last segment, nothing is.
void take_rest(const Grid& grid, const Request& request, Previous& rest) noexcept;

/// The end of a rest that ends elsewhere, relative to the requested start. The rest must not be empty.
inline const Vec3& end_of(const Previous& rest) noexcept {
  return rest.segments[rest.count - 1].points[kDegree];
}

}  // namespace tern

#endif
