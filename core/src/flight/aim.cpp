// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where plans lead, where the sensor points, and when there is no point in going on.
#include "base/math.hpp"
#include "base/too_narrow.hpp"
#include "flight/flight_state.hpp"
#include "grid/bit_rows.hpp"
#include "grid/distance.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

/// A new aim is chosen when less than this part of the horizon is left.
constexpr double kAimRest = 0.6;
/// Voxels around the vehicle that are looked at for a way out, along each axis and direction.
constexpr std::int32_t kMaxWayOut = 8;
/// A vehicle that finds no plan counts as right before a goal in an obstacle within this many radii and some voxels.
constexpr double kBeforeRadii = 2.0;
/// A direction is held this much longer than the turn takes, seconds: frames are late.
constexpr double kLookTime = 0.3;
constexpr double kEighthTurn = 0.78539816339744831;  // pi / 4
constexpr double kHalfRoot = 0.70710678118654752;    // sqrt(1 / 2)

/// How far a window's middle may be off the vehicle after it moved: a voxel, and along x half a word and the slack.
Vec3 offset_after_move(const RollingMap& map) {
  return map.safe().spec().cell * Vec3{0.5 * kWordBits + map.slack() + 1.0, 1.0, 1.0};
}

/// How far a plan leads away from `center` along an axis, from time `t` on.
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

}  // namespace

Vec3 offset_of(int direction) noexcept {
  constexpr double kCosines[kDirections] = {1.0, kHalfRoot, 0.0, -kHalfRoot, -1.0, -kHalfRoot, 0.0, kHalfRoot};
  return {kCosines[direction], kCosines[(direction + 6) % kDirections], 0.0};
}

/// Aims at the target, or at the point on the straight line to it that is at most `most` away and within the window.
void FlightState::choose_aim(const Vec3& from, double most) noexcept {
  const GridSpec& window = map.safe().spec();
  const double margin = window.clearance() + kAimVoxels * window.cell;
  const Vec3 way = goal - from;
  const double far = length(way);
  double part = far > most ? most / far : 1.0;
  for (int a = 0; a < 3; ++a) {
    const double room = axis(way, a) > 0.0 ? axis(window.boundary.upper, a) - margin - axis(from, a)
                                           : axis(from, a) - margin - axis(window.boundary.lower, a);
    const double length_a = absolute(axis(way, a));
    if (length_a > room) part = smaller(part, larger(0.0, room) / length_a);
  }
  aims_at_goal = part >= 1.0;
  aim = aims_at_goal ? goal : from + part * way;
}

/// Aims straight away from what is within the radius, and one radius far.
void FlightState::choose_way_out(const Vec3& from) noexcept {
  const Grid& safe = map.safe();
  const GridSpec& window = safe.spec();
  const Vec3 local = safe.to_local(from);
  const Voxel at = safe.voxel_of(local);
  const std::int32_t reach = ceil_index(window.clearance() / window.cell, 0, kMaxWayOut);
  Vec3 away = kZero;
  for (std::int32_t z = at.z - reach; z <= at.z + reach; ++z) {
    for (std::int32_t y = at.y - reach; y <= at.y + reach; ++y) {
      for (std::int32_t x = at.x - reach; x <= at.x + reach; ++x) {
        if (safe.obstacle({x, y, z})) away = away + (local - safe.center({x, y, z}));
      }
    }
  }
  const double size = length(away);
  if (!(size > 0.0)) return;
  aim = from + (window.clearance() / size) * away;
  aims_at_goal = false;
}

/// A plan keeps its aim until little of the way is left, so that plans are compared by their times.
bool FlightState::keeps_aim(const Vec3& from) const noexcept {
  return now.looks_out || (now.to_goal && now.target == itinerary.last()) ||
         way_length(from, now.aim) > kAimRest * spec.horizon;
}

/// The window follows the vehicle only as far as it must: space that leaves it is forgotten, and may hold the only way
/// to the goal. If it is wide enough, the window covers the horizon around the vehicle. It never cuts off the committed
/// plan, with the radius around it.
void FlightState::follow_window() noexcept {
  const GridSpec& window = map.safe().spec();
  const Vec3 at = sample_at(time).position;
  const Vec3 offset = offset_after_move(map);
  const double needed = spec.horizon + window.clearance() + kAimVoxels * window.cell;
  const Commitment& commitment = latest();
  Vec3 center = 0.5 * (window.boundary.lower + window.boundary.upper);
  for (int a = 0; a < 3; ++a) {
    const double half = 0.5 * (axis(window.boundary.upper, a) - axis(window.boundary.lower, a));
    const double spare = larger(0.0, half - axis(offset, a) - needed);
    axis(center, a) = clamp(axis(center, a), axis(at, a) - spare, axis(at, a) + spare);
    const double room = half - axis(offset, a) - window.clearance() - window.cell;
    if (reach_along(commitment.flown, seconds_between(commitment.begin, time), center, a) > room) return;
  }
  map.follow(center);
}

/// What the sensor should see next: what ended the last proof or, during a look around, one direction after the other.
Vec3 FlightState::looking_at(std::int64_t t) const noexcept {
  if (!is_looking) return look_at;
  const int sector = sector_at(t);
  if (sector < 1 || sector > kDirections) return look_at;
  return sample_at(t).position + spec.horizon * offset_of(sector - 1);
}

double FlightState::seconds_per_direction() const noexcept {
  double held = kEighthTurn / spec.yaw_rate + kLookTime;
  // A planned turn begins late, and takes time to speed up and to slow down.
  if (nose.planned)
    held += spec.yaw_rate / nose.yaw.acceleration_max + 1e-9 * kNoseTicks * static_cast<double>(spec.tick);
  return held;
}

int FlightState::sector_at(std::int64_t t) const noexcept {
  const double sector = seconds_between(look_since, t) / seconds_per_direction();
  constexpr int kLast = kDirections + kStares + 1;
  return sector < kLast ? static_cast<int>(sector) : kLast;
}

/// At rest, looks towards the voxel that ended the proof, at a point 1 m away at least: the voxel may be so near that
/// only its direction means anything.
void FlightState::look_at_obstacle() noexcept {
  const Vec3 at = sample_at(time).position;
  const Grid& safe = map.safe();
  const Vec3 way = safe.spec().origin + safe.center(proof.report().voxel) - at;
  const double flat = square_root(way.x * way.x + way.y * way.y);
  if (flat > 0.0) look_at = at + (larger(1.0, flat) / flat) * way;
}

/// A cycle ended without a commit. After kIdleCycles of them at rest, the vehicle looks around, then flies to lookouts
/// to see what blocks its way. If the goal is still cut off, the vehicle is as near to it as it gets. If nothing helps,
/// it gives up.
void FlightState::note_idle() noexcept {
  if (!rests() || parked) return;
  ++idle_cycles;
  if (idle_cycles < kIdleCycles) return;
  if (report.plan == Status::kGoalFenced && aims_at_goal && !leaves) return park(FlightReason::kNoProgress);
  note_place();
  if (is_looking) {
    if (sector_at(time) <= kDirections + kStares) return;
    is_looking = false;
    turned = true;
    sought = 0;
  }
  const bool is_nearest_place = (cut_off || is_before_goal()) && !leaves;
  if (!is_nearest_place && seek_lookout()) return;
  if (turned) {
    const FlightReason why = is_nearest_place ? FlightReason::kNearest : FlightReason::kNoProgress;
    return park(leaves ? FlightReason::kHemmedIn : why);
  }
  is_looking = true;
  look_since = time;
  if (is_before_goal()) look_since -= nanoseconds((kDirections + 1) * seconds_per_direction()) + 1;
}

/// The goal is in an obstacle that was seen, and the vehicle is right before it: a look around would show no way. A
/// stare shows whether the obstacle is only a wrong pixel.
bool FlightState::is_before_goal() const noexcept {
  const GridSpec& window = map.safe().spec();
  const double near = kBeforeRadii * window.clearance() + kAimVoxels * window.cell;
  const Vec3& place = itinerary.points[itinerary.leg].position;
  const Grid& seen = map.route();
  if (!seen.bound() || distance(sample_at(time).position, place) > near) return false;
  const Vec3 local = seen.to_local(place);
  return seen.inside(seen.voxel_of(local)) && !point_clear(seen, local, window.clearance());
}

/// Gives up, or leaves out the next point as the mission's policy says. Without new frames nothing is known about the
/// points, so the flight gives up as a whole.
void FlightState::park(FlightReason why) noexcept {
  if (why == FlightReason::kNoProgress && is_stale()) why = FlightReason::kMapStale;
  const bool is_general = why == FlightReason::kHemmedIn || why == FlightReason::kMapStale;
  if (itinerary.leg != itinerary.last() && !is_general) {
    const bool is_blocked = why == FlightReason::kNearest && !cut_off;
    leave_out(itinerary.leg, is_blocked ? FlightReason::kViaBlocked : FlightReason::kViaUnreachable);
    return;
  }
  parked = true;
  is_looking = false;
  reason = why;
  if (why == FlightReason::kNearest && !cut_off) note_block_near(goal, map.route());
  if (why == FlightReason::kHemmedIn) note_block_near(start.d[0], map.safe());
}

/// True if the vehicle will rest, and the nearest free point to an aim in an obstacle is no nearer than its own place.
/// If the goal itself is in an obstacle that was seen, this is as near as it gets. If only its voxel is, the vehicle
/// looks around first. Otherwise something unseen is in between.
bool FlightState::is_nearest() noexcept {
  const Grid& seen = map.route();
  const double slack = kAimVoxels * seen.spec().cell;
  if (!rests_at_takeover() || distance(start.d[0], goal) > distance(aim, goal) + slack) return false;
  if (seen.bound() && aims_at_goal && !point_clear(seen, seen.to_local(goal), seen.spec().clearance())) {
    park(FlightReason::kNearest);
  } else if (all_free) {
    cut_off = aims_at_goal;
  }
  return true;
}

/// An aim in an obstacle moves to the nearest free point, once. False if that leads nowhere.
bool FlightState::move_aim(const Report& found) noexcept {
  if (!lacks_goal_voxel(found.status) || !found.has_nearest_free || moved_aim) return false;
  moved_aim = true;
  aim = found.nearest_free;
  if (asked_count == 0 && is_nearest()) return false;
  const double slack = kAimVoxels * map.route().spec().cell;
  const bool keeps_beside = keeps && now.beside_goal && now.target == target;
  if (keeps_beside && distance(now.aim, goal) <= distance(aim, goal) + slack) aim = now.aim;
  beside_goal = aims_at_goal || keeps_beside;
  aims_at_goal = false;
  ask_planner();
  return true;
}

/// If no way through the window leads to the aim even with all unseen voxels free, plans to the reachable point nearest
/// to the aim. False if the vehicle rests there already.
bool FlightState::move_to_reachable(const Report& found) noexcept {
  const bool no_way = found.status == Status::kNoPath && found.has_reachable && all_free && !to_reachable;
  if (!no_way || asked_count > 0) return false;
  const double left = distance(start.d[0], goal) - distance(found.reachable, goal);
  const bool is_there = rests_at_takeover() && left <= map.route().spec().cell;
  cut_off = is_there && (aims_at_goal || beside_goal);
  if (cut_off) note_block_beyond(found.reachable);
  if (is_there) return false;
  aim = found.reachable;
  to_reachable = true;
  aims_at_goal = beside_goal = false;
  way_length(start.d[0], aim) > spec.horizon ? ask_route() : ask_planner();
  return true;
}

/// A new plan is about to be committed. Those that do not lead nearer to the goal are counted, so that no vehicle flies
/// to and fro for ever.
void FlightState::note_progress() noexcept {
  const double left = distance(start.d[0], itinerary.points[itinerary.leg].position);
  const bool comes_nearer = nearest < 0.0 || left < nearest - map.safe().spec().cell;
  if (comes_nearer) {
    nearest = left;
    forget_lookouts();
  }
  wandering = comes_nearer ? 0 : wandering + 1;
  const bool learns = map.learned() - learned >= kLearned;
  if (learns) learned = map.learned();
  fruitless = comes_nearer || learns ? 0 : fruitless + 1;
  cut_off = false;
  if (fruitless > kFruitless || wandering > kWandering) park(FlightReason::kNoProgress);
}

/// At rest at the goal, the flight has arrived, and plans no more.
void FlightState::note_rest() noexcept {
  if (!has_goal || parked || !rests() || !reaches_goal()) return;
  itinerary.state[itinerary.last()] = PointState::kPassed;
  park(FlightReason::kArrived);
}

/// The plan in flight ends at the goal.
bool FlightState::reaches_goal() const noexcept {
  return now.to_goal && now.target == itinerary.last() && now.goal == goal_number && now.branch >= duration(now.wished);
}

}  // namespace tern
