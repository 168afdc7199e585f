// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How the prices of all segments' time change with all durations, learned from programme to programme: the quasi-Newton
// method BFGS.
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
  double factor[kTriangle];  ///< what the last step was solved with
};

inline double sum_of_products(const double* a, const double* b, int count) {
  double sum = 0.0;
  for (int i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

/// Knows nothing yet but the diagonal, > 0.
void curvature_begin(Curvature& curvature, const double* diagonal, int count) noexcept;

/// Learns that the gradient changed by `change` over `step`. Where that says that the curvature along the step is much
/// less than thought, or negative, it learns a part of it only (Powell's damping), and so stays positive definite.
void curvature_learn(Curvature& curvature, const double* step, const double* change, int count) noexcept;

/// All second derivatives times the factor, > 0.
void curvature_scale(Curvature& curvature, double factor, int count) noexcept;

/// The step with  (curvature + diag(extra)) step = descent.  extra >= 0.
void newton_step(Curvature& curvature, const double* extra, const double* descent, int count, double* step) noexcept;

/// The same for another descent, with the factor of the last newton_step.
void solve_curvature(const Curvature& curvature, const double* descent, int count, double* step) noexcept;

}  // namespace tern

#endif
