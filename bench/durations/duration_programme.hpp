// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A plan's durations and states as one nonlinear programme for IPOPT: snap / rate + duration over the rows that the
// trajectory stage puts on its quadratic programmes, with exact derivatives.
//
// With the time of a segment as e^theta, everything is a sum of terms  coefficient e^(m theta) u v  of normalised
// derivatives u, v of its two ends: each derivative with respect to theta is a factor m.
#ifndef TERN_BENCH_DURATION_PROGRAMME_HPP
#define TERN_BENCH_DURATION_PROGRAMME_HPP

#include <coin/IpTNLP.hpp>
#include <vector>

#include "base/bounds.hpp"
#include "curve/hermite.hpp"
#include "durations/vehicle_rows.hpp"
#include "tern/corridor.hpp"
#include "tern/trajectory.hpp"

namespace tern_bench {

constexpr int kEnds = 2 * tern::kJointOrder;

/// Variables of a segment: both ends' states on three axes, then theta.
constexpr int kLocal = 3 * kEnds + 1;
constexpr int kTheta = kLocal - 1;

/// The power of time that end derivative e has.
inline int power(int e) {
  return e % tern::kJointOrder;
}

/// What a segment's row bounds: normal . sum_e weight[e] e^((e % 4 - order) theta) end[e] <= bound.
struct DurationRow {
  int segment;
  int order;
  double weight[kEnds];
  tern::Vec3 normal;
  double bound;
};

/// Minimises  snap / rate + duration  over linear rows and the vehicle's own limits.  Variables: the states of the
/// interior joints (12 each, position, then derivatives times the unit of time to their order), then theta of each
/// segment, in units of `tau`.
class DurationProgramme : public Ipopt::TNLP {
 public:
  /// `corridor`: relative to the plan's origin. The plan is the start of the search, and has the segments.
  DurationProgramme(const tern::Corridor& corridor, const tern::MotionLimits& limits, const tern::Trajectory& plan,
                    double rate);

  /// Of the last point, and whether it keeps the rows; IPOPT may have reached its limit of iterations there.
  double duration() const { return duration_; }
  double cost() const { return cost_; }  ///< snap + rate * duration
  bool keeps_rows() const { return keeps_rows_; }
  bool converged() const { return converged_; }

  bool get_nlp_info(int& n, int& m, int& jacobian, int& hessian, IndexStyleEnum& style) override;
  bool get_bounds_info(int n, double* lower, double* upper, int m, double* row_lower, double* row_upper) override;
  bool get_starting_point(int n, bool init_x, double* x, bool init_z, double*, double*, int m, bool init_lambda,
                          double*) override;
  bool eval_f(int n, const double* x, bool fresh, double& value) override;
  bool eval_grad_f(int n, const double* x, bool fresh, double* gradient) override;
  bool eval_g(int n, const double* x, bool fresh, int m, double* g) override;
  bool eval_jac_g(int n, const double* x, bool fresh, int m, int count, int* rows, int* columns,
                  double* values) override;
  bool eval_h(int n, const double* x, bool fresh, double factor, int m, const double* lambda, bool fresh_lambda,
              int count, int* rows, int* columns, double* values) override;
  void finalize_solution(Ipopt::SolverReturn status, int n, const double* x, const double*, const double*, int m,
                         const double*, const double*, double value, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override;

 private:
  int joint_variable(int segment, int e, int axis) const;  ///< -1 where it is given
  bool given(int segment, int k) const;                    ///< of a segment's variables
  int variable(int segment, int k) const;
  int theta_variable(int segment) const { return 12 * (count_ - 1) + segment; }
  tern::Vec3 end_value(const double* x, int segment, int e) const;
  double snap(const double* x, double* gradient) const;
  void add_cost_curvature(const double* x, double factor, std::vector<double>& blocks) const;
  void add_row_curvature(const double* x, const double* lambda, std::vector<double>& blocks) const;
  void add_rows(int segment, int order, const double* weights, const std::vector<tern::Halfspace>& planes, double unit);

  Local local_of(const double* x, int segment) const;
  void add_vehicle_curvature(const double* x, const double* lambda, std::vector<double>& blocks) const;

  tern::MotionLimits limits_;
  std::vector<VehicleRow> vehicle_rows_;  ///< after rows_
  int count_;
  double tau_;
  double rate_;
  tern::Vec3 fixed_[2][tern::kJointOrder]{};
  std::vector<double> start_;
  std::vector<DurationRow> rows_;
  double duration_ = 0.0;
  double cost_ = 0.0;
  bool keeps_rows_ = false;
  bool converged_ = false;
};

}  // namespace tern_bench

#endif
