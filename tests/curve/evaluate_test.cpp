// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tern/trajectory.hpp"

namespace {

using namespace tern;

/// x = 35 u^4 - 84 u^5 + 70 u^6 - 20 u^7 from 1 to 3 in two seconds, then back in four; the map lies far away.
Trajectory there_and_back() {
  Trajectory trajectory{};
  trajectory.count = 2;
  trajectory.origin = {100.0, 200.0, 300.0};
  const double x[2] = {1.0, 3.0};
  for (int i = 0; i < 2; ++i) {
    trajectory.segments[i].duration = i == 0 ? 2.0 : 4.0;
    for (int k = 0; k < kControlPoints; ++k) trajectory.segments[i].points[k] = {x[k < 4 ? i : 1 - i], 0.5, -0.5};
  }
  return trajectory;
}

bool is_zero(const Vec3& v) {
  return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

TEST(Evaluate, MiddleOfARestToRestSegment) {
  const Sample sample = evaluate(there_and_back(), 1.0);
  EXPECT_NEAR(sample.position.x, 102.0, 1e-12);
  EXPECT_NEAR(sample.position.y, 200.5, 1e-12);
  EXPECT_NEAR(sample.velocity.x, 2.0 * 35.0 / 16.0 / 2.0, 1e-12);
  EXPECT_NEAR(sample.acceleration.x, 0.0, 1e-12);
  // Jerk 840 u (1 - u) (1 - 5 u + 5 u^2) per unit way and time, snap its derivative.
  EXPECT_NEAR(sample.jerk.x, 2.0 * 840.0 * 0.25 * -0.25 / 8.0, 1e-11);
  EXPECT_NEAR(sample.snap.x, 0.0, 1e-11);
}

TEST(Evaluate, SnapAtTheStart) {
  // d^4/du^4 of 35 u^4 - ... at 0 is 840.
  EXPECT_NEAR(evaluate(there_and_back(), 0.0).snap.x, 2.0 * 840.0 / 16.0, 1e-11);
}

TEST(Evaluate, DerivativesMatchDifferences) {
  const Trajectory trajectory = there_and_back();
  const double h = 1e-5;
  for (double t = 0.1; t < 5.9; t += 0.237) {
    const Sample before = evaluate(trajectory, t - h);
    const Sample at = evaluate(trajectory, t);
    const Sample after = evaluate(trajectory, t + h);
    EXPECT_NEAR((after.position.x - before.position.x) / (2 * h), at.velocity.x, 1e-7);
    EXPECT_NEAR((after.velocity.x - before.velocity.x) / (2 * h), at.acceleration.x, 1e-7);
    EXPECT_NEAR((after.acceleration.x - before.acceleration.x) / (2 * h), at.jerk.x, 1e-6);
    EXPECT_NEAR((after.jerk.x - before.jerk.x) / (2 * h), at.snap.x, 1e-5);
  }
}

TEST(Evaluate, BeforeTheStartAndNotANumberAreTheStart) {
  const Trajectory trajectory = there_and_back();
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double t : {-1.0, -0.0, 0.0, -infinity, nan}) {
    const Sample sample = evaluate(trajectory, t);
    EXPECT_EQ(sample.position.x, 101.0);
    EXPECT_TRUE(is_zero(sample.velocity));
  }
}

TEST(Evaluate, PastTheEndHolds) {
  const Trajectory trajectory = there_and_back();
  for (const double t : {6.0, 6.0000001, 1e9, std::numeric_limits<double>::infinity()}) {
    const Sample sample = evaluate(trajectory, t);
    EXPECT_EQ(sample.position.x, 101.0);
    EXPECT_TRUE(is_zero(sample.velocity) && is_zero(sample.acceleration) && is_zero(sample.jerk));
    EXPECT_TRUE(is_zero(sample.snap));
  }
}

TEST(Evaluate, DurationItselfIsPastTheEndWhateverTheRounding) {
  Trajectory trajectory{};
  trajectory.count = 7;
  for (int i = 0; i < trajectory.count; ++i) {
    trajectory.segments[i].duration = 0.1 + 0.013 * i;
    for (int k = 0; k < kControlPoints; ++k) trajectory.segments[i].points[k] = {i + k / 7.0, 0.0, 0.0};
  }
  EXPECT_TRUE(is_zero(evaluate(trajectory, duration(trajectory)).velocity));
  EXPECT_GT(evaluate(trajectory, std::nextafter(duration(trajectory), 0.0)).velocity.x, 1.0);
}

TEST(Evaluate, AtAJointTheLaterSegmentSpeaks) {
  const Trajectory trajectory = there_and_back();
  const Sample at = evaluate(trajectory, 2.0);
  const Sample before = evaluate(trajectory, std::nextafter(2.0, 0.0));
  EXPECT_EQ(at.position.x, 103.0);
  EXPECT_NEAR(before.position.x, at.position.x, 1e-12);
  EXPECT_NEAR(before.jerk.x, at.jerk.x, 1e-9);
  EXPECT_NEAR(at.snap.x, -2.0 * 840.0 / 256.0, 1e-12);
}

TEST(Evaluate, AnEmptyTrajectoryIsZero) {
  const Trajectory empty{};
  EXPECT_TRUE(is_zero(evaluate(empty, 1.0).position));
  EXPECT_EQ(duration(empty), 0.0);
  EXPECT_EQ(snap_cost(empty), 0.0);
}

TEST(Duration, IsTheSum) {
  EXPECT_EQ(duration(there_and_back()), 6.0);
}

TEST(SnapCost, OfARestToRestSegment) {
  // The integral of (840 - 10080 u + 25200 u^2 - 16800 u^3)^2 over [0, 1] is 100800 per unit way squared, over T^7.
  const double there = 4.0 * 100800.0 / std::pow(2.0, 7);
  const double back = 4.0 * 100800.0 / std::pow(4.0, 7);
  EXPECT_NEAR(snap_cost(there_and_back()), there + back, 1e-9 * there);
}

TEST(TimeOn, IsExactFromOneEndOfTheClockToTheOther) {
  Trajectory plan{};
  EXPECT_EQ(time_on(plan, 0), 0.0);
  EXPECT_EQ(time_on(plan, 1500000000), 1.5);
  plan.begin = 1700000000123456789;
  EXPECT_EQ(time_on(plan, plan.begin), 0.0);
  EXPECT_EQ(time_on(plan, plan.begin + 1), 1e-9);
  EXPECT_EQ(time_on(plan, plan.begin - 250000000), -0.25);
  plan.begin = INT64_MIN;
  EXPECT_EQ(time_on(plan, INT64_MAX), 18446744073.709553);
  EXPECT_EQ(time_on(plan, INT64_MIN), 0.0);
  plan.begin = INT64_MAX;
  EXPECT_EQ(time_on(plan, INT64_MIN), -18446744073.709553);
}

}  // namespace
