// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The vehicle's surroundings, and the report of a tick.
#include "flight/flight_state.hpp"

namespace tern {
namespace {

FlightMode mode_of(const FlightFacts& facts, const Watch& watch, bool looks) {
  if (watch.shows_threat(facts)) return FlightMode::kThreat;
  if (facts.hovers()) return looks ? FlightMode::kLook : FlightMode::kRest;
  const Commitment& in_flight = facts.plans.in_flight;
  return in_flight.time_at(facts.time) < in_flight.branch ? FlightMode::kFly : FlightMode::kStop;
}

}  // namespace

/// The distance of the nearest thing from the resting vehicle, metres.
double FlightState::note_block_near_vehicle() noexcept {
  return block.note_near(facts.map, facts.position(), facts.map.safe(), tick_work);
}

void FlightState::finish_report(std::uint32_t spent) noexcept {
  report.mode = mode_of(facts, watch, search.is_looking || lookouts.phase == LookoutPhase::kLooking);
  report.reason = facts.itinerary.reason;
  if (report.reason == FlightReason::kNone && !facts.hovers()) report.reason = facts.stray.reason();
  report.stray = facts.stray.error;
  report.speed_share = facts.stray.speed_share();
  report.work = spent;
  report.waits_for_nose = nose.waits_for_nose(facts);
  report.map_stale = facts.is_stale();
  report.frame_age = facts.time - facts.frame_time;
  report.leg = facts.itinerary.leg;
  report.passed = facts.itinerary.count_points(PointState::kPassed);
  report.skipped = facts.itinerary.count_points(PointState::kSkipped);
  const bool has_block = watch.is_beside(facts) || (facts.itinerary.reason != FlightReason::kNoGoal &&
                                                    facts.itinerary.reason != FlightReason::kArrived &&
                                                    facts.itinerary.reason != FlightReason::kLanded);
  const Blockage& what = has_block ? block : kNoBlockage;
  report.blocked_by = what.by;
  report.blocked_at = what.at;
  report.blocked_fence = what.fence;
  const bool is_threat = report.mode == FlightMode::kThreat;
  report.contact_time = is_threat ? facts.clock.shown_at(watch.first_contact().time) : 0;
  report.contact_speed = is_threat ? watch.first_contact().speed : 0.0;
}

}  // namespace tern
