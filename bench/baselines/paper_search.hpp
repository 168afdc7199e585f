// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The front end that the paper's Table 4 was made with, as its lengths tell: what it prints for Maps 1 and 2 comes out
// to the last digit, and only so.
#ifndef TERN_BENCH_PAPER_SEARCH_HPP
#define TERN_BENCH_PAPER_SEARCH_HPP

#include <vector>

#include "baselines/paper_map.hpp"
#include "baselines/route.hpp"

namespace tern_bench {

/// Cell and margin of the paper's front end, metres.
constexpr double kPaperCell = 0.2;
constexpr double kPaperMargin = 0.1;

/// The paper's "JPS": jump points of 26 directions with corner cutting, but a greedy order: the next node is the one
/// with the least Manhattan distance to the goal plus length of its last jump, and a node is closed when it is
/// generated, so that no way is ever improved. Not optimal. The route is the exact start, the jump points, the centre
/// of the goal's voxel, the exact goal.
Route greedy_jump_search(const PaperMap& map, const tern::Vec3& start, const tern::Vec3& goal);

/// The paper's second half of "JPS-Bresenham": goes along the points and keeps one where it is in sight of the last one
/// kept and its successor is not. A point that was out of sight with its predecessor is dropped without being looked
/// at: the result may cross an obstacle.
std::vector<tern::Vec3> shorten_by_sight(const PaperMap& map, const std::vector<tern::Vec3>& points);

/// A* with 6 neighbours and the Manhattan distance: the spacing of the waypoints of the "A*" of the paper's Table 5,
/// 0.2 m, is that of a search that moves along one axis at a time. Every voxel of the way is a point.
Route six_neighbour_astar(const PaperMap& map, const tern::Vec3& start, const tern::Vec3& goal);

}  // namespace tern_bench

#endif
