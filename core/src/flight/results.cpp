// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the results of a cycle mean to the other parts: the next step, a commit, or a failure.
#include "flight/flight_state.hpp"

namespace tern {

/// Begins a plan, unless there is nothing to plan for, or no map to plan on. A vehicle that is too fast brakes first: a
/// plan takes over from the brake once the speed that is left is reached.
void FlightState::begin_cycle() noexcept {
  const bool is_free = !facts.plans.has_waiting && !evasion.stop_asked && !watch.is_running;
  if (!facts.itinerary.goes_on() || !is_free || !facts.map.safe().bound() || look_out()) return;
  draft.begin(facts, sidestep_ticks(facts.spec) + facts.clearance_ticks());
  const bool is_sidestep = cycle.begin_sidestep(facts, draft, tick_work) ||
                           (!is_leaving && cycle.begin_step_back(facts, search, lookouts, draft, tick_work));
  if (is_sidestep) {
    ++report.asked;
    return;
  }
  draft.begin(facts, cycle.lead.ticks(facts.spec) + facts.clearance_ticks());
  if (begin_lift()) return;
  const Commitment& in_flight = facts.plans.in_flight;
  const bool stays = facts.itinerary.is_reached_by(in_flight) || facts.itinerary.dwells_after(in_flight);
  const bool looks_for_ground = facts.landing.is_asked && lookouts.is_active();
  if (stays && !looks_for_ground && !is_leaving && facts.rests_at(draft.takeover)) return;
  if (facts.is_too_fast_at(draft.takeover)) return evasion.ask_to_slow();
  ++report.asked;
  cycle.begin(facts, search, lookouts, draft.takeover, tick_work);
}

/// A search for a lookout takes some ticks, in which the map stands still and no other plan is made.
bool FlightState::look_out() noexcept {
  const PlanCounts plans{report.asked, report.dropped};
  const bool is_called_for = !search.wants_survey(facts) && lookouts.is_called_for(facts, nose, plans);
  if (is_called_for) lookouts.begin(facts, nose, search.look_at);
  if (lookouts.is_searching()) lookouts.advance(facts, tick_work);
  if (lookouts.is_hopeless(facts)) park(FlightReason::kNoProgress);
  return facts.itinerary.parked || lookouts.is_searching() || lookouts.needs_no_plan(facts);
}

// One line a job: a table.
// clang-format off
Progress FlightState::run_job() noexcept {
  switch (cycle.job) {
    case Job::kIdle: return Progress::kMore;
    case Job::kCopy: return cycle.copy(facts.map, tick_work);
    case Job::kFollow: return cycle.begin_remainder(facts, draft);
    case Job::kRemainder: return cycle.prove_remainder(facts, draft, tick_work);
    case Job::kAim: return choose_aim();
    case Job::kAskRoute: return cycle.ask_route(facts, tick_work);
    case Job::kAskPlan: return ask_plan();
    case Job::kRoute:
    case Job::kPlan: return cycle.planner->step(tick_work) == Status::kRunning ? Progress::kMore : end_planner();
    case Job::kWait: return or_fail(cycle.begin_proof(facts, draft));
    case Job::kProve: return run_proof();
    case Job::kBranch: return or_fail(cycle.find_branch(facts, draft, tick_work));
    case Job::kConfirm: return run_confirm();
    case Job::kAnswer: return Progress::kMore;
    case Job::kCleared: return or_fail(cycle.begin_renewal(facts, draft));
    case Job::kRenew: return run_renewal();
    case Job::kSidestep: return run_sidestep();
  }
  return Progress::kMore;
}
// clang-format on

Progress FlightState::choose_aim() noexcept {
  if (cycle.follow_aim(facts, lookouts, draft.takeover)) return Progress::kDone;
  facts.itinerary.clear_suspicion(facts);
  cycle.choose_aim(facts, lookouts, draft.takeover, tick_work);
  return Progress::kDone;
}

/// What rests at its aim will leave, or not: until then the vehicle waits.
Progress FlightState::ask_plan() noexcept {
  const Progress progress = cycle.ask_plan(facts, draft.takeover, tick_work);
  if (progress == Progress::kFailed) block = {BlockedBy::kTrack, cycle.aim.target_place, kNoFence};
  return or_fail(progress);
}

Progress FlightState::end_planner() noexcept {
  Report found;
  const bool is_found = cycle.finish(found) == Status::kOk;
  if (cycle.job == Job::kPlan) {
    report.plan = cycle.keeps_remainder(found) ? Status::kOk : found.status;
    cycle.lead.shorten(facts, draft.takeover);
  }
  if (!is_found) {
    end_without_plan(found);
  } else if (cycle.job == Job::kRoute && lookouts.turns_away(cycle.route_found())) {
    cycle.leave();
  } else if (cycle.job == Job::kRoute) {
    cycle.follow_route(facts);
  } else {
    cycle.list_passages(facts, found, draft);
    choose_draft(true);
  }
  return Progress::kDone;
}

/// Asks the planner for something else, if there is anything. If the mission is a new one, the failure says nothing.
void FlightState::end_without_plan(const Report& found) noexcept {
  if (cycle.aim.is_outdated(facts.itinerary) || cycle.keeps_remainder(found)) return choose_draft(false);
  block.note_no_plan(facts, cycle.aim, found, tick_work);
  if (cycle.route.presumes_walls() && !is_by_time(found.status)) return cycle.do_without_walls();
  if (is_by_time(found.status)) ++cycle.met_things;
  if (note_fault(found)) return give_up();
  if (cycle.ask_through(facts)) return;
  const NextPlan next = cycle.job == Job::kRoute ? cycle.next_after_route(facts, found, draft.takeover)
                                                 : cycle.next_after_plan(facts, found, draft.takeover);
  if (next == NextPlan::kAsked) return;
  if (next == NextPlan::kNearest) park(FlightReason::kNearest);
  if (next == NextPlan::kCutOff) block.note_beyond(facts, cycle.aim, found.reachable, tick_work);
  choose_draft(false);
}

/// True if a point was left out: then the pending plan no longer fits the mission.
bool FlightState::note_fault(const Report& found) noexcept {
  const std::int32_t point = cycle.aim.point_at_fault(found, facts.itinerary);
  if (point < 0) return false;
  const bool is_fenced = found.status == Status::kViaFenced || found.status == Status::kGoalFenced;
  if (!is_fenced && (!facts.map.route().bound() || !facts.itinerary.is_blocked(facts, point))) return false;
  return facts.itinerary.suspect_point(point, is_fenced) && leave_out(point, FlightReason::kViaBlocked);
}

void FlightState::choose_draft(bool planned) noexcept {
  if (!cycle.choose_draft(facts, planned, draft)) fail();
}

/// The sensor should see next what ended the proof of the draft. If the flight gave up, or something is too near to the
/// resting vehicle, the report keeps that instead.
Progress FlightState::run_proof() noexcept {
  if (draft.proof.step(tick_work) == Status::kRunning) return Progress::kMore;
  if (draft.plan.lifts) {
    end_lift();
    return Progress::kDone;
  }
  const ProofReport& found = draft.proof.report();
  search.look_at_end(facts, draft, found.until);
  nose.note_view(facts.map, found);
  if (!draft.plan.looks_out && !facts.itinerary.parked && !watch.is_beside(facts))
    block.note_unproven(facts.map, draft);
  if (found.finding != Finding::kNone) {
    cycle.begin_branch(found.until);
    return Progress::kDone;
  }
  draft.follow_to_end(found.until);
  const std::int32_t closing = cycle.fence_at_end(facts, draft, tick_work);
  if (closing != kNoFence) block = {BlockedBy::kFence, draft.plan.end(), closing};
  if (closing == kNoFence && leads_on(facts, cycle.aim.start.d[0], draft)) {
    commit();
  } else {
    fail();
  }
  return Progress::kDone;
}

Progress FlightState::run_confirm() noexcept {
  if (draft.proof.step(tick_work) == Status::kRunning) return Progress::kMore;
  const bool is_proven = draft.proof.report().finding == Finding::kNone;
  if (is_proven && cycle.fence_at_end(facts, draft, tick_work) == kNoFence) {
    commit();
  } else {
    cycle.reject_branch();
  }
  return Progress::kDone;
}

Progress FlightState::run_sidestep() noexcept {
  const Progress progress = cycle.sidesteps.advance(facts, cycle.expected, draft, tick_work);
  if (progress == Progress::kDone) commit();
  return or_fail(progress);
}

/// The progress of a step. A step that fails ends the cycle.
Progress FlightState::or_fail(Progress progress) noexcept {
  if (progress != Progress::kFailed) return progress;
  fail();
  return Progress::kDone;
}

/// Commits the draft, or asks whether it may be flown. A late one that may begin at any time takes over with the next
/// tick. A brake does not ask. False, and nothing is committed, if it does not join the committed plan.
bool FlightState::commit() noexcept {
  const bool begins_now = cycle.lead.late > 0 && may_shift_plan() && !draft.extends;
  if (begins_now) draft.shift(facts.time + facts.spec.tick - draft.takeover);
  if (!draft.joins_committed_plan(facts.plans, tick_work)) {
    fail();
    return false;
  }
  const bool asks = facts.spec.clearance > 0 && !evasion.is_running && cycle.job != Job::kRenew &&
                    draft.changes_committed_plan(facts.plans);
  asks ? cycle.ask_for_clearance() : enter_draft();
  return true;
}

/// Makes the draft a committed plan. New plans that do not lead nearer to the goal are counted, so that no vehicle
/// flies back and forth without end.
void FlightState::enter_draft() noexcept {
  if (!draft.extends && !evasion.is_running && !draft.plan.looks_out && !cycle.is_sidestep()) {
    facts.itinerary.count_plan(facts, cycle.aim.start.d[0]);
    cycle.forget_cut_off();
    if (facts.itinerary.is_hopeless()) park(FlightReason::kNoProgress);
  }
  if (!evasion.is_running) facts.itinerary.note_held_up(cycle.gave_way);
  if (cycle.steps_back && !evasion.is_running && !lookouts.leads()) lookouts.note_step_back(facts.map);
  cycle.leave();
  cycle.met_things = 0;
  evasion.leave();
  if (draft.changes_committed_plan(facts.plans)) ++report.committed;
  search.note_commit();
  watch.note_commit(draft.extends, draft.takeover);
  if (!draft.extends) facts.stray.note_plan();
  // What was measured during the proof may refute its tubes.
  const bool has_news = draft.plan.tubes.take_news(facts.tracks, !(facts.spec.clearance > 0));
  facts.plans.commit(draft.plan, draft.extends);
  if (has_news) watch.prove_all();
}

void FlightState::fail() noexcept {
  ++report.failed;
  give_up();
}

}  // namespace tern
