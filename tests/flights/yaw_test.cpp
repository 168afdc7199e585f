// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The nose in flight: limits on its rate and acceleration at every instant, no steps between yaw plans, and flights
// whose camera sees only what is ahead of the nose.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/flights.hpp"

namespace {

using namespace tern;
using tern_test::FlightSettings;
using tern_test::Flown;
using tern_test::forest;
using tern_test::Random;
using tern_test::Scene;

constexpr double kMost = 5.0;  ///< rad/s^2

FlightYaw yaw_of(FlightYawMode mode) {
  FlightYaw yaw{};
  yaw.mode = mode;
  yaw.acceleration_max = kMost;
  yaw.field_of_view = 0.5 * M_PI;
  yaw.start = {1.0, 0.0};
  yaw.heading = {0.0, 1.0};
  yaw.point = {10.0, 4.0, 0.0};
  return yaw;
}

/// A flight whose yaw is looked at every 2 ms.
struct Turned {
  Turned(const Scene& scene, const FlightSettings& settings, const FlightYaw& yaw) : flown(scene, settings) {
    EXPECT_EQ(flown.started, Status::kOk);
    EXPECT_EQ(flown.flight.set_yaw(yaw), Status::kOk);
    flown.follows_yaw = true;
  }

  FlightReason fly(double seconds) {
    const std::int64_t end = flown.time + static_cast<std::int64_t>(seconds * 1e9);
    while (flown.time < end && !testing::Test::HasFatalFailure()) {
      const std::int64_t from = flown.time;
      const YawSample ahead = flown.flight.yaw(from + flown.spec.tick);
      flown.tick();
      check_same(ahead, flown.flight.yaw(flown.time));
      for (std::int64_t t = from; t < flown.time; t += 2000000) check_limits(flown.flight.yaw(t));
      waits += flown.report.waits_for_nose ? 1 : 0;
      if (flown.report.mode == FlightMode::kRest && flown.report.reason != FlightReason::kNone) break;
    }
    return flown.report.reason;
  }

  /// What was planned for the next tick stays, but for rounding where a new plan takes over.
  void check_same(const YawSample& before, const YawSample& after) {
    EXPECT_NEAR(before.yaw.cosine, after.yaw.cosine, 1e-12);
    EXPECT_NEAR(before.yaw.sine, after.yaw.sine, 1e-12);
    EXPECT_NEAR(before.angle, after.angle, 1e-9);
    EXPECT_NEAR(before.yaw.rate, after.yaw.rate, 1e-9);
    EXPECT_NEAR(before.acceleration, after.acceleration, 1e-6);
  }

  void check_limits(const YawSample& at) {
    ASSERT_LE(std::abs(at.yaw.rate), flown.spec.yaw_rate + 1e-9);
    ASSERT_LE(std::abs(at.acceleration), kMost + 1e-9);
    ASSERT_NEAR(std::hypot(at.yaw.cosine, at.yaw.sine), 1.0, 1e-12);
    fastest = std::max(fastest, std::abs(at.yaw.rate));
  }

  Flown flown;
  int waits = 0;
  double fastest = 0.0;
};

TEST(FlightYaw, ForestsAreCrossedWithTheNoseAhead) {
  for (int k = 0; k < tern_test::scaled(4); ++k) {
    Random random(static_cast<std::uint64_t>(1800 + k));
    FlightSettings settings;
    settings.v = k % 2 == 0 ? 3.0 : 5.0;
    const FlightYawMode mode = k < 2 ? FlightYawMode::kTowardsUnseen : FlightYawMode::kAlongMotion;
    Turned turned(forest(random, 24.0, 20.0, 1.0 / 30.0), settings, yaw_of(mode));
    ASSERT_EQ(turned.flown.flight.set_goal({24.0, 0.0, 1.5}), Status::kOk);
    EXPECT_EQ(turned.fly(90.0), FlightReason::kArrived) << k;
    EXPECT_GT(turned.fastest, 0.01) << k;
  }
}

TEST(FlightYaw, GoalBehindIsFlownToAfterATurn) {
  Turned turned(Scene{}, FlightSettings{}, yaw_of(FlightYawMode::kTowardsUnseen));
  turned.flown.flight.set_goal({-8.0, 0.0, 1.5});
  EXPECT_EQ(turned.fly(30.0), FlightReason::kArrived);
  EXPECT_GT(turned.waits, 0);
  EXPECT_LT(turned.flown.flight.yaw(turned.flown.time).yaw.cosine, -0.9);
}

TEST(FlightYaw, PointIsLookedAt) {
  FlightYaw yaw = yaw_of(FlightYawMode::kTowardsPoint);
  Turned turned(Scene{}, FlightSettings{}, yaw);
  turned.flown.flight.set_goal({6.0, 0.0, 1.5});
  EXPECT_EQ(turned.fly(30.0), FlightReason::kArrived);
  turned.flown.tick();
  for (int k = 0; k < 200; ++k) turned.flown.tick();
  const YawSample at = turned.flown.flight.yaw(turned.flown.time);
  EXPECT_NEAR(at.yaw.sine, 4.0 / std::hypot(4.0, 4.0), 0.02);
  EXPECT_NEAR(at.yaw.cosine, 4.0 / std::hypot(4.0, 4.0), 0.02);
}

/// The camera looks to the side: what it does not show is not flown into, and the report says why the flight is slow.
TEST(FlightYaw, NoseThatLooksAwaySlowsTheFlight) {
  Turned turned(Scene{}, tern_test::fast(), yaw_of(FlightYawMode::kFixed));
  turned.flown.flight.set_goal({25.0, 0.0, 1.5});
  EXPECT_EQ(turned.fly(60.0), FlightReason::kArrived);
  const int slow = turned.waits;
  EXPECT_GT(slow, 20);
  Turned ahead(Scene{}, tern_test::fast(), yaw_of(FlightYawMode::kTowardsUnseen));
  ahead.flown.flight.set_goal({25.0, 0.0, 1.5});
  EXPECT_EQ(ahead.fly(60.0), FlightReason::kArrived);
  EXPECT_LT(ahead.waits, slow / 4);
  EXPECT_LT(ahead.flown.time, turned.flown.time);
}

TEST(FlightYaw, PointsArePassedWithTheirHeadings) {
  const double c = std::cos(0.6);
  const double s = std::sin(0.6);
  const Heading headings[3] = {{c, s}, {c, -s}, {1.0, 0.0}};
  FlightYaw yaw = yaw_of(FlightYawMode::kAtPoints);
  yaw.headings = headings;
  yaw.heading_count = 3;
  Turned turned(Scene{}, FlightSettings{}, yaw);
  Via way[3];
  way[0].position = {6.0, 0.0, 1.5};
  way[1].position = {12.0, 0.0, 1.5};
  way[2].position = {18.0, 0.0, 1.5};
  ASSERT_EQ(turned.flown.flight.set_mission(way, 3, ViaPolicy::kEnd), Status::kOk);
  int leg = 0;
  while (turned.flown.report.reason != FlightReason::kArrived && turned.flown.time < 40000000000) {
    turned.fly(0.01);
    if (turned.flown.report.leg == leg) continue;
    const YawSample at = turned.flown.flight.yaw(turned.flown.time);
    EXPECT_NEAR(at.yaw.sine, headings[leg].sine, 0.15) << leg;
    leg = turned.flown.report.leg;
  }
  EXPECT_EQ(turned.flown.report.passed, 3);
}

TEST(FlightYaw, ModesMayChangeAtAnyTime) {
  Random random(1810);
  FlightYaw yaw = yaw_of(FlightYawMode::kTowardsUnseen);
  Turned turned(Scene{}, FlightSettings{}, yaw);
  turned.flown.flight.set_goal({20.0, 3.0, 1.5});
  for (int k = 0; k < 60; ++k) {
    yaw.mode = static_cast<FlightYawMode>(static_cast<int>(random.real(0.0, 4.0)));
    const double angle = random.real(-M_PI, M_PI);
    yaw.heading = {std::cos(angle), std::sin(angle)};
    yaw.point = {random.real(-5.0, 25.0), random.real(-5.0, 5.0), 0.0};
    ASSERT_EQ(turned.flown.flight.set_yaw(yaw), Status::kOk);
    turned.fly(random.real(0.02, 0.5));
  }
  EXPECT_GT(turned.fastest, 1.0);
}

TEST(FlightYaw, WrongRequestsAreRefused) {
  Flown flown(Scene{}, FlightSettings{});
  const FlightYaw good = yaw_of(FlightYawMode::kTowardsUnseen);
  EXPECT_EQ(Flight{}.set_yaw(good), Status::kInvalidArgument);
  EXPECT_EQ(Flight{}.yaw(0).yaw.cosine, 0.0);
  FlightYaw bad = good;
  bad.acceleration_max = 0.0;
  EXPECT_EQ(flown.flight.set_yaw(bad), Status::kLimitsInvalid);
  bad = good;
  bad.field_of_view = std::numeric_limits<double>::infinity();
  EXPECT_EQ(flown.flight.set_yaw(bad), Status::kNonFiniteInput);
  bad.field_of_view = 7.0;
  EXPECT_EQ(flown.flight.set_yaw(bad), Status::kInvalidArgument);
  bad = good;
  bad.start = {0.0, 0.0};
  EXPECT_EQ(flown.flight.set_yaw(bad), Status::kInvalidArgument);
  bad = yaw_of(FlightYawMode::kFixed);
  bad.heading = {0.0, 0.0};
  EXPECT_EQ(flown.flight.set_yaw(bad), Status::kInvalidArgument);
  bad = yaw_of(FlightYawMode::kTowardsPoint);
  bad.point.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(flown.flight.set_yaw(bad), Status::kNonFiniteInput);
  EXPECT_EQ(flown.flight.set_yaw(yaw_of(FlightYawMode::kAtPoints)), Status::kInvalidArgument);
  EXPECT_EQ(flown.flight.set_yaw(yaw_of(static_cast<FlightYawMode>(5))), Status::kInvalidArgument);
  EXPECT_EQ(flown.flight.set_yaw(good), Status::kOk);
  EXPECT_EQ(flown.flight.yaw(0).yaw.cosine, 1.0);
}

}  // namespace
