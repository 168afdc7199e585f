// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A grid, with the harness's own record of what was marked in it.
#ifndef TERN_TESTS_ATTACK_WORLD_HPP
#define TERN_TESTS_ATTACK_WORLD_HPP

#include <cstdint>
#include <vector>

#include "attack/exact.hpp"
#include "attack/rng.hpp"

namespace tern_attack {

enum class Family : int { kNoise, kBoxes, kSlots, kMaze, kCorners, kStairs, kTunnels, kFar, kFences, kChanges };
constexpr int kFamilies = 10;
const char* family_name(Family family);
/// -1 for a name that is none.
int family_by_name(const char* name);

struct World {
  tern::GridSpec spec{};
  std::vector<std::uint8_t> solid;  ///< 1 where an obstacle stands; x fastest
  std::vector<std::uint64_t> words;
  tern::Grid grid;

  World() = default;
  World(const World&) = delete;  // a grid points into the words
  World& operator=(const World&) = delete;

  bool inside(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < spec.dims.x && y < spec.dims.y && z < spec.dims.z;
  }
  int index(int x, int y, int z) const { return (z * spec.dims.y + y) * spec.dims.x + x; }
  int count() const { return spec.dims.x * spec.dims.y * spec.dims.z; }
  tern::Voxel voxel(int i) const {
    return {i % spec.dims.x, i / spec.dims.x % spec.dims.y, i / spec.dims.x / spec.dims.y};
  }
  void set(int x, int y, int z, bool value) {
    if (inside(x, y, z)) solid[static_cast<std::size_t>(index(x, y, z))] = value ? 1 : 0;
  }
  bool is_solid(int x, int y, int z) const {
    return inside(x, y, z) && solid[static_cast<std::size_t>(index(x, y, z))] != 0;
  }
  bool empty() const;
  /// The clearance that the grid promises: a nanometre or less counts as 0.
  Real radius() const { return spec.radius <= 1e-9 ? 0.0L : static_cast<Real>(spec.radius); }
  /// Of a world point: exact but for the rounding of long double.
  Point local(const tern::Vec3& world) const { return point(world) - point(spec.origin); }
  tern::Vec3 world(const Point& local) const;
};

/// Obstacles from begin to end, excluded, in one row of voxels.
struct SolidRun {
  int begin, end, y, z;
};
std::vector<SolidRun> runs_of(const World& world);
void keep_only(const std::vector<SolidRun>& runs, World& world);

/// Lays out the grid (offset, cell, dimensions, boundary, radius) and its obstacles; nothing is bound yet.
void make_world(Rng& rng, Family family, World& world);

/// Fills the record of obstacles of a world that is laid out. `half` is the clearance in voxels that ways through the
/// family's walls are made for.
void fill(Rng& rng, Family family, int half, World& world);
/// Boxes at random, for worlds that change.
void add_box(Rng& rng, World& world, bool value);

/// Binds the grid to storage of its own, marks the record (voxel by voxel or run by run as boxes) and inflates.
tern::Status bind_and_mark(Rng& rng, World& world);
/// Marks or clears in `grid` what the record says and `before` did not.
void mark_difference(Rng& rng, const World& world, const std::vector<std::uint8_t>& before, tern::Grid& grid);

}  // namespace tern_attack

#endif
