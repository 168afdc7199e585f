// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is left of the plan that is being flown, Request::previous: proof that its state can be flown on from, where
// nothing new is found.
#ifndef TERN_PLANNER_PREVIOUS_HPP
#define TERN_PLANNER_PREVIOUS_HPP

#include <cstdint>

#include "tern/grid.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// Report::detours of a plan that flies on along the previous one.
constexpr std::int32_t kFollowed = 3;

/// Frames that the rest is tried in. Coordinates that are moved round: first its beginning counts most, relative to the
/// start that was asked for; then its later segments, as the previous plan has them.
constexpr int kPreviousTries = 2;

/// Where less than this is left of the segment at hand, in seconds, its cut rounds to other derivatives.
constexpr double kLeastRest = 1e-3;

/// Half-spaces that enclosing it makes at most: each segment is the last half of one that had no room.
constexpr std::uint32_t kPreviousPlanes =
    static_cast<std::uint32_t>(kPreviousTries) * 2u * static_cast<std::uint32_t>(kMaxSegments) * kMaxPlanes;

/// The rest of a plan. Plain data.
struct Previous {
  int count;        ///< segments; 0 where there is no rest to fly
  int next;         ///< the first that has no polyhedron yet
  int enclosed;     ///< parts that have one
  int tries;        ///< 0 .. kPreviousTries
  bool flown;       ///< the plan at hand begins with it
  bool meets_goal;  ///< it ends where the plan at hand is to end
  Vec3 jerk;        ///< at its beginning, m/s^3
  Vec3 origin;      ///< world frame: of the segments
  Segment segments[kMaxSegments];
  Trajectory plan;  ///< the whole of it, for another try
};

/// True where request.previous is a trajectory that has request.start at request.previous_time, bit for bit.
bool previous_fits(const Request& request) noexcept;

/// Cuts request.previous, where there is one, at request.previous_time. It has to fit. The segments are made anew from
/// the states at their joints, so that they round as any other plan from here does. Nothing is tried yet.
void cut_previous(const Grid& grid, const Request& request, Previous& rest) noexcept;

/// The same in the previous plan's frame: all segments but the first are its own, bit for bit.
void cut_in_place(double time, Previous& rest) noexcept;

/// Where the rest ends, relative to the start; it must not be empty.
inline const Vec3& end_of(const Previous& rest) noexcept {
  return rest.segments[rest.count - 1].points[kDegree];
}

}  // namespace tern

#endif
