// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "qp/pricing.hpp"

#include "base/math.hpp"
#include "qp/hessian.hpp"
#include "qp/point_tile.hpp"

namespace tern::qp {
namespace {

/// Above every possible violation. It marks a point that is NaN or infinite.
constexpr double kNoNumber = 1e300;

/// A tile is skipped while the worst violation found in it is below this share of the one that entered last...
constexpr double kWorthwhile = 0.3;
/// ...but it is looked at in every kPatience-th scan at least, so that newly violated rows do not wait until all others
/// are satisfied.
constexpr int kPatience = 6;
/// After a scan, only the worst point of each promising tile is looked at again. If one of them is still violated by
/// more than this share of the row that entered last, its row enters without a scan.
constexpr double kFavourite = 0.5;

/// A scan in progress: the best row so far, and how far the scan has come.
struct Scan {
  Pair numbers = both(0.0);  ///< 0 times the sum of all coordinates so far: 0 if all were finite
  int group = -1;
  int point = -1;
  double violation = 0.0;
  double distance = 0.0;
  bool constant = false;
  int tiles = 0;      ///< counted over all groups
  bool rest = false;  ///< true: look at the tiles that were skipped; false: at the promising ones
  bool skipped = false;
};

double inverse_norm(const QpProblem& problem, QpSolver& solver, int point) {
  double& known = solver.inverse_norm[point];
  if (known < 0.0) known = point_inverse_norm(problem.points[point], solver);
  return known;
}

/// Takes the point's worst row if it is the best so far. Returns its violation as a distance in the metric.
double consider(const QpProblem& problem, QpSolver& solver, int group, int point, double violation, Scan& scan) {
  solver.worst = larger(solver.worst, violation);
  if (problem.points[point].terms == 0) solver.constant_worst = larger(solver.constant_worst, violation);
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

bool promising(const QpSolver& solver, const QpLook& last) {
  return last.distance > kWorthwhile * solver.entered;
}

/// True if this pass skips the tile.
bool passes_over(const QpSolver& solver, int index, const Scan& scan) {
  if (solver.scans == 0 || index >= kQpMaxTiles) return scan.rest && solver.scans > 0;
  const QpLook& last = solver.looks[index];
  if (scan.rest) return last.scan == solver.scans;
  return solver.scans - last.scan < kPatience && !promising(solver, last);
}

/// Looks at points [begin, end) of a group, kQpTile at most. Fills `result` in place, because copying it would have to
/// wait for its parts.
void look(const QpProblem& problem, QpSolver& solver, int group, int begin, int end, Scan& scan, QpLook& result) {
  result.distance = 0.0;
  result.point = begin;
  result.group = group;
  result.scan = solver.scans;
  if (begin >= end) return;
  PointTile tile;
  scan.numbers += fill(problem.points + begin, end - begin, solver, tile);
  const int plane_end = problem.groups[group].plane_end;
  if (!qp::scan(solver.planes, solver.screens[group], plane_end, end - begin, tile)) return;
  for (int point = begin; point < end; ++point) {
    const double violation = tile.worst[point - begin];
    if (!(violation > 0.0)) continue;
    const double distance = consider(problem, solver, group, point, violation, scan);
    if (!(distance > result.distance)) continue;
    result.distance = distance;
    result.point = point;
  }
}

/// Looks at the tiles of a group. The first scan looks at all points, later scans only at those that depend on
/// unknowns.
void scan_group(const QpProblem& problem, QpSolver& solver, int group, Scan& scan) {
  const QpGroup& g = problem.groups[group];
  const QpScreen& screen = solver.screens[group];
  const int first = solver.scans == 0 ? g.point_begin : screen.moving_begin;
  const int last = solver.scans == 0 ? g.point_end : screen.moving_end;
  QpLook unkept;
  for (int at = g.point_begin; at < g.point_end; at += kQpTile) {
    const int tile = scan.tiles++;
    if (passes_over(solver, tile, scan)) {
      scan.skipped = true;
      continue;
    }
    const int begin = at < first ? first : at;
    const int end = at + kQpTile < last ? at + kQpTile : last;
    look(problem, solver, group, begin, end, scan, tile < kQpMaxTiles ? solver.looks[tile] : unkept);
  }
}

/// Looks again at the worst point of each promising tile, and at nothing else.
void scan_favourites(const QpProblem& problem, QpSolver& solver, Scan& scan) {
  QpLook unkept;
  for (int t = 0; t < solver.tiles; ++t) {
    const QpLook& last = solver.looks[t];
    if (promising(solver, last)) look(problem, solver, last.group, last.point, last.point + 1, scan, unkept);
  }
}

void scan_rows(const QpProblem& problem, QpSolver& solver, Scan& scan) {
  scan.tiles = 0;
  for (int g = 0; g < problem.group_count; ++g) scan_group(problem, solver, g, scan);
}

/// The plane that the point violates most; of equals, the first. A scan adds in a different order, so the violation
/// that it found cannot be compared with the ones computed here.
int violated_plane(const QpProblem& problem, const QpSolver& solver, const QpGroup& group, int point) {
  const Value at = evaluate(problem.points[point], solver);
  int worst = group.plane_begin;
  double most = violation_at(at, solver.planes, worst);
  for (int plane = worst + 1; plane < group.plane_end; ++plane) {
    const double violation = violation_at(at, solver.planes, plane);
    if (!(violation > most)) continue;
    most = violation;
    worst = plane;
  }
  return worst;
}

Candidate candidate_of(const QpProblem& problem, QpSolver& solver, const Scan& scan) {
  solver.entered = scan.distance;
  if (scan.group < 0) return {};
  const int plane = violated_plane(problem, solver, problem.groups[scan.group], scan.point);
  return {true, scan.constant, {scan.point, plane}, scan.violation};
}

}  // namespace

void forget_lengths(const QpProblem& problem, QpSolver& solver) {
  for (int k = 0; k < problem.point_count; ++k) solver.inverse_norm[k] = -1.0;
  solver.inverse_known = false;
}

void forget_scans(QpSolver& solver) {
  solver.scans = 0;
  solver.scanned = true;
  solver.constant_worst = 0.0;
}

Candidate price(const QpProblem& problem, QpSolver& solver) {
  if (solver.scans > 0 && solver.scanned && !solver.cautious) {
    Scan favourites;
    scan_favourites(problem, solver, favourites);
    solver.scanned = !(favourites.distance > kFavourite * solver.entered);
    if (!solver.scanned) return candidate_of(problem, solver, favourites);
  }
  Scan scan;
  solver.worst = solver.scans == 0 ? 0.0 : solver.constant_worst;
  scan_rows(problem, solver, scan);
  if (scan.group < 0 && scan.skipped) {
    scan.rest = true;
    scan_rows(problem, solver, scan);
  }
  if (!finite(sum(scan.numbers))) solver.worst = kNoNumber;
  ++solver.scans;
  solver.scanned = true;
  solver.tiles = scan.tiles < kQpMaxTiles ? scan.tiles : kQpMaxTiles;
  return candidate_of(problem, solver, scan);
}

}  // namespace tern::qp
