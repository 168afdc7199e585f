// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"
#include "trajectory/bezier.hpp"

namespace {

using namespace tern;

double bernstein(const Curve& curve, double u) {
  double sum = 0.0;
  double binomial = 1.0;
  for (int i = 0; i <= curve.degree; ++i) {
    sum += curve.c[i] * binomial * std::pow(u, i) * std::pow(1.0 - u, curve.degree - i);
    binomial = binomial * (curve.degree - i) / (i + 1);
  }
  return sum;
}

Curve random_curve(tern_test::Random& random) {
  Curve curve{};
  curve.degree = random.integer(1, kDegree);
  for (int i = 0; i <= curve.degree; ++i) curve.c[i] = random.real(-5.0, 5.0);
  return curve;
}

double sampled_peak(const Curve& curve, int steps) {
  double peak = 0.0;
  for (int i = 0; i <= steps; ++i) peak = std::fmax(peak, std::fabs(value(curve, static_cast<double>(i) / steps)));
  return peak;
}

TEST(Curve, ValueIsTheBernsteinSum) {
  tern_test::Random random(1);
  for (int i = 0; i < tern_test::scaled(500); ++i) {
    const Curve curve = random_curve(random);
    const double u = random.unit();
    EXPECT_NEAR(value(curve, u), bernstein(curve, u), 1e-12);
  }
}

TEST(Curve, EndsAreExact) {
  const Curve curve{{0.1, 0.7, -0.3, 0.2, 0.0, 0.0, 0.0, 0.0}, 3};
  EXPECT_EQ(value(curve, 0.0), 0.1);
  EXPECT_EQ(value(curve, 1.0), 0.2);
}

TEST(Curve, HodographOfAParabola) {
  // p(u) = u^2 over two seconds: v = 2 u / 2, a = 2 / 4.
  const Curve parabola{{0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 2};
  const Curve velocity = hodograph(parabola, 2.0);
  ASSERT_EQ(velocity.degree, 1);
  EXPECT_EQ(velocity.c[0], 0.0);
  EXPECT_EQ(velocity.c[1], 1.0);
  const Curve acceleration = hodograph(velocity, 2.0);
  ASSERT_EQ(acceleration.degree, 0);
  EXPECT_EQ(acceleration.c[0], 0.5);
}

TEST(Curve, HalvesAreTheCurve) {
  tern_test::Random random(2);
  for (int i = 0; i < tern_test::scaled(300); ++i) {
    const Curve curve = random_curve(random);
    Curve first = curve;
    const Curve second = split(first);
    const double u = random.unit();
    EXPECT_NEAR(value(first, u), value(curve, 0.5 * u), 1e-12);
    EXPECT_NEAR(value(second, u), value(curve, 0.5 + 0.5 * u), 1e-12);
    EXPECT_EQ(first.c[first.degree], second.c[0]);
  }
}

TEST(PeakBound, OfTheRestToRestSegment) {
  // 35 u^4 - 84 u^5 + 70 u^6 - 20 u^7 peaks at 35 / 16 in speed and 84 sqrt(5) / 25 in acceleration.
  const Curve position{{0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0}, 7};
  const Curve velocity = hodograph(position, 1.0);
  EXPECT_NEAR(peak_bound(velocity, 0.0, 1e-9), 35.0 / 16.0, 1e-8);
  EXPECT_NEAR(peak_bound(hodograph(velocity, 1.0), 0.0, 1e-9), 84.0 * std::sqrt(5.0) / 25.0, 1e-7);
}

TEST(PeakBound, HoldsAndIsTight) {
  tern_test::Random random(3);
  for (int i = 0; i < tern_test::scaled(500); ++i) {
    const Curve curve = random_curve(random);
    const double bound = peak_bound(curve, 0.0, 1e-7);
    const double sampled = sampled_peak(curve, 4000);
    EXPECT_GE(bound, sampled * (1.0 - 1e-14));
    EXPECT_LE(bound, sampled * (1.0 + 1e-4));
  }
}

TEST(PeakBound, IsTheFloorExactlyBelowIt) {
  tern_test::Random random(4);
  for (int i = 0; i < tern_test::scaled(500); ++i) {
    const Curve curve = random_curve(random);
    const double peak = peak_bound(curve, 0.0, 1e-12);
    const double above = peak * (1.0 + 1e-9);
    EXPECT_EQ(peak_bound(curve, above, 0.0), above);
    EXPECT_GT(peak_bound(curve, peak * (1.0 - 1e-9), 0.0), peak * (1.0 - 1e-9));
  }
}

TEST(PeakBound, OfAConstantAndOfZero) {
  const Curve constant{{-2.0, -2.0, -2.0, -2.0, -2.0, -2.0, -2.0, 0.0}, 6};
  EXPECT_EQ(peak_bound(constant, 0.0, 0.0), 2.0);
  EXPECT_EQ(peak_bound(constant, 3.0, 0.0), 3.0);
  const Curve zero{{}, 6};
  EXPECT_EQ(peak_bound(zero, 0.0, 0.0), 0.0);
}

}  // namespace
