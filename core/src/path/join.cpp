// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/join.hpp"

#include "base/direction.hpp"
#include "base/math.hpp"
#include "grid/distance.hpp"
#include "grid/lattice.hpp"

namespace tern {
namespace {

double square_distance(const Grid& grid, const Voxel& voxel, const Vec3& point) {
  const Vec3 d = free_point(grid, voxel) - point;
  return dot(d, d);
}

/// Inserts a candidate after all equally near ones, which come before it in the order of z, y, x.
void insert(Join& join, const Grid& grid, const Voxel& voxel, const Vec3& point) {
  const double far = square_distance(grid, voxel, point);
  std::int32_t at = join.count++;
  for (; at > 0 && far < square_distance(grid, join.candidates[at - 1], point); --at) {
    join.candidates[at] = join.candidates[at - 1];
  }
  join.candidates[at] = voxel;
}

/// True if the closed cube of this neighbour also contains the point, to within the lattice tolerance.
bool lies_beside(const Grid& grid, const Voxel& voxel, const Vec3& point) {
  for (int a = 0; a < 3; ++a) {
    const double beyond = axis(point, a) / grid.spec().cell - axis(voxel, a);
    if (beyond < -kLatticeTolerance || beyond > 1.0 + kLatticeTolerance) return false;
  }
  return true;
}

bool is_candidate(const Join& join, const Grid& grid, const Voxel& voxel, const Vec3& point, bool beside) {
  return grid.free(voxel) && !same(voxel, join.home) && (!beside || lies_beside(grid, voxel, point));
}

/// Collects the candidates. With `beside`, these are only voxels whose closed cubes also contain the point.
void collect(Join& join, const Grid& grid, const Vec3& point, bool beside) {
  const Voxel home = join.home;
  for (int dz = -kJoinReach; dz <= kJoinReach; ++dz) {
    for (int dy = -kJoinReach; dy <= kJoinReach; ++dy) {
      for (int dx = -kJoinReach; dx <= kJoinReach; ++dx) {
        const Voxel voxel{home.x + dx, home.y + dy, home.z + dz};
        if (is_candidate(join, grid, voxel, point, beside)) insert(join, grid, voxel, point);
      }
    }
  }
}

/// Index of a voxel in `searched`; -1 if the voxel is out of reach.
int cell_of(const Join& join, const Voxel& voxel) {
  const Voxel d{voxel.x - join.home.x + kJoinReach, voxel.y - join.home.y + kJoinReach,
                voxel.z - join.home.z + kJoinReach};
  const bool within = d.x >= 0 && d.y >= 0 && d.z >= 0 && d.x < kJoinWidth && d.y < kJoinWidth && d.z < kJoinWidth;
  return within ? d.x + kJoinWidth * (d.y + kJoinWidth * d.z) : -1;
}

/// Marks the free voxels within reach that are connected to `first` through faces. `first` is within reach.
void mark_searched(Join& join, const Grid& grid, const Voxel& first) {
  Voxel waiting[kJoinCells];
  int count = 0;
  waiting[count++] = first;
  join.searched[cell_of(join, first)] = true;
  while (count > 0) {
    const Voxel voxel = waiting[--count];
    for (int k = 0; k < 6; ++k) {
      Voxel next = voxel;
      axis(next, k / 2) += k % 2 == 0 ? 1 : -1;
      const int cell = cell_of(join, next);
      if (cell < 0 || join.searched[cell] || !grid.free(next)) continue;
      join.searched[cell] = true;
      waiting[count++] = next;
    }
  }
}

/// The voxel of the point. If that lies beyond a wall, it counts as its neighbour towards the wall on each axis on
/// which both contain the point: at a wall on the lattice, points belong to the voxels inside, as at a face of the
/// boundary.
Voxel home_of(const World& world, const Vec3& point) {
  const Grid& grid = world.voxels();
  Voxel home = grid.voxel_of(point);
  if (grid.free(home) || !world.solids_clear(point, point)) return home;
  for (int k = 0; k < world.wall_count(); ++k) {
    const Halfspace& wall = world.wall(k);
    if (least_over(cube_of(grid, home), wall.normal) < wall.offset - kLatticeTolerance * grid.spec().cell) continue;
    for (int a = 0; a < 3; ++a) {
      Voxel inner = home;
      axis(inner, a) += axis(wall.normal, a) > 0.0 ? -1 : (axis(wall.normal, a) < 0.0 ? 1 : 0);
      if (lies_beside(grid, inner, point)) home = inner;
    }
  }
  return home;
}

}  // namespace

void join_begin(Join& join, const World& world, const Vec3& point) noexcept {
  const Grid& grid = world.voxels();
  join.voxel = home_of(world, point);
  join.home = join.voxel;
  for (bool& searched : join.searched) searched = false;
  join.count = 0;
  join.next = 0;
  join.state = JoinState::kJoined;
  if (grid.free(join.voxel)) return;
  if (point_clear(grid, point, grid.spec().clearance())) collect(join, grid, point, false);
  join.state = join.count > 0 ? JoinState::kTrying : JoinState::kRefused;
}

bool join_others(Join& join, const Grid& grid, const Vec3& point, bool moves) noexcept {
  mark_searched(join, grid, join.voxel);
  if (join.count == 0) collect(join, grid, point, !moves && !(grid.spec().clearance() > 0.0));
  join.state = join.next < join.count ? JoinState::kTrying : JoinState::kRefused;
  return join.state == JoinState::kTrying;
}

void join_try(Join& join, const World& world, const Vec3& point, Work& work) noexcept {
  const Grid& grid = world.voxels();
  const Voxel candidate = join.candidates[join.next++];
  const Vec3 center = free_point(grid, candidate);
  const bool known = join.searched[cell_of(join, candidate)];
  const bool looks = !known && world.solids_clear(point, center);
  const double radius = grid.spec().clearance();
  work.spend(ops::kPiece + (looks ? clear_operations(grid.spec(), center - point, radius) : 0));
  if (looks && segment_clear(grid, point, center, radius)) {
    join.voxel = candidate;
    join.state = JoinState::kJoined;
  } else if (join.next == join.count) {
    join.state = JoinState::kRefused;
  }
}

}  // namespace tern
