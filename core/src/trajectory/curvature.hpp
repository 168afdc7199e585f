// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the prices of all segments' time change with all durations. The search learns this from programme to programme,
// by the quasi-Newton method BFGS.
#ifndef TERN_TRAJECTORY_CURVATURE_HPP
#define TERN_TRAJECTORY_CURVATURE_HPP

#include "tern/config.hpp"

namespace tern {

/// Entries of the lower triangle of a matrix with a row for each segment.
constexpr int kTriangle = kMaxSegments * (kMaxSegments + 1) / 2;

/// The second derivatives of the least snap in the logarithms of the durations, m^2/s^7, as far as known. Symmetric and
/// positive definite. Lower triangles, row by row.
struct Curvature {
  double entries[kTriangle];
  double factor[kTriangle];  ///< Cholesky's factor that the last newton_step used
};

/// The sum of a[i] * b[i] for i < count, in the order of i.
inline double sum_of_products(const double* a, const double* b, int count) {
  double sum = 0.0;
  for (int i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

/// Begins with a diagonal matrix, whose entries must be > 0.
void curvature_begin(Curvature& curvature, const double* diagonal, int count) noexcept;

/// Learns that the gradient changed by `change` over `step`. If the curvature along the step is then much less than
/// expected, or negative, only a part of the change is learned (Powell's damping). So the matrix stays positive
/// definite.
void curvature_learn(Curvature& curvature, const double* step, const double* change, int count) noexcept;

/// Multiplies all second derivatives by the factor, > 0.
void curvature_scale(Curvature& curvature, double factor, int count) noexcept;

/// Solves (curvature + diag(extra)) step = descent for the step. extra >= 0.
void newton_step(Curvature& curvature, const double* extra, const double* descent, int count, double* step) noexcept;

/// Solves for the step of another descent, with the factor of the last newton_step.
void solve_curvature(const Curvature& curvature, const double* descent, int count, double* step) noexcept;

}  // namespace tern

#endif
