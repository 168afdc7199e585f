// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whole flights through port/onboard, with what goes wrong on vehicles.
#include <gtest/gtest.h>

#include "onboard/onboard_sky.hpp"

namespace {

using tern::FlightReason;
using tern_onboard::Fault;
using tern_onboard::State;
using tern_test::kMs;
using tern_test::Sky;

std::uint64_t count(const Sky& sky, Fault fault) {
  return sky.onboard.status(sky.now).faults[static_cast<std::size_t>(fault)];
}

TEST(OnboardFlight, ReachesTheGoalThroughAForest) {
  Sky sky("P25:20001");
  ASSERT_TRUE(sky.begin().ok);
  EXPECT_EQ(sky.fly(60.0), FlightReason::kArrived);
  EXPECT_LT(tern_onboard::length(tern_onboard::minus(sky.position, sky.world.goal)), 0.05);
  EXPECT_GT(sky.least_clearance, sky.world.settings.body_radius);
  EXPECT_LT(sky.onboard.status(sky.now).stray_max, 0.02);
}

TEST(OnboardFlight, GoesOnAroundAJumpOfTheEstimate) {
  Sky sky("P25:20001");
  ASSERT_TRUE(sky.begin().ok);
  for (int k = 0; k < 300; ++k) sky.step();
  sky.jump({1.3, -0.8, 0.4});
  EXPECT_EQ(sky.fly(60.0), FlightReason::kArrived);
  // The goal keeps its numbers in the estimate's frame.
  EXPECT_LT(tern_onboard::length(tern_onboard::minus(sky.pose().pose.position, sky.world.goal)), 0.05);
  EXPECT_GT(sky.least_clearance, sky.world.settings.body_radius);
  EXPECT_EQ(count(sky, Fault::kPoseJump), 1u);
}

TEST(OnboardFlight, BrakesWithoutPosesAndGoesOnWithThem) {
  Sky sky("P25:20001");
  ASSERT_TRUE(sky.begin().ok);
  for (int k = 0; k < 300; ++k) sky.step();
  sky.poses = false;
  for (int k = 0; k < 300; ++k) sky.step();
  EXPECT_LT(tern_onboard::length(sky.onboard.setpoint(sky.now).velocity), 1e-9);
  sky.poses = true;
  for (int k = 0; k < 2; ++k) sky.step();
  EXPECT_EQ(sky.fly(60.0), FlightReason::kArrived);
  EXPECT_GT(sky.least_clearance, sky.world.settings.body_radius);
  EXPECT_EQ(count(sky, Fault::kPoseLost), 1u);
}

TEST(OnboardFlight, EndsIfTheVehicleLeavesIt) {
  Sky sky("P25:20001");
  ASSERT_TRUE(sky.begin().ok);
  for (int k = 0; k < 200; ++k) sky.step();
  sky.follows = false;
  for (int k = 0; k < 200; ++k) sky.step();
  EXPECT_EQ(sky.onboard.status(sky.now).state, State::kLost);
  const tern_onboard::Setpoint held = sky.onboard.setpoint(sky.now);
  EXPECT_LT(tern_onboard::length(tern_onboard::minus(held.position, sky.position)), 1e-9);
  EXPECT_EQ(tern_onboard::length(held.velocity), 0.0);
  sky.follows = true;
  ASSERT_TRUE(sky.onboard.set_goal(sky.world.goal, sky.now).ok);
  EXPECT_EQ(sky.fly(60.0), FlightReason::kArrived);
}

}  // namespace
