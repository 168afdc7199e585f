// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The check against plans made by hand: a good one passes, and each way of spoiling it is found and named.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/direction.hpp"
#include "support/check_world.hpp"

namespace tern_test {
namespace {

using tern::Finding;
using tern::Segment;
using tern::Status;
using tern::Vec3;

using CheckTest = CheckWorld;

TEST_F(CheckTest, GoodPlanPasses) {
  EXPECT_EQ(run(), Status::kOk);
  EXPECT_EQ(stage_.units, 4u);
}

TEST_F(CheckTest, SlicesReachTheSameAnswer) {
  tern::check_begin(stage_);
  for (int i = 0; i < 4; ++i) {
    tern::Work one{1};
    EXPECT_EQ(tern::check_advance(stage_, grid_, *corridor_, *trajectory_, query_, one),
              i < 3 ? tern::Progress::kMore : tern::Progress::kDone);
  }
}

TEST_F(CheckTest, PolyhedronWithinTheRadius) {
  corridor_->polyhedra[0].planes[3].offset = -1.19;  // 0.19 m from the wall's edge
  const tern::CheckReport& found = expect(Finding::kObstacle, 0);
  EXPECT_TRUE(same(found.voxel, {20, 9, 0}));
  EXPECT_EQ(found.plane, 3);
  EXPECT_NEAR(found.excess, 0.01, 2e-9);
  corridor_->polyhedra[0].planes[3].offset = -1.2;
  EXPECT_EQ(run(), Status::kOk);
}

TEST_F(CheckTest, EveryVoxelCounts) {
  for (const tern::Voxel voxel : {tern::Voxel{0, 19, 0}, tern::Voxel{39, 15, 19}, tern::Voxel{20, 12, 10}}) {
    ASSERT_EQ(grid_.mark_voxel(voxel), Status::kOk);
    EXPECT_TRUE(same(expect(Finding::kObstacle, 0).voxel, voxel));
    ASSERT_EQ(grid_.clear_voxel(voxel), Status::kOk);
    EXPECT_EQ(run(), Status::kOk);
  }
}

TEST_F(CheckTest, ControlPointOutside) {
  trajectory_->segments[0].points[1].y = 1.2 - 1e-6;
  trajectory_->segments[0].points[2].y = 1.2 - 1e-6;
  const tern::CheckReport& found = expect(Finding::kOutside, 0);
  EXPECT_EQ(found.polyhedron, 0);
  EXPECT_EQ(found.plane, 3);
  EXPECT_NEAR(found.excess, 1e-6, 2e-9);
}

TEST_F(CheckTest, ControlPointOutsideTheBoundary) {
  trajectory_->segments[1].points[5].y = -0.25;
  trajectory_->segments[1].points[5].x = 4.125;
  const tern::CheckReport& found = expect(Finding::kOutside, 1);
  EXPECT_EQ(found.polyhedron, -1);
  EXPECT_EQ(found.plane, -1);
  EXPECT_EQ(found.axis, 1);
  EXPECT_NEAR(found.excess, 0.25, 2e-9);
  trajectory_->segments[1].points[5] = {3.0, 0.5, -0.125};
  EXPECT_EQ(expect(Finding::kOutside, 1).axis, 2);
  EXPECT_NEAR(stage_.excess, 0.125, 2e-9);
}

TEST_F(CheckTest, WrongPolyhedron) {
  trajectory_->segments[0].polyhedron = 1;
  expect(Finding::kOutside, 0);
  trajectory_->segments[0].polyhedron = 2;
  expect(Finding::kMalformed, 0);
}

TEST_F(CheckTest, Malformed) {
  trajectory_->segments[1].duration = 0.0;
  expect(Finding::kMalformed, 1);
  trajectory_->segments[1].duration = std::numeric_limits<double>::quiet_NaN();
  expect(Finding::kMalformed, 1);
  trajectory_->segments[1].duration = 2.0;
  trajectory_->segments[1].points[3].x = std::numeric_limits<double>::infinity();
  expect(Finding::kMalformed, 1);
  trajectory_->count = 0;
  expect(Finding::kMalformed, -1);
}

TEST_F(CheckTest, CountsThatAreNone) {
  for (const int count : {0, -1, tern::kMaxSegments + 1}) {
    trajectory_->count = count;
    expect(Finding::kMalformed, -1);
    trajectory_->count = 2;
    corridor_->count = count;
    expect(Finding::kMalformed, -1);
    corridor_->count = 2;
  }
  trajectory_->segments[0].polyhedron = -1;
  expect(Finding::kMalformed, 0);
}

TEST_F(CheckTest, PolyhedraThatAreNone) {
  tern::Polyhedron& polyhedron = corridor_->polyhedra[1];
  for (const int count : {0, -1, tern::kMaxPlanes + 1}) {
    polyhedron.count = count;
    expect(Finding::kMalformed, 1);
  }
  polyhedron.count = 6;
  for (const int redundant : {-1, tern::kMaxPlanes - 5}) {
    polyhedron.redundant = redundant;
    expect(Finding::kMalformed, 1);
  }
  polyhedron.redundant = 0;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const tern::Halfspace good = polyhedron.planes[2];
  const tern::Halfspace bad[] = {
      {{kNan, 1.0, 0.0}, 2.0}, {{0.0, kNan, 0.0}, 2.0}, {{0.0, 1.0, kNan}, 2.0}, {{0.0, 1.0, 0.0}, kNan}};
  for (const tern::Halfspace& plane : bad) {
    polyhedron.planes[2] = plane;
    expect(Finding::kMalformed, 1);
  }
  polyhedron.planes[2] = good;
  EXPECT_EQ(run(), Status::kOk);
}

TEST_F(CheckTest, PolyhedronWithBadNormal) {
  corridor_->polyhedra[1].planes[0].normal.x = 0.5;
  expect(Finding::kMalformed, 1);
}

// From rest to rest over L metres in T seconds with control points 4 + 4 the peaks are 35/16 L/T and
// 84 sqrt(5)/25 L/T^2 (the roots of the third derivative are 1/2 +- sqrt(5)/10).
TEST_F(CheckTest, VelocityLimitIsExact) {
  query_.limits.a_max = {100.0, 100.0, 100.0};
  query_.limits.v_max.x = 35.0 / 16.0 * 2.5 / 4.0;
  EXPECT_EQ(run(), Status::kOk);
  query_.limits.v_max.x *= 1.0 - 1e-6;
  const tern::CheckReport& found = expect(Finding::kVelocity, 0);
  EXPECT_EQ(found.derivative, 1);
  EXPECT_EQ(found.axis, 0);
  EXPECT_NEAR(found.excess, (1e-6 - tern::kCheckRelative) * query_.limits.v_max.x, 1e-10);
}

TEST_F(CheckTest, AccelerationLimitIsExact) {
  query_.limits.v_max = {100.0, 100.0, 100.0};
  query_.limits.a_max.y = 84.0 * 2.2360679774997896 / 25.0 * 1.0 / 4.0;
  EXPECT_EQ(run(), Status::kOk);
  query_.limits.a_max.y *= 1.0 - 1e-6;
  const tern::CheckReport& found = expect(Finding::kAcceleration, 1);
  EXPECT_EQ(found.derivative, 2);
  EXPECT_EQ(found.axis, 1);
  EXPECT_GT(found.excess, 0.0);
  EXPECT_LE(found.excess, 1e-6 * query_.limits.a_max.y);
}

// The peak of the jerk is 105/2 L/T^3, half-way.
TEST_F(CheckTest, JerkLimitIsExact) {
  query_.limits.v_max = {100.0, 100.0, 100.0};
  query_.limits.a_max = {100.0, 100.0, 100.0};
  query_.limits.j_max.x = 52.5 * 2.5 / 64.0;
  EXPECT_EQ(run(), Status::kOk);
  query_.limits.j_max.x *= 1.0 - 1e-6;
  EXPECT_EQ(expect(Finding::kJerk, 0).derivative, 3);
  EXPECT_EQ(stage_.axis, 0);
  query_.limits.j_max.x = 0.0;
  query_.limits.j_horizontal = 1.0;
  EXPECT_EQ(expect(Finding::kJerk, 0).axis, 3);
}

TEST_F(CheckTest, JerkAtTheEndsIsThatWhichWasAsked) {
  query_.start.jerk.y = 1e-3;
  EXPECT_EQ(expect(Finding::kBoundary, 0).derivative, 3);
  query_.start.jerk.y = 0.0;
  query_.goal.jerk.z = -1e-3;
  EXPECT_EQ(expect(Finding::kBoundary, trajectory_->count - 1).axis, 2);
}

// The first segment flies along +x alone, so a limit on -x is met by its braking and by no velocity.
TEST_F(CheckTest, LowerLimitsAreTheirOwn) {
  query_.limits.v_max = {100.0, 100.0, 100.0};
  query_.limits.a_max = {100.0, 100.0, 100.0};
  query_.limits.v_min.x = -1e-3;
  EXPECT_EQ(run(), Status::kOk);
  query_.limits.a_min.x = -84.0 * 2.2360679774997896 / 25.0 * 2.5 / 16.0;
  EXPECT_EQ(run(), Status::kOk);
  query_.limits.a_min.x *= 1.0 - 1e-6;
  expect(Finding::kAcceleration, 0);
}

TEST_F(CheckTest, HorizontalLimitIsOnTheNorm) {
  query_.limits.v_max = {100.0, 100.0, 100.0};
  query_.limits.a_max = {100.0, 100.0, 100.0};
  const Vec3& from = trajectory_->segments[0].points[0];
  const Vec3& to = trajectory_->segments[0].points[7];
  const double way = std::hypot(to.x - from.x, to.y - from.y);
  query_.limits.v_horizontal = 35.0 / 16.0 * way / trajectory_->segments[0].duration;
  EXPECT_EQ(run(), Status::kOk);
  query_.limits.v_horizontal *= 1.0 - 1e-6;
  EXPECT_EQ(expect(Finding::kVelocity, 0).axis, 3);
  EXPECT_NEAR(stage_.excess, (1e-6 - tern::kCheckRelative) * query_.limits.v_horizontal, 1e-10);
  query_.limits.v_horizontal = 0.0;
  query_.limits.a_horizontal = 1e-3;
  expect(Finding::kAcceleration, 0);
}

TEST_F(CheckTest, Joints) {
  trajectory_->segments[1].points[0].x += 1e-5;
  EXPECT_EQ(expect(Finding::kJoint, 1).derivative, 0);
  EXPECT_EQ(stage_.axis, 0);
  EXPECT_NEAR(stage_.excess, 1e-5, 1e-12);
  trajectory_->segments[1].points[0].x -= 1e-5;
  trajectory_->segments[1].points[3].z += 1e-4;  // a jump of jerk alone, 7 6 5 / 2^3 times as large
  EXPECT_EQ(expect(Finding::kJoint, 1).derivative, 3);
  EXPECT_EQ(stage_.axis, 2);
  EXPECT_NEAR(stage_.excess, 210.0 / 8.0 * 1e-4, 1e-9);
}

TEST_F(CheckTest, BoundaryStates) {
  query_.start.position.x += 1e-5;
  EXPECT_EQ(expect(Finding::kBoundary, 0).derivative, 0);
  EXPECT_NEAR(stage_.excess, 1e-5, 1e-12);
  query_.start.position.x -= 1e-5;
  query_.start.velocity.y = 1e-3;
  EXPECT_EQ(expect(Finding::kBoundary, 0).derivative, 1);
  EXPECT_EQ(stage_.axis, 1);
  EXPECT_NEAR(stage_.excess, 1e-3, 1e-9);
  query_.start.velocity.y = 0.0;
  query_.goal.acceleration.z = 1e-3;
  EXPECT_EQ(expect(Finding::kBoundary, 1).derivative, 2);
  EXPECT_EQ(stage_.axis, 2);
}

}  // namespace
}  // namespace tern_test
