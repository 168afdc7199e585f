// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Deliveries below the roofs of a city, past a court that a coarse grid knows: with a far way and without one.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/flight/flight_replay.hpp"
#include "host/flight/simulated_flight.hpp"

namespace {

using tern_host::FlightResult;
using tern_host::FlightWorld;
using tern_host::read_flight_world;

TEST(FarWayFlights, AFarWayLeadsPastACourt) {
  const FlightResult led = tern_host::simulate_flight(read_flight_world("Y:1", {}));
  EXPECT_EQ(led.status, "reached") << led.reason;
  EXPECT_EQ(led.far.searches, 1);
  EXPECT_EQ(led.far.marked, 0);
  EXPECT_LT(led.standing, 2.0);
  const std::string limit = "time_limit=" + std::to_string(1.3 * led.time);
  const FlightResult alone = tern_host::simulate_flight(read_flight_world("Y:1", {"far_cell=0", limit}));
  EXPECT_EQ(alone.status, "timeout") << alone.reason;
  EXPECT_EQ(alone.far.searches, 0);
}

/// The world's blocks that are `wall` thick along x are unknown to the coarse grid: what closes streets along x.
FlightWorld without_walls(FlightWorld world, double wall) {
  for (std::size_t k = 0; k < world.blocks.size(); ++k) {
    const tern::Box& b = world.blocks[k];
    if (b.upper.x - b.lower.x <= wall) world.unmapped.push_back(k);
  }
  return world;
}

TEST(FarWayFlights, WhatTheCoarseGridDoesNotKnowItLearns) {
  const FlightWorld world = without_walls(read_flight_world("Y:1", {"far_cell=8"}), 10.0);
  ASSERT_FALSE(world.unmapped.empty());
  const FlightResult led = tern_host::simulate_flight(world);
  EXPECT_EQ(led.status, "reached") << led.reason;
  EXPECT_GT(led.far.marked, 0);
  EXPECT_GT(led.far.searches, 1);
}

TEST(FarWayFlights, ReplaysToTheSameBits) {
  std::string record;
  tern_host::simulate_flight(read_flight_world("Y:1", {"time_limit=30"}), {}, &record);
  const tern_host::FlightReplay replay = tern_host::replay_flight(record);
  EXPECT_EQ(replay.difference, "");
  EXPECT_GT(replay.ticks, 2900);
}

TEST(FarWayFlights, IsForFlightsToOneGoal) {
  EXPECT_THROW(read_flight_world("D:1", {"far_cell=4"}), tern_host::RecordError);
  EXPECT_THROW(read_flight_world("P49:1", {"far_cell=4", "goal_jitter=1,5"}), tern_host::RecordError);
  EXPECT_THROW(tern_host::simulate_flight(read_flight_world("Y:1", {"far_cell=0.1"})), std::runtime_error);
}

}  // namespace
