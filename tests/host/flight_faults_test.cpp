// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What goes wrong in a simulated flight goes wrong as its settings say.
#include "host/flight/flight_faults.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using tern_host::FlightFaults;
using tern_host::FlightWorld;

FlightWorld hall() {
  FlightWorld world;
  world.boundary = {{-10.0, -10.0, 0.0}, {50.0, 10.0, 4.0}};
  world.goal = {40.0, 0.0, 1.5};
  return world;
}

/// Along x at 2 m/s, for 3 s and 6 m.
tern::Sample at_two_metres_a_second(std::int64_t t) {
  const double s = std::clamp(1e-9 * static_cast<double>(t), 0.0, 3.0);
  tern::Sample sample{};
  sample.position = {2.0 * s, 1.0, 1.5};
  sample.velocity.x = t < 3000000000 ? 2.0 : 0.0;
  return sample;
}

TEST(FlightFaults, SkipsTicksInRuns) {
  for (const auto& [share, longest] : std::vector<std::pair<double, int>>{{0.3, 1}, {0.5, 5}, {0.9, 50}, {0.1, 50}}) {
    FlightWorld world = hall();
    world.settings.tick_skip = {share, longest};
    FlightFaults faults(world);
    constexpr int kTicks = 200000;
    int skipped = 0;
    int run = 0;
    int longest_run = 0;
    EXPECT_FALSE(faults.skips_tick());
    for (int k = 1; k < kTicks; ++k) {
      const bool skips = faults.skips_tick();
      skipped += skips ? 1 : 0;
      run = skips ? run + 1 : 0;
      longest_run = std::max(longest_run, run);
    }
    EXPECT_NEAR(static_cast<double>(skipped) / kTicks, share, 0.02) << share << " " << longest;
    EXPECT_EQ(longest_run, longest) << share << " " << longest;
  }
  FlightWorld world = hall();
  FlightFaults none(world);
  for (int k = 0; k < 1000; ++k) EXPECT_FALSE(none.skips_tick());
}

TEST(FlightFaults, MovesTheGoalAtEveryTickAndBack) {
  FlightWorld world = hall();
  world.settings.goal_jitter = {2.0, 1.0};
  FlightFaults faults(world);
  double worst = 0.0;
  tern::Vec3 goal{};
  tern::Vec3 before{};
  for (int k = 0; k < 100; ++k) {
    ASSERT_TRUE(faults.moves_goal(0.01 * k, goal));
    EXPECT_NE(goal.x, before.x);
    before = goal;
    worst = std::max({worst, std::abs(goal.x - world.goal.x), std::abs(goal.y - world.goal.y)});
  }
  EXPECT_LE(worst, 2.0);
  EXPECT_GT(worst, 1.8);
  ASSERT_TRUE(faults.moves_goal(1.0, goal));
  EXPECT_EQ(goal.x, world.goal.x);
  EXPECT_EQ(goal.y, world.goal.y);
  EXPECT_FALSE(faults.moves_goal(1.01, goal));
}

TEST(FlightFaults, ObstaclesAppearInTime) {
  FlightWorld world = hall();
  world.appearing.push_back({0.5, true, {{3.0, 0.0, 0.0}, {4.0, 1.0, 2.0}}, {}});
  world.appearing.push_back({0.25, false, {}, {8.0, 0.0, 0.0, 4.0, 0.5}});
  FlightFaults faults(world);
  EXPECT_FALSE(faults.appear(249999999, at_two_metres_a_second));
  EXPECT_TRUE(faults.appear(250000000, at_two_metres_a_second));
  EXPECT_EQ(world.cylinders.size(), 1u);
  EXPECT_EQ(world.blocks.size(), 0u);
  EXPECT_TRUE(faults.appear(600000000, at_two_metres_a_second));
  EXPECT_EQ(world.blocks.size(), 1u);
  EXPECT_FALSE(faults.appear(700000000, at_two_metres_a_second));
  ASSERT_EQ(faults.appeared().size(), 2u);
  EXPECT_NEAR(faults.appeared()[1].time, 0.6, 1e-12);
  EXPECT_EQ(distance_to(faults.appeared()[1], {3.5, 3.0, 1.0}), 2.0);
}

/// The pillar's surface is as far ahead as told: on the way, or straight behind its end.
TEST(FlightFaults, APillarAppearsAhead) {
  for (const double distance : {0.5, 2.0, 9.0}) {
    FlightWorld world = hall();
    world.settings.appear_ahead = {1.0, distance};
    FlightFaults faults(world);
    EXPECT_FALSE(faults.appear(990000000, at_two_metres_a_second));
    ASSERT_TRUE(faults.appear(1000000000, at_two_metres_a_second));
    EXPECT_FALSE(faults.appear(1010000000, at_two_metres_a_second));
    const tern_host::Cylinder& pillar = world.cylinders.front();
    EXPECT_NEAR(pillar.x - pillar.radius, 2.0 + distance, 0.01) << distance;
    EXPECT_NEAR(pillar.y, 1.0, 1e-9);
    EXPECT_EQ(pillar.bottom, 0.0);
    EXPECT_EQ(pillar.top, 4.0);
  }
}

TEST(FlightFaults, NothingIsAheadOfAVehicleThatRests) {
  FlightWorld world = hall();
  world.settings.appear_ahead = {5.0, 1.0};
  FlightFaults faults(world);
  EXPECT_FALSE(faults.appear(6000000000, at_two_metres_a_second));
}

}  // namespace
