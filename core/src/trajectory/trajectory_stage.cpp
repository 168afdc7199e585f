// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/trajectory_stage.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "curve/rest.hpp"
#include "times/time_unit.hpp"
#include "trajectory/among_things.hpp"
#include "trajectory/chain_ends.hpp"
#include "trajectory/programme.hpp"
#include "trajectory/stop_and_go.hpp"
#include "trajectory/turning.hpp"
#include "trajectory/turning_rows.hpp"
#include "trajectory/via_bounds.hpp"

namespace tern {
namespace {

/// The most passes of the stage's loop: four a programme, and some at the end.
constexpr int kPasses = 4 * kMaxQpSolves + 4;

/// A programme's lower bound is examined every time after this many iterations.
constexpr int kBoundStride = 4;

/// Rounds of the feasibility phase with a rival: longer durations than its own would not help.
constexpr int kRivalRounds = 1;

bool rests(const TrajectoryQuery& query) {
  return at_rest(query.start) && at_rest(query.goal);
}

bool is_elastic(const TrajectoryStage& stage) {
  return rests(stage.query) && !hurries(stage.chain) && stage.query.scene == nullptr;
}

bool stays(const Corridor& corridor) {
  for (int i = 0; i < corridor.count; ++i) {
    if (distance(corridor.polyhedra[i].from, corridor.polyhedra[i].to) > 0.0) return false;
  }
  return true;
}

int most(int a, int b) {
  return a < b ? b : a;
}

Candidate candidate_of(const TrajectoryStage& stage) {
  return {stage.chain, stage.points};
}

/// Snap of the chain with all unknowns zero, once there is a plan to compare with.
double fixed_snap(TrajectoryStage& stage) {
  if (!stage.best.found && !has_rival(stage)) return 0.0;
  for (int a = 0; a < kQpAxes; ++a) {
    for (int i = 0; i < stage.problem.unknowns; ++i) stage.solution.x[a][i] = 0.0;
  }
  read_points(stage.chain, stage.scale, stage.solution, stage.points);
  return snap_of(candidate_of(stage));
}

void propose(TrajectoryStage& stage, const Corridor& corridor, Work& work) {
  if (stage.refinement.phase == RefinementPhase::kDone || is_full(stage.solves == kMaxQpSolves)) {
    stage.phase = TrajectoryPhase::kFinish;
    return;
  }
  work.spend(kEndOperations * fit_ends(corridor, stage.query.limits, stage.chain));
  if (stage.chain.via_joint_count > 0) even_out(stage.chain);
  if (stage.query.limits.rate > 0.0 && stage.best.found) {
    work.spend(kTurningOperations * stage.chain.count);
    follow_turning({stage.chain, stage.best.points}, stage.query.limits, stage.turning);
  }
  assemble(stage.chain, corridor, stage.query.limits, &stage.turning, stage.problem, stage.scale);
  if (!part_from_things(stage, work)) return;
  stage.fixed_snap = fixed_snap(stage);
  work.spend(assembly_operations(stage.chain, stage.problem));
  qp_begin(stage.solver, stage.problem, stage.warm, stage.warm_count);
  stage.solve_begin = stage.iterations;
  ++stage.solves;
  stage.phase = TrajectoryPhase::kSolve;
}

/// As improves(); the first plan has to cost less than the rival, if there is one.
bool improves(const TrajectoryStage& stage, Offer& offer) {
  if (!improves(stage.refinement, offer)) return false;
  const Rival& rival = stage.query.rival;
  return stage.best.found || !has_rival(stage) || offer.cost < rival.snap + stage.refinement.rate * rival.duration;
}

/// True if no solution of the programme can improve on the best plan, because not even its lower bound of the snap
/// would.
bool hopeless(const TrajectoryStage& stage) {
  if (!stage.best.found && !has_rival(stage)) return false;
  const double bound = qp_lower_bound(stage.solver);
  if (!(bound > -kQpNoBound)) return false;
  const double snap = larger(0.0, stage.scale.snap_per_cost * bound + stage.fixed_snap);
  Offer offer{snap, chain_duration(stage.chain), 0.0, 1.0, 0.0};
  return !improves(stage, offer);
}

void note_iterations(TrajectoryStage& stage, int used) {
  stage.iterations += static_cast<std::uint32_t>(used);
  stage.longest_solve = most(stage.longest_solve, static_cast<int>(stage.iterations - stage.solve_begin));
}

/// Runs the solver, at most until its bound is examined next. kRunning if the solver can go on; kIterationLimit if the
/// programme is hopeless.
Status solve_on(TrajectoryStage& stage, Work& work) {
  const int before = stage.solver.iterations;
  const int stride = kBoundStride - before % kBoundStride;
  const Status status = qp_advance(stage.solver, stage.problem, work, stage.solution, stride);
  const int used = stage.solver.iterations - before;
  note_iterations(stage, used);
  if (status != Status::kRunning) return status;
  return takes_too_long(stage) || (used == stride && hopeless(stage)) ? Status::kIterationLimit : status;
}

/// Runs the solver within the slice. False if the slice is used up.
bool solve(TrajectoryStage& stage, Work& work) {
  Status status = Status::kRunning;
  while (status == Status::kRunning) {
    if (!work.left()) return false;
    status = solve_on(stage, work);
  }
  stage.solve_status = status;
  stage.active_high = most(stage.active_high, stage.solution.active_count);
  stage.phase = TrajectoryPhase::kJudge;
  return true;
}

double relative_residual(const QpSolution& solution) {
  return larger(larger(solution.stationarity, solution.complementarity), larger(solution.violation, 0.0));
}

void keep_best(TrajectoryStage& stage) {
  keep(candidate_of(stage), stage.best);
  stage.best.kkt_residual = relative_residual(stage.solution);
}

/// Reads the solution's plan. It is better if it improves on the best one and passes all tests. A solution whose plan
/// fails a test counts as none.
void accept(TrajectoryStage& stage, const Corridor& corridor, Work& work) {
  work.spend(points_operations(stage.chain));
  read_points(stage.chain, stage.scale, stage.solution, stage.points);
  stage.warm_count = stage.solution.active_count;
  for (int i = 0; i < stage.warm_count; ++i) stage.warm[i] = stage.solution.active[i];
  const Candidate candidate = candidate_of(stage);
  const double least = stage.refinement.elastic ? stretch_to_limits(candidate, stage.query.limits) : 1.0;
  Round& round = stage.round;
  round.offer = Offer{snap_of(candidate), chain_duration(stage.chain), least, 1.0, 0.0};
  const bool better = improves(stage, round.offer);
  const bool via_joints = keeps_everything(candidate, round.offer.stretch, corridor, stage.query.limits);
  if (!via_joints) stage.solve_status = Status::kNumerical;
  if (stage.query.limits.rate > 0.0) {
    work.spend(kRateOperations * stage.chain.count);
    share_turning(stage.problem, stage.solution, stage.scale, stage.chain.count, stage.turning);
    if (!stage.best.found) follow_turning(candidate, stage.query.limits, stage.turning);
  }
  round.better = better && via_joints && is_short_enough(stage);
}

/// Makes the accepted solution's plan the best one.
void take(TrajectoryStage& stage, Work& work) {
  work.spend(prices_operations(stage.chain, stage.solution));
  keep_best(stage);
  time_prices(stage.chain, stage.problem, stage.solution, stage.scale, stage.points, stage.round.prices);
  if (stage.query.scene == nullptr) return;
  add_separation_prices(stage.chain, stage.solution, stage.scale, stage.points, stage.separations, stage.round.prices);
  turn_planes(stage.chain, *stage.query.scene, stage.points, stage.separations, work);
}

Question question_of(const TrajectoryStage& stage, const Corridor& corridor) {
  const TrajectoryQuery& query = stage.query;
  Question question{time_unit(stage.chain, corridor, query.limits), query.time_weight,
                    agility(stage.chain, corridor, query.limits), is_elastic(stage),
                    query.paced && !stage.has_fallback};
  if (has_rival(stage)) question.feasibility_rounds = kRivalRounds;
  if (query.scene != nullptr) ask_among_things(question);
  return question;
}

void begin_refinement(TrajectoryStage& stage, const Corridor& corridor) {
  refinement_begin(stage.refinement, stage.chain, question_of(stage, corridor));
  if (stage.query.limits.rate > 0.0) first_turning(stage.chain, stage.query.limits, stage.turning);
}

/// If no programme had a solution: starts again from the segments of stop-and-go, for which a solution exists.
void follow_fallback(TrajectoryStage& stage, const Corridor& corridor, Work& work) {
  const TrajectoryQuery& query = stage.query;
  const bool has_none = hurries(stage.chain) || query.scene != nullptr || has_rival(stage);
  if (stage.best.found || stage.has_fallback || has_none) return;
  work.spend(rest_operations(corridor.count, rests(query)));
  if (stop_and_go(corridor, query.start, query.goal, query.limits, stage.fallback) != Status::kOk) return;
  stage.has_fallback = true;
  stage.warm_count = 0;
  follow(stage.fallback, stage.chain);
  if (!place_via_joints(stage.chain)) return;  // false if the way from one via to the next has no length
  begin_refinement(stage, corridor);
}

/// Ends a round.
void go_on(TrajectoryStage& stage, const Corridor& corridor, Work& work) {
  if (stage.round.better) take(stage, work);
  stage.optimiser = stage.best.found ? Status::kOk : stage.solve_status;
  stage.round.iterations = static_cast<int>(stage.iterations - stage.solve_begin);
  refinement_next(stage.refinement, stage.round, stage.chain);
  if (stage.refinement.phase == RefinementPhase::kDone) follow_fallback(stage, corridor, work);
  stage.phase = TrajectoryPhase::kPropose;
}

void judge(TrajectoryStage& stage, const Corridor& corridor, Work& work) {
  work.spend(judgement_operations(stage.chain));
  if (stage.solve_status == Status::kNumerical && give_up_tolerances(stage)) {
    stage.phase = TrajectoryPhase::kPropose;
    return;
  }
  stage.round.better = false;
  weigh_bound(stage, work);
  if (stage.solve_status == Status::kOk) accept(stage, corridor, work);
  if (stage.round.better && stage.query.scene != nullptr) return look_at_things(stage);
  go_on(stage, corridor, work);
}

/// Falls back to stop-and-go, if there is no better plan.
Progress fall_back(TrajectoryStage& stage, const Corridor& corridor, Trajectory& out, Work& work) {
  const TrajectoryQuery& query = stage.query;
  if (query.scene != nullptr) {
    return conclude(stage.separations.is_full ? Status::kSeparationsFull : Status::kNoTrajectory, stage.status);
  }
  if (has_rival(stage)) return conclude(Status::kNoTrajectory, stage.status);
  work.spend(rest_operations(corridor.count, rests(query)));
  const Status status =
      hurries(stage.chain) ? Status::kNoTrajectory : stop_and_go(corridor, query.start, query.goal, query.limits, out);
  stage.quality = status == Status::kOk ? Quality::kStopAndGo : Quality::kNone;
  return conclude(status, stage.status);
}

Progress finish(TrajectoryStage& stage, const Corridor& corridor, Trajectory& out, Work& work) {
  if (stays(corridor) && is_elastic(stage)) {
    stage.quality = Quality::kHover;
    hover(stage.query.start.position, out);
    return Progress::kDone;
  }
  if (!stage.best.found) return fall_back(stage, corridor, out, work);
  stage.quality = Quality::kOptimised;
  stage.kkt_residual = stage.best.kkt_residual;
  give_out(stage.best, stage.refinement.best.stretch, stage.chain, out);
  return Progress::kDone;
}

void clear_results(TrajectoryStage& stage) {
  stage.status = Status::kOk;
  stage.quality = Quality::kNone;
  stage.optimiser = Status::kOk;
  stage.iterations = 0;
  stage.active_high = 0;
  stage.solves = 0;
  stage.longest_solve = 0;
  stage.kkt_residual = 0.0;
}

}  // namespace

void trajectory_begin(TrajectoryStage& stage, const Corridor& corridor, const TrajectoryQuery& query,
                      const Chain& chain) noexcept {
  clear_results(stage);
  stage.query = query;
  stage.best.found = false;
  stage.has_fallback = false;
  stage.warm_count = 0;
  stage.repeats = 0;
  stage.phase = TrajectoryPhase::kFinish;
  stage.chain = chain;
  if (stays(corridor) && is_elastic(stage)) return;
  if (query.stop_and_go) return;
  begin_refinement(stage, corridor);
  stage.phase = TrajectoryPhase::kPropose;
  if (query.scene != nullptr) look_at_reference(stage);
}

void trajectory_stop(TrajectoryStage& stage) noexcept {
  stage.optimiser = Status::kBudgetOptimise;
  stage.phase = TrajectoryPhase::kFinish;
}

Progress trajectory_advance(TrajectoryStage& stage, const Corridor& corridor, Work& work, Trajectory& out) noexcept {
  for (int pass = 0; pass < kPasses && stage.phase != TrajectoryPhase::kFinish; ++pass) {
    switch (stage.phase) {
      case TrajectoryPhase::kPropose:
        if (!work.left()) return Progress::kMore;
        propose(stage, corridor, work);
        break;
      case TrajectoryPhase::kSolve:
        if (!solve(stage, work)) return Progress::kMore;
        break;
      case TrajectoryPhase::kJudge:
        if (!work.left()) return Progress::kMore;
        judge(stage, corridor, work);
        break;
      case TrajectoryPhase::kMeet:
        if (!meet(stage, work)) return Progress::kMore;
        stage.phase = TrajectoryPhase::kPropose;
        if (meets_nothing_new(stage, work)) go_on(stage, corridor, work);
        break;
      case TrajectoryPhase::kFinish:
        break;
    }
  }
  return finish(stage, corridor, out, work);
}

}  // namespace tern
