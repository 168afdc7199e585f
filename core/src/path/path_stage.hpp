// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The path stage: from the exact start to the exact goal through free space, in few straight segments.
#ifndef TERN_PATH_PATH_STAGE_HPP
#define TERN_PATH_PATH_STAGE_HPP

#include <cstdint>

#include "base/work.hpp"
#include "path/join.hpp"
#include "path/shortcut.hpp"
#include "path/tighten.hpp"
#include "search/search.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// Searches of a query at most: one, and others from where an end can join the grid besides. Eight voxels meet in a
/// corner, each perhaps a pocket of its own. They are small, mostly: no search begins after kExpansionBound expansions.
constexpr std::uint32_t kJoinSearches = 4096;

/// Bound on PathStage::expansions: those of all searches, and the lines that join both ends to the grid before each.
constexpr std::uint32_t kSearchBound = 2 * kExpansionBound + kJoinSearches * 2u * static_cast<std::uint32_t>(kMaxJoins);

/// Bound on PathStage::sight_lines.
constexpr std::uint32_t kShortcutBound = kChainBound + kTightenBound;

/// What to find. Local frame; both points inside the grid's boundary.
struct PathQuery {
  Vec3 start;
  Vec3 goal;
  std::uint32_t max_expansions;    ///< Budget::expansions
  std::uint32_t max_sight_lines;   ///< Budget::sight_lines
  const Fences* fences = nullptr;  ///< clear of both points; the grid's blocked layer has them already
  bool start_moves = false;        ///< a state in flight, see join_others
  bool goal_moves = false;
};

enum class PathPhase : std::uint8_t { kJoinStart, kJoinGoal, kSearch, kShortcut, kTighten };

/// Plain data; needs no initialisation before path_begin.
struct PathStage {
  std::uint32_t expansions;    ///< nodes expanded and joining lines checked; <= kSearchBound and the budget
  std::uint32_t sight_lines;   ///< steps of the shortcut, trials of tightening; <= kShortcutBound and the budget
  std::int32_t nodes_high;     ///< jump points generated
  std::int32_t open_high;      ///< most open at once
  std::int32_t raw_high;       ///< points of the jump-point path
  std::int32_t segments_high;  ///< segments of the shortcut path; kMaxSegments where more would have been needed
  bool raw_occupied;           ///< kStartOccupied / kGoalOccupied: the point is inside an obstacle, radius apart
  bool has_nearest_free;
  Vec3 nearest_free;  ///< local frame: centre of the free voxel nearest to an occupied start or goal
  Stage stage;        ///< kSearch, then kShortcut

  PathPhase phase;
  PathQuery query;
  std::uint32_t failed;  ///< searches that found no way
  ScanMap* map;
  Join start;
  Join goal;
  Search search;
  union {
    Shortcut shortcut;
    Tighten tighten;  ///< begins when the shortcut's chain is complete
  };
};

/// The grid must be inflated and must not change until the stage ends. `map` as in search_begin.
void path_begin(PathStage& stage, ScanMap& map, const Grid& grid, const PathQuery& query) noexcept;

/// Returns kRunning once, with work left, between search and shortcut. One unit of work is one expansion, one line that
/// joins an end to the grid, one step of the shortcut, which walks one line of sight at most, or one trial of
/// tightening, which walks two lines at most. kRunning, or the end: kOk with `out` full; else kStartOccupied,
/// kGoalOccupied, kNoPath, kNodesFull, kOpenFull, kJumpPointsFull, kSegmentsFull (the raw path in `out` is whole),
/// kBudgetSearch or kBudgetShortcut, with `out` undefined otherwise. `out` must be the same object until then.
///
/// Every segment of the path lies in free voxels and keeps kSightMargin of a voxel (max norm) from all others, but for
/// the first and the last one where the exact start or goal is itself nearer: it then leads straight to the centre of
/// the point's own voxel, or, where that voxel is not free, along a line that keeps the radius to a free voxel near it.
Status path_advance(PathStage& stage, const Grid& grid, Work& work, Path& out) noexcept;

}  // namespace tern

#endif
