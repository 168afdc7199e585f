// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The limits of the simulated ArduPilot, one at a time and by hand.
#include "host/vehicle/ardupilot_cascade.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host/vehicle/square_root.hpp"
#include "tern/flatness.hpp"

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using tern_host::ardupilot_limited_lean;
using tern_host::GuidedTarget;
using tern_host::Motion;
using tern_host::square_root;

constexpr double kLoop = 0.0025;

/// 2 a second up to 0.625 m, from where the correction can still end at 2.5 m/s^2.
TEST(SquareRoot, IsProportionalNearZeroAndBrakesInTimeBeyond) {
  EXPECT_DOUBLE_EQ(square_root(0.5, 2.0, 2.5, kLoop), 1.0);
  EXPECT_DOUBLE_EQ(square_root(-0.625, 2.0, 2.5, kLoop), -1.25);
  EXPECT_DOUBLE_EQ(square_root(2.0, 2.0, 2.5, kLoop), std::sqrt(2.0 * 2.5 * (2.0 - 0.3125)));
  EXPECT_DOUBLE_EQ(square_root(1e-3, 2000.0, 1e9, kLoop), 0.4);
  for (const double error : {0.1, 0.625, 3.0}) {
    EXPECT_NEAR(tern_host::square_root_error(square_root(error, 2.0, 2.5, kLoop), 2.0, 2.5), error, 1e-12);
  }
  EXPECT_LT((square_root(Vector2d(0.3, 0.4), 2.0, 2.5, kLoop) - Vector2d(0.6, 0.8)).norm(), 1e-12);
  EXPECT_EQ(square_root(Vector2d(0.0, 0.0), 2.0, 2.5, kLoop).norm(), 0.0);
}

/// 30 degrees are 5.66 m/s^2.
TEST(ArdupilotCascade, LeansAcrossTheMotionFirst) {
  const double most = tern::kGravity * std::tan(30.0 / 57.295779513082321);
  EXPECT_EQ(ardupilot_limited_lean({3.0, 4.0}, {1.0, 0.0}), Vector2d(3.0, 4.0));
  EXPECT_LT((ardupilot_limited_lean({6.0, 8.0}, {0.0, 0.0}) - most * Vector2d(0.6, 0.8)).norm(), 1e-9);
  EXPECT_LT((ardupilot_limited_lean({10.0, 3.0}, {2.0, 0.0}) - Vector2d(std::sqrt(most * most - 9.0), 3.0)).norm(),
            1e-9);
  EXPECT_LT((ardupilot_limited_lean({-10.0, 9.0}, {2.0, 0.0}) - Vector2d(0.0, most)).norm(), 1e-9);
}

/// Along x; derivatives of the smooth step of degree 7 over `duration`.
tern::Sample step_of_degree_seven(double t, double distance, double duration) {
  const double u = std::min(std::max(t / duration, 0.0), 1.0);
  const double u3 = u * u * u;
  tern::Sample sample{};
  sample.position.x = distance * u3 * u * (35.0 - 84.0 * u + 70.0 * u * u - 20.0 * u3);
  sample.velocity.x = distance / duration * 140.0 * u3 * (1.0 - u) * (1.0 - u) * (1.0 - u);
  sample.acceleration.x = distance / (duration * duration) * 420.0 * u * u * (1.0 - u) * (1.0 - u) * (1.0 - 2.0 * u);
  return sample;
}

/// The largest distance of the target from the motion, with a message at 50 Hz.
double shaping_error(double distance, double duration) {
  GuidedTarget target(Vector3d::Zero(), 10.0);
  double worst = 0.0;
  for (int k = 0; k < 4000; ++k) {
    if (k % 8 == 0) target.take(step_of_degree_seven(kLoop * k, distance, duration));
    target.advance(kLoop, {});
    worst = std::max(worst, std::fabs(target.desired().position.x() -
                                      step_of_degree_seven(kLoop * (k + 1), distance, duration).position.x));
  }
  return worst;
}

/// PSC_JERK_XY is 5 m/s^3. The largest jerk of the step is 52.5 m / s^3 for a metre in a second, of the mean 42.
TEST(GuidedTarget, FollowsWhatKeepsItsJerkLimit) {
  EXPECT_LT(shaping_error(8.0, 5.0), 0.02);
  EXPECT_GT(shaping_error(8.0, 3.0), 0.1);
}

TEST(GuidedTarget, ChangesItsAccelerationByTheJerkLimit) {
  GuidedTarget target(Vector3d::Zero(), 10.0);
  tern::Sample message{};
  message.acceleration = {3.0, 4.0, 0.0};
  target.take(message);
  target.advance(kLoop, {});
  EXPECT_LT((target.desired().acceleration - 5.0 * kLoop * Vector3d(0.6, 0.8, 0.0)).norm(), 1e-12);
}

/// A target far behind its message catches up with WPNAV_SPEED and WPNAV_ACCEL; upright with those of its own.
TEST(GuidedTarget, CorrectsWithinItsSpeeds) {
  GuidedTarget target(Vector3d::Zero(), 4.0);
  tern::Sample message{};
  message.position = {30.0, 40.0, 30.0};
  double fastest = 0.0, climb = 0.0, hardest = 0.0;
  for (int k = 0; k < 12000; ++k) {
    target.take(message);
    target.advance(kLoop, {});
    const Motion& m = target.desired();
    fastest = std::max(fastest, m.velocity.head<2>().norm());
    climb = std::max(climb, m.velocity.z());
    hardest = std::max(hardest, m.acceleration.head<2>().norm());
  }
  EXPECT_NEAR(fastest, 4.0, 0.02);
  EXPECT_NEAR(climb, 2.5, 0.02);
  EXPECT_NEAR(hardest, 2.5, 1e-9);
  EXPECT_LT((target.desired().position - Vector3d(30.0, 40.0, 30.0)).norm(), 0.01);
}

/// Without messages it goes on; a body at its limit holds it.
TEST(GuidedTarget, GoesOnWithTheLastMessageButNotWithoutTheBody) {
  GuidedTarget free(Vector3d::Zero(), 10.0);
  GuidedTarget held(Vector3d::Zero(), 10.0);
  tern::Sample message{};
  message.velocity.x = 2.0;
  tern_host::Lagging lagging;
  lagging.limit = lagging.position = lagging.velocity = Vector3d(1.0, 0.0, 0.0);
  free.take(message);
  held.take(message);
  for (int k = 0; k < 4800; ++k) {
    free.advance(kLoop, {});
    held.advance(kLoop, lagging);
  }
  EXPECT_NEAR(free.desired().position.x(), 24.0, 0.1);
  EXPECT_EQ(held.desired().position.x(), 0.0);
}

}  // namespace
