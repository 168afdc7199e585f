// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/vehicle/vehicle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tern/vec3.hpp"
#include "tern_stacks/stacks.hpp"

namespace {

using tern_host::make_vehicle;
using tern_host::Setpoint;
using tern_host::Setpoints;
using tern_host::VehicleSettings;

double apart(const tern::Vec3& a, const tern::Vec3& b) {
  return std::hypot(a.x - b.x, std::hypot(a.y - b.y, a.z - b.z));
}

VehicleSettings settings_of(const char* kind) {
  VehicleSettings settings;
  settings.kind = kind;
  settings.tracking_margin = 0.1;
  return settings;
}

/// A circle of 3 m at `speed`, smoothly begun, with all derivatives.
Setpoint circle(double t, double speed) {
  constexpr double kRadius = 3.0;
  constexpr double kBegin = 3.0;  // seconds
  // The angle's rate grows from 0 over kBegin as a smooth step; derivatives by hand.
  const double w = speed / kRadius;
  const double u = std::min(1.0, t / kBegin);
  const double phi = t < kBegin ? w * kBegin * (2.5 * u * u * u * u - 3.0 * u * u * u * u * u + u * u * u * u * u * u)
                                : w * (0.5 * kBegin + t - kBegin);
  const double d1 = w * (10.0 * u * u * u - 15.0 * u * u * u * u + 6.0 * u * u * u * u * u);
  const double d2 = w / kBegin * (30.0 * u * u - 60.0 * u * u * u + 30.0 * u * u * u * u);
  const double d3 = w / (kBegin * kBegin) * (60.0 * u - 180.0 * u * u + 120.0 * u * u * u);
  const double c = kRadius * std::cos(phi);
  const double s = kRadius * std::sin(phi);
  tern::Sample sample{};
  sample.position = {c, s, 2.0};
  sample.velocity = {-s * d1, c * d1, 0.0};
  sample.acceleration = {-c * d1 * d1 - s * d2, -s * d1 * d1 + c * d2, 0.0};
  sample.jerk = {s * d1 * d1 * d1 - 3.0 * c * d1 * d2 - s * d3, -c * d1 * d1 * d1 - 3.0 * s * d1 * d2 + c * d3, 0.0};
  return {sample, 0.0, 0.0};
}

/// The largest distance from the command over 15 s.
double largest_error(const VehicleSettings& settings, const Setpoints& setpoints) {
  const auto vehicle = make_vehicle(settings, setpoints(0.0));
  double worst = 0.0;
  for (int k = 1; k <= 1500; ++k) {
    vehicle->fly_to(0.01 * k, setpoints);
    worst = std::max(worst, apart(vehicle->position(), setpoints(0.01 * k).sample.position));
  }
  return worst;
}

double error_on_circle(const VehicleSettings& settings, double speed) {
  return largest_error(settings, [speed](double t) { return circle(t, speed); });
}

TEST(Vehicle, RigidBodiesHoverWhereTheyBegan) {
  const Setpoints still = [](double) {
    tern::Sample sample{};
    sample.position = {1.0, -2.0, 3.0};
    return Setpoint{sample, 0.7, 0.0};
  };
  for (const char* const kind : {"quadrotor", "px4", "ardupilot"}) {
    const auto vehicle = make_vehicle(settings_of(kind), still(0.0));
    vehicle->fly_to(5.0, still);
    EXPECT_LT(apart(vehicle->position(), {1.0, -2.0, 3.0}), 1e-6) << kind;
    EXPECT_LT(apart(vehicle->velocity(), {}), 1e-6) << kind;
  }
}

TEST(Vehicle, PerfectAndBoundedKeepTheirWord) {
  EXPECT_EQ(error_on_circle(settings_of("perfect"), 3.0), 0.0);
  const double bounded = error_on_circle(settings_of("bounded"), 3.0);
  EXPECT_LE(bounded, 0.1);
  EXPECT_GT(bounded, 0.08);
}

/// 3 m/s on 3 m is 3 m/s^2 across: what PX4's feed-forward cascade follows to some decimetres, and feed-forward of
/// attitude and rates to centimetres.
TEST(Vehicle, FeedForwardOfTheFlatStateIsWorthAnOrderOfMagnitude) {
  const double quadrotor = error_on_circle(settings_of("quadrotor"), 3.0);
  const double px4 = error_on_circle(settings_of("px4"), 3.0);
  EXPECT_LT(quadrotor, 0.02);
  EXPECT_GT(px4, 5.0 * quadrotor);
  EXPECT_LT(px4, 0.5);
}

/// PX4 clips the sum of feed-forward and correction at MPC_XY_VEL_MAX. A plan as fast as that leaves nothing for the
/// correction, and drag holds the body back; the share of docs/integration/px4.md leaves enough.
TEST(Vehicle, Px4CatchesUpOnlyBelowItsSpeedLimit) {
  VehicleSettings settings = settings_of("px4");
  settings.air.drag = 0.3;
  const double free = error_on_circle(settings, 2.0);
  settings.stack_speed = 2.0 / tern::kPx4SpeedShare;
  EXPECT_NEAR(error_on_circle(settings, 2.0), free, 0.01);
  settings.stack_speed = 2.0;
  EXPECT_GT(error_on_circle(settings, 2.0), 2.0 * free);
}

/// The correction has priority: a body that is far off flies towards its setpoint, not along with it.
TEST(Vehicle, Px4NeverWantsMoreThanItsSpeedLimit) {
  VehicleSettings settings = settings_of("px4");
  settings.stack_speed = 1.5;
  const Setpoints away = [](double t) {
    tern::Sample sample{};
    sample.position = {0.0, t < 1.0 ? 0.0 : 10.0, 0.0};
    sample.velocity = {t < 1.0 ? 0.0 : 4.0, 0.0, 0.0};
    return Setpoint{sample, 0.0, 0.0};
  };
  const auto vehicle = make_vehicle(settings, away(0.0));
  for (int k = 1; k <= 500; ++k) {
    vehicle->fly_to(0.01 * k, away);
    EXPECT_LT(std::hypot(vehicle->velocity().x, vehicle->velocity().y), 2.0);
  }
  EXPECT_NEAR(vehicle->velocity().y, 1.5, 0.2);
  EXPECT_LT(std::abs(vehicle->velocity().x), 0.2);
}

/// A stack has hovered in its wind before time 0, and its integrators hold against it. Level drag without a limit in
/// the way is then as in calm air.
TEST(Vehicle, StacksHoverInASteadyWindBeforeTheyBegin) {
  const Setpoints still = [](double) {
    tern::Sample sample{};
    sample.position = {1.0, -2.0, 3.0};
    return Setpoint{sample, 0.7, 0.0};
  };
  for (const char* const kind : {"px4", "ardupilot"}) {
    VehicleSettings settings = settings_of(kind);
    const double calm = error_on_circle(settings, 2.0);
    settings.air.wind = 5.0;
    settings.air.has_gusts = true;
    const auto vehicle = make_vehicle(settings, still(0.0));
    EXPECT_LT(apart(vehicle->position(), {1.0, -2.0, 3.0}), 0.02) << kind;
    vehicle->fly_to(5.0, still);
    EXPECT_LT(apart(vehicle->position(), {1.0, -2.0, 3.0}), 0.02) << kind;
    EXPECT_LT(std::hypot(vehicle->attitude()[1], vehicle->attitude()[2]), 0.05) << kind;
    EXPECT_GT(std::hypot(vehicle->attitude()[1], vehicle->attitude()[2]), 0.02) << kind;
    EXPECT_NEAR(error_on_circle(settings, 2.0), calm, 0.15 * calm) << kind;
    settings.air.has_gusts = false;
    EXPECT_GT(error_on_circle(settings, 2.0), 1.2 * calm) << kind;
  }
}

/// An estimate that lags is where the body was; one that drifts takes the body along the other way.
TEST(Vehicle, EstimatesLagAndDriftAsTold) {
  VehicleSettings settings = settings_of("px4");
  settings.pose_lag = 0.05;
  const Setpoints setpoints = [](double t) { return circle(t, 2.0); };
  const auto late = make_vehicle(settings, setpoints(0.0));
  late->fly_to(9.95, setpoints);
  const tern::Vec3 then = late->position();
  late->fly_to(10.0, setpoints);
  EXPECT_LT(apart(late->estimate(), then), 1e-9);
  EXPECT_NEAR(apart(late->position(), then), 0.1, 0.01);
  settings.pose_lag = 0.0;
  settings.pose_drift = 0.05;
  for (const char* const kind : {"perfect", "px4", "ardupilot"}) {
    settings.kind = kind;
    const auto drifting = make_vehicle(settings, setpoints(0.0));
    drifting->fly_to(10.0, setpoints);
    EXPECT_NEAR(apart(drifting->position(), drifting->estimate()), 0.5, 1e-9) << kind;
    EXPECT_LT(apart(drifting->estimate(), setpoints(10.0).sample.position), 0.5) << kind;
  }
}

/// The body cannot follow a step of its heading, and turns for most of a second. Thrust points where the motion needs
/// it all the while: that is all that keeps the body on the circle.
TEST(Vehicle, AHeadingThatLagsDoesNotMoveTheBody) {
  for (const double step : {1.5, 3.0, -2.5}) {
    const Setpoints setpoints = [step](double t) {
      Setpoint setpoint = circle(t, 4.5);
      if (t > 5.0) setpoint.yaw = step;
      return setpoint;
    };
    EXPECT_LT(largest_error(settings_of("quadrotor"), setpoints), 0.05) << "a step of " << step;
  }
}

TEST(Vehicle, WindPushesAndEqualSeedsGiveEqualFlights) {
  VehicleSettings windy = settings_of("quadrotor");
  const double calm = error_on_circle(windy, 2.0);
  windy.air.wind = 5.0;
  const double pushed = error_on_circle(windy, 2.0);
  EXPECT_GT(pushed, calm + 0.01);
  EXPECT_LT(pushed, 0.1);
  EXPECT_EQ(pushed, error_on_circle(windy, 2.0));
  windy.seed = 2;
  EXPECT_NE(pushed, error_on_circle(windy, 2.0));
}

TEST(Vehicle, EstimateIsOffTheTruthByAtMostItsMargin) {
  for (const std::string& kind : tern_host::vehicle_kinds()) {
    VehicleSettings settings = settings_of(kind.c_str());
    settings.pose_margin = 0.05;
    const Setpoints setpoints = [](double t) { return circle(t, 1.0); };
    const auto vehicle = make_vehicle(settings, setpoints(0.0));
    double worst = 0.0;
    for (int k = 1; k <= 1000; ++k) {
      vehicle->fly_to(0.01 * k, setpoints);
      worst = std::max(worst, apart(vehicle->position(), vehicle->estimate()));
    }
    EXPECT_LE(worst, 0.05 + 1e-12) << kind;
    EXPECT_GT(worst, 0.04) << kind;
  }
}

/// The controller sees what is estimated: a body that began at the setpoint itself would begin with a step.
TEST(Vehicle, BeginsWhereItBelievesToBeAtTheSetpoint) {
  const Setpoints still = [](double) {
    tern::Sample sample{};
    sample.position = {1.0, -2.0, 3.0};
    return Setpoint{sample, 0.7, 0.0};
  };
  for (const char* const kind : {"quadrotor", "px4", "ardupilot"}) {
    VehicleSettings settings = settings_of(kind);
    settings.pose_margin = 0.5;
    const auto vehicle = make_vehicle(settings, still(0.0));
    EXPECT_LT(apart(vehicle->estimate(), {1.0, -2.0, 3.0}), 1e-9) << kind;
    EXPECT_GT(apart(vehicle->position(), {1.0, -2.0, 3.0}), 0.1) << kind;
    double worst = 0.0;
    for (int k = 1; k <= 10; ++k) {
      vehicle->fly_to(0.01 * k, still);
      worst = std::max(worst, apart(vehicle->estimate(), {1.0, -2.0, 3.0}));
    }
    EXPECT_LT(worst, 0.02) << kind;
  }
}

/// How far the estimate is off, at most, and how far it jumps.
TEST(Vehicle, EstimatesJumpAsTold) {
  for (const double margin : {0.0, 0.2, 0.3}) {
    VehicleSettings settings = settings_of("perfect");
    settings.pose_margin = margin;
    settings.pose_jumps = {0.2, 0.5};
    const Setpoints still = [](double) { return Setpoint{}; };
    const auto vehicle = make_vehicle(settings, still(0.0));
    double worst = 0.0;
    int jumps = 0;
    tern::Vec3 before = vehicle->position();
    for (int k = 1; k <= 1000; ++k) {
      vehicle->fly_to(0.01 * k, still);
      worst = std::max(worst, apart(vehicle->position(), vehicle->estimate()));
      const double moved = apart(vehicle->position(), before);
      if (moved < 0.05) {
        EXPECT_LT(moved, 0.01) << margin;
      } else {
        ++jumps;
        EXPECT_NEAR(moved, 0.2, 0.01) << margin;
        EXPECT_EQ(k % 50, 0) << margin;
      }
      before = vehicle->position();
    }
    EXPECT_EQ(jumps, 20);
    EXPECT_LE(worst, (margin < 0.2 ? 0.2 : margin) + 1e-12);
    EXPECT_GT(worst, 0.8 * (margin < 0.2 ? 0.2 : margin));
  }
}

TEST(Vehicle, UnknownKindsAreRefused) {
  EXPECT_THROW(make_vehicle(settings_of("balloon"), Setpoint{}), std::runtime_error);
}

}  // namespace
