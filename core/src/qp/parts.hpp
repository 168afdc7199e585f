// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The parts of the solver, each in a source file of its own: constraints, pricing, residuals, the factor of the active
// constraints, the Hessian, and one iteration.
#ifndef TERN_QP_PARTS_HPP
#define TERN_QP_PARTS_HPP

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

/// normal . (point at x) - offset of one unit constraint.
double unit_violation(const QpProblem& problem, const QpSolver& solver, const QpConstraint& constraint);

/// True if the problem has this constraint: its point and plane are in the same group.
bool is_constraint(const QpProblem& problem, const QpConstraint& constraint);

/// Finds a constraint whose plane has a zero normal and a negative offset.
bool find_contradiction(const QpProblem& problem, QpConstraint& constraint);

// Chooses the constraint that enters: the one that is violated most, measured as a distance in the metric of the
// Hessian. That is violation / |L^-1 a|. With unit normals, the divisor depends only on the constraint's point.

/// A violated constraint; `found` is false if there is none.
struct Candidate {
  bool found;
  bool constant;  ///< the constraint depends on no unknown: nothing can be done about it
  QpConstraint constraint;
  double violation;  ///< of the unit constraint
};

/// Forgets the lengths of the points. Call it if coefficients or Hessian changed.
void forget_lengths(const QpProblem& problem, QpSolver& solver);

/// Forgets which constraints were violated. Call it if the point has jumped or the right-hand sides changed.
void forget_passes(QpSolver& solver);

/// The constraint to enter at solver.x: the best of those priced that are violated by more than kQpEntering. Ties go to
/// the lowest group, then point, then plane. If none is found, every constraint was priced, and solver.worst is the
/// largest violation.
Candidate price(const QpProblem& problem, QpSolver& solver);

// Residuals and proofs of an answer, computed from the problem's own data and not from the solver's factors.

/// Fills the solution from solver.x and the working set, and computes its KKT residuals. The violation is that of the
/// last pricing, which was at the same x. Leaves -(Hx + f + A'y) in solver.gradient, interleaved.
void measure(const QpProblem& problem, QpSolver& solver, QpSolution& solution);

/// True if the measured residuals are within the tolerances of kOk.
bool accurate(const QpSolution& solution);

/// Fills the solution with Farkas multipliers: 1 for the entering constraint, and -ratio for each active constraint if
/// that is positive. True if they prove that no feasible point lies within kProofRadius times the distance of the
/// current point (in the Hessian's metric). Overwrites solver.gradient.
bool prove_infeasible(const QpProblem& problem, QpSolver& solver, QpSolution& solution);

/// Fills the solution with the Farkas multiplier of one violated constant constraint, which proves that no point is
/// feasible.
void contradict(const QpProblem& problem, const QpConstraint& constraint, QpSolution& solution);

// The working set's factor: active constraints = basis * triangle, basis with orthonormal columns, triangle upper
// triangular with a positive diagonal. All of it is updated in O(dimension * active constraints).

/// out = basis' v over [begin, stride), where v is zero before `begin` (a multiple of kPad).
void project(const QpSolver& solver, int begin, const double* v, double* out);

/// v -= basis * coordinates.
void subtract(const QpSolver& solver, const double* coordinates, double* v);

/// Splits solver.gradient into basis * projection + direction. The direction is orthogonal to the basis to working
/// precision.
void split_constraint(QpSolver& solver, int begin);

/// out = triangle^-1 in. `in` and `out` may be the same.
void solve_triangle(const QpSolver& solver, const double* in, double* out);

/// out = triangle'^-1 in. `in` and `out` may be the same.
void solve_transposed(const QpSolver& solver, const double* in, double* out);

/// Appends the split constraint to the working set with the given multiplier. There must be room, and direction must
/// not be zero.
void add_constraint(QpSolver& solver, const QpConstraint& constraint, double multiplier);

/// Removes active constraint j. `coordinates` (active_count basis coordinates) rotate with the basis. The last of them
/// then belongs to the direction that is no longer spanned, which is left in basis column active_count.
void drop_constraint(QpSolver& solver, int j, double* coordinates);

// The banded Hessian that the three axes share: H = L L', substitutions with L, and the band of H^-1.

/// Fills solver.factor. False if H is not finite or, apart from rounding, not positive definite. H needs no diagonal
/// scaling: it would not change Cholesky's factor, apart from rounding.
bool factor_hessian(const QpProblem& problem, QpSolver& solver);

/// out = L^-1 in for interleaved 3-vectors, padding zeroed. `in` and `out` may be the same.
void forward(const QpSolver& solver, const double* in, double* out);

/// solver.x = L'^-1 z.
void unknowns_from(QpSolver& solver, const double* z);

/// solver.gradient = normal (x) L^-1 beta for a plane's normal and a point's coefficients beta, and entering_squared =
/// |constraint|^2. Returns the first element that is not zero by structure.
int transform_constraint(const QpPoint& point, int plane, QpSolver& solver);

/// 1 / |L^-1 beta|, from the band of H^-1; 0 if beta is zero.
double point_inverse_norm(const QpPoint& point, QpSolver& solver);

// One iteration of the dual active-set method of Goldfarb and Idnani (Mathematical Programming 27, 1983), in the
// coordinates z, in which the cost is a distance.

/// Outcome of an iteration.
enum class Step : std::uint8_t {
  kFull,        ///< the entering constraint is satisfied and active
  kPartial,     ///< an active constraint left; the entering constraint is not yet satisfied
  kInfeasible,  ///< no constraint can leave and no unknown helps; proven, with the multipliers in the solution
  kNoRoom,      ///< kMaxActive constraints are active, and one more would be needed
  kStalled,     ///< the dual objective no longer rises, or a proof did not hold up
};

/// Makes a violated constraint the entering constraint.
void enter(const QpProblem& problem, QpSolver& solver, const Candidate& candidate);

/// Makes one step towards satisfying the entering constraint.
Step step(const QpProblem& problem, QpSolver& solver, QpSolution& solution);

/// Puts a constraint of the warm start into the factor, unless the problem has no such constraint or it depends on
/// those before it.
void add_warm_constraint(const QpProblem& problem, QpSolver& solver, const QpConstraint& constraint);

/// Computes the step from solver.x to the optimum of the working set. Its basis coordinates are solver.projection (to
/// be subtracted from `pull`, in z), and its multipliers are triangle^-1 projection.
void solve_working_set(const QpProblem& problem, QpSolver& solver, const double* pull);

/// Makes one step of iterative refinement from the residual that measure() left.
void refine(const QpProblem& problem, QpSolver& solver);

}  // namespace tern::qp

#endif
