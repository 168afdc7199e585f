// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which requests have an answer, by the reference alone.
#include "attack/asking.hpp"
#include "attack/solid.hpp"

namespace tern_attack {
namespace {

bool in_boundary(const World& world, const tern::Vec3& p) {
  for (int a = 0; a < 3; ++a) {
    if (axis(p, a) < axis(world.spec.boundary.lower, a) || axis(p, a) > axis(world.spec.boundary.upper, a))
      return false;
  }
  return true;
}

/// Room ahead of a start that its first polyhedron has at least in an empty world, metres: a leg longer than 8 m is cut
/// (docs/corridor.md).
constexpr Real kFirstPolyhedron = 2.0L;

/// How far a voxel's cube reaches to both sides of its centre along a unit normal.
Real half_width(const World& world, const Point& n) {
  return 0.5L * world.spec.cell * (std::fabs(n[0]) + std::fabs(n[1]) + std::fabs(n[2]));
}

/// True where the fence leaves a ball's or a cube's centre alone beyond doubt: all within each half-space of a keep-in,
/// or all beyond one half-space of a keep-out by the radius.
bool leaves(const World& world, const tern::Fence& fence, const std::vector<Plane>& planes, const Point& center,
            bool cube, Real doubt) {
  const bool in = fence.kind == tern::FenceKind::kKeepIn;
  for (const Plane& plane : planes) {
    const Real width = cube ? half_width(world, plane.normal) : 0;
    const Real height = dot(plane.normal, center) - plane.offset;
    if (in && height + width > -doubt) return false;
    if (!in && height - width >= world.radius() + doubt) return true;
  }
  return in;
}

/// Components of voxels that are free of the fences, too.
std::vector<int> fenced_components(const World& world, const Map& map, const Ask& ask) {
  std::vector<std::uint8_t> free(map.layer.size(), 0);
  for (const int i : map.free) free[static_cast<std::size_t>(i)] = 1;
  const Real cell = world.spec.cell;
  for (const tern::Fence& fence : ask.fences) {
    const std::vector<Plane> planes = planes_of(world, fence);
    for (const int i : map.free) {
      const tern::Voxel v = world.voxel(i);
      const Point center{{(v.x + 0.5L) * cell, (v.y + 0.5L) * cell, (v.z + 0.5L) * cell}};
      if (!leaves(world, fence, planes, center, true, 1e-8L)) free[static_cast<std::size_t>(i)] = 0;
    }
  }
  return components(world, free);
}

/// With fences only points in free voxels count: whether others can join the grid depends on more than faces.
int own_component(const World& world, const std::vector<int>& component, const Point& p) {
  int common = -2;
  for (const tern::Voxel& v : homes(world, p)) {
    const int number = component[static_cast<std::size_t>(world.index(v.x, v.y, v.z))];
    if (common != -2 && number != common) return -1;
    common = number;
  }
  return common;
}

}  // namespace

Map map_of(const World& world) {
  Map map;
  map.layer = blocked_layer(world);
  std::vector<std::uint8_t> free(map.layer.size(), 0);
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (map.layer[i] != Space::kFree) continue;
    free[i] = 1;
    map.free.push_back(static_cast<int>(i));
  }
  map.component = components(world, free);
  return map;
}

namespace {

bool connects(const World& world, const Map& map, const Ask& ask, const tern::Vec3& from, const tern::Vec3& to) {
  if (!in_boundary(world, from) || !in_boundary(world, to)) return false;
  const Point start = world.local(from);
  const Point goal = world.local(to);
  if (ask.fences.empty()) {
    return share_one(reachable(world, map.component, start), reachable(world, map.component, goal));
  }
  const std::vector<int> component = fenced_components(world, map, ask);
  const int number = own_component(world, component, start);
  return number >= 0 && number == own_component(world, component, goal);
}

}  // namespace

bool must_connect(const World& world, const Map& map, const Ask& ask) {
  const tern::Vec3* from = &ask.request.start.position;
  for (const tern::Via& via : ask.vias) {
    if (!connects(world, map, ask, *from, via.position)) return false;
    from = &via.position;
  }
  return connects(world, map, ask, *from, ask.request.goal.position);
}

bool has_room_to_stop(const World& world, const Ask& ask) {
  const tern::State& start = ask.request.start;
  const tern::Limits& l = ask.request.limits;
  const Point v = point(start.velocity);
  const Real speed = length(v);
  if (!world.empty() || !ask.fences.empty() || !ask.vias.empty() || largest(point(start.acceleration)) > 0)
    return false;
  if (l.thrust_max > 0.0 || l.thrust_min > 0.0 || l.tilt_tangent > 0.0 || l.rate_max > 0.0) return false;
  if (largest(point(l.j_max)) > 0 || l.j_horizontal > 0.0 || largest(point(start.jerk)) > 0) return false;
  if (largest(point(ask.request.goal.velocity)) > 0 || largest(point(ask.request.goal.acceleration)) > 0) return false;
  if (speed <= 0) return true;
  // Braking is an acceleration against the velocity: by how much the limits allow it along its direction.
  Real most = 1e30L;
  for (int a = 0; a < 3; ++a) {
    const Real part = -v[a] / speed;
    const Real down = axis(l.a_min, a) < 0.0 ? -axis(l.a_min, a) : axis(l.a_max, a);
    if (part != 0) most = std::min(most, (part > 0 ? static_cast<Real>(axis(l.a_max, a)) : down) / std::fabs(part));
  }
  const Real flat = std::sqrt(v[0] * v[0] + v[1] * v[1]) / speed;
  if (l.a_horizontal > 0.0 && flat > 0) most = std::min(most, l.a_horizontal / flat);
  const Real way = 2 * (speed * speed / (2 * most) + 0.05L * speed);
  if (way > kFirstPolyhedron) return false;
  const tern::Vec3 end = world.world(world.local(start.position) + (way / speed) * v);
  return in_boundary(world, start.position) && in_boundary(world, end);
}

}  // namespace tern_attack
