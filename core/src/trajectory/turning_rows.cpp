// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/turning_rows.hpp"

#include "base/math.hpp"
#include "tern/flatness.hpp"

namespace tern {
namespace {

/// A share differs from 1 by no more than this.
constexpr double kStep = 0.1;

/// The first plane of an instant.
int plane_of(const ProgrammeScale& scale, int segment, int instant) {
  return scale.turning + kQpTurningPlanes * (kJerkPoints * segment + instant);
}

void add_planes(const TurningRows& rows, const ProgrammeScale& scale, QpProblem& problem) {
  Halfspace* const planes = problem.planes + problem.plane_count;
  const Vec3 side = cross(rows.thrust, rows.turn);
  planes[0] = Halfspace{-1.0 * rows.thrust, (kGravity * rows.thrust.z - rows.least) / scale.unit[2]};
  planes[1] = Halfspace{rows.turn, rows.most / scale.unit[3]};
  planes[2] = Halfspace{-1.0 * rows.turn, rows.most / scale.unit[3]};
  planes[3] = Halfspace{side, rows.side / scale.unit[3]};
  planes[4] = Halfspace{-1.0 * side, rows.side / scale.unit[3]};
  problem.plane_count += kQpTurningPlanes;
}

/// Puts the points of [begin, end), which are nearest to one instant, above its plane.
void add_floor(int begin, int end, const ProgrammeScale& scale, QpProblem& problem) {
  const PointOrigin& origin = scale.origin[begin];
  const int plane = plane_of(scale, origin.segment, nearest_jerk_point(origin.index));
  problem.groups[problem.group_count++] = QpGroup{begin, end, plane, plane + 1};
}

bool same_instant(const PointOrigin& a, const PointOrigin& b) {
  return a.segment == b.segment && nearest_jerk_point(a.index) == nearest_jerk_point(b.index);
}

}  // namespace

void add_turning_rows(const Turning& turning, int count, int accelerations, int jerks, ProgrammeScale& scale,
                      QpProblem& problem) noexcept {
  scale.turning = problem.plane_count;
  for (int i = 0; i < count; ++i) {
    for (const TurningRows& rows : turning.rows[i]) add_planes(rows, scale, problem);
  }
  int begin = accelerations;
  for (int p = accelerations; p < jerks; ++p) {
    if (p + 1 < jerks && same_instant(scale.origin[p], scale.origin[p + 1])) continue;
    add_floor(begin, p + 1, scale, problem);
    begin = p + 1;
  }
  for (int p = jerks; p < problem.point_count; ++p) {
    const int plane = plane_of(scale, scale.origin[p].segment, scale.origin[p].index);
    problem.groups[problem.group_count++] = QpGroup{p, p + 1, plane + 1, plane + kQpTurningPlanes};
  }
}

void share_turning(const QpProblem& problem, const QpSolution& solution, const ProgrammeScale& scale, int count,
                   Turning& turning) noexcept {
  for (int i = 0; i < count; ++i) {
    for (int r = 0; r < kJerkPoints; ++r) turning.share[i][r] = turning.worth[i][r] = 0.0;
  }
  for (int k = 0; k < solution.active_count; ++k) {
    const QpConstraint& active = solution.active[k];
    const PointOrigin& origin = scale.origin[active.point];
    if (origin.order < 2 || active.plane < scale.turning) continue;
    const int i = origin.segment;
    const int r = (active.plane - scale.turning) / kQpTurningPlanes % kJerkPoints;
    const bool jerk = origin.order == 3;
    const double bound = jerk ? problem.planes[active.plane].offset : turning.rows[i][r].least / scale.unit[2];
    turning.worth[i][r] += solution.multiplier[k] * bound;
    turning.share[i][r] += (jerk ? solution.multiplier[k] : -solution.multiplier[k]) * bound;
  }
  for (int i = 0; i < count; ++i) {
    for (int r = 0; r < kJerkPoints; ++r) {
      const double worth = turning.worth[i][r];
      turning.share[i][r] = worth > 0.0 ? 1.0 + kStep * turning.share[i][r] / worth : 1.0;
    }
  }
}

}  // namespace tern
