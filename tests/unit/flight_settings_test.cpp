// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Settings of flights: what is refused, and how the message says it.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/text_records.hpp"

namespace {

/// Why a flight with this setting is refused; empty where it is not.
std::string refusal(const std::string& setting) {
  try {
    tern_host::flight_settings({setting});
  } catch (const tern_host::RecordError& error) {
    return error.reason();
  }
  return "";
}

TEST(FlightSettings, AreNotRounded) {
  EXPECT_EQ(refusal("hits=1.5"), "hits 1.5 is not a whole number");
  EXPECT_EQ(refusal("support=0.2"), "support 0.2 is not a whole number");
  EXPECT_EQ(refusal("work_per_tick=4000.5"), "work_per_tick 4000.5 is not a whole number");
  EXPECT_EQ(refusal("speckle_filter=0.9"), "speckle_filter 0.9 is not a whole number");
  EXPECT_EQ(refusal("sensor_size=160.5,120"), "sensor_size 160.5 is not a whole number");
  EXPECT_EQ(refusal("seed=0.5"), "seed 0.5 is not a whole number");
  EXPECT_EQ(refusal("hits=2"), "");
}

TEST(FlightSettings, SayTheirRangesBriefly) {
  EXPECT_EQ(refusal("seed=-1"), "seed -1 is not within 0 .. 9e+15");
  EXPECT_EQ(refusal("v_max=0"), "v_max 0 is not within 0.01 .. 100");
  EXPECT_EQ(refusal("sensor_size=7,120"), "sensor_size 7 is not within 8 .. 1000");
}

}  // namespace
