// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Evasions: brakes that begin a few ticks ahead, because something came into the way or the user says stop.
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

/// Instructions to make a brake straight ahead, and one along the committed plan.
constexpr std::uint32_t kStopEffort = 25000;
constexpr std::uint32_t kSlowDownEffort = 90000;

/// No trajectory comes near to this.
constexpr double kNowhere = 1e300;
constexpr Box kNowhereBox{{kNowhere, kNowhere, kNowhere}, {kNowhere, kNowhere, kNowhere}};

}  // namespace

/// Ticks until the brake of an evasion begins. A yaw plan may take a quarter of each tick's units.
std::int64_t FlightState::evade_ticks() const noexcept {
  const std::uint32_t units = spec.work_per_tick - spec.work_per_tick / 4;
  const std::int64_t needed = 1 + (kEvadeWork + units - 1) / units;
  return (needed > kEvadeTicks ? needed : kEvadeTicks) << (missed / 2);
}

/// If the vehicle hovers, a stop drops the waiting plan. Otherwise the waiting plan stays until a brake is proven,
/// because the plan in flight may be blocked beyond that takeover. A brake never begins after the takeover of a waiting
/// plan. If that takeover comes before a brake could begin, the evasion begins after it.
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

/// Appends brake number `branch`: straight ahead, or along the committed plan.
bool FlightState::append_evasion(const Commitment& flown, double from) noexcept {
  const JointState at = joint_at(flown.flown, from, draft.flown.origin);
  if (branch == 0) return append_sharp_stop(at, limits, draft.flown);
  if (branch < kStraight) return append_stop(at, limits, branch - 1, stop, draft.flown);
  return append_slow_down(flown.flown, from, slow_down_time(at.d[1], limits, branch - kStraight), draft.flown);
}

/// The sharpest brake straight ahead comes first: hardly any other meets what is in the way more slowly. Once a brake
/// is judged, those along the path follow, which may be clear; the gentler ones straight ahead come last.
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

/// A proof of kLimits begins at the contact and takes no obstacle into account, but the brake must stay within the
/// window.
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

/// A brake that is not clear may still be flown if it keeps the limits, and is then judged by its contact. True if
/// there is more to prove of the brake.
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

/// True if the brake is better than the committed plan, although it is not proven. If that plan touches at most the
/// alarm, the brake must touch no more either; until this is proven, the plan counts as if it did. The brake's contact
/// must be slower than the plan's, unless only the brake touches at most the alarm. It need not be slower either if the
/// plan has its contact before the brake begins and is no brake itself.
bool FlightState::helps(const Evasion& brake) const noexcept {
  const bool is_kept = known || (watching && watched_part == Watched::kAlarm);
  if (brake.number < 0 || (is_kept && !brake.known)) return false;
  const bool is_too_late = contact.time < takeover && !latest().evades;
  return is_too_late || brake.speed < contact.speed || (brake.known && !is_kept);
}

/// Ends an evasion that has proven no brake: a threat remains. A stop is tried again once the waiting plan has taken
/// over. If there was no time to judge any brake, or to find one for a stop, the next evasion gets more time.
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

/// The evasion was not done in time, for example because ticks were skipped. It is tried again, unless there is no
/// threat and a new goal.
void FlightState::miss_evasion() noexcept {
  evaded = false;
  stopping = stopping || (stops && !has_goal);
  if (missed < 2 * kMostDoublings) ++missed;
}

/// True if the pending plan may go on under a threat because there is time left to brake if it fails. That is the time
/// before a brake begins, and twice the time that the sharpest brake takes.
bool FlightState::leaves_time_to_brake() const noexcept {
  if (job == Job::kIdle || takeover >= contact.time) return false;
  const Vec3& most = spec.limits.a_max;
  const double weakest = smaller(most.x, smaller(most.y, most.z));
  const double needed = 2.0 * length(sample_at(takeover).velocity) / weakest + 2.0 * kSettleTime;
  return seconds_between(takeover + evade_ticks() * spec.tick, contact.time) > needed;
}

}  // namespace tern
