// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/evasion.hpp"

#include "base/bounds.hpp"
#include "base/math.hpp"

namespace tern {
namespace {

/// A brake that touches at most the alarm comes first, then the slowest contact, then the latest one.
bool is_better(const JudgedBrake& a, const JudgedBrake& b) {
  if (b.number < 0) return true;
  if (a.known != b.known) return a.known;
  return a.speed < b.speed || (!(a.speed > b.speed) && a.until > b.until);
}

/// True if something in the way ended the proof, and not a limit.
bool is_contact(Finding end) {
  return end == Finding::kObstacle || end == Finding::kOutside || end == Finding::kFence || end == Finding::kTrack;
}

/// No trajectory comes near to this.
constexpr double kNowhere = 1e300;
constexpr Box kNowhereBox{{kNowhere, kNowhere, kNowhere}, {kNowhere, kNowhere, kNowhere}};

}  // namespace

/// A yaw plan may take a quarter of each tick's units.
std::int64_t Evasion::ticks_after(int missed, const FlightSpec& spec) noexcept {
  const std::uint32_t units = spec.work_per_tick - spec.work_per_tick / 4;
  const std::int64_t needed = 1 + (kEvadeWork + units - 1) / units;
  return (needed > kEvadeTicks ? needed : kEvadeTicks) << (missed / 2);
}

/// The waiting plan stays until a brake is proven, because the plan in flight may be blocked beyond that takeover. A
/// brake never begins after the takeover of a waiting plan. If that takeover comes before a brake could begin, the
/// evasion begins after it.
bool Evasion::begin(const FlightFacts& flight, const Watch& watch, Draft& draft) noexcept {
  const CommittedPlans& plans = flight.plans;
  const std::int64_t lead = ticks(flight.spec) * flight.spec.tick;
  const bool plan_is_next = plans.has_waiting && plans.waiting.branch > 0.0;
  if (plan_is_next && plans.waiting.begin() < flight.time + lead) return false;
  const bool brake_is_next = plans.has_waiting && !plan_is_next;
  const bool needed = !brake_is_next && !flight.rests() && (watch.threat || plans.at(flight.time).branch > 0.0);
  serves_stop = stop_asked;
  slows = slow_asked && !stop_asked && !watch.threat;
  stop_asked = slow_asked = false;
  was_tried = was_tried || !brake_is_next;
  if (!needed || (watch.threat && plans.rest_begins() <= flight.time + lead)) return false;
  draft.begin(flight, ticks(flight.spec));
  draft.clear();
  draft.plan.tubes.take(flight.tracks);
  is_running = true;
  return true;
}

bool Evasion::is_called_for(const FlightFacts& flight, const Watch& watch, bool has_pending,
                            std::int64_t takeover) const noexcept {
  const bool is_braking_soon = flight.plans.has_waiting && flight.plans.waiting.evades;
  const bool threatened =
      watch.threat && !was_tried && !is_braking_soon && !(has_pending && leaves_time(flight, watch, takeover));
  return !is_running && !watch.is_running_but_for_alarm() && flight.map.safe().bound() &&
         (stop_asked || slow_asked || threatened);
}

EvasionResult Evasion::try_brakes(const FlightFacts& flight, const Watch& watch, Draft& draft, Work& work) noexcept {
  best.number = number = -1;
  straight = along = 0;
  return try_next(flight, watch, draft, work);
}

/// The sharpest brake straight ahead comes first: hardly any other is slower at its contact. Once a brake is judged,
/// those along the path follow, because they may be clear. The gentler ones straight ahead come last. A vehicle that
/// strays slows down along the path alone: any other brake asks more of it than the plan does.
int Evasion::number_of_next() noexcept {
  const bool none_is_judged = best.number < 0;
  if (straight < kStraight && !slows && (none_is_judged || along == kSlowDowns)) return straight++;
  return along < kSlowDowns ? kStraight + along++ : kEvasions;
}

EvasionResult Evasion::try_next(const FlightFacts& flight, const Watch& watch, Draft& draft, Work& work) noexcept {
  for (number = number_of_next(); number < kEvasions; number = number_of_next()) {
    if (draft.brake(flight, number, watch.threat, work) &&
        begin_brake_proof(BrakeProof::kClear, flight, watch, draft)) {
      return EvasionResult::kProving;
    }
  }
  return EvasionResult::kOver;
}

/// A proof of kLimits begins at the contact and takes no obstacle into account, but the brake must stay within the
/// window.
bool Evasion::begin_brake_proof(BrakeProof what, const FlightFacts& flight, const Watch& watch, Draft& draft) noexcept {
  proves = what;
  ProofGrounds grounds = grounds_of(flight.spec, draft.plan);
  if (what == BrakeProof::kAlarm) grounds.alarm = &watch.alarm;
  if (what == BrakeProof::kLimits) {
    grounds.added = &kNowhereBox;
    grounds.track_count = 0;
  }
  const double from = what == BrakeProof::kLimits ? tried.until : 0.0;
  const Beyond beyond = what == BrakeProof::kLimits ? Beyond::kEmpty : Beyond::kSolid;
  return draft.begin_proof(flight, from, beyond, grounds) == Status::kRunning;
}

EvasionResult Evasion::judge(const FlightFacts& flight, const Watch& watch, Draft& draft, Work& work) noexcept {
  if (proves == BrakeProof::kClear && draft.proof.report().finding == Finding::kNone) {
    missed = 0;
    return EvasionResult::kProven;
  }
  if (go_on_proving(flight, watch, draft)) return EvasionResult::kProving;
  return try_next(flight, watch, draft, work);
}

/// A brake that is not clear may still be flown if it keeps the limits, and is then judged by its contact. True if
/// there is more to prove of the brake.
bool Evasion::go_on_proving(const FlightFacts& flight, const Watch& watch, Draft& draft) noexcept {
  bool proven = draft.proof.report().finding == Finding::kNone;
  if (proves == BrakeProof::kClear) {
    if (!is_contact(draft.proof.report().finding)) return false;
    const double until = draft.proof.report().until;
    tried = {number, until, length(evaluate(draft.plan.trajectory, until).velocity), true};
    return is_better(tried, best) && begin_brake_proof(BrakeProof::kLimits, flight, watch, draft);
  }
  if (proves == BrakeProof::kLimits) {
    if (!proven) return false;
    if (watch.has_alarm && begin_brake_proof(BrakeProof::kAlarm, flight, watch, draft)) return true;
    proven = false;
  }
  tried.known = proven;
  if (is_better(tried, best)) best = tried;
  return false;
}

/// If the committed plan touches nothing but the alarm, or this proof of it is still at work, the brake must touch
/// nothing else either. The brake's contact must be slower than the plan's, with two exceptions: only the brake touches
/// nothing but the alarm, or the plan is no brake and has its contact before the brake begins.
bool helps(const JudgedBrake& brake, const FlightFacts& flight, const Watch& watch, std::int64_t takeover) noexcept {
  const bool is_kept = watch.known || (watch.is_running && watch.part == Watched::kAlarm);
  if (brake.number < 0 || (is_kept && !brake.known)) return false;
  const bool is_too_late = watch.contact.time < takeover && !flight.plans.latest().evades;
  return is_too_late || brake.speed < watch.contact.speed || (brake.known && !is_kept);
}

/// The threat remains. A stop is tried again once the waiting plan has taken over. If there was no time to judge any
/// brake, or to find one for a stop, the next evasion gets more time.
bool Evasion::end(const FlightFacts& flight, const Watch& watch, Draft& draft, Work& work) noexcept {
  const bool is_late = number < kEvasions && (best.number < 0 || !watch.threat);
  if (is_late) {
    miss(flight.itinerary.has_goal);
    if (missed < 2 * kMostDoublings) ++missed;
    return false;
  }
  missed = 0;
  stop_asked = stop_asked || (serves_stop && flight.plans.has_waiting && !flight.itinerary.has_goal);
  number = best.number;
  return watch.threat && helps(best, flight, watch, draft.takeover) && draft.brake(flight, number, watch.threat, work);
}

void Evasion::miss(bool has_goal) noexcept {
  was_tried = false;
  stop_asked = stop_asked || (serves_stop && !has_goal);
  if (missed < 2 * kMostDoublings) ++missed;
}

/// A brake needs the ticks before it begins, and twice the time of the sharpest brake.
bool Evasion::leaves_time(const FlightFacts& flight, const Watch& watch, std::int64_t takeover) const noexcept {
  if (takeover >= watch.contact.time) return false;
  const Vec3& most = flight.spec.limits.a_max;
  const double weakest = smaller(most.x, smaller(most.y, most.z));
  const Vec3 velocity = flight.plans.sample_at(takeover).velocity;
  const double sharpest =
      larger(length(velocity) / weakest, thrust_gauge(flight.limits.acceleration, kZero - velocity));
  const double needed = 2.0 * sharpest + 2.0 * kSettleTime;
  return seconds_between(takeover + ticks(flight.spec) * flight.spec.tick, watch.contact.time) > needed;
}

}  // namespace tern
