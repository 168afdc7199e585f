// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One iteration of the dual active-set method of Goldfarb and Idnani (Mathematical Programming 27, 1983), in the
// coordinates in which the cost is a distance.
#ifndef TERN_QP_ACTIVE_SET_HPP
#define TERN_QP_ACTIVE_SET_HPP

#include "qp/pricing.hpp"

namespace tern::qp {

/// What became of an iteration.
enum class Step : std::uint8_t {
  kFull,        ///< the entering row is met and active
  kPartial,     ///< an active row left; the entering row is still to be met
  kInfeasible,  ///< no row can leave and none of the unknowns helps: proven, the solution holds the multipliers
  kNoRoom,      ///< kMaxActive rows are active and one more is needed
  kStalled,     ///< the dual objective no longer rises, or a proof did not hold up
};

/// Makes a violated row the entering one.
void enter(const QpProblem& problem, QpSolver& solver, const Candidate& candidate);

/// One step towards meeting the entering row.
Step step(const QpProblem& problem, QpSolver& solver, QpSolution& solution);

/// Puts a row of the warm start into the factor, unless it is not a row of the problem or depends on those before.
void add_warm_row(const QpProblem& problem, QpSolver& solver, const QpRow& row);

/// The working set's optimum as a correction: the step to it from solver.x has basis coordinates solver.projection
/// (to be subtracted from `pull`, in z) and multipliers triangle^-1 projection.
void solve_working_set(const QpProblem& problem, QpSolver& solver, const double* pull);

/// One step of iterative refinement from the residual that measure() left.
void refine(const QpProblem& problem, QpSolver& solver);

}  // namespace tern::qp

#endif
