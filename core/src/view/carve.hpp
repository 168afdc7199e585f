// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the voxels of a brick that a view sees whole.
#ifndef TERN_VIEW_CARVE_HPP
#define TERN_VIEW_CARVE_HPP

#include <cstdint>

#include "base/work.hpp"
#include "view/projector.hpp"

namespace tern {

/// Rows and planes of a brick. Along x, a brick is one word long.
constexpr std::int32_t kBrick = 8;

/// Operations of choosing among eight cubes: their words and, unless they are voxels, a look at the pyramid for each.
constexpr Operations choose_operations(std::int32_t size) noexcept {
  return 8 * (4 * ops::kWord + (size > 1 ? 5 * ops::kDot : 0));
}
/// Operations of a close look at the pixels of a voxel. In the view of a scan, decide_operations() has them.
constexpr Operations kCloseOperations = 8 * ops::kDot;
/// Operations of deciding eight cubes: their outlines and the pixels that cover them. The view of a scan has more of
/// both.
constexpr Operations decide_operations(bool around) noexcept {
  return 8 * (around ? 15 : 7) * ops::kDot;
}
/// Operations of misses().
constexpr Operations kMissesOperations = 3 * ops::kDot;
/// Operations of finding the voxels that earlier views of a scan have not seen.
constexpr Operations kOpenOperations = ops::kWord * kBrick * kBrick;
/// The most operations of a whole brick: cubes of 8, 4 and 2 voxels, and all voxels.
constexpr Operations carve_operations(bool around) noexcept {
  constexpr Operations kCubes = 1 + 8 + 64;
  return (around ? kOpenOperations : 0) + kCubes * (choose_operations(2) + decide_operations(around)) +
         8 * 64 * (choose_operations(1) + decide_operations(around) + (around ? 0 : 8 * kCloseOperations));
}

/// A word for each row of a brick: [plane][row].
struct BrickWords {
  std::uint64_t words[kBrick][kBrick];
};

/// Cubes of a brick, a bit each; along x, a brick is eight of them long.
using CubeBits = std::uint8_t;
constexpr CubeBits kAllCubes = 0xff;

/// The part of a brick that one call carves: whether the call begins the brick, and the cubes that it may divide.
struct CarvePart {
  bool begins;
  CubeBits cubes;
};

/// True if the view sees no voxel of the brick whose lowest voxel is `first`.
bool misses(const View& view, const Projector& projector, const Voxel& first) noexcept;

/// Adds to `free` all wanted voxels that the view sees whole; it may add others that the view sees whole. `first` is
/// the brick's lowest voxel. Begins with cubes of 8 x 8 x 8 voxels and divides only those that cannot be decided as a
/// whole. `left` becomes the cubes that another call must divide. One call is a piece of work.
void carve(const View& view, const Projector& projector, const Voxel& first, const BrickWords& wanted, BrickWords& free,
           const CarvePart& part, CubeBits& left, Work& work) noexcept;

}  // namespace tern

#endif
