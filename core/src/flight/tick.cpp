// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One tick: which part works when, and what a threat and an evasion mean to the others.
#include "flight/flight_state.hpp"

namespace tern {
namespace {

FlightMode mode_of(const FlightFacts& facts, const Watch& watch, const RestSearch& search) {
  if (watch.shows_threat(facts)) return FlightMode::kThreat;
  if (facts.hovers()) return search.is_looking ? FlightMode::kLook : FlightMode::kRest;
  const Commitment& in_flight = facts.plans.in_flight;
  return seconds_between(in_flight.begin, facts.time) < in_flight.branch ? FlightMode::kFly : FlightMode::kStop;
}

}  // namespace

void FlightState::tick(std::int64_t t) noexcept {
  facts.begin_tick(t);
  watch.begin_tick();
  if (itinerary.pass_points(facts)) try_anew();
  if (facts.plans.take_over(facts.time)) watch.note_takeover();
  // A flight that gave up because no frames came goes on with the next one.
  if (facts.note_frame() && itinerary.parked && itinerary.reason == FlightReason::kMapStale) try_anew();
  Work work = charge.begin_tick(facts.spec.work_per_tick, evasion.is_running);
  step_map(work);
  run_watch(work);
  if (watch.lacks_beside(facts)) {
    watch.note_beside(block.note_near(facts.map, facts.position(), facts.map.safe(), charge));
  }
  nose.turn(facts, itinerary, looking_at(facts.time), report.committed, charge, work);
  advance(work);
  finish_report(facts.spec.work_per_tick - work.left);
}

/// The map gets half of the tick's work, or most of it if there is no job. A copy or a proof reads the map, which must
/// not change meanwhile.
void FlightState::step_map(Work& work) noexcept {
  if (watch.is_running || evasion.is_running || cycle.reads_map()) return;
  if (!facts.map.busy()) facts.follow_vehicle();
  if (!facts.map.busy()) return;
  charge.step(facts.map, cycle.job == Job::kIdle ? work.left / 4 : work.left / 2, work);
  // Slide before the next frame begins, because a frame may always be waiting.
  if (!facts.map.busy()) facts.follow_vehicle();
}

void FlightState::run_watch(Work& work) noexcept {
  if (!watch.is_running && !facts.map.busy()) {
    Box added;
    const bool is_added = facts.map.take_added(added);
    watch.begin(facts, is_added ? &added : nullptr);
  }
  for (int k = 0; k < kWatchedParts && watch.is_running; ++k) {
    if (charge.step(watch.proof, work) == Progress::kMore) return;
    end_watched_part();
  }
}

void FlightState::end_watched_part() noexcept {
  const WatchResult result = watch.end_part(facts);
  if (result == WatchResult::kOpen) return;
  evasion.note_news();
  if (result == WatchResult::kNoThreat) return;
  double nearest = kAnywhere;
  if (facts.rests()) nearest = block.note_near(facts.map, facts.position(), facts.map.safe(), charge);
  watch.note_threat(facts, nearest);
  const bool drops = facts.plans.has_waiting && !facts.plans.waiting.evades;
  if (drops) facts.plans.drop_waiting();
  watch.go_on(facts, drops);
}

void FlightState::advance(Work& work) noexcept {
  const bool has_arrived =
      itinerary.has_goal && !itinerary.parked && facts.rests() && itinerary.is_reached_by(facts.plans.in_flight);
  if (has_arrived) {
    itinerary.pass(itinerary.last());
    park(FlightReason::kArrived);
  }
  if (is_busy() && facts.time > draft.deadline) {
    ++report.dropped;
    evasion.is_running ? evasion.miss(itinerary.has_goal) : cycle.count_late();
    give_up();
  }
  if (calls_for_evasion()) begin_evasion();
  if (!is_busy()) begin_cycle();
  prove_anew();
  // A cycle has at most as many steps as jobs and candidates.
  constexpr int kSteps = 16 + 2 * kBranches * kBranchShapes;
  Progress progress = Progress::kDone;
  for (int step = 0; step < kSteps && progress == Progress::kDone && is_busy(); ++step) {
    progress = evasion.is_running ? run_evasion(work) : run_job(work);
  }
  if (evasion.is_running && facts.time >= draft.deadline) end_evasion();  // with the best brake so far
}

/// The pending plan may go on if it leaves time to brake. No evasion begins while the committed plan is being proven,
/// or the map slides.
bool FlightState::calls_for_evasion() const noexcept {
  const bool is_braking_soon = facts.plans.has_waiting && facts.plans.waiting.evades;
  const bool threatened = watch.threat && !evasion.was_tried && !is_braking_soon &&
                          !(is_busy() && evasion.leaves_time(facts, watch, draft.takeover));
  return !evasion.is_running && !watch.is_running_but_for_alarm() && facts.map.safe().bound() &&
         (evasion.stop_asked || threatened);
}

/// If the vehicle hovers, a stop drops the waiting plan.
void FlightState::begin_evasion() noexcept {
  if (evasion.stop_asked && facts.hovers()) {
    facts.plans.drop_waiting();
    watch.forget_before();
  }
  if (!evasion.begin(facts, watch, draft)) return;
  cycle.leave();
  charge.defer_debt();
  if (evasion.try_brakes(facts, itinerary, watch, draft, charge) == EvasionResult::kOver) end_evasion();
}

/// If boxes were marked between two ticks, begins the current proof of the draft anew on the map as it is.
void FlightState::prove_anew() noexcept {
  if (draft.proven_on == facts.map.safe().revision()) return;
  cycle.prove_anew();
  if (!evasion.is_running) return;
  if (evasion.try_brakes(facts, itinerary, watch, draft, charge) == EvasionResult::kOver) end_evasion();
}

Progress FlightState::run_evasion(Work& work) noexcept {
  if (charge.step(draft.proof, work) == Progress::kMore) return Progress::kMore;
  const EvasionResult result = evasion.judge(facts, itinerary, watch, draft, charge);
  if (result == EvasionResult::kProven) commit();
  if (result == EvasionResult::kOver) end_evasion();
  return Progress::kDone;
}

/// Commits the best brake even if it is not proven, if it is better than the committed plan. A threat then remains.
void FlightState::end_evasion() noexcept {
  if (!evasion.end(facts, itinerary, watch, draft, charge)) return give_up();
  const bool had_alarm = watch.has_alarm;
  const JudgedBrake& brake = evasion.best;
  if (!commit()) return;
  watch.note_unproven_brake({draft.takeover + nanoseconds(brake.until), brake.speed}, brake.known, had_alarm);
}

Vec3 FlightState::looking_at(std::int64_t t) const noexcept {
  return search.looking_at(facts, t, nose.seconds_per_direction(facts.spec));
}

void FlightState::finish_report(std::uint32_t spent) noexcept {
  report.mode = mode_of(facts, watch, search);
  report.reason = itinerary.reason;
  report.work = spent;
  report.waits_for_view = nose.waits_for_view(facts, itinerary);
  report.map_stale = facts.is_stale();
  report.frame_age = facts.time - facts.frame_time;
  report.leg = itinerary.leg;
  report.passed = itinerary.count_points(PointState::kPassed);
  report.skipped = itinerary.count_points(PointState::kSkipped);
  const bool has_block = watch.is_beside(facts) ||
                         (itinerary.reason != FlightReason::kNoGoal && itinerary.reason != FlightReason::kArrived);
  const Blockage& what = has_block ? block : kNoBlockage;
  report.blocked_by = what.by;
  report.blocked_at = what.at;
  report.blocked_fence = what.fence;
  const bool is_threat = report.mode == FlightMode::kThreat;
  report.contact_time = is_threat ? facts.clock.shown_at(watch.first_contact().time) : 0;
  report.contact_speed = is_threat ? watch.first_contact().speed : 0.0;
}

}  // namespace tern
