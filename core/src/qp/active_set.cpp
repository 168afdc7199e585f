// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/capacity.hpp"
#include "base/math.hpp"
#include "qp/operations.hpp"
#include "qp/parts.hpp"

namespace tern::qp {
namespace {

/// A constraint depends on the active constraints if less than this share of its squared length lies outside their
/// span. Rounding in L leaves about 1e-11 of the length at 16 segments.
constexpr double kDependent = 1e-18;
/// Below this share of the constraint's squared length, the direction is nothing but rounding.
constexpr double kRounding = 1e-26;
/// Constraints of a warm start must be better conditioned, because leaving one out costs only an iteration.
constexpr double kWarmDependent = 1e-12;
/// A ratio counts as positive above this share of the entering constraint's length over the active one's.
constexpr double kRatioTolerance = 1e-12;
/// A full step that raises the dual objective by less than this share is rounding. More than kMaxStalled of them in a
/// constraint are a stall.
constexpr double kNoGain = 1e-15;
constexpr int kMaxStalled = 100;

struct Limit {
  double length;
  int constraint;  ///< -1: no multiplier of an active constraint falls to zero
};

/// The growth of the entering multiplier at which the first multiplier of an active constraint is zero. Of equals, the
/// constraint that was added first.
Limit dual_limit(const QpSolver& solver) {
  const double scale = kRatioTolerance * square_root(solver.entering_squared);
  Limit limit = {0.0, -1};
  for (int j = 0; j < solver.active_count; ++j) {
    if (!(solver.ratio[j] * solver.constraint_length[j] > scale)) continue;
    const double length = solver.multiplier[j] / solver.ratio[j];
    if (limit.constraint < 0 || length < limit.length) limit = {length, j};
  }
  return limit;
}

void move_multipliers(QpSolver& solver, double length) {
  for (int j = 0; j < solver.active_count; ++j) {
    solver.multiplier[j] = larger(0.0, solver.multiplier[j] - length * solver.ratio[j]);
  }
  solver.entering_multiplier += length;
}

/// Moves z and updates the entering constraint's violation. Returns the rise of the dual objective.
double move_point(QpSolver& solver, double length) {
  add_scaled(-length, solver.direction, solver.z, 0, solver.stride);
  const double before = solver.entering_violation;
  solver.entering_violation = before - length * solver.direction_squared;
  return 0.5 * length * (before + solver.entering_violation);
}

/// Drops the constraint, and adds to the direction the part that this constraint had blocked.
void leave(QpSolver& solver, int constraint) {
  drop_constraint(solver, constraint, solver.projection);
  const int last = solver.active_count;
  const double* freed = solver.basis + last * solver.stride;
  add_scaled(solver.projection[last], freed, solver.direction, 0, solver.stride);
  solver.direction_squared = inner(solver.direction, solver.direction, 0, solver.stride);
}

bool stalls(QpSolver& solver, double rise) {
  const bool gains = rise > kNoGain * solver.gain;
  solver.gain += rise;
  solver.stalled = gains ? 0 : solver.stalled + 1;
  return solver.stalled > kMaxStalled;
}

Step finish_step(QpSolver& solver, double length) {
  move_multipliers(solver, length);
  const double rise = move_point(solver, length);
  add_constraint(solver, solver.entering, solver.entering_multiplier);
  return stalls(solver, rise) ? Step::kStalled : Step::kFull;
}

Step partial_step(QpSolver& solver, const Limit& limit, bool dependent) {
  move_multipliers(solver, limit.length);
  if (!dependent) solver.gain += move_point(solver, limit.length);
  leave(solver, limit.constraint);
  return Step::kPartial;
}

}  // namespace

void enter(const QpProblem& problem, QpSolver& solver, const Candidate& candidate) {
  solver.spent += band_operations(solver);
  const int begin =
      transform_constraint(problem.points[candidate.constraint.point], candidate.constraint.plane, solver);
  split_constraint(solver, begin);
  solver.entering = candidate.constraint;
  solver.entering_multiplier = 0.0;
  solver.entering_violation = candidate.violation;
}

Step step(const QpProblem& problem, QpSolver& solver, QpSolution& solution) {
  const int k = solver.active_count;
  solver.spent += triangle_operations(solver) + ops::kTurn * k + 2 * ops::kElement * solver.stride;
  solve_triangle(solver, solver.projection, solver.ratio);
  const Limit limit = dual_limit(solver);
  const bool full_rank = k == solver.dimension;
  const bool dependent = full_rank || !(solver.direction_squared > kDependent * solver.entering_squared);
  if (dependent && limit.constraint >= 0) return partial_step(solver, limit, true);
  if (dependent) {
    if (prove_infeasible(problem, solver, solution)) return Step::kInfeasible;
    if (full_rank || !(solver.direction_squared > kRounding * solver.entering_squared)) return Step::kStalled;
  }
  const double length = solver.entering_violation / solver.direction_squared;
  if (limit.constraint >= 0 && limit.length < length) return partial_step(solver, limit, false);
  if (is_full(k == kQpMaxRank)) return Step::kNoRoom;
  return finish_step(solver, length);
}

void add_warm_constraint(const QpProblem& problem, QpSolver& solver, const QpConstraint& constraint) {
  solver.spent += ops::kTurn * problem.group_count;
  if (is_full(solver.active_count == kQpMaxRank) || !is_constraint(problem, constraint)) return;
  enter(problem, solver, {true, false, constraint, 0.0});
  if (solver.direction_squared > kWarmDependent * solver.entering_squared) add_constraint(solver, constraint, 0.0);
}

void solve_working_set(const QpProblem& problem, QpSolver& solver, const double* pull) {
  const int k = solver.active_count;
  solver.spent += kConstraintOperations * k + triangle_operations(solver) + basis_operations(solver);
  for (int j = 0; j < k; ++j) solver.ratio[j] = -unit_violation(problem, solver, solver.active[j]);
  solve_transposed(solver, solver.ratio, solver.ratio);
  project(solver, 0, pull, solver.projection);
  for (int j = 0; j < k; ++j) solver.projection[j] -= solver.ratio[j];
}

void refine(const QpProblem& problem, QpSolver& solver) {
  solver.spent += band_operations(solver) + basis_operations(solver) + triangle_operations(solver);
  forward(solver, solver.gradient, solver.gradient);
  solve_working_set(problem, solver, solver.gradient);
  subtract(solver, solver.projection, solver.gradient);
  add_scaled(1.0, solver.gradient, solver.z, 0, solver.stride);
  solve_triangle(solver, solver.projection, solver.ratio);
  for (int j = 0; j < solver.active_count; ++j) {
    solver.multiplier[j] = larger(0.0, solver.multiplier[j] + solver.ratio[j]);
  }
}

}  // namespace tern::qp
