// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The attempt to follow the previous plan. Its remainder is proven on the current map before the search for a new plan,
// so that a remainder that does not hold costs little. A new plan must arrive earlier than a remainder that leads to
// the goal. If the remainder is to be followed, it is proven once more, because the new plan took its memory.
#ifndef TERN_PLANNER_FOLLOW_HPP
#define TERN_PLANNER_FOLLOW_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "planner/end_stop.hpp"
#include "planner/previous.hpp"
#include "planner/problem.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

namespace tern {

struct Follow {
  bool is_trial;           ///< the remainder is tried before a new plan is looked for
  bool leads_plan;         ///< the current plan begins with the remainder
  bool proven;             ///< the remainder was tried, and is proven
  double proven_duration;  ///< of that remainder, s
};

/// True if the remainder is to be tried before a new plan is looked for: it leads to the goal.
bool follow_trial_is_due(const Previous& previous) noexcept;

/// True if following the previous plan may help after this failure. A remainder that ends elsewhere than at the goal
/// cannot help if no voxel near the goal is free.
bool follow_may_help(const Problem& problem, const Previous& previous, Status failure) noexcept;

/// Begins the try of the remainder.
void follow_begin(const RoomProof& room, Follow& follow, Previous& previous) noexcept;

/// A piece of work takes a remainder that meets the goal: it is the whole plan, in room.curve, and the check will prove
/// it. Any other is to be the start's stop, `lead`. It must have room, because the way goes on where it ends; the
/// pieces are those of prove_room. kDone, or kFailed: it has no room.
Progress follow_advance(const RoomProof& room, Follow& follow, const Previous& previous, EndStop& lead,
                        Work& work) noexcept;

/// Notes the result of a trial: whether the check passed the remainder, which is then in `trajectory`.
void follow_note_trial(bool proven, const Trajectory& trajectory, Follow& follow) noexcept;

/// True if the plan is to follow the remainder that was proven, because `trajectory` does not arrive earlier.
bool prefers_remainder(const Follow& follow, const Previous& previous, const Trajectory& trajectory) noexcept;

/// The jerk with which the plan begins.
inline const Vec3& start_jerk(const Problem& problem, const Follow& follow, const Previous& previous) noexcept {
  return follow.leads_plan ? previous.jerk : problem.asked.start.jerk;
}

}  // namespace tern

#endif
