// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which row enters: the one that is violated most, measured as a distance in the metric of the Hessian. That is
// violation^2 / |L^-1 a|^2, and the second factor belongs to a row's point alone once normals are unit.
#ifndef TERN_QP_PRICING_HPP
#define TERN_QP_PRICING_HPP

#include "qp/solver.hpp"

namespace tern::qp {

/// A violated row, `found` where there is one.
struct Candidate {
  bool found;
  bool constant;  ///< no unknown moves the row: nothing can be done about it
  QpRow row;
  double violation;  ///< of the unit row
};

/// Makes the planes unit. False where a plane is not a number. A zero normal becomes a unit plane that is met, or
/// violated by 1 where its offset is negative; the latter sets solver.contradictory.
bool prepare_planes(const QpProblem& problem, QpSolver& solver);

/// Forgets what is known of the points' lengths: coefficients or Hessian changed.
void forget_weights(const QpProblem& problem, QpSolver& solver);

/// 1 / |normal| of a plane; 0 for a zero normal.
double inverse_length(const Halfspace& plane);

/// A row whose plane has a zero normal and a negative offset, if some group has one.
Candidate contradiction(const QpProblem& problem);

/// Scans all rows at solver.x: the best to enter among those violated by more than kQpEntering; ties go to the lowest
/// group, then point, then plane. Sets solver.worst.
Candidate price(const QpProblem& problem, QpSolver& solver);

/// normal . (point at x) - offset of one unit row.
double unit_violation(const QpProblem& problem, const QpSolver& solver, const QpRow& row);

/// True where the row is one of the problem's: its point and plane meet in a group.
bool is_row(const QpProblem& problem, const QpRow& row);

}  // namespace tern::qp

#endif
