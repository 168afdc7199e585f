// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Deliveries below the roofs of a city, past a court that a coarse grid knows: with a far way and without one.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "host/flight/far_guide.hpp"
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

/// A report of the flight, again and again, from a vehicle that sees nothing.
tern_host::FarTotals totals_after(const tern::FlightReport& report) {
  const FlightWorld world = read_flight_world("Y:1", {});
  const tern::MapSpec spec = tern::map_spec({world.start.x - 8.0, world.start.y - 8.0, 0.0}, 0.5, {32, 32, 32}, 0.5);
  std::vector<std::uint64_t> words(tern::map_words(spec));
  tern::RollingMap map;
  EXPECT_EQ(map.bind(spec, words.data(), words.size()), tern::Status::kOk);
  tern_host::FarGuide guide(world);
  for (std::int64_t k = 0; k < 500; ++k) guide.tick(world.start, report, map, k * 1000000);
  return guide.totals();
}

TEST(FarWayFlights, ArrivingIsNotGivingUp) {
  tern::FlightReport report{};
  report.mode = tern::FlightMode::kRest;
  report.reason = tern::FlightReason::kArrived;
  const tern_host::FarTotals arrived = totals_after(report);
  EXPECT_EQ(arrived.searches, 1);
  EXPECT_EQ(arrived.marked, 0);
  report.reason = tern::FlightReason::kNearest;
  EXPECT_GT(totals_after(report).marked, 0);
}

TEST(FarWayFlights, RefusesCellsThatAreTooLargeForTheWindow) {
  EXPECT_THROW(read_flight_world("Y:1", {"far_cell=19.3"}), tern_host::RecordError);
  EXPECT_EQ(read_flight_world("Y:1", {"far_cell=19.1"}).settings.far_cell, 19.1);  // 0.45 x 128 m / 3 = 19.2 m
}

TEST(FarWayFlights, IsForFlightsToOneGoal) {
  EXPECT_THROW(read_flight_world("D:1", {"far_cell=4"}), tern_host::RecordError);
  EXPECT_THROW(read_flight_world("P49:1", {"far_cell=4", "goal_jitter=1,5"}), tern_host::RecordError);
  EXPECT_THROW(tern_host::simulate_flight(read_flight_world("Y:1", {"far_cell=0.1"})), std::runtime_error);
}

}  // namespace
