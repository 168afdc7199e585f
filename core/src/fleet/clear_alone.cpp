// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/work.hpp"
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

/// A part of a plan, or all of it.
struct Stretch {
  Box hull;    ///< from the plan's origin
  double end;  ///< s after the plan's beginning
};

bool is_clear_of(const FleetMemory& fleet, const Trajectory& plan, const Stretch& part, const Beacon& beacon) {
  const double radii = fleet.spec.radius + 1e-3 * beacon.radius + kRounding;
  const double age = part.end - time_on(plan, beacon.stamp);
  return gap_between(part.hull, beacon.place - plan.origin) >= radii + strayed(fleet, age);
}

/// Of vehicles that were not heard, or that the table has no room for.
bool is_clear_of_unheard(const FleetMemory& fleet, const Trajectory& plan, const Stretch& part, std::int64_t now) {
  const FleetRange& range = fleet.spec.range;
  const Beacons& beacons = fleet.beacons;
  if (now - beacons.begun <= range.within) return false;
  // Both may have moved since they were that far apart, and this vehicle may have taken a plan over late.
  const double moved = 2.0 * range.speed * seconds(range.within + fleet.spec.tick);
  const double gap = smaller(range.heard, gap_to_unkept(fleet, now)) - moved - fleet.spec.radius - kRounding;
  return reach_from(part.hull, beacons.place - plan.origin) + strayed(fleet, part.end - time_on(plan, now)) <= gap;
}

/// It follows the rules of the right of way until the plan rests, as this vehicle does.
bool is_trusted(const FleetMemory& fleet, const Trajectory& plan, const Beacon& beacon) {
  const std::int32_t p = beacon.is_member ? find_peer(fleet, beacon.id) : fleet.peer_count;
  const std::int64_t rest = plan.begin + static_cast<std::int64_t>(1e9 * duration(plan)) + 1;
  return p < fleet.peer_count && fleet.peers[p].link.binds && fleet.peers[p].link.trusted >= rest;
}

/// Of all vehicles, or `why` and `by` say of whom not.
bool is_clear(const FleetMemory& fleet, const Stretch& part, std::int64_t now, FleetBlock& why, std::uint16_t& by) {
  const Trajectory& plan = next_plan(fleet).plan;
  for (std::int32_t k = 0; k < fleet.beacons.count; ++k) {
    const Beacon& beacon = fleet.beacons.of[k];
    if (is_stale(fleet, beacon, now) || is_clear_of(fleet, plan, part, beacon)) continue;
    if (is_trusted(fleet, plan, beacon)) continue;
    why = FleetBlock::kStranger;
    by = beacon.id;
    return false;
  }
  why = FleetBlock::kUnheard;
  by = 0;
  return is_clear_of_unheard(fleet, plan, part, now);
}

}  // namespace

bool is_clear_alone(const FleetMemory& fleet, std::int64_t now, Work& work, FleetBlock& why,
                    std::uint16_t& by) noexcept {
  const Trajectory& plan = next_plan(fleet).plan;
  const Operations each = ops::kCurve + 4 * ops::kDot * (fleet.beacons.count + 1);
  work.spend(each + ops::kCurve * plan.count);
  // The whole plan at once is enough for most.
  Stretch whole{hull_of(plan.segments[0]), duration(plan)};
  for (std::int32_t s = 1; s < plan.count; ++s) grow(whole.hull, plan.segments[s]);
  if (is_clear(fleet, whole, now, why, by)) return true;
  work.spend(each * plan.count);
  double end = 0.0;
  for (std::int32_t s = 0; s < plan.count; ++s) {
    end += plan.segments[s].duration;
    if (!is_clear(fleet, {hull_of(plan.segments[s]), end}, now, why, by)) return false;
  }
  return true;
}

}  // namespace tern
