// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Brakes from a few ticks ahead: where something came into the way, and where the user says stop.
#include "base/math.hpp"
#include "curve/brake.hpp"
#include "flight/branch.hpp"
#include "flight/flight_state.hpp"

namespace tern {
namespace {

/// A brake that touches at most the alarm comes first, then the slowest contact, then the latest one.
bool is_better(const Evasion& a, const Evasion& b) {
  if (b.number < 0) return true;
  if (a.known != b.known) return a.known;
  return a.speed < b.speed || (!(a.speed > b.speed) && a.until > b.until);
}

/// Something in the way ended the proof, not the brake itself.
bool is_contact(ProofEnd end) {
  return end == ProofEnd::kObstacle || end == ProofEnd::kOutside || end == ProofEnd::kFence;
}

/// Instructions of making a brake straight ahead, and one along what is flown.
constexpr std::uint32_t kStopEffort = 25000;
constexpr std::uint32_t kSlowDownEffort = 90000;

/// No trajectory comes near to this.
constexpr double kNowhere = 1e300;
constexpr Box kNowhereBox{{kNowhere, kNowhere, kNowhere}, {kNowhere, kNowhere, kNowhere}};

}  // namespace

void FlightState::begin_evade() noexcept {
  const std::int64_t lead = (kEvadeTicks << missed / 2) * spec.tick;
  const bool needed = !rests() && (threat || commitment_at(time).branch > 0.0);
  stops = stopping;
  stopping = false;
  evaded = true;
  if (!needed || (threat && rest_begins() <= time + lead)) return;
  has_next = false;
  takeover = time + lead;
  deadline = takeover - spec.tick;
  job = Job::kEvade;
  best.number = branch = -1;
  extends = false;
  next_evasion();
}

bool FlightState::make_evasion() noexcept {
  owed += branch < kStops ? kStopEffort : kSlowDownEffort;
  const Commitment& commitment = commitment_at(takeover);
  draft.begin = takeover;
  draft.branch = 0.0;
  draft.goal = goal_number;
  draft.target = itinerary.leg;
  draft.passages = 0;
  draft.to_goal = draft.beside_goal = false;
  draft.evades = threat;
  draft.leaves = commitment.leaves;
  draft.left = commitment.left;
  draft.flown.count = 0;
  draft.flown.origin = evaluate(commitment.flown, seconds_between(commitment.begin, takeover)).position;
  if (!append_evasion(commitment, seconds_between(commitment.begin, takeover))) return false;
  draft.wished = draft.flown;
  draft.aim = draft.flown.origin + draft.flown.segments[draft.flown.count - 1].points[kDegree];
  return true;
}

/// Straight ahead, or along what is flown.
bool FlightState::append_evasion(const Commitment& flown, double from) noexcept {
  const JointState at = joint_at(flown.flown, from, draft.flown.origin);
  if (branch < kStops) return append_stop(at, limits, branch, stop, draft.flown);
  return append_slow_down(flown.flown, from, slow_down_time(at.d[1], limits, branch - kStops), draft.flown);
}

/// The sharpest brake first.
void FlightState::next_evasion() noexcept {
  while (++branch < kEvasions) {
    if (make_evasion() && begin_brake_proof(BrakeProof::kClear)) return;
  }
  end_evade();
}

/// Limits alone are proven from the contact on, with no obstacle in the way; the brake must end within the window.
bool FlightState::begin_brake_proof(BrakeProof what) noexcept {
  proves = what;
  ProofGrounds grounds = grounds_of(draft);
  if (what == BrakeProof::kAlarm) grounds.alarm = &alarm;
  if (what == BrakeProof::kLimits) grounds.added = &kNowhereBox;
  const double from = what == BrakeProof::kLimits ? tried.until : 0.0;
  const Beyond beyond = what == BrakeProof::kLimits ? Beyond::kEmpty : Beyond::kSolid;
  return proof.begin(map.safe(), draft.flown, from, &spec.limits, beyond, grounds) == Status::kRunning;
}

Progress FlightState::run_evade(Work& work) noexcept {
  if (prove(work) == Progress::kMore) return Progress::kMore;
  const bool proven = proof.report().end == ProofEnd::kProven;
  if (proven && proves == BrakeProof::kClear) {
    missed = 0;
    commit();
    return Progress::kDone;
  }
  if (go_on_proving(proven)) return Progress::kDone;
  next_evasion();
  return Progress::kDone;
}

/// A brake that is not clear may still be flown if it keeps the limits, and is then judged by its contact. True where
/// there is more to prove of it.
bool FlightState::go_on_proving(bool proven) noexcept {
  if (proves == BrakeProof::kClear) {
    if (!is_contact(proof.report().end)) return false;
    const double until = proof.report().until;
    tried = {branch, until, length(evaluate(draft.flown, until).velocity), true};
    return is_better(tried, best) && begin_brake_proof(BrakeProof::kLimits);
  }
  if (proves == BrakeProof::kLimits) {
    if (!proven) return false;
    if (has_alarm && begin_brake_proof(BrakeProof::kAlarm)) return true;
    proven = false;
  }
  tried.known = proven;
  if (is_better(tried, best)) best = tried;
  return false;
}

/// None is proven. Of those that touch at most the alarm, the one with the slowest contact is flown; of the others,
/// only where what is flown may touch more than the alarm, too. Either must be slower there than what is flown. The
/// threat remains.
void FlightState::end_evade() noexcept {
  missed = 0;
  branch = best.number;
  const bool helps = best.number >= 0 && (best.speed < contact_speed || (best.known && !known));
  if (!threat || !helps || (known && !best.known) || !make_evasion()) return give_up();
  const Alarm raised = alarm;
  const bool is_raised = has_alarm;
  commit();
  alarm = raised;
  has_alarm = is_raised;
  threat = true;
  known = best.known;
  contact = takeover + nanoseconds(best.until);
  contact_speed = best.speed;
}

/// Ticks were skipped until the brake at hand was due. Brakes are tried again from here, unless there is a new goal now
/// and no threat.
void FlightState::miss_evasion() noexcept {
  evaded = false;
  stopping = stopping || (stops && !has_goal);
  if (missed < 2 * kMostDoublings) ++missed;
}

/// A plan in work may go on under a threat if its end leaves time to brake, should it fail: twice as long as the
/// sharpest brake takes, and what comes before it.
bool FlightState::leaves_time_to_brake() const noexcept {
  if (job == Job::kIdle || takeover >= contact) return false;
  const Vec3& most = spec.limits.a_max;
  const double weakest = smaller(most.x, smaller(most.y, most.z));
  const double needed = 2.0 * length(sample_at(takeover).velocity) / weakest + 2.0 * kSettleTime;
  return seconds_between(takeover + kEvadeTicks * spec.tick, contact) > needed;
}

}  // namespace tern
