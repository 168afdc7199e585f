// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The obstacles around one segment as a handful of solid boxes, straight from the words of the obstacle layer: runs
// of bits along x grow into rectangles over y where the next row has the same run, and rectangles into boxes over z.
// A cuboid world becomes its cuboids again instead of thousands of voxels; noise becomes its voxels.
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

/// A rectangle of obstacle voxels in one layer, half-open, counted from the first word of the range's rows and its
/// lower y, and the box that it belongs to.
struct LayerRectangle {
  std::int16_t x0;
  std::int16_t x1;
  std::int16_t y0;
  std::int16_t y1;
  std::int32_t box;
};

constexpr int kMaxRowRuns = kMaxLocalBoxes < kMaxDimension / 2 + 1 ? kMaxLocalBoxes : kMaxDimension / 2 + 1;
static_assert(kMaxDimension < 32768, "rectangles count voxels in 16 bits");

/// An extraction in work, and its scratch; no initialisation needed before extract_begin.
struct ExtractScratch {
  VoxelRange range;
  std::int32_t z;                                ///< the layer to read next
  int count;                                     ///< boxes so far
  int below;                                     ///< which rectangles are those of the layer below,
  std::int32_t below_count;                      ///< and how many
  LayerRectangle rectangles[2][kMaxLocalBoxes];  ///< of this layer and of the one below, each sorted by (y0, x0)
  std::int32_t open[2][kMaxRowRuns];             ///< rectangles that reach the current row, in order of x
  std::uint64_t row[kMaxRowWords];               ///< the range's words of the row at hand
};

/// The voxels whose cubes come closer than the grid's radius to a face of `box` from outside, or meet it: the others
/// are cut off by a face with the radius to spare. Along x it takes a voxel more on either side, so that whoever
/// verifies runs of bits sees no run that is longer than the box it went into.
VoxelRange voxels_within_reach(const Grid& grid, const Box& box) noexcept;

/// Merges the obstacle voxels of `range` into disjoint boxes, in the order of their lower corners by (z, y, x). Reads
/// only the words of the range. A unit of work reads a layer. kDone: scratch.count is the number of boxes. kFailed:
/// they are more than kMaxLocalBoxes.
void extract_begin(const VoxelRange& range, ExtractScratch& scratch) noexcept;
Progress extract_advance(const Grid& grid, ExtractScratch& scratch, LocalBox* boxes, Work& work) noexcept;

/// All of it. Returns the number of boxes, or -1 where they are more than kMaxLocalBoxes.
int extract_local_boxes(const Grid& grid, const VoxelRange& range, ExtractScratch& scratch, LocalBox* boxes) noexcept;

}  // namespace tern

#endif
