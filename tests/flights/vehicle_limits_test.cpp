// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights with limits of thrust, tilt and body rates. The simulator checks every command against them, between ticks,
// too, by arithmetic of its own; a flight that breaks one does not count as reached.
#include <gtest/gtest.h>

#include <iterator>
#include <string>
#include <vector>

#include "host/flight/simulated_flight.hpp"
#include "support/random.hpp"

namespace {

struct Vehicle {
  const char* world;
  std::vector<std::string> settings;
};

/// A loaded delivery quadrotor at 35 and 20 degrees, and a racer of which only rates and thrust are scarce.
const Vehicle kVehicles[] = {
    {"P25@8:7", {"a_max=12", "thrust_max=14.7", "thrust_min=3", "tilt_tangent=0.7", "rate_max=3.5"}},
    {"C@6:8", {"a_max=12", "thrust_max=14.7", "thrust_min=3", "tilt_tangent=0.364", "rate_max=2"}},
    {"P25@12:3", {"a_max=30", "thrust_max=35", "thrust_min=2", "tilt_tangent=3", "rate_max=8"}},
    {"O@2:2", {"a_max=12", "thrust_max=11", "thrust_min=5", "tilt_tangent=0.364", "rate_max=1"}},
};

TEST(VehicleFlights, KeepThrustTiltAndBodyRates) {
  for (int k = 0; k < tern_test::scaled(static_cast<int>(std::size(kVehicles))); ++k) {
    SCOPED_TRACE(kVehicles[k].world);
    const tern_host::FlightWorld world = tern_host::read_flight_world(kVehicles[k].world, kVehicles[k].settings);
    const tern_host::FlightResult result = tern_host::simulate_flight(world);
    EXPECT_EQ(result.status, "reached") << result.reason;
    EXPECT_GT(result.min_clearance, world.settings.body_radius);
  }
}

}  // namespace
