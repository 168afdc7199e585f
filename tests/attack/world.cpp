// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attack/world.hpp"

#include <cstring>

namespace tern_attack {
namespace {

constexpr const char* kNames[kFamilies] = {"noise",  "boxes",   "slots", "maze",   "corners",
                                           "stairs", "tunnels", "far",   "fences", "changes"};

/// The run of voxels [begin, end) of one row as a box in the world frame, with the rounding of its coordinates.
tern::Box run_box(const World& world, int begin, int end, int y, int z) {
  const double cell = world.spec.cell;
  const tern::Vec3& o = world.spec.origin;
  return {{o.x + begin * cell, o.y + y * cell, o.z + z * cell},
          {o.x + end * cell, o.y + (y + 1) * cell, o.z + (z + 1) * cell}};
}

void set_run(bool boxes, const World& world, int begin, int end, int y, int z, bool value, tern::Grid& grid) {
  if (boxes) {
    const tern::Box box = run_box(world, begin, end, y, z);
    (void)(value ? grid.mark_box(box) : grid.clear_box(box));
    return;
  }
  for (int x = begin; x < end; ++x) (void)(value ? grid.mark_voxel({x, y, z}) : grid.clear_voxel({x, y, z}));
}

}  // namespace

const char* family_name(Family family) {
  return kNames[static_cast<int>(family)];
}

int family_by_name(const char* name) {
  for (int f = 0; f < kFamilies; ++f) {
    if (std::strcmp(name, kNames[f]) == 0) return f;
  }
  return -1;
}

bool World::empty() const {
  return std::find(solid.begin(), solid.end(), 1) == solid.end();
}

tern::Vec3 World::world(const Point& p) const {
  const Point w = p + point(spec.origin);
  return {static_cast<double>(w[0]), static_cast<double>(w[1]), static_cast<double>(w[2])};
}

std::vector<SolidRun> runs_of(const World& world) {
  std::vector<SolidRun> runs;
  const tern::Voxel dims = world.spec.dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        const int begin = x;
        while (world.is_solid(x, y, z)) ++x;
        if (x > begin) runs.push_back({begin, x, y, z});
      }
    }
  }
  return runs;
}

void keep_only(const std::vector<SolidRun>& runs, World& world) {
  std::vector<std::uint8_t> before(world.solid.size(), 0);
  before.swap(world.solid);
  for (const SolidRun& run : runs) {
    for (int x = run.begin; x < run.end; ++x) world.set(x, run.y, run.z, true);
  }
  for (std::size_t i = 0; i < before.size(); ++i) world.solid[i] &= before[i];
}

void mark_difference(Rng& rng, const World& world, const std::vector<std::uint8_t>& before, tern::Grid& grid) {
  const bool boxes = rng.chance(0.5);
  const tern::Voxel dims = world.spec.dims;
  const auto changed = [&](int x, int y, int z, int value) {
    const auto i = static_cast<std::size_t>(world.index(x, y, z));
    return world.solid[i] != before[i] && world.solid[i] == value;
  };
  for (int value = 0; value < 2; ++value) {
    for (int z = 0; z < dims.z; ++z) {
      for (int y = 0; y < dims.y; ++y) {
        for (int x = 0; x < dims.x; ++x) {
          const int begin = x;
          while (x < dims.x && changed(x, y, z, value)) ++x;
          if (x > begin) set_run(boxes, world, begin, x, y, z, value != 0, grid);
        }
      }
    }
  }
}

tern::Status bind_and_mark(Rng& rng, World& world) {
  world.words.assign(tern::grid_words(world.spec.dims), rng.chance(0.5) ? 0 : rng.next());
  const tern::Status bound = world.grid.bind(world.spec, world.words.data(), world.words.size());
  if (bound != tern::Status::kOk) return bound;
  mark_difference(rng, world, std::vector<std::uint8_t>(world.solid.size(), 0), world.grid);
  world.grid.inflate();
  return bound;
}

}  // namespace tern_attack
