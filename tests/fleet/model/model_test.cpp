// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "fleet/model/explore.hpp"
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
  setting.places = {tern::Vec3{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {2.0, 2.0, 0.0}, {}};
  for (std::size_t v = 0; v < static_cast<std::size_t>(vehicles); ++v) {
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

TEST(FleetModel, ProofsInSlices) {
  Setting setting = corners(2, 2);
  setting.in_slices = true;
  setting.last_tick = 3;
  expect_sound("proofs in slices", setting);
}

/// Two vehicles 34 m apart, which become members of each other there or nearer. The first one goes to and fro on the
/// spot; the second one comes where the first one is about to be, passes it, or goes out of range and comes back.
Setting in_range() {
  Setting setting;
  setting.vehicles = 2;
  setting.places = {tern::Vec3{0.0, 0.0, 0.0}, {34.0, 0.0, 0.0}, {}, {}};
  setting.targets[0] = {{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {-8.0, 0.0, 0.0}};
  setting.targets[1] = {{-2.0, 0.0, 0.0}, {46.0, 0.0, 0.0}, {34.0, 0.0, 0.0}};
  setting.announcements = 4;
  setting.in_the_air = 4;
  setting.last_tick = 60;
  setting.seconds = 14.0;
  setting.range.join = 34.5;
  setting.range.heard = 1e6;
  setting.range.speed = 10.0;
  setting.range.within = 60 * tern_model::kTick;
  setting.range.lease = 13 * tern_model::kTick;
  setting.settling = 13;
  return setting;
}

/// The second one, which has the right of way, goes out of range and comes back past the place to which the first one
/// goes meanwhile: promises outlive the range.
Setting out_of_range() {
  Setting setting = in_range();
  setting.places = {tern::Vec3{-8.0, 0.0, 0.0}, {34.0, 0.0, 0.0}, {}, {}};
  setting.targets[0] = {{0.0, 0.0, 0.0}};
  setting.targets[1] = {{46.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}};
  setting.priorities = {0, 1, 0};
  setting.announcements = 2;
  setting.range.join = 42.5;
  setting.range.lease = 20 * tern_model::kTick;
  setting.settling = 20;
  return setting;
}

/// A third one comes where the first one is about to be, or goes out of range of both others and comes back.
Setting three_in_range() {
  Setting setting = in_range();
  setting.vehicles = 3;
  setting.places[2] = {0.0, 34.0, 0.0};
  setting.targets[2] = {{0.0, 46.0, 0.0}, {0.0, 34.0, 0.0}, {1.0, 0.5, 0.0}};
  setting.priorities = {0, 1, 0};
  return setting;
}

/// Tables that have room for two, and a fourth vehicle that comes nearer to the first one than they are.
Setting full_tables() {
  Setting setting = in_range();
  setting.vehicles = 4;
  setting.places = {tern::Vec3{0.0, 0.0, 0.0}, {34.0, 0.0, 0.0}, {0.0, 34.0, 0.0}, {0.0, -36.0, 0.0}};
  setting.targets[0] = {{1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, -29.5, 0.0}};
  setting.targets[1] = {{-2.0, 0.0, 0.0}, {34.0, 0.0, 0.0}};
  setting.targets[2] = {{1.0, 34.0, 0.0}, {0.0, 34.0, 0.0}, {1.0, 0.5, 0.0}};
  setting.targets[3] = {{0.0, -30.0, 0.0}, {0.0, -0.5, 0.0}};
  setting.priorities = {0, 1, 0, 0};
  setting.range.speed = 4.0;
  setting.range.lease = 24 * tern_model::kTick;
  setting.seconds = 24.0;
  setting.settling = 60;
  return setting;
}

/// At least `least` walks: never so few that no plan is taken over at a small scale.
void expect_sound_walks(const char* name, const Setting& setting, int most = 400, int least = 40) {
  const int walks = std::max(least, tern_test::scaled(setting.in_slices ? most / 2 : most));
  const int steps = setting.in_slices ? 750 * setting.vehicles : 300;
  const tern_model::Walked walked = tern_model::walk(setting, walks, steps, 1);
  std::printf("%s: %zu worlds, plans taken over:", name, walked.worlds);
  for (int v = 0; v < setting.vehicles; ++v) std::printf(" %zu", walked.taken[v]);
  std::printf("\n");
  EXPECT_EQ(walked.unsafe, 0) << name;
  EXPECT_EQ(walked.stuck, 0) << name;
  for (int v = 0; v < setting.vehicles; ++v) EXPECT_GT(walked.taken[v], 0u) << v;
}

TEST(FleetModel, WalksByRange) {
  Setting setting = in_range();
  expect_sound_walks("by range", setting);
  setting.priorities = {0, 1, 0};
  expect_sound_walks("by range, the second one first", setting);
  setting.restarts = 2;
  expect_sound_walks("by range, restarts", setting);
}

TEST(FleetModel, WalksOutOfRange) {
  expect_sound_walks("out of range", out_of_range());
}

TEST(FleetModel, WalksByRangeWithProofsInSlices) {
  Setting setting = in_range();
  setting.in_slices = true;
  expect_sound_walks("by range, in slices", setting);
  setting.priorities = {0, 1, 0};
  setting.restarts = 2;
  expect_sound_walks("by range, in slices, restarts", setting);
  setting = out_of_range();
  setting.in_slices = true;
  expect_sound_walks("out of range, in slices", setting);
}

TEST(FleetModel, WalksOfThreeByRangeWithProofsInSlices) {
  Setting setting = three_in_range();
  setting.in_slices = true;
  expect_sound_walks("three by range, in slices", setting);
}

TEST(FleetModel, WalksWithFullTables) {
  static_assert(tern::kMaxNeighbours == 2, "as the profile tiny has it");
  expect_sound_walks("full tables", full_tables(), 40, 40);
}

TEST(FleetModel, ByRange) {
  Setting setting = in_range();
  setting.announcements = 1;
  setting.in_the_air = 2;
  setting.last_tick = 3;
  expect_sound("by range", setting);
}

TEST(FleetModel, ByRangeWithProofsInSlices) {
  Setting setting = in_range();
  setting.in_slices = true;
  setting.announcements = 1;
  setting.in_the_air = 1;
  setting.last_tick = 3;
  setting.targets[0].resize(1);
  setting.targets[1].resize(2);
  expect_sound("by range, in slices", setting);
}

}  // namespace
