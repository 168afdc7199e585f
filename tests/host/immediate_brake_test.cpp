// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/immediate_brake.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using tern_host::brake_along;
using tern_host::brake_straight;
using tern_host::BrakeWay;

constexpr std::int64_t kBegin = 100000000;

/// 5 m/s, straight along x or around a circle of 4 m.
tern::Sample straight(std::int64_t t) {
  tern::Sample sample{};
  sample.position = {5e-9 * static_cast<double>(t), 0.0, 2.0};
  sample.velocity = {5.0, 0.0, 0.0};
  return sample;
}

tern::Sample circling(std::int64_t t) {
  constexpr double kRadius = 4.0;
  const double w = 5.0 / kRadius;
  const double a = w * 1e-9 * static_cast<double>(t);
  const double c = std::cos(a);
  const double s = std::sin(a);
  tern::Sample sample{};
  sample.position = {kRadius * s, kRadius * (1.0 - c), 2.0};
  sample.velocity = {5.0 * c, 5.0 * s, 0.0};
  sample.acceleration = {-5.0 * w * s, 5.0 * w * c, 0.0};
  sample.jerk = {-5.0 * w * w * c, -5.0 * w * w * s, 0.0};
  return sample;
}

tern::Limits limits_of(double jerk) {
  tern::Limits limits{{6.0, 6.0, 2.0}, {8.0, 8.0, 6.0}};
  limits.v_horizontal = 6.0;
  limits.a_horizontal = 8.0;
  limits.j_max = {jerk, jerk, jerk};
  return limits;
}

double way_of(const BrakeWay& brake) {
  double way = 0.0;
  for (std::size_t k = 1; k < brake.size(); ++k) {
    way += std::hypot(brake[k].position.x - brake[k - 1].position.x, brake[k].position.y - brake[k - 1].position.y);
  }
  return way;
}

/// Nothing stops in less than v^2 / 2a, and the ramps cost some more.
TEST(ImmediateBrake, StraightAheadIsNearlyAsShortAsCanBe) {
  const double reaction = 5.0 * 0.1;
  const BrakeWay sharp = brake_straight(straight, 0, kBegin, limits_of(0.0));
  EXPECT_GT(way_of(sharp), reaction + 25.0 / 16.0);
  EXPECT_LT(way_of(sharp), 1.25 * (reaction + 25.0 / 16.0));
  const BrakeWay smooth = brake_straight(straight, 0, kBegin, limits_of(30.0));
  EXPECT_GT(way_of(smooth), way_of(sharp));
  EXPECT_LT(way_of(smooth), 1.5 * way_of(sharp));
  EXPECT_EQ(smooth.back().speed, 0.0);
  EXPECT_EQ(smooth[99].speed, 5.0);
}

/// In a turn, a part of the acceleration is taken.
TEST(ImmediateBrake, AlongTheWayStaysOnIt) {
  const BrakeWay brake = brake_along(circling, 0, kBegin, limits_of(30.0));
  for (const tern_host::BrakeMoment& moment : brake) {
    EXPECT_NEAR(std::hypot(moment.position.x, moment.position.y - 4.0), 4.0, 1e-4);
  }
  EXPECT_NEAR(brake.back().speed, 0.0, 1e-9);
  EXPECT_GT(way_of(brake_along(circling, 0, kBegin, limits_of(0.0))),
            way_of(brake_along(straight, 0, kBegin, limits_of(0.0))) + 0.01);
  // The pace falls by 15/8 of a steady one at most: 15/16 v^2 / a.
  EXPECT_NEAR(way_of(brake_along(straight, 0, kBegin, limits_of(0.0))), 0.5 + 15.0 / 16.0 * 25.0 / 8.0, 0.1);
}

TEST(ImmediateBrake, IsNoneWhereTheLimitsAreBrokenAlready) {
  tern::Limits limits = limits_of(30.0);
  limits.v_horizontal = 4.0;
  EXPECT_TRUE(brake_straight(straight, 0, kBegin, limits).empty());
}

}  // namespace
