// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/lift.hpp"

#include "base/math.hpp"
#include "curve/hermite.hpp"
#include "flight/branch.hpp"
#include "flight/flight_state.hpp"

namespace tern {
namespace {

/// From rest to rest in unit time over unit length, a segment's largest speed, acceleration and jerk, rounded up. Its
/// curve is 35 u^4 - 84 u^5 + 70 u^6 - 20 u^7.
constexpr double kTopSpeed = 2.18751;
constexpr double kTopAcceleration = 7.5133;
constexpr double kTopJerk = 52.501;
/// A limit on jerk is met by longer durations: each try takes so much more, and so many tries suffice for a jerk that
/// is 10^7 times too large.
constexpr double kLonger = 1.1;
constexpr int kTries = 60;

}  // namespace

bool append_lift(const Vec3& way, double speed, const MotionLimits& limits, Trajectory& out) noexcept {
  const Vec3 v = kTopSpeed * way;
  const Vec3 a = kTopAcceleration * way;
  const double fastest = larger(gauge(limits.velocity, v), length(v) / speed);
  const double sharpest = larger(gauge(limits.acceleration, a), gauge(limits.acceleration, kZero - a));
  double time = larger(kMinDuration, larger(fastest, square_root(sharpest)));
  const double jerk = ramp_gauge(limits, kTopJerk * way);
  for (int k = 0; k < kTries && jerk > time * time * time; ++k) time *= kLonger;
  return append_between(JointState{}, JointState{{way, kZero, kZero, kZero}}, time, out);
}

/// A vehicle that stands on the ground, or stopped on its way up or down, climbs first. One that hovers above the place
/// to land on descends. True if nothing else may begin now.
bool FlightState::begin_lift() noexcept {
  const Commitment& in_flight = facts.plans.in_flight;
  const bool is_over = draft.takeover >= facts.plans.rest_begins();
  if (in_flight.lifts && (!is_over || facts.lands())) return true;
  const double top = height_above(facts.map.safe().spec(), in_flight.ground);
  const Vec3 from = in_flight.end();
  const bool climbs = in_flight.lifts && from.z < top - kSamePlace;
  const Landing& landing = facts.landing;
  const bool lands =
      landing.is_asked && is_over && !climbs && !lookouts.is_active() && facts.itinerary.is_reached_by(in_flight);
  if (!climbs && !lands) return false;
  ++report.asked;
  cycle.begin_lift(facts, draft.takeover);
  if (climbs) {
    draft.lift(facts, {from.x, from.y, top}, kAnywhere, in_flight.departed, in_flight.ground);
    search.look_towards(facts.itinerary.points[facts.itinerary.leg].position);
    return true;
  }
  const Vec3 place{from.x, from.y, landing.place.z};
  draft.lift(facts, place, landing.speed, place, landing.ground);
  draft.plan.lands = true;
  if (!block.note_site(facts.map, place, landing.ground, tick_work)) end_lift_unproven();
  return true;
}

/// The proof of a lift is done.
void FlightState::end_lift() noexcept {
  const ProofReport& found = draft.proof.report();
  if (found.finding == Finding::kNone) {
    draft.follow_to_end(found.until);
    commit();
    return;
  }
  block.note_unproven(facts.map, draft);
  end_lift_unproven();
}

/// What was seen to be in the way of a landing stays there. What was not seen may be looked at.
void FlightState::end_lift_unproven() noexcept {
  if (draft.plan.lands && block.by != BlockedBy::kUnseen) {
    ++report.failed;
    cycle.leave();
    return park(FlightReason::kGroundUneven);
  }
  fail();
}

}  // namespace tern
