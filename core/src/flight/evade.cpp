// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Brakes from a few ticks ahead: where something came into the way, and where the user says stop.
#include "base/math.hpp"
#include "curve/brake.hpp"
#include "flight/branch.hpp"
#include "flight/flight_state.hpp"
#include "flight/sharp_stop.hpp"

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

/// Until a brake begins. A yaw plan may take a quarter of each tick's units.
std::int64_t FlightState::evade_ticks() const noexcept {
  const std::uint32_t units = spec.work_per_tick - spec.work_per_tick / 4;
  const std::int64_t needed = 1 + (kEvadeWork + units - 1) / units;
  return (needed > kEvadeTicks ? needed : kEvadeTicks) << (missed / 2);
}

/// Where the vehicle rests, a plan that is about to take over is dropped. Otherwise it stays until a brake is proven:
/// what is flown may be blocked beyond its takeover. No brake begins after that takeover, so one that comes too soon is
/// waited for.
void FlightState::begin_evade() noexcept {
  const std::int64_t lead = evade_ticks() * spec.tick;
  if (stopping && hovers()) has_next = meets_before = false;
  const bool plan_is_next = has_next && next.branch > 0.0;
  if (plan_is_next && next.begin < time + lead) return;
  const bool brake_is_next = has_next && !plan_is_next;
  const bool needed = !brake_is_next && !rests() && (threat || commitment_at(time).branch > 0.0);
  stops = stopping;
  stopping = false;
  evaded = evaded || !brake_is_next;
  if (!needed || (threat && rest_begins() <= time + lead)) return;
  takeover = time + lead;
  deadline = takeover - spec.tick;
  job = Job::kEvade;
  defer_debt();
  extends = false;
  try_brakes();
}

void FlightState::try_brakes() noexcept {
  best.number = branch = -1;
  straight = along = 0;
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
  draft.looks_out = false;
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
  if (branch == 0) return append_sharp_stop(at, limits, draft.flown);
  if (branch < kStraight) return append_stop(at, limits, branch - 1, stop, draft.flown);
  return append_slow_down(flown.flown, from, slow_down_time(at.d[1], limits, branch - kStraight), draft.flown);
}

/// The sharpest brake straight ahead comes first, and hardly any other meets what is in the way more slowly. Then those
/// along the path, which may be clear, and the gentler ones straight ahead.
int FlightState::number_of_next() noexcept {
  const bool none_is_judged = best.number < 0;
  if (straight < kStraight && (none_is_judged || along == kSlowDowns)) return straight++;
  return along < kSlowDowns ? kStraight + along++ : kEvasions;
}

void FlightState::next_evasion() noexcept {
  for (branch = number_of_next(); branch < kEvasions; branch = number_of_next()) {
    if (make_evasion() && begin_brake_proof(BrakeProof::kClear)) return;
  }
  end_evade();
}

/// Limits alone are proven from the contact on, with no obstacle in the way; the brake must end within the window.
bool FlightState::begin_brake_proof(BrakeProof what) noexcept {
  proves = what;
  proven_on = map.safe().revision();
  ProofGrounds grounds = grounds_of(draft);
  if (what == BrakeProof::kAlarm) grounds.alarm = &alarm;
  if (what == BrakeProof::kLimits) grounds.added = &kNowhereBox;
  const double from = what == BrakeProof::kLimits ? tried.until : 0.0;
  const Beyond beyond = what == BrakeProof::kLimits ? Beyond::kEmpty : Beyond::kSolid;
  return proof.begin_accepted(map.safe(), draft.flown, from, &spec.limits, beyond, grounds) == Status::kRunning;
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

/// Of the brakes that touch at most the alarm, the one with the slowest contact is flown; of the others, only where
/// what is flown may touch more than the alarm, too. Either must be slower there than what is flown, unless that has
/// its contact before any brake begins and is not such a brake itself. What was not proven yet to touch more than the
/// alarm counts as if it did not.
bool FlightState::helps(const Evasion& brake) const noexcept {
  const bool is_kept = known || (watching && watched_part == Watched::kAlarm);
  if (brake.number < 0 || (is_kept && !brake.known)) return false;
  const bool is_too_late = contact.time < takeover && !latest().evades;
  return is_too_late || brake.speed < contact.speed || (brake.known && !is_kept);
}

/// None is proven. The threat remains. A stop is tried again from a plan that waits, once that has taken over. Where
/// there was no time to judge any brake, or to find one for a stop, they get more.
void FlightState::end_evade() noexcept {
  const bool is_late = branch < kEvasions && (best.number < 0 || !threat);
  if (is_late) {
    miss_evasion();
    if (missed < 2 * kMostDoublings) ++missed;
    return give_up();
  }
  missed = 0;
  stopping = stopping || (stops && has_next && !has_goal);
  branch = best.number;
  if (!threat || !helps(best) || !make_evasion()) return give_up();
  const Alarm raised = alarm;
  const bool is_raised = has_alarm;
  if (!commit()) return;
  alarm = raised;
  has_alarm = is_raised;
  threat = true;
  known = best.known;
  contact = {takeover + nanoseconds(best.until), best.speed};
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
  if (job == Job::kIdle || takeover >= contact.time) return false;
  const Vec3& most = spec.limits.a_max;
  const double weakest = smaller(most.x, smaller(most.y, most.z));
  const double needed = 2.0 * length(sample_at(takeover).velocity) / weakest + 2.0 * kSettleTime;
  return seconds_between(takeover + evade_ticks() * spec.tick, contact.time) > needed;
}

}  // namespace tern
