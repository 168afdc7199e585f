// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans made by hand: a good one passes, and each way of spoiling it is found and named.
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
  EXPECT_EQ(stage_.next, 2) << "joints";
}

TEST_F(CheckTest, SlicesReachTheSameAnswer) {
  constexpr std::uint32_t kMost = 1000000;
  tern::Work all{kMost};
  tern::check_begin(stage_);
  ASSERT_EQ(tern::check_advance(stage_, grid_, *corridor_, *trajectory_, query_, all), tern::Progress::kDone);
  tern::check_begin(stage_);
  tern::Operations spent = 0;
  int slices = 0;
  tern::Progress progress = tern::Progress::kMore;
  for (; progress == tern::Progress::kMore; ++slices) {
    tern::Work one_piece = tern::Work{1}.within(1);
    progress = tern::check_advance(stage_, grid_, *corridor_, *trajectory_, query_, one_piece);
    spent += 1 - one_piece.operations();
  }
  EXPECT_EQ(progress, tern::Progress::kDone);
  EXPECT_EQ(spent, tern::kUnit * kMost - all.operations());
  EXPECT_GE(slices, 9) << "position, velocity and acceleration of two segments, the end, and two joints";
}

/// Past the edge of the wall by 1.5 nm less than the radius: the check grants 2 nm. No corridor, no ends, no limits.
TEST_F(CheckTest, RoomOfACurveThatNoCorridorWasMadeFor) {
  const auto has_room = [&](double spare) {
    tern::check_begin(stage_);
    tern::Work work{tern::kCheckBound};
    return room_advance(stage_, grid_, *trajectory_, nullptr, spare, work) == tern::Progress::kDone;
  };
  trajectory_->count = 1;
  trajectory_->segments[0] = straight({0.5, 1.2 - 1.5e-9, 1.0}, {3.0, 1.2 - 1.5e-9, 1.0}, 0.1, tern::kNoPolyhedron);
  EXPECT_TRUE(has_room(0.0));
  EXPECT_FALSE(has_room(1e-9));
  EXPECT_EQ(stage_.status, Status::kCheckFailed);
  EXPECT_EQ(stage_.found.finding, Finding::kObstacle);
  trajectory_->segments[0] = straight({0.5, 1.2, 1.0}, {3.0, 1.2, 1.0}, 0.1, tern::kNoPolyhedron);
  EXPECT_TRUE(has_room(1e-9));
  const double beyond = 2.0 + tern::face_grant(grid_, 2.0) - 0.5e-9;
  trajectory_->segments[0] = straight({0.5, beyond, 1.0}, {3.0, beyond, 1.0}, 0.1, tern::kNoPolyhedron);
  EXPECT_TRUE(has_room(0.0));
  EXPECT_FALSE(has_room(1e-9));
  EXPECT_EQ(stage_.found.finding, Finding::kOutside);
}

/// Past the edge of the wall, y = 1, whose x is 2.0 to 2.1.
TEST_F(CheckTest, CurveWithinTheRadius) {
  const auto fly_at = [&](double y) {
    trajectory_->segments[0] = straight({0.5, y, 1.0}, {3.0, y, 1.0}, 4.0, 0);
    trajectory_->segments[1] = straight({3.0, y, 1.0}, {3.0, 0.5, 1.0}, 2.0, 1);
    query_.start.position.y = y;
  };
  fly_at(1.19);
  const tern::ProofReport& found = expect(Finding::kObstacle, 0);
  EXPECT_EQ(found.voxel.x, 20);
  EXPECT_EQ(found.voxel.y, 9);
  EXPECT_GT(found.excess, 0.0);
  EXPECT_LE(found.excess, 0.01);
  EXPECT_GT(found.until, 1.0);
  EXPECT_LT(found.until, 3.0);
  for (const double y : {1.2, 1.2 - 0.99 * grant().near}) {
    fly_at(y);
    EXPECT_EQ(run(), Status::kOk) << y;
  }
  fly_at(1.2 - 1.01 * grant().near);
  expect(Finding::kObstacle, 0);
}

TEST_F(CheckTest, EveryVoxelCounts) {
  for (const tern::Voxel voxel : {tern::Voxel{5, 16, 10}, tern::Voxel{30, 15, 8}, tern::Voxel{20, 13, 10}}) {
    ASSERT_EQ(grid_.mark_voxel(voxel), Status::kOk);
    EXPECT_TRUE(same(expect(Finding::kObstacle, 0).voxel, voxel));
    ASSERT_EQ(grid_.clear_voxel(voxel), Status::kOk);
    EXPECT_EQ(run(), Status::kOk);
  }
}

TEST_F(CheckTest, CurveOutsideTheBoundary) {
  query_.limits.a_max = {100.0, 100.0, 100.0};
  trajectory_->segments[1] = straight({3.0, 1.5, 1.0}, {3.0, -0.25, 1.0}, 2.0, 1);
  query_.goal.position.y = -0.25;
  EXPECT_EQ(expect(Finding::kOutside, 1).axis, 1);
  EXPECT_NEAR(stage_.found.excess, 0.25, 2e-9);
  trajectory_->segments[1] = straight({3.0, 1.5, 1.0}, {3.0, 0.5, 2.125}, 2.0, 1);
  query_.goal.position = {3.0, 0.5, 2.125};
  EXPECT_EQ(expect(Finding::kOutside, 1).axis, 2);
  EXPECT_NEAR(stage_.found.excess, 0.125, 2e-9);
}

TEST_F(CheckTest, BoundaryGrantsANanometre) {
  const double beyond = tern::face_grant(grid_, 2.0);
  for (const double part : {0.99, 1.01}) {
    const Vec3 at{0.5, 2.0 + part * beyond, 1.0};
    trajectory_->count = 1;
    trajectory_->segments[0] = straight(at, at, 4.0, 0);
    query_.start.position = query_.goal.position = at;
    EXPECT_EQ(run(), part < 1.0 ? Status::kOk : Status::kCheckFailed);
  }
  EXPECT_EQ(stage_.found.finding, Finding::kOutside);
}

/// They only tell which planes to try: with none, with those of another segment and with numbers that are none, the
/// answer is the same.
TEST_F(CheckTest, PolyhedraNeedNoTrust) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const tern::Halfspace bad[] = {{{kNan, 1.0, 0.0}, 2.0}, {{0.6, kNan, 0.0}, 2.0},    {{0.6, 0.0, kNan}, kNan},
                                 {{kInf, 1.0, 0.0}, 2.0}, {{1e200, 1e200, 0.0}, 0.0}, {{1e-200, 1e-200, 0.0}, 0.0},
                                 {{0.6, -0.4, 0.0}, 0.0}, {{0.6, -0.8, 0.0}, -100.0}};
  const auto expect_same = [&](const char* what) {
    EXPECT_EQ(run(), Status::kOk) << what;
    ASSERT_EQ(grid_.mark_voxel({20, 13, 10}), Status::kOk);
    EXPECT_TRUE(same(expect(Finding::kObstacle, 0).voxel, {20, 13, 10})) << what;
    ASSERT_EQ(grid_.clear_voxel({20, 13, 10}), Status::kOk);
  };
  expect_same("good ones");
  for (const int index : {1, 2, -1, tern::kMaxSegments, 1 << 30}) {
    trajectory_->segments[0].polyhedron = index;
    expect_same("another polyhedron, or none");
  }
  trajectory_->segments[0].polyhedron = 0;
  for (const tern::Halfspace& plane : bad) {
    corridor_->polyhedra[0].planes[2] = corridor_->polyhedra[0].planes[5] = plane;
    expect_same("bad numbers");
  }
  for (const int count : {0, -1, tern::kMaxPlanes + 1}) {
    corridor_->polyhedra[0].count = count;
    expect_same("no count of half-spaces");
  }
  corridor_->polyhedra[0].count = 6;
  for (const int count : {0, -1}) {
    corridor_->count = count;
    expect_same("no polyhedra");
  }
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
  }
}

// From rest to rest over L metres in T seconds with control points 4 + 4 the peaks are 35/16 L/T and
// 84 sqrt(5)/25 L/T^2 (the roots of the third derivative are 1/2 +- sqrt(5)/10).
TEST_F(CheckTest, VelocityLimitIsExact) {
  query_.limits.a_max = {100.0, 100.0, 100.0};
  query_.limits.v_max.x = 35.0 / 16.0 * 2.5 / 4.0;
  EXPECT_EQ(run(), Status::kOk);
  query_.limits.v_max.x *= 1.0 - 1e-6;
  const tern::ProofReport& found = expect(Finding::kVelocity, 0);
  EXPECT_EQ(found.derivative, 1);
  EXPECT_EQ(found.axis, 0);
  EXPECT_NEAR(found.excess, (1e-6 - tern::kCheckRelative) * query_.limits.v_max.x, 1e-10);
}

TEST_F(CheckTest, AccelerationLimitIsExact) {
  query_.limits.v_max = {100.0, 100.0, 100.0};
  query_.limits.a_max.y = 84.0 * 2.2360679774997896 / 25.0 * 1.0 / 4.0;
  EXPECT_EQ(run(), Status::kOk);
  query_.limits.a_max.y *= 1.0 - 1e-6;
  const tern::ProofReport& found = expect(Finding::kAcceleration, 1);
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
  EXPECT_EQ(stage_.found.axis, 0);
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
  EXPECT_NEAR(stage_.found.excess, (1e-6 - tern::kCheckRelative) * query_.limits.v_horizontal, 1e-10);
  query_.limits.v_horizontal = 0.0;
  query_.limits.a_horizontal = 1e-3;
  expect(Finding::kAcceleration, 0);
}

TEST_F(CheckTest, Joints) {
  trajectory_->segments[1].points[0].x += 1e-5;
  EXPECT_EQ(expect(Finding::kJoint, 1).derivative, 0);
  EXPECT_NEAR(stage_.found.excess, 1e-5, 5e-9);
  trajectory_->segments[1].points[0].x = 3.0 + 1e-12;
  EXPECT_EQ(expect(Finding::kJoint, 1).derivative, 0) << "positions have the same bits";
  EXPECT_EQ(stage_.found.axis, 0);
  EXPECT_NEAR(stage_.found.excess, 1e-12, 1e-15);
  trajectory_->segments[1].points[0].x = 3.0;
  trajectory_->segments[1].points[3].z += 1e-4;  // a jump of jerk alone, 7 6 5 / 2^3 times as large
  EXPECT_EQ(expect(Finding::kJoint, 1).derivative, 3);
  EXPECT_EQ(stage_.found.axis, 2);
  EXPECT_NEAR(stage_.found.excess, 210.0 / 8.0 * 1e-4, 1e-9);
}

TEST_F(CheckTest, BoundaryStates) {
  query_.start.position.x += 1e-5;
  EXPECT_EQ(expect(Finding::kBoundary, 0).derivative, 0);
  EXPECT_NEAR(stage_.found.excess, 1e-5, 1e-12);
  query_.start.position.x -= 1e-5;
  query_.start.velocity.y = 1e-3;
  EXPECT_EQ(expect(Finding::kBoundary, 0).derivative, 1);
  EXPECT_EQ(stage_.found.axis, 1);
  EXPECT_NEAR(stage_.found.excess, 1e-3, 1e-9);
  query_.start.velocity.y = 0.0;
  query_.goal.acceleration.z = 1e-3;
  EXPECT_EQ(expect(Finding::kBoundary, 1).derivative, 2);
  EXPECT_EQ(stage_.found.axis, 2);
}

}  // namespace
}  // namespace tern_test
