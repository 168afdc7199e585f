// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Eight vehicles over networks of every kind: never nearer to each other than they should be, at any instant; and as
// long as enough packets get through, everyone flies.
#include <gtest/gtest.h>

#include "fleet/swarm.hpp"

namespace {

using tern_test::kSecond;
using tern_test::Swarm;
using tern_test::SwarmSpec;

struct Flown {
  double least_gap = 1e9;
  int least_taken = 1 << 30;
  int taken = 0;
  int announced = 0;
  int met = 0;  ///< members that came or went
};

Flown fly(const SwarmSpec& spec, std::uint64_t seed, double seconds) {
  auto swarm = std::make_unique<Swarm>(spec, seed);
  Flown flown;
  std::vector<int> members(static_cast<std::size_t>(spec.vehicles));
  while (swarm->seconds() < seconds) {
    swarm->step();
    for (int v = 0; v < spec.vehicles; ++v) {
      int& before = members[static_cast<std::size_t>(v)];
      flown.met += std::abs(swarm->members(v) - before);
      before = swarm->members(v);
    }
    flown.least_gap = std::min(flown.least_gap, swarm->least_gap());
  }
  for (int v = 0; v < spec.vehicles; ++v) {
    flown.least_taken = std::min(flown.least_taken, swarm->taken(v));
    flown.taken += swarm->taken(v);
    flown.announced += swarm->announced(v);
  }
  return flown;
}

/// Flies some seeds. What was granted to a proof may be missing, 4 nm.
void expect_apart(const char* name, const SwarmSpec& spec, int least_taken) {
  Flown all;
  for (int seed = 1; seed <= tern_test::scaled(10); ++seed) {
    const Flown flown = fly(spec, static_cast<std::uint64_t>(seed), 30.0);
    EXPECT_GT(flown.least_gap, -1e-8) << name << ", seed " << seed;
    EXPECT_GE(flown.least_taken, least_taken) << name << ", seed " << seed;
    all.least_gap = std::min(all.least_gap, flown.least_gap);
    all.least_taken = std::min(all.least_taken, flown.least_taken);
    all.taken += flown.taken;
    all.announced += flown.announced;
    all.met += flown.met;
  }
  std::printf("%-28s gap %.4f m, taken %d of %d, least %d, met %d\n", name, all.least_gap, all.taken, all.announced,
              all.least_taken, all.met);
  EXPECT_TRUE(!spec.by_range || all.met > tern_test::scaled(10) * spec.vehicles) << name;
}

TEST(FleetNetwork, Good) {
  SwarmSpec spec;
  expect_apart("no loss", spec, 3);
}

TEST(FleetNetwork, Loss) {
  for (const double loss : {0.1, 0.3, 0.5, 0.9}) {
    SwarmSpec spec;
    spec.link.loss = loss;
    spec.link.delay = 20;
    expect_apart(("loss " + std::to_string(loss)).c_str(), spec, loss < 0.6 ? 1 : 0);
  }
}

TEST(FleetNetwork, NothingGetsThrough) {
  SwarmSpec spec;
  spec.link.loss = 1.0;
  expect_apart("all lost", spec, 0);
}

TEST(FleetNetwork, DelaysOfSeconds) {
  SwarmSpec spec;
  spec.link.loss = 0.2;
  spec.link.delay = 300;
  expect_apart("delay 3 s", spec, 0);
}

TEST(FleetNetwork, BurstsAndIslands) {
  SwarmSpec spec;
  spec.link.loss = 0.5;
  spec.link.bursts = true;
  spec.link.islands = true;
  expect_apart("bursts, islands", spec, 1);
}

TEST(FleetNetwork, SmallPackets) {
  SwarmSpec spec;
  spec.room = tern::kFleetPacketBytes;
  spec.link.loss = 0.1;
  spec.link.delay = 5;
  expect_apart("27 bytes, loss 0.1", spec, 1);
  spec.room = 128;
  spec.link.loss = 0.3;
  expect_apart("128 bytes, loss 0.3", spec, 1);
}

TEST(FleetNetwork, ClocksThatDiffer) {
  SwarmSpec spec;
  spec.clock_error = kSecond / 20;
  spec.link.loss = 0.3;
  spec.link.delay = 10;
  expect_apart("clocks 50 ms apart", spec, 1);
}

TEST(FleetNetwork, LittleWork) {
  SwarmSpec spec;
  spec.work = 20;
  spec.link.loss = 0.1;
  expect_apart("20 units a tick", spec, 1);
}

TEST(FleetNetwork, RestartsWithOtherPriorities) {
  SwarmSpec spec;
  spec.restarts = 0.1;
  spec.link.loss = 0.2;
  spec.link.delay = 20;
  spec.clock_error = kSecond / 50;
  expect_apart("restarts", spec, 0);
}

TEST(FleetNetwork, TheFirstOneLeaves) {
  SwarmSpec spec;
  spec.first_leaves = true;
  spec.link.loss = 0.3;
  spec.link.delay = 10;
  expect_apart("the first one leaves", spec, 1);
}

TEST(FleetNetwork, ByRange) {
  for (const double loss : {0.0, 0.3}) {
    SwarmSpec spec;
    spec.by_range = true;
    spec.link.loss = loss;
    spec.link.delay = loss > 0.0 ? 20 : 0;
    spec.clock_error = loss > 0.0 ? kSecond / 50 : 0;
    expect_apart(("by range, loss " + std::to_string(loss)).c_str(), spec, 1);
  }
}

TEST(FleetNetwork, ByRangeWithRestarts) {
  SwarmSpec spec;
  spec.by_range = true;
  spec.restarts = 0.03;
  spec.link.loss = 0.2;
  spec.link.delay = 20;
  spec.clock_error = kSecond / 50;
  expect_apart("by range, restarts", spec, 1);
}

TEST(FleetNetwork, ByRangeWithLittleWork) {
  for (const std::uint32_t work : {10u, 5u}) {
    SwarmSpec spec;
    spec.by_range = true;
    spec.work = work;
    spec.link.loss = 0.1;
    expect_apart(("by range, units a tick: " + std::to_string(work)).c_str(), spec, work > 5 ? 1 : 0);
  }
}

TEST(FleetNetwork, ByRangeTheFirstOneLeaves) {
  SwarmSpec spec;
  spec.by_range = true;
  spec.first_leaves = true;
  spec.link.loss = 0.3;
  spec.link.delay = 10;
  expect_apart("by range, the first one leaves", spec, 1);
}

}  // namespace
