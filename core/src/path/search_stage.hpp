// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The search stage: from the exact start to the exact goal through free voxels. Both ends join the grid, and a search
// over voxels connects them.
#ifndef TERN_PATH_SEARCH_STAGE_HPP
#define TERN_PATH_SEARCH_STAGE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "guide/voxel_search.hpp"
#include "path/join.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// Searches of a query at most: one, and others from where an end can join the grid besides. Eight voxels meet in a
/// corner, each perhaps a pocket of its own. They are small, mostly: no search begins after kExpansionBound expansions.
constexpr std::uint32_t kJoinSearches = 4096;

/// Bound on SearchStage::expansions: the work of all searches, and the lines that join both ends to the grid before
/// each.
constexpr std::uint32_t kSearchBound =
    kExpansionBound + kVoxelSearchBound + kJoinSearches * 2u * static_cast<std::uint32_t>(kMaxJoins);

/// What to find. Local frame; both points inside the grid's boundary.
struct SearchQuery {
  Vec3 start;
  Vec3 goal;
  std::uint32_t max_expansions;    ///< what is left of Budget::expansions
  const Fences* fences = nullptr;  ///< clear of both points; the grid's blocked layer has them already
  bool start_moves = false;        ///< a state in flight, see join_others
  bool goal_moves = false;
  SearchMode mode = SearchMode::kOptimal;
};

enum class SearchPhase : std::uint8_t { kJoinStart, kJoinGoal, kSearch };

/// Plain data; needs no initialisation before search_begin.
struct SearchStage {
  Status status;             ///< why the stage failed; else kOk
  std::uint32_t expansions;  ///< entries taken off open lists and joining lines checked; <= kSearchBound and the budget
  std::int32_t nodes_high;   ///< jump points generated
  std::int32_t open_high;    ///< most open at once
  std::int32_t raw_high;     ///< points of the jump-point path
  SearchUsed search_used;    ///< kNone until the path is found, and where it needs none
  double search_bound;       ///< Report::search_bound
  bool raw_occupied;         ///< kStartOccupied / kGoalOccupied: the point is inside an obstacle, radius apart
  bool has_nearest_free;
  Vec3 nearest_free;  ///< local frame: centre of the free voxel nearest to an occupied start or goal

  SearchPhase phase;
  SearchQuery query;
  std::uint32_t failed;  ///< searches that found no way
  ScanMap* map;
  Join start;
  Join goal;
  VoxelSearch search;
};

/// The grid must be inflated and must not change until the stage ends. `map` is that of the search itself.
void search_begin(SearchStage& stage, ScanMap& map, const Grid& grid, const SearchQuery& query) noexcept;

/// One unit of work is one entry taken off an open list, or one line that joins an end to the grid. kDone with the raw
/// path in `out`: from each of its points the next is in sight. kFailed: kStartOccupied, kGoalOccupied, kNoPath,
/// kNodesFull, kOpenFull, kJumpPointsFull or kBudgetSearch, with `out` undefined. `out` must be the same object until
/// then.
///
/// Every leg lies in free voxels, but for the first and the last one where the exact start or goal is not in a free
/// voxel: it then leads along a line that keeps the radius to a free voxel near it.
Progress search_advance(SearchStage& stage, const Grid& grid, Work& work, Path& out) noexcept;

}  // namespace tern

#endif
