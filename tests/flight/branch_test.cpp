// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What committed plans are made of: first parts and brakes.
#include "flight/branch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/math.hpp"
#include "curve/brake.hpp"

namespace {

using namespace tern;

const MotionLimits kFast{Limits{{5.0, 5.0, 5.0}, {8.0, 8.0, 8.0}}};

/// Two segments between states in motion.
Trajectory moving_plan() {
  Trajectory plan{};
  plan.origin = {100.0, -20.0, 3.0};
  const JointState a{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, 1.0, 0.0}, {2.0, -3.0, 1.0}}};
  const JointState b{{{2.0, 1.0, 0.5}, {2.0, 1.0, 0.0}, {0.0, -1.0, 0.5}, {1.0, 1.0, -2.0}}};
  const JointState c{{{5.0, 1.5, 0.5}, kZero, kZero, kZero}};
  EXPECT_TRUE(append_between(a, b, 1.25, plan));
  EXPECT_TRUE(append_between(b, c, 2.0, plan));
  return plan;
}

void expect_near(const Vec3& a, const Vec3& b, double most) {
  EXPECT_NEAR(a.x, b.x, most);
  EXPECT_NEAR(a.y, b.y, most);
  EXPECT_NEAR(a.z, b.z, most);
}

/// A plan is not cut less than a millisecond after a joint.
TEST(FlightBranch, CutsLeaveNoSlivers) {
  Trajectory plan{};
  plan.count = 2;
  plan.segments[0].duration = 0.5;
  plan.segments[1].duration = 0.25;
  EXPECT_EQ(off_joints(plan, 0.5), 0.5);
  EXPECT_EQ(off_joints(plan, 0.50001), 0.5);
  EXPECT_EQ(off_joints(plan, 0.5009), 0.5);
  EXPECT_EQ(off_joints(plan, 0.502), 0.502);
  EXPECT_EQ(off_joints(plan, 0.49999), 0.49999);
  EXPECT_EQ(off_joints(plan, 0.0005), 0.0);
  EXPECT_EQ(off_joints(plan, 0.75), 0.75);
  EXPECT_EQ(off_joints(plan, 2.0), 2.0);
}

void expect_near(const Sample& a, const Sample& b) {
  expect_near(a.position, b.position, 1e-12);
  expect_near(a.velocity, b.velocity, 1e-11);
  expect_near(a.acceleration, b.acceleration, 1e-10);
  expect_near(a.jerk, b.jerk, 1e-8);
}

TEST(FlightBranch, FirstPartIsTheSameCurve) {
  const Trajectory plan = moving_plan();
  for (const double t : {0.01, 0.7, 1.25, 1.26, 3.0}) {
    Trajectory part{};
    take_first_part(plan, t, part);
    EXPECT_NEAR(duration(part), t, 1e-15);
    for (int k = 0; k < 10; ++k) expect_near(evaluate(part, 0.1 * k * t), evaluate(plan, 0.1 * k * t));
  }
  Trajectory whole{};
  take_first_part(plan, 100.0, whole);
  EXPECT_EQ(whole.count, 2);
  EXPECT_EQ(duration(whole), duration(plan));
}

TEST(FlightBranch, RestIsThePlansEnd) {
  const Trajectory plan = moving_plan();
  const double whole = duration(plan);
  for (const double t : {0.0, 0.01, 0.7, 1.25, 1.26}) {
    Trajectory rest{};
    take_remainder(plan, t, 100.0, rest);
    EXPECT_NEAR(duration(rest), whole - t, 1e-12);
    for (int k = 0; k < 10; ++k) {
      const double since = 0.1 * k * (whole - t);
      expect_near(evaluate(rest, since).position, evaluate(plan, t + since).position, 1e-9);
      expect_near(evaluate(rest, since).velocity, evaluate(plan, t + since).velocity, 1e-9);
    }
  }
  Trajectory part{};
  take_remainder(plan, 0.2, 0.1, part);
  EXPECT_EQ(part.count, 1);
  take_remainder(plan, whole + 1.0, 1.0, part);
  EXPECT_EQ(part.count, 1);
  expect_near(evaluate(part, 0.0).position, evaluate(plan, whole).position, 1e-12);
}

/// v = 1 + 2 t - t^2 along x with jerk -2: after 0.5 s the jerk has gone from -2 to 0 at a constant rate.
TEST(FlightBranch, JerkFallsToZero) {
  const JointState from{{kZero, {1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}}};
  const JointState to = settled(from, 0.5);
  EXPECT_DOUBLE_EQ(to.d[2].x, 2.0 - 0.5);
  EXPECT_DOUBLE_EQ(to.d[1].x, 1.0 + 1.0 - 2.0 * 0.25 / 3.0);
  EXPECT_DOUBLE_EQ(to.d[0].x, 0.5 + 0.25 - 2.0 * 0.125 / 8.0);
  EXPECT_DOUBLE_EQ(to.d[3].x, 0.0);
  Trajectory plan{};
  ASSERT_TRUE(append_between(from, to, 0.5, plan));
  EXPECT_NEAR(evaluate(plan, 0.25).jerk.x, -1.0, 1e-11);
  EXPECT_NEAR(evaluate(plan, 0.25).snap.x, 4.0, 1e-9);
}

TEST(FlightBranch, JerkFallsFasterNearALimit) {
  JointState from{{kZero, kZero, {7.9, 0.0, 0.0}, {2.0, 0.0, 0.0}}};
  EXPECT_DOUBLE_EQ(settle_time(from, kFast), kSettleTime);
  from.d[3].x = 7.0;  // 0.05 s would take the acceleration to 8.075, 0.025 s to 7.9875
  EXPECT_DOUBLE_EQ(settle_time(from, kFast), 0.5 * kSettleTime);
  from.d[2].x = 8.5;
  EXPECT_DOUBLE_EQ(settle_time(from, kFast), kSettleTime / 32.0);
}

TEST(FlightBranch, StopsJoinToJerkAndEndAtRest) {
  Stopping scratch;
  const Trajectory plan = moving_plan();
  for (int shape = 0; shape < kStops; ++shape) {
    Trajectory part{};
    take_first_part(plan, 0.9, part);
    ASSERT_TRUE(append_stop(joint_at(plan, 0.9, plan.origin), kFast, shape, scratch, part));
    expect_near(evaluate(part, 0.9), evaluate(plan, 0.9));
    expect_near(evaluate(part, 0.9 - 1e-9).jerk, evaluate(part, 0.9).jerk, 1e-5);
    double begin = 0.0;
    for (int i = 1; i < part.count; ++i) {
      begin += part.segments[i - 1].duration;
      const Sample before = evaluate(part, begin - 1e-9);
      const Sample after = evaluate(part, begin + 1e-12);
      expect_near(before.position, after.position, 1e-7);
      expect_near(before.acceleration, after.acceleration, 1e-5);
      expect_near(before.jerk, after.jerk, 1e-3);
    }
    const Sample end = evaluate(part, duration(part) - 1e-10);
    expect_near(end.velocity, kZero, 1e-8);
    expect_near(end.acceleration, kZero, 1e-6);
  }
}

/// The gentlest way is the last one.
TEST(FlightBranch, StopsKeepALimitOfJerk) {
  Stopping scratch;
  Limits limited{{5.0, 5.0, 5.0}, {8.0, 8.0, 8.0}};
  limited.j_max = {30.0, 30.0, 30.0};
  const Trajectory plan = moving_plan();
  Trajectory part{};
  take_first_part(plan, 0.9, part);
  ASSERT_TRUE(append_stop(joint_at(plan, 0.9, plan.origin), limited, kStops - 1, scratch, part));
  for (double t = 0.9; t < duration(part); t += 0.01) {
    const Vec3 jerk = evaluate(part, t).jerk;
    EXPECT_LE(std::max({std::abs(jerk.x), std::abs(jerk.y), std::abs(jerk.z)}), 30.0 * (1.0 + 1e-7)) << t;
  }
  expect_near(evaluate(part, duration(part) - 1e-10).velocity, kZero, 1e-8);
}

/// A plan that is full has no room for the segment that settles the jerk, or for the brake behind it.
TEST(FlightBranch, FullPlansAreNotContinued) {
  Stopping scratch;
  const JointState moving{{kZero, {1.0, 0.0, 0.0}, kZero, {1.0, 0.0, 0.0}}};
  Trajectory plan{};
  plan.count = kMaxSegments;
  EXPECT_FALSE(append_between(moving, moving, 1.0, plan));
  EXPECT_FALSE(append_stop(moving, kFast, 0, scratch, plan));
  EXPECT_EQ(plan.count, kMaxSegments);
  plan.count = kMaxSegments - kBrakeSegments;
  EXPECT_FALSE(append_stop(moving, kFast, 0, scratch, plan));
  plan.count = kMaxSegments - kBrakeSegments - 1;
  EXPECT_TRUE(append_stop(moving, kFast, 0, scratch, plan));
  EXPECT_EQ(plan.count, kMaxSegments);
}

}  // namespace
