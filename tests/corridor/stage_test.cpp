// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstring>
#include <initializer_list>
#include <memory>

#include "corridor/corridor_stage.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"
#include "support/same.hpp"

namespace tern_test {
namespace {

using tern::Corridor;
using tern::CorridorStage;
using tern::Path;
using tern::Polyhedron;
using tern::Status;
using tern::Vec3;
using tern::Work;

class CorridorStageTest : public ::testing::Test {
 protected:
  void set_path(std::initializer_list<Vec3> points) {
    path_->count = 0;
    for (const Vec3& p : points) path_->points[path_->count++] = p;
  }

  /// Runs in slices of `slice` units on a scratch full of `fill`.
  Status run(const MarkedWorld& world, std::uint32_t slice, int fill = 0xA5, bool is_timed = false) {
    std::memset(static_cast<void*>(stage_.get()), fill, sizeof *stage_);
    std::memset(static_cast<void*>(corridor_.get()), fill, sizeof *corridor_);
    corridor_begin(*stage_, *path_, nullptr, is_timed);
    for (int i = 0; i < 1000000; ++i) {
      Work work{slice};
      const tern::Progress progress = corridor_advance(*stage_, tern::World(world.grid), *path_, work, *corridor_);
      EXPECT_LE(stage_->tries, tern::kCorridorTries);
      if (progress != tern::Progress::kMore) return stage_->status;
    }
    return Status::kRunning;
  }

  /// The chain begins at the start, ends at the goal and has no gap.
  void expect_chain() {
    ASSERT_GE(corridor_->count, 1);
    expect_same(corridor_->polyhedra[0].from, path_->points[0]);
    expect_same(corridor_->polyhedra[corridor_->count - 1].to, path_->points[path_->count - 1]);
    for (int i = 0; i + 1 < corridor_->count; ++i) {
      expect_same(corridor_->polyhedra[i].to, corridor_->polyhedra[i + 1].from);
    }
  }

  static bool inside(const Polyhedron& polyhedron, const Vec3& point) {
    for (int p = 0; p < polyhedron.count; ++p) {
      const tern::Halfspace& plane = polyhedron.planes[p];
      if (plane.normal.x * point.x + plane.normal.y * point.y + plane.normal.z * point.z > plane.offset) return false;
    }
    return true;
  }

  /// Every waypoint is the end of a polyhedron.
  void expect_every_waypoint() {
    int waypoint = 1;
    for (int i = 0; i < corridor_->count; ++i) {
      const Vec3& w = path_->points[waypoint];
      const Vec3& end = corridor_->polyhedra[i].to;
      if (norm3(minus3(w, end)) <= 0.0) ++waypoint;
    }
    EXPECT_EQ(waypoint, path_->count) << "a waypoint is no polyhedron's end";
  }

  std::unique_ptr<CorridorStage> stage_ = std::make_unique<CorridorStage>();
  std::unique_ptr<Path> path_ = std::make_unique<Path>();
  std::unique_ptr<Corridor> corridor_ = std::make_unique<Corridor>();
};

TEST_F(CorridorStageTest, OnePolyhedronALeg) {
  MarkedWorld world({80, 80, 30}, 0.1, 0.2);
  world.fill({30, 0, 0}, {35, 50, 30});
  set_path({{1.0, 1.0, 1.5}, {2.5, 5.6, 1.5}, {3.9, 5.6, 1.5}, {6.0, 1.0, 1.5}});
  ASSERT_EQ(run(world, 100), Status::kOk);
  EXPECT_EQ(corridor_->count, 3);
  expect_chain();
  expect_every_waypoint();
  EXPECT_GE(stage_->planes_high, 6);
  EXPECT_GE(stage_->boxes_high, 1);
}

TEST_F(CorridorStageTest, AHoverIsOnePolyhedron) {
  const MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  set_path({{2.0, 2.0, 2.0}, {2.0, 2.0, 2.0}});
  ASSERT_EQ(run(world, 1), Status::kOk);
  EXPECT_EQ(corridor_->count, 1);
  expect_chain();
}

TEST_F(CorridorStageTest, CoincidentWaypointsShareAPolyhedron) {
  const MarkedWorld world({80, 40, 40}, 0.1, 0.2);
  set_path({{1.0, 2.0, 2.0}, {3.0, 2.0, 2.0}, {3.0, 2.0, 2.0}, {7.0, 2.0, 2.0}});
  ASSERT_EQ(run(world, 1), Status::kOk);
  EXPECT_EQ(corridor_->count, 2);
  expect_chain();
}

TEST_F(CorridorStageTest, LegsThatAPolyhedronHoldsAreNotBuilt) {
  // In free space the first polyhedron is the box of its leg and 2 m more: x from 0 to 5, y and z from 0 to 4.
  const MarkedWorld world({80, 40, 40}, 0.1, 0.2);
  set_path({{1.0, 2.0, 2.0}, {3.0, 2.0, 2.0}, {3.0, 3.5, 2.0}, {4.5, 3.5, 1.0}, {7.5, 3.5, 1.0}});
  ASSERT_EQ(run(world, 1), Status::kOk);
  ASSERT_EQ(corridor_->count, 2);
  expect_chain();
  EXPECT_EQ(stage_->grow.planes_high, 6) << "the faces of a box";
  const Polyhedron& first = corridor_->polyhedra[0];
  expect_same(first.to, {4.5, 3.5, 1.0});
}

TEST_F(CorridorStageTest, LegsThatALaterPolyhedronHoldsAreDropped) {
  // Through a door of 0.2 m for the centre, then two legs. The middle one's polyhedron ends at x = 6, short of the last
  // waypoint; the last one's begins at x = 3.5 and holds both.
  MarkedWorld world({100, 60, 40}, 0.1, 0.2);
  world.fill({30, 0, 0}, {32, 27, 40});
  world.fill({30, 33, 0}, {32, 60, 40});
  set_path({{1.0, 3.0, 2.0}, {3.6, 3.0, 2.0}, {4.0, 3.5, 2.0}, {8.0, 3.5, 2.0}});
  ASSERT_EQ(run(world, 1), Status::kOk);
  ASSERT_EQ(corridor_->count, 2);
  expect_chain();
  expect_same(corridor_->polyhedra[1].from, {3.6, 3.0, 2.0});
}

TEST_F(CorridorStageTest, FirstAndLastPieceHaveTheirOwn) {
  const MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  set_path({{1.0, 2.0, 2.0}, {3.0, 2.0, 2.0}, {3.0, 3.0, 2.0}});
  ASSERT_EQ(run(world, 1), Status::kOk);
  ASSERT_EQ(corridor_->count, 2);
  expect_chain();
  expect_every_waypoint();
}

TEST_F(CorridorStageTest, ALegIsBuiltThatEndsTooNearAFace) {
  // The first polyhedron ends at y = 4, the margin is 0.005 m: one waypoint keeps it, the other does not. Either way
  // the last polyhedron holds no leg before its own.
  const MarkedWorld world({80, 80, 40}, 0.1, 0.2);
  set_path({{1.0, 2.0, 2.0}, {3.0, 2.0, 2.0}, {3.0, 3.994, 2.0}, {3.0, 7.0, 2.0}});
  ASSERT_EQ(run(world, 1), Status::kOk);
  EXPECT_EQ(corridor_->count, 2);
  set_path({{1.0, 2.0, 2.0}, {3.0, 2.0, 2.0}, {3.0, 3.996, 2.0}, {3.0, 7.0, 2.0}});
  ASSERT_EQ(run(world, 1), Status::kOk);
  EXPECT_EQ(corridor_->count, 3);
}

TEST_F(CorridorStageTest, AWayBackIsALineThatIsAPoint) {
  const MarkedWorld world({80, 40, 40}, 0.1, 0.2);
  set_path({{1.0, 2.0, 2.0}, {3.0, 2.0, 2.0}, {1.0, 2.0, 2.0}, {7.0, 2.0, 2.0}});
  ASSERT_EQ(run(world, 1), Status::kOk);
  ASSERT_EQ(corridor_->count, 2);
  expect_same(corridor_->polyhedra[0].to, {1.0, 2.0, 2.0});
}

TEST_F(CorridorStageTest, ALongLegIsCutIntoEqualPieces) {
  const MarkedWorld world({300, 40, 40}, 0.1, 0.2);
  set_path({{28.1, 2.3, 1.7}, {0.3, 2.1, 1.9}});
  ASSERT_EQ(run(world, 100), Status::kOk);
  ASSERT_EQ(corridor_->count, 4);
  expect_chain();
  for (int i = 0; i < 4; ++i) {
    const Polyhedron& p = corridor_->polyhedra[i];
    EXPECT_NEAR(norm3(minus3(p.to, p.from)), std::sqrt(27.8 * 27.8 + 0.2 * 0.2 + 0.2 * 0.2) / 4.0, 1e-9);
  }
}

/// Out of a passage, aside, and back. Without time, the polyhedron of the passage spans all that.
TEST_F(CorridorStageTest, AWayInTimeSkipsNoPlaceOutsideItsPolyhedra) {
  MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  for (int x = 15; x < 40; ++x) {
    for (int y = 0; y < 40; ++y) {
      for (int z = 0; z < 40; ++z) {
        if (y < 15 || y >= 25 || z < 15 || z >= 25) world.mark(x, y, z);
      }
    }
  }
  set_path({{3.0, 2.0, 2.0},
            {1.7, 2.0, 2.0},
            {0.8, 2.0, 2.0},
            {0.8, 3.2, 2.0},
            {0.8, 2.0, 2.0},
            {1.7, 2.0, 2.0},
            {2.8, 2.0, 2.0},
            {3.5, 2.0, 2.0}});
  int skipped[2] = {};
  for (int is_timed = 0; is_timed < 2; ++is_timed) {
    ASSERT_EQ(run(world, 1000, 0, is_timed == 1), Status::kOk);
    expect_chain();
    int polyhedron = 0;
    for (int k = 1; k + 1 < path_->count; ++k) {
      skipped[is_timed] += inside(corridor_->polyhedra[polyhedron], path_->points[k]) ? 0 : 1;
      if (norm3(minus3(corridor_->polyhedra[polyhedron].to, path_->points[k])) == 0.0) ++polyhedron;
    }
  }
  EXPECT_GT(skipped[0], 0);
  EXPECT_EQ(skipped[1], 0);
}

TEST_F(CorridorStageTest, ABlockedLegSaysSo) {
  MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  world.mark(20, 20, 20);
  set_path({{0.5, 0.5, 0.5}, {0.5, 2.0, 2.0}, {3.5, 2.0, 2.0}});
  EXPECT_EQ(run(world, 100), Status::kCorridorBlocked);
}

TEST_F(CorridorStageTest, APathOutsideTheBoundarySaysSo) {
  const MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  set_path({{0.5, 0.5, 0.5}, {5.0, 2.0, 2.0}});
  EXPECT_EQ(run(world, 100), Status::kOutOfMap);
}

TEST_F(CorridorStageTest, NoWorkIsNoProgress) {
  const MarkedWorld world({40, 40, 40}, 0.1, 0.2);
  set_path({{0.5, 0.5, 0.5}, {2.0, 2.0, 2.0}});
  corridor_begin(*stage_, *path_);
  for (int i = 0; i < 5; ++i) {
    Work none{0};
    EXPECT_EQ(corridor_advance(*stage_, tern::World(world.grid), *path_, none, *corridor_), tern::Progress::kMore);
  }
  EXPECT_EQ(stage_->growth.phase, tern::GrowPhase::kBox);
}

TEST_F(CorridorStageTest, SlicesChangeNoBit) {
  Random random(5);
  MarkedWorld world({80, 80, 30}, 0.1, 0.1);
  for (int i = 0; i < 300; ++i) world.mark(random.integer(0, 79), random.integer(0, 79), random.integer(0, 29));
  for (int x = 0; x < 80; ++x) {
    for (int y = 38; y < 43; ++y) {
      for (int z = 12; z < 18; ++z) world.clear(x, y, z);
    }
  }
  set_path({{0.5, 4.05, 1.5}, {3.0, 4.05, 1.5}, {7.5, 4.04, 1.5}});
  ASSERT_EQ(run(world, 1000, 0), Status::kOk);
  const auto whole = std::make_unique<Corridor>(*corridor_);
  ASSERT_EQ(run(world, 1), Status::kOk);
  ASSERT_EQ(corridor_->count, whole->count);
  for (int i = 0; i < whole->count; ++i) {
    const Polyhedron& a = whole->polyhedra[i];
    const Polyhedron& b = corridor_->polyhedra[i];
    ASSERT_EQ(a.count, b.count);
    EXPECT_EQ(std::memcmp(a.planes, b.planes, sizeof(tern::Halfspace) * static_cast<std::size_t>(a.count)), 0);
  }
}

}  // namespace
}  // namespace tern_test
