// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_QP_SOLVER_HPP
#define TERN_QP_SOLVER_HPP

#include "qp/lanes.hpp"
#include "qp/qp.hpp"

namespace tern {

/// Unknowns of all axes as one vector, element 3 i + a, padded.
constexpr int kQpMaxDimension = qp::padded(kQpAxes * kQpMaxUnknowns);
/// Rows that can be active at once: the capacity, or what linear independence leaves.
constexpr int kQpMaxRank = kMaxActive < kQpAxes * kQpMaxUnknowns ? kMaxActive : kQpAxes * kQpMaxUnknowns;
/// Points are scanned in tiles of this many: four registers of two lanes. A group's last tile may be partly empty.
constexpr int kQpTile = 8;
constexpr int kQpMaxTiles = kQpMaxPoints / kQpTile + kQpMaxGroups;
constexpr int kQpPackedRank = kQpMaxRank * (kQpMaxRank + 1) / 2;

/// What qp_advance does next.
enum class QpPhase : std::uint8_t {
  kWarmRow,    ///< put the next row of the warm start into the factor
  kWarmSigns,  ///< drop its rows with negative multipliers
  kPrice,      ///< find the row to enter
  kStep,       ///< move along the entering row's direction
  kDone,
};

/// How a plane's normal lies.
enum class QpFacing : std::uint8_t {
  kUp,       ///< along an axis
  kDown,     ///< against an axis
  kSlab,     ///< in any other direction, and the next plane's is the opposite one
  kOblique,  ///< in any other direction
};

/// A plane with a unit normal: the problem's plane over its normal's length.
struct QpUnitPlane {
  double normal[kQpAxes];
  double offset;
  double scale;  ///< 1 / |normal| of the problem's plane; 0 for a zero normal
  QpFacing facing;
  std::uint8_t axis;  ///< of kUp and kDown
};

/// With H = L L', the solver works on z = L' x, where the cost is a distance: minimise 1/2 |z - target|^2 subject to
/// rows r = normal (x) (L^-1 beta). `basis` (orthonormal) times `triangle` is the matrix whose columns are the active
/// rows; everything of three axes is interleaved, element 3 i + a.
struct QpSolver {
  // Of the Hessian: column i of L below the diagonal, factor[i][d] = L(i + d, i), with 1 / L(i, i) at d = 0; and the
  // band of H^-1, inverse[i][d] = H^-1(i, i + d), made when the first row is priced.
  alignas(16) double factor[kQpMaxUnknowns][kQpBand + 1];
  double inverse[kQpMaxUnknowns][kQpBand + 1];
  alignas(16) double x[kQpMaxUnknowns][4];  ///< 3-vectors padded to two lanes of two
  alignas(16) double target[kQpMaxDimension];
  alignas(16) double z[kQpMaxDimension];

  // Of the rows.
  QpUnitPlane planes[kQpMaxPlanes];
  double inverse_norm[kQpMaxPoints];  ///< 1 / |L^-1 beta| of a point; negative: not yet known; 0: a constant point
  double found[kQpMaxTiles];          ///< of a tile: the worst violation when it was looked at, a distance of z
  int seen[kQpMaxTiles];              ///< of a tile: the scan that looked at it last

  // The working set.
  alignas(16) double basis[kQpMaxRank * kQpMaxDimension];  ///< column j begins at j * stride
  double triangle[kQpPackedRank];                          ///< upper triangle by columns: column j at j (j + 1) / 2
  QpRow active[kQpMaxRank];
  double multiplier[kQpMaxRank];  ///< of the unit rows
  double row_length[kQpMaxRank];  ///< of the transformed unit rows
  double ratio[kQpMaxRank];       ///< triangle^-1 * projection: how fast the multipliers fall

  // The row that enters: row = basis * projection + direction.
  alignas(16) double row[kQpMaxDimension];
  alignas(16) double direction[kQpMaxDimension];
  double projection[kQpMaxRank];
  double cosine[kQpMaxRank];
  double sine[kQpMaxRank];
  QpRow entering;
  double entering_multiplier;
  double entering_violation;
  double entering_squared;   ///< |row|^2
  double direction_squared;  ///< |direction|^2

  QpRow warm[kMaxActive];
  double entered;  ///< violation of the row that the last scan found, a distance of z
  double worst;    ///< largest violation at x, of the last pricing
  double gain;     ///< how far the dual objective has risen
  int unknowns;    ///< per axis
  int dimension;   ///< 3 * unknowns
  int stride;      ///< dimension, padded
  int active_count;
  int warm_count;
  int warm_next;
  int iterations;
  int scans;
  int stalled;  ///< full steps in a row that raised the dual objective by rounding at most
  int refinements;
  bool inverse_known;
  bool contradictory;  ///< a zero normal with a negative offset exists
  bool usable;         ///< the factors are of a problem of numbers with a positive definite Hessian
  QpPhase phase;
  Status status;  ///< where phase is kDone
};

}  // namespace tern

#endif
