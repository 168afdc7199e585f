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

/// A tile is left out while the worst violation that was found in it is less than this part of the one that entered...
constexpr double kWorthwhile = 0.3;
/// ...for so many scans at most: rows that have come to be violated must not wait until all others are met.
constexpr int kPatience = 6;

/// Coordinates of up to kQpTile points, by axis.
struct Tile {
  alignas(16) double at[kQpAxes][kQpTile];
  alignas(16) double worst[kQpTile];
  Pair finite;  ///< 0 times the sum of every tile's coordinates so far: 0 where all of them were numbers
};

/// A scan in progress: the best row so far, and where it stands.
struct Scan {
  Tile tile;
  int group = -1;
  int point = -1;
  double violation = 0.0;
  double distance = 0.0;
  bool constant = false;
  int tiles = 0;      ///< counted over all groups
  bool rest = false;  ///< look at the tiles that were passed over, else at the promising ones
  bool skipped = false;
};

void put(const Value& first, const Value& second, int lane, Tile& tile) {
  pair(tile.at[0] + lane) = Pair{first.low[0], second.low[0]};
  pair(tile.at[1] + lane) = Pair{first.low[1], second.low[1]};
  pair(tile.at[2] + lane) = Pair{first.high[0], second.high[0]};
}

/// Evaluates `count` points; the lanes left over repeat the last one.
void fill(const QpPoint* points, int count, const QpSolver& solver, Tile& tile) {
  Pair total = both(0.0);
  Value last;
  int lane = 0;
  for (; lane < count; lane += kPair) {
    const Value first = evaluate(points[lane], solver);
    last = lane + 1 < count ? evaluate(points[lane + 1], solver) : first;
    put(first, last, lane, tile);
    total += (first.low + first.high) + (last.low + last.high);
  }
  for (; lane < kQpTile; lane += kPair) put(last, last, lane, tile);
  tile.finite += both(0.0) * total;
}

/// Raises `worst` to what one plane whose normal is an axis leaves of each point.
void scan_axis(const QpUnitPlane& plane, const Tile& tile, Pair* worst) {
  const double* at = tile.at[plane.axis];
  if (plane.facing == QpFacing::kUp) {
    const Pair upper = both(plane.offset);
    for (int i = 0; i < kTilePairs; ++i) worst[i] = larger_of(pair(at + kPair * i) - upper, worst[i]);
    return;
  }
  const Pair lower = both(-plane.offset);
  for (int i = 0; i < kTilePairs; ++i) worst[i] = larger_of(lower - pair(at + kPair * i), worst[i]);
}

/// normal . point for two points of the tile.
Pair height(const Pair* normal, const Tile& tile, int lane) {
  const Pair sum_xy = normal[0] * pair(tile.at[0] + lane) + normal[1] * pair(tile.at[1] + lane);
  return sum_xy + normal[2] * pair(tile.at[2] + lane);
}

/// The largest violation of each point of the tile; true where one is positive.
bool scan_planes(const QpUnitPlane* planes, int count, Tile& tile) {
  Pair worst[kTilePairs];
  for (int i = 0; i < kTilePairs; ++i) worst[i] = both(kNoViolation);
  for (int p = 0; p < count; ++p) {
    const QpUnitPlane& plane = planes[p];
    if (plane.facing <= QpFacing::kDown) {
      scan_axis(plane, tile, worst);
      continue;
    }
    const Pair normal[kQpAxes] = {both(plane.normal[0]), both(plane.normal[1]), both(plane.normal[2])};
    const Pair upper = both(plane.offset);
    if (plane.facing == QpFacing::kSlab && p + 1 < count) {
      const Pair lower = both(-planes[++p].offset);
      for (int i = 0; i < kTilePairs; ++i) {
        const Pair at = height(normal, tile, kPair * i);
        worst[i] = larger_of(lower - at, larger_of(at - upper, worst[i]));
      }
      continue;
    }
    for (int i = 0; i < kTilePairs; ++i) {
      worst[i] = larger_of(height(normal, tile, kPair * i) - upper, worst[i]);
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

/// Takes the point's worst row where it is the best so far; returns how far it is violated as a distance in the metric.
double consider(const QpProblem& problem, QpSolver& solver, int group, int point, double violation, Scan& scan) {
  solver.worst = larger(solver.worst, violation);
  if (!(violation > kQpEntering) || !finite(violation) || scan.constant) return 0.0;
  const double inverse = inverse_norm(problem, solver, point);
  const bool constant = !(inverse > 0.0);
  const double distance = violation * inverse;
  if (!constant && !(distance > scan.distance)) return distance;
  scan.group = group;
  scan.point = point;
  scan.violation = violation;
  scan.distance = distance;
  scan.constant = constant;
  return distance;
}

/// True where this pass leaves the tile out.
bool passes_over(const QpSolver& solver, int index, const Scan& scan) {
  if (solver.scans == 0 || index >= kQpMaxTiles) return scan.rest && solver.scans > 0;
  if (scan.rest) return solver.seen[index] == solver.scans;
  return solver.scans - solver.seen[index] < kPatience && solver.found[index] <= kWorthwhile * solver.entered;
}

/// Looks at a tile and returns the distance of its most violated row; 0 where none is violated.
double look(const QpProblem& problem, QpSolver& solver, int group, int begin, int count, Scan& scan) {
  const QpGroup& g = problem.groups[group];
  fill(problem.points + begin, count, solver, scan.tile);
  if (!scan_planes(solver.planes + g.plane_begin, g.plane_end - g.plane_begin, scan.tile)) return 0.0;
  double distance = 0.0;
  for (int lane = 0; lane < count; ++lane) {
    const double violation = scan.tile.worst[lane];
    if (!(violation > 0.0)) continue;
    distance = larger(distance, consider(problem, solver, group, begin + lane, violation, scan));
  }
  return distance;
}

void scan_group(const QpProblem& problem, QpSolver& solver, int group, Scan& scan) {
  const QpGroup& g = problem.groups[group];
  for (int begin = g.point_begin; begin < g.point_end; begin += kQpTile) {
    const int tile = scan.tiles++;
    if (passes_over(solver, tile, scan)) {
      scan.skipped = true;
      continue;
    }
    const int left = g.point_end - begin;
    const double distance = look(problem, solver, group, begin, left < kQpTile ? left : kQpTile, scan);
    if (tile >= kQpMaxTiles) continue;
    solver.seen[tile] = solver.scans;
    solver.found[tile] = distance;
  }
}

void scan_rows(const QpProblem& problem, QpSolver& solver, Scan& scan) {
  scan.tiles = 0;
  for (int g = 0; g < problem.group_count; ++g) scan_group(problem, solver, g, scan);
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

void forget_scans(QpSolver& solver) {
  solver.scans = 0;
}

Candidate price(const QpProblem& problem, QpSolver& solver) {
  Scan scan;
  scan.tile.finite = both(0.0);
  solver.worst = 0.0;
  scan_rows(problem, solver, scan);
  if (scan.group < 0 && scan.skipped) {
    scan.rest = true;
    scan_rows(problem, solver, scan);
  }
  if (!finite(sum(scan.tile.finite))) solver.worst = kNoNumber;
  ++solver.scans;
  solver.entered = scan.distance;
  if (scan.group < 0) return {};
  const int plane = worst_plane(problem, solver, problem.groups[scan.group], scan.point);
  return {true, scan.constant, {scan.point, plane}, scan.violation};
}

}  // namespace tern::qp
