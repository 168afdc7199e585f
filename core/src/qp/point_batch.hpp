// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Up to eight points of a group, two in a register, and how far each is outside the group's planes.
#ifndef TERN_QP_POINT_BATCH_HPP
#define TERN_QP_POINT_BATCH_HPP

#include "base/math.hpp"
#include "qp/parts.hpp"

namespace tern::qp {

constexpr int kBatchPairs = kQpBatch / kPair;

/// Coordinates of up to kQpBatch points by axis, and their largest violations.
struct PointBatch {
  Pair x[kBatchPairs];
  Pair y[kBatchPairs];
  Pair z[kBatchPairs];
  alignas(16) double worst[kQpBatch];
};

/// Evaluates two points as pair `at` of the batch, and returns the sum of their coordinates. Neighbours usually depend
/// on the same unknowns.
inline Pair place(const QpPoint& first, const QpPoint& second, const QpSolver& solver, int at, PointBatch& batch) {
  Pair sum_x = {first.offset.x, second.offset.x};
  Pair sum_y = {first.offset.y, second.offset.y};
  Pair sum_z = {first.offset.z, second.offset.z};
  if (first.first == second.first) {
    const int terms = first.terms < second.terms ? second.terms : first.terms;
    const double(*x)[2 * kQpAxes] = solver.spread + first.first;
    for (int t = 0; t < terms; ++t) {
      const Pair factor = {first.coefficient[t], second.coefficient[t]};
      sum_x += factor * twice(x[t]);
      sum_y += factor * twice(x[t] + kPair);
      sum_z += factor * twice(x[t] + 2 * kPair);
    }
  } else {
    const Value a = evaluate(first, solver);
    const Value b = evaluate(second, solver);
    sum_x = Pair{a.low[0], b.low[0]};
    sum_y = Pair{a.low[1], b.low[1]};
    sum_z = Pair{a.high[0], b.high[0]};
  }
  batch.x[at] = sum_x;
  batch.y[at] = sum_y;
  batch.z[at] = sum_z;
  return (sum_x + sum_y) + sum_z;
}

/// Evaluates `count` points; if the count is odd, the last point is evaluated twice. Returns 0 times their sum, which
/// is 0 if no coordinate is NaN or infinite.
inline Pair fill(const QpPoint* points, int count, const QpSolver& solver, PointBatch& batch) {
  Pair total = both(0.0);
  for (int k = 0; k < count; k += kPair) {
    total += place(points[k], points[k + 1 < count ? k + 1 : k], solver, k / kPair, batch);
  }
  return both(0.0) * total;
}

/// The larger of the violations of the lower and the upper bound.
inline Pair outside(Pair at, const double* low, const double* high) {
  return larger_of(at - twice(high), twice(low) - at);
}

/// The largest violations of a group's box.
template <int kPairs>
void worst_by_box(const QpScreen& screen, const PointBatch& batch, Pair* worst) {
  for (int i = 0; i < kPairs; ++i) {
    const Pair level = larger_of(outside(batch.x[i], screen.low[0], screen.high[0]),
                                 outside(batch.y[i], screen.low[1], screen.high[1]));
    worst[i] = larger_of(level, outside(batch.z[i], screen.low[2], screen.high[2]));
  }
}

/// Raises `worst` to the violations of planes [begin, end).
template <int kPairs>
void worst_by_planes(const QpUnitPlanes& planes, int begin, int end, const PointBatch& batch, Pair* worst) {
  for (int p = begin; p < end; ++p) {
    const Pair normal[kQpAxes] = {both(planes.normal[0][p]), both(planes.normal[1][p]), both(planes.normal[2][p])};
    const Pair upper = both(planes.offset[p]);
    Pair height[kPairs];
    for (int i = 0; i < kPairs; ++i) {
      height[i] = (normal[0] * batch.x[i] + normal[1] * batch.y[i]) + normal[2] * batch.z[i];
      worst[i] = larger_of(height[i] - upper, worst[i]);
    }
    if (!planes.slab[p] || p + 1 == end) continue;
    const Pair lower = both(-planes.offset[++p]);
    for (int i = 0; i < kPairs; ++i) worst[i] = larger_of(lower - height[i], worst[i]);
  }
}

/// Computes the largest violation of each point in the batch by a group's planes before plane_end. True if one is
/// positive.
template <int kPairs>
bool find_worst(const QpUnitPlanes& planes, const QpScreen& screen, int plane_end, PointBatch& batch) {
  Pair worst[kPairs];
  worst_by_box<kPairs>(screen, batch, worst);
  worst_by_planes<kPairs>(planes, screen.oblique, plane_end, batch, worst);
  Pair most = worst[0];
  for (int i = 0; i < kPairs; ++i) {
    pair(batch.worst + kPair * i) = worst[i];
    most = larger_of(worst[i], most);
  }
  return larger(most[0], most[1]) > 0.0;
}

/// Calls find_worst() for `count` points, 1 .. kQpBatch, a number that is known only at run time.
inline bool find_worst(const QpUnitPlanes& planes, const QpScreen& screen, int plane_end, int count,
                       PointBatch& batch) {
  switch ((count + 1) / kPair) {
    case 1:
      return find_worst<1>(planes, screen, plane_end, batch);
    case 2:
      return find_worst<2>(planes, screen, plane_end, batch);
    case 3:
      return find_worst<3>(planes, screen, plane_end, batch);
    default:
      return find_worst<kBatchPairs>(planes, screen, plane_end, batch);
  }
}

}  // namespace tern::qp

#endif
