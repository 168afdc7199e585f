// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/assumed_ball.hpp"

#include <algorithm>
#include <cmath>

#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

using tern::Box;
using tern::Vec3;

constexpr double kRounding = 1e-9;   // metres: voxels that only touch something hold nothing of it
constexpr double kShort = 1e-6;      // metres short of the first voxel that is not free
constexpr double kMostVoxels = 6.0;  // that the operator knows beyond the radius, if they are free
constexpr double kKeptVoxels = 2.0;  // and that a vehicle needs beyond it to leave the ball
constexpr double kStepVoxels = 2.0;  // from one ball to the next
constexpr int kDirections = 16;

bool overlap(const Box& a, const Box& b) {
  return a.lower.x < b.upper.x && b.lower.x < a.upper.x && a.lower.y < b.upper.y && b.lower.y < a.upper.y &&
         a.lower.z < b.upper.z && b.lower.z < a.upper.z;
}

bool overlap(const Box& box, const Cylinder& c) {
  const double x = std::clamp(c.x, box.lower.x, box.upper.x) - c.x;
  const double y = std::clamp(c.y, box.lower.y, box.upper.y) - c.y;
  return x * x + y * y < c.radius * c.radius && box.lower.z < c.top && c.bottom < box.upper.z;
}

bool is_inside(const Box& box, const Box& around) {
  return box.lower.x >= around.lower.x && box.lower.y >= around.lower.y && box.lower.z >= around.lower.z &&
         box.upper.x <= around.upper.x && box.upper.y <= around.upper.y && box.upper.z <= around.upper.z;
}

bool is_free(const FlightWorld& world, const Box& voxel) {
  const auto meets = [&voxel](const auto& solid) { return overlap(voxel, solid); };
  return is_inside(voxel, world.boundary) && std::none_of(world.blocks.begin(), world.blocks.end(), meets) &&
         std::none_of(world.cylinders.begin(), world.cylinders.end(), meets);
}

/// From the ball's centre to the voxel's furthest corner.
double reach(const Vec3& center, const Box& voxel) {
  const auto far = [](double at, double low, double high) { return std::max(at - low, high - at); };
  return std::hypot(far(center.x, voxel.lower.x, voxel.upper.x), far(center.y, voxel.lower.y, voxel.upper.y),
                    far(center.z, voxel.lower.z, voxel.upper.z));
}

}  // namespace

double assumed_radius(const FlightWorld& world, const tern::GridSpec& grid, double most) {
  const double cell = grid.cell;
  const auto index = [cell](double at, double origin) { return std::floor((at - origin) / cell); };
  const Vec3& s = world.start;
  const Vec3 first{index(s.x - most, grid.origin.x), index(s.y - most, grid.origin.y),
                   index(s.z - most, grid.origin.z)};
  const int count = static_cast<int>(std::ceil(2.0 * most / cell)) + 1;
  double nearest = most + cell;  // reach of the nearest voxel that is not free
  for (int k = 0; k < count * count * count; ++k) {
    const Vec3 at{first.x + k % count, first.y + k / count % count, first.z + k / (count * count)};
    const Vec3 low{grid.origin.x + cell * at.x, grid.origin.y + cell * at.y, grid.origin.z + cell * at.z};
    const double reached = reach(s, {low, {low.x + cell, low.y + cell, low.z + cell}});
    const double size = cell - 2.0 * kRounding;
    const Vec3 in{low.x + kRounding, low.y + kRounding, low.z + kRounding};
    if (reached < nearest && !is_free(world, {in, {in.x + size, in.y + size, in.z + size}})) nearest = reached;
  }
  return std::min(most, nearest - kShort);
}

std::vector<AssumedBall> assumed_balls(const FlightWorld& world, const tern::GridSpec& grid) {
  const double most = grid.clearance() + kMostVoxels * grid.cell;
  const double seen_from = (grid.clearance() + kKeptVoxels * grid.cell) / std::sin(0.5 * world.settings.fov_vertical);
  const double enough = std::min(most, seen_from);
  std::vector<AssumedBall> balls{{world.start, assumed_radius(world, grid, most)}};
  if (balls.front().radius >= enough) return balls;
  FlightWorld carried = world;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = kTurn * k / kDirections;
    for (double way = kStepVoxels * grid.cell; way <= enough; way += kStepVoxels * grid.cell) {
      carried.start = {world.start.x + way * std::cos(angle), world.start.y + way * std::sin(angle), world.start.z};
      if (clearance(world, carried.start) < grid.clearance()) break;
      balls.push_back({carried.start, assumed_radius(carried, grid, most)});
    }
  }
  return balls;
}

}  // namespace tern_host
