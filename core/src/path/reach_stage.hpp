// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// If no plan leads to a goal, the reach stage finds the reachable point nearest to it. Of all free voxels that the
// search could reach from the start, this is the one whose centre is nearest to the goal.
#ifndef TERN_PATH_REACH_STAGE_HPP
#define TERN_PATH_REACH_STAGE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "grid/distance.hpp"
#include "path/flood.hpp"
#include "path/join.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"
#include "world/world.hpp"

namespace tern {

/// The most pieces of work, without those of nearest_advance: clearing and the rows of the flood. Each voxel that the
/// start can join adds its line, and the beginning and end of its flood.
constexpr std::uint32_t kReachBound = kClearBound + kFloodBound + 4u * static_cast<std::uint32_t>(kJoinCells);

/// A query to the reach stage. Local frame.
struct ReachQuery {
  Vec3 start;                ///< inside the grid's boundary; breaks no wall and no solid
  Vec3 goal;                 ///< anywhere
  bool start_moves = false;  ///< as SearchQuery::start_moves
};

enum class ReachPhase : std::uint8_t {
  kClear,
  kBest,  ///< finds the free voxel nearest to the goal
  kJoin,
  kFlood,
  kNearest,  ///< finds the voxel nearest to the goal of those that were reached
  kEnd,
};

/// Plain data; needs no initialisation before reach_begin.
struct ReachStage {
  Status status;  ///< why the stage failed; else kOk
  Voxel nearest;  ///< the result
  bool joined;    ///< the start has joined at least one voxel
  Voxel best;     ///< of all free voxels, the nearest to the goal; the flood ends once it is reached
  ReachPhase phase;
  ReachQuery query;
  NearestFree search;  ///< for kBest and kNearest
  Join start;
  Flood flood;
};

/// The grid must be inflated, and the world must not change until the stage ends.
void reach_begin(ReachStage& stage, const World& world, const ReachQuery& query) noexcept;

/// A piece of work is one row of the flood, one line that joins the start to the grid, kClearedWords words cleared, or
/// a piece of nearest_advance. kDone: `nearest` is the result. Ties go to the least z, then y, then x. kFailed:
/// kStartOccupied (the start joins no voxel), or kWorldFull (the grid is too large).
Progress reach_advance(ReachStage& stage, const World& world, Work& work) noexcept;

}  // namespace tern

#endif
