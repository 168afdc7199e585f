// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shortening that the paper prints (Section 3.2.3), on Tern's grid: greedy, by Bresenham's line. Not safe: its
// lines pass between blocked voxels that touch at an edge or a corner.
#ifndef TERN_BENCH_BASELINES_GREEDY_BRESENHAM_HPP
#define TERN_BENCH_BASELINES_GREEDY_BRESENHAM_HPP

#include <vector>

#include "tern/grid.hpp"

namespace tern_bench {

/// Bresenham's line from voxel to voxel in three dimensions, one voxel a step along the longest axis: all of them free.
bool bresenham_free(const tern::Grid& grid, const tern::Voxel& a, const tern::Voxel& b);

/// From each point kept, the farthest later one whose voxel Bresenham's line reaches. Neighbours see each other without
/// a line. Local frame; the first and the last point are kept.
std::vector<tern::Vec3> greedy_bresenham(const tern::Grid& grid, const std::vector<tern::Vec3>& points);

}  // namespace tern_bench

#endif
