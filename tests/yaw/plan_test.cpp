// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Yaw plans by hand: where the nose points, and when.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/yaw_case.hpp"

namespace {

using namespace tern;
using tern_test::heading;
using tern_test::hover;
using tern_test::polyline;

constexpr double kHalfTurn = 3.14159265358979323846;

YawPlan planned(const Trajectory& trajectory, const YawRequest& request) {
  static YawPlanner planner;
  YawPlan plan{};
  EXPECT_EQ(planner.plan(trajectory, request, plan), Status::kOk);
  return plan;
}

/// From heading 0 at rest, 1 rad/s and 2 rad/s^2 at most.
YawRequest request(YawMode mode) {
  YawRequest result = yaw_request({1.0, 0.0}, 1.0, 2.0);
  result.mode = mode;
  return result;
}

TEST(YawPlan, QuarterTurnTakesAsLongAsTheLimitsAsk) {
  YawRequest turn = request(YawMode::kFixed);
  turn.heading = heading(kHalfTurn / 2);
  const YawPlan plan = planned(hover(10.0), turn);
  // A trapezoid of the rate: pi/2 at 1 rad/s, and half a second lost to the acceleration.
  const double trapezoid = kHalfTurn / 2 + 0.5;
  EXPECT_LT(evaluate(plan, trapezoid - 0.2).angle, kHalfTurn / 2 - 0.02);
  EXPECT_NEAR(evaluate(plan, trapezoid + 0.6).angle, kHalfTurn / 2, 0.02);
  EXPECT_NEAR(evaluate(plan, duration(plan)).angle, kHalfTurn / 2, 1e-4);
  EXPECT_NEAR(evaluate(plan, trapezoid / 2).yaw.rate, 1.0, 1e-3);
}

TEST(YawPlan, TurnsTheShorterWay) {
  YawRequest turn = request(YawMode::kFixed);
  turn.start = heading(3.0);
  turn.heading = heading(-3.0);
  const YawPlan plan = planned(hover(3.0), turn);
  EXPECT_NEAR(evaluate(plan, 3.0).angle, 2.0 * kHalfTurn - 3.0, 1e-3);
  EXPECT_NEAR(evaluate(plan, 3.0).yaw.cosine, std::cos(-3.0), 1e-3);
}

TEST(YawPlan, LooksIntoACornerBeforeItAndIsBackOnTheMotionSoon) {
  const YawPlan plan = planned(polyline({{0, 0, 0}, {8, 0, 0}, {8, 8, 0}}, 4.0), request(YawMode::kAlongMotion));
  EXPECT_NEAR(evaluate(plan, 2.0).angle, 0.0, 0.01);
  EXPECT_NEAR(evaluate(plan, 4.0).angle, kHalfTurn / 4, 0.05);  // halfway where the motion turns
  EXPECT_NEAR(evaluate(plan, 6.0).angle, kHalfTurn / 2, 0.01);
}

TEST(YawPlan, FollowsTheMotionAtTheEndOfAReversal) {
  const YawPlan plan = planned(polyline({{0, 0, 0}, {9, 0, 0}, {0, 0, 0}}, 6.0), request(YawMode::kAlongMotion));
  EXPECT_NEAR(evaluate(plan, 3.0).yaw.cosine, 1.0, 0.01);
  EXPECT_NEAR(evaluate(plan, 9.0).yaw.cosine, -1.0, 0.01);
}

TEST(YawPlan, HoldsWhereTheMotionIsVerticalOrSlow) {
  YawRequest along = request(YawMode::kAlongMotion);
  along.start = heading(0.7);
  const YawPlan climb = planned(polyline({{0, 0, 0}, {0, 0, 5}}, 4.0), along);
  const YawPlan creep = planned(polyline({{0, 0, 0}, {0, 1, 0}}, 4.0), along);  // 0.25 m/s
  for (const double t : {0.0, 1.0, 2.0, 4.0, 9.0}) {
    EXPECT_NEAR(evaluate(climb, t).angle, 0.7, 1e-9);
    EXPECT_NEAR(evaluate(creep, t).angle, 0.7, 1e-9);
  }
}

TEST(YawPlan, KeepsAPointAheadAndHoldsAboveIt) {
  YawRequest towards = request(YawMode::kTowardsPoint);
  towards.point = {0.0, 20.0, 3.0};
  towards.start = heading(kHalfTurn / 4);
  const YawPlan aside = planned(polyline({{-20, 0, 0}, {20, 0, 0}}, 20.0), towards);
  EXPECT_NEAR(evaluate(aside, 10.0).angle, kHalfTurn / 2, 0.01);
  EXPECT_NEAR(evaluate(aside, 20.0).angle, 0.75 * kHalfTurn, 0.01);
  towards.point = {0.0, 0.0, 3.0};
  towards.start = {1.0, 0.0};
  const YawPlan over = planned(polyline({{-20, 0, 0}, {20, 0, 0}}, 20.0), towards);
  EXPECT_NEAR(evaluate(over, 5.0).yaw.cosine, 1.0, 0.01);
  EXPECT_NEAR(evaluate(over, 15.0).yaw.cosine, -1.0, 0.01);
}

TEST(YawPlan, HasTheHeadingsAtTheirTimes) {
  const TimedHeading timed[] = {{2.0, heading(1.0)}, {6.0, heading(-0.5)}};
  YawRequest at_times = request(YawMode::kTimed);
  at_times.timed = timed;
  at_times.timed_count = 2;
  const YawPlan plan = planned(hover(8.0), at_times);
  EXPECT_NEAR(evaluate(plan, 2.0).angle, 1.0, 0.05);
  EXPECT_NEAR(evaluate(plan, 4.0).angle, 0.25, 0.02);
  EXPECT_NEAR(evaluate(plan, 6.0).angle, -0.5, 0.05);
  EXPECT_NEAR(evaluate(plan, 8.0).angle, -0.5, 1e-3);
}

TEST(YawPlan, BeginsWithTheRateAndAccelerationOfTheVehicle) {
  YawRequest turn = request(YawMode::kFixed);
  turn.heading = turn.start = heading(-2.0);
  turn.start_rate = 0.4;
  turn.start_acceleration = -1.5;
  const YawPlan plan = planned(hover(5.0), turn);
  const YawSample begin = evaluate(plan, 0.0);
  EXPECT_NEAR(begin.angle, -2.0, 1e-15);
  EXPECT_EQ(begin.yaw.rate, 0.4);
  EXPECT_EQ(begin.acceleration, -1.5);
  EXPECT_NEAR(evaluate(plan, 5.0).angle, -2.0, 1e-3);
}

/// A rate beyond the limit falls to it at the acceleration's limit.
TEST(YawPlan, SlowsAStartThatIsTooFast) {
  YawRequest fast = request(YawMode::kFixed);
  fast.heading = fast.start;
  fast.start_rate = 3.0;
  const YawPlan plan = planned(hover(10.0), fast);
  EXPECT_EQ(evaluate(plan, 0.0).yaw.rate, 3.0);
  // (3 - 1) / 2 s, and what a piece of 0.1 s and the share of the acceleration take.
  for (double t = 1.5; t < duration(plan); t += 0.01) EXPECT_LE(std::fabs(evaluate(plan, t).yaw.rate), 1.0);
  for (double t = 0.0; t < duration(plan); t += 0.01) EXPECT_LE(std::fabs(evaluate(plan, t).acceleration), 2.0 + 1e-9);
}

TEST(YawPlan, EveryTimeHasAnAnswer) {
  YawRequest turn = request(YawMode::kFixed);
  turn.heading = heading(1.0);
  const YawPlan plan = planned(hover(2.0), turn);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double t : {nan, -1.0, -std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(evaluate(plan, t).angle, evaluate(plan, 0.0).angle);
  }
  for (const double t : {duration(plan), 1e9, std::numeric_limits<double>::infinity()}) {
    EXPECT_NEAR(evaluate(plan, t).angle, 1.0, 1e-4);
    EXPECT_EQ(evaluate(plan, t).yaw.rate, 0.0);
    EXPECT_EQ(evaluate(plan, t).acceleration, 0.0);
  }
  const YawPlan empty{};
  EXPECT_EQ(duration(empty), 0.0);
  EXPECT_EQ(evaluate(empty, 1.0).yaw.cosine, 1.0);
  YawPlan full = plan;
  full.count = kMaxYawPieces + 1;
  EXPECT_EQ(duration(full), 0.0);
  EXPECT_EQ(evaluate(full, 1.0).yaw.cosine, 1.0);
}

/// A half turn at 100 rad/s and 1000 rad/s^2 takes pi / 100 + 0.1 s. A fifth more, the trajectory and the smoothing are
/// 0.318 s: four pieces of 0.1 s would do, but a plan has eight.
TEST(YawPlan, ShortestPlanHasEightPieces) {
  YawRequest fast = yaw_request({1.0, 0.0}, 100.0, 1000.0);
  fast.mode = YawMode::kFixed;
  fast.heading = heading(0.2);
  const YawPlan plan = planned(hover(0.01), fast);
  EXPECT_EQ(plan.count, 8);
  EXPECT_NEAR(duration(plan), 0.01 + 1.2 * (kHalfTurn / 100.0 + 0.1) + 0.15, 1e-12);
  for (double t = 0.0; t < duration(plan); t += 0.001) EXPECT_LE(std::fabs(evaluate(plan, t).acceleration), 1000.0);
  EXPECT_GT(evaluate(plan, duration(plan)).angle, 0.0);
  EXPECT_LT(evaluate(plan, duration(plan)).angle, 0.2);
}

}  // namespace
