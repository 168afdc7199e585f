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

TEST(OnboardFlight, SaysEachLossOnce) {
  Sky sky("P25:20001");
  ASSERT_TRUE(sky.begin().ok);
  int said = 0;
  for (int loss = 0; loss < 2; ++loss) {
    sky.poses = true;
    for (int k = 0; k < 200; ++k) sky.step();
    sky.poses = false;
    for (int k = 0; k < 100; ++k) sky.step();
  }
  for (const tern_onboard::Notice& notice : sky.onboard.take_notices()) {
    said += notice.text == "no poses come: the vehicle brakes until there are some" ? 1 : 0;
  }
  EXPECT_EQ(said, 2);
  EXPECT_EQ(count(sky, Fault::kPoseLost), 2u);
}

TEST(OnboardFlight, GoesOnWhereTheClockWasSetBack) {
  Sky sky("P25:20001");
  ASSERT_TRUE(sky.begin().ok);
  for (int k = 0; k < 300; ++k) sky.step();
  const tern::Vec3 before = sky.onboard.setpoint(sky.now).position;
  sky.now -= 4000 * kMs;
  sky.step();
  EXPECT_LT(tern_onboard::length(tern_onboard::minus(sky.onboard.setpoint(sky.now).position, before)), 0.1);
  EXPECT_EQ(sky.fly(60.0), FlightReason::kArrived);
  EXPECT_GT(sky.least_clearance, sky.world.settings.body_radius);
  EXPECT_EQ(count(sky, Fault::kClockBack), 1u);
  // Without a pose on the new clock, it brakes.
  sky.now -= 4000 * kMs;
  sky.poses = false;
  for (int k = 0; k < 100; ++k) sky.step();
  EXPECT_EQ(count(sky, Fault::kPoseLost), 1u);
}

TEST(OnboardFlight, SkipsTicksThatAreLateAndSaysSo) {
  Sky sky("P25:20001");
  ASSERT_TRUE(sky.begin().ok);
  for (int k = 0; k < 100; ++k) sky.step();
  const std::uint64_t ticks = sky.onboard.status(sky.now).ticks;
  sky.now += 200 * kMs;
  sky.step();
  EXPECT_EQ(sky.onboard.status(sky.now).ticks, ticks + 2);
  EXPECT_EQ(sky.onboard.status(sky.now).ticks_skipped, 19u);
  EXPECT_EQ(count(sky, Fault::kTicksSkipped), 1u);
  EXPECT_EQ(sky.fly(60.0), FlightReason::kArrived);
  EXPECT_GT(sky.least_clearance, sky.world.settings.body_radius);
}

TEST(OnboardFlight, HoldsThePlaceWhereTheAutopilotBeganToFollow) {
  Sky sky("P25:20001");
  sky.onboard.set_following(false);
  sky.send_pose();
  EXPECT_FALSE(sky.onboard.set_goal(sky.world.goal, sky.now).ok);
  sky.onboard.set_following(true);
  const tern::Vec3 held = sky.position;
  sky.follows = false;
  for (int k = 0; k < 10; ++k) {
    sky.position.x += 0.01;  // drifts
    sky.step();
    EXPECT_EQ(sky.onboard.setpoint(sky.now).position.x, held.x);
  }
  ASSERT_TRUE(sky.onboard.set_goal(sky.world.goal, sky.now).ok);
  EXPECT_NEAR(sky.onboard.setpoint(sky.now).position.x, held.x, 1e-9);
  sky.onboard.set_following(false);
  sky.position.x += 1.0;
  for (int k = 0; k < 2; ++k) sky.step();
  EXPECT_EQ(sky.onboard.setpoint(sky.now).position.x, sky.position.x);
  EXPECT_EQ(sky.onboard.status(sky.now).state, State::kReady);
}

/// Off by 7 of the 10 cm of the margin, so at half the speed; unless the parameter says otherwise.
TEST(OnboardFlight, FliesSlowerWhileItStrays) {
  for (const bool slows : {true, false}) {
    Sky sky("P25:20001", [slows](tern_onboard::Settings& s) { s.watch.slow_when_straying = slows; });
    ASSERT_TRUE(sky.begin().ok);
    for (int k = 0; k < 200; ++k) sky.step();
    sky.off = {0.0, 0.07, 0.0};
    for (int k = 0; k < 150; ++k) sky.step();
    const tern_onboard::Status status = sky.onboard.status(sky.now);
    const double speed = tern_onboard::length(sky.onboard.setpoint(sky.now).velocity);
    EXPECT_EQ(status.report.reason, slows ? FlightReason::kStrays : FlightReason::kNone);
    EXPECT_EQ(speed < 0.51 * sky.world.settings.v_max, slows) << speed;
    EXPECT_NE(describe(status).find(slows ? "flies slower" : "goes on"), std::string::npos);
  }
}

TEST(OnboardFlight, FliesAMissionPastItsPoints) {
  Sky sky("P49:20001");
  sky.send_pose();
  const tern::Vec3 s = sky.position, g = sky.world.goal;
  tern::Via middle{};
  middle.position = tern_onboard::times(tern_onboard::plus(s, g), 0.5);
  middle.tolerance = 2.5;
  tern::Via end{};
  end.position = g;
  ASSERT_TRUE(sky.onboard.set_mission({middle, end}, tern::ViaPolicy::kSkip, sky.now).ok);
  EXPECT_FALSE(sky.onboard.set_mission({}, tern::ViaPolicy::kSkip, sky.now).ok);
  EXPECT_EQ(sky.fly(60.0), FlightReason::kArrived);
  EXPECT_EQ(sky.onboard.status(sky.now).report.passed, 2);
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
