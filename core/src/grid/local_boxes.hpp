// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Merges the obstacles around one segment into a few solid boxes, directly from the words of the obstacle layer. A run
// of bits along x grows into a rectangle over y if the next rows have the same run. Rectangles grow into boxes over z
// in the same way. A map of cuboids gives a few cuboids, not thousands of voxels. Noise gives single voxels.
#ifndef TERN_GRID_LOCAL_BOXES_HPP
#define TERN_GRID_LOCAL_BOXES_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "grid/bit_rows.hpp"
#include "tern/config.hpp"
#include "tern/grid.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// A solid box of obstacle voxels. Local frame, metres.
struct LocalBox {
  double lower[3];
  double upper[3];
};

inline Box box_of(const LocalBox& box) noexcept {
  return {{box.lower[0], box.lower[1], box.lower[2]}, {box.upper[0], box.upper[1], box.upper[2]}};
}

/// Voxels lower <= v < upper on every axis.
struct VoxelRange {
  Voxel lower;
  Voxel upper;
};

/// A rectangle of obstacle voxels in one layer, and the box that it belongs to. Half-open; x counts from the first word
/// of the range's rows, y from the range's lower y.
struct LayerRectangle {
  std::int16_t x0;
  std::int16_t x1;
  std::int16_t y0;
  std::int16_t y1;
  std::int32_t box;
};

constexpr int kMaxRowRuns = kMaxLocalBoxes < kMaxDimension / 2 + 1 ? kMaxLocalBoxes : kMaxDimension / 2 + 1;
static_assert(kMaxDimension < 32768, "rectangles count voxels in 16 bits");

/// The state of an extraction and its scratch memory; needs no initialisation before extract_begin.
struct ExtractScratch {
  VoxelRange range;
  std::int32_t z;                                ///< the layer to read next
  int count;                                     ///< boxes so far
  int below;                                     ///< index in `rectangles` of the layer below
  std::int32_t below_count;                      ///< number of rectangles of the layer below
  LayerRectangle rectangles[2][kMaxLocalBoxes];  ///< of this layer and of the one below, each sorted by (y0, x0)
  std::int32_t open[2][kMaxRowRuns];             ///< rectangles that reach the current row, in order of x
  std::uint64_t row[kMaxRowWords];               ///< the range's words of the current row
};

/// The voxels whose cubes meet `box` after each of its faces has moved out by the grid's radius. Along x, the range has
/// one more voxel on either side: each run of obstacles that a proof takes as one box then lies in one of the boxes
/// here.
VoxelRange voxels_within_reach(const Grid& grid, const Box& box) noexcept;

/// Merges the obstacle voxels of `range` into disjoint boxes, in the order of their lower corners by (z, y, x). Reads
/// only the words of the range. A piece of work reads a layer. kDone: scratch.count is the number of boxes. kFailed:
/// there are more than kMaxLocalBoxes.
void extract_begin(const VoxelRange& range, ExtractScratch& scratch) noexcept;
Progress extract_advance(const Grid& grid, ExtractScratch& scratch, LocalBox* boxes, Work& work) noexcept;

}  // namespace tern

#endif
