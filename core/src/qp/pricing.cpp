// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "qp/pricing.hpp"

#include "base/math.hpp"
#include "qp/hessian.hpp"

namespace tern::qp {
namespace {

/// Points that are scanned together: four registers of two lanes.
constexpr int kTile = 8;
constexpr int kTilePairs = kTile / kPair;

/// Below every violation that there can be, and above: that of a point that is no number.
constexpr double kNoViolation = -1e300;
constexpr double kNoNumber = 1e300;
/// Squared lengths in this range neither overflow nor lose digits.
constexpr double kSmallSquare = 1e-200;
constexpr double kLargeSquare = 1e200;
/// A normal whose squared length is this close to 1 is unit.
constexpr double kUnitTolerance = 1e-14;

/// Coordinates of up to eight points, by axis.
struct Tile {
  alignas(16) double at[kQpAxes][kTile];
  alignas(16) double worst[kTile];
  Pair finite;  ///< 0 times every coordinate so far: 0 where all of them were numbers
};

/// offset + sum coefficient * x, as two lanes of two.
struct Value {
  Pair low;
  Pair high;
};

Value evaluate(const QpPoint& point, const QpSolver& solver) {
  Value value = {{point.offset.x, point.offset.y}, {point.offset.z, 0.0}};
  const double(*x)[4] = solver.x + point.first;
  for (int t = 0; t < point.terms; ++t) {
    const Pair factor = both(point.coefficient[t]);
    value.low += factor * pair(x[t]);
    value.high += factor * pair(x[t] + kPair);
  }
  return value;
}

/// Evaluates `count` points; the lanes left over repeat the last one.
void fill(const QpPoint* points, int count, const QpSolver& solver, Tile& tile) {
  for (int lane = 0; lane < kTile; ++lane) {
    const Value value = evaluate(points[lane < count ? lane : count - 1], solver);
    tile.at[0][lane] = value.low[0];
    tile.at[1][lane] = value.low[1];
    tile.at[2][lane] = value.high[0];
    tile.finite += both(0.0) * (value.low + value.high);
  }
}

/// The largest violation of each point of the tile; true where one is positive.
bool scan(const QpUnitPlane* planes, int count, Tile& tile) {
  Pair worst[kTilePairs];
  for (int i = 0; i < kTilePairs; ++i) worst[i] = both(kNoViolation);
  for (int p = 0; p < count; ++p) {
    const Pair nx = both(planes[p].normal[0]);
    const Pair ny = both(planes[p].normal[1]);
    const Pair nz = both(planes[p].normal[2]);
    const Pair offset = both(planes[p].offset);
    for (int i = 0; i < kTilePairs; ++i) {
      const Pair sum_xy = nx * pair(tile.at[0] + kPair * i) + ny * pair(tile.at[1] + kPair * i);
      worst[i] = larger_of((sum_xy + nz * pair(tile.at[2] + kPair * i)) - offset, worst[i]);
    }
  }
  for (int i = 0; i < kTilePairs; ++i) pair(tile.worst + kPair * i) = worst[i];
  const Pair most = larger_of(larger_of(worst[0], worst[1]), larger_of(worst[2], worst[3]));
  return larger(most[0], most[1]) > 0.0;
}

double violation(const QpUnitPlane& plane, double x, double y, double z) {
  return ((plane.normal[0] * x + plane.normal[1] * y) + plane.normal[2] * z) - plane.offset;
}

/// The best row so far, of a scan.
struct Best {
  int group = -1;
  int point = -1;
  double violation = 0.0;
  double merit = 0.0;
  bool constant = false;
};

void consider(const QpProblem& problem, QpSolver& solver, int group, int point, double violation, Best& best) {
  solver.worst = larger(solver.worst, violation);
  if (!(violation > kQpEntering) || best.constant) return;
  double& weight = solver.weight[point];
  if (weight < 0.0) weight = point_weight(problem.points[point], solver);
  const bool constant = !(weight > 0.0);
  const double merit = violation * violation * weight;
  if (!constant && !(merit > best.merit)) return;
  best = {group, point, violation, merit, constant};
}

void price_group(const QpProblem& problem, QpSolver& solver, int index, Tile& tile, Best& best) {
  const QpGroup& group = problem.groups[index];
  const QpUnitPlane* planes = solver.planes + group.plane_begin;
  for (int begin = group.point_begin; begin < group.point_end; begin += kTile) {
    const int left = group.point_end - begin;
    const int count = left < kTile ? left : kTile;
    fill(problem.points + begin, count, solver, tile);
    if (!scan(planes, group.plane_end - group.plane_begin, tile)) continue;
    for (int lane = 0; lane < count; ++lane) {
      if (tile.worst[lane] > 0.0) consider(problem, solver, index, begin + lane, tile.worst[lane], best);
    }
  }
}

/// The first plane that the point violates most.
int worst_plane(const QpProblem& problem, const QpSolver& solver, const QpGroup& group, int point) {
  const Value at = evaluate(problem.points[point], solver);
  int plane = group.plane_begin;
  double worst = kNoViolation;
  for (int p = group.plane_begin; p < group.plane_end; ++p) {
    const double v = violation(solver.planes[p], at.low[0], at.low[1], at.high[0]);
    if (v > worst) {
      worst = v;
      plane = p;
    }
  }
  return plane;
}

}  // namespace

double inverse_length(const Halfspace& plane) {
  const Vec3& n = plane.normal;
  const double squared = dot(n, n);
  if (absolute(squared - 1.0) <= kUnitTolerance) return 1.0;
  if (squared > kSmallSquare && squared < kLargeSquare) return 1.0 / square_root(squared);
  const double largest = larger(larger(absolute(n.x), absolute(n.y)), absolute(n.z));
  if (!(largest > 0.0)) return 0.0;
  const Vec3 scaled = {n.x / largest, n.y / largest, n.z / largest};
  return 1.0 / largest / square_root(dot(scaled, scaled));
}

bool prepare_planes(const QpProblem& problem, QpSolver& solver) {
  bool numbers = true;
  solver.contradictory = false;
  for (int p = 0; p < problem.plane_count; ++p) {
    const Halfspace& plane = problem.planes[p];
    const double scale = inverse_length(plane);
    QpUnitPlane& unit = solver.planes[p];
    for (int a = 0; a < kQpAxes; ++a) unit.normal[a] = scale * axis(plane.normal, a);
    unit.offset = scale * plane.offset;
    if (!(scale > 0.0) && plane.offset < 0.0) {
      unit.offset = -1.0;
      solver.contradictory = true;
    }
    numbers = numbers && finite(plane.normal) && finite(unit.offset);
  }
  return numbers;
}

void forget_weights(const QpProblem& problem, QpSolver& solver) {
  for (int k = 0; k < problem.point_count; ++k) solver.weight[k] = -1.0;
  solver.inverse_known = false;
}

Candidate contradiction(const QpProblem& problem) {
  for (int g = 0; g < problem.group_count; ++g) {
    const QpGroup& group = problem.groups[g];
    if (group.point_begin >= group.point_end) continue;
    for (int p = group.plane_begin; p < group.plane_end; ++p) {
      const Halfspace& plane = problem.planes[p];
      if (plane.offset < 0.0 && !(inverse_length(plane) > 0.0)) return {true, true, {group.point_begin, p}, 1.0};
    }
  }
  return {};
}

Candidate price(const QpProblem& problem, QpSolver& solver) {
  Best best;
  Tile tile;
  tile.finite = both(0.0);
  solver.worst = 0.0;
  for (int g = 0; g < problem.group_count; ++g) price_group(problem, solver, g, tile, best);
  if (!finite(sum(tile.finite))) solver.worst = kNoNumber;
  if (best.group < 0) return {};
  const int plane = worst_plane(problem, solver, problem.groups[best.group], best.point);
  return {true, best.constant, {best.point, plane}, best.violation};
}

double unit_violation(const QpProblem& problem, const QpSolver& solver, const QpRow& row) {
  const Value at = evaluate(problem.points[row.point], solver);
  return violation(solver.planes[row.plane], at.low[0], at.low[1], at.high[0]);
}

bool is_row(const QpProblem& problem, const QpRow& row) {
  for (int g = 0; g < problem.group_count; ++g) {
    const QpGroup& group = problem.groups[g];
    if (row.point >= group.point_begin && row.point < group.point_end && row.plane >= group.plane_begin &&
        row.plane < group.plane_end) {
      return true;
    }
  }
  return false;
}

}  // namespace tern::qp
