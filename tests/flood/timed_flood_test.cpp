// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The flood in time: what its ways promise, and the scenes that it is for.
#include "flood/timed_flood.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

#include "base/bounds.hpp"
#include "flood/timed_way.hpp"
#include "support/random.hpp"
#include "support/world.hpp"

namespace {

using namespace tern;
using tern_test::Random;
using tern_test::World;

constexpr std::int64_t kNano = 1000000000;

/// 8 x 4 x 2 m with cells of 0.4 m; a metre a second, with much acceleration.
class Floods : public testing::Test {
 protected:
  Floods() : world_({80, 40, 20}, 0.1, 0.2) {
    world_.grid.inflate();
    query_.from = {0.6, 2.0, 1.0};
    query_.to = {7.4, 2.0, 1.0};
    query_.fastest = {1.0, 1.0, 1.0};
    query_.strongest = {10.0, 10.0, 10.0};
    query_.sharpest = {kUnlimited, kUnlimited, kUnlimited};
    query_.longest = 20.0;
    query_.share = 1.0;
    query_.edge = 4;
  }

  Progress run(std::uint32_t slice = 0xFFFFFFFFu) {
    query_.things = {tracks_.data(), static_cast<std::int32_t>(tracks_.size()), 0.2, kZero, 0};
    if (timed_flood_begin(*flood_, world_.grid, query_) != Status::kRunning) return Progress::kFailed;
    Progress progress = Progress::kMore;
    while (progress == Progress::kMore) {
      Work work{slice};
      progress = timed_flood_advance(*flood_, world_.grid, work);
    }
    return progress;
  }

  double arrival() const { return flood_->arrival * flood_->step; }

  /// Each step is at most a cell along each axis, to a cell that is free and not near a thing then.
  void expect_way() const {
    const FloodLattice& lattice = flood_->lattice;
    for (std::int32_t k = 1; k <= flood_->arrival; ++k) {
      const Voxel& a = flood_->way[k - 1];
      const Voxel& b = flood_->way[k];
      EXPECT_LE(std::abs(a.x - b.x), 1);
      EXPECT_LE(std::abs(a.y - b.y), 1);
      EXPECT_LE(std::abs(a.z - b.z), 1);
      EXPECT_TRUE(has_cell(lattice, flood_->words, b));
      if (k == flood_->arrival) continue;
      for (const Track& track : tracks_) {
        Vec3 place{};
        double need = 0.0;
        if (!thing_now(query_.things, track, k * flood_->step, place, need)) continue;
        const Vec3 from = middle_of(lattice, world_.grid, b) - place;
        EXPECT_GE(distance(from, closest_in(query_.things, track, from)), need + query_.more * lattice.size - 1e-9);
      }
    }
    const Voxel goal = cell_at(lattice, world_.grid, query_.to);
    const Voxel& last = flood_->way[flood_->arrival];
    EXPECT_TRUE(last.x == goal.x && last.y == goal.y && last.z == goal.z);
  }

  World world_;
  FloodQuery query_{};
  std::vector<Track> tracks_;
  std::unique_ptr<TimedFlood> flood_ = std::make_unique<TimedFlood>();
};

TEST_F(Floods, TakeTheShortestTimeIfNothingMoves) {
  ASSERT_EQ(run(), Progress::kDone);
  expect_way();
  // 17 cells of 0.4 m, and at both ends 0.05 s more for the acceleration.
  EXPECT_GE(arrival(), 6.8);
  EXPECT_LE(arrival(), 6.8 + 2 * 0.4);
  tracks_.clear();
  query_.longest = 6.0;
  EXPECT_EQ(run(), Progress::kFailed);
}

/// With little acceleration, a start and a goal at rest take longer than vias that are passed.
TEST_F(Floods, InFlightNeitherGainNorBrake) {
  query_.strongest = {0.5, 0.5, 0.5};
  ASSERT_EQ(run(), Progress::kDone);
  const double from_rest = arrival();
  query_.begins_in_flight = true;
  ASSERT_EQ(run(), Progress::kDone);
  const double to_rest = arrival();
  query_.ends_in_flight = true;
  ASSERT_EQ(run(), Progress::kDone);
  expect_way();
  EXPECT_LT(to_rest, from_rest);
  EXPECT_LT(arrival(), to_rest);
  EXPECT_GE(arrival(), 6.8 - 1e-9);
}

/// Four layers for two steps: no way is more than a step too far along x, or two beside.
TEST_F(Floods, LeaveOutWhatIsTooFarOff) {
  query_.from = {4.0, 2.0, 1.0};
  query_.to = {4.8, 2.0, 1.0};
  ASSERT_EQ(run(), Progress::kDone);
  const double soonest = arrival();
  EXPECT_EQ(flood_->lattice.cells.x, 19);
  EXPECT_EQ(flood_->lattice.cells.y, 9);
  query_.longest = 1.3;
  ASSERT_EQ(run(), Progress::kDone);
  expect_way();
  EXPECT_EQ(arrival(), soonest);
  EXPECT_EQ(flood_->lattice.cells.x, 5);
  EXPECT_EQ(flood_->lattice.cells.y, 5);
}

TEST_F(Floods, WaitUntilTheWayOpens) {
  Track wall;
  wall.position = {4.0, 2.0, 1.0};
  wall.shape = TrackShape::kBox;
  wall.half = {0.1, 3.0, 3.0};
  wall.end = TrackEnd::kGone;
  wall.until = 9 * kNano;
  tracks_ = {wall};
  ASSERT_EQ(run(), Progress::kDone);
  expect_way();
  // Before the wall at 3.7 m until it is gone, then 3.7 m on.
  EXPECT_GT(arrival(), 9.0 + 3.2);
  EXPECT_LT(arrival(), 9.0 + 5.0);
  tracks_[0].end = TrackEnd::kGoesOn;
  EXPECT_EQ(run(), Progress::kFailed);
}

TEST_F(Floods, ArriveWhenTheGoalStaysClear) {
  Track thing;
  thing.radius = 0.3;
  // It passes the goal at 9 s; the goal is not clear from 8.5 s to 9.5 s.
  thing.position = {7.4, 2.0 - 9.0, 1.0};
  thing.velocity = {0.0, 1.0, 0.0};
  tracks_ = {thing};
  query_.rest = 1.0;
  ASSERT_EQ(run(), Progress::kDone);
  EXPECT_LT(arrival(), 7.6);
  query_.rest = 3.0;
  ASSERT_EQ(run(), Progress::kDone);
  expect_way();
  EXPECT_GE(arrival(), 9.5);
  EXPECT_LT(arrival(), 11.0);
}

TEST_F(Floods, BackOutOfATunnelAndSlicesChangeNothing) {
  // A tunnel 0.8 m wide from x = 2 to 6, and a thing that comes through it towards the start, which is inside.
  for (std::int32_t x = 20; x < 60; ++x) {
    for (std::int32_t y = 0; y < 40; ++y) {
      for (std::int32_t z = 0; z < 20; ++z) {
        if (y < 14 || y >= 26) world_.grid.mark_voxel({x, y, z});
      }
    }
  }
  world_.grid.inflate();
  query_.from = {3.0, 2.0, 1.0};
  Track thing;
  thing.shape = TrackShape::kCylinder;
  thing.radius = 0.4;
  thing.half.z = 2.0;
  thing.position = {7.0, 2.0, 1.0};
  thing.velocity = {-0.5, 0.0, 0.0};
  tracks_ = {thing};
  query_.longest = 60.0;
  query_.share = 0.9;
  ASSERT_EQ(run(), Progress::kDone);
  expect_way();
  double least = 9.0;
  for (std::int32_t k = 0; k <= flood_->arrival; ++k) {
    least = std::min(least, middle_of(flood_->lattice, world_.grid, flood_->way[k]).x);
  }
  EXPECT_LT(least, 2.0);
  const std::vector<Voxel> whole(flood_->way, flood_->way + flood_->arrival + 1);
  ASSERT_EQ(run(1), Progress::kDone);
  for (std::size_t k = 0; k < whole.size(); ++k) {
    EXPECT_EQ(std::memcmp(&whole[k], &flood_->way[k], sizeof(Voxel)), 0);
  }
}

TEST_F(Floods, KeepWhatTheStartsVelocityAllows) {
  query_.velocity = {-1.0, 0.0, 0.0};
  query_.from = {3.0, 2.0, 1.0};
  query_.strongest = {1.0, 1.0, 1.0};
  ASSERT_EQ(run(), Progress::kDone);
  // It flies back for a second and half a metre before it turns, and needs half a second more at the goal.
  EXPECT_GT(arrival(), 4.4 + 1.0 + 0.5);
  EXPECT_LT(arrival(), 4.4 + 1.0 + 0.5 + 0.5 + 3 * 0.4);
}

/// A limit on jerk delays the ways that begin and end at rest: here, taking up the acceleration takes two seconds.
TEST_F(Floods, KeepWhatALimitOnJerkAllows) {
  query_.strongest = {1.0, 1.0, 1.0};
  ASSERT_EQ(run(), Progress::kDone);
  const double sudden = arrival();
  query_.sharpest = {0.25, 0.25, 0.25};
  ASSERT_EQ(run(), Progress::kDone);
  EXPECT_GT(arrival(), sudden + 1.5);
  EXPECT_LT(arrival(), sudden + 4.5);
  expect_way();
}

TEST_F(Floods, TooManyCellsAreAReason) {
  World large({512, 512, 64}, 0.1, 0.0);
  large.grid.inflate();
  query_.edge = 1;
  query_.from = {0.05, 0.05, 0.05};
  query_.to = {51.0, 51.0, 6.0};
  query_.longest = 70.0;
  query_.things = Things{};
  EXPECT_EQ(timed_flood_begin(*flood_, large.grid, query_), Status::kFloodFull);
}

TEST_F(Floods, WaysHaveFreeLegsWithTimes) {
  Random random(5);
  const int cases = tern_test::scaled(30);
  int found = 0;
  for (int n = 0; n < cases; ++n) {
    tracks_.assign(static_cast<std::size_t>(random.integer(1, 8)), Track{});
    for (Track& track : tracks_) {
      track.position = {random.real(1.5, 7.0), random.real(-1.0, 5.0), random.real(0.0, 2.0)};
      track.velocity = {random.real(-0.5, 0.5), random.real(-0.5, 0.5), 0.0};
      track.radius = 0.2;
    }
    query_.more = 0.25;
    if (run() != Progress::kDone) continue;
    expect_way();
    TimedWay way;
    way.count = 0;
    timed_way_begin(*flood_, kMaxSegments, way);
    Work work{0xFFFFFFFFu};
    ASSERT_EQ(timed_way_advance(*flood_, world_.grid, way, work), Progress::kDone);
    double time = 0.0;
    for (std::int32_t i = 0; i < way.count; ++i) {
      const bool rests = distance(way.points[i], way.points[i + 1]) < 0.4;
      EXPECT_LE(way.duration[i], rests ? 3.0 * kLongestLeg + flood_->step : kLongestLeg + flood_->step);
      time += way.duration[i];
    }
    EXPECT_NEAR(time, arrival(), 1e-9);
    EXPECT_EQ(distance(way.points[0], query_.from), 0.0);
    EXPECT_EQ(distance(way.points[way.count], query_.to), 0.0);
    ++found;
  }
  EXPECT_GT(found, cases / 2);
}

}  // namespace
