// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_WALLED_WORLD_HPP
#define TERN_TESTS_SUPPORT_WALLED_WORLD_HPP

#include "support/path_world.hpp"

namespace tern_test {

/// Worlds of some hundred blocks: storeys and rooms with thin walls, each with a hole or none.
inline VoxelWorld walled_world(Random& random) {
  const tern::Voxel dims{random.integer(20, 90), random.integer(20, 40), random.integer(8, 20)};
  VoxelWorld world(dims);
  const int walls = random.integer(2, 14);
  for (int k = 0; k < walls; ++k) {
    const int axis = random.integer(0, 2);
    tern::Voxel low{0, 0, 0};
    tern::Voxel high{dims.x - 1, dims.y - 1, dims.z - 1};
    int& lower = axis == 0 ? low.x : (axis == 1 ? low.y : low.z);
    int& upper = axis == 0 ? high.x : (axis == 1 ? high.y : high.z);
    lower = upper = random.integer(1, upper);
    for (int z = low.z; z <= high.z; ++z) {
      for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) world.grid.mark_voxel({x, y, z});
      }
    }
    for (int hole = random.integer(0, 4); hole > 0; --hole) {
      world.grid.clear_voxel(
          {random.integer(low.x, high.x), random.integer(low.y, high.y), random.integer(low.z, high.z)});
    }
  }
  world.grid.inflate();
  return world;
}

}  // namespace tern_test

#endif
