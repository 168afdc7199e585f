// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_QP_SOLVER_HPP
#define TERN_QP_SOLVER_HPP

#include "qp/lanes.hpp"
#include "qp/qp.hpp"

namespace tern {

/// Unknowns of all axes as one vector, element 3 i + a, padded.
constexpr int kQpMaxDimension = qp::padded(kQpAxes * kQpMaxUnknowns);
/// Constraints that can be active at once: limited by the capacity, and by linear independence.
constexpr int kQpMaxRank = kMaxActive < kQpAxes * kQpMaxUnknowns ? kMaxActive : kQpAxes * kQpMaxUnknowns;
/// Points are priced in batches of this many. A group's last batch may be partly empty.
constexpr int kQpBatch = 8;
constexpr int kQpMaxBatches = (kQpMaxPoints + 21 * kMaxSegments) / kQpBatch + kQpMaxGroups;

/// Index at which column j of a packed upper triangle begins. Each column has an even length, so that pairs are
/// aligned.
constexpr int packed_column(int j) {
  return 2 * (j / 2 + 1) * (j / 2 + j % 2);
}

/// The next work of qp_advance().
enum class QpPhase : std::uint8_t {
  kWarmConstraint,  ///< put the next warm constraint into the factor
  kWarmSigns,       ///< drop warm constraints with negative multipliers
  kPrice,           ///< find the constraint to enter
  kStep,            ///< move along the entering constraint's direction
  kDone,
};

/// The problem's planes, divided by the lengths of their normals, stored by coordinate.
struct QpUnitPlanes {
  double normal[kQpAxes][kQpMaxPlanes];
  double offset[kQpMaxPlanes];
  double scale[kQpMaxPlanes];      ///< 1 / |normal| of the problem's plane; 0 for a zero normal
  bool slab[kQpMaxPlanes];         ///< the next plane's normal is the opposite one
  std::int8_t axis[kQpMaxPlanes];  ///< axis of each plane of a box: 0 .. 2 for +x, +y, +z; 3 .. 5 for -x, -y, -z
  bool zeros;                      ///< some normal is zero
};

/// The data of a group that a pass reads.
struct QpScreen {
  // The first planes of the group, whose normals are along axes, as one box. Every bound is stored twice, as a pair.
  alignas(16) double low[kQpAxes][2];
  alignas(16) double high[kQpAxes][2];
  std::int32_t oblique;  ///< the first plane that is not in the box
  // The group's points but for those at its ends that depend on no unknown. These are priced once a solve.
  std::int32_t moving_begin;
  std::int32_t moving_end;
};

/// The result of the last pricing of a batch.
struct QpPrice {
  double distance;  ///< violation of the batch's most violated constraint, as a distance in z; 0 if none was violated
  std::int32_t point;  ///< point of that constraint
  std::int32_t group;
  std::int32_t pass;  ///< number of that pass
};

/// With H = L L', the solver works on z = L' x, where the cost is a distance: minimise 1/2 |z - target|^2 subject to
/// constraints r = normal (x) (L^-1 beta). `basis` (orthonormal) times `triangle` is the matrix whose columns are the
/// active constraints; everything that has three axes is interleaved, with element 3 i + a.
struct QpSolver {
  // The Hessian. factor[i] is column i of L below the diagonal: factor[i][d] = L(i + d, i), with 1 / L(i, i) at d = 0.
  // The band of H^-1 is inverse[i][d] = H^-1(i, i + d), computed when the first constraint is priced.
  alignas(16) double factor[kQpMaxUnknowns][kQpBand + 1];
  double inverse[kQpMaxUnknowns][kQpBand + 1];
  alignas(16) double x[kQpMaxUnknowns][4];                 ///< 3-vectors padded to two lanes of two
  alignas(16) double spread[kQpMaxUnknowns][2 * kQpAxes];  ///< x with every element twice
  alignas(16) double target[kQpMaxDimension];
  alignas(16) double z[kQpMaxDimension];

  // The constraints.
  QpUnitPlanes planes;
  QpScreen screens[kQpMaxGroups];
  double inverse_norm[kQpMaxPoints];  ///< 1 / |L^-1 beta| of a point; negative: not yet known; 0: a constant point
  QpPrice prices[kQpMaxBatches];

  // The active constraints.
  alignas(16) double basis[kQpMaxRank * kQpMaxDimension];  ///< column j begins at j * stride
  alignas(16) double triangle[packed_column(kQpMaxRank)];  ///< upper triangle by columns, see packed_column()
  QpConstraint active[kQpMaxRank];
  alignas(16) double multiplier[kQpMaxRank];  ///< of the unit constraints
  double constraint_length[kQpMaxRank];       ///< of the transformed unit constraints
  double inverse_diagonal[kQpMaxRank];        ///< of the triangle
  alignas(16) double ratio[kQpMaxRank];       ///< triangle^-1 * projection: the rate at which multipliers fall

  // The entering constraint: constraint = basis * projection + direction.
  alignas(16) double gradient[kQpMaxDimension];
  alignas(16) double direction[kQpMaxDimension];
  double projection[kQpMaxRank];
  double cosine[kQpMaxRank];
  double sine[kQpMaxRank];
  QpConstraint entering;
  double entering_multiplier;
  double entering_violation;
  double entering_squared;   ///< |constraint|^2
  double direction_squared;  ///< |direction|^2

  QpConstraint warm[kMaxActive];
  double entered;         ///< violation of the constraint found last, as a distance in z
  double worst;           ///< largest violation at x in the last pass
  double constant_worst;  ///< largest violation of points that depend on no unknown, in the first pass
  double gain;            ///< rise of the dual objective so far
  int unknowns;           ///< per axis
  int dimension;          ///< 3 * unknowns
  int stride;             ///< dimension, padded
  int active_count;
  int warm_count;
  int warm_next;
  int iterations;
  int passes;
  int batches;       ///< counted by the last pass
  Operations spent;  ///< since the last iteration
  int stalled;       ///< full steps in a row that raised the dual objective by no more than rounding
  int refinements;
  bool inverse_known;
  bool cautious;       ///< started over after a stall
  bool found_by_pass;  ///< the last constraint to enter was found by a pass
  bool contradictory;  ///< a zero normal with a negative offset exists
  bool usable;         ///< the problem is finite, its Hessian positive definite, and the factors are valid
  QpPhase phase;
  Status status;  ///< set if phase is kDone
};

}  // namespace tern

#endif
