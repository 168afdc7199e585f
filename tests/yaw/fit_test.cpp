// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fit of yaw plans against a lower bound: the dual of the same programme, by coordinate ascent over dense matrices.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <memory>

#include "support/yaw_case.hpp"
#include "yaw/yaw_fit.hpp"

namespace {

using namespace tern;
using tern_test::heading;
using tern_test::hover;
using tern_test::Random;
using tern_test::scaled;

/// min 1/2 x'Hx - f'x + constant with |G x + g| <= b, over the free control points x.
struct Programme {
  Eigen::MatrixXd h, g_rows;
  Eigen::VectorXd f, g, b;
  double constant;
};

/// A row of three factors from control point `first` on: what multiplies x, and what the given points add.
void split(const YawPlan& plan, int first, const double* factors, Eigen::VectorXd& row, double& given) {
  const int n = plan.count - 2;
  row = Eigen::VectorXd::Zero(n);
  given = 0.0;
  for (int i = 0; i < 3; ++i) {
    const int point = first + i;
    if (point < 3) {
      given += factors[i] * plan.points[point];
    } else {
      row[std::min(point - 3, n - 1)] += factors[i];
    }
  }
}

void add_square(Programme& p, const Eigen::VectorXd& row, double rest, double weight) {
  p.h += weight * row * row.transpose();
  p.f -= weight * rest * row;
  p.constant += 0.5 * weight * rest * rest;
}

Programme programme(const YawPlan& plan, const YawRequest& request, double wish) {
  const int n = plan.count - 2;
  Programme p{Eigen::MatrixXd::Zero(n, n),      Eigen::MatrixXd::Zero(2 * n + 1, n), Eigen::VectorXd::Zero(n),
              Eigen::VectorXd::Zero(2 * n + 1), Eigen::VectorXd::Zero(2 * n + 1),    0.0};
  Eigen::VectorXd row;
  double given = 0.0;
  for (int i = 1; i <= plan.count; ++i) {
    const double mean[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
    split(plan, i, mean, row, given);
    add_square(p, row, given - wish, 1.0);
  }
  const double smoothing = std::pow(kYawSmoothing / plan.step, 4.0);
  int next = 0;
  for (int k = 2; k <= plan.count; ++k) {
    const double second[3] = {1.0, -2.0, 1.0};
    split(plan, k - 1, second, row, given);
    add_square(p, row, given, smoothing);
    p.g_rows.row(next) = row;
    p.g[next] = given;
    p.b[next++] = request.acceleration_max * plan.step * plan.step;
    if (k == plan.count) break;
    const double first[3] = {-1.0, 1.0, 0.0};
    split(plan, k, first, row, given);
    p.g_rows.row(next) = row;
    p.g[next] = given;
    p.b[next++] = request.rate_max * plan.step;
  }
  return p;
}

double objective(const Programme& p, const Eigen::VectorXd& x) {
  return 0.5 * x.dot(p.h * x) - p.f.dot(x) + p.constant;
}

/// The greatest value that the dual reaches in so many sweeps: nothing that keeps the limits is below it.
double lower_bound(const Programme& p, int sweeps) {
  const Eigen::LLT<Eigen::MatrixXd> h(p.h);
  const Eigen::MatrixXd gram = p.g_rows * h.solve(p.g_rows.transpose());
  const Eigen::VectorXd start = p.g_rows * h.solve(p.f) + p.g;
  // One price a row, its sign that of the side. x = H^-1 (f - G' price).
  Eigen::VectorXd price = Eigen::VectorXd::Zero(p.b.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < p.b.size(); ++i) {
      const double value = start[i] - gram.row(i).dot(price) + gram(i, i) * price[i];
      const double up = (value - p.b[i]) / gram(i, i);
      const double down = (value + p.b[i]) / gram(i, i);
      price[i] = up > 0.0 ? up : (down < 0.0 ? down : 0.0);
    }
  }
  const Eigen::VectorXd x = h.solve(p.f - p.g_rows.transpose() * price);
  const Eigen::VectorXd rows = p.g_rows * x + p.g;
  double bound = objective(p, x);
  for (int i = 0; i < p.b.size(); ++i) bound += price[i] * rows[i] - std::fabs(price[i]) * p.b[i];
  return bound;
}

TEST(YawFit, IsAtTheOptimum) {
  const auto planner = std::make_unique<YawPlanner>();
  YawPlan plan{};
  for (int seed = 0; seed < scaled(40); ++seed) {
    Random random(static_cast<std::uint64_t>(seed) + 1);
    YawRequest request = yaw_request({1.0, 0.0}, random.real(1.5, 4.0), random.real(3.0, 20.0));
    request.mode = YawMode::kFixed;
    const double wish = random.real(-3.0, 3.0);
    request.heading = heading(wish);
    request.start_rate = random.real(-1.0, 1.0) * request.rate_max;
    ASSERT_EQ(planner->plan(hover(random.real(0.2, 2.0)), request, plan), Status::kOk);
    const Programme p = programme(plan, request, wish);
    const Eigen::Map<const Eigen::VectorXd> x(plan.points + 3, plan.count - 2);
    const double found = objective(p, x);
    const double bound = lower_bound(p, 20000);
    EXPECT_LE(bound, found + 1e-9);
    EXPECT_LE(found, bound + 1e-6 * (1.0 + bound)) << "seed " << seed << ", " << plan.count << " pieces";
  }
}

}  // namespace
