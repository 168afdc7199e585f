// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Rows as (point, plane) pairs: values of points, planes with unit normals, and the rows that no unknown moves.
#ifndef TERN_QP_ROWS_HPP
#define TERN_QP_ROWS_HPP

#include "qp/solver.hpp"

namespace tern::qp {

/// A 3-vector as two lanes of two; the last lane is zero.
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

/// Makes the planes' normals unit and finds out which of them are axes. A zero normal stays zero. False where one is
/// not a number.
bool prepare_normals(const QpProblem& problem, QpSolver& solver);

/// Scales the planes' offsets likewise. False where one is not a number. A plane with a zero normal is met, or
/// violated by 1 where its offset is negative; the latter sets solver.contradictory.
bool prepare_offsets(const QpProblem& problem, QpSolver& solver);

/// Sets the points aside that no unknown moves.
void prepare_points(const QpProblem& problem, QpSolver& solver);

/// 1 / |normal| of a plane; 0 for a zero normal.
double inverse_length(const Halfspace& plane);

/// normal . (point at x) - offset of one unit row.
double unit_violation(const QpProblem& problem, const QpSolver& solver, const QpRow& row);

/// True where the row is one of the problem's: its point and plane meet in a group.
bool is_row(const QpProblem& problem, const QpRow& row);

/// Finds a row whose plane has a zero normal and a negative offset.
bool find_contradiction(const QpProblem& problem, QpRow& row);

}  // namespace tern::qp

#endif
