// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The spline that comes nearest to the wish within the limits: a convex quadratic programme over the control points c,
//
//   min  1/2 sum (psi(t_i) - wish_i)^2 + 1/2 r sum (c[k+1] - 2 c[k] + c[k-1])^2
//   s.t. |c[k+1] - c[k]| <= rate_bound[k],   |c[k+1] - 2 c[k] + c[k-1]| <= acceleration_max h^2,
//
// with h the duration of a piece and r = (kYawSmoothing / h)^4. The start gives the first three control points; the
// last three are equal: rest. The derivatives of a B-spline lie between their own control points, so the rows hold the
// limits at all times.
//
// A primal-dual interior-point method solves it. It starts from a feasible point: the brake from the start's rate.
// Every iterate keeps all limits, so the method can stop after any of them. Its matrix has five diagonals.
#ifndef TERN_YAW_YAW_FIT_HPP
#define TERN_YAW_YAW_FIT_HPP

#include "tern/yaw.hpp"

namespace tern {

/// Turns are smoothed over about this time, s: it weighs accelerations against errors of the angle.
constexpr double kYawSmoothing = 0.15;

class YawPlanner::Fit {
 public:
  explicit Fit(YawPlanner& planner) noexcept : y_(planner), variables_(planner.plan_.count - 2) {}

  /// Sets the control points to the brake, and the prices of the rows.
  void begin() noexcept;
  /// One iteration. Does nothing and returns false once there is nothing left to gain.
  bool iterate() noexcept;

 private:
  /// A row: a sum over up to three neighbouring control points. It has the sum's value, and the factors of those points
  /// that are free.
  struct Row {
    int count;
    int variable[3];
    double factor[3];
    double value;
  };
  /// A limit -bound <= row <= bound, with the prices of both sides.
  struct Limit {
    Row row;
    double bound;
    double* price;
  };

  Row row(int first, double a, double b, double c) const noexcept;
  Row fit_row(int knot) const noexcept;
  Limit limit(int number) const noexcept;
  static bool is_rate(int number) noexcept { return number % 2 == 1; }
  int limit_count() const noexcept { return 2 * variables_ + 1; }
  double acceleration_bound() const noexcept;

  void brake() noexcept;
  double first_gap() const noexcept;
  void add(const Row& row, double weight, double slope) noexcept;
  void assemble(double target) noexcept;
  void solve() noexcept;
  double change_of(const Row& row) const noexcept;
  double gap() const noexcept;
  double least_slack() const noexcept;
  double longest_step(double target) const noexcept;
  void move(double step, double target) noexcept;

  YawPlanner& y_;
  int variables_;
};

}  // namespace tern

#endif
