// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The same frames give the same map, bit for bit, on every target and in slices of every size (contract C3).
#include <gtest/gtest.h>

#include "support/map_flight.hpp"

namespace {

tern_test::MapFlight flight;

TEST(MapGolden, TheHashOfAFlight) {
  EXPECT_EQ(tern_test::map_flight_hash(flight, 1u << 30), tern_test::kMapFlightHash);
}

TEST(MapGolden, TheSameInSlices) {
  EXPECT_EQ(tern_test::map_flight_hash(flight, 11), tern_test::kMapFlightHash);
}

}  // namespace
