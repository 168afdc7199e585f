// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/path.md: a plan along the first way that the search finds, and one along another way that looks faster.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <vector>

#include "tern/tern.hpp"

static tern::Vec3 towards(const tern::Vec3& a, const tern::Vec3& b, double part) {
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), a.z + part * (b.z - a.z)};
}

static double dot(const tern::Vec3& a, const tern::Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Seconds along the path: cruising at the speed limits, and for each turn a part of the time that a stop takes.
static double estimate(const tern::Path& path, const tern::Limits& limits) {
  double time = 0.0;
  tern::Vec3 before{};
  for (int i = 0; i + 1 < path.count; ++i) {
    const tern::Vec3& a = path.points[i];
    const tern::Vec3& b = path.points[i + 1];
    const tern::Vec3 leg{b.x - a.x, b.y - a.y, b.z - a.z};
    const double length = std::sqrt(dot(leg, leg));
    if (!(length > 0.0)) continue;
    time += std::max(
        {std::fabs(leg.x) / limits.v_max.x, std::fabs(leg.y) / limits.v_max.y, std::fabs(leg.z) / limits.v_max.z});
    const tern::Vec3 along{leg.x / length, leg.y / length, leg.z / length};
    if (i > 0) time += 0.5 * (1.0 - dot(before, along)) * limits.v_max.x / limits.a_max.x;
    before = along;
  }
  return time;
}

/// The point at this part of the path's length, grid frame.
static tern::Vec3 point_at(const tern::Path& path, double part) {
  double left = part * path.length;
  for (int i = 0; i + 1 < path.count; ++i) {
    const tern::Vec3& a = path.points[i];
    const tern::Vec3& b = path.points[i + 1];
    const tern::Vec3 leg{b.x - a.x, b.y - a.y, b.z - a.z};
    const double length = std::sqrt(dot(leg, leg));
    if (left < length) return towards(a, b, left / length);
    left -= length;
  }
  return path.points[path.count - 1];
}

static tern::Status plan_best_way(const tern::Grid& grid, const tern::Request& request, tern::Planner& planner,
                                  tern::Trajectory& plan, tern::Report& report) {
  const tern::Status status = planner.plan(grid, request, plan, report);
  if (status != tern::Status::kOk || planner.path() == nullptr) return status;
  const tern::Path first = *planner.path();  // each plan and route has the next path in the same place
  const tern::GridSpec& spec = grid.spec();
  constexpr int kColumns = 5;
  constexpr double kHalf = 0.3;  // half the edge of a column, metres
  tern::Halfspace columns[kColumns][tern::kBoxPlanes];
  tern::Fence best{};
  double least = 1e9;
  for (int k = 0; k < kColumns; ++k) {
    tern::Vec3 at = point_at(first, (k + 1.0) / (kColumns + 1.0));
    at = {at.x + spec.origin.x, at.y + spec.origin.y, at.z + spec.origin.z};
    tern::box_planes(
        {{at.x - kHalf, at.y - kHalf, spec.boundary.lower.z}, {at.x + kHalf, at.y + kHalf, spec.boundary.upper.z}},
        columns[k]);
    const tern::Fence column{columns[k], tern::kBoxPlanes, tern::FenceKind::kKeepOut};
    tern::Request around = request;  // a request with fences of its own keeps them beside this one
    around.fences = &column;
    around.fence_count = 1;
    tern::Report on_way;
    if (planner.route(grid, around, on_way) != tern::Status::kOk) continue;
    const double time = estimate(*planner.path(), request.limits);
    if (time < least) best = column;
    least = std::min(least, time);
  }
  tern::Request around = request;
  around.fences = &best;
  around.fence_count = 1;
  tern::Trajectory other{};
  tern::Report of_other{};
  if (best.count == 0 || planner.plan(grid, around, other, of_other) != tern::Status::kOk) return status;
  if (tern::duration(other) >= tern::duration(plan)) return status;
  plan = other;
  report = of_other;
  return status;
}

int main() {
  tern::GridSpec spec{};
  spec.cell = 0.1;
  spec.dims = {140, 100, 30};
  spec.boundary = {{0.0, 0.0, 0.0}, {14.0, 10.0, 3.0}};
  spec.radius = 0.3;
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  tern::Grid grid;
  if (grid.bind(spec, words.data(), words.size()) != tern::Status::kOk) return 1;
  for (int k = 0; k < 5; ++k) {  // five walls across the way, by turns more to one side and to the other
    const double x = 3.0 + 1.6 * k;
    const double y = k % 2 == 0 ? 4.4 : 5.6;
    grid.mark_box({{x, y - 1.5, 0.0}, {x + 0.3, y + 1.5, 3.0}});
  }
  grid.inflate();
  auto memory = std::make_unique<tern::Workspace>();
  tern::Planner planner(memory.get(), sizeof *memory);
  tern::Request request;
  request.start.position = {1.0, 5.0, 1.5};
  request.goal.position = {13.0, 5.0, 1.5};
  request.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  tern::Trajectory first{};
  tern::Report report{};
  if (planner.plan(grid, request, first, report) != tern::Status::kOk) return 1;
  tern::Trajectory plan{};
  if (plan_best_way(grid, request, planner, plan, report) != tern::Status::kOk) return 1;
  std::printf("%.2f s, and %.2f s along the first way\n", tern::duration(plan), tern::duration(first));
  return tern::duration(plan) < tern::duration(first) ? 0 : 1;
}
