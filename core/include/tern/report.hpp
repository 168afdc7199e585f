// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What one call of the planner did: its answer, the reason for it, and the work that it took.
#ifndef TERN_REPORT_HPP
#define TERN_REPORT_HPP

#include <stdint.h>

#include "tern/config.hpp"
#include "tern/fence.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"
#include "tern/via.hpp"

namespace tern {

/// What one stage did. All zero if the stage did not run.
struct StageReport {
  /// Units of work done. What a unit is depends on the stage:
  /// - kRequest: none
  /// - kSearch: a node, voxel or block taken off an open list, or a line that joins start or goal to the grid
  /// - kShortcut: a line of sight, or a trial of tightening
  /// - kCorridor: a half-space made, even if it was discarded later
  /// - kTimes: a segment that got its first duration
  /// - kTrajectory: an iteration of a quadratic programme
  /// - kCheck: a polyhedron or a segment checked
  /// - kFences: all keep-in fences together, or one keep-out fence, entered into the grid
  /// - kDetour: a line of sight; Budget::sight_lines counts it with those of kShortcut
  /// - kPrevious, kEscape: a half-space made; Budget::planes counts it with those of kCorridor
  /// - kReach: a row of voxels flooded, 1024 words cleared, or a line that joins the start to the grid;
  ///   Budget::expansions counts it with those of kSearch
  uint32_t work;
  /// Upper bound on `work`, from the capacities and the budget alone. work <= bound always holds (contract C2).
  uint32_t bound;
  /// Time in ticks of the clock given to Planner::set_clock. 0 if timing_known is false.
  uint64_t ticks;
};

/// What the check found wrong with a plan: the first thing, in its order. An index is -1, and a voxel has coordinates
/// -1, if the finding is not about one.
struct CheckReport {
  /// Which test failed. kNone: none, and nothing below has a value.
  Finding finding = Finding::kNone;
  /// Segment of the trajectory. For kJoint, the later of the two.
  int32_t segment = -1;
  /// Polyhedron of the corridor.
  int32_t polyhedron = -1;
  /// A half-space of the polyhedron: the one that a control point is beyond, or the one that comes nearest to cutting
  /// off the obstacle or the keep-out fence. If `fence` is a keep-in fence, it is a half-space of that fence. For
  /// kOutside, -1 if a control point is outside the boundary; `axis` then says on which axis.
  int32_t plane = -1;
  /// Index in Request::fences.
  int32_t fence = -1;
  /// Index in Request::vias.
  int32_t via = -1;
  /// 0 position, 1 velocity, 2 acceleration, 3 jerk.
  int32_t derivative = -1;
  /// 0 x, 1 y, 2 z; 3 the horizontal norm.
  int32_t axis = -1;
  /// The obstacle's voxel.
  Voxel voxel{-1, -1, -1};
  /// By how much more than the check allows: metres, or m/s, m/s^2 or m/s^3 for a derivative. >= 0. 0 for kMalformed.
  double excess = 0.0;
};

/// The highest use of each capacity of config.hpp during the plan. Compare it with the capacity to choose capacities of
/// your own. If a capacity ran out, its value here is the capacity itself.
struct HighWater {
  /// Jump points that one search generated; of TERN_MAX_NODES. Only the optimal search counts, and the steps that every
  /// search begins with.
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
  /// Rows in the largest active set; of TERN_MAX_ACTIVE.
  int32_t active;
  /// Iterations of the longest quadratic programme; of TERN_MAX_QP_ITERATIONS.
  int32_t qp_iterations;
  /// Quadratic programmes solved for one corridor; of TERN_MAX_QP_SOLVES.
  int32_t qp_solves;
};

/// What kind of plan the trajectory is. Every kind but kNone is a checked plan.
enum class Quality : uint8_t {
  /// There is no plan.
  kNone = 0,
  /// Start equals goal, both at rest: one segment that stays there.
  kHover,
  /// Straight from waypoint to waypoint, coming to rest at each (contract C6). Report::optimiser says why it was not
  /// optimised. Safe, but slower than an optimised plan. If Report::optimiser is kOk, it is an arrival instead: one
  /// curve straight into the motion of the goal.
  kStopAndGo,
  /// The optimiser's plan: minimum snap, traded against duration.
  kOptimised,
  /// The rest of Request::previous, which leads to the goal.
  kPrevious,
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

/// Where a plan passes a via.
struct ViaPassage {
  double time;      ///< s since the plan's beginning
  double distance;  ///< m from the via's position then, at most its tolerance but for 1e-9 m
};

/// The whole answer to one call of Planner::plan or Planner::finish, which always fill it. Plain data without pointers.
struct Report {
  /// The answer; the same as the call's return value.
  Status status;
  /// The stage where `status` arose. For kOk: kCheck, the last stage.
  Stage stage;
  /// The field of the request or grid that is wrong. kNone if no single field is.
  Field field;
  /// Only for kStartOccupied, kGoalOccupied and kViaOccupied. True: the point lies inside an obstacle. False: it is
  /// outside, but closer to one than the radius.
  bool raw_occupied;
  /// Only for kStartOccupied, kGoalOccupied, kViaOccupied, kStartTooNarrow, kGoalTooNarrow and kViaTooNarrow: true if
  /// nearest_free has a value.
  bool has_nearest_free;
  /// True if reachable has a value: the goal is occupied or fenced, or no path leads to it, or the search had no room
  /// to find one (kNodesFull, kOpenFull). False if the start joins no free voxel, if Budget::expansions did not last,
  /// or if the grid is too large (TERN_MAX_FENCE_WORDS).
  bool has_reachable;
  /// True if ticks were measured. False if no clock was given, or if it stood still or ran backwards.
  bool timing_known;
  /// What kind of plan the trajectory is; kNone unless `status` is kOk.
  Quality quality;
  /// How optimising ended. kOk: it finished normally, or was never started. kBudgetOptimise together with kOptimised:
  /// the budget ended it early, and the plan is the best one found until then. With kStopAndGo it says why there is no
  /// optimised plan: kInfeasible, kNumerical, kIterationLimit, kWorkingSetFull, kBudgetOptimise, kSegmentsFull (no room
  /// for so many segments), or kCheckFailed (the check refused the optimised plan; `check` says why). An arrival has
  /// kOk.
  Status optimiser;
  /// Why the plan was to end at `reachable` instead of the goal: kGoalOccupied, kGoalFenced, kNoPath, kNodesFull or
  /// kOpenFull. kOk if it was not, and always with GoalMode::kExact.
  Status goal_missed;
  /// World frame, metres: the centre of the free voxel nearest to the occupied start, goal or via. Valid if
  /// has_nearest_free is true; zero otherwise.
  Vec3 nearest_free;
  /// World frame, metres: the point nearest to the goal of those that a path leads to. It is the centre of a free
  /// voxel; of centres that are equally near, the one with the least z, then y, then x. If the start is at rest in that
  /// voxel, it is the start. Valid if has_reachable is true; zero otherwise.
  Vec3 reachable;
  /// One entry a stage; index it with static_cast<int>(Stage::kSearch) and so on.
  StageReport stages[kStageCount];
  HighWater high_water;
  /// If `status` or `goal_missed` is kStartFenced, kGoalFenced or kViaFenced: the index in Request::fences of a fence
  /// that is broken. Keep-in fences are looked at first, in the request's order, then keep-out fences. If `field` is
  /// kFences: the index of the fence that is wrong. If `status` or `goal_missed` is kStartTooNarrow, kGoalTooNarrow or
  /// kViaTooNarrow: the index of a fence that takes the point's voxel, although obstacles and boundary leave it. Else
  /// kNoFence.
  int32_t fence = kNoFence;
  /// Why there is no plan, for a request with vias: the index in Request::vias of the via that is wrong or that the
  /// plan could not be led to. kNoVia if the start or the way from the last via to the goal is at fault, or no single
  /// part of the way.
  int32_t via = kNoVia;
  /// How the plan passes the vias, one entry each. Entries beyond Request::via_count are zero; without a plan, all of
  /// them are. At vias with equal positions, one after the other, several may have the same time.
  ViaPassage vias[kMaxVias];

  /// Only if `status` or `optimiser` is kCheckFailed: what was wrong with the plan that the check refused last. Its
  /// segments and polyhedra are those of that plan, which is not given out.
  CheckReport check;

  /// Half-spaces that bound the polyhedra of the corridor, all polyhedra together. Each makes eight rows in the
  /// quadratic programme.
  int32_t half_spaces;
  /// Redundant half-spaces of the corridor, all polyhedra together. They make no rows.
  int32_t half_spaces_redundant;

  /// What the planner did for a start or goal in motion, if the polyhedron around it had no room for that motion:
  /// - 0: nothing, there was no need or no way
  /// - 1, a detour: the path first leads straight ahead to where the motion can stop
  /// - 2, stop first: the plan comes to rest in any way there is room for and goes on from there; before a goal in
  ///   motion, it begins that motion from rest. Or one curve leads straight from start to goal
  /// - 3, previous plan: the plan goes on along Request::previous
  int32_t detours;

  /// Unknowns of one quadratic programme, all axes together; 0 if none was solved.
  int32_t qp_variables;
  /// Rows of the quadratic programme that had the most rows.
  int32_t qp_inequalities;
  /// Rows that are active at the solution that the plan was made from; 0 unless `quality` is kOptimised.
  int32_t qp_active;
  /// Iterations of all quadratic programmes together.
  int32_t qp_iterations;
  /// Largest relative KKT residual of the solution that the plan was made from: stationarity, complementarity or
  /// violation. At most 1e-8; docs/qp.md defines it. 0 unless `quality` is kOptimised.
  double kkt_residual;

  /// The cost of the path over the grid, divided by a proven lower bound of the least cost: the path costs at most this
  /// many times the least possible, but for rounding. Mostly it is much nearer to the optimum. 1 for the optimal
  /// search, and if no search was needed; 0 without a path.
  double search_bound;
  /// Which search found the path.
  SearchUsed search_used;

  /// Only for kStartTooNarrow, kGoalTooNarrow and kViaTooNarrow, metres: the largest of half the voxel's edge, a
  /// quarter and so on, down to 1/64, at which this point is not too narrow. The grid keeps its origin and boundary,
  /// and its obstacles are marked again. 0 if none of them would do, or no such grid fits.
  double finer_cell;
};

}  // namespace tern

#endif
