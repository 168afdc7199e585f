// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Proves the committed plan anew near voxels that became solid.
#include "base/math.hpp"
#include "flight/flight_state.hpp"

namespace tern {
namespace {

constexpr int kWatchedParts = 4;

Box around(const Box& a, const Box& b) {
  Box box = a;
  for (int k = 0; k < 3; ++k) {
    axis(box.lower, k) = smaller(axis(a.lower, k), axis(b.lower, k));
    axis(box.upper, k) = larger(axis(a.upper, k), axis(b.upper, k));
  }
  return box;
}

}  // namespace

/// The alarm grows until the committed plan is proven.
void FlightState::note_added() noexcept {
  alarm.box = has_alarm ? around(alarm.box, added) : added;
  alarm.seen = map.seen_rows();
  has_alarm = true;
}

/// Proves the committed plan anew, but only near what became solid since the last proof. Under a threat, it proves all
/// of the plan, because what was solid may have become free.
void FlightState::begin_watch() noexcept {
  const bool is_added = map.take_added(added);
  if (is_added) note_added();
  const bool all = watch_all || (threat && watched != map.safe().revision());
  if (!all && !is_added) return;
  has_added = !all;
  watch_all = false;
  watched = map.safe().revision();
  watch_part(has_next ? Watched::kBefore : Watched::kLatest);
}

void FlightState::watch_part(Watched which) noexcept {
  watched_part = which;
  const Commitment& commitment = watched_commitment();
  const double from = larger(0.0, seconds_between(commitment.begin, time));
  ProofGrounds grounds = grounds_of(commitment);
  if (has_added && watched_part != Watched::kAlarm) grounds.added = &added;
  if (watched_part == Watched::kAlarm) grounds.alarm = &alarm;
  watching =
      watch.begin_accepted(map.safe(), commitment.flown, from, nullptr, Beyond::kSolid, grounds) == Status::kRunning;
}

void FlightState::run_watch(Work& work) noexcept {
  if (!watching && !map.busy()) begin_watch();
  for (int k = 0; k < kWatchedParts && watching; ++k) {
    if (step_proof(watch, work) == Progress::kMore) return;
    watching = false;
    end_part();
  }
}

Contact FlightState::watched_contact() const noexcept {
  const Commitment& commitment = watched_commitment();
  const double until = watch.report().until;
  return {commitment.begin + nanoseconds(until), length(evaluate(commitment.flown, until).velocity)};
}

void FlightState::end_part() noexcept {
  const bool proven = watch.report().end == ProofEnd::kProven;
  const bool meets = !proven && (!has_next || watched_contact().time < next.begin);
  if (watched_part == Watched::kAlarm) {
    known = proven;
  } else if (watched_part == Watched::kBefore && (!meets || next.evades)) {
    // If the waiting plan is a brake, a contact before its takeover calls for no other: none could begin earlier.
    meets_before = meets || (meets_before && has_added);
    if (meets) before = watched_contact();
    watch_part(Watched::kLatest);
  } else if (proven) {
    threat = evaded = has_alarm = false;
  } else {
    note_threat();
  }
}

/// Notes what is too near to the resting vehicle, once: it may have come to rest after the threat was found.
void FlightState::note_beside() noexcept {
  if (is_beside() && !(beside < kAnywhere)) beside = note_block_near(sample_at(time).position, map.safe());
}

/// True if a threat is news. At rest, it is news only if something is nearer than before, and so comes towards the
/// vehicle.
bool FlightState::is_news() noexcept {
  const double gap_before = is_beside() ? beside : kAnywhere;
  beside = rests() ? note_block_near(sample_at(time).position, map.safe()) : kAnywhere;
  const bool comes_nearer = beside < gap_before;
  beside = smaller(beside, gap_before);
  return comes_nearer || !is_beside();
}

void FlightState::note_threat() noexcept {
  if (is_news()) {
    alarmed = true;
    alarm_time = time;
  }
  threat = true;
  evaded = known = false;
  contact = watched_contact();
  if (has_next && !next.evades) {
    has_next = has_added = meets_before = false;  // without the waiting plan, the flight may still be proven
    watch_part(Watched::kLatest);
  } else if (has_alarm) {
    watch_part(Watched::kAlarm);
  }
}

}  // namespace tern
