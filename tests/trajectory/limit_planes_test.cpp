// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/limit_planes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"

namespace {

using namespace tern;

constexpr double kPi = 3.14159265358979323846;

/// The longest step along `direction` that the planes allow, in the limit's own unit.
double reach(const LimitPlanes& limit, const Vec3& direction) {
  double longest = 1e9;
  for (int p = 0; p < limit.count; ++p) {
    const double rate = dot(limit.planes[p].normal, direction);
    if (rate > 0.0) longest = std::fmin(longest, limit.planes[p].offset / rate);
  }
  return longest * limit.unit;
}

TEST(LimitPlanes, BothSidesOfEveryAxis) {
  const LimitPlanes limit = limit_planes({{-1.0, -2.0, -0.5}, {3.0, 4.0, 5.0}, 0.0}, {1.0, 0.0, 0.0});
  EXPECT_EQ(limit.count, 6);
  EXPECT_EQ(limit.unit, 0.5);
  const double expected[6] = {3.0, 1.0, 4.0, 2.0, 5.0, 0.5};
  for (int side = 0; side < 6; ++side) {
    Vec3 direction{0.0, 0.0, 0.0};
    axis(direction, side / 2) = side % 2 == 0 ? 1.0 : -1.0;
    EXPECT_NEAR(reach(limit, direction), expected[side], 1e-7);
  }
}

TEST(LimitPlanes, PolygonIsInsideTheCircleAndLosesLessThanTwoPercent) {
  tern_test::Random random(1);
  for (int n = 0; n < 200; ++n) {
    const Bounds bounds{{-9.0, -9.0, -1.0}, {9.0, 9.0, 1.0}, random.real(0.5, 8.0)};
    const Vec3 along{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
    const LimitPlanes limit = limit_planes(bounds, along);
    EXPECT_EQ(limit.count, 2 + kHorizontalSides);
    for (int i = 0; i < 100; ++i) {
      const double angle = 2.0 * kPi * i / 100;
      const double part = reach(limit, {std::cos(angle), std::sin(angle), 0.0}) / bounds.horizontal;
      EXPECT_LE(part, 1.0);
      EXPECT_GE(part, std::cos(kPi / 16.0) - 1e-7);
    }
    // Nothing is lost in the direction asked for.
    const double norm = horizontal_length(along);
    EXPECT_NEAR(reach(limit, {along.x / norm, along.y / norm, 0.0}) / bounds.horizontal, 1.0, 2e-8);
  }
}

TEST(LimitPlanes, AnAxisThatIsSlowerThanTheNormKeepsItsPlanes) {
  const LimitPlanes limit = limit_planes({{-1.0, -3.0, -2.0}, {3.0, 1.5, 2.0}, 2.0}, {0.0, 0.0, 0.0});
  EXPECT_EQ(limit.count, 4 + kHorizontalSides);
  EXPECT_NEAR(reach(limit, {-1.0, 0.0, 0.0}), 1.0, 1e-7);
  EXPECT_NEAR(reach(limit, {1.0, 0.0, 0.0}), 2.0, 1e-7);
  EXPECT_NEAR(reach(limit, {0.0, 1.0, 0.0}), 1.5, 1e-7);
}

}  // namespace
