// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults of the caller in one axis of a limit alone, or in one number of a via: F01, F11.
#include <gtest/gtest.h>

#include "support/numbers.hpp"
#include "support/world.hpp"

namespace {

using tern::Field;
using tern::Limits;
using tern::Status;
using tern::Vec3;
using tern_test::kInfinity;
using tern_test::kNan;
using tern_test::open_world;
using tern_test::World;

TEST(AxesFault, EachAxisOfALimitCounts) {  // F11
  const struct {
    Vec3 Limits::*limit;
    Field field;
    double bad;
  } limits[] = {{&Limits::v_max, Field::kVMax, 0.5 * tern::kMinLimit},
                {&Limits::a_max, Field::kAMax, 1.1 * tern::kMaxLimit},
                {&Limits::v_min, Field::kVMin, -1.1 * tern::kMaxLimit},
                {&Limits::a_min, Field::kAMin, 1.0},
                {&Limits::j_max, Field::kJMax, 0.5 * tern::kMinLimit},
                {&Limits::j_max, Field::kJMax, 1.1 * tern::kMaxJerk},
                {&Limits::j_max, Field::kJMax, -1.0}};
  World world = open_world();
  const Limits good = world.request.limits;
  for (const auto& entry : limits) {
    for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      world.request.limits = good;
      world.request.limits.*entry.limit.*axis = entry.bad;
      EXPECT_EQ(world.plan(), Status::kLimitsInvalid) << entry.bad;
      EXPECT_EQ(world.report.field, entry.field);
      EXPECT_TRUE(world.trajectory_untouched());
    }
  }
}

class ViaNumbers : public ::testing::Test {
 protected:
  ViaNumbers() {
    via_.position = {2.05, 1.05, 1.05};
    world_.request.vias = &via_;
    world_.request.via_count = 1;
  }
  void expect_not_finite() {
    EXPECT_EQ(world_.plan(), Status::kNonFiniteInput);
    EXPECT_EQ(world_.report.field, Field::kVias);
    EXPECT_EQ(world_.report.via, 0);
    EXPECT_TRUE(world_.trajectory_untouched());
  }

  World world_ = open_world();
  tern::Via via_;
};

TEST_F(ViaNumbers, ATolerance) {  // F01
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    via_.tolerance = bad;
    expect_not_finite();
  }
}

TEST_F(ViaNumbers, AVelocityWhereItIsRead) {  // F01
  for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    via_.velocity = {0.5, 0.5, 0.0};
    via_.velocity.*axis = kNan;
    via_.has_velocity = true;
    expect_not_finite();
    via_.has_velocity = false;
    EXPECT_EQ(world_.plan(), Status::kOk);
  }
  via_.has_velocity = true;
  via_.velocity = {0.5, 0.5, 0.0};
  EXPECT_EQ(world_.plan(), Status::kOk);
}

}  // namespace
