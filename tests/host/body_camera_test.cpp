// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The simulator's cameras that do not look level: how they are mounted, what they see, and how they err.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/flight/depth_camera.hpp"
#include "host/flight/flight_world.hpp"
#include "host/flight/gimbal.hpp"
#include "host/flight/sensor_mount.hpp"
#include "host/flight/simulated_flight.hpp"
#include "support/pixel_areas.hpp"

namespace {

using tern_host::DepthFrame;
using tern_host::FlightWorld;
using tern_host::Noise;
using tern_host::read_flight_world;
using tern_host::SensorMount;
using tern_test::depth_at;
using tern_test::expect_nearest_in_areas;

constexpr double kClose = 1e-9;

FlightWorld world_of(const std::string& name) {
  return read_flight_world(name, {"sensor=d435", "sensor_size=40,24"});
}

/// The camera's axes (right, down, ahead) in the world, by the quaternion's own formula.
tern::Vec3 turned(const tern::Pose& pose, const tern::Vec3& v) {
  const double w = pose.quaternion[0];
  const double x = pose.quaternion[1];
  const double y = pose.quaternion[2];
  const double z = pose.quaternion[3];
  return {(1 - 2 * (y * y + z * z)) * v.x + 2 * (x * y - w * z) * v.y + 2 * (x * z + w * y) * v.z,
          2 * (x * y + w * z) * v.x + (1 - 2 * (x * x + z * z)) * v.y + 2 * (y * z - w * x) * v.z,
          2 * (x * z - w * y) * v.x + 2 * (y * z + w * x) * v.y + (1 - 2 * (x * x + y * y)) * v.z};
}

/// Where a ray through a place of the image is at a depth.
tern::Vec3 point_behind(const DepthFrame& frame, double u, double v, double depth) {
  const tern::Vec3 ray = turned(
      frame.pose, {depth * (u - frame.view.cx) / frame.view.fx, depth * (v - frame.view.cy) / frame.view.fy, depth});
  const tern::Vec3& p = frame.pose.position;
  return {p.x + ray.x, p.y + ray.y, p.z + ray.z};
}

/// A vehicle at the world's start, turned to `yaw`, with its thrust tilted ahead and to the side.
tern::Pose tilted_pose(const FlightWorld& world, double yaw, double ahead, double aside) {
  const double q[3][2] = {{std::cos(0.5 * yaw), std::sin(0.5 * yaw)},
                          {std::cos(0.5 * ahead), std::sin(0.5 * ahead)},
                          {std::cos(0.5 * aside), std::sin(0.5 * aside)}};
  // About z, then the vehicle's y, then its x.
  const double w = q[0][0] * q[1][0] * q[2][0] + q[0][1] * q[1][1] * q[2][1];
  const double x = q[0][0] * q[1][0] * q[2][1] - q[0][1] * q[1][1] * q[2][0];
  const double y = q[0][0] * q[1][1] * q[2][0] + q[0][1] * q[1][0] * q[2][1];
  const double z = q[0][1] * q[1][0] * q[2][0] - q[0][0] * q[1][1] * q[2][1];
  return camera_pose(world.settings.mount, world.start, {w, x, y, z}, 0.0);
}

TEST(SensorMount, TurnsWithTheBody) {
  SensorMount mount;
  mount.offset = {0.2, 0.0, 0.1};
  mount.pitch = 0.3;
  const tern::Pose level = camera_pose(mount, {1.0, 2.0, 3.0}, tern_host::level_attitude(0.5 * M_PI), 0.2);
  EXPECT_NEAR(level.position.x, 1.0, kClose);
  EXPECT_NEAR(level.position.y, 2.2, kClose);
  EXPECT_NEAR(level.position.z, 3.1, kClose);
  const tern::Vec3 axis = turned(level, {0.0, 0.0, 1.0});
  EXPECT_NEAR(axis.y, std::cos(0.5), kClose);
  EXPECT_NEAR(axis.z, std::sin(0.5), kClose);
  EXPECT_NEAR(turned(level, {1.0, 0.0, 0.0}).x, 1.0, kClose);
  // A vehicle that leans ahead by a right angle: its thrust points along x, its nose down.
  const double half = std::sqrt(0.5);
  const tern::Pose leaning = camera_pose(mount, {0.0, 0.0, 0.0}, {half, 0.0, half, 0.0}, -0.3);
  EXPECT_NEAR(leaning.position.x, 0.1, kClose);
  EXPECT_NEAR(leaning.position.z, -0.2, kClose);
  EXPECT_NEAR(turned(leaning, {0.0, 0.0, 1.0}).z, -1.0, kClose);
}

/// What a pixel shows is there, but for a cylinder's prism, and nothing in its area is nearer.
TEST(BodyCamera, ShowsTheNearestThingInAPixelsWholeArea) {
  Noise random(3);
  for (const char* const name : {"P12:1", "O:2", "S20:1", "M:3"}) {
    const FlightWorld world = world_of(name);
    Noise noise(1);
    const tern::Pose pose =
        tilted_pose(world, random.within(-3, 3), random.within(-0.6, 0.6), random.within(-0.6, 0.6));
    const DepthFrame frame = take_frame(world, pose, 0, noise);
    expect_nearest_in_areas(world, frame, 100, 0.004, random, name,
                            [&](double u, double v, double depth) { return point_behind(frame, u, v, depth); });
  }
}

/// The two ways to see: a level camera's pixels differ by the prisms alone.
TEST(BodyCamera, SeesWhatALevelOneSees) {
  for (const char* const name : {"P12:1", "O:2", "S20:1", "G:3"}) {
    const FlightWorld world = world_of(name);
    Noise noise(1);
    const DepthFrame level = take_frame(world, world.start, 0.4, 0, noise);
    const DepthFrame other = take_frame(world, level.pose, 0, noise);
    int differ = 0;
    for (std::size_t pixel = 0; pixel < level.depths.size(); ++pixel) {
      EXPECT_LE(other.depths[pixel], level.depths[pixel] + 1e-5f);
      differ += other.depths[pixel] < level.depths[pixel] - 0.05f ? 1 : 0;
    }
    EXPECT_LE(differ, 5) << name;
  }
}

/// A wire of a centimetre at 8 m, whose pixels are 9 cm wide: whole pixels show all of it, their middles a part.
TEST(BodyCamera, MissesThinThingsWithTheMiddlesOfItsPixels) {
  FlightWorld world = read_flight_world("P25:1", {"sensor=d435"});
  world.boundary = {{-2.0, -20.0, -20.0}, {40.0, 20.0, 20.0}};
  world.cylinders.clear();
  world.blocks = {{{8.0, -10.0, 1.003}, {8.01, 10.0, 1.013}}};
  world.start = {0.0, 0.0, 0.0};
  const auto columns_of = [&](double part) {
    world.settings.pixel_part = part;
    Noise noise(1);
    const DepthFrame frame = take_frame(world, tilted_pose(world, 0.1, 0.2, 0.3), 0, noise);
    int columns = 0;
    for (int u = 0; u < frame.view.width; ++u) {
      int seen = 0;
      for (int v = 0; v < frame.view.height; ++v) seen += depth_at(frame, u, v) < 9.0 ? 1 : 0;
      columns += seen > 0 ? 1 : 0;
    }
    return columns;
  };
  EXPECT_GT(columns_of(1.0), 120);
  EXPECT_GT(columns_of(0.0), 5);
  EXPECT_LT(columns_of(0.0), 60);
}

/// Errors grow with the square of the depth, far things have no depth, and holes take their part of the image.
TEST(BodyCamera, Errs) {
  FlightWorld world = read_flight_world("P25:1", {"sensor=d435", "depth_error=0.03,0.005", "sensor_far=8"});
  world.cylinders.clear();
  world.boundary = {{-2.0, -30.0, -30.0}, {6.0, 30.0, 30.0}};
  world.start = {0.0, 0.0, 0.0};
  Noise noise(1);
  const tern::Pose ahead = tilted_pose(world, 0.0, 0.0, 0.0);
  DepthFrame frame = take_frame(world, ahead, 0, noise);
  const auto [least, most] = std::minmax_element(frame.depths.begin(), frame.depths.end());
  EXPECT_NEAR(*least, 6.0 - 0.21, 0.001);
  EXPECT_NEAR(*most, 6.0 + 0.21, 0.001);
  world.settings.sensor_far = 5.5;
  frame = take_frame(world, ahead, 0, noise);
  EXPECT_EQ(*std::max_element(frame.depths.begin(), frame.depths.end()), 0.0f);
  world.settings.sensor_far = 0.0;
  world.settings.holes = 0.2;
  frame = take_frame(world, ahead, 0, noise);
  const auto count = static_cast<double>(std::count(frame.depths.begin(), frame.depths.end(), 0.0f));
  EXPECT_NEAR(count / static_cast<double>(frame.depths.size()), 0.18, 0.04);  // patches overlap
}

/// Cameras that look up and down give their frames to the same map by turns: straight up and 0.3 m ahead is seen at
/// once.
TEST(FurtherCameras, ShowWhatTheFirstOneDoesNot) {
  const FlightWorld world =
      read_flight_world("V:1", {"further_camera=0,1.2", "further_camera=0,-1.2", "time_limit=10"});
  ASSERT_EQ(world.settings.cameras.size(), 2u);
  const tern_host::FlightResult result = simulate_flight(world);
  EXPECT_EQ(result.status, "reached") << result.reason;
  EXPECT_LT(result.time, 4.0);  // with one camera, it has to fly away and come back
}

/// As far as its mount lets it, and as fast as it may.
TEST(Gimbal, PitchesToWhereTheFlightLooks) {
  const tern_host::FlightSettings s = tern_host::flight_settings({"gimbal_pitch=-1.5,0.5"});
  tern_host::Gimbal gimbal(0.0, s);
  tern::Command command{};
  for (const double height : {-5.0, 5.0}) {
    command.look_at = {0.1, 0.0, height};
    double fastest = 0.0;
    for (int k = 0; k < 200; ++k) {
      const double before = gimbal.pitch();
      gimbal.turn_to(command);
      gimbal.move_on();
      fastest = std::max(fastest, std::abs(gimbal.pitch() - before) * s.tick_hz);
    }
    EXPECT_NEAR(gimbal.pitch(), height < 0.0 ? -1.5 : 0.5, kClose);
    EXPECT_NEAR(fastest, s.yaw_rate, 1e-6);
  }
  tern_host::Gimbal fixed(0.0, tern_host::flight_settings({}));
  fixed.turn_to(command);
  fixed.move_on();
  EXPECT_EQ(fixed.pitch(), 0.0);
}

}  // namespace
