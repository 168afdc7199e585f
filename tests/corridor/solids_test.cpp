// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Polyhedra that fences leave no room for. No plan asks for them, because its path obeys the fences.
#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <memory>
#include <vector>

#include "corridor/corridor_stage.hpp"
#include "corridor/grow.hpp"
#include "support/at_once.hpp"
#include "support/corridor_reference.hpp"
#include "world/fences.hpp"

namespace tern_test {
namespace {

using tern::Fence;
using tern::FenceKind;
using tern::Halfspace;
using tern::Status;
using tern::Vec3;

/// 4 x 4 x 4 m at 0.1 m, radius 0.2.
class CorridorFences : public ::testing::Test {
 protected:
  CorridorFences() : world_({40, 40, 40}, 0.1, 0.2) {
    world_.grid.inflate();
    tern::reset_counters(*scratch_);
  }
  void load(const std::vector<Fence>& fences) {
    ASSERT_EQ(tern::load_fences(world_.grid, fences.data(), static_cast<std::int32_t>(fences.size()), *solids_).status,
              Status::kOk);
  }
  tern::World world() const { return tern::World(world_.grid, *solids_); }
  Status grow(const Vec3& from, const Vec3& to) {
    return tern_test::grow_polyhedron(world(), from, to, *scratch_, *polyhedron_);
  }
  /// A keep-out box.
  Fence block(const Vec3& lower, const Vec3& upper) {
    faces_.emplace_back();
    tern::box_planes({lower, upper}, faces_.back().at);
    return {faces_.back().at, tern::kBoxPlanes, FenceKind::kKeepOut};
  }

  MarkedWorld world_;
  struct Faces {
    Halfspace at[tern::kBoxPlanes];
  };
  std::deque<Faces> faces_;
  std::unique_ptr<tern::Solids> solids_ = std::make_unique<tern::Solids>();
  std::unique_ptr<tern::GrowScratch> scratch_ = std::make_unique<tern::GrowScratch>();
  std::unique_ptr<tern::Polyhedron> polyhedron_ = std::make_unique<tern::Polyhedron>();
};

TEST_F(CorridorFences, ASegmentOutsideAKeepInIsBlocked) {
  const Halfspace left{{1.0, 0.0, 0.0}, 2.5};
  const Halfspace low{{0.0, 0.0, 1.0}, 3.0};
  load({{&left, 1, FenceKind::kKeepIn}, {&low, 1, FenceKind::kKeepIn}, block({0.0, 3.5, 0.0}, {4.0, 4.0, 4.0})});
  EXPECT_EQ(grow({1.0, 2.0, 2.0}, {2.6, 2.0, 2.0}), Status::kCorridorBlocked);
  ASSERT_EQ(grow({1.0, 2.0, 2.0}, {2.5, 2.0, 2.0}), Status::kOk) << "up to its face";
  EXPECT_LE(signed_excess(polyhedron_->planes[6], {2.5, 2.0, 2.0}), 0.0);
  EXPECT_EQ(polyhedron_->planes[6].normal.x, 1.0);
}

TEST_F(CorridorFences, ASegmentThroughAKeepOutIsBlocked) {
  load({block({1.9, 1.0, 1.0}, {2.1, 3.0, 3.0}), block({1.0, 2.5, 1.0}, {3.0, 3.0, 3.0})});
  EXPECT_EQ(grow({1.0, 2.0, 2.0}, {3.0, 2.0, 2.0}), Status::kCorridorBlocked);
  EXPECT_EQ(grow({1.0, 2.0, 2.0}, {1.8, 2.0, 2.0}), Status::kCorridorBlocked) << "nearer than the radius";
  EXPECT_EQ(grow({1.0, 2.0, 2.0}, {1.7, 2.0, 2.0}), Status::kOk);
}

/// A keep-in like a pipe along x, of more faces than a polyhedron has: no piece of the way through it is so short that
/// some of them would not matter. It is halved as often as may be.
TEST_F(CorridorFences, APipeOfTooManyFacesIsFull) {
  constexpr int kFaces = tern::kMaxPlanes;
  std::vector<Halfspace> faces;
  for (int k = 0; k < kFaces; ++k) {
    const double turn = 2.0 * 3.14159265358979 * k / kFaces;
    const Vec3 normal{0.0, std::cos(turn), std::sin(turn)};
    faces.push_back({normal, dot3(normal, {0.0, 2.0, 2.0}) + 0.01});
  }
  load({{faces.data(), kFaces, FenceKind::kKeepIn}});
  EXPECT_EQ(grow({1.0, 2.0, 2.0}, {3.0, 2.0, 2.0}), Status::kPlanesFull);
  const auto stage = std::make_unique<tern::CorridorStage>();
  const auto path = std::make_unique<tern::Path>();
  const auto corridor = std::make_unique<tern::Corridor>();
  path->count = 2;
  path->points[0] = {1.0, 2.0, 2.0};
  path->points[1] = {3.0, 2.0, 2.0};
  tern::corridor_begin(*stage, *path);
  tern::Work work{0xFFFFFFFFu};
  EXPECT_EQ(tern::corridor_advance(*stage, world(), *path, work, *corridor), tern::Progress::kFailed);
  EXPECT_EQ(stage->status, Status::kPlanesFull);
  EXPECT_EQ(stage->pending, tern::kMaxHalvings + 1);
  EXPECT_NEAR(stage->ends[tern::kMaxHalvings].x, 1.0 + 2.0 / 64.0, 1e-12);
}

TEST(CorridorWithoutALeg, IsFull) {
  const MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  const auto stage = std::make_unique<tern::CorridorStage>();
  const auto path = std::make_unique<tern::Path>();
  const auto corridor = std::make_unique<tern::Corridor>();
  path->points[0] = {1.0, 2.0, 2.0};
  for (const int count : {0, 1}) {
    path->count = count;
    tern::corridor_begin(*stage, *path);
    tern::Work work{10};
    EXPECT_EQ(tern::corridor_advance(*stage, tern::World(world.grid), *path, work, *corridor), tern::Progress::kFailed);
    EXPECT_EQ(stage->status, Status::kSegmentsFull);
    EXPECT_EQ(work.units(), 10u);
  }
}

}  // namespace
}  // namespace tern_test
