// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The banded Hessian that the three axes share: H = L L', substitutions with L, and the band of H^-1.
#ifndef TERN_QP_HESSIAN_HPP
#define TERN_QP_HESSIAN_HPP

#include "qp/solver.hpp"

namespace tern::qp {

/// Fills solver.factor. False if H is not finite or, apart from rounding, not positive definite. H needs no diagonal
/// scaling: it would not change Cholesky's factor, apart from rounding.
bool factor_hessian(const QpProblem& problem, QpSolver& solver);

/// out = L^-1 in for interleaved 3-vectors, padding zeroed. `in` and `out` may be the same.
void forward(const QpSolver& solver, const double* in, double* out);

/// solver.x = L'^-1 z.
void unknowns_from(QpSolver& solver, const double* z);

/// solver.row = normal (x) L^-1 beta for a plane's normal and a point's coefficients beta, and entering_squared =
/// |row|^2. Returns the first element that is not zero by structure.
int transform_row(const QpPoint& point, int plane, QpSolver& solver);

/// 1 / |L^-1 beta|, from the band of H^-1; 0 if beta is zero.
double point_inverse_norm(const QpPoint& point, QpSolver& solver);

}  // namespace tern::qp

#endif
