// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The attempt to follow the previous plan. Its remainder is proven on the current map before the search for a new plan,
// so that a remainder that does not hold costs little. A new plan must arrive earlier than a remainder that leads to
// the goal. If the remainder is to be followed, it is proven once more, because the new plan took its memory.
//
// A remainder that leads to the goal is a plan by itself: the previous one, from the requested start on. Any other is
// what a new plan begins with.
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
  bool leads_plan;         ///< the current plan begins with the remainder, and leads on from its end
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

/// Notes the result of a trial: whether the check passed the remainder.
void follow_note_trial(bool proven, const Problem& problem, const Previous& previous, Follow& follow) noexcept;

/// True if a new plan arrives earlier than the remainder of the plan before it: by more than a microsecond, so that two
/// plans that differ by rounding do not take turns. Both in seconds from the same instant on.
inline bool arrives_earlier(double plan, double remainder) noexcept {
  constexpr double kMargin = 1e-6;
  return plan < remainder - kMargin;
}

/// True if the plan is to follow the remainder that was proven, because `trajectory`, a new plan, does not arrive
/// earlier.
bool prefers_remainder(const Follow& follow, const Trajectory& trajectory) noexcept;

}  // namespace tern

#endif
