// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Up to eight points of a group, two in a register, and how far each is outside the group's planes.
#ifndef TERN_QP_POINT_TILE_HPP
#define TERN_QP_POINT_TILE_HPP

#include "base/math.hpp"
#include "qp/rows.hpp"

namespace tern::qp {

constexpr int kTilePairs = kQpTile / kPair;

/// Coordinates of up to kQpTile points by axis, and their largest violations.
struct PointTile {
  Pair x[kTilePairs];
  Pair y[kTilePairs];
  Pair z[kTilePairs];
  alignas(16) double worst[kQpTile];
};

/// Evaluates two points as pair `at` of the tile, and returns the sum of their coordinates. Neighbours usually depend
/// on the same unknowns.
inline Pair place(const QpPoint& first, const QpPoint& second, const QpSolver& solver, int at, PointTile& tile) {
  Pair sum_x = {first.offset.x, second.offset.x};
  Pair sum_y = {first.offset.y, second.offset.y};
  Pair sum_z = {first.offset.z, second.offset.z};
  if (first.first == second.first) {
    const int terms = first.terms < second.terms ? second.terms : first.terms;
    const double(*x)[2 * kQpAxes] = solver.spread + first.first;
    for (int t = 0; t < terms; ++t) {
      const Pair factor = {first.coefficient[t], second.coefficient[t]};
      sum_x += factor * pair(x[t]);
      sum_y += factor * pair(x[t] + kPair);
      sum_z += factor * pair(x[t] + 2 * kPair);
    }
  } else {
    const Value a = evaluate(first, solver);
    const Value b = evaluate(second, solver);
    sum_x = Pair{a.low[0], b.low[0]};
    sum_y = Pair{a.low[1], b.low[1]};
    sum_z = Pair{a.high[0], b.high[0]};
  }
  tile.x[at] = sum_x;
  tile.y[at] = sum_y;
  tile.z[at] = sum_z;
  return (sum_x + sum_y) + sum_z;
}

/// Evaluates `count` points; if the count is odd, the last point is evaluated twice. Returns 0 times their sum, which
/// is 0 if no coordinate is NaN or infinite.
inline Pair fill(const QpPoint* points, int count, const QpSolver& solver, PointTile& tile) {
  Pair total = both(0.0);
  for (int k = 0; k < count; k += kPair) {
    total += place(points[k], points[k + 1 < count ? k + 1 : k], solver, k / kPair, tile);
  }
  return both(0.0) * total;
}

/// The larger of the violations of the lower and the upper bound.
inline Pair outside(Pair at, const double* low, const double* high) {
  return larger_of(at - pair(high), pair(low) - at);
}

/// The largest violations of a group's box.
template <int kPairs>
void scan_box(const QpScreen& screen, const PointTile& tile, Pair* worst) {
  for (int i = 0; i < kPairs; ++i) {
    const Pair level =
        larger_of(outside(tile.x[i], screen.low[0], screen.high[0]), outside(tile.y[i], screen.low[1], screen.high[1]));
    worst[i] = larger_of(level, outside(tile.z[i], screen.low[2], screen.high[2]));
  }
}

/// Raises `worst` to the violations of planes [begin, end).
template <int kPairs>
void scan_planes(const QpUnitPlanes& planes, int begin, int end, const PointTile& tile, Pair* worst) {
  for (int p = begin; p < end; ++p) {
    const Pair normal[kQpAxes] = {both(planes.normal[0][p]), both(planes.normal[1][p]), both(planes.normal[2][p])};
    const Pair upper = both(planes.offset[p]);
    Pair height[kPairs];
    for (int i = 0; i < kPairs; ++i) {
      height[i] = (normal[0] * tile.x[i] + normal[1] * tile.y[i]) + normal[2] * tile.z[i];
      worst[i] = larger_of(height[i] - upper, worst[i]);
    }
    if (!planes.slab[p] || p + 1 == end) continue;
    const Pair lower = both(-planes.offset[++p]);
    for (int i = 0; i < kPairs; ++i) worst[i] = larger_of(lower - height[i], worst[i]);
  }
}

/// Computes the largest violation of each point in the tile by planes [.., plane_end) of a group. True if one is
/// positive.
template <int kPairs>
bool scan(const QpUnitPlanes& planes, const QpScreen& screen, int plane_end, PointTile& tile) {
  Pair worst[kPairs];
  scan_box<kPairs>(screen, tile, worst);
  scan_planes<kPairs>(planes, screen.oblique, plane_end, tile, worst);
  Pair most = worst[0];
  for (int i = 0; i < kPairs; ++i) {
    pair(tile.worst + kPair * i) = worst[i];
    most = larger_of(worst[i], most);
  }
  return larger(most[0], most[1]) > 0.0;
}

/// The same for a number of points, 1 .. kQpTile, that is known only at run time.
inline bool scan(const QpUnitPlanes& planes, const QpScreen& screen, int plane_end, int count, PointTile& tile) {
  switch ((count + 1) / kPair) {
    case 1:
      return scan<1>(planes, screen, plane_end, tile);
    case 2:
      return scan<2>(planes, screen, plane_end, tile);
    case 3:
      return scan<3>(planes, screen, plane_end, tile);
    default:
      return scan<kTilePairs>(planes, screen, plane_end, tile);
  }
}

}  // namespace tern::qp

#endif
