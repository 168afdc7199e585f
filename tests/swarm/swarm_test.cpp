// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Whole swarms over bad links: nobody touches anybody, and what is flown is the same each time. The watch is tried on
// ways that are known to touch.
#include "host/swarm/swarm.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "host/swarm/swarm_processes.hpp"
#include "support/random.hpp"

namespace {

using namespace tern_host;

SwarmResult fly(const char* name, const SwarmSettings& settings) {
  const SwarmWorld world = swarm_world(name);
  const SwarmResult result = fly_swarm(world, settings);
  EXPECT_EQ(result.disagreed, 0u);
  return result;
}

TEST(Swarm, SwapsPlaces) {
  const SwarmResult result = fly("swap-6:1", {});
  EXPECT_EQ(result.arrived(), 6);
  EXPECT_TRUE(result.contacts.empty());
  EXPECT_GE(result.least_distance, 0.6);
  EXPECT_LT(result.mean_travel(), 12.0);
  EXPECT_EQ(result.lost, 0u);
  for (const SwarmMember& member : result.members) {
    EXPECT_EQ(member.unasked, 0u);
    EXPECT_GT(member.length, 15.9);
  }
}

TEST(Swarm, FliesTheSameAgain) {
  SwarmSettings settings;
  settings.links.loss = 0.3;
  settings.links.delay_max = 0.1;
  settings.clock_error = 0.01;
  SwarmWorld world = swarm_world("swap-4:1");
  world.time_limit = 4.0;
  const SwarmResult once = fly_swarm(world, settings);
  EXPECT_EQ(once.hash, fly_swarm(world, settings).hash);
  settings.threads = 3;
  EXPECT_EQ(once.hash, fly_swarm(world, settings).hash);
  ++settings.seed;
  EXPECT_NE(once.hash, fly_swarm(world, settings).hash);
}

// Half of the packets are lost, in bursts, late and twice; clocks differ; for some seconds half of them hear nothing of
// the other half.
TEST(Swarm, NobodyTouchesAnybodyOverBadLinks) {
  SwarmSettings settings;
  settings.links.loss = 0.5;
  settings.links.burst = 4.0;
  settings.links.delay_max = 0.3;
  settings.links.repeated = 0.2;
  settings.links.partition = {3.0, 5.0};
  settings.clock_error = 0.02;
  for (int run = 0; run < tern_test::scaled(3); ++run) {
    settings.seed = 40 + static_cast<std::uint64_t>(run);
    const SwarmResult result = fly("swap-5:1", settings);
    EXPECT_TRUE(result.contacts.empty()) << run;
    EXPECT_EQ(result.arrived(), 5) << run;
  }
}

// One packet in ten arrives: plans wait longer for their answers, and all arrive.
TEST(Swarm, ArrivesWhereMostIsLost) {
  SwarmSettings settings;
  settings.links.loss = 0.9;
  settings.links.delay_max = 0.1;
  const SwarmResult result = fly("swap-4:1", settings);
  EXPECT_EQ(result.arrived(), 4);
  EXPECT_TRUE(result.contacts.empty());
}

// Vehicles begin anew in the fleet in the middle of everything: what was agreed to with them before is not flown.
TEST(Swarm, NobodyTouchesAnybodyWhereMembersBeginAnew) {
  SwarmSettings settings;
  settings.restarts = 0.3;
  settings.links.loss = 0.3;
  settings.links.delay_max = 0.1;
  for (int run = 0; run < tern_test::scaled(3); ++run) {
    settings.seed = 70 + static_cast<std::uint64_t>(run);
    const SwarmResult result = fly("swap-5:1", settings);
    EXPECT_TRUE(result.contacts.empty()) << run;
    EXPECT_EQ(result.arrived(), 5) << run;
  }
}

// Nobody knows the posts beforehand; each finds them by its own lidar.
TEST(Swarm, DiscoversWhatStandsStill) {
  SwarmSettings settings;
  settings.discover = 4.0;
  const SwarmWorld world = swarm_world("T10-3:1");
  SwarmRecord record;
  const SwarmResult result = fly_swarm(world, settings, nullptr, &record);
  EXPECT_EQ(result.arrived(), 3);
  EXPECT_TRUE(result.contacts.empty());
  EXPECT_GE(result.least_clearance, world.body_radius);
  EXPECT_EQ(replay_swarm(read_swarm_record(write_swarm_record(record))), "");
}

// Six vehicles want through an opening that is as wide as two of them, from both sides; and a maze has no room above.
TEST(Swarm, PassesGapsAndMazes) {
  for (const char* name : {"gap-6:1", "T10S-4:1", "T10D-4:1"}) {
    const SwarmResult result = fly(name, {});
    EXPECT_EQ(result.arrived(), static_cast<int>(result.members.size())) << name;
    EXPECT_TRUE(result.contacts.empty()) << name;
  }
}

// Seventy vehicles have more plans than a flight has room for: the swarm says so.
TEST(Swarm, SaysWhichPlansAFlightHasNoRoomFor) {
  SwarmWorld world = swarm_world("field-70:1");
  world.time_limit = 0.3;
  const SwarmResult result = fly_swarm(world, {});
  EXPECT_GT(result.most_untold, 0);
  EXPECT_TRUE(result.contacts.empty());
}

// Fields of so many are so large that few places are within 20 m of a start.
TEST(Swarm, GoalsOfScatteredVehiclesAreNear) {
  for (const char* name : {"plain-200:1", "plain-500:2", "field-500:1"}) {
    const SwarmWorld world = swarm_world(name);
    for (const SwarmTask& task : world.tasks) {
      const tern::Vec3& goal = task.mission.back().position;
      EXPECT_LE(std::hypot(goal.x - task.start.x, goal.y - task.start.y), 20.0) << name;
    }
  }
}

TEST(SwarmRecord, ReplaysToTheSameBits) {
  SwarmSettings settings;
  settings.links.loss = 0.3;
  settings.links.delay_max = 0.1;
  settings.clock_error = 0.01;
  const SwarmWorld world = swarm_world("swap-3:1");
  SwarmRecord record;
  const SwarmResult flown = fly_swarm(world, settings, nullptr, &record);
  EXPECT_EQ(flown.hash, fly_swarm(world, settings).hash) << "who records changes nothing";
  const std::string bytes = write_swarm_record(record);
  EXPECT_TRUE(is_swarm_record(bytes));
  SwarmRecord read = read_swarm_record(bytes);
  EXPECT_EQ(read.hash(), record.hash());
  EXPECT_EQ(replay_swarm(read), "");
  // Packets that did not come are noticed.
  auto& ticks = read.vehicles[1].ticks;
  for (std::size_t k = ticks.size() / 2; k < ticks.size(); ++k) ticks[k].heard.clear();
  EXPECT_EQ(replay_swarm(read).find("vehicle 1 differs from "), 0u);
}

TEST(SwarmRecord, RefusesWhatIsNone) {
  for (const std::string& bytes : {std::string(), std::string("no record"), std::string(100, '\xA1')}) {
    EXPECT_FALSE(is_swarm_record(bytes));
    EXPECT_THROW(read_swarm_record(bytes), std::runtime_error);
  }
}

// Three processes with nothing in common but a clock and sockets. Where the computer is too busy for them, they may
// rest at the end; they touch nobody anywhere, and their record replays.
TEST(SwarmProcesses, TouchNobodyAndReplay) {
  SwarmSettings settings;
  settings.tick_hz = 20.0;
  settings.late = 0.5;
  settings.links.loss = 0.3;
  settings.links.delay_max = 0.05;
  settings.clock_error = 0.01;
  SwarmWorld world = swarm_world("swap-3:1");
  world.time_limit = 20.0;
  SwarmRecord record;
  const SwarmResult result = fly_swarm_in_processes(world, settings, record);
  EXPECT_TRUE(result.contacts.empty());
  EXPECT_EQ(result.disagreed, 0u);
  EXPECT_GT(result.packets, 0u);
  ASSERT_EQ(record.vehicles.size(), 3u);
  EXPECT_EQ(replay_swarm(record), "");
}

// Nobody hears anybody: nobody moves.
TEST(Swarm, AllRestWithoutLinks) {
  SwarmWorld world = swarm_world("swap-3:1");
  world.time_limit = 4.0;
  SwarmSettings settings;
  settings.links.loss = 1.0;
  const SwarmResult result = fly_swarm(world, settings);
  EXPECT_EQ(result.arrived(), 0);
  for (const SwarmMember& member : result.members) EXPECT_EQ(member.length, 0.0);
}

TEST(SwarmWorld, RefusesNamesThatAreNone) {
  for (const char* name :
       {"", "swap", "swap-8", "swap:1", "swap-0:1", "swap-1001:1", "other-3:1", "swap-x:1", "swap-3.5:1",
        "swap-8:", "swap-8:x", "swap-8:1x", "swap-8:-1", "swap-2:99999999999999999999999"}) {
    EXPECT_THROW(swarm_world(name), std::runtime_error) << name;
  }
  EXPECT_EQ(swarm_world("T10-7:3").tasks.size(), 7u);
  EXPECT_EQ(swarm_world("T9-10:1").blocks.size(), 180u);
  EXPECT_GT(swarm_world("T10D-10:1").blocks.size(), swarm_world("T10S-10:1").blocks.size());
}

// Two bodies of 0.3 m cross at 90 degrees, the second one late by `late` seconds, at 2 m/s. Their centres come as near
// as 2 * late / sqrt(2).
SwarmWatch crossing(double late) {
  SwarmWatch watch(
      2, 0.3, 2.0,
      [late](int k, std::int64_t t) {
        const double s = 1e-9 * static_cast<double>(t) - 5.0 - (k == 1 ? late : 0.0);
        return k == 0 ? tern::Vec3{2.0 * s, 0.0, 0.0} : tern::Vec3{0.0, 2.0 * s, 0.0};
      },
      nullptr);
  for (int tick = 0; tick < 10; ++tick) watch.look(1000000000LL * tick, 1000000000LL * (tick + 1));
  return watch;
}

TEST(SwarmWatch, FindsContactsBetweenTicks) {
  const double just = 0.6 / std::sqrt(2.0);
  EXPECT_TRUE(crossing(just + 1e-3).contacts().empty());
  const SwarmWatch touched = crossing(just - 1e-3);
  ASSERT_EQ(touched.contacts().size(), 1u);
  EXPECT_LT(touched.contacts()[0].distance, 0.6);
  EXPECT_NEAR(crossing(0.5).least_distance(), 0.5 * std::sqrt(2.0), 0.05);
}

TEST(SwarmWatch, FindsContactsWithWhatStandsStill) {
  SwarmWatch watch(
      1, 0.3, 2.0,
      [](int, std::int64_t t) {
        return tern::Vec3{2e-9 * static_cast<double>(t), 0.0, 0.0};
      },
      [](const tern::Vec3& p) { return std::hypot(p.x - 3.0, 0.29); });
  watch.look(0, 1000000000);
  EXPECT_TRUE(watch.contacts().empty());
  watch.look(1000000000, 2000000000);
  ASSERT_EQ(watch.contacts().size(), 1u);
  EXPECT_EQ(watch.contacts()[0].second, -1);
  EXPECT_NEAR(1e-9 * static_cast<double>(watch.contacts()[0].time), 1.5, 0.1);
}

}  // namespace
