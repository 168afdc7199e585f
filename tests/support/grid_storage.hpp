// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_GRID_STORAGE_HPP
#define TERN_TESTS_SUPPORT_GRID_STORAGE_HPP

#include <cstdint>
#include <vector>

#include "tern/grid.hpp"

namespace tern_test {

/// A grid with storage of its own, filled with noise before it is bound: a grid that relies on cleared memory fails.
struct OwnedGrid {
  explicit OwnedGrid(const tern::GridSpec& spec)
      : words(tern::grid_words(spec.dims), 0xA5A5A5A5A5A5A5A5u), status(grid.bind(spec, words.data(), words.size())) {}

  tern::Grid grid;
  std::vector<std::uint64_t> words;
  tern::Status status;
};

/// The words behind the header: both layers, what changed, and the regions' numbers.
inline std::vector<std::uint64_t> words_of(const OwnedGrid& owned) {
  return {owned.grid.obstacle_row(0, 0), owned.words.data() + owned.words.size()};
}

/// A spec whose boundary is the whole grid.
inline tern::GridSpec whole_grid(tern::Voxel dims, double cell, double radius, tern::Vec3 origin = {0.0, 0.0, 0.0}) {
  return {origin, cell, dims, {origin, {origin.x + dims.x * cell, origin.y + dims.y * cell, origin.z + dims.z * cell}},
          radius, 0.0};
}

template <typename Visit>
void for_each_voxel(const tern::Voxel& dims, Visit visit) {
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) visit(tern::Voxel{x, y, z});
    }
  }
}

/// Gives a grid of the same size the obstacles of another, and inflates it.
inline void copy_obstacles(const tern::Grid& from, tern::Grid& to) {
  const tern::Voxel dims = from.spec().dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        if (from.obstacle({x, y, z})) to.mark_voxel({x, y, z});
      }
    }
  }
  to.inflate();
}

inline int count_obstacles(const tern::Grid& grid) {
  int count = 0;
  const tern::Voxel dims = grid.spec().dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) count += grid.obstacle({x, y, z}) ? 1 : 0;
    }
  }
  return count;
}

inline int count_free(const tern::Grid& grid) {
  int count = 0;
  const tern::Voxel dims = grid.spec().dims;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) count += grid.free({x, y, z}) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace tern_test

#endif
