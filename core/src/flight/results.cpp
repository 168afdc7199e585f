// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the results of a cycle mean to the other parts: the next step, a commit, or a failure after which the vehicle
// may look for a way on, or give up.
#include "flight/flight_state.hpp"

namespace tern {

/// Begins a plan, unless there is nothing to plan for, or no map to plan on.
void FlightState::begin_cycle() noexcept {
  const bool is_free = !facts.plans.has_waiting && !evasion.stop_asked && !watch.is_running;
  if (!itinerary.has_goal || itinerary.parked || !is_free || !facts.map.safe().bound()) return;
  draft.begin(facts, cycle.lead_ticks(facts.spec));
  const Commitment& in_flight = facts.plans.in_flight;
  const bool stays = itinerary.is_reached_by(in_flight) || itinerary.dwells_after(in_flight);
  if (stays && facts.rests_at(draft.takeover)) return;
  ++report.asked;
  cycle.begin(facts, itinerary, search, draft.takeover);
  if (cycle.job == Job::kLookout) search.begin_lookout();
}

// One line a job: a table.
// clang-format off
Progress FlightState::run_job(Work& work) noexcept {
  switch (cycle.job) {
    case Job::kIdle: return Progress::kMore;
    case Job::kLookout: return run_lookout(work);
    case Job::kCopy: return cycle.copy(facts.map, work);
    case Job::kFollow: return cycle.begin_remainder(facts, itinerary, draft);
    case Job::kRemainder: return cycle.prove_remainder(facts, itinerary, draft, work);
    case Job::kAim: return choose_aim();
    case Job::kAskRoute: return cycle.ask_route(facts, *planner, tick_work);
    case Job::kAskPlan: return cycle.ask_plan(facts, *planner, draft.takeover, tick_work);
    case Job::kRoute: return planner->step(work) == Status::kRunning ? Progress::kMore : end_route();
    case Job::kPlan: return planner->step(work) == Status::kRunning ? Progress::kMore : end_plan();
    case Job::kWait: return or_fail(cycle.begin_proof(facts, draft));
    case Job::kProve: return run_proof(work);
    case Job::kBranch: return or_fail(cycle.find_branch(facts, draft, work));
    case Job::kConfirm: return run_confirm(work);
  }
  return Progress::kMore;
}
// clang-format on

Progress FlightState::run_lookout(Work& work) noexcept {
  const Progress progress = search.find_lookout(facts, block, draft.takeover, work);
  if (progress == Progress::kDone) cycle.begin_copy(facts, itinerary, search, draft.takeover);
  return progress;
}

Progress FlightState::choose_aim() noexcept {
  if (cycle.follow_aim(facts, itinerary, draft.takeover)) return Progress::kDone;
  itinerary.clear_suspicion(facts);
  cycle.choose_aim(facts, itinerary, search, block, draft.takeover, tick_work);
  return Progress::kDone;
}

Progress FlightState::end_route() noexcept {
  Report found;
  if (planner->finish_route(found) == Status::kOk) {
    cycle.follow_route(facts, itinerary, *planner->path());
  } else {
    end_without_plan(found);
  }
  return Progress::kDone;
}

Progress FlightState::end_plan() noexcept {
  Report found;
  report.plan = cycle.finish(*planner, found);
  cycle.shorten_lead(facts, draft.takeover);
  if (report.plan == Status::kOk) {
    cycle.list_passages(itinerary, found, draft);
    choose_draft(true);
  } else {
    end_without_plan(found);
  }
  return Progress::kDone;
}

/// Asks the planner for something else, if there is anything. If the mission is a new one, the failure says nothing.
void FlightState::end_without_plan(const Report& found) noexcept {
  if (cycle.aim.is_outdated(itinerary)) return choose_draft(false);
  block.note_no_plan(facts, cycle.aim, found, tick_work);
  if (note_fault(found)) return give_up();
  const NextPlan next = cycle.job == Job::kRoute ? cycle.next_after_route(facts, itinerary, found, draft.takeover)
                                                 : cycle.next_after_plan(facts, itinerary, found, draft.takeover);
  if (next == NextPlan::kAsked) return;
  if (next == NextPlan::kNearest) park(FlightReason::kNearest);
  if (next == NextPlan::kCutOff) block.note_beyond(facts, cycle.aim, found.reachable, tick_work);
  choose_draft(false);
}

/// True if a point was left out: then the pending plan no longer fits the mission.
bool FlightState::note_fault(const Report& found) noexcept {
  const std::int32_t point = cycle.aim.point_at_fault(found, itinerary);
  if (point < 0) return false;
  const bool is_fenced = found.status == Status::kViaFenced || found.status == Status::kGoalFenced;
  if (!is_fenced && (!facts.map.route().bound() || !itinerary.is_blocked(facts, point))) return false;
  return itinerary.suspect_point(point, is_fenced) && leave_out(point, FlightReason::kViaBlocked);
}

void FlightState::choose_draft(bool planned) noexcept {
  const Vec3& hidden = search.seeks ? block.at : facts.plans.in_flight.hidden;
  if (!cycle.choose_draft(facts, itinerary, planned, hidden, draft)) fail();
}

/// What ended the proof of the draft is what the sensor should see next. If the flight gave up, or something is too
/// near to the resting vehicle, the report keeps that instead.
Progress FlightState::run_proof(Work& work) noexcept {
  if (draft.proof.step(work) == Status::kRunning) return Progress::kMore;
  const ProofReport& found = draft.proof.report();
  search.look_at_end(facts, draft, found.until);
  nose.note_view(facts.map, found);
  if (!draft.plan.looks_out && !itinerary.parked && !watch.is_beside(facts)) block.note_unproven(facts.map, draft);
  if (found.finding != Finding::kNone) {
    cycle.begin_branch(found.until);
    return Progress::kDone;
  }
  draft.follow_to_end(found.until);
  if (leads_on(facts, cycle.aim.start.d[0], draft)) {
    commit();
  } else {
    fail();
  }
  return Progress::kDone;
}

Progress FlightState::run_confirm(Work& work) noexcept {
  if (draft.proof.step(work) == Status::kRunning) return Progress::kMore;
  if (draft.proof.report().finding == Finding::kNone) {
    commit();
  } else {
    cycle.reject_branch();
  }
  return Progress::kDone;
}

/// The progress of a step; if it failed, the cycle has failed, and is done.
Progress FlightState::or_fail(Progress progress) noexcept {
  if (progress != Progress::kFailed) return progress;
  fail();
  return Progress::kDone;
}

/// Commits the draft. False, and nothing is committed, if it does not join the committed plan.
bool FlightState::commit() noexcept {
  if (!draft.joins_committed_plan(facts.plans, tick_work)) {
    fail();
    return false;
  }
  enter_draft();
  return true;
}

/// Makes the draft a committed plan. New plans that do not lead nearer to the goal are counted, so that no vehicle
/// flies back and forth without end.
void FlightState::enter_draft() noexcept {
  if (!draft.extends && !evasion.is_running && !draft.plan.looks_out) {
    if (itinerary.count_plan(facts, cycle.aim.start.d[0])) search.forget_lookouts();
    cycle.forget_cut_off();
    if (itinerary.is_hopeless()) park(FlightReason::kNoProgress);
  }
  cycle.leave();
  evasion.leave();
  if (draft.changes_committed_plan(facts.plans)) ++report.committed;
  search.note_commit(draft, facts.plans.in_flight);
  watch.note_commit(draft.extends, draft.takeover);
  facts.plans.commit(draft.plan, draft.extends);
}

void FlightState::fail() noexcept {
  ++report.failed;
  give_up();
}

/// A cycle or an evasion ends without a commit.
void FlightState::give_up() noexcept {
  cycle.leave();
  evasion.leave();
  after_failed_cycle();
}

void FlightState::after_failed_cycle() noexcept {
  if (!facts.rests() || itinerary.parked || !search.count_idle()) return;
  if (report.plan == Status::kGoalFenced && cycle.aim.at_target && !cycle.hemmed_in) {
    return park(FlightReason::kNoProgress);
  }
  const FlightReason why = search.after_failed_cycle(facts, itinerary, block, cycle.hemmed_in, cycle.cut_off, nose);
  if (why != FlightReason::kNone) park(why);
}

/// Gives up, or leaves out the next point as the mission's policy says. Without new frames nothing is known about the
/// points, so the flight gives up as a whole.
void FlightState::park(FlightReason why) noexcept {
  if (why == FlightReason::kNoProgress && facts.is_stale()) why = FlightReason::kMapStale;
  const bool is_general = why == FlightReason::kHemmedIn || why == FlightReason::kMapStale;
  const bool is_occupied = why == FlightReason::kNearest && !cycle.cut_off;
  if (itinerary.leg != itinerary.last() && !is_general) {
    leave_out(itinerary.leg, is_occupied ? FlightReason::kViaBlocked : FlightReason::kViaUnreachable);
    return;
  }
  itinerary.park(why);
  search.end_look();
  if (is_occupied) block.note_near(facts.map, cycle.aim.target_place, facts.map.route(), tick_work);
  if (why == FlightReason::kHemmedIn) {
    block.note_near(facts.map, cycle.aim.start.d[0], facts.map.safe(), tick_work);
  }
}

/// True if the mission goes on without the point, or ended.
bool FlightState::leave_out(std::int32_t point, FlightReason why) noexcept {
  const LeftOut left_out = itinerary.leave_out(point, why);
  if (left_out == LeftOut::kLeg) try_anew();
  if (left_out == LeftOut::kEnded) {
    search.end_look();
    evasion.ask_for_stop();
  }
  return left_out != LeftOut::kNothing;
}

/// Whatever made the vehicle give up is forgotten.
void FlightState::try_anew() noexcept {
  itinerary.try_anew();
  search.try_anew();
  cycle.forget_cut_off();
  block.clear();
}

}  // namespace tern
