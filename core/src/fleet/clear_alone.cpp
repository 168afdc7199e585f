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

bool is_clear_of(const FleetMemory& fleet, const Trajectory& plan, const PlanPart& part, const Beacon& beacon) {
  const double radii = fleet.spec.radius + 1e-3 * beacon.radius + kRounding;
  const double age = part.end - time_on(plan, beacon.stamp);
  return gap_between(part.hull, beacon.place - plan.origin) >= radii + strayed(fleet, age);
}

/// Of vehicles that were not heard, or that the table has no room for.
bool is_clear_of_unheard(const FleetMemory& fleet, const Trajectory& plan, const PlanPart& part, std::int64_t now) {
  const FleetRange& range = fleet.spec.range;
  const Beacons& beacons = fleet.beacons;
  if (now - beacons.begun <= range.within) return false;
  // Both may have moved since they were that far apart, and this vehicle may have taken a plan over late.
  const double moved = 2.0 * range.speed * seconds(range.within + fleet.spec.tick);
  const double gap = smaller(range.heard, gap_to_unkept(fleet, now)) - moved - fleet.spec.radius - kRounding;
  return reach_from(part.hull, beacons.place - plan.origin) + strayed(fleet, part.end - time_on(plan, now)) <= gap;
}

/// It follows the rules of the right of way until the plan rests, as this vehicle does.
bool is_trusted(const FleetMemory& fleet, const Beacon& beacon, Work& work) {
  if (!beacon.is_member) return false;
  work.spend(ops::kTurn * fleet.peer_count);
  const std::int32_t p = find_peer(fleet, beacon.id);
  const OwnPlan& next = next_plan(fleet);
  const std::int64_t rest = next.plan.begin + static_cast<std::int64_t>(1e9 * next.whole.end) + 1;
  return p < fleet.peer_count && fleet.peers[p].link.binds && fleet.peers[p].link.trusted >= rest;
}

/// The whole plan at once, which is enough for most, or each segment of it.
template <typename IsClear>
bool is_clear(const OwnPlan& own, Work& work, const IsClear& is_clear_part) {
  work.spend(4 * ops::kDot);
  if (is_clear_part(own.whole)) return true;
  const Trajectory& plan = own.plan;
  work.spend((ops::kCurve + 4 * ops::kDot) * plan.count);
  double end = 0.0;
  for (std::int32_t s = 0; s < plan.count; ++s) {
    end += plan.segments[s].duration;
    if (!is_clear_part({hull_of(plan.segments[s]), end})) return false;
  }
  return true;
}

}  // namespace

PlanPart whole_of(const Trajectory& plan) noexcept {
  PlanPart whole{hull_of(plan.segments[0]), duration(plan)};
  for (std::int32_t s = 1; s < plan.count; ++s) grow(whole.hull, plan.segments[s]);
  return whole;
}

Status step_alone(FleetMemory& fleet, std::int64_t now, Work& work, FleetBlock& why, std::uint16_t& by) noexcept {
  const OwnPlan& next = next_plan(fleet);
  const Beacon* const beacon = beacon_from(fleet.beacons, fleet.job.heard);
  if (beacon == nullptr) {
    const auto of_unheard = [&](const PlanPart& part) { return is_clear_of_unheard(fleet, next.plan, part, now); };
    why = is_clear(next, work, of_unheard) ? FleetBlock::kNone : FleetBlock::kUnheard;
    by = 0;
    return Status::kOk;
  }
  fleet.job.heard = beacon->id + 1;
  const auto of_it = [&](const PlanPart& part) { return is_clear_of(fleet, next.plan, part, *beacon); };
  const bool is_fine = is_stale(fleet, *beacon, now) || is_trusted(fleet, *beacon, work) || is_clear(next, work, of_it);
  if (is_fine) return Status::kRunning;
  why = FleetBlock::kStranger;
  by = beacon->id;
  return Status::kOk;
}

}  // namespace tern
