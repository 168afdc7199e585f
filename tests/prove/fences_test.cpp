// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences: each way of breaking one is found, to what is granted.
#include "prove/fences.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "support/check_world.hpp"

namespace tern_test {
namespace {

using tern::Finding;
using tern::Halfspace;
using tern::Status;

class ProveFences : public CheckWorld {
 protected:
  ProveFences() : fences_(new tern::AskedWorld) { query_.world = fences_.get(); }

  void ask(const std::vector<tern::Fence>& list) {
    ASSERT_TRUE(copy_asked(list.data(), static_cast<std::int32_t>(list.size()), *fences_));
  }
  void ask_keep_out(const std::vector<Halfspace>& planes) {
    ask({{planes.data(), static_cast<std::int32_t>(planes.size()), tern::FenceKind::kKeepOut}});
  }
  /// True if keep-out `index` is cut off along an axis, or along one of its own faces, from a box that keeps
  /// `distance`.
  bool cut_off_from(const tern::Vec3& lower, const tern::Vec3& upper, double distance, int index = 0) {
    const tern::Polyhedron box = box_polyhedron(lower, upper);
    tern::Vec3 corners[8];
    for (int c = 0; c < 8; ++c) {
      corners[c] = {(c & 1) != 0 ? upper.x : lower.x, (c & 2) != 0 ? upper.y : lower.y,
                    (c & 4) != 0 ? upper.z : lower.z};
    }
    return keep_out_cut_off(grid_, fences_->fence, fences_->count, index, tern::hints_of(box), {corners, 8, distance},
                            stage_.hints.scratch, work_);
  }
  /// From the room north of the wall, y >= 1.2.
  bool cut_off_in_the_north(int index = 0) {
    return cut_off_from({0.0, 1.2, 0.0}, {4.0, 2.0, 2.0}, 0.2 - grant().near, index);
  }

  tern::Work work_;
  std::unique_ptr<tern::AskedWorld> fences_;
};

TEST_F(ProveFences, PlanWithinTheRadiusOfAKeepOut) {
  tern::Halfspace planes[tern::kBoxPlanes];
  const Halfspace wide{{0.0, 0.0, 1.0}, 3.0};
  for (const double from : {1.7, 1.69}) {
    box_planes({{1.0, from, 0.5}, {2.0, 2.5, 1.5}}, planes);
    ask({{&wide, 1, tern::FenceKind::kKeepIn}, {planes, 6, tern::FenceKind::kKeepOut}});
    if (from > 1.695) {
      EXPECT_EQ(run(), Status::kOk);
    } else {
      const tern::ProofReport& found = expect(Finding::kFence, 0);
      EXPECT_EQ(found.fence, 1);
      EXPECT_GT(found.excess, 0.0);
      EXPECT_LE(found.excess, 0.01);
    }
  }
}

/// The first segment passes the edge and the corner of a box at a distance that its faces alone do not show.
TEST_F(ProveFences, EdgesAndCornersAreRound) {
  tern::Halfspace planes[tern::kBoxPlanes];
  trajectory_->count = 1;
  trajectory_->segments[0].polyhedron = -1;
  query_.goal.position = {3.0, 1.5, 1.0};
  const auto passes = [&](const tern::Vec3& corner, bool has_end) {
    box_planes({{has_end ? 1.7 : 0.0, corner.y, corner.z}, {has_end ? 1.71 : 4.0, 2.5, 2.0}}, planes);
    ask({{planes, 6, tern::FenceKind::kKeepOut}});
    return run() == Status::kOk;
  };
  for (const bool has_end : {false, true}) {
    EXPECT_TRUE(passes({0.0, 1.5 + 0.12, 1.0 + 0.16}, has_end)) << "0.2 m";
    EXPECT_FALSE(passes({0.0, 1.5 + 0.119, 1.0 + 0.16}, has_end));
  }
}

TEST_F(ProveFences, ACornerCutsOffWhatNoEdgeDoes) {
  tern::Halfspace planes[tern::kBoxPlanes];
  box_planes({{1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}}, planes);
  const tern::Fence box{planes, 6, tern::FenceKind::kKeepOut};
  // 2, 3 and 6 parts of 7 m to the corner: 0.7 m away, but only 0.67 m from the edge's line.
  const tern::Vec3 point{1.0 - 0.2, 1.0 - 0.3, 1.0 - 0.6};
  EXPECT_TRUE(fence_clear(box, {{0.0, 0.0, 0.0}, 0.7 - 1e-12, 0.0}, &point, 1, work_));
  EXPECT_FALSE(fence_clear(box, {{0.0, 0.0, 0.0}, 0.7 + 1e-12, 0.0}, &point, 1, work_));
}

TEST_F(ProveFences, ObliqueKeepOutBesideABox) {
  // A prism below the room, its tip 0.2 m inside it.
  ask_keep_out({{{1.0, 1.0, 0.0}, 2.4}, {{-1.0, 1.0, 0.0}, 0.4}, {{0.0, -1.0, 0.0}, -0.4}});
  EXPECT_FALSE(cut_off_in_the_north());
  ask_keep_out({{{1.0, 1.0, 0.0}, 1.99}, {{-1.0, 1.0, 0.0}, 0.0}, {{0.0, -1.0, 0.0}, -0.4}});
  EXPECT_TRUE(cut_off_in_the_north());  // (0.995, 0.995): 0.205 m away
}

/// The edge of a prism climbs towards the room, y <= 2. It is the radius away where z = 1.7.
TEST_F(ProveFences, AKeepOutCountsAsFarAsTheRadiusAroundAKeepIn) {
  const Halfspace prism[] = {{{1.0, -1.0, -1.0}, 1.0 - 2.2 - 1.7}, {{-1.0, -1.0, -1.0}, -1.0 - 2.2 - 1.7}};
  const auto clear_within = [&](const Halfspace& keep_in) {
    ask({{prism, 2, tern::FenceKind::kKeepOut}, {&keep_in, 1, tern::FenceKind::kKeepIn}});
    return cut_off_in_the_north();
  };
  EXPECT_FALSE(clear_within({{0.0, 0.0, 1.0}, 2.0})) << "all of the map";
  EXPECT_FALSE(clear_within({{0.0, 0.0, 2.0}, 2.0 * (1.5 + 4e-9)}));
  EXPECT_TRUE(clear_within({{0.0, 0.0, 2.0}, 2.0 * 1.5}));
  EXPECT_TRUE(clear_within({{0.0, 0.0, 1.0}, 0.0})) << "a keep-in of the floor alone";
  EXPECT_TRUE(clear_within({{0.0, 0.0, 1.0}, -1e300})) << "a keep-in that leaves no place";
}

/// Without a radius, too: the box's own faces cut nothing off that it holds.
TEST_F(ProveFences, AKeepOutHasAnInsideInAFlatBoundaryAndAFlatKeepIn) {
  const Halfspace slab[] = {{{1.0, 0.0, 0.0}, 3.0}, {{-1.0, 0.0, 0.0}, -1.0}};
  const Halfspace level[] = {{{0.0, 0.0, 1.0}, 1.0}, {{0.0, 0.0, -1.0}, -1.0}};
  tern::GridSpec spec = grid_.spec();
  spec.radius = 0.0;
  for (const bool in_boundary : {true, false}) {
    if (in_boundary) spec.boundary = {{0.0, 0.0, 1.0}, {4.0, 2.0, 1.0}};
    if (!in_boundary) spec.boundary = {{0.0, 0.0, 0.0}, {4.0, 2.0, 2.0}};
    ASSERT_EQ(grid_.bind(spec, words_.data(), words_.size()), Status::kOk);
    std::vector<tern::Fence> list = {{slab, 2, tern::FenceKind::kKeepOut}};
    if (!in_boundary) list.push_back({level, 2, tern::FenceKind::kKeepIn});
    ask(list);
    const auto clear_of = [&](double from) { return cut_off_from({from, 0.0, 1.0}, {4.0, 2.0, 1.0}, -grant().near); };
    EXPECT_FALSE(clear_of(0.0));
    EXPECT_FALSE(clear_of(2.9));
    EXPECT_TRUE(clear_of(3.0)) << "it may touch";
  }
}

TEST_F(ProveFences, CurveOutsideAKeepIn) {
  const tern::Halfspace plane{{2.0, 0.0, 0.0}, 5.8};
  ask({{&plane, 1, tern::FenceKind::kKeepIn}});
  const tern::ProofReport& found = expect(Finding::kFence, 0);
  EXPECT_EQ(found.fence, 0);
  EXPECT_NEAR(found.excess, 0.1, 2e-9);
}

/// Each ends at z = 0.7 at its highest, so that a box may begin at 0.9.
TEST_F(ProveFences, DegenerateKeepOutsCountAsTheirShape) {
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
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    ask_keep_out(shapes[i]);
    const double near = grant().near;
    const auto clear_above = [&](double z) { return cut_off_from({0.0, 0.0, z}, {4.0, 2.0, 2.0}, 0.2 - near); };
    EXPECT_TRUE(clear_above(0.9)) << "shape " << i;
    EXPECT_TRUE(clear_above(0.9 - 0.99 * near)) << "shape " << i;
    // Rounding their offsets moves the edges of a blade and a needle by 1e-10 m.
    EXPECT_FALSE(clear_above(0.9 - 1.2 * near)) << "shape " << i;
  }
}

TEST_F(ProveFences, KeepOutsWithoutPointsAreClearOfAll) {
  const std::vector<std::vector<Halfspace>> shapes = {
      {{{1.0, 0.0, 0.0}, 1.0}, {{-1.0, 0.0, 0.0}, -1.0 - 1e-15}},   // nothing, by a rounding
      {{{1.0, 1e-9, 0.0}, 1.0}, {{-1.0, 1e-9, 0.0}, -1.0 - 1e-8}},  // a blade that begins at y = -5, outside the map
      {{{1.0, 0.0, 0.0}, -1e300}, {{-1.0, 0.0, 0.0}, 1e300}},
      {{{0.0, 0.0, -1.0}, -2.21}},  // further from the boundary than the radius
  };
  for (const std::vector<Halfspace>& shape : shapes) {
    ask_keep_out(shape);
    EXPECT_TRUE(cut_off_in_the_north());
  }
}

TEST_F(ProveFences, HalfSpacesFarBeyondTheMapHoldAllOrNothing) {
  const auto clear_of = [&](const std::vector<Halfspace>& shape) {
    ask_keep_out(shape);
    return cut_off_in_the_north();
  };
  const Halfspace above{{0.0, -1.0, 0.0}, -1.5};  // cuts the room
  EXPECT_FALSE(clear_of({above}));
  for (const double far : {50.0, 1e300}) {
    EXPECT_FALSE(clear_of({{{1.0, 0.0, 0.0}, far}, above})) << "one that holds the whole map says nothing";
    EXPECT_TRUE(clear_of({{{1.0, 0.0, 0.0}, -far}, above})) << "one that holds none of it leaves nothing";
  }
  const tern::Vec3 point{3.0, 1.5, 1.0};
  for (const double far : {1e300, -1e300}) {
    const Halfspace plane{{1.0, 0.0, 0.0}, far};
    EXPECT_EQ(fence_clear({&plane, 1, tern::FenceKind::kKeepIn}, {{0.0, 0.0, 0.0}, 0.2, 1e-9}, &point, 1, work_),
              far > 0.0);
    EXPECT_EQ(fence_clear({&plane, 1, tern::FenceKind::kKeepOut}, {{0.0, 0.0, 0.0}, 0.2, 1e-9}, &point, 1, work_),
              far < 0.0);
  }
}

TEST_F(ProveFences, KeepInsHoldToTheToleranceHoweverFarAway) {
  for (const double away : {0.0, 1e6, 1e12}) {
    // 3 (x - away) + 4 y <= 15: with y = 1.5, x up to 3
    const Halfspace plane{{3.0, 4.0, 0.0}, 15.0 + 3.0 * away};
    const tern::Fence fence{&plane, 1, tern::FenceKind::kKeepIn};
    const tern::Vec3 in[] = {{0.5, 1.5, 1.0}, {3.0 + 1.5e-9, 1.5, 1.0}};   // 0.9e-9 m beyond
    const tern::Vec3 out[] = {{0.5, 1.5, 1.0}, {3.0 + 1.8e-9, 1.5, 1.0}};  // 1.08e-9 m beyond
    const tern::FenceRule rule{{away, 0.0, 0.0}, 0.2, tern::kCheckDistance};
    EXPECT_TRUE(fence_clear(fence, rule, in, 2, work_)) << away;
    EXPECT_FALSE(fence_clear(fence, rule, out, 2, work_)) << away;
    EXPECT_NEAR(tern::fence_excess(fence, rule, out[1]), 0.08e-9, 1e-14) << away;
  }
}

TEST_F(ProveFences, MoreFencesThanFitAreRefused) {
  const std::vector<Halfspace> planes(tern::kMaxFencePlanes + 1, {{1.0, 0.0, 0.0}, 1.0});
  const tern::Fence large{planes.data(), tern::kMaxFencePlanes + 1, tern::FenceKind::kKeepIn};
  EXPECT_FALSE(copy_asked(&large, 1, *fences_));
  const std::vector<tern::Fence> many(tern::kMaxFences + 1, {planes.data(), 1, tern::FenceKind::kKeepIn});
  EXPECT_FALSE(copy_asked(many.data(), tern::kMaxFences + 1, *fences_));
  EXPECT_EQ(fences_->count, 0);
}

}  // namespace
}  // namespace tern_test
