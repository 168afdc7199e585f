// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Limits of thrust, tilt and body rates, as the planner measures them, and manoeuvres that keep them.
#include "support/vehicle_limits.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/bounds.hpp"
#include "curve/body_rate.hpp"
#include "curve/motion_limits.hpp"
#include "curve/rest.hpp"
#include "curve/stopping.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::norm_of;
using tern_test::Random;
using tern_test::random_vehicle;
using tern_test::scaled;
using tern_test::vehicle_use;

Vec3 random_vector(Random& random, double size) {
  return {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
}

Segment random_segment(Random& random, double size) {
  Segment segment{};
  segment.duration = random.real(0.5, 2.0);
  for (Vec3& point : segment.points) point = random_vector(random, size);
  return segment;
}

Sample sample_of(const Segment& segment, double t) {
  Trajectory plan{};
  plan.count = 1;
  plan.segments[0] = segment;
  return evaluate(plan, t);
}

TEST(VehicleLimits, GaugeScalesAnAccelerationOntoThem) {
  Random random(11);
  for (int i = 0; i < scaled(2000); ++i) {
    Limits limits = random_vehicle(random);
    limits.rate_max = 0.0;
    if (i % 3 == 1) limits.thrust_max = 0.0;
    if (i % 3 == 2) limits.tilt_tangent = 0.0;
    const Bounds bounds = MotionLimits(limits).acceleration;
    const Vec3 direction = random_vector(random, random.real(0.01, 30.0));
    const Vec3 touching = (1.0 / gauge(bounds, direction)) * direction;
    EXPECT_LE(vehicle_use(limits, touching, kZero), 1.0 + 1e-12) << i;
    const bool is_boxed = norm_of(touching) > 99.0;
    EXPECT_TRUE(is_boxed || vehicle_use(limits, 1.001 * touching, kZero) > 1.0) << i;
    EXPECT_NEAR(gauge(scaled(0.5, bounds), direction), 2.0 * gauge(bounds, direction), 1e-9);
  }
  EXPECT_EQ(gauge(MotionLimits(random_vehicle(random)).acceleration, kZero), 0.0);
}

TEST(VehicleLimits, CornersOfTheInnerBoxKeepThem) {
  Random random(12);
  for (int i = 0; i < scaled(500); ++i) {
    const Limits limits = random_vehicle(random);
    const Bounds box = inner_box(MotionLimits(limits).acceleration);
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 a{corner & 1 ? box.lower.x : box.upper.x, corner & 2 ? box.lower.y : box.upper.y,
                   corner & 4 ? box.lower.z : box.upper.z};
      EXPECT_LE(vehicle_use(limits, a, kZero), 1.0 + 1e-9) << i;
    }
  }
}

TEST(VehicleLimits, PeakRateBoundsSamplesClosely) {
  Random random(13);
  int measured = 0;
  for (int i = 0; i < scaled(300); ++i) {
    const Segment segment = random_segment(random, random.real(0.01, 0.3));
    double sampled = 0.0;
    double least = 1e9;
    for (int k = 0; k <= 1000; ++k) {
      const Sample s = sample_of(segment, std::nextafter(segment.duration * k / 1000, 0.0));
      least = std::fmin(least, norm_of(s.acceleration + Vec3{0.0, 0.0, kGravity}));
      sampled = std::fmax(sampled, body_rate(s.acceleration, s.jerk));
    }
    const double peak = peak_rate(segment, 0.0, 1e-4);
    EXPECT_GE(peak, sampled * (1.0 - 1e-9)) << i;
    if (least < 1.0) continue;
    ++measured;
    EXPECT_LE(peak, sampled * (1.0 + 3e-3)) << i;
    EXPECT_EQ(peak_rate(segment, 2.0 * peak, 0.0), 2.0 * peak);
  }
  EXPECT_GT(measured, scaled(300) / 3);
}

TEST(VehicleLimits, FreeFallHasNoRate) {
  EXPECT_EQ(body_rate({0.0, 0.0, -kGravity}, {1.0, 0.0, 0.0}), HUGE_VAL);
  Segment fall{};
  fall.duration = 1.0;
  for (int k = 0; k <= kDegree; ++k) fall.points[k].z = -kGravity * k * (k - 1) / 84.0;  // z = -g t^2 / 2
  EXPECT_EQ(peak_rate(fall, 0.0, 1e-4), HUGE_VAL);
}

TEST(VehicleLimits, StraightLegsKeepThemInEveryDirection) {
  Random random(14);
  for (int i = 0; i < scaled(1000); ++i) {
    const Limits limits = random_vehicle(random);
    const Vec3 to =
        i % 5 == 0 ? Vec3{0.0, 0.0, random.real(-20.0, 20.0)} : random_vector(random, random.real(0.01, 20));
    const Segment leg = straight_segment(kZero, to, 0, limits);
    double use = 0.0;
    for (int k = 0; k <= 200; ++k) {
      const Sample s = sample_of(leg, leg.duration * k / 200);
      use = std::fmax(use, vehicle_use(limits, s.acceleration, s.jerk));
    }
    EXPECT_LE(use, 1.0 + 1e-9) << i;
    EXPECT_TRUE(within_limits(leg, limits)) << i;
  }
}

/// Some manoeuvre stops nearly every state, and whatever is accepted keeps the limits.
TEST(VehicleLimits, StopsKeepThem) {
  Random random(15);
  int stopped = 0;
  const int cases = scaled(60);
  for (int i = 0; i < cases; ++i) {
    const Limits limits = random_vehicle(random);
    State state{kZero, (0.5 * random.unit()) * limits.v_max, kZero};
    const Vec3 direction = random_vector(random, 1.0);
    state.acceleration = (0.5 / gauge(MotionLimits(limits).acceleration, direction)) * direction;
    state.jerk = random_vector(random, 0.2 * limits.rate_max * kGravity);
    if (vehicle_use(limits, state.acceleration, state.jerk) > 1.0) state.jerk = kZero;
    int accepted = 0;
    for (int choice = 0; choice < kStoppingChoices; ++choice) {
      Stopping stopping;
      if (!make_stopping(state, limits, choice, stopping)) continue;
      ++accepted;
      double use = 0.0;
      for (int part = 0; part < stopping.count; ++part) {
        const double end = stopping.segments[part].duration;
        for (int k = 0; k < 40; ++k) {
          const Sample s = sample_of(stopping.segments[part], end * k / 40);
          use = std::fmax(use, vehicle_use(limits, s.acceleration, s.jerk));
        }
      }
      ASSERT_LE(use, 1.0 + 1e-6) << "state " << i << ", choice " << choice;
    }
    stopped += accepted > 10 ? 1 : 0;
  }
  EXPECT_GE(stopped, cases * 9 / 10);
}

TEST(WithinLimits, TellsTheVehiclesOwnApart) {
  Segment segment = straight_segment(kZero, {4.0, 0.0, 0.0}, 0, Limits{{9, 9, 9}, {99, 99, 99}});
  const double pull = 84.0 * std::sqrt(5.0) / 25.0 * 4.0 / (segment.duration * segment.duration);
  Limits limits{{9, 9, 9}, {99, 99, 99}};
  limits.tilt_tangent = 1.001 * pull / kGravity;
  EXPECT_TRUE(within_limits(segment, limits));
  limits.tilt_tangent = 0.999 * pull / kGravity;
  EXPECT_FALSE(within_limits(segment, limits));
  limits.tilt_tangent = 0.0;
  limits.thrust_max = 1.001 * std::hypot(pull, kGravity);
  EXPECT_TRUE(within_limits(segment, limits));
  limits.thrust_max = 0.999 * std::hypot(pull, kGravity);
  EXPECT_FALSE(within_limits(segment, limits));
  limits.thrust_max = 0.0;
  limits.thrust_min = 1.0;
  const double rate = peak_rate(segment, 0.0, 1e-7);
  limits.rate_max = 1.001 * rate;
  EXPECT_TRUE(within_limits(segment, limits));
  limits.rate_max = 0.999 * rate;
  EXPECT_FALSE(within_limits(segment, limits));
}

}  // namespace
