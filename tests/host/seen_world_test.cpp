// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/seen_world.hpp"

#include <gtest/gtest.h>

#include <string>

#include "host/flight/ray_length.hpp"
#include "host/flight/simulated_flight.hpp"
#include "host/things/thing_record.hpp"

namespace {

using tern_host::FlightWorld;

/// How far one sees along x at time t, s, past a thing that walks along y at 1 m/s.
double sight(const std::string& shape, int things_seen, double t) {
  FlightWorld world;
  world.boundary = {{-1.0, -10.0, -10.0}, {20.0, 10.0, 10.0}};
  world.settings.things_seen = things_seen;
  const std::string line = "thing a " + shape + " walk 1 1000 0 5 0 0 0 5 8 0 0";
  world.things.push_back(tern_host::read_thing(tern_host::split_words(line, false), {"world.txt", 1}));
  const tern_host::ThingsInFlight things(world);
  tern_host::SeenWorld seen(world, things);
  seen.move_to(static_cast<std::int64_t>(1e9 * t));
  return tern_host::ray_length(seen.world(), {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0});
}

TEST(SeenWorld, ThingsAreWhereTheyAre) {
  EXPECT_DOUBLE_EQ(sight("box 0.5 0.5 0.5", 1, 0.0), 4.5);
  EXPECT_DOUBLE_EQ(sight("cylinder 0.25 2", 1, 0.0), 4.75);
  EXPECT_DOUBLE_EQ(sight("box 0.5 0.5 0.5", 1, 2.0), 20.0);  // it is 2 m aside
  EXPECT_DOUBLE_EQ(sight("box 0.5 0.5 0.5", 0, 0.0), 20.0);
}

// Of a ball's eight discs, the middle two are as wide as the ball.
TEST(SeenWorld, BallsLookNoSmallerThanTheyAre) {
  for (const double height : {0.0, 0.1, 0.3, 0.45}) {
    FlightWorld world;
    world.boundary = {{-1.0, -10.0, -10.0}, {20.0, 10.0, 10.0}};
    world.settings.things_seen = 1;
    world.things.push_back(
        tern_host::read_thing(tern_host::split_words("thing a ball 0.5 hunt 5 0 0 1 1 0", false), {"world.txt", 1}));
    const tern_host::ThingsInFlight things(world);
    tern_host::SeenWorld seen(world, things);
    seen.move_to(0);
    const double near = tern_host::ray_length(seen.world(), {0.0, 0.0, height}, {1.0, 0.0, 0.0});
    const double ball = 5.0 - std::sqrt(0.25 - height * height);
    EXPECT_LE(near, ball) << height;
    EXPECT_GE(near, 4.5) << height;
  }
}

// Seen things that are tracked block no voxel for long: the flight arrives.
TEST(SeenWorld, FlightsAmongSeenThingsArrive) {
  for (const char* const name : {"T4:0", "MF:1"}) {
    const tern_host::FlightResult result =
        tern_host::simulate_flight(tern_host::read_flight_world(name, {"things_seen=1"}));
    EXPECT_EQ(result.status, "reached") << name << ": " << result.reason;
    EXPECT_EQ(result.things.in_motion(), 0) << name;
  }
}

}  // namespace
