// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/follow.hpp"

#include "base/too_narrow.hpp"
#include "curve/rest.hpp"

namespace tern {
namespace {

/// The whole previous plan. No polyhedron of the current corridor was made for it.
void copy_plan(const Trajectory& plan, Trajectory& curve) {
  curve = plan;
  for (int i = 0; i < curve.count; ++i) curve.segments[i].polyhedron = kNoPolyhedron;
}

}  // namespace

bool follow_trial_is_due(const Previous& previous) noexcept {
  return previous.meets_goal;
}

bool follow_may_help(const Problem& problem, const Previous& previous, Status failure) noexcept {
  if (previous.tried) return false;
  return previous.meets_goal || (previous.count > 0 && !lacks_goal_voxel(failure) && !at_rest(problem.asked.start));
}

void follow_begin(const RoomProof& room, Follow& follow, Previous& previous) noexcept {
  previous.tried = true;
  follow.leads_plan = false;
  check_begin(room.stage);
  if (previous.meets_goal) return copy_plan(previous.plan, room.curve);
  room.curve.count = previous.count;
  for (int i = 0; i < previous.count; ++i) room.curve.segments[i] = previous.segments[i];
}

Progress follow_advance(const RoomProof& room, Follow& follow, const Previous& previous, EndStop& lead,
                        Work& work) noexcept {
  if (previous.meets_goal) {
    if (!work.left()) return Progress::kMore;
    work.spend(ops::kCurve * previous.plan.count);
    return Progress::kDone;
  }
  const Progress progress = prove_room(room, 0.0, work);
  if (progress != Progress::kDone) return progress;
  lead.count = previous.count;
  for (int i = 0; i < previous.count; ++i) lead.segments[i] = previous.segments[i];
  lead.place = end_of(previous);
  follow.leads_plan = true;
  return Progress::kDone;
}

void follow_note_trial(bool proven, const Problem& problem, const Previous& previous, Follow& follow) noexcept {
  follow.proven = proven;
  follow.proven_duration = duration(previous.plan) - problem.asked.previous_time;
}

bool prefers_remainder(const Follow& follow, const Trajectory& trajectory) noexcept {
  return follow.proven && !arrives_earlier(duration(trajectory), follow.proven_duration);
}

}  // namespace tern
