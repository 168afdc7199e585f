// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/carve.hpp"

namespace tern {
namespace {

/// A cube of 8, 4, 2 or 1 voxels in a block; (x, y, z) is its lowest voxel within the block.
struct Cube {
  std::int32_t x, y, z;
};

template <std::int32_t kSize>
std::uint64_t bits_of(const Cube& cube) {
  return ((std::uint64_t{1} << kSize) - 1) << cube.x;
}

template <std::int32_t kSize>
bool any(const BlockWords& words, const Cube& cube) {
  std::uint64_t sum = 0;
  for (std::int32_t z = 0; z < kSize; ++z) {
    for (std::int32_t y = 0; y < kSize; ++y) sum |= words.words[cube.z + z][cube.y + y];
  }
  return (sum & bits_of<kSize>(cube)) != 0;
}

template <std::int32_t kSize>
void add(BlockWords& words, const Cube& cube) {
  for (std::int32_t z = 0; z < kSize; ++z) {
    for (std::int32_t y = 0; y < kSize; ++y) words.words[cube.z + z][cube.y + y] |= bits_of<kSize>(cube);
  }
}

/// Decides a cube, or divides it in eight.
template <std::int32_t kSize>
void carve_cube(const View& view, const Voxel& first, const BlockWords& wanted, BlockWords& free, const Cube& cube) {
  if (!any<kSize>(wanted, cube)) return;
  const Sight sight = view.look({first.x + cube.x, first.y + cube.y, first.z + cube.z}, kSize);
  if (sight == Sight::kAll) return add<kSize>(free, cube);
  if constexpr (kSize > 1) {
    if (sight == Sight::kNone) return;
    constexpr std::int32_t kHalf = kSize / 2;
    for (std::int32_t part = 0; part < 8; ++part) {
      const Cube child{cube.x + (part & 1) * kHalf, cube.y + (part >> 1 & 1) * kHalf, cube.z + (part >> 2) * kHalf};
      carve_cube<kHalf>(view, first, wanted, free, child);
    }
  }
}

}  // namespace

void carve(const View& view, const Voxel& first, const BlockWords& wanted, BlockWords& free) noexcept {
  for (std::int32_t x = 0; x < 64; x += kBlock) carve_cube<kBlock>(view, first, wanted, free, {x, 0, 0});
}

}  // namespace tern
