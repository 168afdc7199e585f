// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The trajectory stage (the paper's Section 3.4): corridor in, Bezier trajectory of degree 7 out. It is continuous to
// jerk, its control points are inside the corridor, and it keeps the limits for all t. See docs/trajectory.md.
#ifndef TERN_TRAJECTORY_TRAJECTORY_STAGE_HPP
#define TERN_TRAJECTORY_TRAJECTORY_STAGE_HPP

#include <cstdint>

#include "base/bounds.hpp"
#include "base/progress.hpp"
#include "base/work.hpp"
#include "qp/qp.hpp"
#include "qp/solver.hpp"
#include "tern/corridor.hpp"
#include "tern/report.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"
#include "times/chain.hpp"
#include "times/pace.hpp"
#include "trajectory/candidate.hpp"
#include "trajectory/programme.hpp"
#include "trajectory/refinement.hpp"
#include "trajectory/separations.hpp"

namespace tern {

/// The trajectory to be found. Local frame. The boundary states must keep the limits, and their positions must be
/// inside the first and the last polyhedron.
struct TrajectoryQuery {
  State start;
  State goal;
  MotionLimits limits;
  double time_weight;            ///< > 0; see Request::time_weight
  bool stop_and_go = false;      ///< no programme, but stop-and-go at once
  bool paced = false;            ///< the chain has its durations from an earlier plan (times/pace.hpp)
  Rival rival{};                 ///< what is left of that plan, if only a better one is of use
  const Scene* scene = nullptr;  ///< things that move, which the trajectory is led around; null: none
};

/// The most iterations of one run of the stage.
constexpr std::uint32_t kTrajectoryBound =
    static_cast<std::uint32_t>(kMaxQpSolves) * static_cast<std::uint32_t>(kMaxQpIterations);

enum class TrajectoryPhase : std::uint8_t { kPropose, kSolve, kJudge, kMeet, kFinish };

/// Plain data; needs no initialisation before trajectory_begin.
struct TrajectoryStage {
  // Results, valid whenever trajectory_advance has returned.
  Status status;  ///< why the stage failed; else kOk
  Quality quality;
  Status optimiser;          ///< kOk, or why the plan is not an optimised one
  std::uint32_t iterations;  ///< iterations of all programmes
  int active_high;           ///< the largest working set
  int solves;
  int longest_solve;    ///< iterations
  double kkt_residual;  ///< of the returned plan

  // State.
  TrajectoryPhase phase;
  TrajectoryQuery query;
  Chain chain;
  Refinement refinement;
  Round round;
  ProgrammeScale scale;
  Turning turning;
  BestPlan best;
  bool has_fallback;    ///< the chain follows the fallback
  Trajectory fallback;  ///< stop-and-go
  Status solve_status;
  std::uint32_t solve_begin;  ///< `iterations` when the programme was begun
  double fixed_snap;          ///< snap of the chain with all unknowns zero, which the programme's cost leaves out
  int warm_count;
  QpConstraint warm[kMaxActive];
  Vec3 points[kMaxSegments][kControlPoints];  ///< control points of the candidate
  // With a scene.
  int repeats;  ///< how often durations were tried again with more planes
  Separations separations;
  QpProblem problem;
  QpSolution solution;
  QpSolver solver;
};

/// True if only a plan that is better than another one is of use.
inline bool has_rival(const TrajectoryStage& stage) noexcept {
  return stage.query.rival.duration > 0.0;
}

/// Starts a plan from the chain that the times stage made of the corridor. The corridor must stay unchanged until the
/// plan ends; it has at least one polyhedron, each around its segment.
///
/// With a scene, the chain has the segments of the scene's reference, and the trajectory is what it would be with
/// planes between it and all things that it meets. There is no stop-and-go then: kFailed with kNoTrajectory, or with
/// kSeparationsFull if it meets too much.
///
/// With a rival, only a trajectory that costs less than it is looked for, at first in the rival's durations. There is
/// no stop-and-go then: kFailed with kNoTrajectory if none was found.
void trajectory_begin(TrajectoryStage& stage, const Corridor& corridor, const TrajectoryQuery& query,
                      const Chain& chain) noexcept;

/// Ends the search for a better plan, because the budget is spent: trajectory_advance() then answers with the best plan
/// so far, or with stop-and-go. `optimiser` is kBudgetOptimise.
void trajectory_stop(TrajectoryStage& stage) noexcept;

/// A piece of work is an iteration of a quadratic programme, its assembly, or its judgement. kDone with count and
/// segments of `out` filled (the origin is the caller's). kFailed: kNoTrajectory or kSegmentsFull, with `out`
/// untouched. That happens only from a moving start, to a moving goal or past a via with a velocity. Segments name
/// their polyhedron; there may be more segments than polyhedra.
Progress trajectory_advance(TrajectoryStage& stage, const Corridor& corridor, Work& work, Trajectory& out) noexcept;

/// A duration tried for a segment at an end: its curve and three derivatives, against half-spaces and limits.
constexpr Operations kEndOperations = 10 * ops::kCurve;

/// The assembly of a programme, and the snap of the chain with all unknowns zero: eight curves a segment, and each
/// point and half-space once.
inline Operations assembly_operations(const Chain& chain, const QpProblem& problem) {
  return 8 * ops::kCurve * chain.count + kQpPointTerms * ops::kDot * problem.point_count +
         ops::kDot * problem.plane_count;
}

/// A judgement, whatever it decides: the chain's durations, tried and kept.
inline Operations judgement_operations(const Chain& chain) {
  return ops::kPiece + ops::kCurve * chain.count;
}

/// The points of a solution, read and checked against polyhedra and limits: ten curves a segment.
inline Operations points_operations(const Chain& chain) {
  return 10 * ops::kCurve * chain.count;
}

/// Of each segment, with a limit on body rates: its rates at some stretches, over some pieces each, about.
constexpr Operations kRateOperations = 64 * ops::kCurve;

/// Of each segment, with a limit on body rates: the rows that follow from a plan.
constexpr Operations kTurningOperations = 8 * ops::kCurve;

/// The prices of the durations: five curves a segment, and two points for each active constraint.
inline Operations prices_operations(const Chain& chain, const QpSolution& solution) {
  return 5 * ops::kCurve * chain.count + 2 * ops::kPiece * solution.active_count;
}

/// About the number of brakings that stop-and-go tries at an end in motion.
constexpr int kBrakingsTried = 256;

/// Stop-and-go along `polyhedra` polyhedra: a curve each, and at ends in motion one for each braking that is tried.
inline Operations rest_operations(int polyhedra, bool at_rest) {
  return ops::kCurve * (polyhedra + (at_rest ? 0 : kBrakingsTried));
}

}  // namespace tern

#endif
