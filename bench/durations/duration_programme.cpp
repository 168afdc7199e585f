// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "durations/duration_programme.hpp"

#include <algorithm>
#include <cmath>

#include "curve/bezier.hpp"
#include "trajectory/hodograph_points.hpp"
#include "trajectory/limit_planes.hpp"

namespace tern_bench {
namespace {

using tern::axis;
using tern::kDegree;
using tern::kJointOrder;
using tern::Vec3;

constexpr double kInfinity = 1e20;
/// A point may miss a row by this much.
constexpr double kRowTolerance = 1e-6;

/// What derivative e of the ends counts for in the weighted sum of the eight control points.
double end_weight(const double* weights, int e) {
  const int j = power(e);
  double sum = 0.0;
  for (int k = j; k < kJointOrder; ++k) sum += weights[e < kJointOrder ? k : kDegree - k] * tern::kFirstEnd[k][j];
  return e >= kJointOrder && j % 2 == 1 ? -sum : sum;
}

/// Derivative j of a segment's first end in its own normalised time.
Vec3 first_derivative(const tern::Segment& segment, int j) {
  tern::Vec3 p[4] = {segment.points[0], segment.points[1], segment.points[2], segment.points[3]};
  double factor = 1.0;
  for (int k = 0; k < j; ++k) {
    factor *= kDegree - k;
    for (int i = 0; i < 3 - k; ++i) p[i] = p[i + 1] - p[i];
  }
  return factor * p[0];
}

std::vector<tern::Halfspace> planes_of(const tern::Bounds& bounds, const Vec3& along, double& unit) {
  const tern::LimitPlanes planes = tern::limit_planes(bounds, along);
  unit = planes.unit;
  return {planes.planes, planes.planes + planes.count};
}

}  // namespace

DurationProgramme::DurationProgramme(const tern::Corridor& corridor, const tern::MotionLimits& limits,
                                     const tern::Trajectory& plan, double rate)
    : limits_(limits),
      vehicle_rows_(vehicle_rows(limits, plan.count)),
      count_(plan.count),
      tau_(tern::duration(plan) / plan.count),
      rate_(rate) {
  for (int i = 0; i < count_; ++i) {
    if (i == 0) continue;
    for (int j = 0; j < kJointOrder; ++j) {
      const double scale = std::pow(tau_ / plan.segments[i].duration, j);
      const Vec3 value = scale * first_derivative(plan.segments[i], j);
      for (int a = 0; a < 3; ++a) start_.push_back(axis(value, a));
    }
  }
  for (int i = 0; i < count_; ++i) start_.push_back(std::log(plan.segments[i].duration / tau_));
  fixed_[0][0] = plan.segments[0].points[0];
  fixed_[1][0] = plan.segments[count_ - 1].points[kDegree];
  double unit[2];
  const std::vector<tern::Halfspace> velocity = planes_of(limits.velocity, {}, unit[0]);
  const std::vector<tern::Halfspace> acceleration = planes_of(limits.acceleration, {}, unit[1]);
  for (int i = 0; i < count_; ++i) {
    const tern::Polyhedron& polyhedron = corridor.polyhedra[plan.segments[i].polyhedron];
    for (int k = 0; k <= kDegree; ++k) {
      double weights[tern::kControlPoints] = {};
      weights[k] = 1.0;
      add_rows(i, 0, weights, {polyhedron.planes, polyhedron.planes + polyhedron.count}, 1.0);
    }
    for (int order = 1; order <= 2; ++order) {
      const tern::OrderPoints rows = tern::points_of(order);
      for (int r = i == 0 ? 0 : 1; r < rows.count; ++r) {
        add_rows(i, order, rows.weights[r], order == 1 ? velocity : acceleration,
                 unit[order - 1] * std::pow(tau_, order));
      }
    }
  }
}

/// Rows of a point that depends on nothing free are left out.
void DurationProgramme::add_rows(int segment, int order, const double* weights,
                                 const std::vector<tern::Halfspace>& planes, double unit) {
  DurationRow row{segment, order, {}, {}, 0.0};
  bool free = false;
  for (int e = 0; e < kEnds; ++e) {
    row.weight[e] = end_weight(weights, e) / unit;
    free = free || (row.weight[e] != 0.0 && joint_variable(segment, e, 0) >= 0);
  }
  if (!free) return;
  for (const tern::Halfspace& plane : planes) {
    row.normal = plane.normal;
    row.bound = plane.offset;
    rows_.push_back(row);
  }
}

int DurationProgramme::joint_variable(int segment, int e, int a) const {
  const int joint = e < kJointOrder ? segment - 1 : segment;
  if (joint < 0 || joint + 1 >= count_) return -1;
  return 12 * joint + 3 * power(e) + a;
}

bool DurationProgramme::given(int segment, int k) const {
  return k != kTheta && joint_variable(segment, k / 3, k % 3) < 0;
}

/// Where variable k of a segment is; theta's place if it is given.
int DurationProgramme::variable(int segment, int k) const {
  return k == kTheta || given(segment, k) ? theta_variable(segment) : joint_variable(segment, k / 3, k % 3);
}

bool DurationProgramme::get_nlp_info(int& n, int& m, int& jacobian, int& hessian, IndexStyleEnum& style) {
  n = static_cast<int>(start_.size());
  m = static_cast<int>(rows_.size() + vehicle_rows_.size());
  jacobian = m * kLocal;
  hessian = count_ * kLocal * (kLocal + 1) / 2;
  style = C_STYLE;
  return true;
}

bool DurationProgramme::get_bounds_info(int n, double* lower, double* upper, int m, double* row_lower,
                                        double* row_upper) {
  std::fill(lower, lower + n, -kInfinity);
  std::fill(upper, upper + n, kInfinity);
  for (int i = 0; i < count_; ++i) lower[theta_variable(i)] = std::log(tern::kMinDuration / tau_);
  std::fill(row_lower, row_lower + m, -kInfinity);
  const int linear = static_cast<int>(rows_.size());
  for (int r = 0; r < m; ++r) row_upper[r] = r < linear ? rows_[r].bound : 0.0;
  return true;
}

bool DurationProgramme::get_starting_point(int, bool, double* x, bool, double*, double*, int, bool, double*) {
  std::copy(start_.begin(), start_.end(), x);
  return true;
}

void DurationProgramme::finalize_solution(Ipopt::SolverReturn status, int, const double* x, const double*,
                                          const double*, int m, const double* g, const double*, double,
                                          const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) {
  duration_ = 0.0;
  for (int i = 0; i < count_; ++i) duration_ += tau_ * std::exp(x[theta_variable(i)]);
  cost_ = snap(x, nullptr) + rate_ * duration_;
  converged_ = status == Ipopt::SUCCESS || status == Ipopt::STOP_AT_ACCEPTABLE_POINT;
  keeps_rows_ = true;
  const int linear = static_cast<int>(rows_.size());
  for (int r = 0; r < m; ++r) keeps_rows_ = keeps_rows_ && g[r] <= (r < linear ? rows_[r].bound : 0.0) + kRowTolerance;
}

}  // namespace tern_bench
