// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Faults of the caller: F01 to F05, F11, F12, F14.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/world.hpp"

namespace {

using tern::Field;
using tern::Status;
using tern::Vec3;
using tern_test::open_world;
using tern_test::World;

TEST(RequestFault, OpenWorldIsPlanned) {
  World world = open_world();
  EXPECT_EQ(world.plan(), Status::kOk);
}

TEST(RequestFault, EveryNonFiniteFieldIsNamed) {  // F01
  struct Case {
    Vec3 tern::State::*member;
    bool at_goal;
    Field field;
  };
  const Case cases[] = {
      {&tern::State::position, false, Field::kStartPosition},
      {&tern::State::velocity, false, Field::kStartVelocity},
      {&tern::State::acceleration, false, Field::kStartAcceleration},
      {&tern::State::position, true, Field::kGoalPosition},
      {&tern::State::velocity, true, Field::kGoalVelocity},
      {&tern::State::acceleration, true, Field::kGoalAcceleration},
  };
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity()};
  for (const Case& c : cases) {
    for (const double value : bad) {
      for (double Vec3::*component : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        World world = open_world();
        tern::State& state = c.at_goal ? world.request.goal : world.request.start;
        (state.*c.member).*component = value;
        EXPECT_EQ(world.plan(), Status::kNonFiniteInput);
        EXPECT_EQ(world.report.field, c.field);
        EXPECT_EQ(world.report.status, Status::kNonFiniteInput);
        EXPECT_TRUE(world.trajectory_untouched());
      }
    }
  }
}

TEST(RequestFault, NonFiniteLimitsAreNamed) {  // F01
  World world = open_world();
  world.request.limits.v_max.y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(world.plan(), Status::kNonFiniteInput);
  EXPECT_EQ(world.report.field, Field::kVMax);
  World other = open_world();
  other.request.limits.a_max.z = std::numeric_limits<double>::infinity();
  EXPECT_EQ(other.plan(), Status::kNonFiniteInput);
  EXPECT_EQ(other.report.field, Field::kAMax);
}

TEST(RequestFault, NonFiniteGridIsNamed) {  // F01
  World world = open_world();
  tern::GridSpec spec = world.spec;
  tern::Grid grid;
  Field field = Field::kNone;
  spec.origin.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(grid.bind(spec, world.words.data(), world.words.size(), &field), Status::kNonFiniteInput);
  EXPECT_EQ(field, Field::kOrigin);
  spec = world.spec;
  spec.cell = std::numeric_limits<double>::infinity();
  EXPECT_EQ(grid.bind(spec, world.words.data(), world.words.size(), &field), Status::kNonFiniteInput);
  EXPECT_EQ(field, Field::kCell);
}

TEST(RequestFault, UnboundOrUninflatedGridIsRefused) {  // F02
  World world = open_world();
  const tern::Grid unbound;
  EXPECT_EQ(world.planner.plan(unbound, world.request, world.trajectory, world.report), Status::kInvalidArgument);
  EXPECT_EQ(world.report.field, Field::kStorage);
  world.grid.inflate();
  world.block({1.0, 1.0, 0.0}, {1.2, 1.2, 1.0});
  EXPECT_EQ(world.replan(), Status::kInvalidArgument);
  EXPECT_EQ(world.report.field, Field::kNotInflated);
  EXPECT_TRUE(world.trajectory_untouched());
}

TEST(RequestFault, OutsideTheMap) {  // F03
  for (const double x : {-0.01, 4.01, -1e9, 1e9, 1e300}) {
    World world = open_world();
    world.request.start.position.x = x;
    EXPECT_EQ(world.plan(), Status::kOutOfMap) << x;
    EXPECT_EQ(world.report.field, Field::kStartPosition);
    World other = open_world();
    other.request.goal.position.z = x;
    EXPECT_EQ(other.plan(), Status::kOutOfMap) << x;
    EXPECT_EQ(other.report.field, Field::kGoalPosition);
    EXPECT_TRUE(other.trajectory_untouched());
  }
}

TEST(RequestFault, FacesOfTheMapAreInside) {  // F03
  World world = open_world();
  world.from({-0.0, 0.0, 0.0}).to({4.0, 4.0, 2.0});
  ASSERT_EQ(world.plan(), Status::kOk);
  const tern::Sample end = tern::evaluate(world.trajectory, tern::duration(world.trajectory));
  EXPECT_DOUBLE_EQ(end.position.x, 4.0);
  EXPECT_DOUBLE_EQ(end.position.z, 2.0);
}

TEST(RequestFault, StartInsideAnObstacle) {  // F04
  World world = open_world();
  world.block({0.3, 0.3, 0.0}, {0.8, 0.8, 2.0});
  EXPECT_EQ(world.plan(), Status::kStartOccupied);
  EXPECT_EQ(world.report.stage, tern::Stage::kSearch);
  EXPECT_TRUE(world.report.raw_occupied);
  ASSERT_TRUE(world.report.has_nearest_free);
  const Vec3& p = world.report.nearest_free;
  EXPECT_TRUE(world.grid.free(world.grid.voxel_of(world.grid.to_local(p))));
  EXPECT_TRUE(world.trajectory_untouched());
}

TEST(RequestFault, StartTooCloseToAnObstacle) {  // F04
  World world = open_world();
  world.block({0.7, 0.0, 0.0}, {0.9, 2.0, 2.0});
  EXPECT_EQ(world.plan(), Status::kStartOccupied);
  EXPECT_FALSE(world.report.raw_occupied);
  EXPECT_TRUE(world.report.has_nearest_free);
}

TEST(RequestFault, GoalOccupied) {  // F05
  World world = open_world();
  world.block({3.4, 3.4, 1.0}, {3.5, 3.5, 1.1});
  EXPECT_EQ(world.plan(), Status::kGoalOccupied);
  EXPECT_TRUE(world.report.raw_occupied);
  World near = open_world();
  near.block({3.6, 3.4, 1.0}, {3.7, 3.5, 1.1});
  EXPECT_EQ(near.plan(), Status::kGoalOccupied);
  EXPECT_FALSE(near.report.raw_occupied);
  EXPECT_TRUE(near.trajectory_untouched());
}

TEST(RequestFault, PointThatKeepsItsDistanceIsServed) {  // C5: the exact point counts, not its voxel
  World world = open_world();
  world.block({0.8, 0.0, 0.0}, {0.9, 2.0, 2.0});  // 0.25 m from the start, 0.2 m from its voxel's far face
  world.from({0.55, 0.55, 1.05});
  EXPECT_EQ(world.plan(), Status::kOk);
  World tight({40, 40, 20}, 0.1, 0.22);
  tight.block({0.8, 0.0, 0.0}, {0.9, 2.0, 2.0}).from({0.55, 0.55, 1.05}).to({3.45, 3.45, 1.05});
  ASSERT_FALSE(tight.grid.inflated());
  EXPECT_EQ(tight.plan(), Status::kOk);
  EXPECT_FALSE(tight.grid.free({5, 5, 10}));
}

TEST(RequestFault, InvalidLimits) {  // F11
  for (const double bad : {0.0, -1.0, 5e-324, 1e-300, 1e300, 1001.0}) {
    World world = open_world();
    world.request.limits.v_max.x = bad;
    EXPECT_EQ(world.plan(), Status::kLimitsInvalid) << bad;
    EXPECT_EQ(world.report.field, Field::kVMax);
    World other = open_world();
    other.request.limits.a_max.z = bad;
    EXPECT_EQ(other.plan(), Status::kLimitsInvalid) << bad;
    EXPECT_EQ(other.report.field, Field::kAMax);
    EXPECT_TRUE(other.trajectory_untouched());
  }
}

TEST(RequestFault, InvalidLowerAndHorizontalLimits) {  // F11
  const struct {
    Field field;
    double& (*limit)(tern::Limits&);
    double sign;
  } limits[] = {{Field::kVMin, [](tern::Limits& l) -> double& { return l.v_min.z; }, -1.0},
                {Field::kAMin, [](tern::Limits& l) -> double& { return l.a_min.y; }, -1.0},
                {Field::kVHorizontal, [](tern::Limits& l) -> double& { return l.v_horizontal; }, 1.0},
                {Field::kAHorizontal, [](tern::Limits& l) -> double& { return l.a_horizontal; }, 1.0}};
  for (const auto& entry : limits) {
    for (const double bad : {-1.0, 5e-324, 1e300, 1001.0}) {
      World world = open_world();
      entry.limit(world.request.limits) = entry.sign * bad;
      EXPECT_EQ(world.plan(), Status::kLimitsInvalid) << bad;
      EXPECT_EQ(world.report.field, entry.field);
      EXPECT_TRUE(world.trajectory_untouched());
    }
    for (const double value : {0.0, -0.0, entry.sign * 1.5}) {
      World world = open_world();
      entry.limit(world.request.limits) = value;
      EXPECT_EQ(world.plan(), Status::kOk) << value;
    }
    World world = open_world();
    entry.limit(world.request.limits) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(world.plan(), Status::kNonFiniteInput);
    EXPECT_EQ(world.report.field, entry.field);
  }
}

TEST(RequestFault, InvalidTimeWeight) {  // F11
  for (const double bad : {0.0, -40.0, 5e-324, 1e300}) {
    World world = open_world();
    world.request.time_weight = bad;
    EXPECT_EQ(world.plan(), Status::kLimitsInvalid) << bad;
    EXPECT_EQ(world.report.field, Field::kTimeWeight);
  }
  for (const double weight : {tern::kMinTimeWeight, tern::kMaxTimeWeight}) {
    World world = open_world();
    world.request.time_weight = weight;
    EXPECT_EQ(world.plan(), Status::kOk) << weight;
  }
  World world = open_world();
  world.request.time_weight = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(world.plan(), Status::kNonFiniteInput);
  EXPECT_EQ(world.report.field, Field::kTimeWeight);
}

TEST(RequestFault, BoundaryStatesBeyondLowerAndHorizontalLimits) {  // F12
  World world = open_world();
  world.request.limits.v_min.z = -0.5;
  world.request.start.velocity.z = -0.6;
  EXPECT_EQ(world.plan(), Status::kStartExceedsLimits);
  EXPECT_EQ(world.report.field, Field::kStartVelocity);
  world.request.start.velocity.z = 0.6;
  EXPECT_EQ(world.plan(), Status::kOk);
  world.request.limits.a_horizontal = 1.0;
  world.request.goal.acceleration = {0.8, 0.8, 0.0};
  EXPECT_EQ(world.plan(), Status::kGoalExceedsLimits);
  EXPECT_EQ(world.report.field, Field::kGoalAcceleration);
}

TEST(RequestFault, LimitsAtTheEndsOfTheirRange) {  // F11
  for (const double limit : {tern::kMinLimit, tern::kMaxLimit}) {
    World world = open_world();
    world.request.limits = {{limit, limit, limit}, {limit, limit, limit}};
    EXPECT_EQ(world.plan(), Status::kOk) << limit;
  }
}

TEST(RequestFault, BoundaryStatesAboveTheLimits) {  // F12
  World world = open_world();
  world.request.start.velocity.y = 2.1;
  EXPECT_EQ(world.plan(), Status::kStartExceedsLimits);
  EXPECT_EQ(world.report.field, Field::kStartVelocity);
  world = open_world();
  world.request.start.acceleration.z = -2.1;
  EXPECT_EQ(world.plan(), Status::kStartExceedsLimits);
  EXPECT_EQ(world.report.field, Field::kStartAcceleration);
  world = open_world();
  world.request.goal.velocity.x = -2.1;
  EXPECT_EQ(world.plan(), Status::kGoalExceedsLimits);
  EXPECT_EQ(world.report.field, Field::kGoalVelocity);
  world = open_world();
  world.request.goal.acceleration.x = 2.1;
  EXPECT_EQ(world.plan(), Status::kGoalExceedsLimits);
  EXPECT_EQ(world.report.field, Field::kGoalAcceleration);
  EXPECT_TRUE(world.trajectory_untouched());
}

TEST(RequestFault, MovingIntoAWallHasNoTrajectory) {
  World world = open_world();
  world.block({0.9, 0.0, 0.0}, {1.0, 4.0, 1.9});  // 0.35 m ahead of a start at 2 m/s: braking takes 1 m
  world.from({0.55, 2.0, 1.05}).to({0.55, 3.0, 1.05});
  world.request.start.velocity = {2.0, 0.0, 0.0};
  EXPECT_EQ(world.plan(), Status::kNoTrajectory);
  EXPECT_EQ(world.report.stage, tern::Stage::kTrajectory);
  EXPECT_NE(world.report.optimiser, Status::kOk);
  EXPECT_TRUE(world.trajectory_untouched());
}

TEST(RequestFault, FarFromTheOrigin) {  // F14: the same shape wherever the map lies
  World here = open_world();
  here.block({1.5, 0.0, 0.0}, {1.7, 2.5, 2.0});
  ASSERT_EQ(here.plan(), Status::kOk);
  for (const double far : {1e6, -1e6, 1e9}) {
    World there({40, 40, 20}, 0.1, 0.2, {far, far, far});
    ASSERT_EQ(there.bind_status, Status::kOk);
    there.block({1.5, 0.0, 0.0}, {1.7, 2.5, 2.0}).from({0.55, 0.55, 1.05}).to({3.45, 3.45, 1.05});
    ASSERT_EQ(there.plan(), Status::kOk) << far;
    // Precision is that of the inputs: a unit in the last place of the coordinate.
    const double ulp = std::fabs(far) * 2.3e-16 + 1e-9;
    const double t = 0.5 * tern::duration(there.trajectory);
    const tern::Sample sample = tern::evaluate(there.trajectory, t);
    EXPECT_GE(sample.position.x, far - ulp);
    EXPECT_LE(sample.position.x, far + 4.0 + ulp);
    if (std::fabs(far) < 1e8) {
      EXPECT_NEAR(tern::duration(there.trajectory), tern::duration(here.trajectory), 1e-3);
    }
  }
}

}  // namespace
