// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fleet/model/worlds.hpp"
#include "support/random.hpp"

namespace {

using tern_model::explore;
using tern_model::Seen;
using tern_model::Setting;

/// Vehicles on three corners of a square of 2 m. Each may fly to the fourth corner, or, with two targets, to the corner
/// of the next one. Their radii are 0.5 m, so only one may go to a corner, and nobody may pass close to another one.
Setting corners(int vehicles, int targets) {
  Setting setting;
  setting.vehicles = vehicles;
  const tern::Vec3 free{0.0, 2.0, 0.0};
  setting.places = {tern::Vec3{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {2.0, 2.0, 0.0}};
  for (std::size_t v = 0; v < tern_model::kVehicles; ++v) {
    setting.targets[v] = {free, setting.places[(v + 1) % static_cast<std::size_t>(vehicles)]};
    setting.targets[v].resize(static_cast<std::size_t>(targets));
  }
  return setting;
}

/// All worlds that there are, or, where random tests run only in part, those of a few steps.
void expect_sound(const char* name, const Setting& setting) {
  const bool is_short = TERN_TEST_SCALE < 1;
  const Seen seen = explore(setting, is_short ? 20000 : 1'000'000'000, 97);
  std::printf("%s: %zu worlds in %d steps%s, %zu states of vehicles\n", name, seen.worlds, seen.depth,
              seen.is_whole ? ", which are all" : "", seen.fleets);
  EXPECT_EQ(seen.unsafe_depth, -1) << name << ": steps to a world in which two vehicles meet";
  EXPECT_EQ(seen.stuck, 0u) << name << ": worlds in which somebody cannot go on";
  EXPECT_TRUE(is_short || seen.is_whole);
  for (int v = 0; v < setting.vehicles; ++v) EXPECT_TRUE(is_short || seen.flown[v] > 0) << v << " never flew";
}

TEST(FleetModel, WithdrawalsAndDepartures) {
  Setting setting = corners(2, 2);
  setting.in_the_air = 9;
  setting.withdrawals = 1;
  setting.departures = 1;
  expect_sound("withdrawals and departures", setting);
}

TEST(FleetModel, RestartsWithTheSameAndAHigherPriority) {
  Setting setting = corners(2, 1);
  setting.restarts = 1;
  setting.last_tick = 3;
  setting.in_the_air = 4;
  setting.keeps_first = true;
  expect_sound("restarts", setting);
}

TEST(FleetModel, StateAndPlansApart) {
  Setting setting = corners(2, 2);
  setting.in_the_air = 9;
  setting.in_pieces = true;
  expect_sound("state and plans apart", setting);
}

TEST(FleetModel, TwoPlansEach) {
  Setting setting = corners(2, 1);
  setting.announcements = 2;
  expect_sound("two plans each", setting);
}

// Slow plans, so that the clocks' error leaves room to fly.
TEST(FleetModel, ClocksThatDiffer) {
  Setting setting = corners(2, 2);
  setting.in_the_air = 9;
  setting.skew = 1;
  setting.seconds = 20.0;
  expect_sound("clocks that differ", setting);
}

TEST(FleetModel, ThreeVehicles) {
  Setting setting = corners(3, 1);
  setting.last_tick = 2;
  setting.in_the_air = 1;
  expect_sound("three vehicles", setting);
}

}  // namespace
