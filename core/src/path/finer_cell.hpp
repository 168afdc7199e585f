// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// At which resolution a point could join the grid, if it has room but no voxel near it is free.
#ifndef TERN_PATH_FINER_CELL_HPP
#define TERN_PATH_FINER_CELL_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "fence/fences.hpp"
#include "path/join.hpp"
#include "tern/grid.hpp"

namespace tern {

/// The voxel's edge is halved so often at most.
constexpr int kFinerHalvings = 6;

/// Plain data; needs no initialisation before finer_begin.
struct FinerCell {
  Vec3 point;
  std::int32_t halvings;   ///< of the edge
  std::int32_t candidate;  ///< the next voxel around the point's own
  double cell;             ///< the result, metres; 0 if no edge tried would do
};

/// Looks for the largest of cell / 2, cell / 4 and so on at which the point joins the grid: a grid with the same origin
/// and boundary that holds the same obstacles has a free voxel near the point, and the line to it is clear. No voxels
/// but those that are obstacles here are obstacles there. Local frame; the point keeps the radius and the fences.
void finer_begin(FinerCell& finer, const Vec3& point) noexcept;

/// A unit is one voxel of one resolution. kDone: `cell` is the result. Grids beyond kMaxCells or kMaxDimension would
/// not do.
Progress finer_advance(FinerCell& finer, const Grid& grid, const Fences* fences, Work& work) noexcept;

}  // namespace tern

#endif
