// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A slow reference for the shortest path in a grid's free space, at any angle.
#ifndef TERN_BENCH_ANY_ANGLE_HPP
#define TERN_BENCH_ANY_ANGLE_HPP

#include <vector>

#include "tern/grid.hpp"

namespace tern_bench {

/// A short path in the union of the free voxels, without margin, that cuts no corners: A* over voxel centres with
/// straight moves to every voxel up to three away on each axis that no shorter move repeats (266 directions instead of
/// 26), then pulled tight by moving each point in 26 directions with ever finer steps until nothing helps. It is a
/// path, hence never shorter than the shortest one; how near it comes is not proved. World frame; empty where there is
/// no way.
std::vector<tern::Vec3> any_angle_path(const tern::Grid& grid, const tern::Vec3& start, const tern::Vec3& goal);

double path_length(const std::vector<tern::Vec3>& path);

}  // namespace tern_bench

#endif
