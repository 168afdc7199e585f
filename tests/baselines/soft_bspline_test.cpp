// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/soft_bspline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random.hpp"

namespace {

using tern::Vec3;
using tern_bench::BSpline;
using tern_bench::SoftWeights;

tern_host::Scenario scenario(const std::string& blocks) {
  return tern_host::parse_scenario(
      "boundary 0 0 0 10 10 3\n" + blocks + "start 1 5 1.5\ngoal 9 5 1.5\nradius 0.25\nv_max 2\na_max 2\n", "test");
}

BSpline random_curve(tern_test::Random& random, int points) {
  BSpline curve;
  curve.interval = 0.3;
  for (int i = 0; i < points; ++i) curve.points.push_back({random.real(0, 10), random.real(0, 10), random.real(0, 3)});
  return curve;
}

TEST(BSpline, KnownValuesAtAKnot) {
  // At a knot: (p0 + 4 p1 + p2) / 6, (p2 - p0) / 2h, (p0 - 2 p1 + p2) / h^2.
  BSpline curve{0.5, {{0, 0, 0}, {3, 0, 0}, {6, 6, 0}, {9, 0, 0}, {0, 0, 0}}};
  const tern::Sample s = curve.evaluate(0.0);
  EXPECT_NEAR(s.position.x, 3.0, 1e-12);
  EXPECT_NEAR(s.position.y, 1.0, 1e-12);
  EXPECT_NEAR(s.velocity.x, 6.0, 1e-12);
  EXPECT_NEAR(s.velocity.y, 6.0, 1e-12);
  EXPECT_NEAR(s.acceleration.y, 24.0, 1e-12);
  EXPECT_NEAR(curve.duration(), 1.0, 1e-12);
}

TEST(BSpline, DerivativesAreThoseOfThePosition) {
  tern_test::Random random(2);
  const BSpline curve = random_curve(random, 9);
  const double h = 1e-5;
  for (double t = 0.05; t < curve.duration() - 0.05; t += 0.11) {
    const tern::Sample a = curve.evaluate(t - h);
    const tern::Sample s = curve.evaluate(t);
    const tern::Sample b = curve.evaluate(t + h);
    EXPECT_NEAR(s.velocity.x, (b.position.x - a.position.x) / (2 * h), 1e-4);
    EXPECT_NEAR(s.acceleration.y, (b.velocity.y - a.velocity.y) / (2 * h), 1e-2);
  }
}

TEST(BSpline, DerivativesStayWithinThoseOfTheirControlPoints) {
  tern_test::Random random(4);
  for (int k = 0; k < 20; ++k) {
    const BSpline curve = random_curve(random, 10);
    double speed = 0.0;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      speed = std::max(speed, std::fabs(curve.points[i].x - curve.points[i - 1].x) / curve.interval);
    }
    for (int i = 0; i <= 200; ++i) {
      EXPECT_LE(std::fabs(curve.evaluate(curve.duration() * i / 200).velocity.x), speed + 1e-9);
    }
  }
}

TEST(SignedDistance, OutsideAboveAnEdgeAndInside) {
  const tern_host::Scenario world = scenario("block 4 4 0 6 6 3\n");
  Vec3 gradient{};
  EXPECT_NEAR(tern_bench::signed_distance({3, 5, 1}, world, gradient), 1.0, 1e-12);
  EXPECT_NEAR(gradient.x, -1.0, 1e-12);
  EXPECT_NEAR(tern_bench::signed_distance({7, 7, 1}, world, gradient), std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(gradient.y, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(tern_bench::signed_distance({4.25, 5, 1}, world, gradient), -0.25, 1e-12);
  EXPECT_NEAR(gradient.x, -1.0, 1e-12);
  EXPECT_TRUE(std::isinf(tern_bench::signed_distance({4.25, 5, 1}, scenario(""), gradient)));
}

TEST(SoftCost, GradientIsThatOfTheCost) {
  const tern_host::Scenario world = scenario("block 4 4 0 6 6 3\nblock 2 6 0 3 8 2\n");
  tern_test::Random random(6);
  const SoftWeights weights;
  for (int k = 0; k < 10; ++k) {
    BSpline curve = random_curve(random, 12);
    std::vector<double> gradient, ignored;
    tern_bench::soft_cost(curve, world, weights, gradient);
    ASSERT_EQ(gradient.size(), 18u);
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      const double h = 1e-6;
      Vec3& p = curve.points[3 + i / 3];
      double& value = i % 3 == 0 ? p.x : (i % 3 == 1 ? p.y : p.z);
      const double kept = value;
      value = kept + h;
      const double above = tern_bench::soft_cost(curve, world, weights, ignored);
      value = kept - h;
      const double below = tern_bench::soft_cost(curve, world, weights, ignored);
      value = kept;
      EXPECT_NEAR(gradient[i], (above - below) / (2 * h), 1e-3 * (1.0 + std::fabs(gradient[i])));
    }
  }
}

TEST(SoftBSpline, BendsAroundABlock) {
  const tern_host::Scenario world = scenario("block 4.5 4.9 0 5.5 8 3\n");
  const tern_bench::SoftResult result =
      tern_bench::soft_bspline({{1, 5, 1.5}, {4, 4, 1.5}, {6, 4, 1.5}, {9, 5, 1.5}}, world);
  EXPECT_TRUE(result.clear);
  const tern::Sample first = result.curve.evaluate(0.0);
  const tern::Sample last = result.curve.evaluate(result.curve.duration());
  EXPECT_NEAR(first.position.x, 1.0, 1e-9);
  EXPECT_NEAR(last.position.x, 9.0, 1e-9);
  EXPECT_NEAR(first.velocity.x, 0.0, 1e-9);
  EXPECT_NEAR(last.acceleration.y, 0.0, 1e-9);
}

}  // namespace
