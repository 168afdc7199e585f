// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Braking along a plan's own path.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "base/math.hpp"
#include "flight/branch.hpp"
#include "tern/proof.hpp"

namespace {

using namespace tern;

const MotionLimits kLimits{Limits{{5.0, 5.0, 5.0}, {8.0, 8.0, 8.0}}};

/// Three segments with a bend, and a jump of snap at each joint.
Trajectory bent_plan() {
  Trajectory plan{};
  plan.origin = {100.0, -20.0, 3.0};
  const JointState a{{{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, {0.5, 1.0, 0.0}, {2.0, 6.0, 1.0}}};
  const JointState b{{{3.1, 0.8, 0.1}, {3.6, 2.0, 0.2}, {-1.0, 3.0, 0.0}, {-5.0, 1.0, -2.0}}};
  const JointState c{{{5.7, 5.2, 0.2}, {1.0, 4.6, 0.0}, {-2.5, 0.0, 0.0}, {0.0, -8.0, 0.0}}};
  const JointState d{{{6.0, 8.5, 0.2}, kZero, kZero, kZero}};
  EXPECT_TRUE(append_between(a, b, 0.8, plan));
  EXPECT_TRUE(append_between(b, c, 1.1, plan));
  EXPECT_TRUE(append_between(c, d, 1.6, plan));
  return plan;
}

/// 1 - (10 u^3 - 15 u^4 + 6 u^5), and its integral from 0 by Simpson's rule.
double pace(double u) {
  return 1.0 - u * u * u * (10.0 + u * (-15.0 + 6.0 * u));
}
double passed(double u) {
  constexpr int kParts = 2000;
  double sum = pace(0.0) + pace(u);
  for (int i = 1; i < kParts; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * pace(u * i / kParts);
  return sum * u / (3.0 * kParts);
}

double largest(const Vec3& a, const Vec3& b) {
  return std::fmax(std::abs(a.x - b.x), std::fmax(std::abs(a.y - b.y), std::abs(a.z - b.z)));
}

TEST(FlightSlowDown, StaysOnThePath) {
  const Trajectory plan = bent_plan();
  for (const double from : {0.0, 0.3, 0.79, 0.799, 0.8, 1.7, 2.5, 3.4}) {
    for (const double time : {0.3, 0.7, 1.0, 1.5}) {
      SCOPED_TRACE(std::to_string(from) + " for " + std::to_string(time));
      Trajectory slow{};
      slow.origin = evaluate(plan, from).position;
      ASSERT_TRUE(append_slow_down(plan, from, time, slow));
      ASSERT_NEAR(duration(slow), time, 1e-12);
      for (int k = 0; k <= 40; ++k) {
        const Vec3 expected = evaluate(plan, from + time * passed(k / 40.0)).position;
        EXPECT_LT(largest(evaluate(slow, time * k / 40.0).position, expected), kProofTolerance) << k;
      }
    }
  }
}

/// Where a joint of the plan comes right before the end, the last segment but one ends there. The plan's time passes by
/// half of the slow-down's; 0.03 of it before its end, 2.5 * 0.03^4 of it is left.
TEST(FlightSlowDown, EndsAtAJointThatComesRightBeforeTheEnd) {
  const Trajectory plan = bent_plan();
  const double time = 0.8 / (0.5 - 2.5 * 0.03 * 0.03 * 0.03 * 0.03);
  Trajectory slow{};
  slow.origin = plan.origin;
  ASSERT_TRUE(append_slow_down(plan, 0.0, time, slow));
  ASSERT_NEAR(duration(slow), time, 1e-12);
  EXPECT_NEAR(slow.segments[slow.count - 1].duration, 0.03 * time, 0.001 * time);
  EXPECT_LT(largest(evaluate(slow, 0.97 * time).position, evaluate(plan, 0.8).position), 1e-6);
  EXPECT_LT(largest(evaluate(slow, time).position, evaluate(plan, 0.5 * time).position), 1e-12);
  for (int k = 0; k <= 40; ++k) {
    const Vec3 expected = evaluate(plan, time * passed(k / 40.0)).position;
    EXPECT_LT(largest(evaluate(slow, time * k / 40.0).position, expected), kProofTolerance) << k;
  }
}

TEST(FlightSlowDown, BeginsInThePlansStateAndEndsAtRest) {
  const Trajectory plan = bent_plan();
  const Sample begin = evaluate(plan, 1.3);
  Trajectory slow{};
  slow.origin = begin.position;
  ASSERT_TRUE(append_slow_down(plan, 1.3, 1.5, slow));
  const Sample first = evaluate(slow, 0.0);
  EXPECT_LT(largest(first.position, begin.position), 1e-12);
  EXPECT_LT(largest(first.velocity, begin.velocity), 1e-11);
  EXPECT_LT(largest(first.acceleration, begin.acceleration), 1e-9);
  EXPECT_LT(largest(first.jerk, begin.jerk), 1e-7);
  double end = 0.0;
  for (int i = 0; i < slow.count; ++i) {
    end += slow.segments[i].duration;
    const Sample before = evaluate(slow, end - 1e-9);
    const Sample after = evaluate(slow, end);
    EXPECT_LT(largest(before.velocity, after.velocity), 1e-6) << i;
    EXPECT_LT(largest(before.acceleration, after.acceleration), 1e-5) << i;
    EXPECT_LT(largest(before.jerk, after.jerk), 1e-3) << i;
  }
}

/// 4 m/s along x at 8 m/s^2: 1.875 * 4 / 8 seconds, half of them at 4 m/s.
TEST(FlightSlowDown, SharpestBrakesAtTheLimit) {
  const double time = slow_down_time({4.0, 0.0, 0.0}, kLimits, 0);
  EXPECT_DOUBLE_EQ(time, 0.9375);
  EXPECT_DOUBLE_EQ(slow_down_time({4.0, 0.0, 0.0}, kLimits, 2), 0.9375 * 1.69);
  Trajectory straight{};
  const JointState a{{kZero, {4.0, 0.0, 0.0}, kZero, kZero}};
  const JointState b{{{8.0, 0.0, 0.0}, {4.0, 0.0, 0.0}, kZero, kZero}};
  ASSERT_TRUE(append_between(a, b, 2.0, straight));
  Trajectory slow{};
  ASSERT_TRUE(append_slow_down(straight, 0.0, time, slow));
  double most = 0.0;
  for (int k = 0; k < 1000; ++k) most = std::fmax(most, -evaluate(slow, time * k / 1000.0).acceleration.x);
  EXPECT_NEAR(most, 8.0, 1e-3);
  EXPECT_NEAR(evaluate(slow, time).position.x, 4.0 * 0.5 * time, 1e-12);
}

/// 0.6 m/s along x at 40 m/s^3: the root of 10 / 3^0.5 * 0.6 / 40 seconds. At 8 m/s^2 alone, it would be the least
/// time.
TEST(FlightSlowDown, SharpestKeepsTheLimitOfJerk) {
  Limits limits{{5.0, 5.0, 5.0}, {8.0, 8.0, 8.0}};
  EXPECT_DOUBLE_EQ(slow_down_time({0.6, 0.0, 0.0}, MotionLimits(limits), 0), 0.2);
  limits.j_max = {40.0, 40.0, 40.0};
  const double time = slow_down_time({0.6, 0.0, 0.0}, MotionLimits(limits), 0);
  EXPECT_DOUBLE_EQ(time, std::sqrt(10.0 / std::sqrt(3.0) * 0.6 / 40.0));
  Trajectory straight{};
  const JointState a{{kZero, {0.6, 0.0, 0.0}, kZero, kZero}};
  const JointState b{{{1.2, 0.0, 0.0}, {0.6, 0.0, 0.0}, kZero, kZero}};
  ASSERT_TRUE(append_between(a, b, 2.0, straight));
  Trajectory slow{};
  ASSERT_TRUE(append_slow_down(straight, 0.0, time, slow));
  double most = 0.0;
  for (int k = 0; k < 1000; ++k) most = std::fmax(most, std::fabs(evaluate(slow, time * k / 1000.0).jerk.x));
  EXPECT_NEAR(most, 40.0, 0.5);
}

TEST(FlightSlowDown, RefusesWhatHasNoRoom) {
  Trajectory full{};
  full.count = kMaxSegments - 8;
  EXPECT_FALSE(append_slow_down(bent_plan(), 0.0, 1.0, full));
  EXPECT_LE(full.count, kMaxSegments);
}

}  // namespace
