// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fleet/fleet_memory.hpp"

namespace tern {
namespace {

/// m: what arithmetic rounds, with much to spare.
constexpr double kRounding = 1e-6;

void grow(Box& hull, const Segment& segment) {
  for (const Vec3& point : segment.points) {
    hull.lower = {smaller(hull.lower.x, point.x), smaller(hull.lower.y, point.y), smaller(hull.lower.z, point.z)};
    hull.upper = {larger(hull.upper.x, point.x), larger(hull.upper.y, point.y), larger(hull.upper.z, point.z)};
  }
}

Box hull_of(const Segment& segment) {
  Box hull{segment.points[0], segment.points[0]};
  grow(hull, segment);
  return hull;
}

Box hull_of(const Trajectory& plan) {
  Box hull = hull_of(plan.segments[0]);
  for (std::int32_t s = 1; s < plan.count; ++s) grow(hull, plan.segments[s]);
  return hull;
}

/// How far a place is from a box, on the axis on which that is most, m.
double gap_between(const Box& hull, const Vec3& place) {
  double gap = 0.0;
  for (int a = 0; a < 3; ++a) {
    gap = larger(gap, larger(axis(hull.lower, a) - axis(place, a), axis(place, a) - axis(hull.upper, a)));
  }
  return gap;
}

/// How far a box reaches from a place, on the axis on which that is most, m.
double reach_from(const Box& hull, const Vec3& place) {
  return larger(axis_distance(hull.lower, place), axis_distance(hull.upper, place));
}

/// A plan against vehicles that may go anywhere. `since`: from when on, s after its beginning.
struct TimedPlan {
  const Trajectory& plan;
  const Box& hull;
  double since;
};

/// True if each segment keeps clear. First the whole plan at once, which is enough for most.
template <typename Clear>
bool is_clear(const TimedPlan& flown, Clear clear) {
  const Trajectory& plan = flown.plan;
  if (clear(flown.hull, duration(plan) - flown.since)) return true;
  double end = -flown.since;
  for (std::int32_t s = 0; s < plan.count; ++s) {
    end += plan.segments[s].duration;
    if (!clear(hull_of(plan.segments[s]), end)) return false;
  }
  return true;
}

bool is_clear_of(const FleetMemory& fleet, const Trajectory& plan, const Box& whole, const Beacon& beacon) {
  const double radii = fleet.spec.radius + 1e-3 * beacon.radius + kRounding;
  const Vec3 place = beacon.place - plan.origin;
  return is_clear({plan, whole, time_on(plan, beacon.stamp)},
                  [&](const Box& hull, double age) { return gap_between(hull, place) >= radii + strayed(fleet, age); });
}

/// Of vehicles that were not heard, or that the table has no room for.
bool is_clear_of_unheard(const FleetMemory& fleet, const Trajectory& plan, const Box& whole, std::int64_t now) {
  const FleetRange& range = fleet.spec.range;
  const Beacons& beacons = fleet.beacons;
  if (now - beacons.begun <= range.within) return false;
  double gap = range.heard;
  if (now - beacons.beyond.time <= range.within) gap = smaller(gap, beacons.beyond.gap);
  // Both may have moved since they were that far apart.
  gap -= 2.0 * range.speed * seconds(range.within) + fleet.spec.radius + kRounding;
  const Vec3 place = beacons.place - plan.origin;
  return is_clear({plan, whole, time_on(plan, now)},
                  [&](const Box& hull, double age) { return reach_from(hull, place) + strayed(fleet, age) <= gap; });
}

}  // namespace

bool is_clear_alone(const FleetMemory& fleet, std::int64_t now, FleetBlock& why, std::uint16_t& by) noexcept {
  const OwnPlan& next = next_plan(fleet);
  const Box whole = hull_of(next.plan);
  const std::int64_t rest = next.plan.begin + static_cast<std::int64_t>(1e9 * duration(next.plan)) + 1;
  for (std::int32_t k = 0; k < fleet.beacons.count; ++k) {
    const Beacon& beacon = fleet.beacons.of[k];
    if (is_stale(fleet, beacon, now) || is_clear_of(fleet, next.plan, whole, beacon)) continue;
    const std::int32_t p = beacon.is_member ? find_peer(fleet, beacon.id) : fleet.peer_count;
    if (p < fleet.peer_count && fleet.peers[p].link.binds && fleet.peers[p].link.trusted >= rest) continue;
    why = FleetBlock::kStranger;
    by = beacon.id;
    return false;
  }
  why = FleetBlock::kUnheard;
  by = fleet.spec.id;
  return is_clear_of_unheard(fleet, next.plan, whole, now);
}

}  // namespace tern
