// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/trajectory_stage.hpp"

#include "base/math.hpp"
#include "times/times.hpp"
#include "trajectory/motion_limits.hpp"
#include "trajectory/stop_and_go.hpp"

namespace tern {
namespace {

/// Passes of the stage's loop: three a programme, and the last ones.
constexpr int kPasses = 3 * kMaxQpSolves + 4;

bool rests(const TrajectoryQuery& query) {
  return at_rest(query.start) && at_rest(query.goal);
}

bool stays(const Corridor& corridor) {
  for (int i = 0; i < corridor.count; ++i) {
    if (distance(corridor.polyhedra[i].from, corridor.polyhedra[i].to) > 0.0) return false;
  }
  return true;
}

int count_rows(const QpProblem& problem) {
  int rows = 0;
  for (int g = 0; g < problem.group_count; ++g) {
    const QpGroup& group = problem.groups[g];
    rows += (group.point_end - group.point_begin) * (group.plane_end - group.plane_begin);
  }
  return rows;
}

int most(int a, int b) {
  return a < b ? b : a;
}

void propose(TrajectoryStage& stage, const Corridor& corridor) {
  if (stage.refinement.course == Course::kDone || stage.solves == kMaxQpSolves) {
    stage.phase = TrajectoryPhase::kFinish;
    return;
  }
  fit_ends(corridor, stage.query.limits, stage.chain);
  assemble(stage.chain, corridor, stage.query.limits, refinement_rows(stage.refinement), stage.problem, stage.scale);
  qp_begin(stage.solver, stage.problem, stage.warm, stage.warm_count);
  stage.solve_begin = stage.iterations;
  stage.variables = kQpAxes * stage.problem.unknowns;
  stage.inequalities = most(stage.inequalities, count_rows(stage.problem));
  ++stage.solves;
  stage.phase = TrajectoryPhase::kSolve;
}

/// Runs the solver within the slice and the plan's budget. False where the slice is used up.
bool solve(TrajectoryStage& stage, Work& work) {
  const std::uint32_t allowed = stage.query.max_iterations - stage.iterations;
  const std::uint32_t slice = work.left < allowed ? work.left : allowed;
  Work inner{slice};
  const Status status = qp_advance(stage.solver, stage.problem, inner, stage.solution);
  const std::uint32_t used = slice - inner.left;
  work.left -= used;
  stage.iterations += used;
  stage.longest_solve = most(stage.longest_solve, static_cast<int>(stage.iterations - stage.solve_begin));
  if (status == Status::kRunning) {
    if (stage.iterations < stage.query.max_iterations) return false;
    stage.optimiser = Status::kBudgetOptimise;
    stage.phase = TrajectoryPhase::kFinish;
    return true;
  }
  stage.solve_status = status;
  stage.active_high = most(stage.active_high, stage.solution.active_count);
  stage.phase = TrajectoryPhase::kJudge;
  return true;
}

Segment candidate(const TrajectoryStage& stage, int index) {
  Segment segment{};
  segment.duration = stage.chain.duration[index];
  segment.polyhedron = stage.chain.polyhedron[index];
  for (int k = 0; k < kControlPoints; ++k) segment.points[k] = stage.points[index][k];
  return segment;
}

/// Between states at rest: the whole plan, stretched or shrunk until its peaks meet the limits exactly.
double meet_limits(TrajectoryStage& stage) {
  double factor = 0.0;
  for (int i = 0; i < stage.chain.count; ++i) {
    stage.round.stretch[i] = stretch_to_limits(candidate(stage, i), stage.query.limits);
    factor = larger(factor, stage.round.stretch[i]);
  }
  for (int i = 0; i < stage.chain.count; ++i) factor = larger(factor, kMinDuration / stage.chain.duration[i]);
  return factor;
}

bool keeps_everything(const TrajectoryStage& stage, const Corridor& corridor, double factor) {
  for (int i = 0; i < stage.chain.count; ++i) {
    Segment segment = candidate(stage, i);
    segment.duration *= factor;
    if (!inside(segment, corridor.polyhedra[segment.polyhedron])) return false;
    if (!within_limits(segment, stage.query.limits)) return false;
  }
  return true;
}

double relative_residual(const QpSolution& solution) {
  return larger(larger(solution.stationarity, solution.complementarity), larger(solution.violation, 0.0));
}

void keep_best(TrajectoryStage& stage, double factor) {
  stage.best.found = true;
  stage.best.total = stage.round.duration;
  stage.best.active = stage.solution.active_count;
  stage.best.kkt_residual = relative_residual(stage.solution);
  for (int i = 0; i < stage.chain.count; ++i) {
    stage.best.duration[i] = factor * stage.chain.duration[i];
    for (int k = 0; k < kControlPoints; ++k) stage.best.points[i][k] = stage.points[i][k];
  }
}

/// A solution's plan, where it keeps what it should; a solution that does not is as good as none.
void judge(TrajectoryStage& stage, const Corridor& corridor) {
  const double previous = stage.best.found ? stage.best.total : 0.0;
  stage.round.accepted = false;
  if (stage.solve_status == Status::kOk) {
    read_points(stage.chain, stage.scale, stage.solution, stage.points);
    stage.warm_count = stage.solution.active_count;
    for (int i = 0; i < stage.warm_count; ++i) stage.warm[i] = stage.solution.active[i];
    const double factor = rests(stage.query) ? meet_limits(stage) : 1.0;
    stage.round.duration = factor * chain_duration(stage.chain);
    stage.round.accepted = keeps_everything(stage, corridor, factor);
    if (!stage.round.accepted) stage.solve_status = Status::kNumerical;
    if (stage.round.accepted && (!stage.best.found || stage.round.duration < previous)) keep_best(stage, factor);
  }
  if (!stage.best.found) stage.optimiser = stage.solve_status;
  if (stage.best.found) stage.optimiser = Status::kOk;
  refinement_next(stage.refinement, stage.round, previous, stage.best.duration, stage.chain);
  stage.phase = TrajectoryPhase::kPropose;
}

Status give_out(TrajectoryStage& stage, const Corridor& corridor, Trajectory& out) {
  if (stays(corridor) && rests(stage.query)) {
    stage.quality = Quality::kHover;
    hover(stage.query.start.position, out);
    return Status::kOk;
  }
  if (!stage.best.found) {
    const TrajectoryQuery& query = stage.query;
    const Status status = stop_and_go(corridor, query.start, query.goal, query.limits, out);
    stage.quality = status == Status::kOk ? Quality::kStopAndGo : Quality::kNone;
    return status;
  }
  stage.quality = Quality::kOptimised;
  stage.active = stage.best.active;
  stage.kkt_residual = stage.best.kkt_residual;
  out.count = stage.chain.count;
  for (int i = 0; i < stage.chain.count; ++i) {
    out.segments[i].duration = stage.best.duration[i];
    out.segments[i].polyhedron = stage.chain.polyhedron[i];
    for (int k = 0; k < kControlPoints; ++k) out.segments[i].points[k] = stage.best.points[i][k];
  }
  return Status::kOk;
}

void clear_results(TrajectoryStage& stage) {
  stage.quality = Quality::kNone;
  stage.optimiser = Status::kOk;
  stage.iterations = 0;
  stage.active_high = 0;
  stage.solves = 0;
  stage.longest_solve = 0;
  stage.variables = 0;
  stage.inequalities = 0;
  stage.active = 0;
  stage.kkt_residual = 0.0;
}

}  // namespace

void trajectory_begin(TrajectoryStage& stage, const Corridor& corridor, const TrajectoryQuery& query) noexcept {
  clear_results(stage);
  stage.query = query;
  stage.best.found = false;
  stage.warm_count = 0;
  stage.phase = TrajectoryPhase::kFinish;
  if (stays(corridor) && rests(query)) return;
  if (query.max_iterations == 0) {
    stage.optimiser = Status::kBudgetOptimise;
    return;
  }
  make_chain(corridor, query.start, query.goal, query.limits, stage.chain);
  refinement_begin(stage.refinement, stage.chain, rests(query));
  stage.phase = TrajectoryPhase::kPropose;
}

Status trajectory_advance(TrajectoryStage& stage, const Corridor& corridor, Work& work, Trajectory& out) noexcept {
  for (int pass = 0; pass < kPasses; ++pass) {
    switch (stage.phase) {
      case TrajectoryPhase::kPropose:
        if (!work.take()) return Status::kRunning;
        propose(stage, corridor);
        break;
      case TrajectoryPhase::kSolve:
        if (!solve(stage, work)) return Status::kRunning;
        break;
      case TrajectoryPhase::kJudge:
        if (!work.take()) return Status::kRunning;
        judge(stage, corridor);
        break;
      case TrajectoryPhase::kFinish:
        return give_out(stage, corridor, out);
    }
  }
  return Status::kRunning;
}

}  // namespace tern
