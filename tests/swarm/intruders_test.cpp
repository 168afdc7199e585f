// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Aircraft that are no members: where they fly, what the watch says of those that touch, and whole swarms among them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "host/flight/flight_world.hpp"
#include "host/flight/vectors.hpp"
#include "host/swarm/swarm.hpp"
#include "host/swarm/swarm_intruders.hpp"
#include "host/swarm/swarm_processes.hpp"
#include "support/random.hpp"

namespace {

using namespace tern_host;

SwarmWorld world_among(const char* name, int count, std::uint64_t seed) {
  SwarmWorld world = swarm_world(name);
  add_intruders(world, {count, 0.0, 2.0}, seed);
  return world;
}

TEST(Intruders, FlyLevelAndWithinTheirBounds) {
  SwarmWorld world = swarm_world("T3-10:1");
  add_intruders(world, {5, 4.0, 1.5}, 7);
  ASSERT_EQ(world.intruders.size(), 5u);
  constexpr double kStep = 1e-3;
  for (const Thing& thing : world.intruders) {
    const ThingMotion motion(thing);
    double nearest = 1e9, farthest = 0.0;
    for (double t = 0.0; t < 40.0; t += kStep) {
      const ThingState a = motion.at(t);
      const ThingState b = motion.at(t + kStep);
      EXPECT_EQ(a.position.z, motion.at(0.0).position.z);
      EXPECT_LE(length(a.velocity), 4.0 + 1e-9);
      EXPECT_LE(distance_between(a.velocity, b.velocity), 1.5 * kStep + 1e-9);
      EXPECT_LE(distance_between(a.position, b.position), 4.0 * kStep + 1e-9);
      nearest = std::min(nearest, std::hypot(a.position.x, a.position.y));
      farthest = std::max(farthest, std::hypot(a.position.x, a.position.y));
    }
    EXPECT_LT(nearest, 7.0) << "it crosses the circle of 10 m";
    EXPECT_GT(farthest, 11.0) << "it leaves it";
    for (const SwarmTask& task : world.tasks) EXPECT_GT(distance_between(motion.at(0.0).position, task.start), 2.5);
  }
}

TEST(Intruders, TouchNothingThatStandsStill) {
  for (const char* name : {"T7-20:1", "T9-10:2", "T10-10:1", "gap-6:1"}) {
    const SwarmWorld world = world_among(name, 2, 3);
    for (const Thing& thing : world.intruders) {
      const ThingMotion motion(thing);
      for (double t = 0.0; t < 100.0; t += 0.013) {
        const tern::Vec3 place = motion.at(t).position;
        for (const tern::Box& block : world.blocks) ASSERT_GE(distance_to(block, place), thing.radius) << name;
      }
    }
  }
}

TEST(Intruders, AreSeededAndRefused) {
  EXPECT_EQ(lines_of(world_among("swap-4:1", 3, 5).intruders), lines_of(world_among("swap-4:1", 3, 5).intruders));
  EXPECT_NE(lines_of(world_among("swap-4:1", 3, 5).intruders), lines_of(world_among("swap-4:1", 3, 6).intruders));
  EXPECT_EQ(world_among("swap-4:1", kMostIntruders, 5).intruders.size(), std::size_t{kMostIntruders});
  EXPECT_THROW(world_among("swap-4:1", kMostIntruders + 1, 5), std::runtime_error);
  EXPECT_THROW(world_among("T10D-4:1", 1, 5), std::runtime_error) << "no way leads through a maze";
}

/// A vehicle of 0.2 m that rests at the origin until `sets_off`, s, and then flies along x at 2 m/s; an intruder of 0.3
/// m that passes at `aside` m and 3 m/s, along x from -6 m.
struct Passing {
  double sets_off, aside;

  tern::Vec3 vehicle(double t) const { return {2.0 * std::max(0.0, t - sets_off), 0.0, 0.0}; }
  tern::Vec3 intruder(double t) const { return {3.0 * t - 6.0, aside, 0.0}; }
  SwarmWatch watch() const {
    SwarmWatch found(
        1, 0.2, 2.0, [*this](int, std::int64_t t) { return vehicle(1e-9 * static_cast<double>(t)); }, nullptr);
    found.add_intruder({0.3, 3.0, [*this](std::int64_t t) { return intruder(1e-9 * static_cast<double>(t)); }});
    for (std::int64_t t = 0; t < 6'000'000'000; t += 20'000'000) found.look(t, t + 20'000'000);
    return found;
  }
};

// The vehicle at rest is passed after 2 s. Bodies touch while their centres are within 0.5 m: at 0.3 m aside, while the
// intruder is within 0.4 m along x, for 0.2667 s.
TEST(SwarmWatch, TellsTouchesAtRestFromContacts) {
  const SwarmWatch aside = Passing{10.0, 0.5001}.watch();
  EXPECT_TRUE(aside.contacts().empty() && aside.touched_at_rest().empty());
  EXPECT_EQ(aside.least_gap(), 1e9) << "the vehicle never moved";
  const SwarmWatch rests = Passing{10.0, 0.3}.watch();
  EXPECT_TRUE(rests.contacts().empty());
  ASSERT_EQ(rests.touched_at_rest().size(), 1u);
  EXPECT_EQ(rests.touched_at_rest()[0].intruder, 0);
  EXPECT_NEAR(1e-9 * static_cast<double>(rests.touched_at_rest()[0].time), 2.0 - 0.4 / 3.0, 0.02);
  // It sets off while it is touched: that is a contact, too.
  const SwarmWatch sets_off = Passing{2.1, 0.3}.watch();
  EXPECT_EQ(sets_off.touched_at_rest().size(), 1u);
  ASSERT_EQ(sets_off.contacts().size(), 1u);
  EXPECT_NEAR(1e-9 * static_cast<double>(sets_off.contacts()[0].time), 2.1, 0.02);
  EXPECT_EQ(sets_off.contacts()[0].first, 0);
  EXPECT_EQ(sets_off.contacts()[0].second, -1);
  EXPECT_EQ(sets_off.contacts()[0].intruder, 0);
  // It flies ahead of it at 2 m/s and is caught up with.
  const SwarmWatch caught = Passing{1.0, 0.3}.watch();
  EXPECT_TRUE(caught.touched_at_rest().empty());
  EXPECT_EQ(caught.contacts().size(), 1u);
  EXPECT_LT(caught.least_gap(), 0.0);
}

// Against places 20 us apart.
TEST(SwarmWatch, TellsThemApartAsSamplesDo) {
  tern_test::Random random(11);
  for (int k = 0; k < tern_test::scaled(200); ++k) {
    const Passing passing{random.real(0.0, 3.5), random.real(0.0, 0.6)};
    if (std::abs(passing.aside - 0.5) < 1e-3) continue;
    double rests = 1e9, moves = 1e9;
    for (double t = 0.0; t < 6.0; t += 2e-5) {
      double& nearest = t > passing.sets_off ? moves : rests;
      nearest = std::min(nearest, distance_between(passing.vehicle(t), passing.intruder(t)) - 0.5);
    }
    if (std::abs(rests) < 1e-3 || std::abs(moves) < 1e-3) continue;
    const SwarmWatch watch = passing.watch();
    EXPECT_EQ(watch.contacts().size(), moves < 0.0 ? 1u : 0u) << passing.sets_off << " " << passing.aside;
    // Where it touches both, the order decides whether the touch at rest counts.
    const std::size_t most = rests < 0.0 ? 1 : 0;
    EXPECT_LE(watch.touched_at_rest().size(), most) << passing.sets_off << " " << passing.aside;
    EXPECT_GE(watch.touched_at_rest().size(), moves < 0.0 ? 0 : most) << passing.sets_off << " " << passing.aside;
  }
}

TEST(Intruders, TouchNoVehicleInMotion) {
  SwarmSettings settings;
  settings.links.loss = 0.1;
  settings.links.delay_max = 0.1;
  settings.clock_error = 0.01;
  double least = 1e9;
  for (int run = 0; run < tern_test::scaled(4); ++run) {
    settings.seed = 20 + static_cast<std::uint64_t>(run);
    const SwarmWorld world = world_among("T3-6:1", 3, settings.seed);
    const SwarmResult result = fly_swarm(world, settings);
    EXPECT_TRUE(result.contacts.empty()) << run;
    EXPECT_EQ(result.arrived(), 6) << run;
    EXPECT_EQ(result.disagreed, 0u) << run;
    least = std::min(least, result.least_gap);
  }
  EXPECT_GT(least, 0.0);
  EXPECT_LT(least, 3.0) << "they met";
}

/// Where a vehicle in motion and an intruder are nearer than their sizes in a film: who they are.
std::set<std::pair<int, int>> contacts_in_film(const SwarmWorld& world, const SwarmResult& result) {
  std::set<std::pair<int, int>> found;
  for (std::size_t row = 0; row < result.film.size(); ++row) {
    for (std::size_t i = 0; i < result.film[row].size(); ++i) {
      const tern::Sample& vehicle = result.film[row][i];
      for (std::size_t k = 0; k < world.intruders.size(); ++k) {
        const double size = world.body_radius + world.intruders[k].radius;
        const bool touches = distance_between(vehicle.position, result.intruder_film[row][k]) < size - 1e-3;
        if (touches && length(vehicle.velocity) > 0.01) found.emplace(static_cast<int>(i), static_cast<int>(k));
      }
    }
  }
  return found;
}

// Vehicles are told a hundredth of what intruders may do: some are met, and the watch finds each that is seen in the
// film.
TEST(Intruders, ThoseThatBreakTheirBoundsAreFound) {
  SwarmSettings settings;
  settings.links.delay_max = 0.1;
  SwarmWorld world = swarm_world("T3-10:1");
  add_intruders(world, {5, 0.0, 2.0, 0.01}, 1);
  const SwarmResult result = fly_swarm(world, settings);
  const std::set<std::pair<int, int>> seen = contacts_in_film(world, result);
  EXPECT_FALSE(seen.empty());
  std::set<std::pair<int, int>> watched;
  for (const SwarmContact& contact : result.contacts) watched.emplace(contact.first, contact.intruder);
  EXPECT_TRUE(std::includes(watched.begin(), watched.end(), seen.begin(), seen.end()));
  EXPECT_LT(result.least_gap, 0.0);
}

TEST(Intruders, AreFlownTheSameAgain) {
  SwarmSettings settings;
  settings.links.loss = 0.2;
  settings.links.delay_max = 0.05;
  settings.clock_error = 0.01;
  SwarmWorld world = world_among("swap-3:1", 2, 1);
  world.time_limit = 6.0;
  SwarmRecord record;
  const SwarmResult result = fly_swarm(world, settings, nullptr, &record);
  settings.threads = 3;
  EXPECT_EQ(fly_swarm(world, settings).hash, result.hash);
  SwarmWorld empty = world;
  empty.intruders.clear();
  EXPECT_NE(fly_swarm(empty, settings).hash, result.hash);
  SwarmRecord read = read_swarm_record(write_swarm_record(record));
  EXPECT_EQ(lines_of(read.intruders), lines_of(world.intruders));
  EXPECT_EQ(replay_swarm(read), "");
  read.intruders.pop_back();
  EXPECT_NE(replay_swarm(read), "");
  read.intruders.assign(std::size_t{kMostIntruders} + 1, world.intruders[0]);
  EXPECT_THROW(replay_swarm(read), std::runtime_error);
}

// In processes, ticks are late.
TEST(SwarmProcesses, FlyAmongIntruders) {
  SwarmSettings settings;
  settings.tick_hz = 20.0;
  settings.late = 0.5;
  SwarmWorld world = world_among("swap-2:1", 2, 1);
  world.time_limit = 8.0;
  SwarmRecord record;
  const SwarmResult result = fly_swarm_in_processes(world, settings, record);
  EXPECT_TRUE(result.contacts.empty());
  EXPECT_FALSE(result.intruder_film.empty());
  EXPECT_EQ(replay_swarm(record), "");
}

}  // namespace
