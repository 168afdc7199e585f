// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "qp/operations.hpp"
#include "qp/parts.hpp"
#include "qp/point_batch.hpp"

namespace tern::qp {
namespace {

/// Above every possible violation. It marks a point that is NaN or infinite.
constexpr double kNoNumber = 1e300;

/// A batch is skipped while its worst violation is below this share of the last entering constraint's.
constexpr double kWorthwhile = 0.3;
/// No batch is skipped for kPassPeriod passes in a row. So newly violated constraints need not wait until all others
/// are satisfied.
constexpr int kPassPeriod = 6;
/// After a pass, only the worst point of each promising batch is priced again. If the worst violation there exceeds
/// this share of the last entering constraint's, its constraint enters without a pass.
constexpr double kEntersWithoutPass = 0.5;

/// A pass in progress: the best constraint so far, and how far the pass has come.
struct Pass {
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

/// Takes the point's worst constraint if it is the best so far. Returns its violation as a distance in the metric.
double consider(const QpProblem& problem, QpSolver& solver, int group, int point, double violation, Pass& pass) {
  solver.worst = larger(solver.worst, violation);
  if (problem.points[point].terms == 0) solver.constant_worst = larger(solver.constant_worst, violation);
  if (!(violation > kQpEntering) || !finite(violation) || pass.constant) return 0.0;
  const double inverse = inverse_norm(problem, solver, point);
  const bool constant = !(inverse > 0.0);
  const double distance = violation * inverse;
  if (!constant && !(distance > pass.distance)) return distance;
  pass.group = group;
  pass.point = point;
  pass.violation = violation;
  pass.distance = distance;
  pass.constant = constant;
  return distance;
}

bool promising(const QpSolver& solver, const QpPrice& last) {
  return last.distance > kWorthwhile * solver.entered;
}

/// True if this pass skips the batch.
bool passes_over(const QpSolver& solver, int index, const Pass& pass) {
  if (solver.passes == 0 || index >= kQpMaxBatches) return pass.rest && solver.passes > 0;
  const QpPrice& last = solver.prices[index];
  if (pass.rest) return last.pass == solver.passes;
  return solver.passes - last.pass < kPassPeriod && !promising(solver, last);
}

/// Prices points [begin, end) of a group, kQpBatch at most. Fills `result` in place, because copying it would have to
/// wait for its parts.
void price_batch(const QpProblem& problem, QpSolver& solver, int group, int begin, int end, Pass& pass,
                 QpPrice& result) {
  result.distance = 0.0;
  result.point = begin;
  result.group = group;
  result.pass = solver.passes;
  if (begin >= end) return;
  PointBatch batch;
  pass.numbers += fill(problem.points + begin, end - begin, solver, batch);
  const int plane_end = problem.groups[group].plane_end;
  const int planes = plane_end - solver.screens[group].oblique;
  const bool alone = end - begin == 1;
  solver.spent += price_operations(alone, planes);
  if (!find_worst(solver.planes, solver.screens[group], plane_end, end - begin, batch)) return;
  for (int point = begin; point < end; ++point) {
    const double violation = batch.worst[point - begin];
    if (!(violation > 0.0)) continue;
    const double distance = consider(problem, solver, group, point, violation, pass);
    if (!(distance > result.distance)) continue;
    result.distance = distance;
    result.point = point;
  }
}

/// Prices the batches of a group. The first pass prices all points, later passes only those that depend on unknowns.
void pass_over_group(const QpProblem& problem, QpSolver& solver, int group, Pass& pass) {
  const QpGroup& g = problem.groups[group];
  const QpScreen& screen = solver.screens[group];
  const int first = solver.passes == 0 ? g.point_begin : screen.moving_begin;
  const int last = solver.passes == 0 ? g.point_end : screen.moving_end;
  QpPrice unkept;
  for (int at = g.point_begin; at < g.point_end; at += kQpBatch) {
    const int batch = pass.batches++;
    if (passes_over(solver, batch, pass)) {
      pass.skipped = true;
      continue;
    }
    const int begin = at < first ? first : at;
    const int end = at + kQpBatch < last ? at + kQpBatch : last;
    price_batch(problem, solver, group, begin, end, pass, batch < kQpMaxBatches ? solver.prices[batch] : unkept);
  }
}

/// Prices the worst point of each promising batch again, and nothing else.
void pass_over_promising(const QpProblem& problem, QpSolver& solver, Pass& pass) {
  QpPrice unkept;
  solver.spent += 2 * ops::kTurn * solver.batches;
  for (int t = 0; t < solver.batches; ++t) {
    const QpPrice& last = solver.prices[t];
    if (promising(solver, last)) price_batch(problem, solver, last.group, last.point, last.point + 1, pass, unkept);
  }
}

void pass_over_constraints(const QpProblem& problem, QpSolver& solver, Pass& pass) {
  pass.batches = 0;
  for (int g = 0; g < problem.group_count; ++g) pass_over_group(problem, solver, g, pass);
  solver.spent += 2 * ops::kTurn * (pass.batches + problem.group_count);
}

/// The plane that the point violates most; of equals, the first. A pass adds in a different order, so the violation
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

Candidate candidate_of(const QpProblem& problem, QpSolver& solver, const Pass& pass) {
  solver.entered = pass.distance;
  if (pass.group < 0) return {};
  const QpGroup& group = problem.groups[pass.group];
  solver.spent += price_operations(true, group.plane_end - group.plane_begin);
  const int plane = violated_plane(problem, solver, group, pass.point);
  return {true, pass.constant, {pass.point, plane}, pass.violation};
}

}  // namespace

void forget_lengths(const QpProblem& problem, QpSolver& solver) {
  for (int k = 0; k < problem.point_count; ++k) solver.inverse_norm[k] = -1.0;
  solver.inverse_known = false;
}

void forget_passes(QpSolver& solver) {
  solver.passes = 0;
  solver.found_by_pass = true;
  solver.constant_worst = 0.0;
}

Candidate price(const QpProblem& problem, QpSolver& solver) {
  if (solver.passes > 0 && solver.found_by_pass && !solver.cautious) {
    Pass best;
    pass_over_promising(problem, solver, best);
    solver.found_by_pass = !(best.distance > kEntersWithoutPass * solver.entered);
    if (!solver.found_by_pass) return candidate_of(problem, solver, best);
  }
  Pass pass;
  solver.worst = solver.passes == 0 ? 0.0 : solver.constant_worst;
  pass_over_constraints(problem, solver, pass);
  if (pass.group < 0 && pass.skipped) {
    pass.rest = true;
    pass_over_constraints(problem, solver, pass);
  }
  if (!finite(sum(pass.numbers))) solver.worst = kNoNumber;
  ++solver.passes;
  solver.found_by_pass = true;
  solver.batches = pass.batches < kQpMaxBatches ? pass.batches : kQpMaxBatches;
  return candidate_of(problem, solver, pass);
}

}  // namespace tern::qp
