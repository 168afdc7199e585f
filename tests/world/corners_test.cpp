// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Corners of fences: merged, too many, refused.

#include <gtest/gtest.h>

#include <cmath>

#include "base/math.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"
#include "world/fences.hpp"
#include "world/loaded_fences.hpp"
#include "world/solid_layer.hpp"
#include "world/world.hpp"

namespace tern_test {
namespace {

using tern::FenceKind;
using tern::Halfspace;
using tern::Status;
using tern::Vec3;

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

}  // namespace
}  // namespace tern_test
