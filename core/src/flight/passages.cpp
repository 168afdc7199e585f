// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// When plans pass the points of a mission, and which points the vehicle has passed.
#include "base/math.hpp"
#include "flight/flight_state.hpp"

namespace tern {
namespace {

/// How much later than the plan in flight a new plan may pass the next point, seconds.
constexpr double kLaterAtPoint = 0.25;
/// Later than any plan passes a point, seconds.
constexpr double kNever = 1e9;

/// When a plan passes the point; kNever if it does not.
double time_of(const Commitment& plan, std::int32_t point) {
  for (std::int32_t i = 0; i < plan.passages; ++i) {
    if (plan.passage[i].point == point) return plan.passage[i].time;
  }
  return kNever;
}

}  // namespace

/// The next point at that time, if nothing else is committed before. A point with a dwell is passed once the dwell is
/// over.
std::int32_t FlightState::leg_at(std::int64_t t) const noexcept {
  std::int32_t leg = itinerary.leg;
  if (now.goal != goal_number) return leg;
  const double flown = seconds_between(now.begin, t);
  for (std::int32_t i = 0; i < now.passages; ++i) {
    const Passage& passage = now.passage[i];
    const bool passed = passage.time <= now.branch && passage.time + itinerary.points[leg].dwell <= flown;
    if (passage.point == leg && passed && leg < itinerary.last()) leg = itinerary.after(leg);
  }
  return leg;
}

/// The plan in flight ends at a point with a dwell, and the dwell is not over.
bool FlightState::ends_at_dwell() const noexcept {
  if (!now.to_goal || now.goal != goal_number || now.branch < duration(now.wished)) return false;
  return now.target == itinerary.leg && itinerary.points[now.target].dwell > 0.0;
}

/// Notes the points that were passed until now: those that the plan in flight says, and the next one if the vehicle is
/// within its tolerance.
void FlightState::pass_points() noexcept {
  if (!has_goal) return;
  const std::int32_t leg = leg_at(has_next && next.begin < time ? next.begin : time);
  while (itinerary.leg != leg) pass_point();
  const Via& point = itinerary.points[itinerary.leg];  // the goal has no tolerance
  const bool is_near =
      point.tolerance > 0.0 && !point.stop && distance(sample_at(time).position, point.position) <= point.tolerance;
  if (is_near) pass_point();
}

void FlightState::pass_point() noexcept {
  itinerary.state[itinerary.leg] = PointState::kPassed;
  go_on_from(itinerary.leg);
}

void FlightState::go_on_from(std::int32_t point) noexcept {
  itinerary.leg = itinerary.after(point);
  try_anew();
}

/// Lists when the planner's trajectory passes the points that it was asked for, and the target if it ends there.
void FlightState::list_passages(const Report& found) noexcept {
  if (is_outdated()) {
    asked_count = 0;
    aims_at_goal = beside_goal = false;
  }
  draft.passages = asked_count;
  for (std::int32_t i = 0; i < asked_count; ++i) draft.passage[i] = {asked_point[i], found.vias[i].time};
  draft.target = target;
  if (aims_at_goal) draft.passage[draft.passages++] = {target, duration(plan)};
}

/// True if the draft passes the next point much later than the plan in flight: right before a point, the planner may
/// find no way through it but to stop and come back.
bool FlightState::passes_later() const noexcept {
  const std::int32_t leg = leg_at(takeover);
  if (leg == itinerary.last()) return false;
  const double kept = time_of(now, leg);
  const double flown = seconds_between(now.begin, takeover);
  return kept < kNever && kept - flown + kLaterAtPoint < time_of(draft, leg);
}

}  // namespace tern
