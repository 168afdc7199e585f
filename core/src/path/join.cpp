// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/join.hpp"

#include "base/math.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

double square_distance(const Grid& grid, const Voxel& voxel, const Vec3& point) {
  const Vec3 d = grid.center(voxel) - point;
  return dot(d, d);
}

/// Inserts a candidate behind all that are as near: they came before it in the order of z, y, x.
void insert(Join& join, const Grid& grid, const Voxel& voxel, const Vec3& point) {
  const double far = square_distance(grid, voxel, point);
  std::int32_t at = join.count++;
  for (; at > 0 && far < square_distance(grid, join.candidates[at - 1], point); --at) {
    join.candidates[at] = join.candidates[at - 1];
  }
  join.candidates[at] = voxel;
}

void collect(Join& join, const Grid& grid, const Vec3& point) {
  const Voxel home = join.voxel;
  for (int dz = -kJoinReach; dz <= kJoinReach; ++dz) {
    for (int dy = -kJoinReach; dy <= kJoinReach; ++dy) {
      for (int dx = -kJoinReach; dx <= kJoinReach; ++dx) {
        const Voxel voxel{home.x + dx, home.y + dy, home.z + dz};
        if (grid.free(voxel)) insert(join, grid, voxel, point);
      }
    }
  }
}

}  // namespace

void join_begin(Join& join, const Grid& grid, const Vec3& point) noexcept {
  join.voxel = grid.voxel_of(point);
  join.count = 0;
  join.next = 0;
  join.state = JoinState::kJoined;
  if (grid.free(join.voxel)) return;
  if (point_clear(grid, point, grid.spec().radius)) collect(join, grid, point);
  join.state = join.count > 0 ? JoinState::kTrying : JoinState::kRefused;
}

void join_try(Join& join, const Grid& grid, const Fences* fences, const Vec3& point) noexcept {
  const Voxel candidate = join.candidates[join.next++];
  const Vec3 center = grid.center(candidate);
  const double radius = grid.spec().radius;
  const bool allowed = fences == nullptr || fences_clear(*fences, point, center, radius);
  if (allowed && segment_clear(grid, point, center, radius)) {
    join.voxel = candidate;
    join.state = JoinState::kJoined;
  } else if (join.next == join.count) {
    join.state = JoinState::kRefused;
  }
}

}  // namespace tern
