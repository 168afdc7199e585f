// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the cells of a flood to a path with a time for each leg.
#ifndef TERN_FLOOD_TIMED_WAY_HPP
#define TERN_FLOOD_TIMED_WAY_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "flood/timed_flood.hpp"
#include "tern/config.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Legs last no longer than this, s, unless they rest or there were too many.
constexpr double kLongestLeg = 1.3;

/// Several floods, one behind the other, may lead a way. Local frame of the grid.
struct TimedWay {
  std::int32_t count;             ///< legs
  Vec3 points[kMaxWaypoints];     ///< count + 1
  double duration[kMaxSegments];  ///< s, of each leg
  std::int32_t knot;              ///< layer at which the next leg begins
  std::int32_t trial;             ///< layer at which it may end
  std::int32_t longest;           ///< layers of a leg
};

/// Begins to append the flood's way to `count` legs, in `most` legs or somewhat more.
void timed_way_begin(const TimedFlood& flood, std::int32_t most, TimedWay& way) noexcept;

/// Makes each leg as long as sight and things allow, a straight line flown evenly. A piece of work is a look along a
/// leg. kFailed: there are too many legs.
Progress timed_way_advance(const TimedFlood& flood, const Grid& grid, TimedWay& way, Work& work) noexcept;

}  // namespace tern

#endif
