// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One tick: which part works when, and what a threat and an evasion mean to the others.
#include "flight/flight_state.hpp"

namespace tern {
void FlightState::tick(std::int64_t t) noexcept {
  facts.begin_tick(t);
  watch.begin_tick();
  if (itinerary.pass_points(facts)) try_anew();
  if (facts.plans.take_over(facts.time)) watch.note_takeover();
  // A flight that gave up because no frames came goes on with the next one.
  if (facts.note_frame() && itinerary.parked && itinerary.reason == FlightReason::kMapStale) try_anew();
  if (tick_work.left()) tick_work = Work{};
  tick_work.add(facts.spec.work_per_tick);
  Work& work = tick_work;
  step_map(work);
  run_watch(work);
  note_beside();
  turn_nose(work);
  advance(work);
  finish_report(facts.spec.work_per_tick - least(work.units(), facts.spec.work_per_tick));
}

/// The map gets half of the tick's work, or most of it if there is no job. A copy or a proof reads the map, which must
/// not change meanwhile.
void FlightState::step_map(Work& work) noexcept {
  if (watch.is_running || evasion.is_running || cycle.reads_map()) return;
  if (!facts.map.busy()) facts.follow_vehicle();
  if (!facts.map.busy()) return;
  Work part = work.within(work.operations() - work.operations() / (cycle.job == Job::kIdle ? 4 : 2));
  const Operations given = part.operations();
  facts.map.step(part);
  work.spend(given - part.operations());
  // Slide before the next frame begins, because a frame may always be waiting.
  if (!facts.map.busy()) facts.follow_vehicle();
}

void FlightState::run_watch(Work& work) noexcept {
  if (!watch.is_running && !facts.map.busy()) watch.begin(facts, facts.map);
  for (int k = 0; k < kWatchedParts && watch.is_running; ++k) {
    if (watch.proof.step(work) == Status::kRunning) return;
    end_watched_part();
  }
}

void FlightState::end_watched_part() noexcept {
  const WatchResult result = watch.end_part(facts);
  if (result == WatchResult::kOpen) return;
  evasion.note_news();
  if (result == WatchResult::kNoThreat) return;
  watch.note_threat(facts, facts.rests() ? note_block_near_vehicle() : kAnywhere);
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
  if (evasion.is_called_for(facts, watch, is_busy(), draft.takeover)) begin_evasion();
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

/// If the vehicle hovers, a stop drops the waiting plan.
void FlightState::begin_evasion() noexcept {
  if (evasion.stop_asked && facts.hovers()) {
    facts.plans.drop_waiting();
    watch.forget_before();
  }
  if (!evasion.begin(facts, watch, draft)) return;
  cycle.leave();
  tick_work.forgive();
  if (evasion.try_brakes(facts, itinerary, watch, draft, tick_work) == EvasionResult::kOver) end_evasion();
}

/// If boxes were marked between two ticks, begins the current proof of the draft anew on the map as it is.
void FlightState::prove_anew() noexcept {
  if (draft.proven_on == facts.map.safe().revision()) return;
  cycle.prove_anew();
  if (!evasion.is_running) return;
  if (evasion.try_brakes(facts, itinerary, watch, draft, tick_work) == EvasionResult::kOver) end_evasion();
}

Progress FlightState::run_evasion(Work& work) noexcept {
  if (draft.proof.step(work) == Status::kRunning) return Progress::kMore;
  const EvasionResult result = evasion.judge(facts, itinerary, watch, draft, tick_work);
  if (result == EvasionResult::kProven) commit();
  if (result == EvasionResult::kOver) end_evasion();
  return Progress::kDone;
}

/// Commits the best brake even if it is not proven, if it is better than the committed plan. A threat then remains.
void FlightState::end_evasion() noexcept {
  if (!evasion.end(facts, itinerary, watch, draft, tick_work)) return give_up();
  const bool had_alarm = watch.has_alarm;
  const JudgedBrake& brake = evasion.best;
  if (!commit()) return;
  watch.note_unproven_brake({draft.takeover + nanoseconds(brake.until), brake.speed}, brake.known, had_alarm);
}

}  // namespace tern
