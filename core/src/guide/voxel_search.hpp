// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The search that the search stage uses: the optimal search alone, or a guided search first, which usually makes the
// optimal one unnecessary.
#ifndef TERN_GUIDE_VOXEL_SEARCH_HPP
#define TERN_GUIDE_VOXEL_SEARCH_HPP

#include <cstdint>

#include "base/work.hpp"
#include "guide/guided_search.hpp"
#include "guide/pocket.hpp"
#include "search/search.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/report.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"

namespace tern {

/// A fast search begins with the optimal search: with its steps, as long as they make progress, and then with this many
/// expansions that jump. Easy queries end there, with a cheapest path.
constexpr std::uint32_t kFirstJumps = 32;

/// Pieces of work of one search. The first expansions count as an optimal search of their own.
constexpr std::uint32_t kVoxelSearchBound = 2 * kGuidedBound + 2 * kPocketBound + 2 * kExpansionBound;

enum class SearchMethod : std::uint8_t { kFirst, kGuided, kStartPocket, kGoalPocket, kOptimal };

/// Plain data; needs no initialisation before voxel_search_begin.
struct VoxelSearch {
  Voxel start;
  Voxel goal;
  SearchMethod method;
  bool start_flooded;       ///< a flood around the start was begun; if it has ended, it found no pocket, or a large one
  bool goal_flooded;        ///< the same for a flood around the goal
  bool gave_up;             ///< the guided search gave up
  Cost least;               ///< proven lower bound of the cost of any path
  std::uint32_t entries;    ///< entries taken off open lists, and sorting steps; <= kVoxelSearchBound
  std::int32_t nodes_high;  ///< the most nodes of the optimal search
  std::int32_t open_high;
  union {
    Search optimal;
    GuidedSearch guided;  ///< valid if the method is neither kFirst nor kOptimal
  };
};
static_assert(sizeof(GuidedSearch) <= sizeof(Search), "the guided search takes no memory of its own");

/// Both voxels must be free in the grid's blocked layer, which must not change until the search ends.
void voxel_search_begin(VoxelSearch& search, const Grid& grid, const Voxel& start, const Voxel& goal,
                        SearchMode mode) noexcept;

/// A piece of work is an entry taken off an open list, or a sorting step. kRunning if nothing is left; at the end:
/// kOk, kNoPath, kNodesFull, kOpenFull.
Status voxel_search_advance(VoxelSearch& search, const Grid& grid, Work& work) noexcept;

/// As search_extract(). Call it once, after kOk.
Status voxel_search_extract(VoxelSearch& search, const Grid& grid, int reserve, Path& path) noexcept;

/// Call this after kOk if the path cannot be used. Begins the optimal search if another search found the path;
/// otherwise does nothing and returns false.
bool voxel_search_again(VoxelSearch& search, const Grid& grid) noexcept;

/// The search that found the path.
SearchUsed search_used(const VoxelSearch& search) noexcept;

/// Upper bound of the cost of the path found, in voxels, divided by the least cost of any path; at least 1.
double search_bound(const VoxelSearch& search, double cost) noexcept;

}  // namespace tern

#endif
