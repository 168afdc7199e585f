// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/curvature.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// A learned curvature along a step is at least this part of the curvature expected there.
constexpr double kLeastPart = 0.2;
/// A pivot is at least this part of its diagonal entry: rounding may leave less.
constexpr double kLeastPivot = 1e-12;

/// Index at which row i of a triangle begins.
constexpr int row(int i) {
  return i * (i + 1) / 2;
}

void multiply(const double* triangle, const double* x, int count, double* product) {
  for (int i = 0; i < count; ++i) {
    product[i] = sum_of_products(triangle + row(i), x, i + 1);
    for (int k = i + 1; k < count; ++k) product[i] += triangle[row(k) + i] * x[k];
  }
}

/// Adds scale * x x' to the triangle.
void add_square(double* triangle, const double* x, double scale, int count) {
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k <= i; ++k) triangle[row(i) + k] += scale * x[i] * x[k];
  }
}

/// Computes Cholesky's factor of entries + diag(extra).
void factorise(Curvature& curvature, const double* extra, int count) {
  for (int i = 0; i < count; ++i) {
    double* const own = curvature.factor + row(i);
    const double* const entries = curvature.entries + row(i);
    for (int k = 0; k < i; ++k) {
      const double* const other = curvature.factor + row(k);
      own[k] = (entries[k] - sum_of_products(own, other, k)) / other[k];
    }
    const double diagonal = entries[i] + extra[i];
    own[i] = square_root(larger(diagonal - sum_of_products(own, own, i), kLeastPivot * diagonal));
  }
}

}  // namespace

void curvature_begin(Curvature& curvature, const double* diagonal, int count) noexcept {
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < i; ++k) curvature.entries[row(i) + k] = 0.0;
    curvature.entries[row(i) + i] = diagonal[i];
  }
}

void curvature_learn(Curvature& curvature, const double* step, const double* change, int count) noexcept {
  double thought[kMaxSegments];
  multiply(curvature.entries, step, count, thought);
  const double before = sum_of_products(step, thought, count);
  const double seen = sum_of_products(step, change, count);
  if (!(before > 0.0)) return;
  const double part = seen < kLeastPart * before ? (1.0 - kLeastPart) * before / (before - seen) : 1.0;
  double learned[kMaxSegments];
  for (int i = 0; i < count; ++i) learned[i] = part * change[i] + (1.0 - part) * thought[i];
  const double after = sum_of_products(step, learned, count);
  if (!(after > 0.0)) return;
  add_square(curvature.entries, learned, 1.0 / after, count);
  add_square(curvature.entries, thought, -1.0 / before, count);
}

void curvature_scale(Curvature& curvature, double factor, int count) noexcept {
  for (int i = 0; i < row(count); ++i) curvature.entries[i] *= factor;
}

void newton_step(Curvature& curvature, const double* extra, const double* descent, int count, double* step) noexcept {
  factorise(curvature, extra, count);
  solve_curvature(curvature, descent, count, step);
}

void solve_curvature(const Curvature& curvature, const double* descent, int count, double* step) noexcept {
  const double* const factor = curvature.factor;
  for (int i = 0; i < count; ++i) {
    step[i] = (descent[i] - sum_of_products(factor + row(i), step, i)) / factor[row(i) + i];
  }
  for (int i = count - 1; i >= 0; --i) {
    for (int k = i + 1; k < count; ++k) step[i] -= factor[row(k) + i] * step[k];
    step[i] /= factor[row(i) + i];
  }
}

}  // namespace tern
