// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The working set's factor: active rows = basis * triangle, basis with orthonormal columns, triangle upper triangular
// with a positive diagonal. All of it is updated in O(dimension * active rows).
#ifndef TERN_QP_FACTOR_HPP
#define TERN_QP_FACTOR_HPP

#include "qp/solver.hpp"

namespace tern::qp {

/// out = basis' v over [begin, stride), where v is zero before `begin` (a multiple of kPad).
void project(const QpSolver& solver, int begin, const double* v, double* out);

/// v -= basis * coordinates.
void subtract(const QpSolver& solver, const double* coordinates, double* v);

/// Splits solver.row into basis * projection + direction. The direction is orthogonal to the basis to working
/// precision.
void split_row(QpSolver& solver, int begin);

/// out = triangle^-1 in. `in` and `out` may be the same.
void solve_triangle(const QpSolver& solver, const double* in, double* out);

/// out = triangle'^-1 in. `in` and `out` may be the same.
void solve_transposed(const QpSolver& solver, const double* in, double* out);

/// Appends the split row to the working set with the given multiplier. There must be room, and direction must not be
/// zero.
void add_row(QpSolver& solver, const QpRow& row, double multiplier);

/// Removes active row j. `coordinates` (active_count basis coordinates) rotate with the basis. The last of them then
/// belongs to the direction that is no longer spanned, which is left in basis column active_count.
void drop_row(QpSolver& solver, int j, double* coordinates);

}  // namespace tern::qp

#endif
