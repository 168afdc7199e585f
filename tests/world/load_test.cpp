// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geofences on their way into the world: gaps between segments and hulls, corners, refusals, the search's voxels.

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "base/math.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"
#include "world/fences.hpp"
#include "world/loaded_fences.hpp"
#include "world/solid_layer.hpp"
#include "world/world.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::Fence;
using tern::FenceKind;
using tern::Halfspace;
using tern::Status;
using tern::Vec3;

std::vector<Vec3> corners_of_box(const Box& b) {
  std::vector<Vec3> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back({k & 1 ? b.upper.x : b.lower.x, k & 2 ? b.upper.y : b.lower.y, k & 4 ? b.upper.z : b.lower.z});
  }
  return corners;
}

TEST(FenceGap, AgreesWithBoxesAtRandom) {
  Random random(11);
  for (int i = 0; i < scaled(20000); ++i) {
    const Vec3 a{random.real(-2.0, 3.0), random.real(-2.0, 3.0), random.real(-2.0, 3.0)};
    const Vec3 b{random.real(-2.0, 3.0), random.real(-2.0, 3.0), random.real(-2.0, 3.0)};
    const Vec3 to = random.chance(0.2) ? a : b;
    const Box box{{0.0, 0.0, 0.0}, {random.real(0.0, 1.0), random.real(0.0, 1.0), random.chance(0.3) ? 0.0 : 1.0}};
    const std::vector<Vec3> corners = corners_of_box(box);
    const tern::HullGap gap = segment_hull_gap(a, to, {corners.data(), 8});
    ASSERT_NEAR(gap.distance, segment_cube_distance(a, to, box), 1e-8) << "case " << i;
    if (gap.distance < 1e-6) continue;
    ASSERT_NEAR(norm3(gap.normal), 1.0, 1e-12);
    const double between = cube_support(gap.normal, box) - std::max(dot3(gap.normal, a), dot3(gap.normal, to));
    ASSERT_NEAR(between, gap.distance, 1e-9);
  }
}

TEST_F(FencesTest, AHalfSpaceIsCutToTheSurroundings) {
  ASSERT_EQ(load_one(FenceKind::kKeepOut, {{{-2.0, 0.0, 0.0}, -6.0}}), Status::kOk);  // x >= 3, normal of length 2
  ASSERT_EQ(solids_->solid_count, 1);
  EXPECT_EQ(solids_->parts[0].corners, 8);
  EXPECT_TRUE(is_clear({1.0, 1.0, 1.0}, {2.8, 1.0, 1.0}, 0.2));
  EXPECT_FALSE(is_clear({1.0, 1.0, 1.0}, {2.81, 1.0, 1.0}, 0.2));
}

TEST_F(FencesTest, FarKeepOutsKeepNothingOut) {
  ASSERT_EQ(load_one(FenceKind::kKeepOut, {{{-1.0, 0.0, 0.0}, -9.0}}), Status::kOk);
  EXPECT_EQ(solids_->solid_count, 0);
}

TEST_F(FencesTest, AFlatKeepOutStillCounts) {
  ASSERT_EQ(load_one(FenceKind::kKeepOut, {{{1.0, 0.0, 0.0}, 2.0}, {{-1.0, 0.0, 0.0}, -2.0}}), Status::kOk);
  ASSERT_EQ(solids_->solid_count, 1);
  EXPECT_FALSE(is_clear({1.0, 1.0, 1.0}, {3.0, 1.0, 1.0}, 0.0));
  EXPECT_TRUE(is_clear({1.0, 1.0, 1.0}, {1.5, 1.0, 1.0}, 0.2));
}

TEST_F(FencesTest, KeepInsAreClosed) {
  ASSERT_EQ(load_one(FenceKind::kKeepIn, {{{1.0, 0.0, 0.0}, 2.0}}), Status::kOk);
  EXPECT_TRUE(is_clear({1.0, 1.0, 1.0}, {2.0, 1.0, 1.0}, 0.2));
  EXPECT_FALSE(is_clear({1.0, 1.0, 1.0}, {2.0001, 1.0, 1.0}, 0.2));
}

TEST_F(FencesTest, AKeepInCutsKeepOutsShortAsABoundaryDoes) {
  const Halfspace all{{1.0, 0.0, 0.0}, 10.0};  // holds the whole map
  const Fence out{&all, 1, FenceKind::kKeepOut};
  const Box room{{1.0, 1.5, 0.5}, {2.0, 1.5, 0.55}};
  Halfspace planes[tern::kBoxPlanes];
  box_planes(room, planes);
  planes[5] = {{0.0, 1e-16, -3.0}, -1.5};  // of any length, and across an axis but for rounding
  const Fence in{planes, 6, FenceKind::kKeepIn};
  const Halfspace beyond{{0.0, -1.0, 0.0}, 1e300};
  const Fence map{&beyond, 1, FenceKind::kKeepIn};
  for (const std::vector<Fence>& list : {std::vector<Fence>{out, map, in}, std::vector<Fence>{in, out}}) {
    ASSERT_EQ(load(list), Status::kOk);
    ASSERT_EQ(solids_->solid_count, 1);
    EXPECT_EQ(solids_->parts[0].corners, 8);
    const tern::Hull hull = solid().hull;
    for (int a = 0; a < 3; ++a) {
      Vec3 up{};
      tern::axis(up, a) = 1.0;
      EXPECT_NEAR(hull_support(up, hull), tern::axis(room.lower, a) - 0.2, 1e-12);
      EXPECT_NEAR(hull_reach(up, hull), tern::axis(room.upper, a) + 0.2, 1e-12);
    }
  }
}

TEST_F(FencesTest, AKeepInOfOnePointLosesNoKeepOutAboutIt) {
  const MarkedWorld world({40, 40, 20}, 0.1, 0.0);
  const Vec3 point{1.0, 1.5, 0.5};
  Halfspace planes[tern::kBoxPlanes];
  box_planes({point, point}, planes);
  for (const double face : {1.0, 1.2}) {
    const Halfspace half{{1.0, 0.0, 0.0}, face};
    const Fence list[] = {{planes, 6, FenceKind::kKeepIn}, {&half, 1, FenceKind::kKeepOut}};
    ASSERT_EQ(load_fences(world.grid, list, 2, *solids_).status, Status::kOk);
    ASSERT_EQ(solids_->solid_count, 1);
    EXPECT_EQ(is_clear(point, point, 0.0), face < 1.1) << "it may touch";
  }
}

/// They miss each other by less than the map's size lets count, however small a keep-in is.
TEST_F(FencesTest, AFlatKeepOutStillCountsInASmallKeepIn) {
  const Halfspace plate[] = {{{1.0, 0.0, 0.0}, 1.0}, {{-1.0, 0.0, 0.0}, -1.0 - 2e-13}};
  const Halfspace small[] = {{{1.0, 0.0, 0.0}, 1.01},  {{-1.0, 0.0, 0.0}, -0.99}, {{0.0, 1.0, 0.0}, 1.01},
                             {{0.0, -1.0, 0.0}, -1.0}, {{0.0, 0.0, 1.0}, 1.01},   {{0.0, 0.0, -1.0}, -1.0}};
  const MarkedWorld world({40, 40, 20}, 0.1, 0.0);
  const Fence list[] = {{plate, 2, FenceKind::kKeepOut}, {small, 6, FenceKind::kKeepIn}};
  ASSERT_EQ(load_fences(world.grid, list, 2, *solids_).status, Status::kOk);
  EXPECT_EQ(solids_->solid_count, 1);
}

TEST_F(FencesTest, HalfSpacesFarBeyondTheMapHoldAllOrNothing) {
  for (const double far : {50.0, 1e300}) {
    ASSERT_EQ(load_one(FenceKind::kKeepIn, {{{2.0, 0.0, 0.0}, far}}), Status::kOk);
    EXPECT_TRUE(is_clear({0.1, 1.0, 1.0}, {3.9, 1.0, 1.0}, 0.2));
    ASSERT_EQ(load_one(FenceKind::kKeepIn, {{{2.0, 0.0, 0.0}, -far}}), Status::kOk);
    EXPECT_FALSE(is_clear({0.1, 1.0, 1.0}, {0.1, 1.0, 1.0}, 0.2));
  }
  // 1e308 / 1e-3 is no number.
  EXPECT_EQ(load_one(FenceKind::kKeepIn, {{{1e-3, 0.0, 0.0}, 1e308}}), Status::kNonFiniteInput);
}

TEST_F(FencesTest, RefusesWhatIsNoFence) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Halfspace good{{1.0, 0.0, 0.0}, 2.0};
  EXPECT_EQ(load_one(FenceKind::kKeepIn, {{{nan, 0.0, 0.0}, 2.0}}), Status::kNonFiniteInput);
  EXPECT_EQ(load_one(FenceKind::kKeepOut, {{{1.0, 0.0, 0.0}, nan}}), Status::kNonFiniteInput);
  EXPECT_EQ(load_one(FenceKind::kKeepIn, {{{0.0, 0.0, 0.0}, 2.0}}), Status::kInvalidArgument);
  EXPECT_EQ(load_one(FenceKind::kKeepIn, {{{1e7, 0.0, 0.0}, 2.0}}), Status::kInvalidArgument);
  EXPECT_EQ(load({{nullptr, 1, FenceKind::kKeepIn}}), Status::kInvalidArgument);
  EXPECT_EQ(load({{&good, 0, FenceKind::kKeepIn}}), Status::kInvalidArgument);
  EXPECT_EQ(load({{&good, 1, static_cast<FenceKind>(7)}}), Status::kInvalidArgument);
  EXPECT_EQ(load_fences(world_.grid, nullptr, 1, *solids_).status, Status::kInvalidArgument);
  EXPECT_EQ(load_fences(world_.grid, nullptr, -1, *solids_).status, Status::kInvalidArgument);
  EXPECT_EQ(load_fences(world_.grid, nullptr, 0, *solids_).status, Status::kOk);
  EXPECT_EQ(load(std::vector<Fence>(tern::kMaxFences + 1, {&good, 1, FenceKind::kKeepIn})), Status::kFencesFull);
  EXPECT_EQ(load_one(FenceKind::kKeepOut, std::vector<Halfspace>(tern::kMaxFencePlanes + 1, good)),
            Status::kFencePlanesFull);
}

TEST_F(FencesTest, TouchingIsAllowedWithoutARadiusToo) {
  Halfspace planes[tern::kBoxPlanes];
  box_planes({{1.0, 1.0, 0.5}, {2.0, 1.5, 1.0}}, planes);
  ASSERT_EQ(load({{planes, 6, FenceKind::kKeepOut}}), Status::kOk);
  EXPECT_TRUE(is_clear({1.0, 1.2, 0.7}, {1.0, 1.2, 0.7}, 0.0)) << "on a face";
  EXPECT_TRUE(is_clear({1.0, 1.0, 0.5}, {1.0, 1.0, 0.5}, 0.0)) << "on a corner";
  EXPECT_TRUE(is_clear({1.0, 0.5, 0.7}, {1.0, 3.0, 0.7}, 0.0)) << "along a face";
  EXPECT_FALSE(is_clear({1.00001, 1.2, 0.7}, {1.00001, 1.2, 0.7}, 0.0));
  EXPECT_FALSE(is_clear({0.5, 1.2, 0.7}, {2.5, 1.2, 0.7}, 0.0));
}

TEST_F(FencesTest, FreeVoxelsAreClearWithAllTheirCorners) {
  Random random(3);
  const auto layer = std::make_unique<tern::SolidLayer>();
  int freed = 0;
  for (int i = 0; i < scaled(120); ++i) {
    const Vec3 center{random.real(0.5, 3.5), random.real(0.5, 3.5), random.real(0.5, 1.5)};
    std::vector<Halfspace> out;
    for (int k = random.integer(4, 8); k > 0; --k) {
      const Vec3 n = random_unit(random);
      out.push_back({n, dot3(n, center) + random.real(0.05, 0.5)});
    }
    const Vec3 n = random.chance(0.3) ? Vec3{0.0, 0.0, 1.0} : random_unit(random);
    const Halfspace in{n, dot3(n, center) + random.real(0.0, 1.0)};
    ASSERT_EQ(
        load({{out.data(), static_cast<std::int32_t>(out.size()), FenceKind::kKeepOut}, {&in, 1, FenceKind::kKeepIn}}),
        Status::kOk);
    world_.grid.inflate();
    tern::Grid view;
    ASSERT_EQ(copy_blocked(world_.grid, *layer, view), Status::kOk);
    tern::Work work;
    for (int z = 0; z < 20; ++z) block_outside(*solids_, *layer, view, z, work);
    for (int k = 0; k < solids_->solid_count; ++k) block(k, *layer, view);
    for (int k = 0; k < 300; ++k) {
      const tern::Voxel v{random.integer(0, 39), random.integer(0, 39), random.integer(0, 19)};
      const Box cube{{v.x * 0.1, v.y * 0.1, v.z * 0.1}, {v.x * 0.1 + 0.1, v.y * 0.1 + 0.1, v.z * 0.1 + 0.1}};
      bool clear = true;
      bool far = true;
      for (const Vec3& p : corners_of_box(cube)) {
        clear = clear && is_clear(p, p, 0.2);
        far = far && is_clear(p, p, 0.4);
      }
      if (view.free(v)) {
        ASSERT_TRUE(clear) << "case " << i;
        ++freed;
      }
      // Not much more than needed is taken where no corner of the fence is sharp: at most everything within twice the
      // radius.
      if (far && i == 0) {
        EXPECT_TRUE(view.free(v));
      }
    }
  }
  EXPECT_GT(freed, scaled(120) * 20);
}

TEST_F(FencesTest, ABoxBlocksWhatItReachesAndNoMore) {
  Halfspace planes[tern::kBoxPlanes];
  box_planes({{1.0, 1.0, 0.5}, {2.0, 1.5, 1.0}}, planes);
  ASSERT_EQ(load({{planes, 6, FenceKind::kKeepOut}}), Status::kOk);
  const auto layer = std::make_unique<tern::SolidLayer>();
  world_.grid.inflate();
  tern::Grid view;
  ASSERT_EQ(copy_blocked(world_.grid, *layer, view), Status::kOk);
  block(0, *layer, view);
  EXPECT_FALSE(view.free({8, 12, 7}));
  EXPECT_TRUE(view.free({7, 12, 7}));  // its upper face is at 0.8, the radius away
  EXPECT_FALSE(view.free({15, 12, 7}));
  EXPECT_TRUE(view.free({22, 12, 7}));
  EXPECT_TRUE(world_.grid.free({15, 12, 7})) << "the caller's grid is as it was";
}

TEST_F(FencesTest, AnEdgeIsRounderThanItsFaces) {
  MarkedWorld world({40, 40, 20}, 0.1, 0.25);
  Halfspace planes[tern::kBoxPlanes];
  box_planes({{1.0, 1.0, 0.5}, {2.0, 1.5, 1.0}}, planes);
  const Fence box{planes, 6, FenceKind::kKeepOut};
  ASSERT_EQ(load_fences(world.grid, &box, 1, *solids_).status, Status::kOk);
  const auto layer = std::make_unique<tern::SolidLayer>();
  world.grid.inflate();
  tern::Grid view;
  ASSERT_EQ(copy_blocked(world.grid, *layer, view), Status::kOk);
  block(0, *layer, view);
  EXPECT_FALSE(view.free({7, 12, 7}));  // 0.2 m from the face
  EXPECT_TRUE(view.free({7, 7, 7}));    // 0.28 m from the edge, 0.2 m from the faces' planes
  EXPECT_FALSE(view.free({8, 8, 7}));   // 0.14 m from the edge
}

}  // namespace
}  // namespace tern_test
