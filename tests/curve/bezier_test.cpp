// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/bezier.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/arc_curve.hpp"
#include "support/random.hpp"
#include "support/same.hpp"

namespace {

using namespace tern;
using tern_test::expect_near;

constexpr Bounds kUnit{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}, 0.0};

Vec3 bernstein(const Curve& curve, double u) {
  Vec3 sum{0.0, 0.0, 0.0};
  double binomial = 1.0;
  for (int i = 0; i <= curve.degree; ++i) {
    sum = sum + (binomial * std::pow(u, i) * std::pow(1.0 - u, curve.degree - i)) * curve.c[i];
    binomial = binomial * (curve.degree - i) / (i + 1);
  }
  return sum;
}

Vec3 random_point(tern_test::Random& random) {
  return {random.real(-5.0, 5.0), random.real(-5.0, 5.0), random.real(-5.0, 5.0)};
}

Curve random_curve(tern_test::Random& random) {
  Curve curve{};
  curve.degree = random.integer(1, kDegree);
  for (int i = 0; i <= curve.degree; ++i) curve.c[i] = random_point(random);
  return curve;
}

/// Different limits up and down on every axis, and in half of the cases on the horizontal norm.
Bounds random_bounds(tern_test::Random& random) {
  const Vec3 lower{random.real(-4.0, -0.5), random.real(-4.0, -0.5), random.real(-4.0, -0.5)};
  const Vec3 upper{random.real(0.5, 4.0), random.real(0.5, 4.0), random.real(0.5, 4.0)};
  return {lower, upper, random.chance(0.5) ? random.real(0.5, 4.0) : 0.0};
}

double sampled_peak(const Curve& curve, const Bounds& bounds, int steps) {
  double peak = 0.0;
  for (int i = 0; i <= steps; ++i) {
    peak = std::fmax(peak, gauge(bounds, value(curve, static_cast<double>(i) / steps)));
  }
  return peak;
}

TEST(Gauge, TakesTheLimitOfEachSideAndOfTheHorizontalNorm) {
  const Bounds bounds{{-2.0, -2.0, -1.0}, {2.0, 2.0, 4.0}, 0.0};
  EXPECT_EQ(gauge(bounds, {0.0, 0.0, 2.0}), 0.5);
  EXPECT_EQ(gauge(bounds, {0.0, 0.0, -2.0}), 2.0);
  EXPECT_EQ(gauge(bounds, {1.5, -2.0, 0.0}), 1.0);
  EXPECT_EQ(gauge({bounds.lower, bounds.upper, 2.0}, {1.5, -2.0, 0.0}), 1.25);
  EXPECT_EQ(gauge(bounds, {0.0, 0.0, 0.0}), 0.0);
}

TEST(Bounds, ALowerLimitOfZeroIsTheUpperOnesOpposite) {
  Limits limits{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  limits.v_min.z = -0.5;
  const Bounds velocity = MotionLimits(limits).velocity;
  expect_near(velocity.lower, {-1.0, -2.0, -0.5}, 0.0);
  expect_near(velocity.upper, {1.0, 2.0, 3.0}, 0.0);
  expect_near(MotionLimits(limits).acceleration.lower, {-4.0, -5.0, -6.0}, 0.0);
  const Bounds reversed = backwards(MotionLimits(limits)).velocity;
  expect_near(reversed.lower, {-1.0, -2.0, -3.0}, 0.0);
  expect_near(reversed.upper, {1.0, 2.0, 0.5}, 0.0);
}

TEST(Curve, ValueIsTheBernsteinSum) {
  tern_test::Random random(1);
  for (int i = 0; i < tern_test::scaled(500); ++i) {
    const Curve curve = random_curve(random);
    const double u = random.unit();
    expect_near(value(curve, u), bernstein(curve, u), 1e-12);
  }
}

TEST(Curve, EndsAreExact) {
  const Curve curve{{{0.1, 0.3, 0.7}, {0.7, 1.0, 1.0}, {-0.3, 2.0, 1.0}, {0.2, 0.9, -0.7}}, 3};
  expect_near(value(curve, 0.0), {0.1, 0.3, 0.7}, 0.0);
  expect_near(value(curve, 1.0), {0.2, 0.9, -0.7}, 0.0);
}

TEST(Curve, HodographOfAParabola) {
  // p(u) = u^2 over two seconds: v = 2 u / 2, a = 2 / 4.
  const Curve parabola{{{}, {}, {1.0, 0.0, -1.0}}, 2};
  const Curve velocity = hodograph(parabola, 2.0);
  ASSERT_EQ(velocity.degree, 1);
  expect_near(velocity.c[0], {0.0, 0.0, 0.0}, 0.0);
  expect_near(velocity.c[1], {1.0, 0.0, -1.0}, 0.0);
  const Curve acceleration = hodograph(velocity, 2.0);
  ASSERT_EQ(acceleration.degree, 0);
  expect_near(acceleration.c[0], {0.5, 0.0, -0.5}, 0.0);
}

TEST(Curve, HalvesAreTheCurve) {
  tern_test::Random random(2);
  for (int i = 0; i < tern_test::scaled(300); ++i) {
    const Curve curve = random_curve(random);
    Curve first = curve;
    const Curve second = split(first);
    const double u = random.unit();
    expect_near(value(first, u), value(curve, 0.5 * u), 1e-12);
    expect_near(value(second, u), value(curve, 0.5 + 0.5 * u), 1e-12);
    expect_near(first.c[first.degree], second.c[0], 0.0);
  }
}

TEST(PeakBound, OfTheRestToRestSegment) {
  // 35 u^4 - 84 u^5 + 70 u^6 - 20 u^7 peaks at 35 / 16 in speed and 84 sqrt(5) / 25 in acceleration.
  const Vec3 end{1.0, 0.0, -2.0};
  const Curve position{{{}, {}, {}, {}, end, end, end, end}, 7};
  const Curve velocity = hodograph(position, 1.0);
  EXPECT_NEAR(peak_bound(velocity, kUnit, 0.0, 1e-9), 35.0 / 8.0, 1e-7);
  EXPECT_NEAR(peak_bound(hodograph(velocity, 1.0), kUnit, 0.0, 1e-9), 168.0 * std::sqrt(5.0) / 25.0, 1e-6);
}

TEST(PeakBound, HoldsAndIsTight) {
  tern_test::Random random(3);
  for (int i = 0; i < tern_test::scaled(500); ++i) {
    const Curve curve = random_curve(random);
    const Bounds bounds = random_bounds(random);
    const double bound = peak_bound(curve, bounds, 0.0, 1e-7);
    const double sampled = sampled_peak(curve, bounds, 4000);
    EXPECT_GE(bound, sampled * (1.0 - 1e-14));
    EXPECT_LE(bound, sampled * (1.0 + 1e-4));
  }
}

TEST(PeakBound, IsTheFloorExactlyBelowIt) {
  tern_test::Random random(4);
  for (int i = 0; i < tern_test::scaled(500); ++i) {
    const Curve curve = random_curve(random);
    const Bounds bounds = random_bounds(random);
    const double peak = peak_bound(curve, bounds, 0.0, 1e-10);
    const double above = peak * (1.0 + 1e-8);
    EXPECT_EQ(peak_bound(curve, bounds, above, 0.0), above);
    EXPECT_GT(peak_bound(curve, bounds, peak * (1.0 - 1e-8), 0.0), peak * (1.0 - 1e-8));
  }
}

TEST(PeakBound, OfAConstantAndOfZero) {
  Curve constant{};
  constant.degree = 6;
  for (Vec3& c : constant.c) c = {0.0, -2.0, 1.0};
  EXPECT_EQ(peak_bound(constant, kUnit, 0.0, 0.0), 2.0);
  EXPECT_EQ(peak_bound(constant, kUnit, 3.0, 0.0), 3.0);
  const Curve zero{{}, 6};
  EXPECT_EQ(peak_bound(zero, kUnit, 0.0, 0.0), 0.0);
}

// The norm is 1 all along the arc, but the hulls of its parts exceed it: no number of pieces within the bound suffices.
// What is left counts with its hull, 0.025 times the square of the part's angle beyond the arc.
TEST(PeakBound, HoldsWhereThePiecesRunOut) {
  Curve arc{};
  arc.degree = tern_test::kSextic;
  for (int i = 0; i <= arc.degree; ++i) arc.c[i] = tern_test::arc_point(0.5, i);
  const double bound = peak_bound(arc, {{-9.0, -9.0, -9.0}, {9.0, 9.0, 9.0}, 1.0}, 0.0, 0.0);
  EXPECT_GE(bound, sampled_peak(arc, {{-9.0, -9.0, -9.0}, {9.0, 9.0, 9.0}, 1.0}, 1000));
  EXPECT_GT(bound, 1.0 + 1e-4) << "half of the curve was not looked into";
  EXPECT_LT(bound, 1.0 + 0.025 * 0.25 * 0.25 * 1.1);
}

}  // namespace
