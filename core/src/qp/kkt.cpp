// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/linear.hpp"
#include "qp/operations.hpp"
#include "qp/parts.hpp"

namespace tern::qp {
namespace {

/// Rounding leaves an A'y that is not zero, so a proof only excludes points within some distance. That distance must be
/// at least this many times the distance of the solver's current point.
constexpr double kProofRadius = 1e3;
/// b'y may be nothing but rounding up to this share of the sum of |y_i b_i|.
constexpr double kGapRounding = 1e-13;

/// b of a constraint in x: offset - normal . (constant part of the point).
double right_side(const QpProblem& problem, const QpConstraint& constraint) {
  const Halfspace& plane = problem.planes[constraint.plane];
  return plane.offset - dot(plane.normal, problem.points[constraint.point].offset);
}

/// out += factor * a, interleaved.
void add_gradient(const QpProblem& problem, const QpConstraint& constraint, double factor, double* out) {
  const QpPoint& point = problem.points[constraint.point];
  const Vector normal = factor * to_vector(problem.planes[constraint.plane].normal);
  for (int t = 0; t < point.terms; ++t) {
    vector_at(out + kQpAxes * (point.first + t)) += point.coefficient[t] * normal;
  }
}

/// solver.gradient = A'y.
void gather_constraints(const QpProblem& problem, QpSolver& solver, const QpSolution& solution) {
  for (int i = 0; i < solver.stride; ++i) solver.gradient[i] = 0.0;
  for (int j = 0; j < solution.active_count; ++j) {
    add_gradient(problem, solution.active[j], solution.multiplier[j], solver.gradient);
  }
}

/// The 3-vector of an unknown, with zero in the last lane.
Value value_at(const double* v) {
  return {load_two(v), Pair{v[2], 0.0}};
}

/// Row i of H times x.
Value multiply(const QpProblem& problem, const QpSolver& solver, int i) {
  Value product = {both(0.0), both(0.0)};
  const auto add = [&](double h, int j) {
    product.low += both(h) * pair(solver.x[j]);
    product.high += both(h) * pair(solver.x[j] + kPair);
  };
  const int left = i < kQpBand ? i : kQpBand;
  const int right = problem.unknowns - 1 - i < kQpBand ? problem.unknowns - 1 - i : kQpBand;
  for (int d = left; d >= 0; --d) add(problem.hessian[i][d], i - d);
  for (int d = 1; d <= right; ++d) add(problem.hessian[i + d][d], i + d);
  return product;
}

Pair size_of(Pair v) {
  return larger_of(v, -v);
}

/// The larger of `so_far` and the squares of a 3-vector's elements times `scale`.
Pair largest_square(const Value& v, double scale, Pair so_far) {
  const Pair s = both(scale);
  return larger_of(v.low * v.low * s, larger_of(v.high * v.high * s, so_far));
}

struct Sums {
  double curvature = 0.0;  ///< x'Hx
  double slope = 0.0;      ///< f'x
};

/// Replaces A'y in solver.gradient by -(Hx + f + A'y).
Sums measure_stationarity(const QpProblem& problem, QpSolver& solver, QpSolution& solution) {
  Value curvature = {both(0.0), both(0.0)};
  Value slope = curvature;
  Pair residual = both(0.0);
  Pair term = both(0.0);
  for (int i = 0; i < problem.unknowns; ++i) {
    double* at = solver.gradient + kQpAxes * i;
    const Value hx = multiply(problem, solver, i);
    const Value f = {{problem.linear[0][i], problem.linear[1][i]}, {problem.linear[2][i], 0.0}};
    const Value ay = value_at(at);
    const Value x = {pair(solver.x[i]), pair(solver.x[i] + kPair)};
    const double scale = 1.0 / problem.hessian[i][0];
    const Value most = {larger_of(larger_of(size_of(hx.low), size_of(f.low)), size_of(ay.low)),
                        larger_of(larger_of(size_of(hx.high), size_of(f.high)), size_of(ay.high))};
    const Value rest = {(hx.low + f.low) + ay.low, (hx.high + f.high) + ay.high};
    term = largest_square(most, scale, term);
    residual = largest_square(rest, scale, residual);
    curvature = {curvature.low + hx.low * x.low, curvature.high + hx.high * x.high};
    slope = {slope.low + f.low * x.low, slope.high + f.high * x.high};
    store_two(-rest.low, at);
    at[2] = -rest.high[0];
  }
  const double largest_term = larger(term[0], term[1]);
  const double largest_residual = larger(residual[0], residual[1]);
  solution.stationarity = largest_term > 0.0 ? square_root(largest_residual / largest_term) : 0.0;
  return {sum(curvature.low + curvature.high), sum(slope.low + slope.high)};
}

double measure_complementarity(const QpProblem& problem, const QpSolver& solver, const QpSolution& solution,
                               const Sums& sums) {
  // The scale includes f'H^-1 f, because all other terms are rounding if the optimum is at the origin.
  const double pull = inner(solver.target, solver.target, 0, solver.stride);
  double scale = larger(pull, larger(absolute(sums.curvature), absolute(sums.slope)));
  double product = 0.0;
  for (int j = 0; j < solution.active_count; ++j) {
    const double slack = unit_violation(problem, solver, solution.active[j]);
    product = larger(absolute(solver.multiplier[j] * slack), product);
    scale = larger(absolute(solution.multiplier[j] * right_side(problem, solution.active[j])), scale);
  }
  return scale > 0.0 ? product / scale : 0.0;
}

void copy_unknowns(const QpSolver& solver, QpSolution& solution) {
  for (int i = 0; i < solver.unknowns; ++i) {
    for (int a = 0; a < kQpAxes; ++a) solution.x[a][i] = solver.x[i][a];
  }
}

void append(const QpProblem& problem, const QpConstraint& constraint, double unit_multiplier, QpSolution& solution) {
  solution.active[solution.active_count] = constraint;
  solution.multiplier[solution.active_count] = unit_multiplier * inverse_length(problem.planes[constraint.plane]);
  ++solution.active_count;
}

/// Scales the multipliers to max y = 1.
void normalise(QpSolution& solution) {
  double most = 0.0;
  for (int j = 0; j < solution.active_count; ++j) most = larger(solution.multiplier[j], most);
  for (int j = 0; j < solution.active_count; ++j) solution.multiplier[j] /= most;
}

/// Writes -b'y to the solution. True if it is positive beyond rounding.
bool measure_gap(const QpProblem& problem, QpSolution& solution) {
  double gap = 0.0;
  double terms = 0.0;
  for (int j = 0; j < solution.active_count; ++j) {
    const double product = solution.multiplier[j] * right_side(problem, solution.active[j]);
    gap -= product;
    terms += absolute(product);
  }
  solution.farkas_gap = gap;
  return gap > kGapRounding * terms;
}

/// Largest element of A'y (in solver.gradient), divided by the largest element of any single y_i a_i.
double certificate_residual(const QpProblem& problem, const QpSolver& solver, const QpSolution& solution) {
  double residual = 0.0;
  for (int i = 0; i < solver.dimension; ++i) {
    residual = larger(solver.gradient[i] * solver.gradient[i] / problem.hessian[i / kQpAxes][0], residual);
  }
  double term = 0.0;
  for (int j = 0; j < solution.active_count; ++j) {
    const QpPoint& point = problem.points[solution.active[j].point];
    const Vec3& normal = problem.planes[solution.active[j].plane].normal;
    const double size = solution.multiplier[j] * solution.multiplier[j] * dot(normal, normal);
    for (int t = 0; t < point.terms; ++t) {
      const double c = point.coefficient[t];
      term = larger(size * c * c / problem.hessian[point.first + t][0], term);
    }
  }
  return term > 0.0 ? square_root(residual / term) : 0.0;
}

}  // namespace

void measure(const QpProblem& problem, QpSolver& solver, QpSolution& solution) {
  solver.spent += measure_operations(solver);
  copy_unknowns(solver, solution);
  solution.active_count = 0;
  for (int j = 0; j < solver.active_count; ++j) append(problem, solver.active[j], solver.multiplier[j], solution);
  gather_constraints(problem, solver, solution);
  const Sums sums = measure_stationarity(problem, solver, solution);
  solution.objective = 0.5 * sums.curvature + sums.slope;
  solution.violation = solver.worst;
  solution.complementarity = measure_complementarity(problem, solver, solution, sums);
  solution.iterations = solver.iterations;
  solution.farkas_residual = 0.0;
  solution.farkas_gap = 0.0;
}

bool accurate(const QpSolution& solution) {
  return solution.stationarity <= kQpStationarity && solution.violation <= kQpViolation &&
         solution.complementarity <= kQpComplementarity && finite(solution.objective);
}

bool prove_infeasible(const QpProblem& problem, QpSolver& solver, QpSolution& solution) {
  solver.spent += measure_operations(solver);
  unknowns_from(solver, solver.z);
  measure(problem, solver, solution);
  solution.active_count = 0;
  for (int j = 0; j < solver.active_count; ++j) {
    if (solver.ratio[j] < 0.0) append(problem, solver.active[j], -solver.ratio[j], solution);
  }
  append(problem, solver.entering, 1.0, solution);
  normalise(solution);
  gather_constraints(problem, solver, solution);
  solution.farkas_residual = certificate_residual(problem, solver, solution);
  const bool positive = measure_gap(problem, solution);
  forward(solver, solver.gradient, solver.gradient);
  const double residual = square_root(inner(solver.gradient, solver.gradient, 0, solver.stride));
  const double here =
      larger(inner(solver.z, solver.z, 0, solver.stride), inner(solver.target, solver.target, 0, solver.stride));
  const double needed = solver.entering_violation * solver.entering_violation / solver.entering_squared;
  return positive && solution.farkas_gap > kProofRadius * residual * square_root(larger(here, needed));
}

void contradict(const QpProblem& problem, const QpConstraint& constraint, QpSolution& solution) {
  solution.active_count = 1;
  solution.active[0] = constraint;
  solution.multiplier[0] = 1.0;
  solution.farkas_residual = 0.0;
  measure_gap(problem, solution);
}

}  // namespace tern::qp
