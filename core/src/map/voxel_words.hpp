// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The words of a box of the window's voxels, one after the other.
#ifndef TERN_MAP_VOXEL_WORDS_HPP
#define TERN_MAP_VOXEL_WORDS_HPP

#include <cstdint>

#include "map/map_state.hpp"

namespace tern {

/// Calls visit(y, z, k, bits) for each word of the box, unless the box is empty along x.
template <typename Visit>
void visit_words(const VoxelBox& box, Visit visit) {
  if (box.x.begin >= box.x.end) return;
  for (std::int32_t z = box.z.begin; z < box.z.end; ++z) {
    for (std::int32_t y = box.y.begin; y < box.y.end; ++y) {
      for (std::int32_t k = box.x.begin >> 6; k <= (box.x.end - 1) >> 6; ++k) visit(y, z, k, bits_within(box.x, k));
    }
  }
}

inline VoxelBox all_voxels(const Voxel& dims) {
  return {{0, dims.x}, {0, dims.y}, {0, dims.z}};
}

}  // namespace tern

#endif
