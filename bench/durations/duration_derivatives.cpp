// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Cost and rows of the programme, with their first and second derivatives.
#include <algorithm>
#include <cmath>

#include "curve/bezier.hpp"
#include "durations/duration_programme.hpp"

namespace tern_bench {
namespace {

using tern::axis;
using tern::kJointOrder;
using tern::Vec3;

double inner(const Vec3& u, const Vec3& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

}  // namespace

Vec3 DurationProgramme::end_value(const double* x, int segment, int e) const {
  const int at = joint_variable(segment, e, 0);
  if (at < 0) return fixed_[e < kJointOrder ? 0 : 1][power(e)];
  return {x[at], x[at + 1], x[at + 2]};
}

/// Snap; with `gradient` its derivatives added there. Both over tau^7, which makes seconds of them.
double DurationProgramme::snap(const double* x, double* gradient) const {
  double sum = 0.0;
  for (int i = 0; i < count_; ++i) {
    const double theta = x[theta_variable(i)];
    for (int e = 0; e < kEnds; ++e) {
      const Vec3 u = end_value(x, i, e);
      for (int f = 0; f < kEnds; ++f) {
        const Vec3 v = end_value(x, i, f);
        const int m = power(e) + power(f) - 7;
        const double form = tern::kSnapForm[e][f] * std::exp(m * theta) / std::pow(tau_, 7);
        const double term = form * inner(u, v);
        sum += term;
        if (gradient == nullptr) continue;
        gradient[theta_variable(i)] += m * term;
        const int at = joint_variable(i, e, 0);
        for (int a = 0; at >= 0 && a < 3; ++a) gradient[at + a] += 2.0 * form * axis(v, a);
      }
    }
  }
  return sum;
}

bool DurationProgramme::eval_f(int, const double* x, bool, double& value) {
  value = snap(x, nullptr) / rate_;
  for (int i = 0; i < count_; ++i) value += tau_ * std::exp(x[theta_variable(i)]);
  return true;
}

bool DurationProgramme::eval_grad_f(int n, const double* x, bool, double* gradient) {
  std::fill(gradient, gradient + n, 0.0);
  snap(x, gradient);
  for (int i = 0; i < n; ++i) gradient[i] /= rate_;
  for (int i = 0; i < count_; ++i) gradient[theta_variable(i)] += tau_ * std::exp(x[theta_variable(i)]);
  return true;
}

Local DurationProgramme::local_of(const double* x, int segment) const {
  Local local{};
  for (int e = 0; e < kEnds; ++e) {
    const Vec3 u = end_value(x, segment, e);
    for (int a = 0; a < 3; ++a) local[3 * e + a] = axis(u, a);
  }
  local[kTheta] = x[theta_variable(segment)];
  return local;
}

bool DurationProgramme::eval_g(int, const double* x, bool, int m, double* g) {
  const int linear = static_cast<int>(rows_.size());
  for (int r = linear; r < m; ++r) {
    const VehicleRow& row = vehicle_rows_[r - linear];
    g[r] = vehicle_value(row, limits_, tau_, local_of(x, row.segment), nullptr);
  }
  for (int r = 0; r < linear; ++r) {
    const DurationRow& row = rows_[r];
    const double theta = x[theta_variable(row.segment)];
    g[r] = 0.0;
    for (int e = 0; e < kEnds; ++e) {
      const Vec3 u = end_value(x, row.segment, e);
      g[r] += row.weight[e] * std::exp((power(e) - row.order) * theta) * inner(row.normal, u);
    }
  }
  return true;
}

/// Entries of given ends are zeros at theta's column.
bool DurationProgramme::eval_jac_g(int, const double* x, bool, int m, int, int* rows, int* columns, double* values) {
  const int linear = static_cast<int>(rows_.size());
  for (int r = linear; r < m; ++r) {
    const VehicleRow& row = vehicle_rows_[r - linear];
    Local gradient{};
    if (values != nullptr) vehicle_value(row, limits_, tau_, local_of(x, row.segment), &gradient);
    for (int k = 0; k < kLocal; ++k) {
      if (values != nullptr) {
        values[r * kLocal + k] = given(row.segment, k) ? 0.0 : gradient[k];
      } else {
        rows[r * kLocal + k] = r;
        columns[r * kLocal + k] = variable(row.segment, k);
      }
    }
  }
  for (int r = 0; r < linear; ++r) {
    const DurationRow& row = rows_[r];
    const int theta_at = theta_variable(row.segment);
    if (values == nullptr) {
      for (int k = 0; k < kLocal; ++k) {
        rows[r * kLocal + k] = r;
        columns[r * kLocal + k] = variable(row.segment, k);
      }
      continue;
    }
    double slope = 0.0;
    for (int e = 0; e < kEnds; ++e) {
      const int m_e = power(e) - row.order;
      const double weight = row.weight[e] * std::exp(m_e * x[theta_at]);
      const Vec3 u = end_value(x, row.segment, e);
      slope += m_e * weight * inner(row.normal, u);
      const bool free = joint_variable(row.segment, e, 0) >= 0;
      for (int a = 0; a < 3; ++a) values[r * kLocal + 3 * e + a] = free ? weight * axis(row.normal, a) : 0.0;
    }
    values[r * kLocal + kTheta] = slope;
  }
  return true;
}

/// Adds the cost's second derivatives to the blocks.
void DurationProgramme::add_cost_curvature(const double* x, double factor, std::vector<double>& blocks) const {
  for (int i = 0; i < count_; ++i) {
    double* const block = &blocks[i * kLocal * kLocal];
    const double theta = x[theta_variable(i)];
    block[kTheta * kLocal + kTheta] += factor * tau_ * std::exp(theta);
    for (int e = 0; e < kEnds; ++e) {
      const Vec3 u = end_value(x, i, e);
      for (int f = 0; f < kEnds; ++f) {
        const Vec3 v = end_value(x, i, f);
        const int m = power(e) + power(f) - 7;
        const double form = factor / rate_ * tern::kSnapForm[e][f] * std::exp(m * theta) / std::pow(tau_, 7);
        block[kTheta * kLocal + kTheta] += m * m * form * inner(u, v);
        for (int a = 0; a < 3; ++a) {
          block[(3 * e + a) * kLocal + 3 * f + a] += 2.0 * form;
          block[kTheta * kLocal + 3 * e + a] += 2.0 * m * form * axis(v, a);
        }
      }
    }
  }
}

void DurationProgramme::add_row_curvature(const double* x, const double* lambda, std::vector<double>& blocks) const {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const DurationRow& row = rows_[r];
    double* const block = &blocks[row.segment * kLocal * kLocal];
    for (int e = 0; e < kEnds; ++e) {
      const int m = power(e) - row.order;
      const double weight = lambda[r] * m * row.weight[e] * std::exp(m * x[theta_variable(row.segment)]);
      block[kTheta * kLocal + kTheta] += m * weight * inner(row.normal, end_value(x, row.segment, e));
      for (int a = 0; a < 3; ++a) block[kTheta * kLocal + 3 * e + a] += weight * axis(row.normal, a);
    }
  }
}

/// By differences of the gradients.
void DurationProgramme::add_vehicle_curvature(const double* x, const double* lambda,
                                              std::vector<double>& blocks) const {
  constexpr double kStep = 1e-5;
  for (std::size_t r = 0; r < vehicle_rows_.size(); ++r) {
    const VehicleRow& row = vehicle_rows_[r];
    const double multiplier = lambda[rows_.size() + r];
    if (multiplier == 0.0) continue;
    double* const block = &blocks[row.segment * kLocal * kLocal];
    const Local middle = local_of(x, row.segment);
    for (int k = 0; k < kLocal; ++k) {
      const double step = kStep * std::max(1.0, std::fabs(middle[k]));
      Local more = middle, less = middle, after{}, before{};
      more[k] += step;
      less[k] -= step;
      vehicle_value(row, limits_, tau_, more, &after);
      vehicle_value(row, limits_, tau_, less, &before);
      for (int l = 0; l <= k; ++l) block[k * kLocal + l] += multiplier * (after[l] - before[l]) / (2.0 * step);
    }
  }
}

bool DurationProgramme::eval_h(int, const double* x, bool, double factor, int, const double* lambda, bool, int,
                               int* rows, int* columns, double* values) {
  std::vector<double> blocks(count_ * kLocal * kLocal, 0.0);
  if (values != nullptr) {
    add_cost_curvature(x, factor, blocks);
    add_row_curvature(x, lambda, blocks);
    add_vehicle_curvature(x, lambda, blocks);
  }
  int at = 0;
  for (int i = 0; i < count_; ++i) {
    for (int k = 0; k < kLocal; ++k) {
      for (int l = 0; l <= k; ++l, ++at) {
        const bool none = given(i, k) || given(i, l);  // a zero at theta's place
        if (values != nullptr) {
          values[at] = none ? 0.0 : blocks[(i * kLocal + k) * kLocal + l];
        } else {
          rows[at] = none ? theta_variable(i) : std::max(variable(i, k), variable(i, l));
          columns[at] = none ? theta_variable(i) : std::min(variable(i, k), variable(i, l));
        }
      }
    }
  }
  return true;
}

}  // namespace tern_bench
