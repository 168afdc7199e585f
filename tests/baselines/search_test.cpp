// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "baselines/paper_search.hpp"
#include "baselines/plain_astar.hpp"
#include "baselines/plain_jps.hpp"
#include "host/scenario.hpp"
#include "support/path_world.hpp"

namespace {

using tern::Vec3;
using tern::Voxel;
using tern_bench::PaperMap;
using tern_bench::Route;

tern_host::Scenario scenario(const std::string& blocks) {
  return tern_host::parse_scenario("boundary 0 0 0 4 4 1\n" + blocks + "start 0.5 0.5 0.5\ngoal 3.5 0.5 0.5\n", "test");
}

std::string four_decimals(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4f", value);
  return text;
}

TEST(PaperMap, GrowsCuboidsByTheMarginAndTakesEveryVoxelTouched) {
  const PaperMap map(scenario("block 1.5 1.5 0 2 2 1\n"), 1.0, 0.25);
  EXPECT_EQ(map.cells(), 16u);
  // From 1.25 to 2.25: voxels 1 and 2 along both axes.
  EXPECT_TRUE(map.obstacle({1, 1, 0}));
  EXPECT_TRUE(map.obstacle({2, 2, 0}));
  EXPECT_FALSE(map.obstacle({3, 2, 0}));
  EXPECT_FALSE(map.obstacle({0, 1, 0}));
  EXPECT_FALSE(map.free({4, 0, 0}));
  EXPECT_FALSE(map.obstacle({4, 0, 0}));
}

TEST(PaperMap, PointsOutsideBelongToTheNearestVoxel) {
  const PaperMap map(scenario(""), 1.0, 0.0);
  const Voxel v = map.voxel_of({-3.0, 9.0, 0.5});
  EXPECT_EQ(v.x, 0);
  EXPECT_EQ(v.y, 3);
  EXPECT_EQ(v.z, 0);
}

/// Table 4 of the paper, as printed.
struct PrintedRow {
  int map;
  const char* jump_points;  // null where the printed cell is another method's
  std::size_t jump_count;
  const char* shortened;
  std::size_t shortened_count;
};

class PaperTable4 : public testing::TestWithParam<PrintedRow> {};

TEST_P(PaperTable4, ComesOutToThePrintedDigit) {
  const PrintedRow& row = GetParam();
  const tern_host::Scenario map_scenario =
      tern_host::read_scenario(TERN_SOURCE_DIR "/bench/maps/map" + std::to_string(row.map) + ".txt");
  const PaperMap map(map_scenario, tern_bench::kPaperCell, tern_bench::kPaperMargin);
  const Route route = tern_bench::greedy_jump_search(map, map_scenario.start.position, map_scenario.goal.position);
  ASSERT_TRUE(route.found);
  if (row.jump_points != nullptr) {
    EXPECT_EQ(four_decimals(tern_bench::length(route.points)), row.jump_points);
  }
  EXPECT_EQ(route.points.size(), row.jump_count);
  const std::vector<Vec3> shortened = tern_bench::shorten_by_sight(map, route.points);
  EXPECT_EQ(four_decimals(tern_bench::length(shortened)), row.shortened);
  EXPECT_EQ(shortened.size(), row.shortened_count);
}

INSTANTIATE_TEST_SUITE_P(Maps, PaperTable4,
                         testing::Values(PrintedRow{1, "3.7276", 13, "3.4859", 8},
                                         PrintedRow{2, nullptr, 26, "14.2825", 8}),
                         [](const testing::TestParamInfo<PrintedRow>& row) {
                           return "Map" + std::to_string(row.param.map);
                         });

TEST(PaperSearch, GoesStraightWhereNothingIsInTheWay) {
  const PaperMap map(scenario(""), 1.0, 0.0);
  const Route route = tern_bench::greedy_jump_search(map, {0.5, 0.5, 0.5}, {3.5, 0.5, 0.5});
  ASSERT_TRUE(route.found);
  // The goal's voxel is reached in one jump: start, its centre, goal.
  ASSERT_EQ(route.points.size(), 3u);
  EXPECT_DOUBLE_EQ(tern_bench::length(route.points), 3.0);
}

TEST(PaperSearch, FindsNothingBehindAWall) {
  const PaperMap map(scenario("block 2 0 0 3 4 1\n"), 1.0, 0.0);
  EXPECT_FALSE(tern_bench::greedy_jump_search(map, {0.5, 0.5, 0.5}, {3.5, 0.5, 0.5}).found);
  EXPECT_FALSE(tern_bench::six_neighbour_astar(map, {0.5, 0.5, 0.5}, {3.5, 0.5, 0.5}).found);
}

TEST(SixNeighbours, WalksAroundAWallAlongTheAxes) {
  // A wall at x = 1 up to y = 3: up 3, right 3, down 3, between cell centres.
  const PaperMap map(scenario("block 1.1 0 0 1.9 2.9 1\n"), 1.0, 0.0);
  const Route route = tern_bench::six_neighbour_astar(map, {0.5, 0.5, 0.5}, {3.5, 0.5, 0.5});
  ASSERT_TRUE(route.found);
  EXPECT_DOUBLE_EQ(tern_bench::length(route.points), 9.0);
  // Nine voxels after the start's own, and both exact ends.
  EXPECT_EQ(route.points.size(), 11u);
}

TEST(Shortening, KeepsTheCornerOnly) {
  const PaperMap map(scenario("block 1.1 0 0 2.9 2.9 1\n"), 1.0, 0.0);
  const std::vector<Vec3> chain{{0.5, 0.5, 0.5}, {0.5, 1.5, 0.5}, {0.5, 3.5, 0.5}, {1.5, 3.5, 0.5}, {3.5, 3.5, 0.5}};
  const std::vector<Vec3> kept = tern_bench::shorten_by_sight(map, chain);
  ASSERT_EQ(kept.size(), 3u);
  EXPECT_DOUBLE_EQ(kept[1].x, 0.5);
  EXPECT_DOUBLE_EQ(kept[1].y, 3.5);
}

TEST(Shortening, LeavesTwoPointsAlone) {
  const PaperMap map(scenario(""), 1.0, 0.0);
  EXPECT_EQ(tern_bench::shorten_by_sight(map, {{0.5, 0.5, 0.5}, {3.5, 0.5, 0.5}}).size(), 2u);
}

TEST(PlainJps, CostsWhatPlainAStarCosts) {
  tern_test::Random random(7);
  int solved = 0;
  for (int k = 0; k < tern_test::scaled(400); ++k) {
    const tern_test::VoxelWorld world = tern_test::random_world(random);
    Voxel start{}, goal{};
    if (!tern_test::random_ends(world.grid, random, start, goal)) continue;
    tern_bench::PlainAStar astar(world.grid);
    tern_bench::PlainJps jps(world.grid);
    const bool found = astar.run(start, goal);
    ASSERT_EQ(jps.run(start, goal), found) << "case " << k;
    if (!found) continue;
    ++solved;
    EXPECT_EQ(jps.cost(), astar.cost()) << "case " << k;
    EXPECT_TRUE(tern::same(jps.path().front(), start) && tern::same(jps.path().back(), goal));
  }
  EXPECT_GT(solved, tern_test::scaled(400) / 4);
}

}  // namespace
