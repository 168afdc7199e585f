// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the planner came to its answer: the work of each stage, the use of each capacity, the search. Nothing here is
// needed to fly.
#ifndef TERN_DIAGNOSTICS_HPP
#define TERN_DIAGNOSTICS_HPP

#include <stdint.h>

#include "tern/status.hpp"

namespace tern {

/// What one stage did. All zero if the stage did not run.
struct StageReport {
  /// Units of work done, the last one perhaps in part: about a thousand instructions each (tern/work.hpp). Reading the
  /// request (kRequest) is not counted here.
  uint64_t work;
  /// Upper bound on `work`, from the capacities, the size of the grid and the budget. work <= bound always holds
  /// (contract C2).
  uint64_t bound;
  /// Time in ticks of the clock given to Planner::set_clock. 0 if timing_known is false.
  uint64_t ticks;
};

/// The highest use of each capacity of config.hpp during the plan. Compare it with the capacity to choose capacities of
/// your own. If a capacity ran out, its value here is the capacity itself.
struct HighWater {
  /// Jump points that one search generated; of TERN_MAX_NODES. The guided search generates none; the optimal one does,
  /// and so do the first steps of a fast search.
  int32_t nodes;
  /// Entries of the open list at one time; of TERN_MAX_OPEN.
  int32_t open;
  /// Points of the jump-point path; of TERN_MAX_JUMP_POINTS.
  int32_t jump_points;
  /// Legs of the path or segments of the trajectory, whichever is more; of TERN_MAX_SEGMENTS.
  int32_t segments;
  /// Half-spaces of the fullest polyhedron; of TERN_MAX_PLANES.
  int32_t planes;
  /// Boxes around the busiest segment; of TERN_MAX_LOCAL_BOXES.
  int32_t local_boxes;
  /// Constraints in the largest active set; of TERN_MAX_ACTIVE.
  int32_t active;
  /// Iterations of the longest quadratic programme; of TERN_MAX_QP_ITERATIONS.
  int32_t qp_iterations;
  /// Quadratic programmes solved for one corridor; of TERN_MAX_QP_SOLVES.
  int32_t qp_solves;
  /// Planes between a plan and things that move; of TERN_MAX_SEPARATIONS.
  int32_t separations;
  /// Words of the largest flood in time; of TERN_MAX_FLOOD_WORDS.
  int32_t flood_words;
};

/// Which search found the path.
enum class SearchUsed : uint8_t {
  /// None did: there is no path, or none was needed between start and goal.
  kNone = 0,
  /// The guided search.
  kGuided,
  /// The optimal search.
  kOptimal,
};

/// Report::diagnostics. Plain data.
struct Diagnostics {
  /// One entry a stage; index it with static_cast<int>(Stage::kSearch) and so on.
  StageReport stages[kStageCount];
  /// True if ticks were measured. False if no clock was given, or if it stood still or ran backwards.
  bool timing_known;
  HighWater high_water;
  /// What the planner did for a start or goal in motion, if the polyhedron around it had no room for that motion:
  /// - 0: nothing, there was no need or no way
  /// - 1, a detour: the path first leads straight ahead to where the motion can stop
  /// - 2, stop first: the plan comes to rest in any way there is room for and goes on from there; before a goal in
  ///   motion, it begins that motion from rest. Or one curve leads straight from start to goal
  /// - 3, previous plan: the plan goes on along Request::previous
  int32_t detours;
  /// What a plan around things that move began from: 1 the plan as if nothing moved, 2 and more a flood in time, the
  /// last number a way around what stands, as if it always did. 0 for all other plans.
  int32_t seed;
  /// The cost of the path over the grid, divided by a proven lower bound of the least cost. So the path costs at most
  /// this many times the least possible, up to rounding; most paths cost much less. 1 for the optimal search, and if no
  /// search was needed; 0 without a path.
  double search_bound;
  /// Which search found the path.
  SearchUsed search_used;
};

}  // namespace tern

#endif
