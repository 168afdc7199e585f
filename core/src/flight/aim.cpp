// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where plans lead, where the sensor points, and when there is no point in going on.
#include "base/math.hpp"
#include "flight/flight_state.hpp"
#include "grid/bit_rows.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

/// A new aim is chosen where less than this part of the horizon is left.
constexpr double kAimRest = 0.6;
/// A direction is held this much longer than the turn takes, seconds: frames are late.
constexpr double kLookTime = 0.3;
constexpr double kEighthTurn = 0.78539816339744831;  // pi / 4
constexpr double kHalfRoot = 0.70710678118654752;    // sqrt(1 / 2)

/// How far a window's middle may be off the vehicle after it moved: a voxel, and along x half a word and the slack.
Vec3 offset_after_move(const RollingMap& map) {
  return map.safe().spec().cell * Vec3{0.5 * kWordBits + map.slack() + 1.0, 1.0, 1.0};
}

/// How far a plan leads away from a point from `t` on, along an axis.
double reach_along(const Trajectory& plan, double t, const Vec3& center, int a) {
  double reach = 0.0;
  double end = 0.0;
  for (int i = 0; i < plan.count; ++i) {
    end += plan.segments[i].duration;
    if (end < t && i + 1 < plan.count) continue;
    for (const Vec3& point : plan.segments[i].points) {
      reach = larger(reach, absolute(axis(plan.origin, a) + axis(point, a) - axis(center, a)));
    }
  }
  return reach;
}

Vec3 offset_of(int direction) {
  constexpr double kCosines[kDirections] = {1.0, kHalfRoot, 0.0, -kHalfRoot, -1.0, -kHalfRoot, 0.0, kHalfRoot};
  return {kCosines[direction], kCosines[(direction + 6) % kDirections], 0.0};
}

}  // namespace

/// The goal, or the point on the straight line to it that is within the horizon and the window.
void FlightState::choose_aim(const Vec3& from) noexcept {
  const GridSpec& window = map.safe().spec();
  const double margin = window.radius + kAimVoxels * window.cell;
  const Vec3 way = goal - from;
  const double far = length(way);
  double part = far > spec.horizon ? spec.horizon / far : 1.0;
  for (int a = 0; a < 3; ++a) {
    const double room = axis(way, a) > 0.0 ? axis(window.boundary.upper, a) - margin - axis(from, a)
                                           : axis(from, a) - margin - axis(window.boundary.lower, a);
    const double length_a = absolute(axis(way, a));
    if (length_a > room) part = smaller(part, larger(0.0, room) / length_a);
  }
  aims_at_goal = part >= 1.0;
  aim = aims_at_goal ? goal : from + part * way;
}

/// A plan keeps its aim until little of the way is left, so that plans are compared by their times.
bool FlightState::keeps_aim(const Vec3& from) const noexcept {
  return now.to_goal || distance(from, now.aim) > kAimRest * spec.horizon;
}

/// The window follows the vehicle where it cannot cut off what will be flown, with the radius around it.
void FlightState::follow_window() noexcept {
  const GridSpec& window = map.safe().spec();
  const Vec3 center = sample_at(time).position;
  const Vec3 offset = offset_after_move(map);
  const Course& course = has_next ? next : now;
  for (int a = 0; a < 3; ++a) {
    const double half = 0.5 * (axis(window.boundary.upper, a) - axis(window.boundary.lower, a));
    const double room = half - axis(offset, a) - window.radius - window.cell;
    if (reach_along(course.flown, seconds_between(course.begin, time), center, a) > room) return;
  }
  map.follow(center);
}

/// What the sensor should see next: what ended the last proof, or while looking around one direction after the other.
Vec3 FlightState::looking_at(std::int64_t t) const noexcept {
  if (!is_looking) return look_at;
  const int sector = sector_at(t);
  if (sector < 1) return look_at;
  return sample_at(t).position + spec.horizon * offset_of((sector - 1) % kDirections);
}

int FlightState::sector_at(std::int64_t t) const noexcept {
  const double sector = seconds_between(look_since, t) / (kEighthTurn / spec.yaw_rate + kLookTime);
  return sector < kDirections + 1.0 ? static_cast<int>(sector) : kDirections + 1;
}

/// A cycle ended without a commit. At rest the vehicle then looks around, once; after that it gives up.
void FlightState::note_idle() noexcept {
  if (!rests() || parked) return;
  ++idle_cycles;
  if (idle_cycles < kPatience) return;
  if (!is_looking) {
    is_looking = true;
    look_since = time;
  } else if (sector_at(time) > kDirections) {
    park(FlightReason::kNoProgress);
  }
}

void FlightState::park(FlightReason why) noexcept {
  parked = true;
  is_looking = false;
  reason = why;
}

/// True where the vehicle will rest, and the nearest free point to an aim in an obstacle is no nearer than where it is.
/// If the goal itself is in an obstacle that was seen, this is as near as it gets; otherwise something unseen is in
/// between.
bool FlightState::is_nearest() noexcept {
  const Grid& seen = map.route();
  const double slack = kAimVoxels * seen.spec().cell;
  if (!rests_at_takeover() || distance(start.d[0], goal) > distance(aim, goal) + slack) return false;
  if (seen.bound() && aims_at_goal && !point_clear(seen, seen.to_local(goal), seen.spec().radius)) {
    park(FlightReason::kNearest);
  }
  return true;
}

/// A new plan is about to be committed. Those that do not lead nearer to the goal are counted, so that no vehicle flies
/// to and fro for ever.
void FlightState::note_progress() noexcept {
  const double left = distance(start.d[0], goal);
  if (nearest < 0.0 || left < nearest - map.safe().spec().cell) {
    nearest = left;
    fruitless = 0;
  } else if (++fruitless > kFruitless) {
    park(FlightReason::kNoProgress);
  }
}

/// At the goal, there is nothing left to plan.
void FlightState::note_rest() noexcept {
  if (has_goal && !parked && rests() && reaches_goal()) park(FlightReason::kArrived);
}

/// What is flown ends at the goal.
bool FlightState::reaches_goal() const noexcept {
  return now.to_goal && now.goal == goal_number && now.branch >= duration(now.wished);
}

}  // namespace tern
