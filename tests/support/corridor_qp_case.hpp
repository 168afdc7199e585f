// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Corridor optimisation problems from files: degree 7, C3, minimum snap, control points in polyhedra, velocity and
// acceleration limits on the control points of the hodographs. Host code: reads a case, makes the quadratic programme
// of it, and evaluates an answer through control points, which the solver knows nothing of.
#ifndef TERN_TESTS_SUPPORT_CORRIDOR_QP_CASE_HPP
#define TERN_TESTS_SUPPORT_CORRIDOR_QP_CASE_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "qp/qp.hpp"

namespace tern_test {

/// One file. SI units.
struct CorridorQpCase {
  std::string id;
  std::string kind;  ///< nom, thin, freejerk, tightdyn, infeas or dup
  int segments = 0;
  bool start_jerk_fixed = true;
  bool goal_jerk_fixed = true;
  double v_max = 0.0;
  double a_max = 0.0;
  std::array<tern::Vec3, 4> start{};  ///< position, velocity, acceleration, jerk
  tern::Vec3 goal{};                  ///< at rest
  tern::Vec3 shift{};                 ///< of the start, for the warm variant
  std::vector<double> durations;
  std::vector<tern::Vec3> waypoints;
  std::vector<std::vector<tern::Halfspace>> corridor;
};

inline tern::Vec3 read_vec(std::istream& in) {
  tern::Vec3 v{};
  in >> v.x >> v.y >> v.z;
  return v;
}

inline void read_record(const std::string& name, std::istream& in, CorridorQpCase& c) {
  std::string word;
  if (name == "id") {
    in >> c.id >> word >> c.kind;
  } else if (name == "M") {
    in >> c.segments;
    c.corridor.resize(static_cast<std::size_t>(std::max(c.segments, 0)));
    while (in >> word) {
      if (word == "start_jerk_fixed") in >> c.start_jerk_fixed;
      if (word == "goal_jerk_fixed") in >> c.goal_jerk_fixed;
    }
  } else if (name == "vmax") {
    in >> c.v_max >> word >> c.a_max;
  } else if (name == "start_p" || name == "start_v" || name == "start_a" || name == "start_j") {
    c.start[std::string("pvaj").find(name.back())] = read_vec(in);
  } else if (name == "goal_p") {
    c.goal = read_vec(in);
  } else if (name == "warm_dp") {
    c.shift = read_vec(in);
  } else if (name == "T") {
    for (double t = 0.0; in >> t;) c.durations.push_back(t);
  } else if (name == "wp") {
    c.waypoints.push_back(read_vec(in));
  } else if (name == "hs") {
    std::size_t segment = 0;
    in >> segment;
    tern::Halfspace plane{read_vec(in), 0.0};
    in >> plane.offset;
    c.corridor.at(segment).push_back(plane);
  }
}

/// False where the file cannot be read or is not whole.
inline bool read_case(const std::string& path, CorridorQpCase& c) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream in(line);
    std::string name;
    in >> name;
    read_record(name, in, c);
  }
  const auto m = static_cast<std::size_t>(c.segments);
  return m > 0 && c.durations.size() == m && c.waypoints.size() == m + 1;
}

/// A line of reference.csv; `warm` is of the shifted start.
struct CorridorQpReference {
  std::string id;
  bool feasible = false;
  double objective = 0.0;
  bool warm_feasible = false;
  double warm_objective = 0.0;
};

inline std::vector<CorridorQpReference> read_reference(const std::string& path) {
  std::vector<CorridorQpReference> lines;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    if (fields.size() < 8) continue;
    const auto number = [](const std::string& text) { return text.empty() ? 0.0 : std::stod(text); };
    lines.push_back(
        {fields[0], fields[1] == "feasible", number(fields[2]), fields[5] == "feasible", number(fields[6])});
  }
  return lines;
}

using Local = std::array<double, 8>;  ///< over position, velocity, acceleration, jerk at a segment's two ends

/// A case as a quadratic programme. Unknowns per axis: [start jerk,] p v a j of every inner joint [, goal jerk], with
/// positions relative to the waypoints and derivatives in units of the mean duration.
class CorridorQp {
 public:
  /// `moved`: the start is shifted.
  CorridorQp(const CorridorQpCase& c, bool moved) : c_(c) {
    for (const double t : c.durations) tau_ += t / c.segments;
    if (moved) {
      c_.start[0] = {c.start[0].x + c.shift.x, c.start[0].y + c.shift.y, c.start[0].z + c.shift.z};
    }
    for (int k = 0; k < 8; ++k) {
      for (int l = 0; l < 8; ++l) {
        gram_[at(k)][at(l)] = snap_gram(k, l);
        largest_gram_ = std::max(largest_gram_, std::fabs(gram_[at(k)][at(l)]));
      }
    }
    const int first = c.start_jerk_fixed ? 0 : 1;
    unknowns_ = first + 4 * (c.segments - 1) + (c.goal_jerk_fixed ? 0 : 1);
  }

  void assemble(tern::QpProblem& problem) const {
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

  /// Control points of every segment, from an answer.
  std::vector<std::array<tern::Vec3, 8>> control_points(const tern::QpSolution& solution) const {
    std::vector<std::array<tern::Vec3, 8>> result;
    for (int s = 0; s < c_.segments; ++s) {
      std::array<tern::Vec3, 8> points{};
      for (int k = 0; k < 8; ++k) {
        for (int i = 0; i < 8; ++i) add(control_point(s, k)[at(i)], state(s, i, solution), points[at(k)]);
      }
      result.push_back(points);
    }
    return result;
  }

  /// The scaled objective of the reference: cost_scale times the integral of snap squared, through snap's own control
  /// points.
  double objective(const tern::QpSolution& solution) const {
    const auto points = control_points(solution);
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

  /// Largest violation of any row, by control points: metres, m/s, m/s^2.
  double violation(const tern::QpSolution& solution) const {
    const auto points = control_points(solution);
    double worst = 0.0;
    for (int s = 0; s < c_.segments; ++s) {
      const auto& p = points[at(s)];
      for (const auto& plane : c_.corridor[at(s)]) {
        for (const auto& q : p) worst = std::max(worst, dot(plane.normal, q) - plane.offset);
      }
      const double t = c_.durations[at(s)];
      for (int i = 0; i < 7; ++i) worst = std::max(worst, largest(difference(p, i, 1), 7.0 / t) - c_.v_max);
      for (int i = 0; i < 6; ++i) worst = std::max(worst, largest(difference(p, i, 2), 42.0 / (t * t)) - c_.a_max);
    }
    return worst;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  static double dot(const tern::Vec3& a, const tern::Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  static void add(double s, const tern::Vec3& v, tern::Vec3& sum) {
    sum.x += s * v.x;
    sum.y += s * v.y;
    sum.z += s * v.z;
  }
  static double largest(const tern::Vec3& v, double s) {
    return s * std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  }
  static double choose(int n, int k) {
    double value = 1.0;
    for (int i = 0; i < k; ++i) value = value * (n - i) / (i + 1);
    return value;
  }
  static double sign(int n) { return n % 2 == 0 ? 1.0 : -1.0; }
  /// Finite difference of the given order, from control point i on.
  static tern::Vec3 difference(const std::array<tern::Vec3, 8>& points, int i, int order) {
    tern::Vec3 v{};
    for (int k = 0; k <= order; ++k) add(sign(order - k) * choose(order, k), points[at(i + k)], v);
    return v;
  }
  static tern::Vec3 snap(const std::array<tern::Vec3, 8>& points, int i) {
    tern::Vec3 v{};
    add(840.0, difference(points, i, 4), v);
    return v;
  }
  /// Integral over [0, 1] of the product of two cubic Bernstein polynomials.
  static double gram(int i, int j) { return choose(3, i) * choose(3, j) / (choose(6, i + j) * 7.0); }
  /// Element of the snap Gram matrix of degree 7.
  static double snap_gram(int k, int l) {
    double total = 0.0;
    for (int i = std::max(0, k - 4); i <= std::min(3, k); ++i) {
      for (int j = std::max(0, l - 4); j <= std::min(3, l); ++j) {
        total += 840.0 * 840.0 * sign(k - i) * choose(4, k - i) * sign(l - j) * choose(4, l - j) * gram(i, j);
      }
    }
    return total;
  }
  /// cost_scale / T^7.
  double cost_of(int s) const { return std::pow(tau_ / c_.durations[at(s)], 7) / largest_gram_; }

  /// Control point k of a segment as a combination of the states at its ends.
  Local control_point(int s, int k) const {
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
  Local hodograph(int s, int i, int order) const {
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
  int unknown(int s, int i) const {
    const int joint = s + i / 4;
    const int first = c_.start_jerk_fixed ? 0 : 1;
    if (joint == 0) return i == 3 && !c_.start_jerk_fixed ? 0 : -1;
    if (joint == c_.segments) return i == 7 && !c_.goal_jerk_fixed ? unknowns_ - 1 : -1;
    return first + 4 * (joint - 1) + i % 4;
  }
  /// The part of a local state that is given.
  tern::Vec3 given(int s, int i) const {
    const int joint = s + i / 4;
    tern::Vec3 v{};
    if (unknown(s, i) >= 0) return i % 4 == 0 ? c_.waypoints[at(joint)] : v;
    if (joint == c_.segments) return i == 4 ? c_.goal : v;
    add(std::pow(tau_, i), c_.start[at(i)], v);
    return v;
  }
  tern::Vec3 state(int s, int i, const tern::QpSolution& solution) const {
    tern::Vec3 v = given(s, i);
    const int u = unknown(s, i);
    if (u >= 0) add(1.0, {solution.x[0][u], solution.x[1][u], solution.x[2][u]}, v);
    return v;
  }

  void add_cost(int s, tern::QpProblem& problem) const {
    const double cost = 2.0 * cost_of(s);
    std::array<Local, 8> map{};
    for (int k = 0; k < 8; ++k) map[at(k)] = control_point(s, k);
    for (int i = 0; i < 8; ++i) {
      const int row = unknown(s, i);
      if (row < 0) continue;
      for (int j = 0; j < 8; ++j) {
        double h = 0.0;
        for (int k = 0; k < 8; ++k) {
          for (int l = 0; l < 8; ++l) {
            h += cost * gram_[at(k)][at(l)] * map[at(k)][at(i)] * map[at(l)][at(j)];
          }
        }
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
  void add_point(int s, const Local& weights, tern::QpProblem& problem) const {
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

  void add_corridor(int s, tern::QpProblem& problem) const {
    tern::QpGroup& group = problem.groups[problem.group_count++];
    group.point_begin = problem.point_count;
    for (int k = 0; k < 8; ++k) add_point(s, control_point(s, k), problem);
    group.point_end = problem.point_count;
    group.plane_begin = problem.plane_count;
    for (const auto& plane : c_.corridor[at(s)]) problem.planes[problem.plane_count++] = plane;
    group.plane_end = problem.plane_count;
  }

  void add_limits(int order, double limit, tern::QpProblem& problem) const {
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

  CorridorQpCase c_;
  std::array<Local, 8> gram_{};  ///< of snap, over control points
  double largest_gram_ = 0.0;
  double tau_ = 0.0;
  int unknowns_ = 0;
};

}  // namespace tern_test

#endif
