// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whole flights with a lidar instead of a camera.
#include <gtest/gtest.h>

#include "host/flight/simulated_flight.hpp"

namespace {

/// Both were hemmed in by lone returns before they had left the start.
TEST(LidarFlight, ReachesItsGoalAmongOutliers) {
  for (const char* const name : {"P25@5:7003", "P25@5:7006"}) {
    const tern_host::FlightWorld world = tern_host::read_flight_world(
        name, {"sensor=lidar", "sensor_fov=6.2832,1.2915", "depth_noise=0.01", "outliers=0.01", "time_limit=60"});
    const tern_host::FlightResult result = tern_host::simulate_flight(world);
    EXPECT_EQ(result.status, "reached") << name << ": " << result.reason;
  }
}

TEST(LidarFlight, ReachesItsGoalInAForest) {
  const tern_host::FlightWorld world =
      tern_host::read_flight_world("P36@3:3", {"sensor=lidar", "sensor_hz=10", "time_limit=60"});
  const tern_host::FlightResult result = tern_host::simulate_flight(world);
  EXPECT_EQ(result.status, "reached") << result.reason;
  EXPECT_GT(result.watched.voxels, 20u);
  EXPECT_GT(result.watched.hits, 100u);
}

}  // namespace
