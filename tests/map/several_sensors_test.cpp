// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Frames of several sensors in one map, in the order in which they arrive: one may be older than those before it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/camera_map.hpp"
#include "support/owned_map.hpp"

namespace {

using tern::MapSpec;
using tern::Pose;
using tern::Status;
using tern::Vec3;
using tern::Voxel;
using tern_test::finish;
using tern_test::Image;
using tern_test::OwnedMap;

constexpr std::int64_t kMillisecond = 1000000;

MapSpec late_spec() {
  MapSpec spec = tern_test::camera_spec();
  spec.slack = 0;
  return spec;
}

/// A camera that looks along x at a wall, and one that looks back and sees nothing at all.
class MapLateFrames : public ::testing::Test {
 protected:
  explicit MapLateFrames(const MapSpec& spec = late_spec()) : owned(spec), image(41, 41, 20.0) {}

  /// A frame of this time, in milliseconds, of a wall at this depth.
  Status enter(std::int64_t t, double depth) {
    for (float& z : image.z) z = static_cast<float>(depth);
    const Status begun = owned.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {0.5, -0.5, 0.5, -0.5}}, kMillisecond * t);
    return begun == Status::kRunning ? finish(owned.map) : begun;
  }
  /// One of the other camera.
  Status look_back(std::int64_t t) {
    for (float& z : image.z) z = 0.0f;
    const Status begun = owned.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {0.5, -0.5, -0.5, 0.5}}, kMillisecond * t);
    return begun == Status::kRunning ? finish(owned.map) : begun;
  }
  bool solid(int voxels) const { return owned.map.route().obstacle({10 + voxels, 10, 10}); }
  bool seen(int voxels) const { return owned.map.seen({10 + voxels, 10, 10}); }

  OwnedMap owned;
  Image image;
};

TEST_F(MapLateFrames, ShowAndBlockLikeOthers) {
  ASSERT_EQ(look_back(100), Status::kOk);
  ASSERT_EQ(enter(60, 2.05), Status::kOk);
  EXPECT_TRUE(seen(19));
  EXPECT_TRUE(solid(20));
  // What a newer frame saw free, an older one blocks: hits win.
  ASSERT_EQ(enter(120, 4.05), Status::kOk);
  ASSERT_EQ(enter(110, 3.05), Status::kOk);
  EXPECT_TRUE(solid(30));
}

TEST_F(MapLateFrames, ClearNothingThatANewerFrameHit) {
  ASSERT_EQ(enter(100, 2.05), Status::kOk);
  for (const std::int64_t t : {60, 70, 80, 99}) ASSERT_EQ(enter(t, 4.05), Status::kOk);
  EXPECT_TRUE(solid(20));
  EXPECT_FALSE(seen(20));
  EXPECT_TRUE(seen(25));
  for (const std::int64_t t : {100, 100, 100}) ASSERT_EQ(enter(t, 4.05), Status::kOk);
  EXPECT_FALSE(solid(20));
  EXPECT_TRUE(seen(20));
}

TEST_F(MapLateFrames, TakeNoHitBackThatANewerFrameCounted) {
  MapSpec spec = late_spec();
  spec.hits = 2;
  owned.words.assign(tern::map_words(spec), 0);
  ASSERT_EQ(owned.map.bind(spec, owned.words.data(), owned.words.size()), Status::kOk);
  ASSERT_EQ(enter(100, 2.05), Status::kOk);
  ASSERT_EQ(enter(90, 4.05), Status::kOk);
  ASSERT_EQ(enter(110, 2.05), Status::kOk);
  EXPECT_TRUE(solid(20));
}

/// A sensor that is always later than another one clears what it saw itself.
TEST_F(MapLateFrames, ClearWhatWasHitBefore) {
  ASSERT_EQ(enter(40, 2.05), Status::kOk);
  for (const std::int64_t t : {60, 70, 80}) {
    ASSERT_EQ(look_back(t + 100), Status::kOk);
    ASSERT_EQ(enter(t, 4.05), Status::kOk);
  }
  EXPECT_FALSE(solid(20));
  EXPECT_TRUE(seen(20));
}

TEST_F(MapLateFrames, ClearNothingThatWasMarkedSince) {
  ASSERT_EQ(look_back(100), Status::kOk);
  ASSERT_EQ(owned.map.mark_box({{3.0, 0.0, 0.0}, {3.1, 2.0, 2.0}}), Status::kOk);
  for (const std::int64_t t : {70, 80, 90}) ASSERT_EQ(enter(t, 4.05), Status::kOk);
  EXPECT_TRUE(solid(20));
  for (const std::int64_t t : {100, 110, 120}) ASSERT_EQ(enter(t, 4.05), Status::kOk);
  EXPECT_FALSE(solid(20));
}

/// The times of hits stay behind when the window moves: until newer frames come, nothing is cleared.
TEST_F(MapLateFrames, ClearNothingThatWasHitBeforeTheWindowMoved) {
  ASSERT_EQ(enter(100, 2.05), Status::kOk);
  ASSERT_EQ(owned.map.follow({3.2, 1.0, 1.7}), Status::kRunning);
  ASSERT_EQ(finish(owned.map), Status::kOk);
  const auto still_solid = [this] { return owned.map.route().obstacle({30, 10, 3}); };
  ASSERT_TRUE(still_solid());
  for (const std::int64_t t : {70, 80, 90}) ASSERT_EQ(enter(t, 4.05), Status::kOk);
  EXPECT_TRUE(still_solid());
  for (const std::int64_t t : {110, 120, 130}) ASSERT_EQ(enter(t, 4.05), Status::kOk);
  EXPECT_FALSE(still_solid());
}

TEST_F(MapLateFrames, AreRefusedIfTheyAreTooLate) {
  constexpr std::int64_t kLast = std::numeric_limits<std::int64_t>::max();
  ASSERT_EQ(look_back(1200), Status::kOk);
  EXPECT_EQ(look_back(200), Status::kOk);  // kMaxFrameDelay
  EXPECT_EQ(look_back(199), Status::kClockBehind);
  EXPECT_EQ(owned.map.frames(), 2u);
  const auto begin = [this](std::int64_t t) {
    const Status begun = owned.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {0.5, -0.5, 0.5, -0.5}}, t);
    finish(owned.map);
    return begun;
  };
  EXPECT_EQ(begin(kLast), Status::kRunning);
  EXPECT_EQ(begin(kLast - tern::kMaxFrameDelay), Status::kRunning);
  EXPECT_EQ(begin(kLast - tern::kMaxFrameDelay - 1), Status::kClockBehind);
  EXPECT_EQ(begin(-kLast - 1), Status::kClockBehind);
  // The times of hits go with the clock that was set.
  ASSERT_EQ(owned.map.forget_time(), Status::kOk);
  ASSERT_EQ(enter(0, 2.05), Status::kOk);
  ASSERT_EQ(look_back(50), Status::kOk);
  for (const std::int64_t t : {10, 20, 30}) ASSERT_EQ(enter(t, 4.05), Status::kOk);
  EXPECT_FALSE(solid(20));
}

TEST_F(MapLateFrames, ClearWhatAFrameHitWhileTheClockWasSet) {
  for (float& z : image.z) z = 2.05f;
  const std::int64_t old_time = 100000 * kMillisecond;
  ASSERT_EQ(owned.map.begin_frame(image.view, {{1.0, 1.0, 1.0}, {0.5, -0.5, 0.5, -0.5}}, old_time), Status::kRunning);
  ASSERT_EQ(owned.map.forget_time(), Status::kOk);
  ASSERT_EQ(finish(owned.map), Status::kOk);
  EXPECT_TRUE(solid(20));
  ASSERT_EQ(look_back(50), Status::kOk);
  for (const std::int64_t t : {10, 20, 30}) ASSERT_EQ(enter(t, 4.05), Status::kOk);
  EXPECT_FALSE(solid(20));
}

/// Ageing goes by the latest time: late frames do not turn it back, and what they show ages from then on.
TEST_F(MapLateFrames, AgeWithTheLatestOne) {
  MapSpec spec = late_spec();
  spec.age = 500 * kMillisecond;
  owned.words.assign(tern::map_words(spec), 0);
  ASSERT_EQ(owned.map.bind(spec, owned.words.data(), owned.words.size()), Status::kOk);
  ASSERT_EQ(look_back(1000), Status::kOk);
  for (int k = 0; k < 50; ++k) {
    ASSERT_EQ(enter(600, 2.05), Status::kOk);
    EXPECT_TRUE(seen(19)) << k;
  }
  ASSERT_EQ(look_back(1500), Status::kOk);
  EXPECT_FALSE(seen(19));
}

// Three sensors on one vehicle in a world that stands still.

/// A room with its walls, floor and pillar in the middle of voxels, seen along single rays.
double depth_in_room(const Vec3& eye, const Vec3& ray) {
  const auto to = [](double from, double along, double low, double high) {
    if (along == 0.0) return 1e9;
    return ((along > 0.0 ? high : low) - from) / along;
  };
  double depth = std::min({to(eye.x, ray.x, 0.45, 5.95), to(eye.y, ray.y, 0.45, 3.55), to(eye.z, ray.z, 0.45, 2.55)});
  const double enter = std::max((3.05 - eye.x) / ray.x, (1.05 - eye.y) / ray.y);
  const double leave = std::min((3.55 - eye.x) / ray.x, (1.55 - eye.y) / ray.y);
  if (ray.x > 0.0 && ray.y > 0.0 && enter > 0.0 && enter < leave) depth = std::min(depth, enter);
  return depth;
}

struct Shot {
  std::int64_t taken, arrives;
  int sensor;  ///< 0: looks ahead, 1: looks down, 2: a lidar
  Vec3 eye;
};

class SensorSuite {
 public:
  explicit SensorSuite(const MapSpec& spec) : owned(spec), image(41, 41, 20.0) {
    for (int k = 0; k < 12000; ++k) {  // evenly over the sphere
      const double z = 1.0 - 2.0 * (k + 0.5) / 12000;
      const double turn = 2.399963229728653 * k;
      ways.push_back({std::sqrt(1.0 - z * z) * std::cos(turn), std::sqrt(1.0 - z * z) * std::sin(turn), z});
    }
    ranges.resize(ways.size());
  }

  void enter(const Shot& shot) {
    Status begun = Status::kOk;
    if (shot.sensor == 2) {
      for (std::size_t k = 0; k < ways.size(); ++k) ranges[k] = static_cast<float>(depth_in_room(shot.eye, ways[k]));
      begun =
          owned.map.begin_scan(tern::Beams{ways.data(), ranges.data(), ways.size(), 0.1, 50.0}, shot.eye, shot.taken);
    } else {
      const bool ahead = shot.sensor == 0;
      for (int v = 0; v < 41; ++v) {
        for (int u = 0; u < 41; ++u) {
          const double right = (u - 20) / 20.0;
          const double down = (v - 20) / 20.0;
          const Vec3 ray = ahead ? Vec3{1.0, -right, -down} : Vec3{-down, -right, -1.0};
          image.at(u, v) = static_cast<float>(depth_in_room(shot.eye, ray));
        }
      }
      const double half = std::sqrt(0.5);
      const Pose pose = ahead ? Pose{shot.eye, {0.5, -0.5, 0.5, -0.5}} : Pose{shot.eye, {0.0, -half, half, 0.0}};
      begun = owned.map.begin_frame(image.view, pose, shot.taken);
    }
    ASSERT_EQ(begun, Status::kRunning);
    ASSERT_EQ(finish(owned.map), Status::kOk);
  }

  OwnedMap owned;
  Image image;
  std::vector<Vec3> ways;
  std::vector<float> ranges;
};

/// Frames of `sensors` sensors, each with its own rate and delay, in the order in which they arrive.
std::vector<Shot> flown_shots(int sensors) {
  const std::int64_t every[] = {33, 50, 100};
  const std::int64_t delay[] = {20, 95, 150};
  std::vector<Shot> shots;
  for (int s = 0; s < sensors; ++s) {
    for (std::int64_t t = 7 * s; t < 600; t += every[s]) {
      const double x = 1.5 + 0.002 * static_cast<double>(t);
      shots.push_back(
          {kMillisecond * t, kMillisecond * (t + delay[s]), s, {x, 2.2, 1.5 - 0.0005 * static_cast<double>(t)}});
    }
  }
  std::sort(shots.begin(), shots.end(), [](const Shot& a, const Shot& b) { return a.arrives < b.arrives; });
  return shots;
}

void expect_the_same_map(int sensors) {
  MapSpec spec = tern::map_spec({0.0, 0.0, 0.0}, 0.1, {64, 40, 30}, 0.3);
  spec.depth_margin = 0.02;
  spec.pose_margin = 0.0;
  spec.scan_pixel = 0.09;
  spec.pixels = 6 * 30 * 30;
  std::vector<Shot> shots = flown_shots(sensors);
  int late = 0;
  std::int64_t latest = -1;
  SensorSuite as_they_come(spec);
  for (const Shot& shot : shots) {
    late += shot.taken < latest ? 1 : 0;
    latest = std::max(latest, shot.taken);
    as_they_come.enter(shot);
  }
  EXPECT_GT(late, 8);
  std::sort(shots.begin(), shots.end(), [](const Shot& a, const Shot& b) { return a.taken < b.taken; });
  SensorSuite in_order(spec);
  for (const Shot& shot : shots) in_order.enter(shot);
  EXPECT_EQ(tern_test::hash_of(as_they_come.owned.map), tern_test::hash_of(in_order.owned.map));
  int seen = 0;
  for (int n = 0; n < 64 * 40 * 30; ++n) seen += in_order.owned.map.seen({n % 64, n / 64 % 40, n / 2560}) ? 1 : 0;
  EXPECT_GT(seen, 20000);
}

TEST(MapSensors, AheadAndDownMakeOneMapInAnyOrder) {
  expect_the_same_map(2);
}

TEST(MapSensors, TwoCamerasAndALidarMakeOneMapInAnyOrder) {
  expect_the_same_map(3);
}

}  // namespace
