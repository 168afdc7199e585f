// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rest of the plan that is being flown, Request::previous. It is flown if the planner finds no plan that arrives
// earlier.
#ifndef TERN_PLANNER_PREVIOUS_HPP
#define TERN_PLANNER_PREVIOUS_HPP

#include <cstdint>

#include "planner/tube.hpp"
#include "tern/grid.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Ways in which the rest is tried at most: cut_previous(), then cut_again().
constexpr int kPreviousTries = 6;

/// Ways in which the rest is tried at most if kLeastRest or more is left of the segment that is being flown.
constexpr int kLongRestTries = 3;

/// The least remainder of a segment that is made anew from the states at its ends, seconds. The derivatives of a
/// shorter one would be rounded too much.
constexpr double kLeastRest = 1e-3;

/// The most half-spaces for enclosing the rest, before a new plan is looked for and after it. The last factor 2 is for
/// segments that had no room and were halved.
constexpr std::uint32_t kPreviousPlanes =
    2u * static_cast<std::uint32_t>(kPreviousTries) * 2u * static_cast<std::uint32_t>(kMaxSegments) * kMaxPlanes;

/// The rest of a plan. Plain data.
struct Previous {
  int count;          ///< segments; 0 if nothing is left to fly
  int next;           ///< the first segment that has no polyhedron yet
  int enclosed;       ///< parts of segments that have a polyhedron
  bool is_enclosing;  ///< the next segment is being enclosed
  SegmentEnclosure enclosure;
  int tries;          ///< 0 .. last_try
  int last_try;       ///< kPreviousTries if less than kLeastRest is left of the first segment; else kLongRestTries
  bool meets_goal;    ///< the rest ends at the goal of the current plan
  bool in_own_frame;  ///< `origin` is that of the previous plan; else the requested start
  Vec3 jerk;          ///< at its beginning, m/s^3
  Vec3 origin;        ///< of the segments, in the world frame
  Segment segments[kMaxSegments];
  Trajectory plan;  ///< the whole previous plan, for cut_again() and the pace
};

/// True if its numbers are sound: counts in range, durations above 0, everything finite.
bool is_trajectory(const Trajectory& plan) noexcept;

/// True if request.previous is a valid trajectory whose state at request.previous_time is request.start, bit for bit.
bool previous_fits(const Request& request) noexcept;

/// Cuts request.previous, if there is one, at request.previous_time. previous_fits() must be true. Makes the segments
/// anew from the states at their joints, relative to the requested start, so they are rounded like any other plan from
/// there. If less than kLeastRest is left of the segment that is being flown, it becomes one piece with the beginning
/// of the next one. Tries nothing yet.
void cut_previous(const Grid& grid, const Request& request, Previous& rest) noexcept;

/// Cuts rest.plan once more, for try number rest.tries, 2 .. rest.last_try, after the try before failed. The rest must
/// not be empty. There are two ways. In the frame of the previous plan, segments that are left whole keep their bits,
/// which moving coordinates would round. Relative to the requested start, each segment is placed by how far it moves.
/// If kLeastRest or more is left of the first segment, try 2 is in the previous plan's frame and try 3 is relative to
/// the start. If less is left, the tries are relative to the start, with less and less of the next segment joined to
/// the first, then with none. The last try is in the previous plan's frame.
void cut_again(const Request& request, Previous& rest) noexcept;

/// The end of the rest, relative to `origin`. The rest must not be empty.
inline const Vec3& end_of(const Previous& rest) noexcept {
  return rest.segments[rest.count - 1].points[kDegree];
}

}  // namespace tern

#endif
