// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "qp/rows.hpp"

#include "base/math.hpp"

namespace tern::qp {
namespace {

/// Squared lengths in this range neither overflow nor lose digits.
constexpr double kSmallSquare = 1e-200;
constexpr double kLargeSquare = 1e200;
/// A normal whose squared length is this close to 1 is unit.
constexpr double kUnitTolerance = 1e-14;

/// The axis that the unit normal lies along, -1 for none.
int axis_of(const QpUnitPlane& plane) {
  for (int a = 0; a < kQpAxes; ++a) {
    if (absolute(plane.normal[a]) < 1.0) continue;
    const double rest = absolute(plane.normal[(a + 1) % kQpAxes]) + absolute(plane.normal[(a + 2) % kQpAxes]);
    return rest > 0.0 ? -1 : a;
  }
  return -1;
}

bool in_group(const QpGroup& group, const QpRow& row) {
  return row.point >= group.point_begin && row.point < group.point_end && row.plane >= group.plane_begin &&
         row.plane < group.plane_end;
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
    unit.normal[0] = scale * plane.normal.x;
    unit.normal[1] = scale * plane.normal.y;
    unit.normal[2] = scale * plane.normal.z;
    unit.offset = scale * plane.offset;
    unit.axis = axis_of(unit);
    if (!(scale > 0.0) && plane.offset < 0.0) {
      unit.offset = -1.0;
      solver.contradictory = true;
    }
    numbers = numbers && finite(plane.normal) && finite(unit.offset);
  }
  return numbers;
}

double unit_violation(const QpProblem& problem, const QpSolver& solver, const QpRow& row) {
  return violation_at(evaluate(problem.points[row.point], solver), solver.planes[row.plane]);
}

bool is_row(const QpProblem& problem, const QpRow& row) {
  for (int g = 0; g < problem.group_count; ++g) {
    if (in_group(problem.groups[g], row)) return true;
  }
  return false;
}

bool find_contradiction(const QpProblem& problem, QpRow& row) {
  for (int g = 0; g < problem.group_count; ++g) {
    const QpGroup& group = problem.groups[g];
    if (group.point_begin >= group.point_end) continue;
    for (int p = group.plane_begin; p < group.plane_end; ++p) {
      const Halfspace& plane = problem.planes[p];
      row = {group.point_begin, p};
      if (plane.offset < 0.0 && !(inverse_length(plane) > 0.0)) return true;
    }
  }
  return false;
}

}  // namespace tern::qp
