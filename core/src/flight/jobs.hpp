// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The jobs of a flight, for plans and for brakes: what each of them proves, and how many candidates it tries.
#ifndef TERN_FLIGHT_JOBS_HPP
#define TERN_FLIGHT_JOBS_HPP

#include <cstdint>

#include "flight/branch.hpp"
#include "flight/slow_down.hpp"

namespace tern {

/// How many instants of a plan a brake is tried from, and how many brakes from each, the sharpest first. Sharp brakes
/// need the least room, but the sharpest may break the limits on jerk.
constexpr int kBranches = 16;
constexpr int kBranchShapes = kStops;
/// How many brakes are tried under a threat: straight ahead, the sharpest first, and along the committed plan.
constexpr int kStraight = 1 + kStops;
constexpr int kEvasions = kStraight + kSlowDowns;
/// The fewest ticks from the start of an evasion to its brake. They double after every second evasion that skipped
/// ticks made late, and after every evasion that had no time to judge a brake.
constexpr int kEvadeTicks = 3;
/// Units to prove that the committed plan touches at most the alarm, and to judge the sharpest brake. They must fit
/// into the ticks after the first, beside the share that the yaw takes of each tick.
constexpr std::uint32_t kEvadeWork = 900;
/// The most doublings of the lead of plans and brakes.
constexpr int kMostDoublings = 3;
/// Which part of the committed plan is being proven.
enum class Watched : std::uint8_t {
  kBefore,  ///< the plan in flight, up to the takeover of the waiting plan
  kLatest,  ///< the latest committed plan, to its end
  kAlarm,   ///< the latest committed plan, without the obstacles of the alarm
};

/// Which property of a brake is being proven.
enum class BrakeProof : std::uint8_t {
  kClear,   ///< it is clear and keeps the limits: it may be flown
  kLimits,  ///< it is not clear, but keeps the limits after its contact as well
  kAlarm,   ///< it is clear of everything but the alarm
};

/// The flight's current job. A cycle makes one plan; an evasion makes a brake.
enum class Job : std::uint8_t {
  kIdle,
  kCopy,     ///< copies the route grid
  kKeep,     ///< proves the rest of the planner's plan in flight free on the copy
  kLookout,  ///< seeks a place from where the sensor may see what blocks the way
  kRoute,    ///< finds the way to the goal; the plan follows its first part
  kPlan,     ///< runs the planner
  kWait,     ///< waits until the window has slid
  kReach,    ///< finds until when the draft is proven
  kBranch,   ///< finds a proven brake that leaves the draft there or earlier
  kConfirm,  ///< proves the draft with its brake as a whole
  kEvade,    ///< finds a brake that begins a few ticks ahead
};

}  // namespace tern

#endif
