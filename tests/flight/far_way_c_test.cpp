// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A far way through C: the same near goals as through C++, and an answer to every call that comes too early or is
// wrong.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "tern/tern_far_way.h"

namespace {

constexpr std::uint8_t kDone = 0;
constexpr auto kRefused = static_cast<std::uint8_t>(tern::Status::kInvalidArgument);
constexpr auto kNotFinite = static_cast<std::uint8_t>(tern::Status::kNonFiniteInput);
constexpr tern_far_way_spec kAhead{40.0, 10000000000};

/// A wall in a coarse grid of 96 x 96 x 16 m, with a way around one end.
struct CoarseInC {
  CoarseInC() : memory(new tern::Workspace) {
    const tern_grid_spec spec{{0, 0, 0}, 4.0, {24, 24, 4}, {{0, 0, 0}, {96, 96, 16}}, 0.0, 0.0};
    words.resize(tern_grid_words(spec.dims));
    EXPECT_EQ(tern_grid_bind(&grid, &spec, words.data(), words.size()), kDone);
    const tern_box wall{{40, 0, 0}, {44, 80, 16}};
    EXPECT_EQ(tern_grid_mark_box(&grid, &wall), kDone);
    tern_grid_inflate(&grid);
    EXPECT_EQ(tern_planner_init(&planner, memory.get(), sizeof *memory), kDone);
  }

  tern_grid grid{};
  std::vector<std::uint64_t> words;
  std::unique_ptr<tern::Workspace> memory;
  tern_planner planner{};
  tern_map map{};  ///< never bound: nothing is seen
};

TEST(FarWayC, GivesTheSameNearGoals) {
  CoarseInC c;
  CoarseInC cpp;
  const tern_vec3 goal{90, 10, 6};
  tern_far_way far_way{};
  ASSERT_EQ(tern_far_way_start(&far_way, &kAhead, &c.grid, &c.planner), kDone);
  ASSERT_EQ(tern_far_way_set_goal(&far_way, &goal), kDone);
  tern::Grid& grid = *reinterpret_cast<tern::Grid*>(cpp.grid.opaque + 1);
  tern::Planner planner(cpp.memory.get(), sizeof *cpp.memory);
  tern::FarWay way;
  ASSERT_EQ(way.start(kAhead, grid, planner), tern::Status::kOk);
  ASSERT_EQ(way.set_goal(goal), tern::Status::kOk);
  const tern_flight_report report{};
  tern_vec3 at{10, 10, 6};
  int told = 0;
  for (int k = 0; k < 100 && (told == 0 || !tern_far_way_is_last(&far_way)); ++k) {
    tern_vec3 near_goal{};
    const bool is_new = tern_far_way_tick(&far_way, &at, &report, &c.map, k, 100000, &near_goal);
    ASSERT_EQ(is_new, way.tick(at, report, tern::RollingMap{}, k, 100000));
    EXPECT_EQ(tern_far_way_state(&far_way), static_cast<std::uint8_t>(way.state()));
    EXPECT_EQ(tern_far_way_left(&far_way), way.left());
    if (!is_new) continue;
    EXPECT_EQ(near_goal.x, way.near_goal().x);
    EXPECT_EQ(near_goal.y, way.near_goal().y);
    at = near_goal;
    ++told;
  }
  EXPECT_GT(told, 2);
  EXPECT_TRUE(way.is_last());
  EXPECT_EQ(tern_far_way_searches(&far_way), 1);
  EXPECT_EQ(tern_far_way_marked(&far_way), 0);
}

TEST(FarWayC, AnswersWhatIsWrong) {
  CoarseInC c;
  tern_far_way far_way{};
  const tern_vec3 goal{90, 10, 6};
  tern_vec3 near_goal{1, 2, 3};
  const tern_flight_report report{};
  EXPECT_EQ(tern_far_way_set_goal(&far_way, &goal), kRefused);
  EXPECT_FALSE(tern_far_way_tick(&far_way, &goal, &report, &c.map, 0, 1000, &near_goal));
  EXPECT_TRUE(tern_far_way_is_last(&far_way));
  EXPECT_EQ(tern_far_way_state(&far_way), TERN_FAR_NO_GOAL);
  EXPECT_EQ(tern_far_way_left(nullptr), 0.0);
  EXPECT_EQ(tern_far_way_searches(nullptr), 0);
  EXPECT_EQ(tern_far_way_marked(nullptr), 0);
  const tern_far_way_spec none{0.0, 1};
  tern_grid unbound{};
  EXPECT_EQ(tern_far_way_start(&far_way, &none, &c.grid, &c.planner), kRefused);
  const tern_far_way_spec near{11.9, 1};
  EXPECT_EQ(tern_far_way_start(&far_way, &near, &c.grid, &c.planner), kRefused);
  const tern_far_way_spec far{1024.1, 1};
  EXPECT_EQ(tern_far_way_start(&far_way, &far, &c.grid, &c.planner), kRefused);
  EXPECT_EQ(tern_far_way_start(&far_way, &kAhead, &unbound, &c.planner), kRefused);
  EXPECT_EQ(tern_far_way_start(&far_way, &kAhead, &c.grid, nullptr), kRefused);
  EXPECT_EQ(tern_far_way_start(&far_way, nullptr, &c.grid, &c.planner), kRefused);
  EXPECT_EQ(tern_far_way_start(nullptr, &kAhead, &c.grid, &c.planner), kRefused);
  ASSERT_EQ(tern_far_way_start(&far_way, &kAhead, &c.grid, &c.planner), kDone);
  EXPECT_EQ(tern_far_way_set_goal(&far_way, nullptr), kRefused);
  const tern_vec3 nowhere{std::numeric_limits<double>::infinity(), 0, 0};
  EXPECT_EQ(tern_far_way_set_goal(&far_way, &nowhere), kNotFinite);
  ASSERT_EQ(tern_far_way_set_goal(&far_way, &goal), kDone);
  EXPECT_FALSE(tern_far_way_tick(&far_way, &goal, &report, &c.map, 0, 1000, nullptr));
  EXPECT_FALSE(tern_far_way_tick(&far_way, nullptr, &report, &c.map, 0, 1000, &near_goal));
  EXPECT_FALSE(tern_far_way_tick(&far_way, &goal, nullptr, &c.map, 0, 1000, &near_goal));
  EXPECT_FALSE(tern_far_way_tick(&far_way, &goal, &report, nullptr, 0, 1000, &near_goal));
  EXPECT_EQ(near_goal.x, 1.0);
}

}  // namespace
