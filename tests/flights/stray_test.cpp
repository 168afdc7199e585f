// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A simulated PX4 whose speed limit leaves no room to catch up, against the wind.
#include <gtest/gtest.h>

#include "host/flight/flight_world.hpp"
#include "host/flight/simulated_flight.hpp"

namespace {

tern_host::FlightResult fly(const char* monitor) {
  return tern_host::simulate_flight(tern_host::read_flight_world(
      "P49@3:1", {"tracking=px4", "stack_speed=3", "drag=0.3", "wind=5,3.1416", "gusts=1", "seed=3", "a_max=3",
                  "j_max=8", "tick_hz=50", "tracking_margin=0.8", monitor}));
}

TEST(FlightStrays, MonitorKeepsTheMarginThatIsExceededWithoutIt) {
  const tern_host::FlightResult blind = fly("monitor=0");
  EXPECT_GT(blind.tracking_max, 1.2);
  const tern_host::FlightResult watched = fly("monitor=1");
  EXPECT_EQ(watched.status, "reached") << watched.reason;
  EXPECT_LT(watched.tracking_max, 0.8);
  EXPECT_GT(watched.time, blind.time);
}

}  // namespace
