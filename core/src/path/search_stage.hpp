// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The search stage finds a path from the exact start to the exact goal through free voxels. It joins both ends to the
// grid, and a search over voxels connects them.
#ifndef TERN_PATH_SEARCH_STAGE_HPP
#define TERN_PATH_SEARCH_STAGE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "grid/distance.hpp"
#include "guide/voxel_search.hpp"
#include "path/finer_cell.hpp"
#include "path/join.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"
#include "world/world.hpp"

namespace tern {

/// Searches that one query may make: the first, and more from other voxels that an end can join. Eight voxels meet in a
/// corner, and each may lie in a separate pocket. Most pockets are small, so no search begins once kExpansionBound
/// pieces of work are done.
constexpr std::uint32_t kJoinSearches = 4096;

/// Bound on SearchStage::pieces: kExpansionBound until the last search begins, that search, and the lines
/// that join both ends to the grid before each search.
constexpr std::uint32_t kSearchBound =
    kExpansionBound + kVoxelSearchBound + kJoinSearches * 2u * static_cast<std::uint32_t>(kMaxJoins);

/// A query to the search stage. Local frame; both points are inside the grid's boundary, and break no wall and no
/// solid.
struct SearchQuery {
  Vec3 start;
  Vec3 goal;
  bool start_moves = false;  ///< the start is a state in flight, see join_others
  bool goal_moves = false;
  SearchMode mode = SearchMode::kOptimal;
};

enum class SearchPhase : std::uint8_t {
  kJoinStart,
  kJoinGoal,
  kSearch,
  kFiner,    ///< an end has room but joins no voxel: finds the resolution at which it would
  kNearest,  ///< an end joins no voxel: finds the free voxel nearest to it
};

/// Plain data; needs no initialisation before search_begin.
struct SearchStage {
  Status status;            ///< why the stage failed; else kOk
  std::uint32_t pieces;     ///< entries taken off open lists and joining lines checked; <= kSearchBound
  std::int32_t nodes_high;  ///< jump points generated
  std::int32_t open_high;   ///< most entries of the open list at once
  std::int32_t raw_high;    ///< points of the jump-point path
  SearchUsed search_used;   ///< kNone until a search has found the path, or if none was needed
  double search_bound;      ///< Diagnostics::search_bound
  bool raw_occupied;        ///< kStartOccupied / kGoalOccupied: the point itself is inside an obstacle
  bool has_nearest_free;
  Vec3 nearest_free;  ///< local frame: centre of the free voxel nearest to an occupied start or goal

  SearchPhase phase;
  SearchQuery query;
  std::uint32_t failed;  ///< searches that found no path
  Join start;
  Join goal;
  NearestFree nearest;
  FinerCell finer;
  VoxelSearch search;
};

/// The grid must be inflated, and the world must not change until the stage ends.
void search_begin(SearchStage& stage, const World& world, const SearchQuery& query) noexcept;

/// A piece of work is one entry taken off an open list, or one line that joins an end to the grid. kDone: `out` has the
/// raw path, and each point of it sees the next. kFailed: kStartOccupied, kGoalOccupied, kStartTooNarrow,
/// kGoalTooNarrow, kNoPath, kNodesFull, kOpenFull or kJumpPointsFull, with `out` undefined. Pass the same `out` in
/// every call.
///
/// Every leg lies in free voxels, except the first or the last if the exact start or goal is not in a free voxel. Such
/// a leg leads to a free voxel nearby along a line that keeps the radius.
Progress search_advance(SearchStage& stage, const World& world, Work& work, Path& out) noexcept;

}  // namespace tern

#endif
