// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "flight/itinerary.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "flight/flight_facts.hpp"
#include "grid/distance.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// Within this many radii and some voxels of a goal in an obstacle, a vehicle without a plan counts as right before it.
constexpr double kBeforeRadii = 2.0;

/// kOk, or the fault of a point. Tolerance, stop and dwell of the goal mean nothing. A velocity cannot be promised in
/// unknown space.
Status check_point(const Via& point, bool is_goal) {
  if (!finite(point.position)) return Status::kNonFiniteInput;
  if (point.has_velocity) return Status::kInvalidArgument;
  if (is_goal) return Status::kOk;
  if (!finite(point.tolerance) || !finite(point.dwell)) return Status::kNonFiniteInput;
  return point.tolerance < 0.0 || !dwell_valid(point) ? Status::kInvalidArgument : Status::kOk;
}

}  // namespace

Status check_mission(const Via* points, std::int32_t count, ViaPolicy policy) noexcept {
  if (points == nullptr || count < 1) return Status::kInvalidArgument;
  if (policy != ViaPolicy::kEnd && policy != ViaPolicy::kSkip) return Status::kInvalidArgument;
  if (is_full(count > kMaxMissionPoints)) return Status::kViasFull;
  for (std::int32_t i = 0; i < count; ++i) {
    const Status status = check_point(points[i], i + 1 == count);
    if (status != Status::kOk) return status;
  }
  return Status::kOk;
}

void Itinerary::begin(const Via* mission_points, std::int32_t point_count, ViaPolicy mission_policy) noexcept {
  for (std::int32_t i = 0; i < point_count; ++i) {
    points[i] = mission_points[i];
    state[i] = PointState::kAhead;
  }
  // The flight ends at the goal, at rest.
  points[point_count - 1].tolerance = 0.0;
  points[point_count - 1].stop = false;
  points[point_count - 1].dwell = 0.0;
  count = point_count;
  leg = suspicions = 0;
  policy = mission_policy;
  has_goal = true;
  ++number;
}

void Itinerary::try_anew() noexcept {
  parked = false;
  fruitless = wandering = 0;
  held_up = 0;
  is_held_up = false;
  nearest = -1.0;
  reason = FlightReason::kNone;
}

void Itinerary::park(FlightReason why) noexcept {
  parked = true;
  reason = why;
}

void Itinerary::forget_goal() noexcept {
  has_goal = false;
  reason = FlightReason::kNoGoal;
}

/// A point is passed if the plan in flight says so, or if it is the next one and the vehicle is within its tolerance.
bool Itinerary::pass_points(const FlightFacts& flight) noexcept {
  if (!has_goal) return false;
  const CommittedPlans& plans = flight.plans;
  const bool took_over = plans.has_waiting && plans.waiting.begin() < flight.time;
  const std::int32_t before = leg;
  const std::int32_t next = leg_at(plans.in_flight, took_over ? plans.waiting.begin() : flight.time);
  while (leg != next) {
    pass(leg);
    go_on_from(leg);
  }
  const Via& point = points[leg];  // the goal has no tolerance
  const bool is_near =
      point.tolerance > 0.0 && !point.stop && distance(flight.position(), point.position) <= point.tolerance;
  if (is_near) {
    pass(leg);
    go_on_from(leg);
  }
  return leg != before;
}

void Itinerary::clear_suspicion(const FlightFacts& flight) noexcept {
  if (suspicions > 0 && flight.map.route().bound() && !is_blocked(flight, suspect)) suspicions = 0;
}

bool Itinerary::suspect_point(std::int32_t point, bool lasts) noexcept {
  suspicions = suspect == point ? suspicions + 1 : 1;
  suspect = point;
  return lasts || suspicions >= kBlockedPlans;
}

LeftOut Itinerary::leave_out(std::int32_t point, FlightReason why) noexcept {
  if (policy == ViaPolicy::kSkip) {
    state[point] = PointState::kSkipped;
    suspicions = 0;
    if (point != leg) return LeftOut::kSkipped;
    go_on_from(point);
    return LeftOut::kLeg;
  }
  if (point != leg) return LeftOut::kNothing;
  has_goal = false;
  park(why);
  return LeftOut::kEnded;
}

bool Itinerary::count_plan(const FlightFacts& flight, const Vec3& from) noexcept {
  const double remaining = distance(from, points[leg].position);
  const bool comes_nearer = nearest < 0.0 || remaining < nearest - flight.map.safe().spec().cell;
  if (comes_nearer) {
    nearest = remaining;
    held_up = 0;
  }
  wandering = comes_nearer ? 0 : wandering + 1;
  const bool learns = flight.map.learned() - learned >= kLearned;
  if (learns) learned = flight.map.learned();
  fruitless = comes_nearer || learns ? 0 : fruitless + 1;
  return comes_nearer;
}

/// Plans that led nowhere so far do not count for a vehicle that is pushed away.
void Itinerary::note_held_up(bool by_thing) noexcept {
  is_held_up = by_thing;
  if (by_thing) fruitless = 0;
}

bool Itinerary::waits_too_long(std::int64_t gap) noexcept {
  if (goes_on() && is_held_up) held_up += gap;
  return held_up > kPatience;
}

std::int32_t Itinerary::after(std::int32_t point) const noexcept {
  while (point < last() && state[++point] == PointState::kSkipped) {
  }
  return point;
}

std::int32_t Itinerary::leg_at(const Commitment& in_flight, std::int64_t t) const noexcept {
  std::int32_t next = leg;
  if (in_flight.mission != number) return next;
  const double since_begin = in_flight.time_at(t);
  for (std::int32_t i = 0; i < in_flight.passages; ++i) {
    const Passage& passage = in_flight.passage[i];
    const bool passed = passage.time <= in_flight.branch && passage.time + points[next].dwell <= since_begin;
    if (passage.point == next && passed && next < last()) next = after(next);
  }
  return next;
}

bool Itinerary::is_reached_by(const Commitment& plan) const noexcept {
  return plan.at_target && plan.target == last() && plan.mission == number && plan.branch >= duration(plan.planned);
}

bool Itinerary::dwells_after(const Commitment& plan) const noexcept {
  if (!plan.at_target || plan.mission != number || plan.branch < duration(plan.planned)) return false;
  return plan.target == leg && points[plan.target].dwell > 0.0;
}

bool Itinerary::still_fits(const Commitment& plan) const noexcept {
  for (std::int32_t i = 0; i < plan.passages; ++i) {
    if (state[plan.passage[i].point] == PointState::kSkipped) return false;
  }
  return state[plan.target] == PointState::kAhead;
}

bool Itinerary::is_blocked(const FlightFacts& flight, std::int32_t point) const noexcept {
  const Grid& seen = flight.map.route();
  const Vec3& place = points[point].position;
  return flight.in_window(place) && !point_clear(seen, seen.to_local(place), seen.spec().clearance());
}

bool Itinerary::is_right_before(const FlightFacts& flight) const noexcept {
  const GridSpec& window = flight.map.safe().spec();
  const double near = kBeforeRadii * window.clearance() + kAimVoxels * window.cell;
  const Vec3& place = points[leg].position;
  const Grid& seen = flight.map.route();
  if (!seen.bound() || distance(flight.position(), place) > near) return false;
  const Vec3 local = seen.to_local(place);
  return seen.inside(seen.voxel_of(local)) && !point_clear(seen, local, window.clearance());
}

std::int32_t Itinerary::count_points(PointState which) const noexcept {
  std::int32_t found = 0;
  for (std::int32_t i = 0; i < count; ++i) found += state[i] == which ? 1 : 0;
  return found;
}

}  // namespace tern
