// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Brakes from a few ticks ahead: where something came into the way, and where the user says stop.
#include "base/math.hpp"
#include "curve/brake.hpp"
#include "flight/branch.hpp"
#include "flight/flight_state.hpp"

namespace tern {

void FlightState::begin_evade() noexcept {
  const bool needed = !rests() && (threat || course_at(time).branch > 0.0);
  stopping = false;
  evaded = true;
  if (!needed || (threat && rest_begins() <= time + kEvadeTicks * spec.tick)) return;
  has_next = false;
  takeover = time + kEvadeTicks * spec.tick;
  deadline = takeover - spec.tick;
  job = Job::kEvade;
  best_until = -1.0;
  best_shape = branch = -1;
  extends = false;
  next_evasion();
}

bool FlightState::make_evasion() noexcept {
  const Course& course = course_at(takeover);
  draft.begin = takeover;
  draft.branch = 0.0;
  draft.goal = goal_number;
  draft.to_goal = draft.beside_goal = false;
  draft.flown.count = 0;
  draft.flown.origin = evaluate(course.flown, seconds_between(course.begin, takeover)).position;
  const JointState at = joint_at(course.flown, seconds_between(course.begin, takeover), draft.flown.origin);
  if (!append_stop(at, limits, branch, stop, draft.flown)) return false;
  draft.wished = draft.flown;
  draft.aim = draft.flown.origin + draft.flown.segments[draft.flown.count - 1].points[kDegree];
  return true;
}

/// The sharpest brake first.
void FlightState::next_evasion() noexcept {
  while (++branch < kStops) {
    if (!make_evasion()) continue;
    if (proof.begin(map.safe(), draft.flown, 0.0, &spec.limits, Beyond::kSolid) == Status::kRunning) return;
  }
  end_evade();
}

Progress FlightState::run_evade(Work& work) noexcept {
  if (prove(work) == Progress::kMore) return Progress::kMore;
  if (proof.report().end == ProofEnd::kProven) {
    commit();
    return Progress::kDone;
  }
  if (proof.report().until > best_until) {
    best_until = proof.report().until;
    best_shape = branch;
  }
  next_evasion();
  return Progress::kDone;
}

/// None is proven. Of what is left, the brake that is proven for longest, if that is later than what is flown; the
/// threat remains.
void FlightState::end_evade() noexcept {
  const std::int64_t best = takeover + nanoseconds(larger(0.0, best_until));
  branch = best_shape;
  if (!threat || best_shape < 0 || best <= contact || !make_evasion()) return give_up();
  commit();
  threat = true;
  contact = best;
  contact_speed = length(evaluate(draft.flown, best_until).velocity);
}

}  // namespace tern
