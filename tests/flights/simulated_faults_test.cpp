// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Simulated flights with faults: where the theorem's assumptions hold, nothing is touched; where one does not, the log
// says which. The campaign of faults flies more of them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/flight/simulated_flight.hpp"

namespace {

using tern_host::FlightResult;

FlightResult flown(const std::string& world, const std::vector<std::string>& settings) {
  return simulate_flight(tern_host::read_flight_world(world, settings));
}

TEST(SimulatedFaults, WithinTheAssumptionsCostOnlyTime) {
  for (const std::vector<std::string>& settings : std::vector<std::vector<std::string>>{
           {"dropout=0.7", "sensor_latency=0.2"},
           {"pose_jump=0.2,0.7", "pose_margin=0.2"},
           {"tick_skip=0.5,50"},
           {"goal_jitter=3,6"},
       }) {
    const FlightResult result = flown("P25@5:2", settings);
    EXPECT_EQ(result.status, "reached") << settings[0] << ": " << result.reason;
    EXPECT_FALSE(result.contact.happened);
  }
}

TEST(SimulatedFaults, WithoutFramesItRestsWithAReason) {
  const FlightResult result = flown("P25@8:4", {"frames_until=2.5"});
  EXPECT_EQ(result.status, "stuck") << result.reason;
  EXPECT_GT(result.length, 10.0);
}

TEST(SimulatedFaults, GoalsThatCannotBeReachedDoNoHarm) {
  for (const char* const place : {"goal_place=occupied", "goal_place=outside"}) {
    const FlightResult result = flown("P25@5:2", {place, "time_limit=40"});
    EXPECT_TRUE(result.status == "stuck" || result.status == "timeout") << result.status << ": " << result.reason;
  }
}

TEST(SimulatedFaults, TicksAreSkipped) {
  const FlightResult result = flown("P25@5:2", {"tick_skip=0.4,10", "time_limit=5"});
  const double share = static_cast<double>(result.skipped) / static_cast<double>(result.track.size());
  EXPECT_NEAR(share, 0.4, 0.1);
  EXPECT_EQ(result.watched.ticks + result.skipped, result.track.size());
}

/// Too near to brake for: the flight says so, and is as slow as can be.
TEST(SimulatedFaults, WhatAppearsInTheWayIsAThreat) {
  const FlightResult result = flown("P25@5:2", {"appear_ahead=3,2"});
  EXPECT_EQ(result.status, "threat") << result.reason;
  ASSERT_TRUE(result.contact.happened);
  EXPECT_EQ(result.contact.broken_assumption, "still_world");
  EXPECT_TRUE(result.contact.threat.shown);
  EXPECT_LE(result.contact.threat.speed, result.contact.threat.brake_speed + result.contact.threat.tolerance);
  EXPECT_LT(result.contact.threat.speed, 5.0);
  EXPECT_GT(result.seconds_in[4], 0.1);
  ASSERT_EQ(result.appeared.size(), 1u);
}

TEST(SimulatedFaults, WhatAppearsFarAheadIsFlownAround) {
  const FlightResult result = flown("P25@5:2", {"appear_ahead=3,7"});
  EXPECT_EQ(result.status, "reached") << result.reason;
  EXPECT_EQ(result.appeared.size(), 1u);
}

/// On top of the vehicle: nobody could have known.
TEST(SimulatedFaults, WhatAppearsTooLateToBeSeenIsACollision) {
  const FlightResult result = flown("P25@5:2", {"appear_ahead=3,0.3"});
  EXPECT_EQ(result.status, "collision") << result.reason;
  EXPECT_EQ(result.contact.broken_assumption, "still_world");
  EXPECT_NE(result.reason.find("did not show in time"), std::string::npos) << result.reason;
}

/// Some of the flights touch nothing all the same.
TEST(SimulatedFaults, PosesThatJumpBeyondTheirMarginAreNamed) {
  FlightResult result;
  for (int seed = 1; seed <= 8 && !result.contact.happened; ++seed) {
    result = flown("P12@5:" + std::to_string(seed), {"pose_jump=0.8,0.5"});
    EXPECT_LE(result.pose_max, 0.8 + 1e-9);
  }
  ASSERT_TRUE(result.contact.happened);
  EXPECT_EQ(result.status, "collision");
  EXPECT_EQ(result.contact.broken_assumption, "pose_margin");
}

TEST(SimulatedFaults, AVehicleThatCannotFollowIsNamed) {
  const FlightResult result = flown("S20:2", {"tracking=px4", "monitor=0"});
  ASSERT_TRUE(result.contact.happened) << result.status;
  EXPECT_EQ(result.status, "collision");
  EXPECT_EQ(result.contact.broken_assumption, "tracking_margin");
}

TEST(SimulatedFaults, EqualSeedsGiveEqualFlights) {
  const std::vector<std::string> settings{"pose_jump=0.1,0.3", "pose_margin=0.1", "tick_skip=0.3,5",
                                          "goal_jitter=1",     "dropout=0.3",     "time_limit=4"};
  EXPECT_EQ(flown("P25@5:6", settings).commands_hash, flown("P25@5:6", settings).commands_hash);
}

}  // namespace
