// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the resolution at which a point could join the grid, if the point has room but no voxel near it is free.
#ifndef TERN_PATH_FINER_CELL_HPP
#define TERN_PATH_FINER_CELL_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "path/join.hpp"
#include "world/world.hpp"

namespace tern {

/// The voxel's edge is halved at most this many times.
constexpr int kFinerHalvings = 6;

/// Plain data; needs no initialisation before finer_begin.
struct FinerCell {
  Vec3 point;
  std::int32_t halvings;   ///< how often the voxel's edge is halved now
  std::int32_t candidate;  ///< the next voxel around the point's own
  double cell;             ///< the result: the voxel's edge, metres; 0 if the point joins at none
};

/// Looks for the largest of cell / 2, cell / 4 and so on at which the point joins the grid. It joins if a finer grid
/// has a free voxel near the point and the line to it is clear. The finer grid has the same origin and boundary, and
/// its obstacles fill the same space. Local frame. The point must break no wall and no solid.
void finer_begin(FinerCell& finer, const Vec3& point) noexcept;

/// A piece of work is one voxel of one resolution. kDone: `cell` is the result. Ends without a result once the finer
/// grid could not be bound.
Progress finer_advance(FinerCell& finer, const World& world, Work& work) noexcept;

}  // namespace tern

#endif
