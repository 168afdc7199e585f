// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "qp/operations.hpp"
#include "qp/parts.hpp"

namespace tern::qp {
namespace {

/// Columns that one pass over a vector handles.
constexpr int kBatch = 4;

/// Gram-Schmidt needs a second pass if the first left less than this share of the squared length ("twice is enough").
constexpr double kCancellation = 0.5;

const double* column(const QpSolver& solver, int j) {
  return solver.basis + j * solver.stride;
}
double* column(QpSolver& solver, int j) {
  return solver.basis + j * solver.stride;
}

const double* triangle_column(const QpSolver& solver, int j) {
  return solver.triangle + packed_column(j);
}
double* triangle_column(QpSolver& solver, int j) {
  return solver.triangle + packed_column(j);
}

/// Columns that one pass of a projection handles. The sums of each column keep their order, whatever the number.
constexpr int kProjected = kVectors ? kBatch : 2;

void project_batch(const QpSolver& solver, int j, int begin, const double* v, double* out) {
  Pair total[kProjected][2] = {};
  const double* q = column(solver, j);
  for (int i = begin; i < solver.stride; i += kPad) {
    const Pair low = pair(v + i);
    const Pair high = pair(v + i + kPair);
    for (int b = 0; b < kProjected; ++b) {
      total[b][0] += low * pair(q + b * solver.stride + i);
      total[b][1] += high * pair(q + b * solver.stride + i + kPair);
    }
  }
  for (int b = 0; b < kProjected; ++b) out[j + b] = sum(total[b][0] + total[b][1]);
}

/// Two elements of the sum of four columns, each column times its coordinate.
[[gnu::always_inline]] inline Pair combine(const Pair* c, const double* q, int stride) {
  return (c[0] * pair(q) + c[1] * pair(q + stride)) + (c[2] * pair(q + 2 * stride) + c[3] * pair(q + 3 * stride));
}

/// Subtracts kBatches batches of columns, each times its coordinate, in one pass over the vector.
template <int kBatches>
void subtract_batches(const QpSolver& solver, int j, const double* coordinates, double* v) {
  Pair c[kBatches * kBatch];
  for (int b = 0; b < kBatches * kBatch; ++b) c[b] = both(coordinates[j + b]);
  const double* q = column(solver, j);
  const int stride = solver.stride;
  const double* const far = q + (kBatches - 1) * kBatch * stride;
  for (int i = 0; i < stride; i += kPad) {
    Pair low = pair(v + i) - combine(c, q + i, stride);
    Pair high = pair(v + i + kPair) - combine(c, q + i + kPair, stride);
    if (kBatches == 2) {
      low -= combine(c + kBatch, far + i, stride);
      high -= combine(c + kBatch, far + i + kPair, stride);
    }
    pair(v + i) = low;
    pair(v + i + kPair) = high;
  }
}

/// Subtracts kColumns < kBatch columns, one after the other, in one pass over the vector.
template <int kColumns>
void subtract_columns(const QpSolver& solver, int j, const double* coordinates, double* v) {
  const double* q = column(solver, j);
  const int stride = solver.stride;
  Pair c[kColumns];
  for (int b = 0; b < kColumns; ++b) c[b] = both(-coordinates[j + b]);
  for (int i = 0; i < stride; i += kPad) {
    Pair low = pair(v + i);
    Pair high = pair(v + i + kPair);
    for (int b = 0; b < kColumns; ++b) {
      low += c[b] * pair(q + b * stride + i);
      high += c[b] * pair(q + b * stride + i + kPair);
    }
    pair(v + i) = low;
    pair(v + i + kPair) = high;
  }
}

/// Back substitution for columns j and j + 1, j even: two steps in one pass over the elements above.
void solve_two_columns(const QpSolver& solver, int j, double* out) {
  const double* left = triangle_column(solver, j);
  const double* right = triangle_column(solver, j + 1);
  out[j + 1] *= solver.inverse_diagonal[j + 1];
  out[j] = (out[j] - out[j + 1] * right[j]) * solver.inverse_diagonal[j];
  const Pair first = both(out[j]);
  const Pair second = both(out[j + 1]);
  for (int i = 0; i < j; i += kPair) pair(out + i) -= second * pair(right + i) + first * pair(left + i);
}

/// Moves column c + 1 of the triangle to column c, applies the rotations so far, and makes the rotation that clears the
/// element left below the diagonal.
void shift_triangle_column(QpSolver& solver, int first, int c) {
  const double* from = triangle_column(solver, c + 1);
  double* to = triangle_column(solver, c);
  for (int i = 0; i < first; ++i) to[i] = from[i];
  double carried = from[first];
  for (int i = first; i < c; ++i) {
    to[i] = solver.cosine[i] * carried + solver.sine[i] * from[i + 1];
    carried = solver.cosine[i] * from[i + 1] - solver.sine[i] * carried;
  }
  const double below = from[c + 1];
  const double radius = square_root(carried * carried + below * below);
  const double inverse = 1.0 / radius;
  solver.cosine[c] = carried * inverse;
  solver.sine[c] = below * inverse;
  to[c] = radius;
  solver.inverse_diagonal[c] = inverse;
}

void rotate_coordinates(const QpSolver& solver, int first, int last, double* v) {
  double carried = v[first];
  for (int c = first; c < last; ++c) {
    const double next = v[c + 1];
    v[c] = solver.cosine[c] * carried + solver.sine[c] * next;
    carried = solver.cosine[c] * next - solver.sine[c] * carried;
  }
  v[last] = carried;
}

/// Applies all rotations to kPad elements before the next ones, so each element is read and written once.
void rotate_basis(QpSolver& solver, int first, int last) {
  for (int i = 0; i < solver.stride; i += kPad) {
    double* at = column(solver, first) + i;
    Pair low = pair(at);
    Pair high = pair(at + kPair);
    for (int c = first; c < last; ++c) {
      const Pair cosine = both(solver.cosine[c]);
      const Pair sine = both(solver.sine[c]);
      const Pair next_low = pair(at + solver.stride);
      const Pair next_high = pair(at + solver.stride + kPair);
      pair(at) = cosine * low + sine * next_low;
      pair(at + kPair) = cosine * high + sine * next_high;
      low = cosine * next_low - sine * low;
      high = cosine * next_high - sine * high;
      at += solver.stride;
    }
    pair(at) = low;
    pair(at + kPair) = high;
  }
}

}  // namespace

void project(const QpSolver& solver, int begin, const double* v, double* out) {
  const int k = solver.active_count;
  int j = 0;
  for (; j + kProjected <= k; j += kProjected) project_batch(solver, j, begin, v, out);
  for (; j < k; ++j) out[j] = inner(column(solver, j), v, begin, solver.stride);
}

void subtract(const QpSolver& solver, const double* coordinates, double* v) {
  const int k = solver.active_count;
  int j = 0;
  for (; j + 2 * kBatch <= k; j += 2 * kBatch) subtract_batches<2>(solver, j, coordinates, v);
  for (; j + kBatch <= k; j += kBatch) subtract_batches<1>(solver, j, coordinates, v);
  if (k - j == 1) subtract_columns<1>(solver, j, coordinates, v);
  if (k - j == 2) subtract_columns<2>(solver, j, coordinates, v);
  if (k - j == 3) subtract_columns<3>(solver, j, coordinates, v);
}

void split_constraint(QpSolver& solver, int begin) {
  const int k = solver.active_count;
  for (int i = 0; i < solver.stride; ++i) solver.direction[i] = solver.gradient[i];
  solver.direction_squared = solver.entering_squared;
  solver.spent += 2 * ops::kElement * solver.stride;
  if (k == 0) return;
  solver.spent += 2 * basis_operations(solver);
  project(solver, begin, solver.gradient, solver.projection);
  subtract(solver, solver.projection, solver.direction);
  solver.direction_squared = inner(solver.direction, solver.direction, 0, solver.stride);
  if (solver.direction_squared >= kCancellation * solver.entering_squared) return;
  solver.spent += 2 * basis_operations(solver);
  double* again = solver.ratio;
  project(solver, 0, solver.direction, again);
  subtract(solver, again, solver.direction);
  for (int j = 0; j < k; ++j) solver.projection[j] += again[j];
  solver.direction_squared = inner(solver.direction, solver.direction, 0, solver.stride);
}

void solve_triangle(const QpSolver& solver, const double* in, double* out) {
  const int k = solver.active_count;
  for (int j = 0; j < k; ++j) out[j] = in[j];
  int j = k;
  if (k % 2 == 1) {
    const double* upper = triangle_column(solver, --j);
    out[j] *= solver.inverse_diagonal[j];
    const Pair last = both(out[j]);
    for (int i = 0; i < j; i += kPair) pair(out + i) -= last * pair(upper + i);
  }
  for (j -= 2; j >= 0; j -= 2) solve_two_columns(solver, j, out);
}

void solve_transposed(const QpSolver& solver, const double* in, double* out) {
  const int k = solver.active_count;
  for (int j = 0; j < k; ++j) {
    const double* upper = triangle_column(solver, j);
    double total = in[j];
    for (int i = 0; i < j; ++i) total -= upper[i] * out[i];
    out[j] = total * solver.inverse_diagonal[j];
  }
}

void add_constraint(QpSolver& solver, const QpConstraint& constraint, double multiplier) {
  const int k = solver.active_count;
  const double length = square_root(solver.direction_squared);
  const double inverse = 1.0 / length;
  const Pair scale = both(inverse);
  double* q = column(solver, k);
  for (int i = 0; i < solver.stride; i += kPair) pair(q + i) = scale * pair(solver.direction + i);
  double* upper = triangle_column(solver, k);
  for (int j = 0; j < k; ++j) upper[j] = solver.projection[j];
  upper[k] = length;
  solver.inverse_diagonal[k] = inverse;
  solver.active[k] = constraint;
  solver.multiplier[k] = multiplier;
  solver.constraint_length[k] = square_root(solver.entering_squared);
  solver.active_count = k + 1;
}

void drop_constraint(QpSolver& solver, int j, double* coordinates) {
  const int last = solver.active_count - 1;
  solver.spent += rotation_operations(solver, j);
  for (int c = j; c < last; ++c) shift_triangle_column(solver, j, c);
  rotate_coordinates(solver, j, last, coordinates);
  rotate_basis(solver, j, last);
  for (int c = j; c < last; ++c) {
    solver.active[c] = solver.active[c + 1];
    solver.multiplier[c] = solver.multiplier[c + 1];
    solver.constraint_length[c] = solver.constraint_length[c + 1];
  }
  solver.active_count = last;
}

}  // namespace tern::qp
