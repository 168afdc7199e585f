// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rows as (point, plane) pairs: values of points, planes with unit normals, and the rows that depend on no unknown.
#ifndef TERN_QP_ROWS_HPP
#define TERN_QP_ROWS_HPP

#include "qp/solver.hpp"

namespace tern::qp {

/// A 3-vector as two pairs of doubles; the last double is zero.
struct Value {
  Pair low;
  Pair high;
};

/// offset + sum coefficient * x.
inline Value evaluate(const QpPoint& point, const QpSolver& solver) {
  Value value = {{point.offset.x, point.offset.y}, {point.offset.z, 0.0}};
  const double(*x)[4] = solver.x + point.first;
  const double* c = point.coefficient;
  for (const double* const end = c + point.terms; c < end; ++c, ++x) {
    value.low += both(*c) * pair(x[0]);
    value.high += both(*c) * pair(x[0] + kPair);
  }
  return value;
}

/// normal . value - offset.
inline double violation_at(const Value& at, const QpUnitPlanes& planes, int p) {
  return ((planes.normal[0][p] * at.low[0] + planes.normal[1][p] * at.low[1]) + planes.normal[2][p] * at.high[0]) -
         planes.offset[p];
}

/// Makes the normals of the planes unit vectors and finds out which of them are along an axis. A zero normal stays
/// zero. False if one is not finite.
bool prepare_normals(const QpProblem& problem, QpSolver& solver);

/// Divides the offsets of the planes by the lengths of their normals. False if one is not finite. A plane with a zero
/// normal counts as satisfied, or as violated by 1 if its offset is negative, which also sets solver.contradictory.
bool prepare_offsets(const QpProblem& problem, QpSolver& solver);

/// Sets aside the points that depend on no unknown.
void prepare_points(const QpProblem& problem, QpSolver& solver);

/// 1 / |normal| of a plane; 0 for a zero normal.
double inverse_length(const Halfspace& plane);

/// normal . (point at x) - offset of one unit row.
double unit_violation(const QpProblem& problem, const QpSolver& solver, const QpRow& row);

/// True if the problem has this row: its point and plane are in the same group.
bool is_row(const QpProblem& problem, const QpRow& row);

/// Finds a row whose plane has a zero normal and a negative offset.
bool find_contradiction(const QpProblem& problem, QpRow& row);

}  // namespace tern::qp

#endif
