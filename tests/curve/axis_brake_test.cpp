// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "curve/axis_brake.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/math.hpp"
#include "support/box_corridor.hpp"

namespace {

using namespace tern;
using tern_test::Random;
using tern_test::scaled;

/// A power of two: holds that are whole quarters of it come out exact.
constexpr double kRamp = 0.0625;

Trajectory flown(const AxisBrake& brake) {
  Trajectory plan{};
  for (int i = 0; i < brake.segments; ++i) {
    Segment& segment = plan.segments[plan.count++];
    segment.duration = brake.duration[i];
    control_points(brake.joint[i], brake.joint[i + 1], segment.duration, segment.points);
  }
  return plan;
}

double stop_of(const AxisBrake& brake, int a) {
  return axis(brake.joint[brake.segments].d[0], a);
}

/// When the axis comes to rest: the first joint from which on nothing but its position is left.
double rest_time(const AxisBrake& brake, int a) {
  double time = 0.0;
  double result = 0.0;
  for (int i = 0; i < brake.segments; ++i) {
    time += brake.duration[i];
    const JointState& before = brake.joint[i];
    const bool moved = axis(before.d[1], a) != 0.0 || axis(before.d[2], a) != 0.0;
    if (moved) result = time;
  }
  return result;
}

/// What one axis should do, from the description alone: acceleration over a ramp, a hold and a ramp back.
struct Profile {
  double from, to, hold;

  Profile(double velocity, double acceleration, double lower, double upper) : from(acceleration) {
    const double excess = velocity + 0.5 * kRamp * acceleration;
    const double needed = std::fabs(excess) / (excess > 0.0 ? -lower : upper) - kRamp;
    hold = std::max(0.0, std::ceil(needed / (0.25 * kRamp)) * 0.25 * kRamp);
    to = -excess / (kRamp + hold);
  }
  static double step(double u) { return u <= 0.0 ? 0.0 : (u >= 1.0 ? 1.0 : u * u * (3.0 - 2.0 * u)); }
  double acceleration(double t) const {
    if (t <= kRamp + hold) return from + (to - from) * step(t / kRamp);
    return to * (1.0 - step((t - kRamp - hold) / kRamp));
  }
};

TEST(AxisBrake, StopsWithinTheWayThatOneAxisTakes) {
  // 2 m/s against 2 m/s^2: the speed falls symmetrically over two ramps and a hold of 1 s - ramp.
  const Limits limits{{9, 9, 9}, {2, 2, 2}};
  const AxisBrake brake = make_axis_brake({{5, 0, 0}, {2, 0, 0}, {0, 0, 0}}, limits, kRamp);
  EXPECT_DOUBLE_EQ(stop_of(brake, 0), 5.0 + 0.5 * 2.0 * 1.0625);
  EXPECT_DOUBLE_EQ(rest_time(brake, 0), 1.0625);
  EXPECT_EQ(stop_of(brake, 1), 0.0);
}

TEST(AxisBrake, UndoesTheAccelerationThatTheStateHas) {
  // 1 m/s and 1 m/s^2 against 2 m/s^2: 1.03125 m/s when the acceleration is undone, 29 quarters of a ramp to hold.
  const AxisBrake brake = make_axis_brake({{0, 0, 0}, {0, 1, 0}, {0, 1, 0}}, tern::Limits{{9, 9, 9}, {2, 2, 2}}, kRamp);
  const double hold = 29 * 0.015625;
  // A ramp's way is time * v + time^2 (0.35 from + 0.15 to).
  const double first = 0.0625 + 0.00390625 * (0.35 - 0.30);
  const double second = hold * 0.96875 - hold * hold;
  const double third = 0.0625 * 0.0625 - 0.00390625 * 0.70;
  EXPECT_NEAR(stop_of(brake, 1), first + second + third, 1e-14);
  EXPECT_NEAR(rest_time(brake, 1), 2.0 * kRamp + hold, 1e-14);
  EXPECT_NEAR(brake.joint[1].d[2].y, -2.0, 1e-14) << "all of the limit";
}

TEST(AxisBrake, EachAxisStopsAtItsOwnTime) {
  // 1 s, 1/4 s and 1/2 s, and a ramp each.
  const Limits limits{{9, 9, 9}, {7, 4, 1}, {}, {-2, 0, -9}};
  const AxisBrake brake = make_axis_brake({{0, 0, 0}, {2, 1, -0.5}, {0, 0, 0}}, limits, kRamp);
  EXPECT_DOUBLE_EQ(rest_time(brake, 0), 1.0625) << "slowing down on x is a_min";
  EXPECT_DOUBLE_EQ(rest_time(brake, 1), 0.3125);
  EXPECT_DOUBLE_EQ(rest_time(brake, 2), 0.5625) << "and on z, which sinks, a_max";
  EXPECT_DOUBLE_EQ(stop_of(brake, 0), 1.0625);
  EXPECT_DOUBLE_EQ(stop_of(brake, 1), 0.15625);
  EXPECT_DOUBLE_EQ(stop_of(brake, 2), -0.140625);
  EXPECT_EQ(brake.segments, 7);
}

TEST(AxisBrake, NeedsNoHoldForALittle) {
  const AxisBrake brake =
      make_axis_brake({{0, 0, 0}, {0.05, 0, 0}, {0, 0, 0}}, tern::Limits{{9, 9, 9}, {4, 4, 4}}, kRamp);
  EXPECT_EQ(brake.segments, 2);
  EXPECT_DOUBLE_EQ(brake.joint[1].d[2].x, -0.8);
  EXPECT_DOUBLE_EQ(stop_of(brake, 0), 0.5 * 0.05 * 0.125);
}

TEST(AxisBrake, StatesAtTheJointsAreTheMotions) {
  Random random(31);
  for (int i = 0; i < scaled(200); ++i) {
    const Limits limits = tern_test::random_uneven_limits(random);
    const auto within = [&](double lower, double upper) { return random.real(lower < 0.0 ? lower : -upper, upper); };
    State state{{1, 2, 3}, {}, {}};
    for (int a = 0; a < 3; ++a) {
      axis(state.velocity, a) = within(axis(limits.v_min, a), axis(limits.v_max, a));
      axis(state.acceleration, a) = within(axis(limits.a_min, a), axis(limits.a_max, a));
    }
    const AxisBrake brake = make_axis_brake(state, limits, kRamp);
    const Trajectory plan = flown(brake);
    for (int a = 0; a < 3; ++a) {
      const double least = axis(limits.a_min, a) < 0.0 ? axis(limits.a_min, a) : -axis(limits.a_max, a);
      const Profile profile(axis(state.velocity, a), axis(state.acceleration, a), least, axis(limits.a_max, a));
      const double end = duration(plan);
      const int steps = 400;
      double velocity = axis(state.velocity, a);
      for (int k = 0; k < steps; ++k) {
        const double t = end * k / steps;
        const Sample sample = evaluate(plan, t);
        ASSERT_NEAR(axis(sample.acceleration, a), profile.acceleration(t), 1e-9) << t;
        ASSERT_LE(axis(sample.acceleration, a), axis(limits.a_max, a) * (1.0 + 1e-9));
        ASSERT_GE(axis(sample.acceleration, a), least * (1.0 + 1e-9));
        ASSERT_NEAR(axis(sample.velocity, a), velocity, 1e-3);
        // Simpson over the step.
        const double h = end / steps;
        velocity +=
            h / 6.0 * (profile.acceleration(t) + 4.0 * profile.acceleration(t + 0.5 * h) + profile.acceleration(t + h));
      }
    }
  }
}

TEST(AxisBrake, IsContinuousToJerkAndEndsAtRest) {
  Random random(32);
  for (int i = 0; i < scaled(200); ++i) {
    const Limits limits = tern_test::random_limits(random);
    const State state{{4, 5, 6},
                      {random.real(-2, 2), random.real(-2, 2), random.real(-2, 2)},
                      {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)}};
    const AxisBrake brake = make_axis_brake(state, limits, kRamp);
    const Trajectory plan = flown(brake);
    ASSERT_LE(brake.segments, kAxisBrakeSegments);
    double at = 0.0;
    for (int part = 0; part + 1 < plan.count; ++part) {
      ASSERT_GE(brake.duration[part], 0.2 * kRamp);
      at += brake.duration[part];
      const double h = 1e-7;
      const Sample before = evaluate(plan, at - h);
      const Sample after = evaluate(plan, at + h);
      for (int a = 0; a < 3; ++a) {
        ASSERT_NEAR(axis(before.position, a), axis(after.position, a), 1e-5);
        ASSERT_NEAR(axis(before.velocity, a), axis(after.velocity, a), 1e-5);
        // Snap is below 6 (5 + 5) / ramp^2 on every piece.
        ASSERT_NEAR(axis(before.acceleration, a), axis(after.acceleration, a), 1e-4);
        ASSERT_NEAR(axis(before.jerk, a), axis(after.jerk, a), 2.0 * h * 60.0 / (kRamp * kRamp));
      }
    }
    for (int a = 0; a < 3; ++a) {
      EXPECT_EQ(axis(brake.joint[0].d[1], a), axis(state.velocity, a));
      EXPECT_EQ(axis(brake.joint[0].d[3], a), 0.0);
      for (int k = 1; k < kJointOrder; ++k) EXPECT_EQ(axis(brake.joint[brake.segments].d[k], a), 0.0);
    }
  }
}

}  // namespace
