// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/corridor_programme.hpp"

#include <algorithm>
#include <cmath>

#include "curve/hermite.hpp"

namespace tern_host {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

double dot(const tern::Vec3& a, const tern::Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

void add(double s, const tern::Vec3& v, tern::Vec3& sum) {
  sum.x += s * v.x;
  sum.y += s * v.y;
  sum.z += s * v.z;
}

double largest(const tern::Vec3& v, double s) {
  return s * std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

double choose(int n, int k) {
  double value = 1.0;
  for (int i = 0; i < k; ++i) value = value * (n - i) / (i + 1);
  return value;
}

double sign(int n) {
  return n % 2 == 0 ? 1.0 : -1.0;
}

/// Finite difference of the given order, from control point i on.
tern::Vec3 difference(const ControlPoints& points, int i, int order) {
  tern::Vec3 v{};
  for (int k = 0; k <= order; ++k) add(sign(order - k) * choose(order, k), points[at(i + k)], v);
  return v;
}

/// Control point i of snap over normalised time.
tern::Vec3 snap(const ControlPoints& points, int i) {
  tern::Vec3 v{};
  add(840.0, difference(points, i, 4), v);
  return v;
}

/// Integral over [0, 1] of the product of two cubic Bernstein polynomials.
double gram(int i, int j) {
  return choose(3, i) * choose(3, j) / (choose(6, i + j) * 7.0);
}

/// Element of the snap Gram matrix of degree 7.
double snap_gram(int k, int l) {
  double total = 0.0;
  for (int i = std::max(0, k - 4); i <= std::min(3, k); ++i) {
    for (int j = std::max(0, l - 4); j <= std::min(3, l); ++j) {
      total += 840.0 * 840.0 * sign(k - i) * choose(4, k - i) * sign(l - j) * choose(4, l - j) * gram(i, j);
    }
  }
  return total;
}

}  // namespace

CorridorProgramme::CorridorProgramme(const CorridorCase& c, bool moved) : c_(c) {
  for (const double t : c.durations) tau_ += t / c.segments;
  if (moved) add(1.0, c.shift, c_.start[0]);
  for (int k = 0; k < 8; ++k) {
    for (int l = 0; l < 8; ++l) {
      largest_gram_ = std::max(largest_gram_, std::fabs(snap_gram(k, l)));
    }
  }
  const int first = c.start_jerk_fixed ? 0 : 1;
  unknowns_ = first + 4 * (c.segments - 1) + (c.goal_jerk_fixed ? 0 : 1);
}

void CorridorProgramme::assemble(tern::QpProblem& problem) const {
  problem.unknowns = unknowns_;
  problem.point_count = problem.plane_count = problem.group_count = 0;
  for (int i = 0; i < unknowns_; ++i) {
    for (double& h : problem.hessian[i]) h = 0.0;
    for (auto& f : problem.linear) f[i] = 0.0;
  }
  for (int s = 0; s < c_.segments; ++s) add_cost(s, problem);
  for (int s = 0; s < c_.segments; ++s) add_corridor(s, problem);
  add_limits(1, c_.v_max, problem);
  add_limits(2, c_.a_max, problem);
}

std::vector<ControlPoints> CorridorProgramme::control_points(const tern::QpSolution& solution) const {
  std::vector<ControlPoints> result;
  for (int s = 0; s < c_.segments; ++s) {
    ControlPoints points{};
    for (int k = 0; k < 8; ++k) {
      for (int i = 0; i < 8; ++i) add(control_point(s, k)[at(i)], state(s, i, solution), points[at(k)]);
    }
    result.push_back(points);
  }
  return result;
}

double CorridorProgramme::objective(const tern::QpSolution& solution) const {
  const std::vector<ControlPoints> points = control_points(solution);
  double total = 0.0;
  for (int s = 0; s < c_.segments; ++s) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        total += gram(i, j) * cost_of(s) * dot(snap(points[at(s)], i), snap(points[at(s)], j));
      }
    }
  }
  return total;
}

double CorridorProgramme::violation(const tern::QpSolution& solution) const {
  const std::vector<ControlPoints> points = control_points(solution);
  double worst = 0.0;
  for (int s = 0; s < c_.segments; ++s) {
    const ControlPoints& p = points[at(s)];
    for (const tern::Halfspace& plane : c_.planes[at(s)]) {
      for (const tern::Vec3& q : p) worst = std::max(worst, dot(plane.normal, q) - plane.offset);
    }
    const double t = c_.durations[at(s)];
    for (int i = 0; i < 7; ++i) worst = std::max(worst, largest(difference(p, i, 1), 7.0 / t) - c_.v_max);
    for (int i = 0; i < 6; ++i) worst = std::max(worst, largest(difference(p, i, 2), 42.0 / (t * t)) - c_.a_max);
  }
  return worst;
}

/// Factor of segment s in the scaled objective: tau^7 / (T^7 * largest element of the Gram matrix).
double CorridorProgramme::cost_of(int s) const {
  return std::pow(tau_ / c_.durations[at(s)], 7) / largest_gram_;
}

/// Control point k of a segment as a combination of the states at its ends.
CorridorProgramme::Local CorridorProgramme::control_point(int s, int k) const {
  Local weights{};
  const bool right = k > 3;
  const int steps = right ? 7 - k : k;
  double factor = 1.0;
  for (int d = 0; d < 4; ++d) {
    weights[at(d + (right ? 4 : 0))] = choose(steps, d) * factor;
    factor *= (right ? -1.0 : 1.0) * c_.durations[at(s)] / tau_ / (7 - d);
  }
  return weights;
}

/// Control point i of the hodograph of the given order.
CorridorProgramme::Local CorridorProgramme::hodograph(int s, int i, int order) const {
  Local weights{};
  double scale = 1.0;
  for (int d = 0; d < order; ++d) scale *= (7 - d) / c_.durations[at(s)];
  for (int k = 0; k <= order; ++k) {
    const Local point = control_point(s, i + k);
    for (int w = 0; w < 8; ++w) weights[at(w)] += scale * sign(order - k) * choose(order, k) * point[at(w)];
  }
  return weights;
}

/// Index of a local state among the unknowns; -1 where it is given.
int CorridorProgramme::unknown(int s, int i) const {
  const int joint = s + i / 4;
  const int first = c_.start_jerk_fixed ? 0 : 1;
  if (joint == 0) return i == 3 && !c_.start_jerk_fixed ? 0 : -1;
  if (joint == c_.segments) return i == 7 && !c_.goal_jerk_fixed ? unknowns_ - 1 : -1;
  return first + 4 * (joint - 1) + i % 4;
}

/// The part of a local state that is given.
tern::Vec3 CorridorProgramme::given(int s, int i) const {
  const int joint = s + i / 4;
  tern::Vec3 v{};
  if (unknown(s, i) >= 0) return i % 4 == 0 ? c_.waypoints[at(joint)] : v;
  if (joint == c_.segments) return i == 4 ? c_.goal : v;
  add(std::pow(tau_, i), c_.start[at(i)], v);
  return v;
}

tern::Vec3 CorridorProgramme::state(int s, int i, const tern::QpSolution& solution) const {
  tern::Vec3 v = given(s, i);
  const int u = unknown(s, i);
  if (u >= 0) add(1.0, {solution.x[0][u], solution.x[1][u], solution.x[2][u]}, v);
  return v;
}

/// Element of the snap form of a segment in the states at its ends. From exact integers: the sum over control points
/// would lose digits that segments of very unequal durations need.
double CorridorProgramme::curvature(int s, int i, int j) const {
  return tern::kSnapForm[i][j] * std::pow(c_.durations[at(s)] / tau_, i % 4 + j % 4);
}

void CorridorProgramme::add_cost(int s, tern::QpProblem& problem) const {
  for (int i = 0; i < 8; ++i) {
    const int row = unknown(s, i);
    if (row < 0) continue;
    for (int j = 0; j < 8; ++j) {
      const double h = 2.0 * cost_of(s) * curvature(s, i, j);
      const int column = unknown(s, j);
      if (column >= 0 && column <= row) problem.hessian[row][row - column] += h;
      const tern::Vec3 fixed = given(s, j);
      problem.linear[0][row] += h * fixed.x;
      problem.linear[1][row] += h * fixed.y;
      problem.linear[2][row] += h * fixed.z;
    }
  }
}

/// Only the span of unknowns with a weight counts: the control points next to a joint depend on that joint alone.
void CorridorProgramme::add_point(int s, const Local& weights, tern::QpProblem& problem) const {
  tern::QpPoint& point = problem.points[problem.point_count++];
  point = {};
  int first = unknowns_;
  int last = -1;
  for (int i = 0; i < 8; ++i) {
    add(weights[at(i)], given(s, i), point.offset);
    if (unknown(s, i) < 0 || std::fabs(weights[at(i)]) <= 0.0) continue;
    first = std::min(first, unknown(s, i));
    last = std::max(last, unknown(s, i));
  }
  if (last < 0) return;
  point.first = static_cast<std::int16_t>(first);
  point.terms = static_cast<std::int16_t>(last - first + 1);
  for (int i = 0; i < 8; ++i) {
    const int u = unknown(s, i);
    if (u >= first && u <= last) point.coefficient[u - first] += weights[at(i)];
  }
}

void CorridorProgramme::add_corridor(int s, tern::QpProblem& problem) const {
  tern::QpGroup& group = problem.groups[problem.group_count++];
  group.point_begin = problem.point_count;
  for (int k = 0; k < 8; ++k) add_point(s, control_point(s, k), problem);
  group.point_end = problem.point_count;
  group.plane_begin = problem.plane_count;
  for (const tern::Halfspace& plane : c_.planes[at(s)]) problem.planes[problem.plane_count++] = plane;
  group.plane_end = problem.plane_count;
}

void CorridorProgramme::add_limits(int order, double limit, tern::QpProblem& problem) const {
  tern::QpGroup& group = problem.groups[problem.group_count++];
  group.point_begin = problem.point_count;
  for (int s = 0; s < c_.segments; ++s) {
    for (int i = 0; i + order < 8; ++i) add_point(s, hodograph(s, i, order), problem);
  }
  group.point_end = problem.point_count;
  group.plane_begin = problem.plane_count;
  for (const double side : {1.0, -1.0}) {
    problem.planes[problem.plane_count++] = {{side, 0.0, 0.0}, limit};
    problem.planes[problem.plane_count++] = {{0.0, side, 0.0}, limit};
    problem.planes[problem.plane_count++] = {{0.0, 0.0, side}, limit};
  }
  group.plane_end = problem.plane_count;
}

}  // namespace tern_host
