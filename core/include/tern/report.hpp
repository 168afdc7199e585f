// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_REPORT_HPP
#define TERN_REPORT_HPP

#include <stdint.h>

#include "tern/fence.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// What one stage did. `bound` holds before the stage runs (contract C2): work <= bound always.
struct StageReport {
  uint32_t work;   ///< units: expansions, sight lines, planes, segments timed, iterations, checks
  uint32_t bound;  ///< the bound on it that follows from capacities, input sizes and budget
  uint64_t ticks;  ///< of the caller's clock; 0 with no clock
};

/// Highest use of each capacity of config.hpp during the plan.
struct HighWater {
  int32_t nodes;
  int32_t open;
  int32_t jump_points;
  int32_t segments;
  int32_t planes;         ///< of the fullest polyhedron
  int32_t local_boxes;    ///< around the busiest segment
  int32_t active;         ///< of the largest working set
  int32_t qp_iterations;  ///< of the longest quadratic programme
  int32_t qp_solves;
};

/// What the trajectory is.
enum class Quality : uint8_t {
  kNone = 0,
  kHover,      ///< start equals goal: one segment that stays
  kStopAndGo,  ///< straight from waypoint to waypoint, at rest in each (contract C6)
  kOptimised,  ///< minimum snap
  kPrevious,   ///< the rest of Request::previous, as it was
};

/// All that can be said of one call of the planner.
struct Report {
  Status status;
  Stage stage;        ///< where the status arose
  Field field;        ///< which input, for a caller's fault
  bool raw_occupied;  ///< kStartOccupied / kGoalOccupied: inside an obstacle itself (else only too close)
  bool has_nearest_free;
  bool timing_known;  ///< a clock was given and did not misbehave
  Quality quality;
  Status optimiser;   ///< why the optimiser stopped: kOk, or the reason for a fallback
  Vec3 nearest_free;  ///< world frame: centre of the free voxel nearest to an occupied start or goal
  StageReport stages[kStageCount];
  HighWater high_water;
  int32_t fence = kNoFence;  ///< kStartFenced / kGoalFenced: which of Request::fences, the first that is broken

  // The corridor's half-spaces, of all polyhedra together.
  int32_t half_spaces;            ///< that bound a polyhedron: eight rows each in the quadratic programme
  int32_t half_spaces_redundant;  ///< that follow from those, and were set aside

  /// Where an end moves too fast for the room around it on the path: 1, the path leads along its motion first; 2, the
  /// plan comes to rest first, in any way there is room for, and flies on from there (a goal's motion: begins at rest);
  /// 3, it flies Request::previous to its end first.
  int32_t detours;

  // The optimiser's last quadratic programme.
  int32_t qp_variables;
  int32_t qp_inequalities;
  int32_t qp_active;
  int32_t qp_iterations;  ///< of all quadratic programmes together
  double kkt_residual;    ///< relative; see docs/qp.md
};

}  // namespace tern

#endif
