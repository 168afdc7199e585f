// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The path stage finds a path of few straight segments through free space, from the exact start to the exact goal.
#ifndef TERN_PATH_PATH_STAGE_HPP
#define TERN_PATH_PATH_STAGE_HPP

#include <cstdint>

#include "base/work.hpp"
#include "guide/voxel_search.hpp"
#include "path/join.hpp"
#include "path/shortcut.hpp"
#include "path/tighten.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// Searches that one query may make: the first, and more from other voxels that an end can join. Eight voxels meet in a
/// corner, and each may lie in a separate pocket. Most pockets are small: no search begins after kExpansionBound
/// expansions.
constexpr std::uint32_t kJoinSearches = 4096;

/// Bound on PathStage::expansions: the work of all searches, plus the lines checked before each one to join both ends
/// to the grid.
constexpr std::uint32_t kSearchBound =
    kExpansionBound + kVoxelSearchBound + kJoinSearches * 2u * static_cast<std::uint32_t>(kMaxJoins);

/// Bound on PathStage::sight_lines.
constexpr std::uint32_t kShortcutBound = kChainBound + kTightenBound;

/// What to find. Local frame; both points inside the grid's boundary.
struct PathQuery {
  Vec3 start;
  Vec3 goal;
  std::uint32_t max_expansions;    ///< Budget::expansions
  std::uint32_t max_sight_lines;   ///< Budget::sight_lines
  const Fences* fences = nullptr;  ///< both points obey them, and the grid's blocked layer includes them
  bool start_moves = false;        ///< a state in flight, see join_others
  bool goal_moves = false;
  SearchMode search = SearchMode::kOptimal;
};

enum class PathPhase : std::uint8_t { kJoinStart, kJoinGoal, kSearch, kShortcut, kTighten };

/// Plain data; needs no initialisation before path_begin.
struct PathStage {
  std::uint32_t expansions;  ///< entries taken off open lists and joining lines checked; <= kSearchBound and the budget
  std::uint32_t sight_lines;   ///< steps of the shortcut, trials of tightening; <= kShortcutBound and the budget
  std::int32_t nodes_high;     ///< jump points generated
  std::int32_t open_high;      ///< most open at once
  std::int32_t raw_high;       ///< points of the jump-point path
  std::int32_t segments_high;  ///< segments of the shortcut path; kMaxSegments if it needs more
  bool raw_occupied;           ///< kStartOccupied / kGoalOccupied: the point itself is inside an obstacle
  bool has_nearest_free;
  Vec3 nearest_free;       ///< local frame: centre of the free voxel nearest to an occupied start or goal
  Stage stage;             ///< kSearch, then kShortcut
  SearchUsed search_used;  ///< kNone until the raw path is found, and where it needs none
  double search_bound;     ///< Report::search_bound

  PathPhase phase;
  PathQuery query;
  std::uint32_t failed;  ///< searches that found no way
  ScanMap* map;
  Join start;
  Join goal;
  VoxelSearch search;
  union {
    Shortcut shortcut;
    Tighten tighten;  ///< begins when the shortcut's chain is complete
  };
};

/// The grid must be inflated and must not change until the stage ends. `map` as in search_begin.
void path_begin(PathStage& stage, ScanMap& map, const Grid& grid, const PathQuery& query) noexcept;

/// Returns kRunning until the end; with work left once between search and shortcut, and where the search begins again
/// because a fast path has too many turns. One unit of work is one entry taken off an open list, one line that joins an
/// end to the grid, one step of the shortcut (at most one line of sight), or one trial of tightening (at most two lines
/// of sight). At the end: kOk with `out` filled in, or kStartOccupied, kGoalOccupied, kNoPath, kNodesFull, kOpenFull,
/// kJumpPointsFull, kSegmentsFull, kBudgetSearch or kBudgetShortcut. `out` is then undefined, except that with
/// kSegmentsFull its raw path is complete. Pass the same `out` in every call.
///
/// Every segment of the path lies in free voxels and keeps kSightMargin of a voxel (max norm) from all others. The
/// first and the last segment may come closer if the exact start or goal does. Such a segment leads straight to the
/// centre of the point's own voxel or, if that voxel is not free, to a free voxel near it along a line that keeps the
/// radius.
Status path_advance(PathStage& stage, const Grid& grid, Work& work, Path& out) noexcept;

}  // namespace tern

#endif
