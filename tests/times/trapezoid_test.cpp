// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "times/trapezoid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"

namespace {

using namespace tern;

constexpr Limits kTwo{{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};

/// Distance covered by the profile of duration `time`, integrated from its speed.
double integrate(double time, const LineLimits& line) {
  const int steps = 200000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double t = time * (i + 0.5) / steps;
    sum += std::fmin(line.speed, line.acceleration * std::fmin(t, time - t)) * time / steps;
  }
  return sum;
}

TEST(Trapezoid, MatchesThePapersFigure) {
  // 30 m in 4 s with one second of speeding up to 10 m/s and one of slowing down.
  EXPECT_NEAR(trapezoid_time(30.0, LineLimits{10.0, 10.0}), 4.0, 1e-12);
}

TEST(Trapezoid, IsTriangularWhereTooShort) {
  EXPECT_NEAR(trapezoid_time(1.0, LineLimits{10.0, 4.0}), 2.0 * std::sqrt(1.0 / 4.0), 1e-12);
}

TEST(Trapezoid, BothFormsMeetAtTheLimitSpeed) {
  const LineLimits line{2.0, 4.0};
  const double x = 1.0;  // v^2 / a
  EXPECT_NEAR(trapezoid_time(x * (1.0 - 1e-12), line), 1.0, 1e-9);
  EXPECT_NEAR(trapezoid_time(x, line), 1.0, 1e-12);
}

TEST(Trapezoid, CoversItsLength) {
  tern_test::Random random(11);
  for (int i = 0; i < tern_test::scaled(50); ++i) {
    const LineLimits line{random.real(0.5, 5.0), random.real(0.5, 5.0)};
    const double x = random.real(0.1, 20.0);
    EXPECT_NEAR(integrate(trapezoid_time(x, line), line), x, 1e-4 * x);
  }
}

TEST(LimitsAlong, AxesAndDiagonals) {
  const Limits limits{{3.0, 2.0, 1.0}, {6.0, 2.0, 4.0}};
  EXPECT_NEAR(limits_along({-5.0, 0.0, 0.0}, limits).speed, 3.0, 1e-12);
  EXPECT_NEAR(limits_along({0.0, 0.0, 2.0}, limits).acceleration, 4.0, 1e-12);
  EXPECT_NEAR(limits_along({1.0, 1.0, 1.0}, kTwo).speed, 2.0 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(limits_along({1.0, 1.0, 0.0}, limits).speed, 2.0 * std::sqrt(2.0), 1e-12);
}

TEST(LimitsAlong, UpAndDownAndTheHorizontalNorm) {
  Limits limits{{2.0, 2.0, 4.0}, {2.0, 2.0, 6.0}};
  limits.v_min.z = -1.0;
  limits.a_min.z = -3.0;
  EXPECT_NEAR(limits_along({0.0, 0.0, 5.0}, limits).speed, 4.0, 1e-12);
  EXPECT_NEAR(limits_along({0.0, 0.0, -5.0}, limits).speed, 1.0, 1e-12);
  // Speeding up at 6 and slowing down at 3 m/s^2 take as long as 4 m/s^2 both ways.
  EXPECT_NEAR(limits_along({0.0, 0.0, 5.0}, limits).acceleration, 4.0, 1e-12);
  EXPECT_NEAR(limits_along({1.0, 1.0, 0.0}, limits).speed, 2.0 * std::sqrt(2.0), 1e-12);
  limits.v_horizontal = 2.0;
  EXPECT_NEAR(limits_along({1.0, 1.0, 0.0}, limits).speed, 2.0, 1e-12);
}

TEST(RampAcceleration, AJerkLimitLowersTheMean) {
  Limits limits{{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  const Vec3 along{3.0, 0.0, 0.0};
  const tern::LineLimits line = limits_along(along, limits);
  EXPECT_EQ(tern::ramp_acceleration(along, limits, line), 2.0);
  limits.j_max = {4.0, 4.0, 4.0};  // 1 s and half a second to full acceleration
  EXPECT_NEAR(tern::ramp_acceleration(along, limits, line), 2.0 / 1.5, 1e-12);
  limits.j_max = {1.0, 1.0, 1.0};  // full acceleration is not reached: sqrt 2 s up and sqrt 2 s down
  EXPECT_NEAR(tern::ramp_acceleration(along, limits, line), 2.0 / std::sqrt(8.0), 1e-12);
}

TEST(LimitsAlong, NoAxisExceedsItsOwnAndOneReachesIt) {
  tern_test::Random random(12);
  for (int i = 0; i < tern_test::scaled(1000); ++i) {
    const Limits limits{{random.real(0.1, 9.0), random.real(0.1, 9.0), random.real(0.1, 9.0)},
                        {random.real(0.1, 9.0), random.real(0.1, 9.0), random.real(0.1, 9.0)}};
    const Vec3 d{random.real(-3.0, 3.0), random.real(-3.0, 3.0), random.real(-3.0, 3.0)};
    const double norm = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    const double v = limits_along(d, limits).speed / norm;
    const double worst = std::fmax(std::fmax(std::fabs(d.x) * v / limits.v_max.x, std::fabs(d.y) * v / limits.v_max.y),
                                   std::fabs(d.z) * v / limits.v_max.z);
    EXPECT_NEAR(worst, 1.0, 1e-12);
  }
}

}  // namespace
