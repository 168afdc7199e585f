// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_map.hpp"

#include <algorithm>
#include <cmath>

#include "tern/config.hpp"

namespace tern_host {
namespace {

/// Voxels beside the world's boundary, so that its faces are seen as walls.
constexpr int kBeside = 2;
/// So far the window reaches beyond the world, in voxels, besides the horizon.
constexpr int kSlideRoom = 40;

int even_voxels(double metres, double cell) {
  return 2 * static_cast<int>(std::ceil(0.5 * metres / cell));
}

/// What a vehicle's map holds: the world, or what is around its task.
tern::Box box_of(const SwarmWorld& world, const SwarmTask& task) {
  tern::Box box = world.boundary;
  if (world.around <= 0.0) return box;
  tern::Vec3 lower = task.start;
  tern::Vec3 upper = task.start;
  for (const tern::Via& via : task.mission) {
    const tern::Vec3& p = via.position;
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), 0.0};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), 0.0};
  }
  box.lower.x = std::max(box.lower.x, lower.x - world.around);
  box.lower.y = std::max(box.lower.y, lower.y - world.around);
  box.upper.x = std::min(box.upper.x, upper.x + world.around);
  box.upper.y = std::min(box.upper.y, upper.y + world.around);
  return box;
}

}  // namespace

tern::MapSpec map_spec_of(const SwarmWorld& world, const SwarmTask& task, const SwarmSettings& settings) {
  const tern::Box b = box_of(world, task);
  const double beyond = world.horizon + 2.0 + kSlideRoom * world.cell;
  const tern::Voxel dims{std::min(tern::kMaxDimension, even_voxels(b.upper.x - b.lower.x + 2.0 * beyond, world.cell)),
                         std::min(tern::kMaxDimension, even_voxels(b.upper.y - b.lower.y + 2.0 * beyond, world.cell)),
                         even_voxels(b.upper.z - b.lower.z + 2.0 * kBeside * world.cell, world.cell)};
  const tern::Vec3 middle{0.5 * (b.lower.x + b.upper.x), 0.5 * (b.lower.y + b.upper.y), 0.5 * (b.lower.z + b.upper.z)};
  const tern::Vec3 origin{middle.x - 0.5 * world.cell * dims.x, middle.y - 0.5 * world.cell * dims.y,
                          middle.z - 0.5 * world.cell * dims.z};
  tern::MapSpec spec = tern::map_spec(origin, world.cell, dims, world.body_radius);
  spec.tracking_margin = settings.tracking_margin;
  spec.slack = tern::kMaxDimension;  // the window holds all that matters: what slides out of it would be forgotten
  return spec;
}

std::vector<tern::Box> walls_of(const SwarmWorld& world) {
  constexpr double kFar = 1000.0;
  const tern::Box& b = world.boundary;
  return {{{-kFar, -kFar, -kFar}, {b.lower.x, kFar, kFar}}, {{b.upper.x, -kFar, -kFar}, {kFar, kFar, kFar}},
          {{-kFar, -kFar, -kFar}, {kFar, b.lower.y, kFar}}, {{-kFar, b.upper.y, -kFar}, {kFar, kFar, kFar}},
          {{-kFar, -kFar, -kFar}, {kFar, kFar, b.lower.z}}, {{-kFar, -kFar, b.upper.z}, {kFar, kFar, kFar}}};
}

}  // namespace tern_host
