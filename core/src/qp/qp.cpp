// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "qp/qp.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "qp/operations.hpp"
#include "qp/parts.hpp"

namespace tern {
namespace {

/// Steps of iterative refinement in one solve, at most. One is enough unless the factors are very poor.
constexpr int kMaxRefinements = 2;

void end(QpSolver& solver, Status status) {
  solver.phase = QpPhase::kDone;
  solver.status = status;
}

void clear_point(QpSolver& solver) {
  for (int i = 0; i < solver.unknowns; ++i) {
    for (double& value : solver.x[i]) value = 0.0;
    for (double& value : solver.spread[i]) value = 0.0;
  }
  for (int i = 0; i < solver.stride; ++i) solver.z[i] = 0.0;
}

/// Sets target = -L^-1 f, the minimum of the cost without constraints.
void aim(const QpProblem& problem, QpSolver& solver) {
  for (int i = 0; i < problem.unknowns; ++i) {
    for (int a = 0; a < kQpAxes; ++a) solver.target[kQpAxes * i + a] = -problem.linear[a][i];
  }
  qp::forward(solver, solver.target, solver.target);
}

/// Restarts at x = 0 with the constraints that are active.
void set_out(QpSolver& solver) {
  solver.stalled = 0;
  solver.gain = 0.0;
  solver.worst = 0.0;
  solver.phase = QpPhase::kWarmConstraint;
  clear_point(solver);
  qp::forget_passes(solver);
}

/// Starts over after rounding stopped progress: with no active constraint, and with every entering constraint found by
/// a pass.
void start_over(QpSolver& solver) {
  solver.cautious = true;
  solver.active_count = 0;
  solver.warm_next = solver.warm_count;
  set_out(solver);
}

void start(const QpProblem& problem, QpSolver& solver) {
  solver.iterations = 0;
  solver.refinements = 0;
  solver.cautious = false;
  set_out(solver);
  solver.usable = solver.usable && qp::prepare_offsets(problem, solver);
  if (!solver.usable) return;
  aim(problem, solver);
}

/// Computes the optimum of the working set, at x = 0 as solve_working_set() needs it. Its multipliers decide which
/// constraints stay.
void solve_warm(const QpProblem& problem, QpSolver& solver) {
  solver.spent += qp::triangle_operations(solver);
  qp::solve_working_set(problem, solver, solver.target);
  qp::solve_triangle(solver, solver.projection, solver.multiplier);
}

/// The constraint with the most negative multiplier; -1 if none is negative.
int most_negative(const QpSolver& solver) {
  int constraint = -1;
  double least = 0.0;
  for (int j = 0; j < solver.active_count; ++j) {
    if (solver.multiplier[j] < least) {
      least = solver.multiplier[j];
      constraint = j;
    }
  }
  return constraint;
}

void finish_warm(QpSolver& solver) {
  for (int i = 0; i < solver.stride; ++i) solver.z[i] = solver.target[i];
  solver.spent += qp::basis_operations(solver);
  qp::subtract(solver, solver.projection, solver.z);
  solver.phase = QpPhase::kPrice;
}

void drop_negative(QpSolver& solver) {
  solver.spent += qp::triangle_operations(solver);
  qp::drop_constraint(solver, most_negative(solver), solver.projection);
  qp::solve_triangle(solver, solver.projection, solver.multiplier);
}

/// Goes on if no constraint is violated. The point is the answer if its residuals are small enough; otherwise it is
/// refined and priced again.
void conclude(const QpProblem& problem, QpSolver& solver, QpSolution& solution) {
  qp::measure(problem, solver, solution);
  if (qp::accurate(solution)) return end(solver, Status::kOk);
  if (solver.refinements == kMaxRefinements) return end(solver, Status::kNumerical);
  ++solver.refinements;
  qp::refine(problem, solver);
  qp::forget_passes(solver);
}

void contradict(const QpProblem& problem, QpSolver& solver, const QpConstraint& constraint, QpSolution& solution) {
  qp::measure(problem, solver, solution);
  qp::contradict(problem, constraint, solution);
  end(solver, Status::kInfeasible);
}

void find_entering(const QpProblem& problem, QpSolver& solver, QpSolution& solution) {
  solver.spent += qp::band_operations(solver);
  qp::unknowns_from(solver, solver.z);
  QpConstraint constraint;
  if (solver.contradictory && qp::find_contradiction(problem, constraint))
    return contradict(problem, solver, constraint, solution);
  const qp::Candidate candidate = qp::price(problem, solver);
  if (!candidate.found) return conclude(problem, solver, solution);
  if (candidate.constant) return contradict(problem, solver, candidate.constraint, solution);
  qp::enter(problem, solver, candidate);
  solver.phase = QpPhase::kStep;
}

/// Does everything between two iterations, which is at most a few passes of the constraints.
void settle(const QpProblem& problem, QpSolver& solver, QpSolution& solution) {
  if (solver.phase == QpPhase::kWarmConstraint && solver.warm_next == solver.warm_count) {
    solve_warm(problem, solver);
    solver.phase = QpPhase::kWarmSigns;
  }
  if (solver.phase == QpPhase::kWarmSigns && most_negative(solver) < 0) finish_warm(solver);
  for (int i = 0; i <= kMaxRefinements && solver.phase == QpPhase::kPrice; ++i) {
    find_entering(problem, solver, solution);
  }
}

/// The numbers do not make a valid problem, so nothing is computed from them.
Status refuse(const QpSolver& solver, QpSolution& solution) {
  for (int a = 0; a < kQpAxes; ++a) {
    for (int i = 0; i < solver.unknowns; ++i) solution.x[a][i] = 0.0;
  }
  solution.objective = 0.0;
  solution.active_count = 0;
  solution.stationarity = solution.violation = solution.complementarity = 0.0;
  solution.farkas_residual = solution.farkas_gap = 0.0;
  solution.iterations = 0;
  return Status::kNumerical;
}

void give_up(const QpProblem& problem, QpSolver& solver, Status status, QpSolution& solution) {
  solver.spent += qp::band_operations(solver);
  qp::unknowns_from(solver, solver.z);
  qp::measure(problem, solver, solution);
  end(solver, status);
}

void advance_step(const QpProblem& problem, QpSolver& solver, QpSolution& solution) {
  switch (qp::step(problem, solver, solution)) {
    case qp::Step::kFull:
      solver.phase = QpPhase::kPrice;
      return;
    case qp::Step::kPartial:
      return;
    case qp::Step::kInfeasible:
      return end(solver, Status::kInfeasible);
    case qp::Step::kNoRoom:
      return give_up(problem, solver, Status::kWorkingSetFull, solution);
    case qp::Step::kStalled:
      if (!solver.cautious) return start_over(solver);
      return give_up(problem, solver, Status::kNumerical, solution);
  }
}

void iterate(const QpProblem& problem, QpSolver& solver, QpSolution& solution) {
  ++solver.iterations;
  solver.spent += 2 * ops::kPiece;
  if (solver.phase == QpPhase::kWarmConstraint) {
    qp::add_warm_constraint(problem, solver, solver.warm[solver.warm_next++]);
  } else if (solver.phase == QpPhase::kWarmSigns) {
    drop_negative(solver);
  } else {
    advance_step(problem, solver, solution);
  }
}

}  // namespace

void qp_begin(QpSolver& solver, const QpProblem& problem, const QpConstraint* warm, int warm_count) noexcept {
  solver.unknowns = problem.unknowns;
  solver.dimension = kQpAxes * problem.unknowns;
  solver.stride = qp::padded(solver.dimension);
  solver.active_count = 0;
  solver.warm_next = 0;
  solver.warm_count = warm == nullptr ? 0 : (warm_count < kMaxActive ? warm_count : kMaxActive);
  for (int j = 0; j < solver.warm_count; ++j) solver.warm[j] = warm[j];
  solver.spent = qp::begin_operations(problem);
  solver.usable = qp::factor_hessian(problem, solver);
  qp::forget_lengths(problem, solver);
  qp::prepare_points(problem, solver);
  solver.usable = qp::prepare_normals(problem, solver) && solver.usable;
  start(problem, solver);
}

void qp_abandon(QpSolver& solver, const QpProblem& problem, QpSolution& solution) noexcept {
  const bool entering = solver.phase == QpPhase::kStep;
  give_up(problem, solver, Status::kIterationLimit, solution);
  if (!entering) return;
  const QpConstraint constraint = solver.entering;
  solution.active[solution.active_count] = constraint;
  solution.multiplier[solution.active_count] = solver.entering_multiplier * solver.planes.scale[constraint.plane];
  ++solution.active_count;
}

namespace {

/// Spends the operations since the last iteration.
void settle_work(QpSolver& solver, Work& work) {
  work.spend(solver.spent);
  solver.spent = 0;
}

Status advance(QpSolver& solver, const QpProblem& problem, int most, Work& work, QpSolution& solution) {
  if (!solver.usable) return refuse(solver, solution);
  for (int iteration = 0; iteration <= kMaxQpIterations; ++iteration) {
    settle(problem, solver, solution);
    settle_work(solver, work);
    if (solver.phase == QpPhase::kDone) return solver.status;
    if (is_full(solver.iterations == kMaxQpIterations)) break;
    if (iteration == most || !work.left()) return Status::kRunning;
    iterate(problem, solver, solution);
  }
  give_up(problem, solver, Status::kIterationLimit, solution);
  return solver.status;
}

}  // namespace

Status qp_advance(QpSolver& solver, const QpProblem& problem, Work& work, QpSolution& solution, int most) noexcept {
  const Status status = advance(solver, problem, most, work, solution);
  settle_work(solver, work);
  return status;
}

double qp_lower_bound(const QpSolver& solver) noexcept {
  if (solver.phase != QpPhase::kPrice && solver.phase != QpPhase::kStep) return -kQpNoBound;
  // z minimises the Lagrangian of the current multipliers. Active constraints hold with equality and the entering
  // constraint is violated, so the dual objective is at least the cost at z. That cost is a distance from the target.
  double distance_squared = 0.0;
  double target_squared = 0.0;
  for (int i = 0; i < solver.dimension; ++i) {
    const double off = solver.z[i] - solver.target[i];
    distance_squared += off * off;
    target_squared += solver.target[i] * solver.target[i];
  }
  return 0.5 * (distance_squared - target_squared);
}

}  // namespace tern
