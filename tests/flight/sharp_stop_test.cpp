// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The sharpest brake straight ahead: within its limits, continuous, and no longer than any other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/math.hpp"
#include "flight/branch.hpp"
#include "support/random.hpp"
#include "support/vehicle_limits.hpp"

namespace {

using namespace tern;
using tern_test::Random;

Limits limits_of(double jerk) {
  Limits limits{{5.0, 5.0, 2.0}, {8.0, 8.0, 6.0}};
  limits.v_horizontal = 5.0;
  limits.a_horizontal = 8.0;
  limits.j_max = {jerk, jerk, jerk};
  return limits;
}

Vec3 random_vector(Random& random, double size) {
  return {random.real(-size, size), random.real(-size, size), 0.3 * random.real(-size, size)};
}

double way_to_rest(const Trajectory& brake) {
  return length(brake.segments[brake.count - 1].points[kDegree]);
}

double largest(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

void expect_within(const Trajectory& brake, const Limits& limits) {
  for (double t = 0.0; t < duration(brake); t += 0.002) {
    const Sample s = evaluate(brake, t);
    EXPECT_LE(std::hypot(s.velocity.x, s.velocity.y), limits.v_horizontal * (1.0 + 1e-7)) << t;
    EXPECT_LE(std::hypot(s.acceleration.x, s.acceleration.y), limits.a_horizontal * (1.0 + 1e-7)) << t;
    if (limits.j_max.x > 0.0) {
      EXPECT_LE(largest(s.jerk), limits.j_max.x * (1.0 + 1e-6)) << t;
    }
  }
}

void expect_joined(const Trajectory& brake, const JointState& from) {
  double begin = 0.0;
  for (int i = 0; i < brake.count; begin += brake.segments[i++].duration) {
    const JointState after = joint_at(brake, begin, kZero);
    const JointState before = i == 0 ? from : joint_at(brake, begin - 1e-9, kZero);
    EXPECT_LT(largest(after.d[0] - before.d[0]), 1e-7) << i;
    EXPECT_LT(largest(after.d[1] - before.d[1]), 1e-7) << i;
    EXPECT_LT(largest(after.d[2] - before.d[2]), 1e-5) << i;
    EXPECT_LT(largest(after.d[3] - before.d[3]), 1e-3) << i;
  }
  const JointState end = joint_at(brake, duration(brake), kZero);
  for (int k = 1; k < kJointOrder; ++k) EXPECT_LT(largest(end.d[k]), 1e-6) << k;
}

TEST(FlightSharpStop, IsNoLongerThanAnyOther) {
  Random random(7);
  Stopping scratch;
  for (const double jerk : {0.0, 30.0, 60.0}) {
    const Limits limits = limits_of(jerk);
    int made = 0;
    int shorter = 0;
    for (int k = 0; k < tern_test::scaled(1000); ++k) {
      const JointState from{{kZero, random_vector(random, 4.0), random_vector(random, 5.0),
                             random_vector(random, random.chance(0.2) ? 0.0 : 25.0)}};
      Trajectory sharp{};
      if (!append_sharp_stop(from, limits, sharp)) continue;
      ++made;
      expect_within(sharp, limits);
      expect_joined(sharp, from);
      for (int way = 0; way < kStops; ++way) {
        Trajectory other{};
        if (!append_stop(from, limits, way, scratch, other)) continue;
        EXPECT_LE(way_to_rest(sharp), way_to_rest(other) + 2e-3) << k << " way " << way;
        shorter += way_to_rest(sharp) < way_to_rest(other) - 0.01 ? 1 : 0;
      }
      if (HasFailure()) return;
    }
    EXPECT_GT(made, tern_test::scaled(1000) / 2) << jerk;
    EXPECT_GT(shorter, tern_test::scaled(1000) / 2) << jerk;
  }
}

/// Ramps of 1.5 * 8 / 30 and 1.2 * 8 / 30 seconds, each with what is left of 4 m/s at 8 m/s^2 between them.
TEST(FlightSharpStop, FlatRampsAreShorter) {
  const JointState from{{kZero, {4.0, 0.0, 0.0}, kZero, kZero}};
  Trajectory sharp{};
  ASSERT_TRUE(append_sharp_stop(from, limits_of(30.0), sharp));
  EXPECT_NEAR(duration(sharp), 0.9, 1e-4);
  EXPECT_NEAR(way_to_rest(sharp), 4.0 * 0.9 / 2.0, 1e-3);
  Trajectory flat{};
  ASSERT_TRUE(append_flat_stop(from, limits_of(30.0), flat));
  EXPECT_NEAR(duration(flat), 0.82, 1e-4);
  EXPECT_NEAR(way_to_rest(flat), 4.0 * 0.82 / 2.0, 1e-3);
}

TEST(FlightSharpStop, FlatRampsKeepTheLimits) {
  Random random(9);
  const Limits limits = limits_of(30.0);
  int made = 0;
  for (int k = 0; k < tern_test::scaled(1000); ++k) {
    const JointState from{{kZero, random_vector(random, 4.0), random_vector(random, 5.0), random_vector(random, 25.0)}};
    Trajectory sharp{};
    Trajectory flat{};
    if (!append_flat_stop(from, limits, flat)) continue;
    ++made;
    expect_within(flat, limits);
    expect_joined(flat, from);
    if (append_sharp_stop(from, limits, sharp)) {
      EXPECT_LE(duration(flat), duration(sharp) + 0.02) << k;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(made, tern_test::scaled(1000) / 2);
}

TEST(FlightSharpStop, KeepsTheVehiclesLimits) {
  Random random(8);
  int made = 0;
  const int cases = tern_test::scaled(400);
  for (int k = 0; k < cases; ++k) {
    const Limits limits = tern_test::random_vehicle(random);
    const JointState from{{kZero, random_vector(random, 0.5 * limits.v_max.x), random_vector(random, 1.0), kZero}};
    if (tern_test::vehicle_use(limits, from.d[2], from.d[3]) > 1.0) continue;
    Trajectory brake{};
    if (!append_sharp_stop(from, limits, brake)) continue;
    ++made;
    for (double t = 0.0; t < duration(brake); t += 0.005) {
      const Sample s = evaluate(brake, t);
      ASSERT_LE(tern_test::vehicle_use(limits, s.acceleration, s.jerk), 1.0 + 1e-6) << k << " at " << t;
    }
    expect_joined(brake, from);
  }
  EXPECT_GT(made, cases / 3);
}

/// At its limit of speed, which still rises while the jerk falls: 0.05 s would exceed it.
TEST(FlightSharpStop, DoesNotWaitAtTheLimitOfSpeed) {
  const JointState from{{kZero, {4.99, 0.0, 0.0}, {0.4, 0.0, 0.0}, {-2.0, 0.0, 0.0}}};
  Trajectory brake{};
  ASSERT_TRUE(append_sharp_stop(from, limits_of(0.0), brake));
  ASSERT_EQ(brake.count, 4);
  EXPECT_LT(brake.segments[0].duration, 0.05);
  EXPECT_DOUBLE_EQ(brake.segments[1].duration, kMinDuration);
  expect_within(brake, limits_of(0.0));
  EXPECT_LT(way_to_rest(brake), 4.99 * 4.99 / 16.0 + 4.99 * 0.08);
}

/// Slow: a ramp and another one take all the speed, and there is no hold.
TEST(FlightSharpStop, NeedsNoHoldWhereItIsSlow) {
  Trajectory brake{};
  ASSERT_TRUE(append_sharp_stop({{kZero, {0.5, 0.0, 0.0}, kZero, kZero}}, limits_of(30.0), brake));
  EXPECT_EQ(brake.count, 2);
  expect_within(brake, limits_of(30.0));
}

TEST(FlightSharpStop, FullPlansAreNotContinued) {
  const JointState moving{{kZero, {1.0, 0.0, 0.0}, kZero, {1.0, 0.0, 0.0}}};
  Trajectory plan{};
  for (const int free : {0, 1, 2, 3}) {
    plan.count = kMaxSegments - free;
    EXPECT_FALSE(append_sharp_stop(moving, limits_of(0.0), plan));
    EXPECT_EQ(plan.count, kMaxSegments - free);
  }
  plan.count = kMaxSegments - 4;
  EXPECT_TRUE(append_sharp_stop(moving, limits_of(0.0), plan));
}

/// Beyond its limit of acceleration, there is no brake that keeps it.
TEST(FlightSharpStop, StatesBeyondTheLimitsHaveNone) {
  Trajectory brake{};
  EXPECT_FALSE(append_sharp_stop({{kZero, {3.0, 0.0, 0.0}, {9.0, 0.0, 0.0}, kZero}}, limits_of(0.0), brake));
  EXPECT_EQ(brake.count, 0);
}

}  // namespace
