// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "qp/pricing.hpp"

#include "base/math.hpp"
#include "qp/hessian.hpp"

namespace tern::qp {
namespace {

constexpr int kTilePairs = kQpTile / kPair;

/// Below every violation that there can be, and above: that of a point that is no number.
constexpr double kNoViolation = -1e300;
constexpr double kNoNumber = 1e300;

/// From this scan on tiles remember their reach, which takes the lengths of all their points.
constexpr int kFirstReach = 3;

/// Coordinates of up to kQpTile points, by axis.
struct Tile {
  alignas(16) double at[kQpAxes][kQpTile];
  alignas(16) double worst[kQpTile];
  Pair finite;  ///< 0 times every coordinate so far: 0 where all of them were numbers
};

/// A scan in progress: the best row so far, and where it stands.
struct Scan {
  Tile tile;
  int group = -1;
  int point = -1;
  double violation = 0.0;
  double distance = 0.0;
  bool constant = false;
  int tiles = 0;    ///< counted over all groups
  bool all = true;  ///< look at every tile
  bool skipped = false;
};

/// Evaluates `count` points; the lanes left over repeat the last one.
void fill(const QpPoint* points, int count, const QpSolver& solver, Tile& tile) {
  for (int lane = 0; lane < count; ++lane) {
    const Value value = evaluate(points[lane], solver);
    tile.at[0][lane] = value.low[0];
    tile.at[1][lane] = value.low[1];
    tile.at[2][lane] = value.high[0];
    tile.finite += both(0.0) * (value.low + value.high);
  }
  for (int lane = count; lane < kQpTile; ++lane) {
    for (int a = 0; a < kQpAxes; ++a) tile.at[a][lane] = tile.at[a][count - 1];
  }
}

/// The largest violation of each point of the tile; true where one is positive.
bool scan_planes(const QpUnitPlane* planes, int count, Tile& tile) {
  Pair worst[kTilePairs];
  for (int i = 0; i < kTilePairs; ++i) worst[i] = both(kNoViolation);
  for (int p = 0; p < count; ++p) {
    const QpUnitPlane& plane = planes[p];
    const Pair offset = both(plane.offset);
    if (plane.axis >= 0) {
      const Pair side = both(plane.normal[plane.axis]);
      const double* at = tile.at[plane.axis];
      for (int i = 0; i < kTilePairs; ++i) worst[i] = larger_of(side * pair(at + kPair * i) - offset, worst[i]);
      continue;
    }
    const Pair nx = both(plane.normal[0]);
    const Pair ny = both(plane.normal[1]);
    const Pair nz = both(plane.normal[2]);
    for (int i = 0; i < kTilePairs; ++i) {
      const Pair sum_xy = nx * pair(tile.at[0] + kPair * i) + ny * pair(tile.at[1] + kPair * i);
      worst[i] = larger_of((sum_xy + nz * pair(tile.at[2] + kPair * i)) - offset, worst[i]);
    }
  }
  for (int i = 0; i < kTilePairs; ++i) pair(tile.worst + kPair * i) = worst[i];
  const Pair most = larger_of(larger_of(worst[0], worst[1]), larger_of(worst[2], worst[3]));
  return larger(most[0], most[1]) > 0.0;
}

double inverse_norm(const QpProblem& problem, QpSolver& solver, int point) {
  double& known = solver.inverse_norm[point];
  if (known < 0.0) known = point_inverse_norm(problem.points[point], solver);
  return known;
}

void consider(const QpProblem& problem, QpSolver& solver, int group, int point, double violation, Scan& scan) {
  solver.worst = larger(solver.worst, violation);
  if (!(violation > kQpEntering) || !finite(violation) || scan.constant) return;
  const double inverse = inverse_norm(problem, solver, point);
  const bool constant = !(inverse > 0.0);
  const double distance = violation * inverse;
  if (!constant && !(distance > scan.distance)) return;
  scan.group = group;
  scan.point = point;
  scan.violation = violation;
  scan.distance = distance;
  scan.constant = constant;
}

/// How far the nearest row of the tile is violated, as a distance in the metric; negative: how far z may go before one
/// is. Constant points never are.
double tile_distance(const QpProblem& problem, QpSolver& solver, int begin, int count, const Tile& tile) {
  double distance = kNoViolation;
  for (int lane = 0; lane < count; ++lane) {
    const double inverse = inverse_norm(problem, solver, begin + lane);
    if (inverse > 0.0) distance = larger(tile.worst[lane] * inverse, distance);
  }
  return distance;
}

/// True where no row of the tile can be better than what was found: since the tile was looked at, z has not gone far
/// enough.
bool out_of_reach(const QpSolver& solver, int index, const Scan& scan) {
  if (scan.all || index >= kQpMaxTiles) return false;
  return solver.reach[index] + solver.travelled <= scan.distance;
}

void remember_reach(const QpProblem& problem, QpSolver& solver, int index, int begin, int count, const Tile& tile) {
  if (index >= kQpMaxTiles) return;
  solver.reach[index] =
      solver.scans < kFirstReach ? kNoNumber : tile_distance(problem, solver, begin, count, tile) - solver.travelled;
}

void scan_group(const QpProblem& problem, QpSolver& solver, int index, Scan& scan) {
  const QpGroup& group = problem.groups[index];
  const QpUnitPlane* planes = solver.planes + group.plane_begin;
  for (int begin = group.point_begin; begin < group.point_end; begin += kQpTile) {
    const int tile = scan.tiles++;
    if (out_of_reach(solver, tile, scan)) {
      scan.skipped = true;
      continue;
    }
    const int left = group.point_end - begin;
    const int count = left < kQpTile ? left : kQpTile;
    fill(problem.points + begin, count, solver, scan.tile);
    const bool violated = scan_planes(planes, group.plane_end - group.plane_begin, scan.tile);
    remember_reach(problem, solver, tile, begin, count, scan.tile);
    if (!violated) continue;
    for (int lane = 0; lane < count; ++lane) {
      if (scan.tile.worst[lane] > 0.0) consider(problem, solver, index, begin + lane, scan.tile.worst[lane], scan);
    }
  }
}

void scan_rows(const QpProblem& problem, QpSolver& solver, Scan& scan) {
  scan.tile.finite = both(0.0);
  solver.worst = 0.0;
  for (int g = 0; g < problem.group_count; ++g) scan_group(problem, solver, g, scan);
  if (!finite(sum(scan.tile.finite))) solver.worst = kNoNumber;
  ++solver.scans;
}

/// The first plane that the point violates most.
int worst_plane(const QpProblem& problem, const QpSolver& solver, const QpGroup& group, int point) {
  const Value at = evaluate(problem.points[point], solver);
  int plane = group.plane_begin;
  double worst = kNoViolation;
  for (int p = group.plane_begin; p < group.plane_end; ++p) {
    const double violation = violation_at(at, solver.planes[p]);
    if (violation > worst) {
      worst = violation;
      plane = p;
    }
  }
  return plane;
}

}  // namespace

void forget_lengths(const QpProblem& problem, QpSolver& solver) {
  for (int k = 0; k < problem.point_count; ++k) solver.inverse_norm[k] = -1.0;
  solver.inverse_known = false;
}

void forget_reach(QpSolver& solver) {
  solver.scans = 0;
  solver.travelled = 0.0;
}

Candidate price(const QpProblem& problem, QpSolver& solver) {
  Scan scan;
  scan.all = solver.scans <= kFirstReach;
  scan_rows(problem, solver, scan);
  if (scan.group < 0 && scan.skipped) {
    scan.all = true;
    scan.tiles = 0;
    scan_rows(problem, solver, scan);
  }
  if (scan.group < 0) return {};
  const int plane = worst_plane(problem, solver, problem.groups[scan.group], scan.point);
  return {true, scan.constant, {scan.point, plane}, scan.violation};
}

}  // namespace tern::qp
