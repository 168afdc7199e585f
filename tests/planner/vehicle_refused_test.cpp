// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults of the caller in the vehicle's own limits: F01, F11, F12.
#include <gtest/gtest.h>

#include <limits>

#include "support/world.hpp"
#include "tern/flatness.hpp"

namespace {

using tern::Field;
using tern::kGravity;
using tern::Limits;
using tern::Status;
using tern_test::open_world;
using tern_test::World;

struct Named {
  double Limits::*limit;
  Field field;
};
constexpr Named kAll[] = {{&Limits::thrust_max, Field::kThrustMax},
                          {&Limits::thrust_min, Field::kThrustMin},
                          {&Limits::tilt_tangent, Field::kTiltTangent},
                          {&Limits::rate_max, Field::kRateMax}};

void expect_refused(World& world, Status status, Field field) {
  EXPECT_EQ(world.plan(), status);
  EXPECT_EQ(world.report.field, field);
  EXPECT_TRUE(world.trajectory_untouched());
}

TEST(VehicleFault, NonFiniteNumbersAreNamed) {  // F01
  for (const Named& named : kAll) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      World world = open_world();
      world.request.limits.*named.limit = bad;
      expect_refused(world, Status::kNonFiniteInput, named.field);
    }
  }
}

TEST(VehicleFault, InvalidLimits) {  // F11
  const std::initializer_list<std::pair<Named, double>> cases = {
      {kAll[0], -1.0}, {kAll[0], kGravity}, {kAll[0], 1001.0}, {kAll[1], -1.0}, {kAll[1], kGravity}, {kAll[1], 1e-4},
      {kAll[2], -1.0}, {kAll[2], 1e-4},     {kAll[2], 1e4},    {kAll[3], -1.0}, {kAll[3], 1e-4},     {kAll[3], 1e4}};
  for (const auto& [named, bad] : cases) {
    World world = open_world();
    world.request.limits.*named.limit = bad;
    expect_refused(world, Status::kLimitsInvalid, named.field);
  }
  World turning = open_world();
  turning.request.limits.rate_max = 5.0;
  expect_refused(turning, Status::kLimitsInvalid, Field::kThrustMin);  // no rate in free fall
  for (const Named& named : kAll) {
    World world = open_world();
    world.request.limits.thrust_min = 2.0;
    world.request.limits.*named.limit = named.field == Field::kThrustMax ? 1.1 * kGravity : 2.0;
    EXPECT_EQ(world.plan(), Status::kOk);
  }
}

TEST(VehicleFault, StatesBeyondTheLimits) {  // F12
  World world = open_world();
  Limits& limits = world.request.limits;
  limits.a_max = {50.0, 50.0, 50.0};
  limits.thrust_min = 4.0;
  limits.tilt_tangent = 1.0;
  world.request.start.acceleration = {9.9, 0.0, 0.0};
  expect_refused(world, Status::kStartExceedsLimits, Field::kStartAcceleration);
  world.request.start.acceleration = {0.0, 0.0, -6.0};
  expect_refused(world, Status::kStartExceedsLimits, Field::kStartAcceleration);
  limits.thrust_max = 15.0;
  world.request.start.acceleration = {0.0, 0.0, 5.3};
  expect_refused(world, Status::kStartExceedsLimits, Field::kStartAcceleration);
  world.request.start.acceleration = {0.0, 0.0, 0.0};
  limits.rate_max = 3.0;
  world.request.start.jerk = {30.0, 0.0, 0.0};
  expect_refused(world, Status::kStartExceedsLimits, Field::kStartJerk);
  world.request.start.jerk = {0.0, 0.0, 0.0};
  world.request.goal.jerk = {0.0, 30.0, 0.0};
  expect_refused(world, Status::kGoalExceedsLimits, Field::kGoalJerk);
  world.request.goal.jerk = {0.0, 0.0, 0.0};
  EXPECT_EQ(world.plan(), Status::kOk);
}

}  // namespace
