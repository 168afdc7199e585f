// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/brake.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/bounds.hpp"
#include "curve/hermite.hpp"
#include "curve/motion_limits.hpp"
#include "curve/rest.hpp"
#include "curve/stopping.hpp"
#include "support/box_corridor.hpp"

namespace {

using namespace tern;
using tern_test::box_around;

constexpr Limits kTwo{{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
constexpr State kFast{{1.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};

double seconds(const Brake& brake) {
  return brake.duration[0] + brake.duration[1] + brake.duration[2];
}

TEST(Brake, GentlestTakesTwiceTheLeastTime) {
  const Brake brake = make_brake(kFast, kTwo, 0);
  EXPECT_DOUBLE_EQ(seconds(brake), 1.0 + kMinDuration + 1.0);
  // The speed falls symmetrically in time: half of it on the mean.
  EXPECT_NEAR(stopping_point(brake).x, 1.0 + 0.5 * 2.0 * seconds(brake), 1e-12);
}

TEST(Brake, SharpestTakesLittleMoreThanTheLeastWay) {
  const Brake brake = make_brake(kFast, kTwo, kBrakeShapes - 1);
  EXPECT_DOUBLE_EQ(brake.duration[0], kMinDuration);
  EXPECT_NEAR(stopping_point(brake).x, 1.0 + 2.0 * 2.0 / (2.0 * 2.0) + 0.5 * 2.0 * kMinDuration, 1e-12);
  EXPECT_NEAR(brake.joint[1].d[2].x, -2.0, 1e-12) << "the whole deceleration";
}

TEST(Brake, UsesWhatTheAxesAllow) {
  // 3 s on x, 1 s on z, where only slowing down counts: the slowest axis sets the time of all.
  const Limits limits{{4.0, 4.0, 4.0}, {9.0, 9.0, 1.0}, {}, {-1.0, 0.0, 0.0}};
  const Brake brake = make_brake(State{{0, 0, 0}, {3.0, 0.0, 1.0}, {0, 0, 0}}, limits, kBrakeShapes - 1);
  EXPECT_NEAR(seconds(brake), 3.0 + kMinDuration, 0.05);
  EXPECT_GE(brake.joint[1].d[2].x, -1.0 - 1e-12);
}

TEST(Brake, IsSmoothAndEndsAtRest) {
  tern_test::Random random(3);
  for (int i = 0; i < tern_test::scaled(300); ++i) {
    const Limits limits = tern_test::random_uneven_limits(random);
    const Vec3 v{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
    const Vec3 a{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
    const Brake brake = make_brake(State{{5, 6, 7}, v, a}, limits, random.integer(0, kBrakeShapes - 1));
    Trajectory plan{};
    for (int part = 0; part < kBrakeSegments; ++part) {
      EXPECT_GE(brake.duration[part], kMinDuration);
      plan.segments[plan.count++] = brake_segment(brake, part, 4);
      EXPECT_EQ(plan.segments[part].polyhedron, 4);
    }
    double at = 0.0;
    for (int part = 0; part + 1 < kBrakeSegments; ++part) {
      at += brake.duration[part];
      const Sample before = evaluate(plan, at * (1.0 - 1e-9));
      const Sample after = evaluate(plan, at * (1.0 + 1e-9));
      EXPECT_NEAR(before.velocity.x, after.velocity.x, 1e-6);
      EXPECT_NEAR(before.acceleration.y, after.acceleration.y, 1e-5);
      EXPECT_NEAR(before.jerk.z, 0.0, 1e-3);
      EXPECT_NEAR(after.jerk.z, 0.0, 1e-3);
    }
    const Sample first = evaluate(plan, 0.0);
    EXPECT_NEAR(first.velocity.z, v.z, 1e-9);
    EXPECT_NEAR(first.acceleration.x, a.x, 1e-7);
    for (int k = 1; k < kJointOrder; ++k) EXPECT_EQ(dot(brake.joint[kBrakeSegments].d[k], {1, 1, 1}), 0.0);
  }
}

TEST(FindBrake, TakesTheGentlestThatFits) {
  // Ramps of 1, 1/2 and 1/4 s stop within 2.05, 1.5 and 1.25 m.
  const double room[] = {2.1, 2.0, 1.4};
  const double ramp[] = {1.0, 0.5, 0.25};
  for (int i = 0; i < 3; ++i) {
    Brake brake;
    ASSERT_TRUE(find_brake(kFast, box_around({1.0, 0, 0}, {1.0 + room[i] - 0.1, 0, 0}, 0.1), kTwo, brake)) << i;
    EXPECT_DOUBLE_EQ(brake.duration[0], ramp[i]);
  }
}

TEST(FindBrake, KeepsLimitsThatAnAccelerationPushesAgainst) {
  // 0.1 m/s below the limit and still speeding up: only a short ramp is in time.
  const State state{{0, 0, 0}, {1.9, 0, 0}, {1.5, 0, 0}};
  const Polyhedron box = box_around({0, 0, 0}, {5, 0, 0}, 0.5);
  Brake brake;
  ASSERT_TRUE(find_brake(state, box, kTwo, brake));
  EXPECT_LT(brake.duration[0], 0.5);
  for (int part = 0; part < kBrakeSegments; ++part) {
    const Segment segment = brake_segment(brake, part, 0);
    EXPECT_TRUE(inside(segment, box));
    EXPECT_TRUE(within_limits(segment, kTwo));
  }
}

TEST(FindBrake, RefusesWhatCannotStop) {
  Brake brake;
  EXPECT_FALSE(find_brake(kFast, box_around({1, 0, 0}, {1.9, 0, 0}, 0.1), kTwo, brake)) << "1 m at full deceleration";
  const State beyond{{1, 0, 0}, {2.0, 0, 0}, {0.5, 0, 0}};
  EXPECT_FALSE(find_brake(beyond, box_around({0, 0, 0}, {9, 0, 0}, 1.0), kTwo, brake)) << "past the speed limit";
}

TEST(Rest, IsNoVelocityNoAccelerationAndNoJerk) {
  EXPECT_TRUE(at_rest({{1.0, 2.0, 3.0}, {}, {}, {}}));
  EXPECT_FALSE(at_rest({{}, {0.0, 1e-9, 0.0}, {}, {}}));
  EXPECT_FALSE(at_rest({{}, {}, {0.0, 0.0, 1e-9}, {}}));
  EXPECT_FALSE(at_rest({{}, {}, {}, {1e-9, 0.0, 0.0}}));
}

// A state without a velocity counts as one that climbs: it brakes downwards, and turns to a side that is level.
TEST(Stopping, TurnsAboutTheVerticalWithoutAVelocity) {
  const State still{{0, 0, 5}, {0, 0, 0}, {0.5, 0, 0}};
  const int first_turn = kBrakeShapes + kAxisBrakes;  // all of the limit to a side, 0.7 of it against the motion
  Stopping stopping;
  ASSERT_TRUE(make_stopping(still, kTwo, first_turn, stopping));
  Trajectory plan{};
  for (int i = 0; i < stopping.count; ++i) plan.segments[plan.count++] = stopping.segments[i];
  const Sample turning = evaluate(plan, stopping.segments[0].duration + 0.5 * stopping.segments[1].duration);
  EXPECT_NEAR(turning.acceleration.z, -1.4, 1e-6);
  EXPECT_NEAR(std::hypot(turning.acceleration.x, turning.acceleration.y), 2.0, 1e-6);
  const Sample end = evaluate(plan, duration(plan));
  EXPECT_NEAR(dot(end.velocity, end.velocity), 0.0, 1e-18);
}

// Of all limits on jerk, one axis' alone counts, too.
TEST(WithinLimits, TakesTheJerkOfEachAxis) {
  for (int a = 0; a < 3; ++a) {
    Segment segment{};
    segment.duration = 1.0;
    for (int k = kJointOrder; k <= kDegree; ++k) axis(segment.points[k], a) = 1.0;
    Limits limits{{9.0, 9.0, 9.0}, {99.0, 99.0, 99.0}};
    // From rest to rest over 1 m in 1 s the jerk is 52.5 m/s^3 half-way.
    for (const double j : {52.4, 52.6}) {
      axis(limits.j_max, a) = j;
      EXPECT_EQ(within_limits(segment, limits), j > 52.5) << a;
      Limits other = limits;
      other.j_max = {0.0, 0.0, 0.0};
      axis(other.j_max, (a + 1) % 3) = j;
      EXPECT_TRUE(within_limits(segment, other)) << a;
    }
  }
}

}  // namespace
