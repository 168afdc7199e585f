// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is claimed of an answer, computed from the problem's own data and not from the solver's factors.
#ifndef TERN_QP_KKT_HPP
#define TERN_QP_KKT_HPP

#include "qp/rows.hpp"

namespace tern::qp {

/// Fills the solution from solver.x and the working set, with its KKT residuals (violation: of the last pricing, which
/// was at the same x). Leaves -(Hx + f + A'y) in solver.row, interleaved.
void measure(const QpProblem& problem, QpSolver& solver, QpSolution& solution);

/// True where the measured residuals are within kOk's tolerances.
bool accurate(const QpSolution& solution);

/// Fills the solution with Farkas multipliers: 1 for the entering row, -ratio where that is positive for the active
/// ones. True where they prove that no feasible point is within kProofRadius times the present point's distance (in the
/// Hessian's metric). Overwrites solver.row.
bool prove_infeasible(const QpProblem& problem, QpSolver& solver, QpSolution& solution);

/// The same for one constant row that is violated; a proof for all points.
void contradict(const QpProblem& problem, const QpRow& row, QpSolution& solution);

}  // namespace tern::qp

#endif
