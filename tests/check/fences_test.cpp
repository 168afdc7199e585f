// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences in the check: each way of breaking one is found, to the tolerance.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "support/check_world.hpp"

namespace tern_test {
namespace {

using tern::Finding;
using tern::Halfspace;
using tern::Segment;
using tern::Status;

using CheckFences = CheckWorld;

TEST_F(CheckFences, PolyhedronWithinTheRadiusOfAKeepOut) {
  const auto fences = std::make_unique<tern::AskedFences>();
  tern::Halfspace planes[tern::kBoxPlanes];
  query_.fences = fences.get();
  for (const double from : {2.2, 2.19}) {
    box_planes({{1.0, from, 0.5}, {2.0, 2.5, 1.5}}, planes);
    const Halfspace wide{{0.0, 0.0, 1.0}, 3.0};
    const tern::Fence list[] = {{&wide, 1, tern::FenceKind::kKeepIn}, {planes, 6, tern::FenceKind::kKeepOut}};
    ASSERT_TRUE(copy_fences(list, 2, *fences));
    if (from > 2.195) {
      EXPECT_EQ(run(), Status::kOk);
    } else {
      const tern::CheckReport& found = expect(Finding::kFence, 0);
      EXPECT_EQ(found.fence, 1);
      EXPECT_EQ(found.plane, 2);
      EXPECT_NEAR(found.excess, 0.01, 2e-9);
    }
  }
}

TEST_F(CheckFences, ObliqueKeepOutBesideAPolyhedron) {
  const auto fences = std::make_unique<tern::AskedFences>();
  query_.fences = fences.get();
  // A prism below the first polyhedron, its tip 0.3 m from it: some half-space of the polyhedron has to cut it off.
  const tern::Halfspace prism[] = {{{1.0, 1.0, 0.0}, 2.4}, {{-1.0, 1.0, 0.0}, 0.4}, {{0.0, -1.0, 0.0}, -0.4}};
  const tern::Fence fence{prism, 3, tern::FenceKind::kKeepOut};
  ASSERT_TRUE(copy_fences(&fence, 1, *fences));
  const bool first = keep_outs_clear(grid_, corridor_->polyhedra[0], *fences, stage_.scratch, stage_);
  EXPECT_FALSE(first);  // the tip, (1, 1.4), is inside
  const tern::Halfspace lower[] = {{{1.0, 1.0, 0.0}, 1.99}, {{-1.0, 1.0, 0.0}, 0.0}, {{0.0, -1.0, 0.0}, -0.4}};
  const tern::Fence below{lower, 3, tern::FenceKind::kKeepOut};
  ASSERT_TRUE(copy_fences(&below, 1, *fences));
  EXPECT_TRUE(keep_outs_clear(grid_, corridor_->polyhedra[0], *fences, stage_.scratch,
                              stage_));  // (0.995, 0.995): 0.205 m away
}

/// The edge of a prism climbs towards the first polyhedron, y <= 2. It is the radius away where z = 1.7.
TEST_F(CheckFences, AKeepOutCountsAsFarAsTheRadiusAroundAKeepIn) {
  const auto fences = std::make_unique<tern::AskedFences>();
  const Halfspace prism[] = {{{1.0, -1.0, -1.0}, 1.0 - 2.2 - 1.7}, {{-1.0, -1.0, -1.0}, -1.0 - 2.2 - 1.7}};
  const auto clear_within = [&](const Halfspace& keep_in) {
    const tern::Fence list[] = {{prism, 2, tern::FenceKind::kKeepOut}, {&keep_in, 1, tern::FenceKind::kKeepIn}};
    EXPECT_TRUE(copy_fences(list, 2, *fences));
    return keep_outs_clear(grid_, corridor_->polyhedra[0], *fences, stage_.scratch, stage_);
  };
  EXPECT_FALSE(clear_within({{0.0, 0.0, 1.0}, 2.0})) << "all of the map";
  EXPECT_FALSE(clear_within({{0.0, 0.0, 2.0}, 2.0 * (1.5 + 2e-9)}));
  EXPECT_TRUE(clear_within({{0.0, 0.0, 2.0}, 2.0 * 1.5}));
  EXPECT_TRUE(clear_within({{0.0, 0.0, 1.0}, 0.0})) << "a keep-in of the floor alone";
  EXPECT_TRUE(clear_within({{0.0, 0.0, 1.0}, -1e300})) << "a keep-in that leaves no place";
}

/// Without a radius, too: the polyhedron's own faces cut nothing off that it holds.
TEST_F(CheckFences, AKeepOutHasAnInsideInAFlatBoundaryAndAFlatKeepIn) {
  const auto fences = std::make_unique<tern::AskedFences>();
  const Halfspace slab[] = {{{1.0, 0.0, 0.0}, 3.0}, {{-1.0, 0.0, 0.0}, -1.0}};
  const Halfspace level[] = {{{0.0, 0.0, 1.0}, 1.0}, {{0.0, 0.0, -1.0}, -1.0}};
  const tern::Fence list[] = {{slab, 2, tern::FenceKind::kKeepOut}, {level, 2, tern::FenceKind::kKeepIn}};
  tern::GridSpec spec = grid_.spec();
  spec.radius = 0.0;
  for (const bool in_boundary : {true, false}) {
    if (in_boundary) spec.boundary = {{0.0, 0.0, 1.0}, {4.0, 2.0, 1.0}};
    if (!in_boundary) spec.boundary = {{0.0, 0.0, 0.0}, {4.0, 2.0, 2.0}};
    ASSERT_EQ(grid_.bind(spec, words_.data(), words_.size()), Status::kOk);
    ASSERT_TRUE(copy_fences(list, in_boundary ? 1 : 2, *fences));
    const auto clear_of = [&](double from) {
      const tern::Polyhedron flat = box_polyhedron({from, 0.0, 1.0}, {4.0, 2.0, 1.0});
      return keep_outs_clear(grid_, flat, *fences, stage_.scratch, stage_);
    };
    EXPECT_FALSE(clear_of(0.0));
    EXPECT_FALSE(clear_of(2.9));
    EXPECT_TRUE(clear_of(3.0)) << "it may touch";
  }
}

TEST_F(CheckFences, ControlPointOutsideAKeepIn) {
  const auto fences = std::make_unique<tern::AskedFences>();
  query_.fences = fences.get();
  const tern::Halfspace plane{{2.0, 0.0, 0.0}, 5.8};
  const tern::Fence fence{&plane, 1, tern::FenceKind::kKeepIn};
  ASSERT_TRUE(copy_fences(&fence, 1, *fences));
  const tern::CheckReport& found = expect(Finding::kFence, 0);
  EXPECT_EQ(found.segment, 0);
  EXPECT_EQ(found.polyhedron, -1);
  EXPECT_EQ(found.fence, 0);
  EXPECT_EQ(found.plane, 0);
  EXPECT_NEAR(found.excess, 0.1, 2e-9);
}

/// Each ends at z = 0.7 at its highest, so that a polyhedron may begin at 0.9.
TEST_F(CheckFences, DegenerateKeepOutsCountAsTheirShape) {
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
      return keep_outs_clear(grid_, box_polyhedron({0.0, 0.0, z}, {4.0, 2.0, 2.0}), *fences, stage_.scratch, stage_);
    };
    EXPECT_TRUE(clear_above(0.9)) << "shape " << i;
    EXPECT_TRUE(clear_above(0.9 - 0.99 * tern::fence_tolerance(grid_))) << "shape " << i;
    // Rounding their offsets moves the edges of a blade and a needle by 1e-10 m.
    EXPECT_FALSE(clear_above(0.9 - 1.2 * tern::fence_tolerance(grid_))) << "shape " << i;
  }
}

TEST_F(CheckFences, KeepOutsWithoutPointsAreClearOfAll) {
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
    EXPECT_TRUE(keep_outs_clear(grid_, corridor_->polyhedra[0], *fences, stage_.scratch, stage_));
  }
}

TEST_F(CheckFences, HalfSpacesFarBeyondTheMapHoldAllOrNothing) {
  const auto fences = std::make_unique<tern::AskedFences>();
  const auto clear_of = [&](const std::vector<Halfspace>& shape) {
    const tern::Fence fence{shape.data(), static_cast<std::int32_t>(shape.size()), tern::FenceKind::kKeepOut};
    EXPECT_TRUE(copy_fences(&fence, 1, *fences));
    return keep_outs_clear(grid_, corridor_->polyhedra[0], *fences, stage_.scratch, stage_);
  };
  const Halfspace above{{0.0, -1.0, 0.0}, -1.5};  // cuts the polyhedron
  EXPECT_FALSE(clear_of({above}));
  for (const double far : {50.0, 1e300}) {
    EXPECT_FALSE(clear_of({{{1.0, 0.0, 0.0}, far}, above})) << "one that holds the whole map says nothing";
    EXPECT_TRUE(clear_of({{{1.0, 0.0, 0.0}, -far}, above})) << "one that holds none of it leaves nothing";
  }
  const Segment segment = straight({0.5, 1.5, 1.0}, {3.0, 1.5, 1.0}, 4.0, 0);
  for (const double far : {1e300, -1e300}) {
    const Halfspace plane{{1.0, 0.0, 0.0}, far};
    const tern::Fence fence{&plane, 1, tern::FenceKind::kKeepIn};
    ASSERT_TRUE(copy_fences(&fence, 1, *fences));
    EXPECT_EQ(keep_ins_hold(segment, *fences, {0.0, 0.0, 0.0}, tern::kCheckDistance, stage_), far > 0.0);
  }
  EXPECT_EQ(stage_.finding, Finding::kFence);
}

TEST_F(CheckFences, KeepInsHoldToTheToleranceHoweverFarAway) {
  const auto fences = std::make_unique<tern::AskedFences>();
  for (const double away : {0.0, 1e6, 1e12}) {
    // 3 (x - away) + 4 y <= 15: with y = 1.5, x up to 3
    const Halfspace plane{{3.0, 4.0, 0.0}, 15.0 + 3.0 * away};
    const tern::Fence fence{&plane, 1, tern::FenceKind::kKeepIn};
    ASSERT_TRUE(copy_fences(&fence, 1, *fences));
    Segment segment = straight({0.5, 1.5, 1.0}, {3.0 + 1.5e-9, 1.5, 1.0}, 4.0, 0);  // 0.9e-9 m beyond
    EXPECT_TRUE(keep_ins_hold(segment, *fences, {away, 0.0, 0.0}, tern::kCheckDistance, stage_)) << away;
    segment = straight({0.5, 1.5, 1.0}, {3.0 + 1.8e-9, 1.5, 1.0}, 4.0, 0);  // 1.08e-9 m beyond
    EXPECT_FALSE(keep_ins_hold(segment, *fences, {away, 0.0, 0.0}, tern::kCheckDistance, stage_)) << away;
  }
}

TEST_F(CheckFences, MoreFencesThanFitAreRefused) {
  const auto fences = std::make_unique<tern::AskedFences>();
  const std::vector<Halfspace> planes(tern::kMaxFencePlanes + 1, {{1.0, 0.0, 0.0}, 1.0});
  const tern::Fence large{planes.data(), tern::kMaxFencePlanes + 1, tern::FenceKind::kKeepIn};
  EXPECT_FALSE(copy_fences(&large, 1, *fences));
  const std::vector<tern::Fence> many(tern::kMaxFences + 1, {planes.data(), 1, tern::FenceKind::kKeepIn});
  EXPECT_FALSE(copy_fences(many.data(), tern::kMaxFences + 1, *fences));
  EXPECT_EQ(fences->count, 0);
}

}  // namespace
}  // namespace tern_test
