// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Residuals and proofs of an answer, computed from the problem's own data and not from the solver's factors.
#ifndef TERN_QP_KKT_HPP
#define TERN_QP_KKT_HPP

#include "qp/rows.hpp"

namespace tern::qp {

/// Fills the solution from solver.x and the working set, and computes its KKT residuals. The violation is that of the
/// last pricing, which was at the same x. Leaves -(Hx + f + A'y) in solver.row, interleaved.
void measure(const QpProblem& problem, QpSolver& solver, QpSolution& solution);

/// True if the measured residuals are within the tolerances of kOk.
bool accurate(const QpSolution& solution);

/// Fills the solution with Farkas multipliers: 1 for the entering row, and -ratio for each active row if that is
/// positive. True if they prove that no feasible point lies within kProofRadius times the distance of the current point
/// (in the Hessian's metric). Overwrites solver.row.
bool prove_infeasible(const QpProblem& problem, QpSolver& solver, QpSolution& solution);

/// Fills the solution with the Farkas multiplier of one violated constant row, which proves that no point is feasible.
void contradict(const QpProblem& problem, const QpRow& row, QpSolution& solution);

}  // namespace tern::qp

#endif
