// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "qp/parts.hpp"

namespace tern::qp {
namespace {

/// Squared lengths within this range neither overflow nor lose digits.
constexpr double kSmallSquare = 1e-200;
constexpr double kLargeSquare = 1e200;
/// A normal whose squared length is this close to 1 is unit.
constexpr double kUnitTolerance = 1e-14;

/// 1 / length of a normal whose squared length is outside kSmallSquare .. kLargeSquare; 0 for a zero normal.
double careful_inverse(const Vec3& n) {
  const double largest = larger(larger(absolute(n.x), absolute(n.y)), absolute(n.z));
  if (!(largest > 0.0)) return 0.0;
  const Vec3 scaled = {n.x / largest, n.y / largest, n.z / largest};
  return 1.0 / largest / square_root(dot(scaled, scaled));
}

/// Makes one normal a unit vector. Returns 0 if it is finite.
double take_normal(const Halfspace& plane, int p, QpUnitPlanes& planes) {
  const double scale = inverse_length(plane);
  planes.scale[p] = scale;
  planes.normal[0][p] = scale * plane.normal.x;
  planes.normal[1][p] = scale * plane.normal.y;
  planes.normal[2][p] = scale * plane.normal.z;
  planes.slab[p] = false;
  planes.zeros = planes.zeros || !(scale > 0.0);
  return 0.0 * ((planes.normal[0][p] + planes.normal[1][p]) + planes.normal[2][p]);
}

/// Makes two normals unit vectors, both at once if they already are. Returns 0 for each that is finite.
Pair take_two_normals(const Halfspace* two, int p, QpUnitPlanes& planes) {
  const Pair x = {two[0].normal.x, two[1].normal.x};
  const Pair y = {two[0].normal.y, two[1].normal.y};
  const Pair z = {two[0].normal.z, two[1].normal.z};
  const Pair excess = ((x * x + y * y) + z * z) - both(1.0);
  const Pair size = larger_of(excess, -excess);
  if (!(size[0] <= kUnitTolerance) || !(size[1] <= kUnitTolerance)) {
    return Pair{take_normal(two[0], p, planes), take_normal(two[1], p + 1, planes)};
  }
  store_two(x, planes.normal[0] + p);
  store_two(y, planes.normal[1] + p);
  store_two(z, planes.normal[2] + p);
  store_two(both(1.0), planes.scale + p);
  const double apart = absolute(x[0] + x[1]) + absolute(y[0] + y[1]) + absolute(z[0] + z[1]);
  planes.slab[p] = apart <= 0.0;
  planes.slab[p + 1] = false;
  return both(0.0);
}

/// Planes with a zero normal and a negative offset count as violated by 1.
void contradict_zeros(const QpProblem& problem, QpSolver& solver) {
  solver.contradictory = false;
  if (!solver.planes.zeros) return;
  for (int p = 0; p < problem.plane_count; ++p) {
    if (solver.planes.scale[p] > 0.0 || !(problem.planes[p].offset < 0.0)) continue;
    solver.planes.offset[p] = -1.0;
    solver.contradictory = true;
  }
}

/// Offset of a bound that does not exist.
constexpr double kFar = 1e300;

/// The axis along which a unit normal points: 0 .. 2 upwards, 3 .. 5 downwards; -1 for an oblique one. A normal that
/// rounding has tilted off an axis is oblique.
int axis_of(const QpUnitPlanes& planes, int p) {
  const double n[kQpAxes] = {planes.normal[0][p], planes.normal[1][p], planes.normal[2][p]};
  if (absolute(n[0]) + absolute(n[1]) + absolute(n[2]) > 1.0) return -1;
  for (int a = 0; a < kQpAxes; ++a) {
    if (n[a] >= 1.0) return a;
    if (n[a] <= -1.0) return kQpAxes + a;
  }
  return -1;
}

/// Makes the box of the group's first planes.
void make_box(const QpGroup& group, const QpUnitPlanes& planes, QpScreen& screen) {
  double low[kQpAxes] = {-kFar, -kFar, -kFar};
  double high[kQpAxes] = {kFar, kFar, kFar};
  for (int p = group.plane_begin; p < screen.oblique; ++p) {
    const int a = planes.axis[p];
    if (a < kQpAxes) {
      high[a] = smaller(high[a], planes.offset[p]);
    } else {
      low[a - kQpAxes] = larger(low[a - kQpAxes], -planes.offset[p]);
    }
  }
  for (int a = 0; a < kQpAxes; ++a) {
    pair(screen.low[a]) = both(low[a]);
    pair(screen.high[a]) = both(high[a]);
  }
}

void find_obliques(const QpProblem& problem, QpSolver& solver) {
  for (int g = 0; g < problem.group_count; ++g) {
    const QpGroup& group = problem.groups[g];
    QpUnitPlanes& planes = solver.planes;
    int p = group.plane_begin;
    for (; p < group.plane_end; ++p) {
      const int axis = axis_of(planes, p);
      if (axis < 0) break;
      planes.axis[p] = static_cast<std::int8_t>(axis);
    }
    solver.screens[g].oblique = p;
  }
}

bool in_group(const QpGroup& group, const QpConstraint& constraint) {
  return constraint.point >= group.point_begin && constraint.point < group.point_end &&
         constraint.plane >= group.plane_begin && constraint.plane < group.plane_end;
}

}  // namespace

double inverse_length(const Halfspace& plane) {
  const Vec3& n = plane.normal;
  const double squared = dot(n, n);
  if (absolute(squared - 1.0) <= kUnitTolerance) return 1.0;
  if (squared > kSmallSquare && squared < kLargeSquare) return 1.0 / square_root(squared);
  return careful_inverse(n);
}

bool prepare_normals(const QpProblem& problem, QpSolver& solver) {
  const int count = problem.plane_count;
  solver.planes.zeros = false;
  Pair numbers = both(0.0);
  int p = 0;
  for (; p + 1 < count; p += kPair) numbers += take_two_normals(problem.planes + p, p, solver.planes);
  if (p < count) numbers[0] += take_normal(problem.planes[p], p, solver.planes);
  find_obliques(problem, solver);
  return finite(sum(numbers));
}

bool prepare_offsets(const QpProblem& problem, QpSolver& solver) {
  const int count = problem.plane_count;
  Pair numbers = both(0.0);
  int p = 0;
  for (; p + 1 < count; p += kPair) {
    const Pair offset = {problem.planes[p].offset, problem.planes[p + 1].offset};
    store_two(load_two(solver.planes.scale + p) * offset, solver.planes.offset + p);
    numbers += both(0.0) * offset;
  }
  if (p < count) {
    solver.planes.offset[p] = solver.planes.scale[p] * problem.planes[p].offset;
    numbers[0] += 0.0 * problem.planes[p].offset;
  }
  contradict_zeros(problem, solver);
  for (int g = 0; g < problem.group_count; ++g) make_box(problem.groups[g], solver.planes, solver.screens[g]);
  return finite(sum(numbers));
}

void prepare_points(const QpProblem& problem, QpSolver& solver) {
  for (int g = 0; g < problem.group_count; ++g) {
    int begin = problem.groups[g].point_begin;
    int end = problem.groups[g].point_end;
    while (begin < end && problem.points[begin].terms == 0) ++begin;
    while (begin < end && problem.points[end - 1].terms == 0) --end;
    solver.screens[g].moving_begin = begin;
    solver.screens[g].moving_end = end;
  }
}

double unit_violation(const QpProblem& problem, const QpSolver& solver, const QpConstraint& constraint) {
  return violation_at(evaluate(problem.points[constraint.point], solver), solver.planes, constraint.plane);
}

bool is_constraint(const QpProblem& problem, const QpConstraint& constraint) {
  for (int g = 0; g < problem.group_count; ++g) {
    if (in_group(problem.groups[g], constraint)) return true;
  }
  return false;
}

bool find_contradiction(const QpProblem& problem, QpConstraint& constraint) {
  for (int g = 0; g < problem.group_count; ++g) {
    const QpGroup& group = problem.groups[g];
    if (group.point_begin >= group.point_end) continue;
    for (int p = group.plane_begin; p < group.plane_end; ++p) {
      const Halfspace& plane = problem.planes[p];
      constraint = {group.point_begin, p};
      if (plane.offset < 0.0 && !(inverse_length(plane) > 0.0)) return true;
    }
  }
  return false;
}

}  // namespace tern::qp
