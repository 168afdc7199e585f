// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights with faults: frames that are lost or late, poses that jump, ticks that are skipped, pixels that are wrong,
// and things that appear. Where the theorem's assumptions hold there is no contact; Flown asserts that at every tick.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include "base/math.hpp"
#include "support/flights.hpp"

namespace {

using namespace tern;
using tern_test::fast;
using tern_test::FlightSettings;
using tern_test::Flown;
using tern_test::forest;
using tern_test::Random;
using tern_test::Scene;
using tern_test::size;
using tern_test::story;

/// A flight of 20 m through a forest.
std::unique_ptr<Flown> begin(std::uint64_t seed, const FlightSettings& settings, double density = 1.0 / 30.0) {
  Random random(seed);
  auto flown = std::make_unique<Flown>(forest(random, 20.0, 20.0, density), settings);
  EXPECT_EQ(flown->started, Status::kOk);
  EXPECT_EQ(flown->flight.set_goal({20.0, 0.0, 1.5}), Status::kOk);
  return flown;
}

TEST(FlightFaults, LostAndLateFramesCostOnlyTime) {
  for (int k = 0; k < tern_test::scaled(6); ++k) {
    const double drops[] = {0.1, 0.5, 0.9, 0.0, 0.0, 0.5};
    const int late[] = {0, 0, 0, 15, 30, 30};
    const auto flown = begin(static_cast<std::uint64_t>(1000 + k), fast());
    flown->drop = drops[k % 6];
    flown->late = late[k % 6];
    EXPECT_EQ(flown->fly(120.0), FlightReason::kArrived) << k << ": " << story(*flown);
  }
}

TEST(FlightFaults, ReasonsHaveWords) {
  for (int k = 0; k < 16; ++k) {
    const std::string mode = flight_mode_name(static_cast<FlightMode>(k));
    const std::string reason = flight_reason_text(static_cast<FlightReason>(k));
    EXPECT_EQ(mode == "unknown", k > static_cast<int>(FlightMode::kThreat)) << k;
    EXPECT_EQ(reason == "unknown", k > static_cast<int>(FlightReason::kHeldUp)) << k;
  }
}

/// The map ends at some instant; the vehicle ends at rest, and says so.
TEST(FlightFaults, WithoutFramesItComesToRest) {
  int stale = 0;
  for (int k = 0; k < tern_test::scaled(4); ++k) {
    const auto flown = begin(static_cast<std::uint64_t>(1020 + k), fast());
    flown->fly(0.3 + 0.8 * k);
    EXPECT_FALSE(flown->report.map_stale) << k;
    flown->frames = false;
    flown->fly(0.5);
    EXPECT_FALSE(flown->report.map_stale) << k;
    const FlightReason reason = flown->fly(80.0);
    EXPECT_TRUE(reason == FlightReason::kMapStale || reason == FlightReason::kArrived) << k << ": " << story(*flown);
    EXPECT_TRUE(flown->report.map_stale) << k;
    EXPECT_GT(flown->report.frame_age, 1000000000) << k;
    if (reason != FlightReason::kMapStale) continue;
    ++stale;
    flown->frames = true;  // and it goes on by itself
    for (int t = 0; t < 10; ++t) flown->tick();
    EXPECT_FALSE(flown->report.map_stale) << k;
    EXPECT_EQ(flown->fly(60.0), FlightReason::kArrived) << k << ": " << story(*flown);
  }
  EXPECT_GT(stale, 0);
}

/// The pose jumps by 0.2 m again and again, within its margin.
TEST(FlightFaults, PosesMayJumpWithinTheirMargin) {
  for (int k = 0; k < tern_test::scaled(4); ++k) {
    FlightSettings settings = fast();
    settings.pose_margin = 0.1;
    settings.radius = settings.body + 2.0 * settings.pose_margin;  // the map's pose and the vehicle's, either way
    const auto flown = begin(static_cast<std::uint64_t>(1040 + k), settings, 1.0 / 60.0);
    Random random(static_cast<std::uint64_t>(k));
    while (flown->time < 40000000000 && flown->report.reason == FlightReason::kNone && !HasFatalFailure()) {
      const double angle = random.real(0.0, 6.28);
      flown->pose_error = {0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.0};
      flown->fly(0.1 * random.integer(1, 20));
      const Vec3 e = flown->pose_error;
      flown->pose_error = {-e.x, -e.y, 0.0};  // 0.2 m
      flown->fly(0.5);
    }
    EXPECT_NE(flown->report.reason, FlightReason::kNone) << k << ": " << story(*flown);
  }
}

/// Beyond the margin nothing is promised but an end: no tick fails, and the vehicle rests at last.
TEST(FlightFaults, PosesThatJumpTooFarDoNotHang) {
  const auto flown = begin(1060, fast());
  flown->may_touch = true;
  flown->fly(2.0);
  flown->pose_error = {0.0, 0.2, 0.0};
  flown->fly(90.0);
  EXPECT_EQ(flown->report.mode, FlightMode::kRest) << story(*flown);
  EXPECT_NE(flown->report.reason, FlightReason::kNone) << story(*flown);
}

TEST(FlightFaults, TicksMayBeSkipped) {
  for (int k = 0; k < tern_test::scaled(4); ++k) {
    const auto flown = begin(static_cast<std::uint64_t>(1080 + k), fast());
    Random random(static_cast<std::uint64_t>(k));
    while (flown->time < 90000000000 && flown->report.reason == FlightReason::kNone && !HasFatalFailure()) {
      flown->fly(0.01 * random.integer(1, 60));
      if (flown->report.reason == FlightReason::kNone) flown->skip(random.integer(1, 50));
    }
    EXPECT_EQ(flown->report.reason, FlightReason::kArrived) << k << ": " << story(*flown);
  }
}

/// One pixel in a hundred shows anything.
TEST(FlightFaults, WrongPixelsCostOnlyTime) {
  for (int k = 0; k < tern_test::scaled(6); ++k) {
    FlightSettings settings = fast();
    settings.v = k % 2 == 0 ? 5.0 : 8.0;
    settings.outliers = 0.01;
    settings.noise = 0.01;
    settings.hits = 2;
    settings.support = 1;
    const auto flown = begin(static_cast<std::uint64_t>(1100 + k), settings, 1.0 / 25.0);
    EXPECT_EQ(flown->fly(60.0), FlightReason::kArrived) << k << ": " << story(*flown);
  }
}

/// From one second on, no pixel shows anything, or all of them show something right before the lens. Nothing more is
/// seen to be free, so the vehicle comes to rest and says why.
TEST(FlightFaults, BlindImagesEndAtRest) {
  for (const tern_test::Images images : {tern_test::Images::kBlind, tern_test::Images::kNear}) {
    for (int k = 0; k < tern_test::scaled(3); ++k) {
      const auto flown = begin(static_cast<std::uint64_t>(1500 + k), fast(), 1.0 / 25.0);
      flown->fly(1.0);
      flown->images = images;
      const FlightReason reason = flown->fly(80.0);
      EXPECT_TRUE(reason != FlightReason::kNone && reason != FlightReason::kArrived) << story(*flown);
      EXPECT_EQ(flown->report.mode, FlightMode::kRest) << story(*flown);
    }
  }
}

/// All pixels show free space up to the range: true of an empty world, through which the vehicle flies.
TEST(FlightFaults, ImagesOfNothingButFreeSpaceAreFlownThrough) {
  Flown flown(Scene{}, fast());
  flown.images = tern_test::Images::kFar;
  ASSERT_EQ(flown.flight.set_goal({24.0, 0.0, 1.5}), Status::kOk);
  EXPECT_EQ(flown.fly(30.0), FlightReason::kArrived) << story(flown);
}

/// Ticks are skipped once the user says stop: the vehicle comes to rest all the same, and does not fly on to its old
/// goal.
TEST(FlightFaults, TicksSkippedAfterAStopOnlyDelayTheBrake) {
  int missed = 0;
  for (int k = 0; k < tern_test::scaled(30) && !HasFatalFailure(); ++k) {
    FlightSettings settings = fast();
    settings.work_per_tick = 270;
    const auto flown = begin(static_cast<std::uint64_t>(1264 + k), settings, 1.0 / 15.0);
    flown->fly(2.4 + 0.1 * k);
    EXPECT_EQ(flown->flight.stop(), Status::kOk);
    flown->tick();
    const std::uint32_t dropped = flown->report.dropped;
    flown->skip(7);
    flown->fly(2.0);
    EXPECT_EQ(flown->report.mode, FlightMode::kRest) << k << ": " << story(*flown);
    missed += flown->report.dropped > dropped ? 1 : 0;
  }
  EXPECT_GT(missed, 0);
}

/// A plan is pending at rest. It must not be flown once the user says stop.
TEST(FlightFaults, AStopTakesBackThePlanInWork) {
  int planning = 0;
  for (int k = 0; k < tern_test::scaled(20) && !HasFatalFailure(); ++k) {
    FlightSettings settings = fast();
    settings.work_per_tick = 400;
    const auto flown = begin(static_cast<std::uint64_t>(1260 + k), settings, 1.0 / 15.0);
    for (int t = 0; t < 5 + k; ++t) flown->tick();
    const Vec3 before = flown->position();
    planning += flown->report.asked > 0 && flown->report.committed == 0 ? 1 : 0;
    EXPECT_EQ(flown->flight.stop(), Status::kOk);
    for (int t = 0; t < 200; ++t) flown->tick();
    EXPECT_EQ(flown->report.mode, FlightMode::kRest) << k;
    EXPECT_EQ(flown->report.reason, FlightReason::kNoGoal) << k;
    EXPECT_LT(size(flown->position() - before), 0.05) << k << ": " << story(*flown);
  }
  EXPECT_GT(planning, 0);
}

/// Whatever was pending when the goal moved: the vehicle arrives at the new one.
TEST(FlightFaults, APlanInWorkForTheOldGoalDoesNotReachTheNewOne) {
  for (int k = 0; k < tern_test::scaled(30) && !HasFatalFailure(); ++k) {
    FlightSettings settings = fast();
    settings.work_per_tick = k % 2 == 0 ? 300 : 700;
    settings.assumed = 12.0;  // plans in space that is known to be free are committed as a whole
    Flown flown(Scene{}, settings);
    EXPECT_EQ(flown.flight.set_goal({6.0, 0.0, 1.5}), Status::kOk);
    for (int t = 0; t <= k; ++t) flown.tick();
    EXPECT_EQ(flown.flight.set_goal({2.0, 6.0, 1.5}), Status::kOk);
    EXPECT_EQ(flown.fly(15.0), FlightReason::kArrived) << k << ": " << story(flown);
    EXPECT_LT(size(flown.position() - Vec3{2.0, 6.0, 1.5}), 0.01) << k << ": " << story(flown);
  }
}

TEST(FlightFaults, GoalsOutOfReachEndWithAReason) {
  for (const Vec3& goal : {Vec3{1e6, 0.0, 1.5}, Vec3{5.0, 0.0, -40.0}, Vec3{-1e9, 1e9, 1e9}}) {
    const auto flown = begin(1300, fast());
    EXPECT_EQ(flown->flight.set_goal(goal), Status::kOk);
    flown->fly(12.0);
    EXPECT_EQ(flown->flight.set_goal({std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}), Status::kNonFiniteInput);
    EXPECT_EQ(flown->flight.set_goal({20.0, 0.0, 1.5}), Status::kOk);
    flown->fly(90.0);
    EXPECT_NE(flown->report.reason, FlightReason::kNone) << story(*flown);
  }
}

}  // namespace
