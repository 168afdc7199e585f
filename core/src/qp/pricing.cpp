// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "qp/pricing.hpp"

#include "base/math.hpp"
#include "qp/hessian.hpp"
#include "qp/operations.hpp"
#include "qp/point_batch.hpp"

namespace tern::qp {
namespace {

/// Above every possible violation. It marks a point that is NaN or infinite.
constexpr double kNoNumber = 1e300;

/// A batch is skipped while the worst violation found in it is below this share of that of the row that entered last.
constexpr double kWorthwhile = 0.3;
/// No batch is skipped for kScanPeriod scans in a row. So newly violated rows need not wait until all others are
/// satisfied.
constexpr int kScanPeriod = 6;
/// After a scan, only the worst point of each promising batch is priced again. If the worst of them is still violated
/// by more than this share of the row that entered last, its row enters without a scan.
constexpr double kEntersUnscanned = 0.5;

/// A scan in progress: the best row so far, and how far the scan has come.
struct Scan {
  Pair numbers = both(0.0);  ///< 0 times the sum of all coordinates so far: 0 if all were finite
  int group = -1;
  int point = -1;
  double violation = 0.0;
  double distance = 0.0;
  bool constant = false;
  int batches = 0;    ///< counted over all groups
  bool rest = false;  ///< true: price the batches that were skipped; false: the promising ones
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

bool promising(const QpSolver& solver, const QpPrice& last) {
  return last.distance > kWorthwhile * solver.entered;
}

/// True if this pass skips the batch.
bool passes_over(const QpSolver& solver, int index, const Scan& scan) {
  if (solver.scans == 0 || index >= kQpMaxBatches) return scan.rest && solver.scans > 0;
  const QpPrice& last = solver.prices[index];
  if (scan.rest) return last.scan == solver.scans;
  return solver.scans - last.scan < kScanPeriod && !promising(solver, last);
}

/// Prices points [begin, end) of a group, kQpBatch at most. Fills `result` in place, because copying it would have to
/// wait for its parts.
void price_batch(const QpProblem& problem, QpSolver& solver, int group, int begin, int end, Scan& scan,
                 QpPrice& result) {
  result.distance = 0.0;
  result.point = begin;
  result.group = group;
  result.scan = solver.scans;
  if (begin >= end) return;
  PointBatch batch;
  scan.numbers += fill(problem.points + begin, end - begin, solver, batch);
  const int plane_end = problem.groups[group].plane_end;
  const int planes = plane_end - solver.screens[group].oblique;
  const bool alone = end - begin == 1;
  solver.spent += price_operations(alone, planes);
  if (!qp::scan(solver.planes, solver.screens[group], plane_end, end - begin, batch)) return;
  for (int point = begin; point < end; ++point) {
    const double violation = batch.worst[point - begin];
    if (!(violation > 0.0)) continue;
    const double distance = consider(problem, solver, group, point, violation, scan);
    if (!(distance > result.distance)) continue;
    result.distance = distance;
    result.point = point;
  }
}

/// Prices the batches of a group. The first scan prices all points, later scans only those that depend on unknowns.
void scan_group(const QpProblem& problem, QpSolver& solver, int group, Scan& scan) {
  const QpGroup& g = problem.groups[group];
  const QpScreen& screen = solver.screens[group];
  const int first = solver.scans == 0 ? g.point_begin : screen.moving_begin;
  const int last = solver.scans == 0 ? g.point_end : screen.moving_end;
  QpPrice unkept;
  for (int at = g.point_begin; at < g.point_end; at += kQpBatch) {
    const int batch = scan.batches++;
    if (passes_over(solver, batch, scan)) {
      scan.skipped = true;
      continue;
    }
    const int begin = at < first ? first : at;
    const int end = at + kQpBatch < last ? at + kQpBatch : last;
    price_batch(problem, solver, group, begin, end, scan, batch < kQpMaxBatches ? solver.prices[batch] : unkept);
  }
}

/// Prices the worst point of each promising batch again, and nothing else.
void scan_promising(const QpProblem& problem, QpSolver& solver, Scan& scan) {
  QpPrice unkept;
  solver.spent += 2 * ops::kTurn * solver.batches;
  for (int t = 0; t < solver.batches; ++t) {
    const QpPrice& last = solver.prices[t];
    if (promising(solver, last)) price_batch(problem, solver, last.group, last.point, last.point + 1, scan, unkept);
  }
}

void scan_rows(const QpProblem& problem, QpSolver& solver, Scan& scan) {
  scan.batches = 0;
  for (int g = 0; g < problem.group_count; ++g) scan_group(problem, solver, g, scan);
  solver.spent += 2 * ops::kTurn * (scan.batches + problem.group_count);
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
  const QpGroup& group = problem.groups[scan.group];
  solver.spent += price_operations(true, group.plane_end - group.plane_begin);
  const int plane = violated_plane(problem, solver, group, scan.point);
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
    Scan best;
    scan_promising(problem, solver, best);
    solver.scanned = !(best.distance > kEntersUnscanned * solver.entered);
    if (!solver.scanned) return candidate_of(problem, solver, best);
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
  solver.batches = scan.batches < kQpMaxBatches ? scan.batches : kQpMaxBatches;
  return candidate_of(problem, solver, scan);
}

}  // namespace tern::qp
