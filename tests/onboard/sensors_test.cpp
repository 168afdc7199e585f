// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/sensors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "onboard/onboard_sky.hpp"

namespace {

using tern_onboard::DepthImage;
using tern_onboard::Fault;
using tern_onboard::Notices;
using tern_onboard::Poses;
using tern_onboard::SensorKind;
using tern_onboard::Sensors;
using tern_test::kMs;

constexpr int kWidth = 80, kHeight = 60;

/// A map of 12.8 x 12.8 x 6.4 m around a body at rest in its middle, with sensors.
class Room {
 public:
  explicit Room(std::int32_t pixels = kWidth * kHeight) : sensors(tern_onboard::WatchSettings{}, pixels) {
    tern::MapSpec spec = tern::map_spec({-6.4, -6.4, -3.2}, 0.2, {64, 64, 32}, 0.3);
    spec.range = 5.0;
    spec.pose_margin = 0.0;
    spec.scan_pixel = 0.1;
    spec.pixels = 320 * 240;
    words_.resize(tern::map_words(spec));
    EXPECT_EQ(map.bind(spec, words_.data(), words_.size()), tern::Status::kOk);
    send_pose();
  }
  void send_pose() { poses.add({now, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}}}, 0, now, notices); }
  /// A camera that looks along x.
  int add_camera(const char* name, int width = kWidth, int height = kHeight,
                 const tern_onboard::SensorSettings& settings = {}) {
    const int camera = sensors.add({name, SensorKind::kDepth, settings});
    EXPECT_EQ(
        sensors.set_lens(camera, {width, height, 0.5 * width, 0.5 * width, 0.5 * (width - 1), 0.5 * (height - 1)}), "");
    EXPECT_EQ(sensors.set_mounting(camera, {{0.0, 0.0, 0.0}, {0.5, -0.5, 0.5, -0.5}}), "");
    return camera;
  }
  void offer(int camera, const std::vector<float>& depths, std::int64_t stamp, int width = kWidth,
             int height = kHeight) {
    const DepthImage image{stamp, depths.data(), 4 * depths.size(), width, height, 4 * static_cast<std::size_t>(width),
                           true,  false};
    sensors.offer(camera, image, now, notices);
  }
  void enter() {
    sensors.enter(map, record, poses, now, notices);
    while (map.step(100000) == tern::Status::kRunning) {
    }
  }
  bool blocked(double x, double y) const { return map.route().obstacle(voxel(x, y)); }
  bool seen(double x, double y) const { return map.seen(voxel(x, y)); }
  std::uint64_t count(Fault fault) const { return notices.counts()[static_cast<std::size_t>(fault)]; }

  std::int64_t now = 1000 * kMs;
  Notices notices;
  Poses poses{tern_onboard::WatchSettings{}};
  Sensors sensors;
  tern::RollingMap map;
  tern::FlightRecorder record;  // not begun: it records nothing

 private:
  static tern::Voxel voxel(double x, double y) {
    return {static_cast<std::int32_t>((x + 6.4) / 0.2), static_cast<std::int32_t>((y + 6.4) / 0.2), 16};
  }
  std::vector<std::uint64_t> words_;
};

std::vector<float> wall(float depth, int width = kWidth, int height = kHeight) {
  return std::vector<float>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), depth);
}

TEST(Sensors, EnterAWallInMetresAndInMillimetres) {
  for (const bool big_endian : {false, true}) {
    for (const bool metres : {false, true}) {
      if (metres && big_endian) continue;
      Room room;
      const int camera = room.add_camera("camera");
      const std::vector<float> depths = wall(3.1f);
      const auto number = static_cast<std::uint16_t>(big_endian ? 0x1c0c : 0x0c1c);  // 3100
      const std::vector<std::uint16_t> millimetres(depths.size(), number);
      DepthImage image{room.now, depths.data(), 4 * depths.size(), kWidth, kHeight, 4 * kWidth, metres, big_endian};
      if (!metres) {
        image.data = millimetres.data();
        image.bytes = 2 * millimetres.size();
        image.row_bytes = 2 * kWidth;
      }
      room.sensors.offer(camera, image, room.now, room.notices);
      room.enter();
      EXPECT_TRUE(room.blocked(3.1, 0.1));
      EXPECT_TRUE(room.seen(1.5, 0.1));
      EXPECT_FALSE(room.seen(3.9, 0.1));
      EXPECT_EQ(room.sensors.state(camera).taken, 1u);
    }
  }
}

TEST(Sensors, TakeNothingForAMeasurementThatIsNone) {
  const float inf = std::numeric_limits<float>::infinity();
  for (const float depth : {0.0f, std::nanf(""), 0.1f, 25.0f, inf, -inf, -1.0f}) {
    Room room;
    room.offer(room.add_camera("camera"), wall(depth), room.now);
    room.enter();
    EXPECT_FALSE(room.seen(1.5, 0.1)) << depth;
  }
}

TEST(Sensors, TakeNoReturnForWhatIsStated) {
  const float inf = std::numeric_limits<float>::infinity();
  tern_onboard::SensorSettings settings;
  settings.no_return = 3.0;
  for (const float depth : {0.0f, inf, std::nanf(""), 0.1f, 25.0f, -inf, -1.0f}) {
    const bool nothing_back = depth == 0.0f || depth == inf;
    for (const int size : {1, 4}) {  // larger images are divided into squares
      Room room(kWidth * kHeight);
      const int camera = room.add_camera("camera", size * kWidth, size * kHeight, settings);
      std::vector<float> depths = wall(inf, size * kWidth, size * kHeight);
      depths[static_cast<std::size_t>(size * kWidth * (size * kHeight / 2) + size * kWidth / 2)] = depth;
      room.offer(camera, depths, room.now, size * kWidth, size * kHeight);
      room.enter();
      EXPECT_EQ(room.seen(2.5, -0.05), nothing_back) << depth;
      EXPECT_TRUE(room.seen(2.5, 1.1));
      EXPECT_FALSE(room.seen(3.3, 1.1));
    }
  }
}

TEST(Sensors, MakeLargeImagesSmallerByTheirLeastDepths) {
  Room room(kWidth * kHeight);
  const int camera = room.add_camera("camera", 4 * kWidth, 4 * kHeight);
  std::vector<float> depths = wall(4.5f, 4 * kWidth, 4 * kHeight);
  // One near pixel on the axis, and one without a measurement at the image's right edge.
  depths[static_cast<std::size_t>(4 * kWidth * (2 * kHeight - 1) + 2 * kWidth)] = 2.1f;
  depths[static_cast<std::size_t>(4 * kWidth * (2 * kHeight - 1) + 4 * kWidth - 1)] = 0.0f;
  room.offer(camera, depths, room.now, 4 * kWidth, 4 * kHeight);
  room.enter();
  EXPECT_TRUE(room.blocked(2.1, -0.01));
  EXPECT_FALSE(room.seen(3.5, -0.05));  // behind it
  EXPECT_TRUE(room.seen(3.5, 1.1));
  EXPECT_EQ(room.count(Fault::kFrameRefused), 0u);
}

TEST(Sensors, TakeTurnsByStamp) {
  Room room;
  const int front = room.add_camera("front"), back = room.add_camera("back");
  room.sensors.set_mounting(back, {{0.0, 0.0, 0.0}, {0.5, -0.5, -0.5, 0.5}});  // looks along -x
  room.offer(front, wall(3.1f), room.now - 10 * kMs);
  room.now += 20 * kMs;
  room.send_pose();
  room.offer(back, wall(2.1f), room.now - 15 * kMs);
  room.offer(front, wall(3.1f), room.now - 5 * kMs);  // takes the place of the one that waited
  EXPECT_EQ(room.count(Fault::kFrameReplaced), 1u);
  room.enter();
  EXPECT_EQ(room.sensors.state(back).taken, 1u);
  EXPECT_EQ(room.sensors.state(front).taken, 0u);
  room.enter();
  EXPECT_EQ(room.sensors.state(front).taken, 1u);
  EXPECT_TRUE(room.blocked(3.1, 0.1));
  EXPECT_TRUE(room.blocked(-2.1, 0.1));
  // One that comes later, but was taken before what was entered, is entered all the same.
  room.offer(back, wall(2.1f), room.now - 8 * kMs);
  room.enter();
  EXPECT_EQ(room.sensors.state(back).taken, 2u);
}

TEST(Sensors, AFastSensorGetsItsTurnBesideASlowOne) {
  Room room;
  const int fast = room.add_camera("fast"), slow = room.add_camera("slow");
  for (int k = 0; k < 40; ++k) {
    room.now += 40 * kMs;
    room.send_pose();
    room.offer(fast, wall(3.1f), room.now);
    // Of the slow one, a frame waits always, and it is always the older one.
    if (k % 2 == 0) room.offer(slow, wall(3.1f), room.now - 30 * kMs);
    if (k % 2 == 1) room.enter();  // the map has time for half of them
  }
  EXPECT_EQ(room.sensors.state(fast).taken, 10u);
  EXPECT_EQ(room.sensors.state(slow).taken, 10u);
}

TEST(Sensors, WaitForAPose) {
  Room room;
  const int camera = room.add_camera("camera");
  room.now += 100 * kMs;
  room.offer(camera, wall(3.1f), room.now - 10 * kMs);
  room.enter();
  EXPECT_EQ(room.sensors.state(camera).taken, 0u);
  room.send_pose();
  room.enter();
  EXPECT_EQ(room.sensors.state(camera).taken, 1u);
  room.now += 10 * kMs;
  room.offer(camera, wall(3.1f), room.now);
  room.now += 600 * kMs;
  room.enter();
  EXPECT_EQ(room.count(Fault::kFrameNoPose), 1u);
  room.offer(camera, wall(3.1f), room.now - 400 * kMs);  // between poses that are far apart
  room.send_pose();
  room.enter();
  EXPECT_EQ(room.count(Fault::kFrameNoPose), 2u);
}

TEST(Sensors, RefuseFramesThatDoNotFit) {
  Room room;
  const int camera = room.add_camera("camera");
  const auto refused = [&](Fault fault, const std::vector<float>& depths, std::int64_t stamp, int width, int height) {
    const std::uint64_t before = room.count(fault);
    room.offer(camera, depths, stamp, width, height);
    EXPECT_EQ(room.count(fault), before + 1);
  };
  room.offer(camera, wall(3.0f), room.now);
  refused(Fault::kFrameRepeated, wall(3.0f), room.now, kWidth, kHeight);
  refused(Fault::kFrameBackward, wall(3.0f), room.now - kMs, kWidth, kHeight);
  refused(Fault::kFrameAhead, wall(3.0f), room.now + 21 * kMs, kWidth, kHeight);
  refused(Fault::kFrameOld, wall(3.0f), room.now - 501 * kMs, kWidth, kHeight);
  refused(Fault::kFrameInvalid, wall(3.0f), room.now + kMs, kWidth, kHeight / 2);
  refused(Fault::kFrameInvalid, {}, room.now + kMs, kWidth, kHeight);
  refused(Fault::kFrameInvalid, wall(3.0f, kWidth - 1), room.now + kMs, kWidth, kHeight);
  const int unknown = room.sensors.add({"unknown", SensorKind::kDepth, {}});
  room.offer(unknown, wall(3.0f), room.now);
  EXPECT_EQ(room.count(Fault::kFrameUnready), 1u);
  EXPECT_NE(room.sensors.set_lens(unknown, {kWidth, kHeight, 0.0, 40.0, 1.0, 1.0}), "");
  EXPECT_NE(room.sensors.set_mounting(unknown, {{0.0, 0.0, 0.0}, {1.0, 1.0, 0.0, 0.0}}), "");
}

TEST(Sensors, EnterAScanOfPoints) {
  Room room;
  const int lidar = room.sensors.add({"lidar", SensorKind::kPoints, {}});
  room.sensors.set_mounting(lidar, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0, 1.0}});  // mounted backwards
  std::vector<float> points;
  for (int row = -40; row <= 40; ++row) {
    for (int column = 0; column < 160; ++column) {
      const double azimuth = 0.04 * column, elevation = 0.02 * row;
      // A wall at x = -3.1 in the sensor's axes, and nothing in the map's range elsewhere.
      const double ahead = -std::cos(elevation) * std::cos(azimuth);
      const double range = ahead > 0.3 ? 3.1 / ahead : 50.0;
      points.push_back(static_cast<float>(-range * ahead));
      points.push_back(static_cast<float>(range * std::cos(elevation) * std::sin(azimuth)));
      points.push_back(static_cast<float>(range * std::sin(elevation)));
    }
  }
  points[0] = std::nanf("");
  tern_onboard::PointScan scan{
      room.now, points.data(), 4 * points.size(), points.size() / 3, 1, 4 * points.size(), 12, 0, 4, 8};
  room.sensors.offer(lidar, scan, room.now, room.notices);
  room.enter();
  EXPECT_TRUE(room.blocked(3.1, 0.1));
  EXPECT_TRUE(room.seen(2.1, 0.1));
  EXPECT_TRUE(room.seen(-2.1, 1.1));
  scan.bytes -= 1;
  scan.stamp += kMs;
  room.sensors.offer(lidar, scan, room.now + kMs, room.notices);
  EXPECT_EQ(room.count(Fault::kFrameInvalid), 1u);
}

}  // namespace
