// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/thrust_planes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/math.hpp"
#include "support/random.hpp"
#include "support/vehicle_limits.hpp"

namespace {

using namespace tern;
using tern_test::Random;
using tern_test::scaled;

/// What a polygon keeps, less the margin of the constraints.
constexpr double kInside = kPolygonInside * (1.0 - 1e-6);

/// A limit's polyhedron and what it stands for.
struct Case {
  Bounds bounds;
  Vec3 along;
  Halfspace planes[kMaxThrustPlanes];
  int count;
};

Case make(Random& random, const Limits& limits, bool rests) {
  Case c{MotionLimits(limits).acceleration, kZero, {}, 0};
  const Vec3 direction{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
  if (!rests) c.along = (1.0 / gauge(c.bounds, direction)) * direction;
  c.count = thrust_planes(c.bounds, c.along, 2.5, c.planes);
  return c;
}

/// The gauge of the polyhedron together with the box.
double polyhedron_gauge(const Case& c, const Vec3& value) {
  Bounds box = c.bounds;
  box.thrust = box.slope = 0.0;
  double result = gauge(box, value);
  for (int p = 0; p < c.count; ++p) {
    result = std::fmax(result, dot(c.planes[p].normal, value) / (2.5 * c.planes[p].offset));
  }
  return result;
}

TEST(ThrustPlanes, AreInsideTheLimits) {
  Random random(21);
  for (int i = 0; i < scaled(300); ++i) {
    Limits limits = tern_test::random_vehicle(random);
    if (i % 4 == 1) limits.tilt_tangent = 0.0;
    if (i % 4 == 2) limits.thrust_max = 0.0;
    if (i % 4 == 3) limits.a_horizontal = random.real(2.0, 30.0);
    const Case c = make(random, limits, i % 2 == 0);
    ASSERT_LE(c.count, kMaxThrustPlanes);
    for (int k = 0; k < 200; ++k) {
      const Vec3 direction{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
      const double norms = limits.a_horizontal > 0.0 ? horizontal_length(direction) / limits.a_horizontal : 0.0;
      const double kept = std::fmax(polyhedron_gauge(c, direction), norms);
      EXPECT_GE(kept, thrust_gauge(c.bounds, direction) * (1.0 - 1e-12)) << i;
    }
    const bool is_boundary = c.along.x != 0.0 && tern_test::vehicle_use(limits, c.along, kZero) > 0.999999;
    EXPECT_TRUE(!is_boundary || std::fabs(polyhedron_gauge(c, c.along) - 1.0) < 1e-6) << i << ": nothing is lost there";
  }
}

/// Thrusts of cos^2(pi / 16) of the ball's radius, and tilts of cos(pi / 16) of the cone's tangent, are inside.
TEST(ThrustPlanes, LoseLessThanFourPercent) {
  Random random(22);
  int inside = 0;
  for (int i = 0; i < scaled(300); ++i) {
    const Limits limits = tern_test::random_vehicle(random);
    const Case c = make(random, limits, i % 2 == 0);
    for (int k = 0; k < 200; ++k) {
      const double angle = random.real(0.0, 6.3);
      const double tangent = kInside * limits.tilt_tangent * random.unit();
      const double vertical = kInside * kPolygonInside * limits.thrust_max / std::hypot(1.0, tangent);
      if (vertical < limits.thrust_min) continue;
      const double flat = vertical * tangent;
      EXPECT_LE(polyhedron_gauge(c, {flat * std::cos(angle), flat * std::sin(angle), vertical - kGravity}), 1.0) << i;
      ++inside;
    }
  }
  EXPECT_GT(inside, scaled(300) * 100);
}

TEST(ThrustPlanes, LeaveOutWhatOtherLimitsCutOff) {
  Limits gentle{{5, 5, 5}, {50, 50, 3}};
  gentle.thrust_max = 2.0 * kGravity;
  gentle.tilt_tangent = 0.7;
  Halfspace planes[kMaxThrustPlanes];
  EXPECT_EQ(thrust_planes(MotionLimits(gentle).acceleration, kZero, 1.0, planes), kHorizontalSides)
      << "at 35 degrees no thrust below 12.8 m/s^2 vertically reaches the ball";
  EXPECT_EQ(thrust_planes(MotionLimits(Limits{{1, 1, 1}, {1, 1, 1}}).acceleration, kZero, 1.0, planes), 0);
}

}  // namespace
