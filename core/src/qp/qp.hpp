// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A strictly convex quadratic programme whose three blocks of unknowns share one banded Hessian and whose constraints
// keep affine points inside half-spaces. Nothing here knows what the unknowns mean.
//
//   minimise    sum over the axes a = 0, 1, 2 of   1/2 x_a' H x_a + f_a' x_a
//   subject to  normal_p . (offset_k + sum_i coefficient_ki x_(first_k + i)) <= bound_p
//               for every group g, every point k of g and every plane p of g
//
// where x_(i) is the 3-vector of the i-th unknown of every axis. A constraint is a (point, plane) pair of a group.
// Constraints are never stored: 8 points and 20 planes cost 28 records, not 160.
#ifndef TERN_QP_QP_HPP
#define TERN_QP_QP_HPP

#include <cstdint>

#include "base/work.hpp"
#include "tern/config.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"

namespace tern {

constexpr int kQpAxes = 3;
constexpr int kQpBand = 7;                                  ///< half bandwidth of H: 4x4 blocks, block-tridiagonal
constexpr int kQpMaxUnknowns = 4 * (kMaxSegments - 1) + 2;  ///< per axis; 2 for jerks left free at both ends
constexpr int kQpPointTerms = 8;                            ///< unknowns that one point may depend on
/// Positions, velocities on halves, accelerations on quarters, jerks on halves.
constexpr int kQpPointsPerSegment = 8 + 13 + 21 + 9;
constexpr int kQpMaxPoints = kMaxSegments * kQpPointsPerSegment + kMaxVias + 8 * kMaxSeparations;
/// Instants of a segment at which a limit on body rates has rows of its own, and their planes: one below the thrust,
/// four around the jerk.
constexpr int kQpTurningInstants = 9;
constexpr int kQpTurningPlanes = 5;
constexpr int kQpMaxGroups = (4 + 2 * kQpTurningInstants) * kMaxSegments + kMaxVias + kMaxSeparations;
/// Planes of the limits on thrust and tilt.
constexpr int kQpThrustPlanes = 7 * 16;
/// Polyhedra and body rates; velocity, acceleration, thrust and jerk limits; cubes around vias.
constexpr int kQpMaxPlanes = kMaxSegments * (kMaxPlanes + kQpTurningInstants * kQpTurningPlanes) + 3 * 22 +
                             kQpThrustPlanes + 6 * kMaxVias + kMaxSeparations;

/// An affine function of the unknowns with values in R^3: offset + sum_i coefficient[i] * x_(first + i), i < terms.
/// terms = 0 makes a constant point, whose constraints can only be checked.
struct QpPoint {
  double coefficient[kQpPointTerms];
  Vec3 offset;
  std::int16_t first;
  std::int16_t terms;
};

/// All points of [point_begin, point_end) must be inside all planes of [plane_begin, plane_end).
struct QpGroup {
  std::int32_t point_begin;
  std::int32_t point_end;
  std::int32_t plane_begin;
  std::int32_t plane_end;
};

/// One constraint of the programme.
struct QpConstraint {
  std::int32_t point;
  std::int32_t plane;
};

/// The data. The caller owns it and fills it in; the solver does not change it.
struct QpProblem {
  int unknowns;                                 ///< per axis, 0 .. kQpMaxUnknowns
  double hessian[kQpMaxUnknowns][kQpBand + 1];  ///< lower band: hessian[i][d] = H(i, i - d); 0 outside the matrix
  double linear[kQpAxes][kQpMaxUnknowns];       ///< f
  int point_count;
  QpPoint points[kQpMaxPoints];
  int plane_count;
  Halfspace planes[kQpMaxPlanes];  ///< normals need not be unit vectors; a zero normal is decided exactly
  int group_count;
  QpGroup groups[kQpMaxGroups];
};

/// A constraint enters the working set if it is violated by more than this (in the constraint's unit over |normal|:
/// metres).
constexpr double kQpEntering = 5e-10;
/// If a solve ends in kOk, the residuals, computed from the problem's own data, do not exceed these.
constexpr double kQpViolation = 1e-9;
constexpr double kQpStationarity = 1e-8;
constexpr double kQpComplementarity = 1e-8;

/// The answer. kOk: x is optimal, its KKT residuals were computed from the problem's own data and are below tolerance.
struct QpSolution {
  double x[kQpAxes][kQpMaxUnknowns];
  double objective;  ///< 1/2 x'Hx + f'x at x
  int active_count;
  QpConstraint
      active[kMaxActive + 1];  ///< working set, in the factor's order; a proof of infeasibility has one constraint more
  double multiplier[kMaxActive + 1];  ///< >= 0, of the constraints as given (not normalised)
  double stationarity;                ///< max |Hx + f + A'y| over the largest of |Hx|, |f|, |A'y|, each over sqrt(H_ii)
  double violation;  ///< max of 0 and a'x - b over all constraints, in the constraints' unit over |normal| (metres)
  double complementarity;  ///< max |y_i (a_i'x - b_i)| over the largest of f'H^-1 f, |x'Hx|, |f'x|, |y_i b_i|
  int iterations;          ///< warm constraints tried, constraints entered, constraints dropped
  /// kInfeasible: multipliers y >= 0 of `active` with |A'y| ~ 0 and b'y < 0 (Farkas), scaled to max y = 1.
  double farkas_residual;  ///< max |A'y| over the largest |y_i a_i|, each over sqrt(H_ii)
  double farkas_gap;       ///< -b'y > 0
};

/// The solver's state: an opaque part of the workspace. Plain data; needs no initialisation before qp_begin.
struct QpSolver;

/// Starts a solve. `warm` may name constraints to start from; null is a cold start. Any constraints are allowed, and
/// unsuitable ones are dropped. The problem must not change until the solve ends. The caller guarantees valid counts
/// and indices; the solver checks the numbers.
void qp_begin(QpSolver& solver, const QpProblem& problem, const QpConstraint* warm, int warm_count) noexcept;

/// Runs iterations, at most `most`; a piece of work is one of them. Returns kRunning until the end, then kOk,
/// kInfeasible (proven), kIterationLimit, kWorkingSetFull or kNumerical. Fills `solution` at the end. Unless kOk, its x
/// is not feasible, because the method is dual. The first call also spends the work of qp_begin().
Status qp_advance(QpSolver& solver, const QpProblem& problem, Work& work, QpSolution& solution,
                  int most = kMaxQpIterations) noexcept;

/// A lower bound during a solve: apart from rounding, no feasible x has an objective below it. It rises from step to
/// step, without limit if the problem is infeasible. -kQpNoBound while a warm start is being built, and after the solve
/// has ended.
double qp_lower_bound(const QpSolver& solver) noexcept;
constexpr double kQpNoBound = 1e300;

/// Ends a solve for which qp_lower_bound() has a bound, and fills `solution` with the x and the multipliers of that
/// bound.
void qp_abandon(QpSolver& solver, const QpProblem& problem, QpSolution& solution) noexcept;

}  // namespace tern

#endif
