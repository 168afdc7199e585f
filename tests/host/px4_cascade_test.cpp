// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The limits of the simulated PX4, one at a time and by hand.
#include "host/vehicle/px4_cascade.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tern/flatness.hpp"

namespace {

using Eigen::Vector3d;
using tern::kGravity;
using tern_host::Believed;
using tern_host::px4_asked_thrust;
using tern_host::px4_limited_thrust;
using tern_host::Px4Cascade;
using tern_host::Setpoint;

void expect_vector(const Vector3d& a, const Vector3d& b) {
  EXPECT_LT((a - b).norm(), 1e-9) << a.transpose() << " and " << b.transpose();
}

TEST(Px4Cascade, TiltsAsIfTheThrustCarriedTheWeightAlone) {
  expect_vector(px4_asked_thrust(Vector3d::Zero()), {0.0, 0.0, kGravity});
  expect_vector(px4_asked_thrust({3.0, 4.0, 0.0}), {3.0, 4.0, kGravity});
  // Half the weight upright gives half of what is wanted sideways, and twice of it twice.
  expect_vector(px4_asked_thrust({3.0, 4.0, -0.5 * kGravity}), {1.5, 2.0, 0.5 * kGravity});
  expect_vector(px4_asked_thrust({3.0, 4.0, kGravity}), {6.0, 8.0, 2.0 * kGravity});
}

TEST(Px4Cascade, TiltsBy45DegreesAndGivesAQuarterOfTheWeight) {
  expect_vector(px4_asked_thrust({30.0, 40.0, 0.0}), {0.6 * kGravity, 0.8 * kGravity, kGravity});
  expect_vector(px4_asked_thrust({0.0, 0.0, -2.0 * kGravity}), {0.0, 0.0, 0.24 * kGravity});
}

/// Twice the weight at most. Upright comes first, but sideways keeps 0.6 of the weight.
TEST(Px4Cascade, LimitsTheThrustUprightFirst) {
  expect_vector(px4_limited_thrust({1.0, -2.0, 12.0}), {1.0, -2.0, 12.0});
  expect_vector(px4_limited_thrust({0.0, 0.0, 3.0 * kGravity}), {0.0, 0.0, 2.0 * kGravity});
  expect_vector(px4_limited_thrust({1.5 * kGravity, 0.0, 1.5 * kGravity}),
                {std::sqrt(1.75) * kGravity, 0.0, 1.5 * kGravity});
  expect_vector(px4_limited_thrust({0.0, kGravity, 3.0 * kGravity}),
                {0.0, 0.6 * kGravity, std::sqrt(4.0 - 0.36) * kGravity});
}

/// A body that hovers, and a setpoint so far along x.
class Px4Hovering {
 public:
  explicit Px4Hovering(double speed_max) : cascade_(0.0, 0.01, speed_max) {}
  /// What the next turn of the position loop accelerates along x with; the thrust carries the weight.
  double accelerates(double away) {
    Setpoint setpoint{};
    setpoint.sample.position.x = away;
    const Believed hovering{Vector3d::Zero(), Vector3d::Zero(), Eigen::Quaterniond::Identity(), Vector3d::Zero()};
    const tern_host::Wrench wrench =
        cascade_.control(hovering, 0.01 * turns_++, 0.001, [&](double) { return setpoint; });
    return std::sqrt(wrench.thrust * wrench.thrust - kGravity * kGravity);
  }

 private:
  Px4Cascade cascade_;
  int turns_ = 0;
};

/// 0.95 m/s for each metre, at most MPC_XY_VEL_MAX; 1.8 m/s^2 for each m/s, and 0.4 m/s^2 more for each second of it.
TEST(Px4Cascade, ClipsTheVelocityAndIntegratesTheRest) {
  Px4Hovering near(2.0);
  EXPECT_NEAR(near.accelerates(1.0), 1.8 * 0.95, 1e-9);
  EXPECT_NEAR(near.accelerates(1.0), 1.8 * 0.95 + 0.4 * 0.95 * 0.01, 1e-9);
  Px4Hovering far(2.0);
  EXPECT_NEAR(far.accelerates(100.0), 1.8 * 2.0, 1e-9);
  EXPECT_NEAR(far.accelerates(100.0), 1.8 * 2.0 + 0.4 * 2.0 * 0.01, 1e-9);
}

/// At 12 m/s, 21.6 m/s^2 are wanted and 9.8 given. The integral is taken back by 2 / 1.8 s of what is missing.
TEST(Px4Cascade, TakesBackTheIntegralWhereTheTiltIsAtItsLimit) {
  Px4Hovering far(12.0);
  EXPECT_NEAR(far.accelerates(100.0), kGravity, 1e-9);
  const double slope = 0.4 * (12.0 - 2.0 / 1.8 * (1.8 * 12.0 - kGravity));
  EXPECT_LT(slope, 0.0);
  EXPECT_NEAR(far.accelerates(0.0), -slope * 0.01, 1e-7);
}

}  // namespace
