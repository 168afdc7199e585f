// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Over an open field, nothing comes back from the sky and from far ground. What that says is the user's statement.
#include <gtest/gtest.h>

#include <cmath>

#include "support/flown.hpp"

namespace {

using tern::FlightReason;
using tern_test::Flown;
using tern_test::Images;

/// A flight of 30 m over nothing but ground.
void fly_over_field(double height, double speed) {
  SCOPED_TRACE(height);
  tern_test::FlightSettings settings;
  settings.v = speed;
  settings.start.z = height;
  settings.no_return = 8.0;
  Flown flown({}, settings);
  flown.images = Images::kShort;
  ASSERT_EQ(flown.started, tern::Status::kOk);
  ASSERT_EQ(flown.flight.set_goal({30.0, 3.0, height}), tern::Status::kOk);
  EXPECT_EQ(flown.fly(60.0), FlightReason::kArrived);
  const double straight = std::hypot(30.0, 3.0) / speed + speed / settings.a;
  EXPECT_LE(1e-9 * static_cast<double>(flown.time), 1.15 * straight + 1.0);
}

TEST(OpenField, IsFlownOverAtTheLimitIfNoReturnIsStatedToBeFree) {
  const double heights[] = {20.0, 1.5, 120.0};
  const double speeds[] = {3.0, 3.0, 5.0};
  for (int k = 0; k < tern_test::scaled(3); ++k) fly_over_field(heights[k], speeds[k]);
}

TEST(OpenField, IsUnknownOtherwise) {
  tern_test::FlightSettings settings;
  settings.start.z = 20.0;
  Flown flown({}, settings);
  flown.images = Images::kShort;
  ASSERT_EQ(flown.flight.set_goal({30.0, 3.0, 20.0}), tern::Status::kOk);
  for (int k = 0; k < 300; ++k) flown.tick();
  EXPECT_LT(flown.position().x, 1.5);
}

}  // namespace
