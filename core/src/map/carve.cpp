// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "map/carve.hpp"

#include "base/math.hpp"
#include "map/projector.hpp"

namespace tern {
namespace {

/// What a view sees of a cube of voxels.
enum class Sight : std::uint8_t {
  kNone,  ///< no voxel of it is seen whole
  kPart,  ///< unknown: some voxels may be seen whole
  kAll,   ///< every pixel that covers the cube measured a depth behind it
};

/// A cube of voxels in a block; (x, y, z) is its lowest voxel within the block.
struct Cube {
  std::int32_t x, y, z;
};

template <std::int32_t kSize>
std::uint64_t bits_of(const Cube& cube) {
  return ((std::uint64_t{1} << kSize) - 1) << cube.x;
}

/// True if the cube has a wanted voxel.
template <std::int32_t kSize>
bool any(const BlockWords& wanted, const Cube& cube) {
  std::uint64_t sum = 0;
  for (std::int32_t z = 0; z < kSize; ++z) {
    for (std::int32_t y = 0; y < kSize; ++y) sum |= wanted.words[cube.z + z][cube.y + y];
  }
  return (sum & bits_of<kSize>(cube)) != 0;
}

template <std::int32_t kSize>
void add(BlockWords& words, const Cube& cube) {
  for (std::int32_t z = 0; z < kSize; ++z) {
    for (std::int32_t y = 0; y < kSize; ++y) words.words[cube.z + z][cube.y + y] |= bits_of<kSize>(cube);
  }
}

/// What the view sees of cube k of eight.
template <std::int32_t kSize>
Sight judge(const DepthPyramid& pyramid, const Footprints& feet, int k) {
  if (feet.beside[k / 4][k % 4] != 0) return Sight::kNone;
  if (feet.inside[k / 4][k % 4] == 0) return Sight::kPart;
  const PixelBox box = feet.pixels(k);
  const std::int32_t level = pyramid.level_for(box);
  if (level >= pyramid.levels()) return Sight::kPart;
  if (pyramid.least(box, level) >= feet.far[k / 4][k % 4]) return Sight::kAll;
  if (kSize == 1) return Sight::kNone;
  return pyramid.most(box, level) < feet.near[k / 4][k % 4] ? Sight::kNone : Sight::kPart;
}

/// A block and the view that carves it.
struct Carving {
  const View& view;
  const Projector& projector;
  const BlockWords& wanted;
  BlockWords& free;

  /// Decides cube k of eight, or divides it into eight.
  template <std::int32_t kSize>
  void decide(const Centers& centers, const Footprints& feet, int k, const Cube& cube) const {
    if (!any<kSize>(wanted, cube)) return;
    const Sight sight = judge<kSize>(view.pyramid, feet, k);
    if (sight == Sight::kAll) return add<kSize>(free, cube);
    if constexpr (kSize > 1) {
      if (sight == Sight::kPart) divide<kSize>(centers.at(k), cube);
    }
  }

  template <std::int32_t kSize>
  void divide(const Point& center, const Cube& cube) const {
    constexpr std::int32_t kHalf = kSize / 2;
    const Centers centers = projector.parts(center, kHalf);
    const Footprints feet = projector.project(centers, kHalf);
    for (int k = 0; k < 8; ++k) {
      decide<kHalf>(centers, feet, k,
                    {cube.x + (k & 1) * kHalf, cube.y + (k >> 1 & 1) * kHalf, cube.z + (k >> 2) * kHalf});
    }
  }
};

}  // namespace

void carve(const View& view, const Projector& projector, const Voxel& first, const BlockWords& wanted,
           BlockWords& free) noexcept {
  const Vec3 center = view.at(first.x + 32.0, first.y + 0.5 * kBlock, first.z + 0.5 * kBlock);
  const Centers centers =
      projector.row({static_cast<float>(center.x), static_cast<float>(center.y), static_cast<float>(center.z)}, kBlock);
  const Footprints feet = projector.project(centers, kBlock);
  const Carving carving{view, projector, wanted, free};
  for (int k = 0; k < 8; ++k) carving.decide<kBlock>(centers, feet, k, {kBlock * k, 0, 0});
}

}  // namespace tern
