// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// F19: every way for a map to change between the slices of a plan. Storage is as long as its grid needs, so that a
// sanitizer sees any read past a smaller grid's.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/grid_storage.hpp"
#include "support/world.hpp"

namespace {

using tern::Field;
using tern::Grid;
using tern::Status;
using tern_test::World;

constexpr tern::Box kWall{{2.0, 0.0, 0.0}, {2.2, 3.4, 2.0}};

/// A plan around a wall, begun and some steps on.
class MapChanged : public ::testing::Test {
 protected:
  MapChanged() : world({40, 40, 20}, 0.1, 0.1) {
    world.from({0.55, 0.55, 1.05}).to({3.45, 0.55, 1.05});
    stand(world.grid, kWall);
  }

  void SetUp() override {
    ASSERT_EQ(world.replan(), Status::kOk);
    ASSERT_EQ(world.planner.begin(world.grid, world.request), Status::kRunning);
    ASSERT_EQ(world.planner.step(3), Status::kRunning);
  }

  static void stand(Grid& grid, const tern::Box& wall) {
    ASSERT_EQ(grid.mark_box(wall), Status::kOk);
    grid.inflate();
  }

  Status bind_again(Grid& grid) { return grid.bind(world.spec, world.words.data(), world.words.size()); }

  void zero_storage() { std::fill(world.words.begin(), world.words.end(), 0); }

  Status rest() {
    Status status = Status::kRunning;
    for (int k = 0; k < 1000000 && status == Status::kRunning; ++k) status = world.planner.step(50);
    return status;
  }

  void expect_changed() {
    EXPECT_EQ(world.planner.step(0), Status::kMapChanged);
    std::memset(static_cast<void*>(&world.trajectory), 0x5A, sizeof world.trajectory);
    EXPECT_EQ(world.planner.finish(world.trajectory, world.report), Status::kMapChanged);
    EXPECT_TRUE(world.trajectory_untouched());
  }

  World world;
};

TEST_F(MapChanged, NotWithoutAChange) {
  EXPECT_EQ(rest(), Status::kOk);
}

TEST_F(MapChanged, MarkedThroughACopy) {
  Grid copy = world.grid;
  stand(copy, {{3.0, 0.2, 0.0}, {3.2, 0.4, 1.0}});
  expect_changed();
}

TEST_F(MapChanged, MarkedAndClearedThroughACopy) {
  Grid copy = world.grid;
  ASSERT_EQ(copy.mark_voxel({1, 1, 1}), Status::kOk);
  ASSERT_EQ(copy.clear_voxel({1, 1, 1}), Status::kOk);
  copy.inflate();
  expect_changed();
}

TEST_F(MapChanged, BoundToSmallerStorageWithAsManyMarks) {
  tern::GridSpec spec = tern_test::whole_grid({5, 5, 3}, 0.1, 0.1);
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  ASSERT_EQ(world.grid.bind(spec, words.data(), words.size()), Status::kOk);
  stand(world.grid, kWall);
  expect_changed();
}

TEST_F(MapChanged, ANewGridInItsPlaceOverOtherStorage) {
  std::vector<std::uint64_t> words(world.words.size());
  world.grid = Grid();
  ASSERT_EQ(world.grid.bind(world.spec, words.data(), words.size()), Status::kOk);
  stand(world.grid, kWall);
  expect_changed();
}

TEST_F(MapChanged, ANewGridInItsPlaceOverTheSameStorage) {
  world.grid = Grid();
  ASSERT_EQ(bind_again(world.grid), Status::kOk);
  stand(world.grid, kWall);
  expect_changed();
}

TEST_F(MapChanged, NoGridInItsPlace) {
  world.grid = Grid();
  expect_changed();
}

TEST_F(MapChanged, StorageBoundThroughAnotherGrid) {
  Grid other;
  ASSERT_EQ(bind_again(other), Status::kOk);
  stand(other, kWall);
  expect_changed();
  EXPECT_EQ(world.replan(), Status::kInvalidArgument);
  EXPECT_EQ(world.report.field, Field::kStorage);
}

TEST_F(MapChanged, StorageOverwritten) {
  zero_storage();
  expect_changed();
}

TEST_F(MapChanged, CountersThatCoincideHideNoOtherContent) {
  zero_storage();
  world.grid = Grid();
  ASSERT_EQ(bind_again(world.grid), Status::kOk);
  stand(world.grid, {{1.5, 0.5, 0.0}, {1.7, 4.0, 2.0}});
  expect_changed();
}

TEST_F(MapChanged, CountersThatCoincideHideNoMissingInflation) {
  zero_storage();
  world.grid = Grid();
  ASSERT_EQ(bind_again(world.grid), Status::kOk);
  ASSERT_EQ(world.grid.mark_box(kWall), Status::kOk);
  expect_changed();
}

TEST_F(MapChanged, CountersThatCoincideHideNoOtherSpec) {
  zero_storage();
  world.grid = Grid();
  world.spec.origin.z += 0.5;
  world.spec.boundary.lower.z += 0.5;
  world.spec.boundary.upper.z += 0.5;
  ASSERT_EQ(bind_again(world.grid), Status::kOk);
  ASSERT_EQ(world.grid.mark_box({{2.0, 0.0, 0.5}, {2.2, 3.4, 2.5}}), Status::kOk);
  world.grid.inflate();
  expect_changed();
}

/// Nobody can tell this map from the one before, and nothing is other than it was.
TEST_F(MapChanged, TheSameMapMadeAgainInZeroedStorageGivesTheSamePlan) {
  zero_storage();
  world.grid = Grid();
  ASSERT_EQ(bind_again(world.grid), Status::kOk);
  stand(world.grid, kWall);
  ASSERT_EQ(rest(), Status::kOk);
  tern::Trajectory made{};
  ASSERT_EQ(world.planner.finish(made, world.report), Status::kOk);
  ASSERT_EQ(world.replan(), Status::kOk);
  EXPECT_EQ(std::memcmp(&made.segments[0], &world.trajectory.segments[0], sizeof made.segments[0]), 0);
}

}  // namespace
