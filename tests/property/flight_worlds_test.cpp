// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights through unknown worlds: no contact, whatever happens, and the invariants of docs/flight.md at every tick.
#include <gtest/gtest.h>

#include <cmath>

#include "support/flown.hpp"

namespace {

using namespace tern;
using tern_test::FlightSettings;
using tern_test::Flown;
using tern_test::forest;
using tern_test::Random;
using tern_test::Scene;

TEST(FlightWorlds, ForestsAreCrossed) {
  int arrived = 0;
  const int flights = tern_test::scaled(40);
  for (int k = 0; k < flights; ++k) {
    Random random(static_cast<std::uint64_t>(900 + k));
    FlightSettings settings;
    settings.v = k % 2 == 0 ? 3.0 : 5.0;
    Flown flown(forest(random, 30.0, 20.0, 1.0 / 25.0), settings);
    ASSERT_EQ(flown.started, Status::kOk);
    ASSERT_EQ(flown.flight.set_goal({30.0, 0.0, 1.5}), Status::kOk);
    const FlightReason reason = flown.fly(60.0);
    std::printf("flight %d: reason %d t %.2f x %.2f y %.2f clear %.3f asked %u committed %u dropped %u failed %u\n", k,
                static_cast<int>(reason), 1e-9 * static_cast<double>(flown.time), flown.position().x,
                flown.position().y, flown.least_clearance, flown.report.asked, flown.report.committed,
                flown.report.dropped, flown.report.failed);
    const GridSpec& w = flown.owned.map.safe().spec();
    std::printf("window x %.1f..%.1f y %.1f z %.1f plan %s look %.2f %.2f %.2f yaw %.2f\n", w.boundary.lower.x, w.boundary.upper.x, w.boundary.lower.y, w.boundary.lower.z, status_name(flown.report.plan), flown.flight.command(flown.time).look_at.x, flown.flight.command(flown.time).look_at.y,flown.flight.command(flown.time).look_at.z, flown.yaw);
    arrived += reason == FlightReason::kArrived ? 1 : 0;
  }
  EXPECT_EQ(arrived, flights);
}

}  // namespace
