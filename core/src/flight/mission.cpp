// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points of a mission: which of them the next plan passes, when one was passed, and what happens to one that
// cannot be reached.
#include "base/math.hpp"
#include "base/too_narrow.hpp"
#include "flight/branch.hpp"
#include "flight/flight_state.hpp"
#include "grid/distance.hpp"

namespace tern {

void FlightState::begin_mission(const Via* points, std::int32_t count, ViaPolicy policy) noexcept {
  for (std::int32_t i = 0; i < count; ++i) {
    itinerary.points[i] = points[i];
    itinerary.state[i] = PointState::kAhead;
  }
  // The flight ends at the goal, at rest.
  itinerary.points[count - 1].tolerance = 0.0;
  itinerary.points[count - 1].stop = false;
  itinerary.points[count - 1].dwell = 0.0;
  itinerary.count = count;
  itinerary.leg = itinerary.suspicions = 0;
  itinerary.policy = policy;
  goal = points[0].position;
  has_goal = true;
  ++goal_number;
  stopping = false;
  try_anew();
}

/// Whatever made the vehicle give up is forgotten.
void FlightState::try_anew() noexcept {
  parked = is_looking = cut_off = seeks = false;
  idle_cycles = fruitless = wandering = 0;
  forget_lookouts();
  nearest = -1.0;
  block = kNoBlockage;
  reason = FlightReason::kNone;
}

bool FlightState::in_window(const Vec3& place) const noexcept {
  const GridSpec& window = map.safe().spec();
  const double margin = window.clearance() + kAimVoxels * window.cell;
  for (int a = 0; a < 3; ++a) {
    if (axis(place, a) < axis(window.boundary.lower, a) + margin) return false;
    if (axis(place, a) > axis(window.boundary.upper, a) - margin) return false;
  }
  return true;
}

/// The next plan passes all points that are less than a horizon away, along straight lines, and then leads towards the
/// target. That is the first point that is further away or has a dwell, or the goal.
void FlightState::choose_points(const Vec3& from) noexcept {
  const Grid& seen = map.route();
  const bool is_clear = itinerary.suspicions > 0 && seen.bound() && !is_blocked(itinerary.suspect);
  if (is_clear) itinerary.suspicions = 0;
  asked_count = 0;
  target = leg_at(takeover);
  double way = distance(from, itinerary.points[target].position);
  while (target != itinerary.last() && way <= spec.horizon && in_window(itinerary.points[target].position)) {
    if (itinerary.points[target].dwell > 0.0) break;
    const Vec3& place = itinerary.points[target].position;
    ask_for(target);
    target = itinerary.after(target);
    way += distance(place, itinerary.points[target].position);
  }
  goal = itinerary.points[target].position;
}

void FlightState::ask_for(std::int32_t point) noexcept {
  asked_point[asked_count] = point;
  asked[asked_count++] = itinerary.points[point];
}

/// Asks for the points that the planner's plan in flight still passes, for a plan to the same aim.
void FlightState::keep_points() noexcept {
  const std::int32_t leg = leg_at(takeover);
  asked_count = 0;
  for (std::int32_t i = 0; i < now.passages; ++i) {
    const std::int32_t point = now.passage[i].point;
    if (point >= leg && !(now.to_goal && point == now.target)) ask_for(point);
  }
  target = now.target;
  goal = itinerary.points[target].position;
}

/// True if no point that the planner's plan in flight passes was skipped since, and its target is still ahead.
bool FlightState::still_fits() const noexcept {
  for (std::int32_t i = 0; i < now.passages; ++i) {
    if (itinerary.state[now.passage[i].point] == PointState::kSkipped) return false;
  }
  return itinerary.state[now.target] == PointState::kAhead;
}

/// Metres along straight lines from `from`, past the points that are asked for, to `to`.
double FlightState::way_length(const Vec3& from, const Vec3& to) const noexcept {
  double sum = 0.0;
  Vec3 place = from;
  for (std::int32_t i = 0; i < asked_count; ++i) {
    sum += distance(place, asked[i].position);
    place = asked[i].position;
  }
  return sum + distance(place, to);
}

Vec3 FlightState::place_before_target(const Vec3& from) const noexcept {
  return asked_count > 0 ? asked[asked_count - 1].position : from;
}

/// A plan past all points that were asked for failed. Asks for one that ends at rest at the last point that may be
/// reached. False if there is no point to leave out, or if the plan in flight goes on anyway.
bool FlightState::ask_for_less(const Report& found) noexcept {
  if (asked_count == 0 || keeps) return false;
  const bool on_way = found.status == Status::kNoPath || lacks_via_voxel(found.status) ||
                      found.status == Status::kViaFenced || lacks_goal_voxel(found.status) ||
                      found.status == Status::kGoalFenced;
  const std::int32_t reached_points = !on_way ? 0 : (found.via == kNoVia ? asked_count : found.via);
  end_at_point(reached_points > 1 ? reached_points - 1 : 0);
  ask_planner();
  return true;
}

/// Something that was seen is nearer to the point than the radius.
bool FlightState::is_blocked(std::int32_t point) const noexcept {
  const Grid& seen = map.route();
  const Vec3& place = itinerary.points[point].position;
  return in_window(place) && !point_clear(seen, seen.to_local(place), seen.spec().clearance());
}

/// The point at which a plan failed, if it may be left out; otherwise negative.
std::int32_t FlightState::point_at_fault(const Report& found) const noexcept {
  const bool at_via = lacks_via_voxel(found.status) || found.status == Status::kViaFenced;
  const bool at_aim = lacks_goal_voxel(found.status) || found.status == Status::kGoalFenced;
  if (at_via && found.via != kNoVia) return asked_point[found.via];
  return at_aim && aims_at_goal && target != itinerary.last() ? target : -1;
}

/// True if a point was left out: then the pending plan no longer fits the mission.
bool FlightState::note_fault(const Report& found) noexcept {
  const std::int32_t point = point_at_fault(found);
  if (point < 0) return false;
  const bool is_fenced = found.status == Status::kViaFenced || found.status == Status::kGoalFenced;
  if (!is_fenced && (!map.route().bound() || !is_blocked(point))) return false;
  itinerary.suspicions = itinerary.suspect == point ? itinerary.suspicions + 1 : 1;
  itinerary.suspect = point;
  if (!is_fenced && itinerary.suspicions < kBlockedPlans) return false;
  return leave_out(point, FlightReason::kViaBlocked);
}

/// Leaves out a point as the mission's policy says. The mission ends only if the point is the next one.
bool FlightState::leave_out(std::int32_t point, FlightReason why) noexcept {
  if (itinerary.policy == ViaPolicy::kSkip) {
    itinerary.state[point] = PointState::kSkipped;
    itinerary.suspicions = 0;
    if (point == itinerary.leg) go_on_from(point);
    return true;
  }
  if (point != itinerary.leg) return false;
  has_goal = is_looking = false;
  parked = stopping = true;
  reason = why;
  return true;
}

/// Passes only the first `points` of the points that are asked for; the one after them becomes the target.
void FlightState::ask_for_first(std::int32_t points) noexcept {
  if (points < asked_count) target = asked_point[points];
  asked_count = points;
  goal = itinerary.points[target].position;
  const bool ends_beside = points > 0 && distance(aim, asked[points - 1].position) < route.grid().spec().cell;
  if (ends_beside) end_at_point(points - 1);
}

/// Lets the plan end at rest at point `number` of those that are asked for.
void FlightState::end_at_point(std::int32_t number) noexcept {
  asked_count = number;
  target = asked_point[number];
  goal = aim = itinerary.points[target].position;
  aims_at_goal = true;
  moved_aim = beside_goal = false;
}

/// Puts the aim onto the way, one horizon along it, if the way past the points that are asked for is longer than that.
void FlightState::shorten_way(const Path& way) noexcept {
  const Vec3& origin = route.grid().spec().origin;
  double left = spec.horizon;
  std::int32_t passed = 0;
  for (int i = 1; i < way.count; ++i) {
    const double leg = distance(way.points[i - 1], way.points[i]);
    if (leg > left) {
      aim = origin + way.points[i - 1] + (left / leg) * (way.points[i] - way.points[i - 1]);
      aims_at_goal = beside_goal = moved_aim = false;
      ask_for_first(passed);
      return;
    }
    left -= leg;
    const Vec3 place = origin + way.points[i];
    while (passed < asked_count && distance(place, asked[passed].position) < kSamePlace) ++passed;
  }
}

/// There is a new mission since the pending plan was begun. The plan may be flown, but counts as passing none of the
/// new points; if it fails, that says nothing about them.
bool FlightState::is_outdated() const noexcept {
  return planned_goal != goal_number;
}

}  // namespace tern
