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
#include "corridor/grow_scratch.hpp"
#include "planner/end_stop.hpp"
#include "planner/previous.hpp"
#include "planner/problem.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

namespace tern {

struct Follow {
  bool is_trial;               ///< the remainder is tried before a new plan is looked for
  bool leads_plan;             ///< the current plan begins with the remainder
  bool held;                   ///< the remainder was tried, and holds
  double held_duration;        ///< of that remainder, s
  Operations held_operations;  ///< that it takes to enclose that remainder
};

/// True if the remainder is to be tried before a new plan is looked for: it leads to the goal.
bool follow_trial_is_due(const Previous& previous) noexcept;

/// True if following the previous plan may help after this failure. A remainder that ends elsewhere than at the goal
/// cannot help if no voxel near the goal is free.
bool follow_may_help(const Problem& problem, const Previous& previous, Status failure) noexcept;

/// Begins the try of the remainder.
void follow_begin(Follow& follow, Previous& previous) noexcept;

/// Encloses the remainder in polyhedra. The pieces of work are those of append_advance. kDone: if the remainder meets
/// the goal, it is the whole plan, in `corridor` and `trajectory`; otherwise it is the start's stop, `lead`. kFailed:
/// previous.enclosure.status says why.
Progress follow_advance(const Problem& problem, const Ends& ends, Follow& follow, Previous& previous,
                        GrowScratch& scratch, EndStop& lead, Corridor& corridor, Trajectory& trajectory,
                        Work& work) noexcept;

/// Notes the result of a trial: whether the check passed the remainder, which is then in `trajectory`, and the
/// operations that it took.
void follow_note_trial(bool holds, const Trajectory& trajectory, Operations spent, Follow& follow) noexcept;

/// True if the plan is to follow the remainder that held, because `trajectory` does not arrive earlier. `left`: the
/// operations that are left to enclose it.
bool prefers_remainder(const Follow& follow, const Previous& previous, const Trajectory& trajectory,
                       Operations left) noexcept;

/// The jerk with which the plan begins.
inline const Vec3& start_jerk(const Problem& problem, const Follow& follow, const Previous& previous) noexcept {
  return follow.leads_plan ? previous.jerk : problem.asked.start.jerk;
}

}  // namespace tern

#endif
