// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The check against plans made by hand: a good one passes, and each way of spoiling it is found and named.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "check/check_stage.hpp"

namespace {

using tern::Finding;
using tern::Halfspace;
using tern::Segment;
using tern::Status;
using tern::Vec3;

tern::Polyhedron box_polyhedron(const Vec3& lower, const Vec3& upper) {
  tern::Polyhedron polyhedron{};
  polyhedron.count = 6;
  polyhedron.planes[0] = {{1.0, 0.0, 0.0}, upper.x};
  polyhedron.planes[1] = {{-1.0, 0.0, 0.0}, -lower.x};
  polyhedron.planes[2] = {{0.0, 1.0, 0.0}, upper.y};
  polyhedron.planes[3] = {{0.0, -1.0, 0.0}, -lower.y};
  polyhedron.planes[4] = {{0.0, 0.0, 1.0}, upper.z};
  polyhedron.planes[5] = {{0.0, 0.0, -1.0}, -lower.z};
  return polyhedron;
}

/// At rest at both ends: the first four control points at `from`, the last four at `to`.
Segment straight(const Vec3& from, const Vec3& to, double duration, int polyhedron) {
  Segment segment{};
  segment.duration = duration;
  segment.polyhedron = polyhedron;
  for (int i = 0; i < 4; ++i) {
    segment.points[i] = from;
    segment.points[i + 4] = to;
  }
  return segment;
}

/// A 4 x 2 x 2 m grid with a wall of voxels at x in [2.0, 2.1), y < 1; two segments pass it at y = 1.5.
class CheckTest : public testing::Test {
 protected:
  CheckTest()
      : words_(tern::grid_words({40, 20, 20})), corridor_(new tern::Corridor), trajectory_(new tern::Trajectory) {
    tern::GridSpec spec{};
    spec.cell = 0.1;
    spec.dims = {40, 20, 20};
    spec.boundary = {{0.0, 0.0, 0.0}, {4.0, 2.0, 2.0}};
    spec.radius = 0.2;
    EXPECT_EQ(grid_.bind(spec, words_.data(), words_.size()), Status::kOk);
    EXPECT_EQ(grid_.mark_box({{2.0, 0.0, 0.0}, {2.1, 1.0, 2.0}}), Status::kOk);
    grid_.inflate();
    corridor_->count = 2;
    corridor_->polyhedra[0] = box_polyhedron({0.0, 1.2, 0.0}, {4.0, 2.0, 2.0});
    corridor_->polyhedra[1] = box_polyhedron({2.3, 0.0, 0.0}, {4.0, 2.0, 2.0});
    trajectory_->count = 2;
    trajectory_->origin = {0.0, 0.0, 0.0};
    trajectory_->segments[0] = straight({0.5, 1.5, 1.0}, {3.0, 1.5, 1.0}, 4.0, 0);
    trajectory_->segments[1] = straight({3.0, 1.5, 1.0}, {3.0, 0.5, 1.0}, 2.0, 1);
    query_.start.position = {0.5, 1.5, 1.0};
    query_.goal.position = {3.0, 0.5, 1.0};
    query_.limits = {{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}};
  }

  Status run() {
    tern::check_begin(stage_);
    tern::Work work{1000};
    return tern::check_advance(stage_, grid_, *corridor_, *trajectory_, query_, work);
  }

  void expect(Finding finding, int where) {
    EXPECT_EQ(run(), Status::kCheckFailed);
    EXPECT_EQ(stage_.finding, finding);
    EXPECT_EQ(stage_.where, where);
  }

  std::vector<std::uint64_t> words_;
  tern::Grid grid_;
  std::unique_ptr<tern::Corridor> corridor_;
  std::unique_ptr<tern::Trajectory> trajectory_;
  tern::CheckQuery query_{};
  tern::CheckStage stage_{};
};

TEST_F(CheckTest, GoodPlanPasses) {
  EXPECT_EQ(run(), Status::kOk);
  EXPECT_EQ(stage_.units, 4u);
}

TEST_F(CheckTest, SlicesReachTheSameAnswer) {
  tern::check_begin(stage_);
  for (int i = 0; i < 4; ++i) {
    tern::Work one{1};
    EXPECT_EQ(tern::check_advance(stage_, grid_, *corridor_, *trajectory_, query_, one),
              i < 3 ? Status::kRunning : Status::kOk);
  }
}

TEST_F(CheckTest, PolyhedronWithinTheRadiusOfAKeepOut) {
  const auto fences = std::make_unique<tern::AskedFences>();
  tern::Halfspace planes[tern::kBoxPlanes];
  query_.fences = fences.get();
  for (const double from : {2.2, 2.19}) {
    box_planes({{1.0, from, 0.5}, {2.0, 2.5, 1.5}}, planes);
    const tern::Fence fence{planes, 6, tern::FenceKind::kKeepOut};
    ASSERT_TRUE(copy_fences(&fence, 1, *fences));
    if (from > 2.195) {
      EXPECT_EQ(run(), Status::kOk);
    } else {
      expect(Finding::kFence, 0);
    }
  }
}

TEST_F(CheckTest, ObliqueKeepOutBesideAPolyhedron) {
  const auto fences = std::make_unique<tern::AskedFences>();
  query_.fences = fences.get();
  // A prism below the first polyhedron, its tip 0.3 m from it: some half-space of the polyhedron has to cut it off.
  const tern::Halfspace prism[] = {{{1.0, 1.0, 0.0}, 2.4}, {{-1.0, 1.0, 0.0}, 0.4}, {{0.0, -1.0, 0.0}, -0.4}};
  const tern::Fence fence{prism, 3, tern::FenceKind::kKeepOut};
  ASSERT_TRUE(copy_fences(&fence, 1, *fences));
  const bool first = keep_outs_clear(grid_, corridor_->polyhedra[0], *fences, stage_.scratch);
  EXPECT_FALSE(first);  // the tip, (1, 1.4), is inside
  const tern::Halfspace lower[] = {{{1.0, 1.0, 0.0}, 1.99}, {{-1.0, 1.0, 0.0}, 0.0}, {{0.0, -1.0, 0.0}, -0.4}};
  const tern::Fence below{lower, 3, tern::FenceKind::kKeepOut};
  ASSERT_TRUE(copy_fences(&below, 1, *fences));
  EXPECT_TRUE(
      keep_outs_clear(grid_, corridor_->polyhedra[0], *fences, stage_.scratch));  // (0.995, 0.995): 0.205 m away
}

TEST_F(CheckTest, ControlPointOutsideAKeepIn) {
  const auto fences = std::make_unique<tern::AskedFences>();
  query_.fences = fences.get();
  const tern::Halfspace plane{{2.0, 0.0, 0.0}, 5.8};
  const tern::Fence fence{&plane, 1, tern::FenceKind::kKeepIn};
  ASSERT_TRUE(copy_fences(&fence, 1, *fences));
  expect(Finding::kFence, 0);
}

/// Each ends at z = 0.7 at its highest, so that a polyhedron may begin at 0.9.
TEST_F(CheckTest, DegenerateKeepOutsCountAsTheirShape) {
  const double tilt = 1e-13;
  const std::vector<std::vector<Halfspace>> shapes = {
      // a blade: its edge at y = 1, z = 0.7, its sides two millionths of a radian apart
      {{{0.0, 1.0, 1e-6}, 1.0 + 0.7e-6}, {{0.0, -1.0, 1e-6}, -1.0 + 0.7e-6}},
      // a plate at z = 0.7, flat but for rounding
      {{{0.0, tilt, 1.0}, 0.7}, {{0.0, 0.0, -1.0}, -0.7}, {{0.0, -tilt, 1.0}, 0.7}},
      // a half-space twice, of other lengths, and once more a hair further out
      {{{0.0, 0.0, 3.0}, 2.1}, {{0.0, 0.0, 0.1}, 0.07}, {{0.0, tilt, 1.0}, 0.7 + 1e-12}},
      // a needle upwards between three planes that are nearly upright
      {{{1.0, 0.0, 1e-6}, 1.0 + 0.7e-6}, {{-1.0, 1.0, 1e-6}, 0.7e-6}, {{-1.0, -1.0, 1e-6}, -2.0 + 0.7e-6}},
  };
  const auto fences = std::make_unique<tern::AskedFences>();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const tern::Fence fence{shapes[i].data(), static_cast<std::int32_t>(shapes[i].size()), tern::FenceKind::kKeepOut};
    ASSERT_TRUE(copy_fences(&fence, 1, *fences));
    const auto clear_above = [&](double z) {
      return keep_outs_clear(grid_, box_polyhedron({0.0, 0.0, z}, {4.0, 2.0, 2.0}), *fences, stage_.scratch);
    };
    EXPECT_TRUE(clear_above(0.9)) << "shape " << i;
    EXPECT_TRUE(clear_above(0.9 - 0.99 * tern::fence_tolerance(grid_))) << "shape " << i;
    // Rounding their offsets moves the edges of a blade and a needle by 1e-10 m.
    EXPECT_FALSE(clear_above(0.9 - 1.2 * tern::fence_tolerance(grid_))) << "shape " << i;
  }
}

TEST_F(CheckTest, KeepOutsWithoutPointsAreClearOfAll) {
  const auto fences = std::make_unique<tern::AskedFences>();
  const std::vector<std::vector<Halfspace>> shapes = {
      {{{1.0, 0.0, 0.0}, 1.0}, {{-1.0, 0.0, 0.0}, -1.0 - 1e-15}},   // nothing, by a rounding
      {{{1.0, 1e-9, 0.0}, 1.0}, {{-1.0, 1e-9, 0.0}, -1.0 - 1e-8}},  // a blade that begins at y = -5, outside the map
      {{{1.0, 0.0, 0.0}, -1e300}, {{-1.0, 0.0, 0.0}, 1e300}},
      {{{0.0, 0.0, -1.0}, -2.21}},  // further from the boundary than the radius
  };
  for (const std::vector<Halfspace>& shape : shapes) {
    const tern::Fence fence{shape.data(), static_cast<std::int32_t>(shape.size()), tern::FenceKind::kKeepOut};
    ASSERT_TRUE(copy_fences(&fence, 1, *fences));
    EXPECT_TRUE(keep_outs_clear(grid_, corridor_->polyhedra[0], *fences, stage_.scratch));
  }
}

TEST_F(CheckTest, KeepInsHoldToTheToleranceHoweverFarAway) {
  const auto fences = std::make_unique<tern::AskedFences>();
  for (const double away : {0.0, 1e6, 1e12}) {
    // 3 (x - away) + 4 y <= 15: with y = 1.5, x up to 3
    const Halfspace plane{{3.0, 4.0, 0.0}, 15.0 + 3.0 * away};
    const tern::Fence fence{&plane, 1, tern::FenceKind::kKeepIn};
    ASSERT_TRUE(copy_fences(&fence, 1, *fences));
    Segment segment = straight({0.5, 1.5, 1.0}, {3.0 + 1.5e-9, 1.5, 1.0}, 4.0, 0);  // 0.9e-9 m beyond
    EXPECT_TRUE(keep_ins_hold(segment, *fences, {away, 0.0, 0.0})) << away;
    segment = straight({0.5, 1.5, 1.0}, {3.0 + 1.8e-9, 1.5, 1.0}, 4.0, 0);  // 1.08e-9 m beyond
    EXPECT_FALSE(keep_ins_hold(segment, *fences, {away, 0.0, 0.0})) << away;
  }
}

TEST_F(CheckTest, MoreFencesThanFitAreRefused) {
  const auto fences = std::make_unique<tern::AskedFences>();
  const std::vector<Halfspace> planes(tern::kMaxFencePlanes + 1, {{1.0, 0.0, 0.0}, 1.0});
  const tern::Fence large{planes.data(), tern::kMaxFencePlanes + 1, tern::FenceKind::kKeepIn};
  EXPECT_FALSE(copy_fences(&large, 1, *fences));
  const std::vector<tern::Fence> many(tern::kMaxFences + 1, {planes.data(), 1, tern::FenceKind::kKeepIn});
  EXPECT_FALSE(copy_fences(many.data(), tern::kMaxFences + 1, *fences));
  EXPECT_EQ(fences->count, 0);
}

TEST_F(CheckTest, PolyhedronWithinTheRadius) {
  corridor_->polyhedra[0].planes[3].offset = -1.19;  // 0.19 m from the wall's edge
  expect(Finding::kObstacle, 0);
  corridor_->polyhedra[0].planes[3].offset = -1.2;
  EXPECT_EQ(run(), Status::kOk);
}

TEST_F(CheckTest, EveryVoxelCounts) {
  for (const tern::Voxel voxel : {tern::Voxel{0, 19, 0}, tern::Voxel{39, 15, 19}, tern::Voxel{20, 12, 10}}) {
    ASSERT_EQ(grid_.mark_voxel(voxel), Status::kOk);
    expect(Finding::kObstacle, 0);
    ASSERT_EQ(grid_.clear_voxel(voxel), Status::kOk);
    EXPECT_EQ(run(), Status::kOk);
  }
}

TEST_F(CheckTest, ControlPointOutside) {
  trajectory_->segments[0].points[1].y = 1.2 - 1e-6;
  trajectory_->segments[0].points[2].y = 1.2 - 1e-6;
  expect(Finding::kOutside, 0);
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

TEST_F(CheckTest, PolyhedronWithBadNormal) {
  corridor_->polyhedra[1].planes[0].normal.x = 0.5;
  expect(Finding::kObstacle, 1);
}

// From rest to rest over L metres in T seconds with control points 4 + 4 the peaks are 35/16 L/T and
// 84 sqrt(5)/25 L/T^2 (the roots of the third derivative are 1/2 +- sqrt(5)/10).
TEST_F(CheckTest, VelocityLimitIsExact) {
  query_.limits.a_max = {100.0, 100.0, 100.0};
  query_.limits.v_max.x = 35.0 / 16.0 * 2.5 / 4.0;
  EXPECT_EQ(run(), Status::kOk);
  query_.limits.v_max.x *= 1.0 - 1e-6;
  expect(Finding::kVelocity, 0);
}

TEST_F(CheckTest, AccelerationLimitIsExact) {
  query_.limits.v_max = {100.0, 100.0, 100.0};
  query_.limits.a_max.y = 84.0 * 2.2360679774997896 / 25.0 * 1.0 / 4.0;
  EXPECT_EQ(run(), Status::kOk);
  query_.limits.a_max.y *= 1.0 - 1e-6;
  expect(Finding::kAcceleration, 1);
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
  expect(Finding::kVelocity, 0);
  query_.limits.v_horizontal = 0.0;
  query_.limits.a_horizontal = 1e-3;
  expect(Finding::kAcceleration, 0);
}

TEST_F(CheckTest, Joints) {
  trajectory_->segments[1].points[0].x += 1e-5;
  expect(Finding::kJoint, 1);
  trajectory_->segments[1].points[0].x -= 1e-5;
  trajectory_->segments[1].points[3].z += 1e-4;  // a jump of jerk alone
  expect(Finding::kJoint, 1);
}

TEST_F(CheckTest, BoundaryStates) {
  query_.start.position.x += 1e-5;
  expect(Finding::kBoundary, 0);
  query_.start.position.x -= 1e-5;
  query_.start.velocity.y = 1e-3;
  expect(Finding::kBoundary, 0);
  query_.start.velocity.y = 0.0;
  query_.goal.acceleration.z = 1e-3;
  expect(Finding::kBoundary, 1);
}

}  // namespace
