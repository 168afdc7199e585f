// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/linear.hpp"
#include "qp/parts.hpp"

namespace tern::qp {
namespace {

/// A pivot, positive or negative, is mostly rounding if its magnitude is below this share of its diagonal element.
constexpr double kPivotRounding = 1e-13;
/// A pivot that is mostly rounding is raised to at least this share of its diagonal element.
constexpr double kPivotFloor = 1e-15;
/// A raised pivot is so large that its column subtracts at most 1 / kPivotShare of any other diagonal element.
constexpr double kPivotShare = 4.0;

/// Below this share of its diagonal terms, beta' H^-1 beta is lost in rounding. The value only steers pricing.
constexpr double kNormFloor = 1e-12;
/// Replaces a squared length that overflowed, so that such a point does not count as constant.
constexpr double kNormCeiling = 1e300;

/// Number of elements of column i of L below its diagonal.
int reach_of(int i, int n) {
  return n - 1 - i < kQpBand ? n - 1 - i : kQpBand;
}

void load_columns(const QpProblem& problem, QpSolver& solver) {
  const int n = problem.unknowns;
  for (int i = 0; i < n; ++i) {
    const int reach = reach_of(i, n);
    for (int d = 0; d <= reach; ++d) solver.factor[i][d] = problem.hessian[i + d][d];
    for (int d = reach + 1; d <= kQpBand; ++d) solver.factor[i][d] = 0.0;
  }
}

/// Subtracts the contribution of a column from the columns to its right. The column is still that of L times the square
/// root of its pivot, so that the next pivot need not wait for that square root.
template <int kReach>
void eliminate(QpSolver& solver, int i, double inverse_pivot) {
  const double* column = solver.factor[i];
  for (int d = 1; d <= kReach; ++d) {
    double* target = solver.factor[i + d];
    const double multiple = column[d] * inverse_pivot;
    for (int e = 0; e <= kReach - d; ++e) target[e] -= multiple * column[d + e];
  }
}

void eliminate(QpSolver& solver, int i, int reach, double inverse_pivot) {
  if (reach == kQpBand) return eliminate<kQpBand>(solver, i, inverse_pivot);
  const double* column = solver.factor[i];
  for (int d = 1; d <= reach; ++d) {
    double* target = solver.factor[i + d];
    const double multiple = column[d] * inverse_pivot;
    for (int e = 0; e <= reach - d; ++e) target[e] -= multiple * column[d + e];
  }
}

/// Makes pivot i safe to divide by. False if H is not finite or, apart from rounding, not positive definite. Raising a
/// pivot that is rounding changes H no more than rounding already did, and answers are judged by residuals of the
/// original H.
bool secure_pivot(const QpProblem& problem, QpSolver& solver, int i, int reach) {
  const double diagonal = problem.hessian[i][0];
  double* column = solver.factor[i];
  if (!(diagonal > 0.0) || !finite(column[0])) return false;
  if (column[0] > kPivotRounding * diagonal) return true;
  if (!(column[0] > -kPivotRounding * diagonal)) return false;
  column[0] = larger(column[0], kPivotFloor * diagonal);
  for (int d = 1; d <= reach; ++d) {
    const double other = solver.factor[i + d][0];
    if (other > 0.0) column[0] = larger(column[0], kPivotShare * column[d] * column[d] / other);
  }
  return finite(column[0]);
}

/// Takahashi's recurrence: computes row i of H^-1 within the band from the rows below it.
void inverse_row(QpSolver& solver, int i, int reach) {
  const double* column = solver.factor[i];
  double* row = solver.inverse[i];
  for (int j = reach; j >= 1; --j) {
    double total = 0.0;
    for (int d = 1; d <= j; ++d) total += column[d] * solver.inverse[i + d][j - d];
    for (int d = j + 1; d <= reach; ++d) total += column[d] * solver.inverse[i + j][d - j];
    row[j] = -column[0] * total;
  }
  double total = 0.0;
  for (int d = 1; d <= reach; ++d) total += column[d] * row[d];
  row[0] = column[0] * (column[0] - total);
}

void invert_band(QpSolver& solver) {
  const int n = solver.unknowns;
  for (int i = n - 1; i >= 0; --i) inverse_row(solver, i, reach_of(i, n));
  solver.inverse_known = true;
}

}  // namespace

bool factor_hessian(const QpProblem& problem, QpSolver& solver) {
  load_columns(problem, solver);
  const int n = problem.unknowns;
  for (int i = 0; i < n; ++i) {
    double* column = solver.factor[i];
    const int reach = reach_of(i, n);
    if (!secure_pivot(problem, solver, i, reach)) return false;
    eliminate(solver, i, reach, 1.0 / column[0]);
    column[0] = 1.0 / square_root(column[0]);
    for (int d = 1; d <= kQpBand; ++d) column[d] *= column[0];
  }
  return true;
}

void forward(const QpSolver& solver, const double* in, double* out) {
  const int n = solver.unknowns;
  for (int i = 0; i < kQpAxes * n; ++i) out[i] = in[i];
  for (int i = kQpAxes * n; i < solver.stride; ++i) out[i] = 0.0;
  for (int i = 0; i < n; ++i) {
    const double* column = solver.factor[i];
    double* const at = out + kQpAxes * i;
    const Vector solved = column[0] * vector_at(at);
    vector_at(at) = solved;
    const int reach = reach_of(i, n);
    for (int d = 1; d <= reach; ++d) vector_at(at + kQpAxes * d) -= column[d] * solved;
  }
}

namespace {

/// Subtracts column i of the factor times the `reach` unknowns after i from an unknown's 3-vector. The nearest unknown
/// comes last, because it was computed just before.
inline void subtract_later(const QpSolver& solver, int i, int reach, Pair& low, Pair& high) {
  const double* const column = solver.factor[i];
  const double(*const later)[4] = solver.x + i;
  for (int d = reach; d >= 1; --d) {
    low -= both(column[d]) * pair(later[d]);
    high -= both(column[d]) * pair(later[d] + kPair);
  }
}

}  // namespace

void unknowns_from(QpSolver& solver, const double* z) {
  const int n = solver.unknowns;
  for (int i = n - 1; i >= 0; --i) {
    Pair low = {z[kQpAxes * i], z[kQpAxes * i + 1]};
    Pair high = {z[kQpAxes * i + 2], 0.0};
    // Nearly all columns have the whole band: with a constant, the loop is unrolled.
    if (n - 1 - i >= kQpBand) {
      subtract_later(solver, i, kQpBand, low, high);
    } else {
      subtract_later(solver, i, n - 1 - i, low, high);
    }
    const double inverse = solver.factor[i][0];
    low *= both(inverse);
    high *= both(inverse);
    pair(solver.x[i]) = low;
    pair(solver.x[i] + kPair) = high;
    pair(solver.spread[i]) = both(low[0]);
    pair(solver.spread[i] + kPair) = both(low[1]);
    pair(solver.spread[i] + 2 * kPair) = both(high[0]);
  }
}

int transform_constraint(const QpPoint& point, int plane, QpSolver& solver) {
  const QpUnitPlanes& planes = solver.planes;
  const Vector normal(planes.normal[0][plane], planes.normal[1][plane], planes.normal[2][plane]);
  const int begin = kQpAxes * point.first;
  double window[kQpBand + 1] = {};
  for (int t = 0; t < point.terms; ++t) window[t] = point.coefficient[t];
  for (int i = 0; i < begin; ++i) solver.gradient[i] = 0.0;
  double squared = 0.0;
  for (int i = point.first; i < solver.unknowns; ++i) {
    const double* column = solver.factor[i];
    const double w = window[0] * column[0];
    vector_at(solver.gradient + kQpAxes * i) = w * normal;
    squared += w * w;
    for (int d = 1; d <= kQpBand; ++d) window[d - 1] = window[d] - column[d] * w;
    window[kQpBand] = 0.0;
  }
  for (int i = solver.dimension; i < solver.stride; ++i) solver.gradient[i] = 0.0;
  solver.entering_squared = squared;  // the normal is unit
  return begin / kPad * kPad;
}

double point_inverse_norm(const QpPoint& point, QpSolver& solver) {
  if (!solver.inverse_known) invert_band(solver);
  double diagonal = 0.0;
  double coupling = 0.0;
  for (int i = 0; i < point.terms; ++i) {
    const double* row = solver.inverse[point.first + i];
    const double beta = point.coefficient[i];
    double total = 0.0;
    for (int d = 1; d < point.terms - i; ++d) total += row[d] * point.coefficient[i + d];
    diagonal += beta * beta * row[0];
    coupling += beta * total;
  }
  if (diagonal <= 0.0) return 0.0;
  const double squared = larger(diagonal + 2.0 * coupling, kNormFloor * diagonal);
  return 1.0 / square_root(finite(squared) ? squared : kNormCeiling);
}

}  // namespace tern::qp
