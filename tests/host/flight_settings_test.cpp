// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Settings of flights: what is refused, and how the message says it.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "host/flight/flight_specs.hpp"
#include "host/flight/flight_world.hpp"
#include "host/text_records.hpp"
#include "support/world_refusal.hpp"

namespace {

/// Why a flight with this setting is refused; empty where it is not.
std::string setting_refusal(const std::string& setting) {
  try {
    tern_host::flight_settings({setting});
  } catch (const tern_host::RecordError& error) {
    return error.reason();
  }
  return "";
}

TEST(FlightSettings, AreNotRounded) {
  EXPECT_EQ(setting_refusal("hits=1.5"), "hits 1.5 is not a whole number");
  EXPECT_EQ(setting_refusal("support=0.2"), "support 0.2 is not a whole number");
  EXPECT_EQ(setting_refusal("work_per_tick=4000.5"), "work_per_tick 4000.5 is not a whole number");
  EXPECT_EQ(setting_refusal("speckle_filter=0.9"), "speckle_filter 0.9 is not a whole number");
  EXPECT_EQ(setting_refusal("sensor_size=160.5,120"), "sensor_size 160.5 is not a whole number");
  EXPECT_EQ(setting_refusal("seed=0.5"), "seed 0.5 is not a whole number");
  EXPECT_EQ(setting_refusal("hits=2"), "");
}

TEST(FlightSettings, SayTheirRangesBriefly) {
  EXPECT_EQ(setting_refusal("seed=-1"), "seed -1 is not within 0 .. 9e+15");
  EXPECT_EQ(setting_refusal("v_max=0"), "v_max 0 is not within 0.01 .. 100");
  EXPECT_EQ(setting_refusal("sensor_size=7,120"), "sensor_size 7 is not within 8 .. 1000");
}

/// Faults are settings like the others.
TEST(FlightSettings, OfFaults) {
  const tern_host::FlightSettings s =
      tern_host::flight_settings({"pose_jump=0.2,1.5", "tick_skip=0.3,7", "goal_jitter=2,8", "frames_until=3",
                                  "appear_ahead=4,2.5", "goal_place=outside"});
  EXPECT_EQ(s.pose_jump.size, 0.2);
  EXPECT_EQ(s.pose_jump.every, 1.5);
  EXPECT_EQ(s.tick_skip.share, 0.3);
  EXPECT_EQ(s.tick_skip.longest, 7);
  EXPECT_EQ(s.goal_jitter.size, 2.0);
  EXPECT_EQ(s.goal_jitter.until, 8.0);
  EXPECT_EQ(s.frames_until, 3.0);
  EXPECT_EQ(s.appear_ahead.time, 4.0);
  EXPECT_EQ(s.appear_ahead.distance, 2.5);
  EXPECT_EQ(s.goal_place, "outside");
  EXPECT_EQ(tern_host::flight_settings({"goal_jitter=2"}).goal_jitter.until, tern_host::kLongestFlight);
}

TEST(FlightSettings, RefuseFaultsThatCannotBe) {
  EXPECT_EQ(setting_refusal("tick_skip=0.6,1"),
            "tick_skip: with runs of up to 1 ticks, at most 0.500 of all are skipped");
  EXPECT_EQ(setting_refusal("tick_skip=0.5,51"), "tick_skip 51 is not within 1 .. 50");
  EXPECT_EQ(setting_refusal("tick_skip=0.5,2.5"), "tick_skip 2.5 is not a whole number");
  EXPECT_EQ(setting_refusal("pose_jump=0.2"), "'pose_jump' needs two numbers, found 1");
  EXPECT_EQ(setting_refusal("goal_place=moon"), "goal_place is given, occupied or outside");
}

TEST(FlightSettings, ASensorHasAPlace) {
  EXPECT_EQ(setting_refusal("sensor=sonar"), "sensor is camera, lidar, d435 or livox");
  EXPECT_EQ(setting_refusal("mount=nose"), "mount is level or body");
  EXPECT_EQ(setting_refusal("mount_offset=3,0,0"), "mount_offset 3 is not within -2 .. 2");
  EXPECT_EQ(setting_refusal("mount_pitch=-90"), "mount_pitch -90 is not within -1.571 .. 1.571");
  EXPECT_EQ(setting_refusal("gimbal_pitch=0.5,0.4"), "gimbal_pitch 0.4 is not within 0.5 .. 1.571");
  EXPECT_EQ(setting_refusal("further_camera=0,-1.6"), "further_camera -1.6 is not within -1.571 .. 1.571");
  EXPECT_EQ(setting_refusal("depth_error=0.03"), "'depth_error' needs two numbers, found 1");
  EXPECT_EQ(setting_refusal("depth_error=0.03,0.005"), "");
}

TEST(FlightSettings, AD435IsFixedToTheBody) {
  const tern_host::FlightSettings s = tern_host::flight_settings({"sensor=d435", "sensor_hz=30"});
  EXPECT_EQ(s.sensor, "camera");
  EXPECT_EQ(s.mount.kind, "body");
  EXPECT_NEAR(s.fov_horizontal, 1.5184, 1e-4);
  EXPECT_NEAR(s.fov_vertical, 1.0123, 1e-4);
  EXPECT_EQ(s.sensor_hz, 30.0);
}

TEST(FlightSettings, ALivoxIsPitchedForward) {
  const tern_host::FlightSettings s = tern_host::flight_settings({"sensor=livox"});
  EXPECT_EQ(s.sensor, "lidar");
  EXPECT_EQ(s.mount.kind, "body");
  EXPECT_EQ(s.mount.pitch, -0.35);
  const tern::FlightSensor sensor = tern_host::flight_sensor_of(s);
  EXPECT_NEAR(sensor.raised - 0.5 * sensor.vertical, -0.1222, 1e-4);  // 7 degrees below its level
  EXPECT_NEAR(sensor.raised + 0.5 * sensor.vertical, 0.9076, 1e-4);   // and 52 above it
}

/// Why a world with these further lines is refused.
std::string refusal_of_world(const std::string& lines) {
  return tern_test::world_refusal("boundary -5 -5 0 15 5 3\ngoal 8 0 1\n" + lines);
}

TEST(FlightSettings, ObstaclesAppear) {
  EXPECT_EQ(refusal_of_world("appear 2 block 1 1 1 2 2 2\nappear 3.5 cylinder 4 0 0 3 0.3\n"), "");
  EXPECT_EQ(refusal_of_world("appear 2 wall 1 1 1 2 2 2\n"),
            "appear is followed by a time, and by a block or a cylinder");
  EXPECT_EQ(refusal_of_world("appear block 1 1 1 2 2 2\n"),
            "appear is followed by a time, and by a block or a cylinder");
  EXPECT_EQ(refusal_of_world("appear -1 cylinder 4 0 0 3 0.3\n"), "appear -1 is not within 0 .. 10000");
  EXPECT_EQ(refusal_of_world("appear 1 cylinder 4 0 0 3\n"), "'cylinder' needs x y z0 z1 r, found 4");
}

TEST(FlightSettings, FencesSayWhatTheyWereMadeFor) {
  EXPECT_EQ(refusal_of_world("fences_within -5 -5 0 15 5 3 0.35\n"), "");
  EXPECT_EQ(
      refusal_of_world("fences_within -5 -5 0 15 5 3 0.35\npose_margin 0.2\n"),
      "the fences were made for a clearance of 0.35 m, but body_radius + pose_margin + tracking_margin is 0.55 m: "
      "zones may be missing. Make the fences again, with tern airspace --clearance 0.55");
}

TEST(FlightSettings, TheGoalMayLieInAnObstacleOrOutside) {
  const auto goal = [](const std::string& name, const std::string& place) {
    const tern_host::FlightWorld world = tern_host::read_flight_world(name, {"goal_place=" + place});
    return std::make_pair(clearance(world, world.goal), world.goal);
  };
  for (const char* const name : {"P25:3", "O:2", "S20:1"}) {
    EXPECT_GT(goal(name, "given").first, 0.5) << name;
    EXPECT_EQ(goal(name, "occupied").first, 0.0) << name;
    EXPECT_EQ(goal(name, "outside").first, -5.0) << name;
  }
  EXPECT_EQ(refusal_of_world("goal_place occupied\n"), "goal_place occupied: there is no obstacle");
  EXPECT_EQ(refusal_of_world("via 1 0 1\ngoal_jitter 1\n"),
            "goal_jitter is for worlds without vias: each new goal begins the mission anew");
}

}  // namespace
