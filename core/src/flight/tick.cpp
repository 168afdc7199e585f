// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One tick: which part works when, and what a threat and an evasion mean to the others.
#include "base/capacity.hpp"
#include "flight/closing.hpp"
#include "flight/flight_state.hpp"

namespace tern {

void FlightState::tick(std::int64_t t) noexcept {
  facts.begin_tick(t);
  watch.begin_tick();
  if (facts.itinerary.pass_points(facts)) try_anew();
  if (facts.plans.take_over(facts.time)) watch.note_takeover();
  // A flight that gave up because no frames came goes on with the next one.
  if (facts.note_frame() && facts.itinerary.parked && facts.itinerary.reason == FlightReason::kMapStale) try_anew();
  if (tick_work.left()) tick_work = Work{};
  tick_work.add(facts.spec.work_per_tick);
  step_map();
  run_watch();
  if (watch.lacks_beside(facts)) watch.note_beside(note_block_near_vehicle());
  lookouts.note_tick(facts, {report.asked, report.dropped});
  lookouts.follow(facts, nose, {report.asked, report.dropped});
  nose.turn(facts, looking_at(facts.time), lookouts.is_active(), report.committed, tick_work);
  // While an evasion runs, all work is for its brakes.
  if (!evasion.is_running) rest.advance(facts, tick_work);
  advance();
  finish_report(facts.spec.work_per_tick - least(tick_work.units(), facts.spec.work_per_tick));
}

Vec3 FlightState::looking_at(std::int64_t t) const noexcept {
  return lookouts.is_active() ? lookouts.look_at(facts.plans.sample_at(t).position) : search.looking_at(facts, nose, t);
}

/// The map gets half of the tick's work, or three quarters if the cycle is idle. A copy, a proof or a search for a
/// lookout reads the map, which must not change meanwhile.
void FlightState::step_map() noexcept {
  if (watch.is_running || evasion.is_running || cycle.reads_map() || lookouts.is_searching()) return;
  if (!facts.map.busy()) facts.follow_vehicle();
  if (!facts.map.busy()) return;
  Share share(tick_work, tick_work.operations() - tick_work.operations() / (cycle.job == Job::kIdle ? 4 : 2));
  facts.map.explain_hits(facts.tracks.tracks, facts.tracks.count, facts.clock.shown_at(0));
  facts.map.step(share.part);
  facts.map.explain_hits(nullptr, 0);
  // Slide before the next frame begins, because a frame may always be waiting.
  if (!facts.map.busy()) facts.follow_vehicle();
}

void FlightState::run_watch() noexcept {
  if (!watch.is_running && !facts.map.busy()) watch.begin(facts, facts.map);
  for (int k = 0; k < kWatchedParts && watch.is_running; ++k) {
    if (watch.proof.step(tick_work) == Status::kRunning) return;
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

bool FlightState::keep_pieces(Track& track) noexcept {
  const TrackTable* tables[5] = {&facts.tracks, &facts.plans.in_flight.tubes};
  int count = 2;
  if (facts.plans.has_waiting) tables[count++] = &facts.plans.waiting.tubes;
  if (is_busy()) {
    tables[count++] = &draft.plan.tubes;
    tables[count++] = &cycle.expected;
  }
  return pieces.keep(track, tables, count);
}

/// A measurement outside the tube of a committed plan, or of a thing that the plan does not know: from now on the plan
/// has this tube, and is proven anew.
Status FlightState::update_track(const Track& measured) noexcept {
  Track taken;
  const Status status = facts.read_track(measured, taken);
  if (status != Status::kOk) return status;
  if (taken.piece_count > 0 && is_full(!keep_pieces(taken))) return Status::kTrackPiecesFull;
  CommittedPlans& plans = facts.plans;
  const Status known = facts.tracks.update(taken, facts.time);
  if (known != Status::kOk) return known;
  rest.note_news();
  // Who clears plans keeps curves clear of them.
  const bool is_cleared = taken.piece_count > 0 && facts.spec.clearance > 0;
  bool has_news = !is_cleared && plans.in_flight.tubes.take_news(taken, facts.tracks);
  const bool waits = !is_cleared && plans.has_waiting;
  if (waits) has_news = plans.waiting.tubes.take_news(taken, facts.tracks) || has_news;
  if (has_news) watch.prove_all();
  // What rested in the way may leave.
  const FlightReason reason = facts.itinerary.reason;
  const bool is_stuck =
      facts.itinerary.parked && (reason == FlightReason::kNoProgress || reason == FlightReason::kHeldUp);
  if (is_stuck && taken.piece_count > 0) try_anew();
  return Status::kOk;
}

/// A vehicle that has a goal and rests where a fence is about to begin goes on, even if it had arrived or given up. It
/// stays on the ground.
bool FlightState::leaves_place() noexcept {
  const Commitment& latest = facts.plans.latest();
  if (!facts.has_windows || !facts.itinerary.has_goal || !facts.rests() || latest.lifts) return false;
  if (closing_fence(facts, latest.end(), facts.time, kLeaveSpare, tick_work) == kNoFence) return false;
  if (facts.itinerary.parked) try_anew();
  return true;
}

/// True if the plan that is being made may begin at any time. Things that were forgotten since are in its proof all the
/// same.
bool FlightState::may_shift_plan() const noexcept {
  const bool has_tubes = cycle.proves_draft() && draft.plan.tubes.count > 0;
  return facts.takes_plans_at_any_time() && !evasion.is_running && cycle.is_planning() && !has_tubes;
}

/// A late plan from rest goes on with twice its lead if it may begin at any time.
bool FlightState::waits_for_plan() noexcept {
  const bool is_from_rest = draft.takeover > facts.plans.rest_begins();
  if (!may_shift_plan() || !is_from_rest || cycle.lead.late >= kMostDoublings) return false;
  const std::int64_t before = cycle.lead.ticks(facts.spec);
  cycle.lead.note_late();
  draft.shift((cycle.lead.ticks(facts.spec) - before) * facts.spec.tick);
  return true;
}

void FlightState::advance() noexcept {
  is_leaving = leaves_place();
  const bool is_last = facts.landing.is_asked ? facts.lands() : facts.itinerary.is_reached_by(facts.plans.in_flight);
  if (facts.itinerary.goes_on() && facts.rests() && is_last && !is_leaving) {
    facts.itinerary.pass(facts.itinerary.last());
    park(facts.landing.is_asked ? FlightReason::kLanded : FlightReason::kArrived);
  }
  if (is_busy() && facts.time > draft.deadline && !waits_for_plan()) {
    ++report.dropped;
    if (evasion.is_running) evasion.miss(facts.itinerary.has_goal);
    if (!evasion.is_running && cycle.is_planning()) cycle.lead.note_late();
    cycle.job == Job::kAnswer ? cycle.leave() : give_up();
  }
  if (facts.spec.clearance > 0) evasion.forget_wishes();
  if (evasion.is_called_for(facts, watch, is_busy(), draft.takeover)) begin_evasion();
  const bool is_held_up = facts.itinerary.waits_too_long(facts.gap);
  if (is_held_up && !is_busy() && facts.itinerary.goes_on()) park(FlightReason::kHeldUp);
  if (!is_busy()) begin_cycle();
  prove_anew();
  // A cycle has at most as many steps as jobs and candidates.
  constexpr int kSteps = 20 + 2 * kBranches * kBranchShapes;
  Progress progress = Progress::kDone;
  for (int step = 0; step < kSteps && progress == Progress::kDone && is_busy(); ++step) {
    progress = evasion.is_running ? run_evasion() : run_job();
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
  leave_question();
  cycle.leave();
  tick_work.forgive();
  go_on_evading(evasion.try_brakes(facts, watch, draft, tick_work));
}

/// If boxes were marked between two ticks, begins the current proof of the draft anew on the map as it is.
void FlightState::prove_anew() noexcept {
  if (draft.proven_on == facts.map.safe().revision()) return;
  cycle.prove_anew();
  if (evasion.is_running) go_on_evading(evasion.try_brakes(facts, watch, draft, tick_work));
}

Progress FlightState::run_evasion() noexcept {
  if (draft.proof.step(tick_work) == Status::kRunning) return Progress::kMore;
  go_on_evading(evasion.judge(facts, watch, draft, tick_work));
  return Progress::kDone;
}

void FlightState::go_on_evading(EvasionResult result) noexcept {
  if (result == EvasionResult::kProven) commit();
  if (result == EvasionResult::kOver) end_evasion();
}

/// Commits the best brake even if it is not proven, if it is better than the committed plan. A threat then remains.
void FlightState::end_evasion() noexcept {
  if (!evasion.end(facts, watch, draft, tick_work)) return give_up();
  const bool had_alarm = watch.has_alarm;
  const JudgedBrake& brake = evasion.best;
  if (!commit()) return;
  watch.note_unproven_brake({draft.takeover + nanoseconds(brake.until), brake.speed}, brake.known, had_alarm);
}

}  // namespace tern
