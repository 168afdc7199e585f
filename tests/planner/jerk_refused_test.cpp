// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults of the caller in what a request says about jerk: F01, F11, F12.
#include <gtest/gtest.h>

#include <limits>

#include "support/world.hpp"

namespace {

using tern::Field;
using tern::Status;
using tern_test::open_world;
using tern_test::World;

void expect_refused(World& world, Status status, Field field) {
  EXPECT_EQ(world.plan(), status);
  EXPECT_EQ(world.report.field, field);
  EXPECT_TRUE(world.trajectory_untouched());
}

TEST(JerkFault, NonFiniteNumbersAreNamed) {  // F01
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    World start = open_world();
    start.request.start.jerk.y = bad;
    expect_refused(start, Status::kNonFiniteInput, Field::kStartJerk);
    World goal = open_world();
    goal.request.goal.jerk.z = -bad;
    expect_refused(goal, Status::kNonFiniteInput, Field::kGoalJerk);
    World most = open_world();
    most.request.limits.j_max.x = bad;
    expect_refused(most, Status::kNonFiniteInput, Field::kJMax);
    World norm = open_world();
    norm.request.limits.j_horizontal = bad;
    expect_refused(norm, Status::kNonFiniteInput, Field::kJHorizontal);
  }
}

TEST(JerkFault, InvalidLimits) {  // F11
  for (const double bad : {-1.0, 5e-324, 1e-4, 1.1e6, 1e300}) {
    World most = open_world();
    most.request.limits.j_max.z = bad;
    expect_refused(most, Status::kLimitsInvalid, Field::kJMax);
    World norm = open_world();
    norm.request.limits.j_horizontal = bad;
    expect_refused(norm, Status::kLimitsInvalid, Field::kJHorizontal);
  }
  for (const double good : {0.0, -0.0, tern::kMinLimit, 5.0, tern::kMaxJerk}) {
    World world = open_world();
    world.request.limits.j_max = {good, good, good};
    world.request.limits.j_horizontal = good;
    EXPECT_EQ(world.plan(), Status::kOk) << good;
  }
}

TEST(JerkFault, StatesAboveTheLimits) {  // F12
  World world = open_world();
  world.request.limits.j_max = {5.0, 0.0, 0.0};
  world.request.start.jerk = {5.1, 0.0, 0.0};
  expect_refused(world, Status::kStartExceedsLimits, Field::kStartJerk);
  world.request.start.jerk = {4.0, 9.0, 0.0};
  EXPECT_EQ(world.plan(), Status::kOk);
  World norm = open_world();
  norm.request.limits.j_horizontal = 5.0;
  norm.request.goal.jerk = {4.0, 4.0, 0.0};
  expect_refused(norm, Status::kGoalExceedsLimits, Field::kGoalJerk);
  World huge = open_world();
  huge.request.start.jerk.z = -2.0 * tern::kMaxJerk;
  expect_refused(huge, Status::kStartExceedsLimits, Field::kStartJerk);
}

}  // namespace
