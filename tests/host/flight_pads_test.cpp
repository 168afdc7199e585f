// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where simulated vehicles stand, what counts as a contact there, and flights from the ground to the ground.
#include "host/flight/flight_pads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "host/atomic_file.hpp"
#include "host/flight/flight_replay.hpp"
#include "host/flight/simulated_flight.hpp"
#include "host/text_records.hpp"
#include "support/own_folder.hpp"
#include "support/random.hpp"
#include "support/world_refusal.hpp"

namespace {

using tern_host::FlightWorld;
using tern_host::Pad;

FlightWorld standing() {
  FlightWorld world;
  world.boundary = {{-10.0, -10.0, 0.0}, {10.0, 10.0, 5.0}};
  world.start = {0.0, 0.0, 0.15};
  world.goal = {5.0, 0.0, 1.15};
  world.column = {{0.0, 0.0, 0.05}, 1.0, 3.0};
  world.landing = {1.05, 0.5};
  world.blocks.push_back({{4.0, -1.0, 0.0}, {6.0, 1.0, 1.0}});
  return world;
}

TEST(FlightPads, AreWhereTheVehicleStands) {
  EXPECT_TRUE(tern_host::pads_of(FlightWorld{}).empty());
  const std::vector<Pad> pads = tern_host::pads_of(standing());
  ASSERT_EQ(pads.size(), 2u);
  EXPECT_EQ(pads[0].ground, 0.05);
  EXPECT_EQ(pads[1].place.x, 5.0);
  EXPECT_EQ(tern_host::pad_below(pads, {5.0, 0.3, 9.0}, 0.31), &pads[1]);
  EXPECT_EQ(tern_host::pad_below(pads, {5.0, 0.3, 9.0}, 0.29), nullptr);
}

/// The floor, a roof, and a stone of 1.1 m beside it.
TEST(FlightPads, OnlyTheGroundDoesNotCount) {
  FlightWorld world = standing();
  EXPECT_DOUBLE_EQ(tern_host::clearance_of_flight(world, {0.0, 0.2, 0.15}, 0.1), 0.15);
  EXPECT_DOUBLE_EQ(tern_host::clearance_of_flight(world, {0.0, 0.0, 0.15}, 0.1), 4.0);   // the roof is higher
  EXPECT_DOUBLE_EQ(tern_host::clearance_of_flight(world, {5.0, 0.0, 1.15}, 0.1), 3.85);  // the ceiling
  world.blocks.push_back({{5.5, -1.0, 0.0}, {6.0, 1.0, 1.1}});
  EXPECT_NEAR(tern_host::clearance_of_flight(world, {5.0, 0.0, 1.15}, 0.1), 0.502494, 1e-6);
}

/// Why a world with these further records is refused.
std::string refusal_on_ground(const std::string& records) {
  return tern_test::world_refusal("boundary -5 -5 0 15 5 4\nstart 0 0 0.15\ngoal 8 0 1\n" + records);
}

TEST(FlightPads, WhatIsStatedMustBeTrue) {
  EXPECT_EQ(refusal_on_ground("column 0.05 1.3 3\n"), "");
  EXPECT_EQ(refusal_on_ground("column 0.05 1.3 3\nblock -1 -1 -1 1 1 0.05\n"), "");
  EXPECT_EQ(refusal_on_ground("column -0.1 1.3 3\n"), "column: the ground is higher, at 0");
  EXPECT_EQ(refusal_on_ground("column 0.05 1.3 4\n"), "column: it is not within the boundary");
  EXPECT_EQ(refusal_on_ground("column 0.05 5.5 3\n"), "column: it is not within the boundary");
  EXPECT_EQ(refusal_on_ground("column 0.05 1.3 3\nblock 1 -1 0 2 1 0.3\n"),
            "column: a block is in it, 1 m from its axis and up to 0.3 m high");
  EXPECT_EQ(refusal_on_ground("column 0.05 1.3 3\ncylinder 1 0 0 4 0.25\n"),
            "column: a cylinder is in it, 0.75 m from its axis");
  EXPECT_EQ(refusal_on_ground("column 0.05 1.3 3\ncylinder 2 0 0 4 0.25\n"), "");
  EXPECT_EQ(refusal_on_ground("column 0.05 1.3\n"),
            "'column' needs the ground's height, a radius and a height, found 2");
  EXPECT_EQ(refusal_on_ground("column 0.05 0 3\n"), "column 0 is not within 0.01 .. 100");
  EXPECT_EQ(refusal_on_ground("land 0.05 0\n"), "land 0 is not within 0.01 .. 100");
  EXPECT_EQ(refusal_on_ground("land 0.05\n"), "'land' needs the ground's height and a speed, found 1");
  EXPECT_EQ(refusal_on_ground("via 1 0 1\nland 0.05 0.5\n"),
            "land is for worlds without vias, and without goal_jitter");
}

/// The watch looks at every tick, and the record flies again to the same bits.
TEST(FlightPads, FlightsFromTheGroundLand) {
  for (int seed = 1; seed <= tern_test::scaled(4); ++seed) {
    const std::string name = "K:" + std::to_string(seed);
    std::string record;
    const tern_host::FlightResult result =
        tern_host::simulate_flight(tern_host::read_flight_world(name, {}), {}, &record);
    EXPECT_EQ(result.status, "reached") << name << ": " << result.reason;
    EXPECT_EQ(result.reason, "it stands where it was to land") << name;
    EXPECT_EQ(tern_host::replay_flight(record).difference, "") << name;
  }
}

/// A landing at 12 m on a slope that rises from 6 m on, in steps of 0.1 m.
std::string landing_on_slope(double degrees) {
  const double rise = std::tan(degrees * 3.14159265358979 / 180.0);
  const double ground = rise * 6.0;
  std::string text = "boundary 0 -8 0 24 8 24\nsensor d435\nyaw unseen\nstart 3 0 1.5\n";
  text += tern_host::record_line("goal", {12.0, 0.0, ground + 0.25 * rise + 0.2});
  text += tern_host::record_line("land", {ground + 0.4 * rise + 0.05, 0.5});
  for (int k = 61; k < 240; ++k) {
    text += tern_host::record_line("block", {0.1 * k, -8.0, 0.0, 0.1 * (k + 1), 8.0, rise * (0.1 * k - 6.0)});
  }
  const std::string path = tern_test::own_folder() + "slope.txt";
  tern_host::write_file(path, text);
  return tern_host::simulate_flight(tern_host::read_flight_world(path, {})).reason;
}

/// Over a disc of 0.7 m, 10 degrees rise by 0.12 m and 30 by 0.4 m, two voxels.
TEST(FlightPads, GentleSlopesAreLandedOnAndSteepOnesAreNot) {
  EXPECT_EQ(landing_on_slope(10.0), "it stands where it was to land");
  EXPECT_EQ(landing_on_slope(30.0), "it cannot land: the ground there is not flat, or something is on it");
}

/// A pole grows out of the place to land, once the vehicle descends: it is a threat, and nothing is touched.
TEST(FlightPads, WhatAppearsOnTheWayDownIsNoGround) {
  const std::string path = tern_test::own_folder() + "appearing_world.txt";
  tern_host::write_file(path,
                        "boundary -5 -5 0 15 5 4\nstart 0 0 0.15\ncolumn 0.05 1.3 3\ngoal 3 0 0.15\nland 0.05 0.1\n"
                        "appear 5.5 block 3.4 -0.1 0 3.6 0.1 1.5\ntime_limit 20\n");
  const tern_host::FlightResult result = tern_host::simulate_flight(tern_host::read_flight_world(path, {}));
  EXPECT_NE(result.status, "invariant") << result.reason;
  EXPECT_FALSE(result.contact.happened) << result.reason;
}

}  // namespace
