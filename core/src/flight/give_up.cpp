// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What follows if a cycle ends without a commit: another attempt, a look for a way on, or an end with a reason.
#include "flight/flight_state.hpp"

namespace tern {

/// A cycle or an evasion ends without a commit.
void FlightState::give_up() noexcept {
  const bool was_step_back = cycle.steps_back && !evasion.is_running;
  cycle.leave();
  evasion.leave();
  if (was_step_back) return next_attempt();
  // What moves will be elsewhere soon, and a fence may end or begin: no reason to look around, or to give up.
  const bool is_by_thing = block.is_temporary(facts, tick_work) || cycle.gave_way;
  if (is_by_thing && block.by != BlockedBy::kFence && facts.rests()) facts.itinerary.note_held_up(true);
  if (!facts.rests() || facts.itinerary.parked || is_by_thing) return;
  lookouts.note_failure(facts);
  if (!search.count_idle()) return;
  if (report.plan == Status::kGoalFenced && cycle.aim.at_target && !cycle.hemmed_in) {
    return park(FlightReason::kNoProgress);
  }
  const bool is_at_end = cycle.hemmed_in || cycle.cut_off || facts.itinerary.is_right_before(facts);
  if (!is_at_end && !search.wants_survey(facts) && lookouts.may_help(facts)) return;
  const bool had_turned = search.turned;
  const FlightReason why = search.after_failed_cycle(facts, cycle.hemmed_in, cycle.cut_off, nose);
  if (why == FlightReason::kNoProgress && !had_turned && lookouts.searches_again(facts)) return;
  const bool is_for_ever = block.by == BlockedBy::kFence || !is_by_time(report.plan);
  if (why != FlightReason::kNone && is_for_ever) park(why);
}

/// A step back that failed says nothing of the plans, nor what is in their way: the next attempt is another one.
void FlightState::next_attempt() noexcept {
  lookouts.note_failure(facts);
  search.count_idle();
}

/// Why the vehicle does not land, if that is why it rests.
FlightReason FlightState::reason_of_landing(FlightReason why) const noexcept {
  if (why == FlightReason::kNoProgress && facts.itinerary.is_reached_by(facts.plans.in_flight)) {
    return FlightReason::kGroundUnseen;
  }
  return why == FlightReason::kNearest && !cycle.cut_off ? FlightReason::kGroundUneven : why;
}

/// Gives up, or leaves out the next point as the mission's policy says. Without new frames nothing is known about the
/// points, so the flight gives up as a whole.
void FlightState::park(FlightReason why) noexcept {
  if (facts.landing.is_asked && !facts.is_stale()) why = reason_of_landing(why);
  if (why == FlightReason::kNoProgress && facts.is_stale()) why = FlightReason::kMapStale;
  Vec3 unseen{};
  const bool is_fenced = block.by == BlockedBy::kFence;
  if (why == FlightReason::kNoProgress && !is_fenced && lookouts.has_unseen(facts, unseen)) {
    why = FlightReason::kGoalUnseen;
  }
  const bool is_general =
      why == FlightReason::kHemmedIn || why == FlightReason::kMapStale || why == FlightReason::kHeldUp;
  const bool is_occupied = why == FlightReason::kNearest && !cycle.cut_off;
  if (facts.itinerary.leg != facts.itinerary.last() && !is_general) {
    leave_out(facts.itinerary.leg, is_occupied ? FlightReason::kViaBlocked : FlightReason::kViaUnreachable);
    return;
  }
  facts.itinerary.park(why);
  search.end_look();
  if (why == FlightReason::kGoalUnseen) block = {BlockedBy::kUnseen, unseen, kNoFence};
  if (is_occupied) block.note_near(facts.map, cycle.aim.target_place, facts.map.route(), tick_work);
  if (why == FlightReason::kHemmedIn) {
    block.note_near(facts.map, cycle.aim.start.d[0], facts.map.safe(), tick_work);
  }
}

/// True if the mission goes on without the point, or ended.
bool FlightState::leave_out(std::int32_t point, FlightReason why) noexcept {
  const LeftOut left_out = facts.itinerary.leave_out(point, why);
  if (left_out == LeftOut::kLeg) try_anew();
  if (left_out == LeftOut::kEnded) {
    search.end_look();
    evasion.ask_for_stop();
  }
  return left_out != LeftOut::kNothing;
}

/// Forgets all reasons to give up.
void FlightState::try_anew() noexcept {
  facts.itinerary.try_anew();
  search.try_anew(facts.position());
  lookouts.try_anew();
  cycle.forget_cut_off();
  block = kNoBlockage;
}

}  // namespace tern
