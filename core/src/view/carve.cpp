// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "view/carve.hpp"

#include "base/math.hpp"
#include "base/work.hpp"
#include "view/projector.hpp"

namespace tern {
namespace {

/// A cube of voxels in a brick; (x, y, z) is its lowest voxel within the brick.
struct Cube {
  std::int32_t x, y, z;
};

template <std::int32_t kSize>
std::uint64_t bits_of(const Cube& cube) {
  return ((std::uint64_t{1} << kSize) - 1) << cube.x;
}

/// True if the cube has a wanted voxel.
template <std::int32_t kSize>
bool any(const BrickWords& wanted, const Cube& cube) {
  std::uint64_t sum = 0;
  for (std::int32_t z = 0; z < kSize; ++z) {
    for (std::int32_t y = 0; y < kSize; ++y) sum |= wanted.words[cube.z + z][cube.y + y];
  }
  return (sum & bits_of<kSize>(cube)) != 0;
}

template <std::int32_t kSize>
void add(BrickWords& words, const Cube& cube) {
  for (std::int32_t z = 0; z < kSize; ++z) {
    for (std::int32_t y = 0; y < kSize; ++y) words.words[cube.z + z][cube.y + y] |= bits_of<kSize>(cube);
  }
}

/// True if the view sees no voxel of cube k of eight whole.
bool hidden(const DepthPyramid& pyramid, const Cores& cores, int k) {
  if (cores.beside[k / 4][k % 4] != 0) return true;
  if (cores.ahead[k / 4][k % 4] == 0) return false;
  const PixelBox box = cores.pixels.at(k);
  if (cores.common[k / 4][k % 4] != 0) return !pyramid.reaches(box, cores.far[k / 4][k % 4]);
  const std::int32_t level = pyramid.level_for(box);
  return level < pyramid.levels() && pyramid.most(box, level) < cores.far[k / 4][k % 4];
}

/// True if every pixel that covers cube k of eight measured a depth behind it. Rounding outlines outwards to a coarse
/// level hides too much of what is beside an obstacle: voxels, and all cubes in the wide outlines of a scan's view, are
/// therefore looked at closely.
template <std::int32_t kSize>
bool clear(const View& view, const Footprints& feet, int k, Work& work) {
  const DepthPyramid& pyramid = view.pyramid;
  if (feet.inside[k / 4][k % 4] == 0) return false;
  const PixelBox box = feet.pixels.at(k);
  // Usually, one pixel in the middle decides.
  if (pyramid.row((box.v0 + box.v1) >> 1)[(box.u0 + box.u1) >> 1] < feet.far[k / 4][k % 4]) return false;
  if (view.reach > 0.0) return pyramid.reaches(box, feet.far[k / 4][k % 4]);
  const std::int32_t level = pyramid.level_for(box);
  if (level < pyramid.levels() && pyramid.least(box, level) >= feet.far[k / 4][k % 4]) return true;
  if (kSize > 1) return false;
  work.spend(kCloseOperations);
  return pyramid.reaches(box, feet.far[k / 4][k % 4]);
}

/// Carves cubes of a brick.
struct Carver {
  const View& view;
  const Projector& projector;
  const BrickWords& wanted;
  BrickWords& free;
  Work& work;

  /// Of eight cubes, marks those that may have a wanted voxel that the view sees whole.
  template <std::int32_t kSize>
  bool choose(const Centers& centers, const Cube* cubes, bool* chosen) const {
    Cores cores;
    if constexpr (kSize > 1) cores = projector.cores(centers, kSize);
    bool one = false;
    for (int k = 0; k < 8; ++k) {
      chosen[k] = any<kSize>(wanted, cubes[k]);
      if constexpr (kSize > 1) chosen[k] = chosen[k] && !hidden(view.pyramid, cores, k);
      one = one || chosen[k];
    }
    return one;
  }

  /// Decides eight cubes. Returns those that must be divided.
  template <std::int32_t kSize>
  CubeBits decide(const Centers& centers, const Cube* cubes) {
    bool chosen[8];
    const bool around = view.reach > 0.0;
    work.spend(choose_operations(kSize));
    if (!choose<kSize>(centers, cubes, chosen)) return 0;
    work.spend(decide_operations(around));
    const Footprints feet = projector.footprints(centers, kSize);
    unsigned left = 0;
    for (int k = 0; k < 8; ++k) {
      if (!chosen[k]) continue;
      if (clear<kSize>(view, feet, k, work)) {
        add<kSize>(free, cubes[k]);
      } else {
        left |= 1u << k;
      }
    }
    return static_cast<CubeBits>(left);
  }

  /// Divides the cubes in `which` into eight each, and decides the eight.
  template <std::int32_t kSize>
  void divide(const Centers& centers, const Cube* cubes, CubeBits which) {
    constexpr std::int32_t kHalf = kSize / 2;
    for (unsigned left = which; left != 0; left &= left - 1) {
      const int k = __builtin_ctz(left);
      Cube parts[8];
      for (int i = 0; i < 8; ++i) {
        parts[i] = {cubes[k].x + (i & 1) * kHalf, cubes[k].y + (i >> 1 & 1) * kHalf, cubes[k].z + (i >> 2) * kHalf};
      }
      const Centers centers_of_parts = projector.parts(centers.at(k), kHalf);
      const CubeBits finer = decide<kHalf>(centers_of_parts, parts);
      if constexpr (kHalf > 1) divide<kHalf>(centers_of_parts, parts, finer);
    }
  }
};

/// The wanted voxels that no view has seen whole yet.
BrickWords without(const BrickWords& wanted, const BrickWords& free) {
  BrickWords open;
  for (std::int32_t z = 0; z < kBrick; ++z) {
    for (std::int32_t y = 0; y < kBrick; ++y) open.words[z][y] = wanted.words[z][y] & ~free.words[z][y];
  }
  return open;
}

Point middle_of(const View& view, const Voxel& first) {
  const Vec3 center = view.at(first.x + 32.0, first.y + 0.5 * kBrick, first.z + 0.5 * kBrick);
  return {static_cast<float>(center.x), static_cast<float>(center.y), static_cast<float>(center.z)};
}

}  // namespace

bool misses(const View& view, const Projector& projector, const Voxel& first) noexcept {
  return projector.misses(middle_of(view, first), {64.0f, kBrick, kBrick});
}

void carve(const View& view, const Projector& projector, const Voxel& first, const BrickWords& wanted, BrickWords& free,
           const CarvePart& part, CubeBits& left, Work& work) noexcept {
  const Centers centers = projector.row(middle_of(view, first), kBrick);
  Cube cubes[8];
  for (int k = 0; k < 8; ++k) cubes[k] = {kBrick * k, 0, 0};
  // The views of a scan overlap. What one of them has seen, the next ones need not look for.
  BrickWords open;
  const bool around = view.reach > 0.0;
  if (around) {
    work.spend(kOpenOperations);
    open = without(wanted, free);
  }
  Carver carver{view, projector, around ? open : wanted, free, work};
  if (part.begins) left = carver.decide<kBrick>(centers, cubes);
  carver.divide<kBrick>(centers, cubes, left & part.cubes);
  left = static_cast<CubeBits>(left & ~part.cubes);
}

}  // namespace tern
