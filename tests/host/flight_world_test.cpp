// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The simulator's world: its families, what a start may assume of it, and the settings that one file can hold.
#include "host/flight/flight_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "host/atomic_file.hpp"
#include "host/flight/assumed_ball.hpp"
#include "host/flight/clear_ends.hpp"
#include "host/flight/flight_pads.hpp"
#include "host/flight/flight_specs.hpp"
#include "host/flight/full_knowledge.hpp"
#include "host/flight/world_family.hpp"
#include "host/text_records.hpp"
#include "support/own_folder.hpp"
#include "support/random.hpp"

namespace {

using tern_host::FamilyMember;
using tern_host::FlightWorld;
using tern_host::read_flight_world;

FlightWorld member(const std::string& name) {
  return read_flight_world(name, {});
}

/// A start in the middle of a voxel of 0.2 m.
double assumed_beside(const std::vector<tern::Box>& blocks, const std::vector<tern_host::Cylinder>& cylinders) {
  FlightWorld world;
  world.boundary = {{-4.0, -4.0, -4.0}, {4.0, 4.0, 4.0}};
  world.start = {0.1, 0.1, 0.1};
  world.blocks = blocks;
  world.cylinders = cylinders;
  tern::GridSpec grid{};
  grid.origin = {-4.0, -4.0, -4.0};
  grid.cell = 0.2;
  return tern_host::assumed_radius(world, grid, 1.55);
}

TEST(AssumedBall, HoldsNothingOfAnObstacle) {
  EXPECT_EQ(assumed_beside({}, {}), 1.55);
  // The voxel that reaches from x = 1.0 to 1.2 has corners at (1.1, 0.1, 0.1) from the start.
  const double before = std::sqrt(1.23) - 1e-6;
  EXPECT_NEAR(assumed_beside({{{1.15, -1.0, -1.0}, {2.0, 1.0, 1.0}}}, {}), before, 1e-9);
  EXPECT_NEAR(assumed_beside({}, {{1.5, 0.1, -1.0, 1.0, 0.35}}), before, 1e-9);
  // An obstacle that begins where a voxel ends is in the next voxel alone.
  EXPECT_NEAR(assumed_beside({{{1.2, -1.0, -1.0}, {2.0, 1.0, 1.0}}}, {}), std::sqrt(1.71) - 1e-6, 1e-9);
  EXPECT_EQ(assumed_beside({}, {{2.5, 0.1, -1.0, 1.0, 0.35}}), 1.55);
  // The start's own voxel.
  EXPECT_NEAR(assumed_beside({{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}}, {}), std::sqrt(0.03) - 1e-6, 1e-9);
}

/// Where the ball at the start holds what the sensor needs, it is the only one. In a corridor there are more along it,
/// and all of them lie in it.
TEST(AssumedBall, CorridorsHaveMoreAlongThem) {
  tern::GridSpec grid{};
  grid.cell = 0.1;
  grid.radius = 0.35;
  FlightWorld world;
  world.start = {0.0, 0.0, 0.0};
  world.boundary = {{-5.0, -0.95, -1.0}, {5.0, 0.95, 1.0}};
  grid.origin = {-6.0, -2.0, -2.0};
  ASSERT_EQ(tern_host::assumed_balls(world, grid).size(), 1u);
  for (const bool along_y : {false, true}) {
    world.boundary = {{-5.0, -0.6, -2.0}, {5.0, 0.6, 2.0}};
    if (along_y) world.boundary = {{-0.6, -5.0, -2.0}, {0.6, 5.0, 2.0}};
    double least = 0.0;
    double most = 0.0;
    for (const tern_host::AssumedBall& ball : tern_host::assumed_balls(world, grid)) {
      EXPECT_LT(ball.radius, std::sqrt(0.51));  // the nearest voxel beyond a wall
      EXPECT_GE(clearance(world, ball.center), 0.35);
      least = std::min(least, along_y ? ball.center.y : ball.center.x);
      most = std::max(most, along_y ? ball.center.y : ball.center.x);
    }
    EXPECT_LT(least, -0.7);
    EXPECT_GT(most, 0.7);
  }
}

TEST(WorldFamily, NamesSayFamilySpeedAndSeed) {
  FamilyMember m;
  ASSERT_TRUE(tern_host::parse_member("P25@8:17", m));
  EXPECT_EQ(m.family, "P25");
  EXPECT_EQ(m.speed, 8.0);
  EXPECT_EQ(m.seed, 17u);
  for (const char* const none : {"P25", "P25:", "P25@:1", "P26:1", "P25@-1:1", "P25:1x", "worlds/P25:1", ":1"}) {
    EXPECT_FALSE(tern_host::parse_member(none, m)) << none;
  }
}

TEST(WorldFamily, EveryMemberIsAWorldWithClearEnds) {
  for (const std::string& family : tern_host::family_names()) {
    for (int seed = 1; seed <= tern_test::scaled(40); ++seed) {
      const std::string name = family + ":" + std::to_string(seed);
      const FlightWorld world = member(name);
      const bool on_ground = family == "K";
      EXPECT_EQ(world.column.radius > 0.0 && world.landing.speed > 0.0, on_ground) << name;
      EXPECT_GT(on_ground ? clearance_of_flight(world, world.start, 0.0) : clearance(world, world.start), 0.6) << name;
      EXPECT_GT(on_ground ? clearance_of_flight(world, world.goal, 0.0) : clearance(world, world.goal), 0.6) << name;
      EXPECT_EQ(world.settings.seed, static_cast<std::uint64_t>(seed)) << name;
      EXPECT_TRUE(world.warnings.empty()) << name << ": " << world.warnings[0];
      EXPECT_NO_THROW(tern_host::refuse_occupied_ends(world, tern_host::map_spec_of(world).origin)) << name;
    }
  }
}

TEST(WorldFamily, SeedsGiveOtherWorldsAndSpeedsTheSame) {
  const FlightWorld one = member("P25:1");
  const FlightWorld two = member("P25:2");
  const FlightWorld fast = member("P25@12:1");
  EXPECT_NE(one.cylinders[0].x, two.cylinders[0].x);
  ASSERT_EQ(one.cylinders.size(), fast.cylinders.size());
  EXPECT_EQ(one.cylinders.back().y, fast.cylinders.back().y);
  EXPECT_EQ(fast.settings.v_max, 12.0);
}

/// No step of a hill's or slope's ground is higher than 30 degrees allow, and flights begin above it.
TEST(WorldFamily, GroundRisesByThirtyDegreesAtMost) {
  for (const char* const name : {"H:1", "H:2", "T30:1", "T30:2", "T30:3"}) {
    const FlightWorld world = member(name);
    const auto ground = [&world](double x, double y) {
      double top = 0.0;
      for (const tern::Box& b : world.blocks) {
        if (b.lower.x <= x && x < b.upper.x && b.lower.y <= y && y < b.upper.y) top = std::max(top, b.upper.z);
      }
      return top;
    };
    for (double x = 1.0; x < world.boundary.upper.x - 2.0; x += 0.83) {
      for (double y = -6.9; y < 6.0; y += 1.31) {
        const double here = ground(x, y);
        EXPECT_GT(here, 0.0) << name;
        EXPECT_LE(std::abs(ground(x + 0.8, y) - here), 0.8 * 0.5774 + 0.22) << name << " " << x << " " << y;
        EXPECT_LE(std::abs(ground(x, y + 0.8) - here), 0.8 * 0.5774 + 0.22) << name << " " << x << " " << y;
      }
    }
    EXPECT_NEAR(world.start.z - ground(world.start.x, world.start.y), 1.5, 0.2) << name;
    EXPECT_NEAR(world.goal.z - ground(world.goal.x, world.goal.y), 1.5, 0.2) << name;
  }
}

/// Mean of a Poisson forest, gaps of a thick one, and the part of the area that it covers.
TEST(WorldFamily, ForestsAreAsDenseAsTheyClaim) {
  double trees = 0.0;
  for (int seed = 1; seed <= 50; ++seed)
    trees += static_cast<double>(member("P25:" + std::to_string(seed)).cylinders.size());
  EXPECT_NEAR(trees / 50.0, 1800.0 / 25.0, 4.0);
  const FlightWorld thick = member("S20:3");
  double covered = 0.0;
  for (std::size_t i = 0; i < thick.cylinders.size(); ++i) {
    const tern_host::Cylinder& a = thick.cylinders[i];
    covered += M_PI * a.radius * a.radius;
    for (std::size_t j = 0; j < i; ++j) {
      const tern_host::Cylinder& b = thick.cylinders[j];
      EXPECT_GT(std::hypot(a.x - b.x, a.y - b.y), a.radius + b.radius + 1.49);
    }
  }
  EXPECT_NEAR(covered / 4000.0, 0.2, 0.005);
}

/// Every room of a maze can be reached: a plan that knows it all gets through.
TEST(WorldFamily, MazesAndStoreysHaveAWay) {
  for (const char* const name : {"M:1", "M:2", "O:1", "C:1", "B:1"}) {
    EXPECT_GT(full_knowledge_time(member(name)), 5.0) << name;
  }
}

/// Why a flight with these settings is refused; empty where it is not.
std::string refusal(const std::string& world, const std::vector<std::string>& overrides) {
  try {
    read_flight_world(world, overrides);
  } catch (const tern_host::RecordError& error) {
    return error.reason();
  }
  return "";
}

/// Why no flight can be at its ends, in a room with a start, a goal and a via that are clear unless `records` say so.
std::string ends_refusal(const std::string& records) {
  const std::string path = tern_test::own_folder() + "ends.txt";
  tern_host::write_files({{path, "boundary 0 0 0 20 12 4\nstart 2 6 1.5\ngoal 18 6 1.5\n" + records}});
  const FlightWorld world = read_flight_world(path, {});
  try {
    tern_host::refuse_occupied_ends(world, {-10.0, -4.0, -0.4});
  } catch (const tern_host::RecordError& error) {
    return std::string(error.what()).substr(path.size());
  }
  return "";
}

void expect_refused(const std::string& records, const std::string& place, const std::string& why) {
  const std::string text = ends_refusal(records);
  EXPECT_EQ(text.find(place + ": the flight cannot be at its "), 0u) << records << text;
  EXPECT_NE(text.find(why), std::string::npos) << records << text;
}

TEST(FlightWorld, SaysWhatToDoAboutTime) {
  const auto refusal = [](const std::string& record) {
    const std::string path = tern_test::own_folder() + "time.txt";
    tern_host::write_files({{path, "boundary 0 0 0 20 12 4\n" + record + "\n"}});
    try {
      read_flight_world(path, {});
    } catch (const tern_host::RecordError& error) {
      return std::string(error.what()).substr(path.size());
    }
    return std::string();
  };
  EXPECT_EQ(refusal("keepout 1 1 1 2 2 2"), "");
  EXPECT_EQ(refusal("keepout 1 1 1 2 2 2 during 0 5 0.5"), "");
  EXPECT_EQ(refusal("keepout 1 1 1 2 2 2 during 5 0"), ":2: 'during' ends before it begins, or at once");
  EXPECT_EQ(
      refusal("track a ball 0.3 at 3 3 1"),
      ":2: there is no record 'track' for flights: what moves in a flight's world is a 'thing', which says how it "
      "moves. 'tern plan' plans among tracks");
}

TEST(ClearEnds, AreAtLeastTheRadiusFromEverything) {
  EXPECT_EQ(ends_refusal(""), "");
  // The ground is as far away as it must be, and then not.
  EXPECT_EQ(ends_refusal("goal 18 6 0.35\n"), "");
  expect_refused("goal 18 6 0.34\n", ":4",
                 "goal: the ground, the boundary's lower face, is 0.34 m away, at 18.00 6.00 0.00. "
                 "All of it must be 0.35 m away: body_radius 0.25, tracking_margin 0.1, pose_margin 0. To land, give "
                 "the record land");
  expect_refused("goal 18 6 0.49\npose_margin 0.15\n", ":4", "must be 0.50 m away");
  expect_refused("start 2 6 0\n", ":4", "start: the ground");
  EXPECT_EQ(ends_refusal("start 2 6 0.15\ncolumn 0.05 1.3 3\ngoal 18 6 0.15\nland 0.05 0.5\n"), "");
  expect_refused("start 2 6 3.9\n", ":4", "start: the ceiling, the boundary's upper face, is 0.10 m");
  expect_refused("goal 0.2 6 1\n", ":4", "a wall, the boundary's lower face along x, is 0.20 m");
  expect_refused("goal 18 11.8 1\n", ":4", "a wall, the boundary's upper face along y, is 0.20 m");
  expect_refused("goal 25 6 1.5\n", ":4", "goal: 25.00 6.00 1.50 is outside the boundary");
}

TEST(ClearEnds, KnowBlocksCylindersAndTheirVoxels) {
  expect_refused("block 17 5 0 19 7 1.3\n", ":3", "a block is 0.20 m away, at 18.00 6.00 1.30. All of it");
  expect_refused("block 17 5 1 19 7 2\n", ":3", "a block is 0.00 m away");
  expect_refused("cylinder 18 7 0 4 0.8\n", ":3", "a cylinder is 0.20 m away, at 18.00 6.20 1.50");
  // 0.38 m away, in voxels that are 0.3 m away.
  const std::string voxels = "and the voxels of 0.2 m that hold a part of it 0.30 m";
  expect_refused("block 17 5 0 19 7 1.12\n", ":3", "a block is 0.38 m away, at 18.00 6.00 1.12, " + voxels);
  expect_refused("cylinder 18 6 0 1.12 0.8\n", ":3", voxels);
  EXPECT_EQ(ends_refusal("block 17 5 0 19 7 1.0\n"), "");
  EXPECT_EQ(ends_refusal("cylinder 18 6 0 1.0 0.8\n"), "");
  EXPECT_EQ(ends_refusal("cell 0.1\nblock 17 5 0 19 7 1.1\n"), "");
  // What appears later is not looked at.
  EXPECT_EQ(ends_refusal("appear 1 block 17 5 1 19 7 2\n"), "");
}

TEST(ClearEnds, BreakNoFence) {
  expect_refused("keepout 17 5 0 17.9 7 4\n", ":3",
                 "goal: it is 0.10 m from the 'keepout' of line 4, which must be 0.35 m");
  expect_refused("keepout 17 5 0 19 7 4\n", ":3", "goal: it is in the 'keepout' of line 4");
  expect_refused("keepin 0 0 0 17.5 12 4\n", ":3", "goal: it is 0.50 m outside of the 'keepin' of line 4");
  EXPECT_EQ(ends_refusal("keepin 0 0 0 18 12 4\nkeepout 17 5 0 17.65 7 4\n"), "");
}

TEST(ClearEnds, ViasMayBeOffByTheirToleranceOrSkipped) {
  expect_refused("via 10 6 0.2 0.1\n", ":4", "via: the ground");
  EXPECT_EQ(ends_refusal("via 10 6 0.2 0.16\n"), "");
  EXPECT_EQ(ends_refusal("via 10 6 0.2\nvia_policy skip\n"), "");
}

TEST(ClearEnds, GoalsThatAreMovedOnPurposeAreFlownTo) {
  EXPECT_EQ(ends_refusal("cylinder 10 6 0 4 0.5\ngoal_place occupied\n"), "");
  EXPECT_EQ(ends_refusal("goal_place outside\n"), "");
}

TEST(SensorFov, IsAllAroundForALidarAlone) {
  EXPECT_EQ(refusal("P25:1", {"sensor=lidar", "sensor_fov=6.2832,0.7"}), "");
  EXPECT_EQ(refusal("P25:1", {"sensor_fov=6.2832,0.7", "sensor=lidar"}), "");
  EXPECT_EQ(refusal("P25:1", {"sensor=lidar", "sensor_fov=1.57,1.29"}), "");
  EXPECT_EQ(refusal("P25:1", {"sensor_fov=2.618,0.1745"}), "");
  const std::string allowed = ": both are in rad, 0.174 to 2.62; with sensor lidar, the first may also be 6.2832";
  EXPECT_EQ(refusal("P25:1", {"sensor_fov=6.2832,0.7"}), "sensor_fov 6.28318531 0.7" + allowed);
  EXPECT_EQ(refusal("P25:1", {"sensor_fov=2.7,0.7"}), "sensor_fov 2.7 0.7" + allowed);
  EXPECT_EQ(refusal("P25:1", {"sensor_fov=1.5,0.1"}), "sensor_fov 1.5 0.1" + allowed);
  EXPECT_EQ(refusal("P25:1", {"sensor=lidar", "sensor_fov=3.5,0.7"}), "sensor_fov 3.5 0.7" + allowed);
  EXPECT_EQ(refusal("P25:1", {"sensor=lidar", "sensor_fov=6.2832,6.2832"}), "sensor_fov 6.2832 6.2832" + allowed);
  EXPECT_THROW(tern_host::flight_settings({"sensor_fov=6.2832,0.7"}), tern_host::RecordError);
  const tern_host::FlightSettings around = tern_host::flight_settings({"sensor_fov=6.2832,0.7", "sensor=lidar"});
  EXPECT_LE(around.fov_horizontal, 2.0 * M_PI);
  EXPECT_EQ(around.fov_vertical, 0.7);
}

TEST(FlightYawRecord, DegreesAreRefused) {
  EXPECT_EQ(refusal("P25:1", {"yaw=heading,-1.57"}), "");
  EXPECT_EQ(tern_host::flight_settings({"yaw=heading,1.5"}).yaw_heading, 1.5);
  EXPECT_EQ(refusal("P25:1", {"yaw=heading,90"}),
            "'yaw heading' is in rad, at most 6.2832, found 90; if that is in degrees, write 1.5708");
  EXPECT_NE(refusal("P25:1", {"yaw_rate=45"}).find("'yaw_rate' is in rad/s, at most"), std::string::npos);
  EXPECT_NE(refusal("P25:1", {"yaw_acceleration=180"}).find("is in rad/s^2, at most"), std::string::npos);
  EXPECT_NE(refusal("P25:1", {"sensor_fov=90,74"}).find("; if that is in degrees, write 1.5708 1.2915"),
            std::string::npos);
  EXPECT_NE(
      refusal("P25:1", {"sensor=lidar", "sensor_fov=360,40"}).find("; if that is in degrees, write 6.2832 0.6981"),
      std::string::npos);
}

TEST(SensorFov, OfAFileMayComeBeforeItsSensor) {
  const std::string path = tern_test::own_folder() + "tern_lidar_world.txt";
  const std::string world = "boundary -5 -5 0 5 5 3\nsensor_fov 6.2832 0.7\n";
  tern_host::write_files({{path, world + "sensor lidar\n"}});
  EXPECT_EQ(refusal(path, {}), "");
  EXPECT_EQ(read_flight_world(path, {}).settings.fov_horizontal, 2.0 * M_PI);
  EXPECT_NE(refusal(path, {"sensor=camera"}), "");
  tern_host::write_files({{path, world}});
  EXPECT_NE(refusal(path, {}), "");
  EXPECT_EQ(refusal(path, {"sensor=lidar"}), "");
}

}  // namespace
