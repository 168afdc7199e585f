// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From a draft to the committed plan: until when the draft is proven, which brake from it is proven, and the commit.
#include "base/math.hpp"
#include "flight/branch.hpp"
#include "flight/flight_state.hpp"
#include "proof/proven_joints.hpp"

namespace tern {

/// Waits for the end of a slide, then begins the proof; from here on the map stands still. Its words are true in the
/// middle of a frame, but not in the middle of a slide.
Progress FlightState::run_wait() noexcept {
  if (!map.safe().bound()) return Progress::kMore;
  const Status begun = begin_proof(draft.wished, start_of_proof());
  job = Job::kReach;
  if (begun != Status::kRunning) give_up();
  return Progress::kDone;
}

/// What every proof of a commitment rests on.
ProofGrounds FlightState::grounds_of(const Commitment& commitment) const noexcept {
  return {nullptr, commitment.leaves ? &commitment.left : nullptr, nullptr, spec.fences, spec.fence_count};
}

/// Begins the current proof anew on the map as it is, if boxes were marked between two ticks while the proof ran.
void FlightState::note_changed_map() noexcept {
  const bool proves_draft = job == Job::kReach || job == Job::kBranch || job == Job::kConfirm;
  if (proven_on == map.safe().revision()) return;
  if (job == Job::kEvade) try_brakes();
  if (proves_draft) job = Job::kWait;
}

/// Begins the proof of a trajectory on the safe grid, with limits.
Status FlightState::begin_proof(const Trajectory& trajectory, double from) noexcept {
  proven_on = map.safe().revision();
  return proof.begin_accepted(map.safe(), trajectory, from, &spec.limits, Beyond::kSolid, grounds_of(draft));
}

double FlightState::start_of_proof() const noexcept {
  return larger(0.0, seconds_between(draft.begin, takeover));
}

Progress FlightState::run_reach(Work& work) noexcept {
  if (prove(work) == Progress::kMore) return Progress::kMore;
  reached = proof.report().until;
  look_at = place_to_see();
  note_view();
  if (!draft.looks_out) note_unproven();
  if (!draft.looks_out && rests_at_takeover() && proof.report().end == ProofEnd::kObstacle) look_at_obstacle();
  if (proof.report().end == ProofEnd::kProven) {
    draft.flown = draft.wished;
    draft.branch = reached;
    if (leads_on()) {
      commit();
    } else {
      fail();
    }
    return Progress::kDone;
  }
  branch = -1;
  tries_branch = false;
  job = Job::kBranch;
  return Progress::kDone;
}

/// Branches must be later than this, in seconds since the draft's beginning. In an extension, a branch no later than
/// the committed one would change nothing. A new plan must lead somewhere before its branch.
double FlightState::earliest_branch() const noexcept {
  return extends ? now.branch : 2.0 * 1e-9 * static_cast<double>(spec.tick);
}

/// A hop of less than a voxel from rest is no progress.
bool FlightState::leads_on() const noexcept {
  const Trajectory& flown = draft.flown;
  const Vec3 end = flown.origin + flown.segments[flown.count - 1].points[kDegree];
  return !rests_at_takeover() || draft.to_goal || distance(end, start.d[0]) >= map.safe().spec().cell;
}

/// Makes candidate `branch`. The candidates go back from the last proven instant, and each instant has all brakes.
bool FlightState::make_branch() noexcept {
  const double earliest = earliest_branch();
  const int from_last = branch / kBranchShapes;
  const double at = off_joints(draft.wished, reached - (reached - earliest) * from_last / kBranches);
  if (!(at > earliest)) return false;
  draft.branch = at;
  take_first_part(draft.wished, at, draft.flown);
  const JointState joint = joint_at(draft.wished, at, draft.wished.origin);
  if (!append_stop(joint, limits, branch % kBranchShapes, stop, draft.flown)) return false;
  if (!leads_on()) return false;
  return begin_proof(draft.flown, at) == Status::kRunning;
}

/// Units that making a candidate costs.
constexpr std::uint32_t kBranchPrice = 32;

/// Makes the candidate after `branch`. After the last one, the draft has failed.
Progress FlightState::next_branch(Work& work) noexcept {
  if (branch + 1 == kBranches * kBranchShapes) {
    fail();
    return Progress::kDone;
  }
  if (work.left < kBranchPrice) return Progress::kMore;
  work.left -= kBranchPrice;
  ++branch;
  tries_branch = make_branch();
  return Progress::kDone;
}

Progress FlightState::run_branch(Work& work) noexcept {
  if (!tries_branch) return next_branch(work);
  if (prove(work) == Progress::kMore) return Progress::kMore;
  tries_branch = false;
  if (proof.report().end != ProofEnd::kProven) return Progress::kDone;
  job = Job::kConfirm;
  begin_proof(draft.flown, start_of_proof());
  return Progress::kDone;
}

Progress FlightState::run_confirm(Work& work) noexcept {
  if (prove(work) == Progress::kMore) return Progress::kMore;
  if (proof.report().end == ProofEnd::kProven) {
    commit();
  } else {
    job = Job::kBranch;
  }
  return Progress::kDone;
}

/// Proves that the draft goes on from the committed plan, without a jump at any joint, and ends at rest. The proofs of
/// obstacles and limits look at each segment alone.
bool FlightState::joins_what_is_flown() noexcept {
  const Commitment& flown = commitment_at(takeover);
  owed += effort_of(kJointEffort, draft.flown.count + 2);
  return follows(evaluate(flown.flown, seconds_between(flown.begin, takeover)),
                 evaluate(draft.flown, start_of_proof())) &&
         joints_hold(draft.flown);
}

/// Makes the draft the committed plan or the waiting one. An extension is the same curve up to the committed branch, so
/// it replaces the committed plan in place. A new plan becomes the waiting plan. A contact before its takeover remains.
void FlightState::enter_draft() noexcept {
  if (!extends && job != Job::kEvade && !draft.looks_out) note_progress();
  job = Job::kIdle;
  if (changes_what_is_flown()) ++report.committed;
  note_lookout();
  idle_cycles = 0;
  is_looking = false;
  if (watching) watch_all = true;
  const bool meets = threat && contact.time < takeover;
  if (meets) before = contact;
  watching = has_alarm = false;
  threat = extends && meets;
  if (extends) {
    now = draft;
  } else {
    next = draft;
    has_next = true;
    meets_before = meets;
  }
}

/// Commits the draft. False, and nothing is committed, if it does not join the committed plan.
bool FlightState::commit() noexcept {
  if (!joins_what_is_flown()) {
    fail();
    return false;
  }
  enter_draft();
  return true;
}

void FlightState::fail() noexcept {
  ++report.failed;
  give_up();
}

void FlightState::give_up() noexcept {
  job = Job::kIdle;
  note_idle();
}

}  // namespace tern
