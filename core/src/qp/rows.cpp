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

/// 1 / length of a normal that is neither unit nor of an ordinary size.
double careful_inverse(const Vec3& n) {
  const double largest = larger(larger(absolute(n.x), absolute(n.y)), absolute(n.z));
  if (!(largest > 0.0)) return 0.0;
  const Vec3 scaled = {n.x / largest, n.y / largest, n.z / largest};
  return 1.0 / largest / square_root(dot(scaled, scaled));
}

/// How a unit normal lies, as long as nothing is known of the next plane. What rounding leaves beside an axis is none.
void face(QpUnitPlane& plane) {
  const double size[kQpAxes] = {absolute(plane.normal[0]), absolute(plane.normal[1]), absolute(plane.normal[2])};
  plane.facing = QpFacing::kOblique;
  if (size[0] + size[1] + size[2] > 1.0) return;
  for (int a = 0; a < kQpAxes; ++a) {
    if (size[a] < 1.0) continue;
    plane.facing = plane.normal[a] > 0.0 ? QpFacing::kUp : QpFacing::kDown;
    plane.axis = static_cast<std::uint8_t>(a);
  }
}

/// True where the normals are opposite to the last bit.
bool opposite(const QpUnitPlane& a, const QpUnitPlane& b) {
  if (absolute(a.normal[0] + b.normal[0]) > 0.0) return false;
  return absolute(a.normal[1] + b.normal[1]) + absolute(a.normal[2] + b.normal[2]) <= 0.0;
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
  return careful_inverse(n);
}

void prepare_normals(const QpProblem& problem, QpSolver& solver) {
  for (int p = 0; p < problem.plane_count; ++p) {
    const Halfspace& plane = problem.planes[p];
    QpUnitPlane& unit = solver.planes[p];
    unit.scale = inverse_length(plane);
    unit.normal[0] = unit.scale * plane.normal.x;
    unit.normal[1] = unit.scale * plane.normal.y;
    unit.normal[2] = unit.scale * plane.normal.z;
    face(unit);
    if (p == 0 || unit.facing != QpFacing::kOblique || solver.planes[p - 1].facing != QpFacing::kOblique) continue;
    if (opposite(solver.planes[p - 1], unit)) solver.planes[p - 1].facing = QpFacing::kSlab;
  }
}

bool prepare_offsets(const QpProblem& problem, QpSolver& solver) {
  double numbers = 0.0;
  solver.contradictory = false;
  for (int p = 0; p < problem.plane_count; ++p) {
    QpUnitPlane& unit = solver.planes[p];
    const double offset = problem.planes[p].offset;
    unit.offset = unit.scale * offset;
    numbers += 0.0 * ((unit.normal[0] + unit.normal[1]) + (unit.normal[2] + unit.offset));
    if (unit.scale > 0.0 || !(offset < 0.0)) continue;
    unit.offset = -1.0;
    solver.contradictory = true;
  }
  return finite(numbers);
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
