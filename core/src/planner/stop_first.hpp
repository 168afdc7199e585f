// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The last attempt for an end in motion, if neither the corridor nor a detour has room for the motion: the plan stops
// first, and goes on from there. Near the goal, one curve may lead straight into the motion of the goal instead.
#ifndef TERN_PLANNER_STOP_FIRST_HPP
#define TERN_PLANNER_STOP_FIRST_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "curve/stopping.hpp"
#include "planner/end_stop.hpp"
#include "planner/problem.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

namespace tern {

/// The most stops from which a plan tries to go on. From the first ones there may be no path.
constexpr std::uint32_t kStopFirstTries = 3;

struct StopFirst {
  std::uint32_t tries;    ///< stops that the plan has tried to go on from; of the current goal
  std::int32_t arrivals;  ///< durations of an arrival that were tried
  bool arrived;           ///< an arrival has room: it is the whole plan
};

/// True if coming to rest first may help: an end is in motion, and the failure depends on that motion or on the place
/// where the path begins.
bool stop_first_may_help(const Problem& problem, const StopFirst& stop_first, Stage stage, Status status) noexcept;

/// Begins another try. `stops` are those of the start and of the goal. A second try discards one of them: the
/// start's, if the start is in motion.
void stop_first_begin(const Problem& problem, StopFirst& stop_first, EndStop* stops) noexcept;

/// Finds a stop for each end in motion that has none. The pieces of work are those of stop_advance. kDone: `ends` are
/// now the places of rest, or `arrived` is set, and room.curve is the arrival. kFailed: some end has no stop left.
Progress stop_first_advance(const Problem& problem, const RoomProof& room, StopFirst& stop_first, EndStop* stops,
                            Ends& ends, Work& work) noexcept;

}  // namespace tern

#endif
