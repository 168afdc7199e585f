// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/corridor_widths.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "host/figures.hpp"
#include "paper/statistics.hpp"

namespace tern_bench {
namespace {

using tern::Vec3;

constexpr int kPlaces = 9;
constexpr int kDirections = 8;
constexpr double kReach = 2.0;
constexpr double kStep = 5e-3;

Vec3 along(const Vec3& p, const Vec3& d, double t) {
  return {p.x + t * d.x, p.y + t * d.y, p.z + t * d.z};
}
double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vec3 unit(const Vec3& v) {
  return along({0.0, 0.0, 0.0}, v, 1.0 / std::sqrt(dot(v, v)));
}

bool free_at(const Vec3& p, const tern_host::Scenario& scenario) {
  const tern::Box& box = scenario.boundary;
  const bool in = p.x >= box.lower.x && p.y >= box.lower.y && p.z >= box.lower.z && p.x <= box.upper.x &&
                  p.y <= box.upper.y && p.z <= box.upper.z;
  return in && tern_host::distance_to_blocks(p, scenario) >= scenario.radius;
}

/// Metres that the centre may go; kReach where nothing ends it.
double passage(const Vec3& p, const Vec3& d, const tern_host::Scenario& scenario) {
  for (double t = 0.0; t < kReach; t += kStep) {
    if (!free_at(along(p, d, t), scenario)) return t;
  }
  return kReach;
}

double corridor(const tern::Polyhedron& polyhedron, const Vec3& local, const Vec3& d) {
  double exit = kReach;
  for (int i = 0; i < polyhedron.count; ++i) {
    const tern::Halfspace& plane = polyhedron.planes[i];
    const double rate = dot(plane.normal, d);
    if (rate > 0.0) exit = std::min(exit, (plane.offset - dot(plane.normal, local)) / rate);
  }
  return exit;
}

struct Segment {
  double widest = 0.0;
  double narrowest = std::numeric_limits<double>::infinity();
};

void look_across(const tern_host::PlanResult& plan, const tern::Polyhedron& polyhedron, const Vec3& local,
                 const Vec3& d, Segment& segment, std::vector<double>& ratios, double& over) {
  const Vec3& origin = plan.grid.origin;
  const Vec3 world{local.x + origin.x, local.y + origin.y, local.z + origin.z};
  const Vec3 back{-d.x, -d.y, -d.z};
  const double ends[2] = {passage(world, d, plan.scenario), passage(world, back, plan.scenario)};
  const double free = ends[0] + ends[1];
  if (free >= 2.0 * kReach || free <= 0.0) return;
  const double outs[2] = {corridor(polyhedron, local, d), corridor(polyhedron, local, back)};
  for (int k = 0; k < 2; ++k) over = std::max(over, outs[k] - ends[k] - kStep);
  const double wide = std::min(outs[0], kReach) + std::min(outs[1], kReach);
  ratios.push_back(wide / free);
  segment.widest = std::max(segment.widest, wide);
  segment.narrowest = std::min(segment.narrowest, free);
}

}  // namespace

CorridorWidths measure_widths(const tern_host::PlanResult& plan) {
  CorridorWidths widths;
  widths.passage = std::numeric_limits<double>::infinity();
  std::vector<double> ratios;
  std::vector<double> extremes;
  for (int i = 0; i < plan.corridor->count; ++i) {
    const tern::Polyhedron& polyhedron = plan.corridor->polyhedra[i];
    const Vec3 way{polyhedron.to.x - polyhedron.from.x, polyhedron.to.y - polyhedron.from.y,
                   polyhedron.to.z - polyhedron.from.z};
    if (dot(way, way) <= 0.0) continue;
    const Vec3 forward = unit(way);
    const bool upright = std::fabs(forward.z) > 0.9;
    const Vec3 side = unit(cross(forward, upright ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 0.0, 1.0}));
    const Vec3 up = cross(forward, side);
    Segment segment;
    for (int place = 0; place < kPlaces; ++place) {
      const Vec3 at = along(polyhedron.from, way, (place + 0.5) / kPlaces);
      for (int k = 0; k < kDirections; ++k) {
        const double angle = 3.14159265358979324 * k / kDirections;
        const Vec3 d = along(along({0.0, 0.0, 0.0}, side, std::cos(angle)), up, std::sin(angle));
        look_across(plan, polyhedron, at, d, segment, ratios, widths.over);
      }
    }
    if (segment.widest > 0.0) extremes.push_back(segment.widest / segment.narrowest);
    widths.passage = std::min(widths.passage, segment.narrowest);
  }
  widths.used = mean(ratios);
  widths.extreme = mean(extremes);
  return widths;
}

}  // namespace tern_bench
