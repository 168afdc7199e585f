// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights through the families of worlds in which things move.
#include <gtest/gtest.h>

#include <string>

#include "host/flight/flight_world.hpp"
#include "host/flight/simulated_flight.hpp"

namespace {

tern_host::FlightResult among(const std::string& world) {
  return tern_host::simulate_flight(tern_host::read_flight_world(world, {"time_limit=40"}));
}

TEST(FlightsAmongThings, NothingIsTouchedInMotion) {
  for (const char* const name :
       {"T1-50:2", "T4:1", "T5-50:1", "T5-100:1", "T5-200:1", "CW:2", "RX:1", "MF:1", "HU:2", "B50:2", "B100:2"}) {
    const tern_host::FlightResult result = among(name);
    EXPECT_EQ(result.things.in_motion(), 0) << name;
    EXPECT_TRUE(result.status == "reached" || result.status == "timeout") << name << ": " << result.reason;
    EXPECT_GT(result.things.detector.measured, 100u) << name;
  }
}

// Slow things whose bounds are known: the flight arrives, untouched.
TEST(FlightsAmongThings, SlowOnesAreFlownAround) {
  for (const char* const name : {"T4:0", "T5-50:0", "T5-200:0", "MF:1"}) {
    const tern_host::FlightResult result = among(name);
    EXPECT_EQ(result.status, "reached") << name << ": " << result.reason;
    EXPECT_TRUE(result.things.contacts.empty()) << name;
  }
}

// Hunters pin the vehicle: that is why it gives up, though what its way needs can be seen from nowhere.
TEST(FlightsAmongThings, WhatThingsHoldUpGivesUpForThem) {
  for (const char* const name : {"HU:60", "HU:337"}) {
    const tern_host::FlightResult result =
        tern_host::simulate_flight(tern_host::read_flight_world(name, {"time_limit=90"}));
    EXPECT_EQ(result.status, "stuck") << name << ": " << result.reason;
    EXPECT_EQ(result.reason.find(tern::flight_reason_text(tern::FlightReason::kHeldUp)), 0u) << result.reason;
  }
}

}  // namespace
