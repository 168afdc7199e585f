// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The core's own angles against the C library's in long double.
#include "yaw/angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random.hpp"

namespace {

using tern::angle_of;
using tern::Heading;
using tern::heading_of;
using tern::kPi;
using tern::wrapped;
using tern_test::Random;

TEST(YawAngle, QuarterTurns) {
  EXPECT_EQ(heading_of(0.0).cosine, 1.0);
  EXPECT_EQ(heading_of(0.0).sine, 0.0);
  EXPECT_EQ(angle_of({1.0, 0.0}), 0.0);
  EXPECT_DOUBLE_EQ(angle_of({0.0, 2.0}), kPi / 2);
  EXPECT_DOUBLE_EQ(angle_of({0.0, -1e-300}), -kPi / 2);
  EXPECT_DOUBLE_EQ(angle_of({-1e300, 0.0}), kPi);
  EXPECT_DOUBLE_EQ(angle_of({1.0, 1.0}), kPi / 4);
}

TEST(YawAngle, HeadingsAgreeWithTheLibrary) {
  Random random(1);
  for (int i = 0; i < 200000; ++i) {
    const double angle = random.real(-1.0, 1.0) * std::pow(10.0, random.integer(-8, 5));
    const Heading heading = heading_of(angle);
    const double allowed = 1e-15 + 1e-16 * std::fabs(angle);
    ASSERT_NEAR(heading.cosine, static_cast<double>(std::cos(static_cast<long double>(angle))), allowed) << angle;
    ASSERT_NEAR(heading.sine, static_cast<double>(std::sin(static_cast<long double>(angle))), allowed) << angle;
  }
}

TEST(YawAngle, AnglesAgreeWithTheLibrary) {
  Random random(2);
  for (int i = 0; i < 200000; ++i) {
    const double scale = std::pow(10.0, random.integer(-200, 200));
    const Heading h{scale * random.real(-1.0, 1.0),
                    scale * random.real(-1.0, 1.0) * std::pow(10.0, random.integer(-9, 0))};
    const long double expected = std::atan2(static_cast<long double>(h.sine), static_cast<long double>(h.cosine));
    ASSERT_NEAR(angle_of(h), static_cast<double>(expected), 1e-15) << h.cosine << " " << h.sine;
  }
}

TEST(YawAngle, WrappedLeavesTheDirection) {
  Random random(3);
  for (int i = 0; i < 100000; ++i) {
    const double angle = random.real(-1000.0, 1000.0);
    const double rest = wrapped(angle);
    ASSERT_LE(std::fabs(rest), kPi * (1.0 + 1e-15));
    ASSERT_NEAR(std::remainder(angle - rest, 2.0 * kPi), 0.0, 1e-12);
  }
  EXPECT_DOUBLE_EQ(wrapped(kPi), kPi);
  EXPECT_DOUBLE_EQ(wrapped(3.0 * kPi), kPi);
  EXPECT_DOUBLE_EQ(wrapped(-kPi / 2), -kPi / 2);
}

TEST(YawAngle, WhatIsNoAngleCountsAsZero) {
  EXPECT_EQ(heading_of(std::numeric_limits<double>::quiet_NaN()).cosine, 1.0);
  EXPECT_EQ(heading_of(std::numeric_limits<double>::infinity()).sine, 0.0);
  EXPECT_EQ(angle_of({0.0, 0.0}), 0.0);
  EXPECT_EQ(wrapped(std::numeric_limits<double>::quiet_NaN()), 0.0);
  EXPECT_EQ(wrapped(1.5e6), 0.0);
  EXPECT_NE(wrapped(1e6), 0.0);
  EXPECT_EQ(tern::whole_turns(1.5e6), 0.0);
}

}  // namespace
