// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/watch.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

Box around(const Box& a, const Box& b) {
  Box box = a;
  for (int k = 0; k < 3; ++k) {
    axis(box.lower, k) = smaller(axis(a.lower, k), axis(b.lower, k));
    axis(box.upper, k) = larger(axis(a.upper, k), axis(b.upper, k));
  }
  return box;
}

}  // namespace

/// Proves only the parts of the plan near the added voxels. Under a threat, it proves all of the plan, because solid
/// voxels may have become free. The alarm grows until the committed plan is proven.
void Watch::begin(const FlightFacts& flight, RollingMap& map) noexcept {
  const bool is_added = map.take_added(added);
  if (is_added) {
    alarm.box = has_alarm ? around(alarm.box, added) : added;
    alarm.seen = flight.map.seen_rows();
    has_alarm = true;
  }
  const bool all = covers_all || (threat && revision != flight.map.safe().revision());
  if (!all && !is_added) return;
  has_added = !all;
  covers_all = false;
  revision = flight.map.safe().revision();
  prove(flight, flight.plans.has_waiting ? Watched::kBefore : Watched::kLatest);
}

void Watch::prove(const FlightFacts& flight, Watched which) noexcept {
  part = which;
  const Commitment& plan = watched(flight.plans);
  const double from = larger(0.0, plan.time_at(flight.time));
  ProofGrounds grounds = grounds_of(flight.spec, plan);
  if (has_added && part != Watched::kAlarm) {
    grounds.added = &added;
    grounds.track_count = 0;  // it stays proven clear of its tubes
  }
  if (part == Watched::kAlarm) grounds.alarm = &alarm;
  is_running = proof.begin_accepted(flight.map.safe(), plan.trajectory, from, nullptr, Beyond::kSolid, grounds) ==
               Status::kRunning;
}

Contact Watch::contact_on(const Commitment& plan) const noexcept {
  const double until = proof.report().until;
  return {plan.begin() + nanoseconds(until), length(evaluate(plan.trajectory, until).velocity)};
}

WatchResult Watch::end_part(const FlightFacts& flight) noexcept {
  is_running = false;
  const CommittedPlans& plans = flight.plans;
  const bool proven = proof.report().finding == Finding::kNone;
  const bool meets = !proven && (!plans.has_waiting || contact_on(watched(plans)).time < plans.waiting.begin());
  if (part == Watched::kAlarm) {
    known = proven;
    return WatchResult::kOpen;
  }
  if (part == Watched::kBefore && (!meets || plans.waiting.evades)) {
    // If the waiting plan is a brake, a contact before its takeover calls for no other: none could begin earlier.
    meets_before = meets || (meets_before && has_added);
    if (meets) before = contact_on(watched(plans));
    prove(flight, Watched::kLatest);
    return WatchResult::kOpen;
  }
  if (!proven) return WatchResult::kThreat;
  threat = has_alarm = false;
  return WatchResult::kNoThreat;
}

/// At rest, a threat is news only if something is nearer than before, and so comes towards the vehicle.
void Watch::note_threat(const FlightFacts& flight, double nearest) noexcept {
  const bool was_beside = is_beside(flight);
  const double nearest_before = was_beside ? beside : kAnywhere;
  beside = smaller(nearest, nearest_before);
  if (nearest < nearest_before || !was_beside) {
    alarmed = true;
    alarm_time = flight.time;
  }
  threat = true;
  known = false;
  contact = contact_on(watched(flight.plans));
}

void Watch::go_on(const FlightFacts& flight, bool dropped) noexcept {
  if (dropped) {
    has_added = meets_before = false;
    prove(flight, Watched::kLatest);
  } else if (has_alarm) {
    prove(flight, Watched::kAlarm);
  }
}

void Watch::prove_all() noexcept {
  covers_all = true;
  is_running = false;
}

void Watch::note_takeover() noexcept {
  if (is_running && part == Watched::kBefore) {
    covers_all = true;
    is_running = false;
  }
  meets_before = false;
}

void Watch::note_commit(bool extends, std::int64_t takeover) noexcept {
  if (is_running) covers_all = true;
  const bool meets = threat && contact.time < takeover;
  if (meets) before = contact;
  is_running = has_alarm = false;
  threat = extends && meets;
  if (!extends) meets_before = meets;
}

void Watch::note_unproven_brake(const Contact& of_brake, bool is_known, bool alarm_stays) noexcept {
  threat = true;
  contact = of_brake;
  known = is_known;
  has_alarm = alarm_stays;
}

bool Watch::shows_threat(const FlightFacts& flight) const noexcept {
  const bool was_shown = flight.rests() && flight.time - alarm_time > kThreatShown;
  return alarmed || ((threat || meets_before) && !was_shown);
}

}  // namespace tern
