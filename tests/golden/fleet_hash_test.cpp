// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A fleet over a lossy network does the same on every target: one hash of every packet, every answer and every place.
#include <gtest/gtest.h>

#include <memory>

#include "golden/fleet_run.hpp"
#include "golden/golden_hash.hpp"

namespace {

using namespace tern_golden;

TEST(GoldenFleet, HasOneHash) {
  const auto memory = std::make_unique<FleetRunMemory<FleetSetting{}.members>>();
  const FleetTotals totals = fly_fleet(FleetSetting{}, *memory, [] { return std::uint64_t{0}; });
  EXPECT_EQ(totals.hash, kGoldenFleetHash) << std::hex << totals.hash;
  // Everything that a fleet may do is in it.
  EXPECT_GT(totals.taken, 20);
  EXPECT_GT(totals.refused, 5);
  EXPECT_GT(totals.unanswered, 1);
  EXPECT_GT(totals.conflicts, 1);
}

TEST(GoldenFleet, HasOneHashByRange) {
  const auto memory = std::make_unique<FleetRunMemory<FleetSetting{}.members>>();
  FleetSetting setting;
  setting.join = kGoldenJoin;
  const FleetTotals totals = fly_fleet(setting, *memory, [] { return std::uint64_t{0}; });
  EXPECT_EQ(totals.hash, kGoldenFleetRangeHash) << std::hex << totals.hash;
  EXPECT_GT(totals.taken, 10);
  EXPECT_GT(totals.strangers, 3);
  EXPECT_GT(totals.refused + totals.unanswered + totals.conflicts, 5);
}

}  // namespace
