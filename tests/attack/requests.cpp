// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "attack/asking.hpp"
#include "attack/checker.hpp"
#include "attack/clearance.hpp"
#include "tern/flatness.hpp"

namespace tern_attack {
namespace {

constexpr std::uint32_t kUnlimited = 0xFFFFFFFFu;

bool zero(const tern::Vec3& v) {
  return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

/// A point of a voxel's closed cube, in cells from its lower corner.
tern::Vec3 place_in_voxel(Rng& rng) {
  const double u = rng.unit();
  if (u < 0.4) return {0.5, 0.5, 0.5};
  if (u < 0.7) return {rng.unit(), rng.unit(), rng.unit()};
  constexpr double kLattice[] = {0.0, 1.0};
  if (u < 0.85) return {rng.pick(kLattice), rng.pick(kLattice), rng.pick(kLattice)};
  tern::Vec3 at{rng.unit(), rng.unit(), rng.unit()};
  axis(at, rng.integer(0, 2)) = rng.pick(kLattice);
  return at;
}

tern::Vec3 point_of_voxel(const World& world, const tern::Voxel& v, const tern::Vec3& at) {
  const double cell = world.spec.cell;
  const tern::Vec3& o = world.spec.origin;
  return {o.x + (v.x + at.x) * cell, o.y + (v.y + at.y) * cell, o.z + (v.z + at.z) * cell};
}

/// On the ray from an obstacle's face, edge or corner, exactly the radius away.
tern::Vec3 point_at_radius(Rng& rng, const World& world) {
  for (int tries = 0; tries < 20; ++tries) {
    const int i = rng.integer(0, world.count() - 1);
    if (world.solid[static_cast<std::size_t>(i)] == 0) continue;
    const tern::Voxel v = world.voxel(i);
    tern::Vec3 p = point_of_voxel(world, v, place_in_voxel(rng));
    const int a = rng.integer(0, 2);
    const bool up = rng.chance(0.5);
    const double face = axis(world.spec.origin, a) + (axis(v, a) + (up ? 1 : 0)) * world.spec.cell;
    axis(p, a) = face + (up ? world.spec.radius : -world.spec.radius);
    return p;
  }
  return point_of_voxel(world, world.voxel(rng.integer(0, world.count() - 1)), {0.5, 0.5, 0.5});
}

void clamp_to_boundary(const World& world, tern::Vec3& p) {
  for (int a = 0; a < 3; ++a) {
    const double low = axis(world.spec.boundary.lower, a);
    axis(p, a) = std::max(low, std::min(axis(world.spec.boundary.upper, a), axis(p, a)));
  }
}

double gauge(const tern::Vec3& most, const tern::Vec3& least, double horizontal, const tern::Vec3& v) {
  double g = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double down = axis(least, a) < 0.0 ? axis(least, a) : -axis(most, a);
    g = std::max(g, axis(v, a) / (axis(v, a) < 0.0 ? down : axis(most, a)));
  }
  return horizontal > 0.0 ? std::max(g, std::sqrt(v.x * v.x + v.y * v.y) / horizontal) : g;
}

/// A vector of some direction, up to 0.98 of what the limits allow.
tern::Vec3 within(Rng& rng, const tern::Vec3& most, const tern::Vec3& least, double horizontal) {
  tern::Vec3 v{most.x * rng.real(-1, 1), most.y * rng.real(-1, 1), most.z * rng.real(-1, 1)};
  if (rng.chance(0.3)) axis(v, rng.integer(0, 2)) = 0.0;
  const double g = gauge(most, least, horizontal, v);
  const double scale = g > 0.0 ? rng.real(0.0, 0.98) / g : 0.0;
  return {scale * v.x, scale * v.y, scale * v.z};
}

void make_moving(Rng& rng, const tern::Limits& l, tern::State& state) {
  state.velocity = within(rng, l.v_max, l.v_min, l.v_horizontal);
  if (rng.chance(0.5)) state.acceleration = within(rng, l.a_max, l.a_min, l.a_horizontal);
}

void make_budget(Rng& rng, double none, tern::Budget& budget) {
  const double u = rng.unit();
  if (u < none) budget.trajectory = 0;
  if (u >= none && u < none + 0.15) budget.trajectory = static_cast<std::uint32_t>(rng.integer(1, 60));
  if (!rng.chance(0.04)) return;
  std::uint32_t* const budgets[] = {&budget.search, &budget.shortcut, &budget.corridor};
  *rng.pick(budgets) = static_cast<std::uint32_t>(rng.integer(0, 40));
}

/// From a picometre to some voxels beside the start: what is far from the grid's origin need not be long.
tern::Vec3 goal_nearby(Rng& rng, const World& world, const tern::Vec3& start) {
  const double reach = rng.chance(0.25) ? rng.spread(1e-12, 1.0) : 6.0 * world.spec.cell;
  tern::Vec3 goal = start;
  for (int a = 0; a < 3; ++a) axis(goal, a) += reach * rng.real(-1.0, 1.0);
  clamp_to_boundary(world, goal);
  return goal;
}

/// The goal: anywhere, the start itself, or a little beside it, from a picometre up.
tern::Vec3 make_goal(Rng& rng, const World& world, const Map& map, const tern::Vec3& start) {
  const double u = rng.unit();
  if (u >= 0.14) return make_point(rng, world, map);
  tern::Vec3 goal = start;
  if (u < 0.02) return goal;
  const double move = std::pow(10.0, rng.real(-12.0, 0.0));
  for (int a = 0; a < 3; ++a) axis(goal, a) += rng.chance(0.3) ? 0.0 : move * rng.real(-1, 1);
  clamp_to_boundary(world, goal);
  return goal;
}

bool rests(const tern::State& state) {
  return zero(state.velocity) && zero(state.acceleration) && zero(state.jerk);
}

}  // namespace

bool Ask::rest_to_rest() const {
  return rests(request.start) && rests(request.goal);
}

bool Ask::hurries() const {
  return std::any_of(vias.begin(), vias.end(), [](const tern::Via& via) { return via.has_velocity; });
}

bool Ask::unlimited_search() const {
  const tern::Budget& b = request.budget;
  return b.search == kUnlimited && b.shortcut == kUnlimited && b.corridor == kUnlimited;
}

tern::Vec3 make_point(Rng& rng, const World& world, const Map& map) {
  const double u = rng.unit();
  tern::Vec3 p{};
  if (u < 0.12) {
    p = point_at_radius(rng, world);
  } else if (u < 0.17 || map.free.empty()) {
    p = point_of_voxel(world, world.voxel(rng.integer(0, world.count() - 1)), place_in_voxel(rng));
  } else {
    const int i = map.free[static_cast<std::size_t>(rng.integer(0, static_cast<int>(map.free.size()) - 1))];
    p = point_of_voxel(world, world.voxel(i), place_in_voxel(rng));
  }
  if (u > 0.93) {
    const int a = rng.integer(0, 2);
    axis(p, a) = rng.chance(0.5) ? axis(world.spec.boundary.lower, a) : axis(world.spec.boundary.upper, a);
  }
  clamp_to_boundary(world, p);
  return p;
}

void make_limits(Rng& rng, tern::Limits& limits) {
  const double v = rng.spread(0.01, 100.0);
  const double a = rng.spread(0.01, 100.0);
  limits.v_max = {v, v, v};
  limits.a_max = {a, a, a};
  if (rng.chance(0.3)) limits.v_max = {rng.spread(0.01, 100), rng.spread(0.01, 100), rng.spread(0.01, 100)};
  if (rng.chance(0.3)) limits.a_max = {rng.spread(0.01, 100), rng.spread(0.01, 100), rng.spread(0.01, 100)};
  if (rng.chance(0.15)) limits.v_min = {-rng.spread(0.01, 100), 0.0, -rng.spread(0.01, 100)};
  if (rng.chance(0.15)) limits.a_min = {0.0, -rng.spread(0.01, 100), -rng.spread(0.01, 100)};
  if (rng.chance(0.15)) limits.v_horizontal = rng.spread(0.01, 100);
  if (rng.chance(0.15)) limits.a_horizontal = rng.spread(0.01, 100);
}

namespace {

/// Limits on jerk, and a jerk within them at an end that moves.
void limit_jerk(Rng& rng, tern::Request& request) {
  const double j = rng.spread(0.01, 1000.0);
  request.limits.j_max = {j, j, j};
  if (rng.chance(0.3)) axis(request.limits.j_max, rng.integer(0, 2)) = rng.chance(0.5) ? 0.0 : rng.spread(0.01, 1000.0);
  if (rng.chance(0.3)) request.limits.j_horizontal = rng.spread(0.01, 1000.0);
  const double norm = request.limits.j_horizontal > 0.0 ? std::min(j, request.limits.j_horizontal) : j;
  for (tern::State* state : {&request.start, &request.goal}) {
    if (rests(*state) || rng.chance(0.5)) continue;
    for (int a = 0; a < 3; ++a) {
      const double most = axis(request.limits.j_max, a) > 0.0 ? std::min(norm, axis(request.limits.j_max, a)) : norm;
      axis(state->jerk, a) = 0.7 * most * rng.real(-1.0, 1.0);
    }
  }
}

/// Limits of a vehicle.
void limit_vehicle(Rng& rng, tern::Request& request) {
  tern::Limits& limits = request.limits;
  if (rng.chance(0.7)) limits.thrust_max = tern::kGravity * rng.real(1.02, 8.0);
  if (rng.chance(0.7)) limits.thrust_min = tern::kGravity * rng.real(0.01, 0.98);
  if (rng.chance(0.7)) limits.tilt_tangent = rng.spread(0.02, 20.0);
  if (limits.thrust_min > 0.0 && rng.chance(0.7)) limits.rate_max = rng.spread(0.05, 50.0);
  calm_vehicle(request);
}

}  // namespace

void calm_vehicle(tern::Request& request) {
  const tern::Limits& limits = request.limits;
  for (tern::State* state : {&request.start, &request.goal}) {
    for (int k = 0; k < 60 && !keeps_vehicle(limits, point(state->acceleration), 0, 0); ++k) {
      for (int a = 0; a < 3; ++a) axis(state->acceleration, a) *= 0.5;
    }
    for (int k = 0; k < 60 && !turns_slowly(limits, point(state->acceleration), point(state->jerk)); ++k) {
      for (int a = 0; a < 3; ++a) axis(state->jerk, a) *= 0.5;
    }
  }
}

void make_request(Rng& rng, Family family, const World& world, const Map& map, Ask& ask) {
  tern::Request& r = ask.request;
  make_limits(rng, r.limits);
  r.start.position = make_point(rng, world, map);
  r.goal.position = make_goal(rng, world, map, r.start.position);
  const bool far = family == Family::kFar;
  if (far && rng.chance(0.7)) r.goal.position = goal_nearby(rng, world, r.start.position);
  if (rng.chance(far ? 0.5 : 0.25)) make_moving(rng, r.limits, r.start);
  if (rng.chance(0.08)) make_moving(rng, r.limits, r.goal);
  make_budget(rng, far ? 0.5 : 0.25, r.budget);
  if (rng.chance(0.3)) r.time_weight = rng.spread(1e-3, 1e6);
  if (family == Family::kFences) make_fences(rng, world, ask);
  Rng own = side_stream(rng);
  if (own.chance(0.2)) limit_jerk(own, r);
  if (own.chance(0.25)) limit_vehicle(own, r);
}

void make_mission(Rng& rng, const World& world, const Map& map, const Ask& ask, Ask& mission) {
  const tern::Limits& limits = ask.request.limits;
  mission.request = ask.request;
  mission.fences = ask.fences;
  mission.request.fences = mission.fences.empty() ? nullptr : mission.fences.data();
  for (int count = rng.integer(1, 5); count > 0; --count) {
    tern::Via via;
    const bool again = !mission.vias.empty() && rng.chance(0.08);
    via.position = again ? mission.vias.back().position : make_point(rng, world, map);
    if (rng.chance(0.08)) via.position = goal_nearby(rng, world, ask.request.start.position);
    if (rng.chance(0.5)) via.tolerance = world.spec.cell * rng.spread(1e-6, 20.0);
    via.stop = rng.chance(0.15);
    if (!via.stop && rng.chance(0.1)) {
      via.has_velocity = true;
      via.velocity = within(rng, limits.v_max, limits.v_min, limits.v_horizontal);
    }
    mission.vias.push_back(via);
  }
  for (tern::Via& via : mission.vias) {
    if (via.stop && rng.chance(0.4)) via.dwell = rng.spread(1e-3, tern::kMaxDwell);
  }
  mission.request.vias = mission.vias.data();
  mission.request.via_count = static_cast<std::int32_t>(mission.vias.size());
}

}  // namespace tern_attack
