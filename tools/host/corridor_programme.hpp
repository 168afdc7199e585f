// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A corridor case as a quadratic programme, and an answer judged through control points, of which the solver knows
// nothing.
#ifndef TERN_HOST_CORRIDOR_PROGRAMME_HPP
#define TERN_HOST_CORRIDOR_PROGRAMME_HPP

#include <array>
#include <vector>

#include "host/corridor_case.hpp"
#include "qp/qp.hpp"

namespace tern_host {

using ControlPoints = std::array<tern::Vec3, 8>;  ///< of one segment, metres

/// Unknowns per axis: [start jerk,] p v a j of every inner joint [, goal jerk], with positions relative to the
/// waypoints and derivatives in units of the mean duration.
class CorridorProgramme {
 public:
  /// `moved`: the start is shifted.
  CorridorProgramme(const CorridorCase& c, bool moved);

  void assemble(tern::QpProblem& problem) const;

  /// Control points of every segment, from an answer.
  std::vector<ControlPoints> control_points(const tern::QpSolution& solution) const;

  /// Integral of the squared snap, through snap's own control points, times tau^7 / (largest element of the snap Gram
  /// matrix of degree 7), tau the mean duration.
  double objective(const tern::QpSolution& solution) const;

  /// Largest violation of any row, by control points: metres, m/s, m/s^2; at least 0.
  double violation(const tern::QpSolution& solution) const;

 private:
  /// Weights of position, velocity, acceleration, jerk at a segment's two ends.
  using Local = std::array<double, 8>;

  double cost_of(int s) const;
  Local control_point(int s, int k) const;
  Local hodograph(int s, int i, int order) const;
  int unknown(int s, int i) const;
  tern::Vec3 given(int s, int i) const;
  tern::Vec3 state(int s, int i, const tern::QpSolution& solution) const;
  double curvature(int s, int i, int j) const;
  void add_cost(int s, tern::QpProblem& problem) const;
  void add_point(int s, const Local& weights, tern::QpProblem& problem) const;
  void add_corridor(int s, tern::QpProblem& problem) const;
  void add_limits(int order, double limit, tern::QpProblem& problem) const;

  CorridorCase c_;
  double largest_gram_ = 0.0;  ///< element of the snap Gram matrix over control points
  double tau_ = 0.0;           ///< mean duration
  int unknowns_ = 0;
};

}  // namespace tern_host

#endif
