// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One iteration of the dual active-set method of Goldfarb and Idnani (Mathematical Programming 27, 1983), in the
// coordinates z, in which the cost is a distance.
#ifndef TERN_QP_ACTIVE_SET_HPP
#define TERN_QP_ACTIVE_SET_HPP

#include "qp/pricing.hpp"

namespace tern::qp {

/// Outcome of an iteration.
enum class Step : std::uint8_t {
  kFull,        ///< the entering row is satisfied and active
  kPartial,     ///< an active row left; the entering row is not yet satisfied
  kInfeasible,  ///< no row can leave and no unknown helps; proven, with the multipliers in the solution
  kNoRoom,      ///< kMaxActive rows are active, and one more would be needed
  kStalled,     ///< the dual objective no longer rises, or a proof did not hold up
};

/// Makes a violated row the entering row.
void enter(const QpProblem& problem, QpSolver& solver, const Candidate& candidate);

/// Makes one step towards satisfying the entering row.
Step step(const QpProblem& problem, QpSolver& solver, QpSolution& solution);

/// Puts a row of the warm start into the factor, unless the problem has no such row or it depends on those before it.
void add_warm_row(const QpProblem& problem, QpSolver& solver, const QpRow& row);

/// Computes the step from solver.x to the optimum of the working set. Its basis coordinates are solver.projection (to
/// be subtracted from `pull`, in z), and its multipliers are triangle^-1 projection.
void solve_working_set(const QpProblem& problem, QpSolver& solver, const double* pull);

/// Makes one step of iterative refinement from the residual that measure() left.
void refine(const QpProblem& problem, QpSolver& solver);

}  // namespace tern::qp

#endif
