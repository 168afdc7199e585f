// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geofences on their way into the world: gaps between segments and hulls, corners, refusals, the search's voxels.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "base/math.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"
#include "world/fences.hpp"
#include "world/solid_layer.hpp"
#include "world/world.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::Fence;
using tern::FenceKind;
using tern::Halfspace;
using tern::Solids;
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

class FencesTest : public ::testing::Test {
 protected:
  /// The first solid.
  tern::ConvexSolid solid() const { return solid_of(*solids_, solids_->parts[0]); }
  /// All planes of a solid.
  void block(int k, tern::SolidLayer& layer, const tern::Grid& view) {
    tern::Work work;
    prepare_solid(solid_of(*solids_, solids_->parts[k]), layer, view, work);
    for (int z = 0; z < view.spec().dims.z; ++z) block_solid(layer, view, z, work);
  }
  /// Of a grid with this radius: 0, 0.2 or 0.4.
  bool is_clear(const Vec3& from, const Vec3& to, double radius) const {
    const MarkedWorld& marked = radius > 0.3 ? wide_ : radius > 0.1 ? world_ : bare_;
    return tern::World(marked.grid, *solids_).solids_clear(from, to);
  }
  Status load(const std::vector<Fence>& list) {
    return load_fences(world_.grid, list.data(), static_cast<std::int32_t>(list.size()), *solids_).status;
  }
  Status load_one(FenceKind kind, const std::vector<Halfspace>& planes) {
    return load({{planes.data(), static_cast<std::int32_t>(planes.size()), kind}});
  }

  MarkedWorld world_{{40, 40, 20}, 0.1, 0.2};
  MarkedWorld bare_{{40, 40, 20}, 0.1, 0.0};
  MarkedWorld wide_{{40, 40, 20}, 0.1, 0.4};
  std::unique_ptr<Solids> solids_ = std::make_unique<Solids>();
};

TEST_F(FencesTest, ABoxHasItsEightCorners) {
  Halfspace planes[tern::kBoxPlanes];
  box_planes({{1.0, 1.0, 0.5}, {2.0, 1.5, 1.0}}, planes);
  ASSERT_EQ(load({{planes, 6, FenceKind::kKeepOut}}), Status::kOk);
  ASSERT_EQ(solids_->solid_count, 1);
  EXPECT_EQ(solids_->parts[0].corners, 8);
  EXPECT_TRUE(is_clear({0.8, 1.2, 0.7}, {0.8, 1.2, 0.7}, 0.2));
  EXPECT_FALSE(is_clear({0.81, 1.2, 0.7}, {0.81, 1.2, 0.7}, 0.2));
  EXPECT_FALSE(is_clear({0.5, 1.2, 0.7}, {3.0, 1.2, 0.7}, 0.2));
  EXPECT_FALSE(is_clear({1.5, 1.2, 0.7}, {1.5, 1.2, 0.7}, 0.0)) << "inside";
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

/// Planes that miss each other count as flat as far as the hull is grown: nothing in between is left out in silence.
TEST_F(FencesTest, WhatIsNotEmptyHasCorners) {
  const double diagonal = std::sqrt(4.0 * 4.0 + 4.0 * 4.0 + 2.0 * 2.0);
  for (const double miss : {0.0, 1e-14, 3e-14, 8e-14, 1e-13, 1.2e-13, 3e-13}) {
    const double by = miss * diagonal;
    const Status status =
        load_one(FenceKind::kKeepOut, {{{1.0, 0.0, 0.0}, 2.0 - 0.5 * by}, {{-1.0, 0.0, 0.0}, -2.0 - 0.5 * by}});
    EXPECT_EQ(status, miss < 1.1e-13 ? Status::kOk : Status::kFenceEmpty) << miss;
    if (status == Status::kOk) {
      EXPECT_EQ(solids_->solid_count, 1) << miss;
    }
  }
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

Vec3 random_unit(Random& random) {
  Vec3 n{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
  const double norm = norm3(n);
  if (norm < 0.1) return {1.0, 0.0, 0.0};
  return {n.x / norm, n.y / norm, n.z / norm};
}

TEST_F(FencesTest, EqualPlanesMakeNoMoreCornersAndLoseNone) {
  Halfspace planes[tern::kBoxPlanes];
  box_planes({{1.0, 1.0, 0.5}, {2.0, 1.5, 1.0}}, planes);
  std::vector<Halfspace> twice(planes, planes + tern::kBoxPlanes);
  for (const Halfspace& h : planes) {
    twice.push_back({{3.0 * h.normal.x, 3.0 * h.normal.y, 3.0 * h.normal.z}, 3.0 * h.offset});
  }
  ASSERT_EQ(load_one(FenceKind::kKeepOut, twice), Status::kOk);
  ASSERT_EQ(solids_->solid_count, 1);
  EXPECT_EQ(solids_->parts[0].corners, 8);
  EXPECT_TRUE(is_clear({0.8, 1.2, 0.7}, {0.8, 1.2, 0.7}, 0.2));
  EXPECT_FALSE(is_clear({0.81, 1.2, 0.7}, {0.81, 1.2, 0.7}, 0.2));
}

TEST_F(FencesTest, ANeedleKeepsItsTip) {
  // Three planes that meet at (2, 2, 1), each a millionth of a radian off upright.
  ASSERT_EQ(load_one(FenceKind::kKeepOut,
                     {{{1.0, 0.0, 1e-6}, 2.0 + 1e-6}, {{-1.0, 1.0, 1e-6}, 1e-6}, {{-1.0, -1.0, 1e-6}, -4.0 + 1e-6}}),
            Status::kOk);
  ASSERT_EQ(solids_->solid_count, 1);
  const double top = -hull_support({0.0, 0.0, -1.0}, solid().hull);
  EXPECT_GE(top, 1.0);
  EXPECT_LE(top, 1.0 + 1e-5);  // moved out by 1e-12 m, three planes a millionth of a radian apart
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

TEST_F(FencesTest, MoreCornersThanFitAreFoundMoreCoarsely) {
  // As many planes as there may be, all but equal in pairs: each corner has copies further apart than rounding.
  Random random(7);
  for (int i = 0; i < scaled(40); ++i) {
    std::vector<Halfspace> planes;
    while (static_cast<int>(planes.size()) + 2 <= tern::kMaxFencePlanes) {
      const Vec3 n = random_unit(random);
      for (int k = 0; k < 2; ++k) {
        const double by = 1e-7 * random.real(-1.0, 1.0);
        const Vec3 m{n.x + by, n.y - by, n.z + by};
        planes.push_back({m, dot3(m, {2.0, 2.0, 1.0}) + 0.5 * norm3(m)});
      }
    }
    ASSERT_EQ(load_one(FenceKind::kKeepOut, planes), Status::kOk);
    ASSERT_EQ(solids_->solid_count, 1);
    const tern::Hull hull = solid().hull;
    for (const Halfspace& h : planes) {  // each plane touches a ball of 0.5 m
      const double out = -hull_support({-h.normal.x, -h.normal.y, -h.normal.z}, hull);
      ASSERT_GE(out, dot3(h.normal, {2.0, 2.0, 1.0}) + 0.5 - 1e-6);
      ASSERT_LE(out, dot3(h.normal, {2.0, 2.0, 1.0}) + 0.5 + 1e-4);
    }
  }
}

TEST_F(FencesTest, CornersThatFitInNoWayAreRefused) {
  // Pyramids as flat as a billionth of a radian all around a ball of 0.5 m: what rounding leaves of their edges is
  // farther apart than the coarsest tolerance.
  Random random(8);
  std::vector<Halfspace> planes;
  while (static_cast<int>(planes.size()) + 4 <= tern::kMaxFencePlanes) {
    const Vec3 n = random_unit(random);
    const Vec3 u = tern::perpendicular(n);
    for (const Vec3& side : {u, -1.0 * u, cross(n, u), cross(u, n)}) {
      const Vec3 m = n + 1e-9 * side;
      planes.push_back({m, dot3(m, {2.0, 2.0, 1.0}) + 0.5 * norm3(m)});
    }
  }
  EXPECT_EQ(load_one(FenceKind::kKeepOut, planes), Status::kFencePlanesFull);
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
