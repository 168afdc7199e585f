// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight works on: the jobs of a plan and of a brake, what is being proven, and how many candidates there are.
#ifndef TERN_FLIGHT_JOBS_HPP
#define TERN_FLIGHT_JOBS_HPP

#include <cstdint>

#include "flight/branch.hpp"
#include "flight/slow_down.hpp"

namespace tern {

/// Instants of a plan from which a brake is tried, and brakes from each, sharp ones first: those need the least room,
/// and with limits on jerk the sharpest may be too sharp.
constexpr int kBranches = 16;
constexpr int kBranchShapes = kStops;
/// Brakes for a threat: straight ahead, the sharpest one first, and along what is flown.
constexpr int kStraight = 1 + kStops;
constexpr int kEvasions = kStraight + kSlowDowns;
/// Ticks that getting out of the way may take before it begins, at least. Twice as many after every second time that
/// ticks were skipped until it was too late for that, and after every time that no brake was judged by then.
constexpr int kEvadeTicks = 3;
/// Units for proving that what is flown touches at most the alarm, and for judging the sharpest brake. They must fit
/// into the ticks after the first one, next to the yaw's part of each.
constexpr std::uint32_t kEvadeWork = 900;
/// The most doublings of the lead of plans and brakes.
constexpr int kMostDoublings = 3;
/// What is being proven of what is flown.
enum class Watched : std::uint8_t {
  kBefore,  ///< what comes before the takeover
  kLatest,  ///< what is flown to its end
  kAlarm,   ///< the same, but for the alarm
};

/// What is being proven of a brake.
enum class BrakeProof : std::uint8_t {
  kClear,   ///< that it may be flown
  kLimits,  ///< where it is not clear: that it keeps the limits after its contact, too
  kAlarm,   ///< that it is clear of everything but the alarm
};

/// What the flight works on. A cycle makes one plan; evading makes a brake.
enum class Job : std::uint8_t {
  kIdle,
  kCopy,     ///< the route grid
  kKeep,     ///< is the rest of the plan that is flown still free on the route?
  kLookout,  ///< a place from where what blocks the way may be seen
  kRoute,    ///< the way to the goal, of which the plan is the first part
  kPlan,     ///< the planner
  kWait,     ///< for the window to be done with its slide
  kReach,    ///< until when is the best plan proven?
  kBranch,   ///< a brake from there or before
  kConfirm,  ///< the whole of what would be flown
  kEvade,    ///< brakes from a few ticks ahead
};

}  // namespace tern

#endif
