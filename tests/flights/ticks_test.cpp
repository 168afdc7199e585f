// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Simulated flights whose ticks are not a whole number of milliseconds, or long: what watches them must not mistake
// rounding, or what happens between two ticks, for a broken invariant.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/flight/simulated_flight.hpp"
#include "support/random.hpp"

namespace {

struct OddTicks {
  const char* name;
  std::vector<std::string> settings;
  const char* what;  ///< the false alarm that it once raised
};

const OddTicks kOddTicks[] = {
    {"P25@5:1", {"tick_hz=60", "yaw=unseen"}, "yaw: beyond its limits, at half a tick of 16666667 ns"},
    {"L:3", {"tick_hz=15", "time_limit=10"}, "likewise"},
    {"P25:3", {"tick_hz=15", "j_max=0", "time_limit=6"}, "not smooth: the largest jerk lay between two ticks"},
};

TEST(OddTicks, RaiseNoFalseAlarm) {
  for (int k = 0; k < tern_test::scaled(static_cast<int>(std::size(kOddTicks))); ++k) {
    const OddTicks& odd = kOddTicks[k];
    SCOPED_TRACE(std::string(odd.name) + ": " + odd.what);
    const tern_host::FlightResult result = simulate_flight(tern_host::read_flight_world(odd.name, odd.settings));
    EXPECT_NE(result.status, "invariant") << result.reason;
    EXPECT_NE(result.status, "collision") << result.reason;
  }
}

}  // namespace
