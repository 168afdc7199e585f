// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vehicle that looks at a man who walks before a wall, for tests of what its sensors see move.
#ifndef TERN_TESTS_ONBOARD_LOOKOUT_HPP
#define TERN_TESTS_ONBOARD_LOOKOUT_HPP

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "flight/flight_state.hpp"
#include "host/flight/flight_replay.hpp"
#include "support/random.hpp"
#include "tern_onboard/onboard.hpp"
#include "tern_onboard/pose.hpp"
#include "tern_tracker/cluster_detector.hpp"

namespace tern_test {

inline constexpr std::int64_t kTenth = 100000000, kCentisecond = 10000000;

/// A wall 7 m ahead, and the ground; a man 4 m ahead, 0.4 m deep and 0.5 m wide, who walks to the right.
struct Scene {
  bool has_man = true;
  double ground = 0.0;
  double noise = 0.0;  // m, of a depth, at most
  tern::Vec3 man_at(double t) const { return {4.2, 1.5 - t, 0.9}; }

  /// The way along the direction, in multiples of it, to what is there.
  double way(const tern::Vec3& eye, const tern::Vec3& direction, double t) const {
    double least = (7.0 - eye.x) / direction.x;
    if (direction.z < 0.0) least = std::min(least, (ground - eye.z) / direction.z);
    return has_man ? std::min(least, way_to_man(eye, direction, man_at(t))) : least;
  }

 private:
  static double way_to_man(const tern::Vec3& eye, const tern::Vec3& direction, const tern::Vec3& man) {
    const double from[] = {man.x - eye.x, man.y - eye.y, man.z - eye.z};
    const double along[] = {direction.x, direction.y, direction.z}, half[] = {0.2, 0.25, 0.9};
    double enter = 0.0, leave = 1e9;
    for (int k = 0; k < 3; ++k) {
      const double a = (from[k] - half[k]) / along[k], b = (from[k] + half[k]) / along[k];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter < leave ? enter : 1e9;
  }
};

/// What the flight knows of a thing after a tick, with times of the clock.
struct Told {
  std::int64_t t;
  tern::Track track;
};

/// A vehicle that looks along x and does what it is told. Every 10 ms a pose and a tick, every 100 ms a frame of each
/// sensor.
class Lookout {
 public:
  explicit Lookout(const std::string& clusters = "person",
                   const std::function<void(tern_onboard::Settings&)>& change = {},
                   std::unique_ptr<tern_onboard::Detector> detector = nullptr) {
    tern_onboard::Settings settings;
    settings.things.clusters = clusters;
    settings.fly.ground = 0.0;
    settings.map.free_radius = 1.6;
    settings.map.angle_margin = 0.005;
    settings.map.depth_margin = settings.map.pose_margin = 0.02;
    if (change) change(settings);
    if (detector == nullptr) detector = tern_tracker::detector_of(settings);
    onboard = std::make_unique<tern_onboard::Onboard>(settings, std::move(detector));
    onboard->record_flights();
  }
  void add_camera() {
    const int camera = onboard->add_sensor({"camera", tern_onboard::SensorKind::kDepth, {}});
    onboard->set_lens(camera, {kColumns, kRows, kFocus, kFocus, 0.5 * (kColumns - 1), 0.5 * (kRows - 1)});
    onboard->set_mounting(camera, {{0.0, 0.0, 0.0}, {0.5, -0.5, 0.5, -0.5}});
    cameras.push_back(camera);
  }
  void add_lidar() {
    lidar = onboard->add_sensor({"lidar", tern_onboard::SensorKind::kPoints, {}});
    onboard->set_mounting(lidar, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}});
  }
  void fly(double duration) {
    send_pose();
    if (onboard->status(now).state != tern_onboard::State::kFlying) {
      ASSERT_TRUE(onboard->begin(now).ok);
    }
    for (int k = 0; k < std::lround(100.0 * duration); ++k) {
      now += kCentisecond;
      onboard->tick(now);
      position = tern_onboard::minus(onboard->setpoint(now).position, drift);
      send_pose();
      if (now % kTenth == 0 && now - late >= begun) send_frames(now - late);
      most = std::max(most, things());
    }
  }
  /// The estimate jumps, and with the next pose everybody knows.
  void jump(const tern::Vec3& by) {
    drift = by;
    now += kCentisecond;
    send_pose();
  }
  std::string record() const {
    std::string record;
    for (const tern_onboard::RecordPart& part : onboard->take_record()) {
      if (!record.empty()) record.resize(record.size() - tern_onboard::kRecordEnd);
      record.append(part.bytes.begin(), part.bytes.end());
    }
    return record;
  }
  /// What the flight was told, from its record, which replays.
  std::vector<Told> told() const {
    std::vector<Told> all;
    const tern_host::FlightReplay replay = tern_host::replay_flight(record(), [&all](const auto& tick) {
      const std::int64_t zero = tick.t - tick.state.facts.time;
      const tern::TrackTable& table = tick.state.facts.tracks;
      for (int k = 0; k < table.count; ++k) {
        all.push_back({tick.t, table.tracks[k]});
        all.back().track.measured += zero;
      }
    });
    EXPECT_EQ(replay.difference, "");
    return all;
  }
  std::size_t things() const { return onboard->status(now).things; }
  std::uint64_t count(tern_onboard::Fault fault) const {
    return onboard->status(now).faults[static_cast<std::size_t>(fault)];
  }

  static constexpr std::int64_t kBegin = 50 * kTenth;
  static constexpr int kRows = 120, kColumns = 160;
  static constexpr double kFocus = 80.0;
  Scene scene;
  std::unique_ptr<tern_onboard::Onboard> onboard;
  std::vector<int> cameras;
  int lidar = -1;
  std::int64_t now = kBegin;
  tern::Vec3 position{0.0, 0.0, 1.5}, drift{};
  std::map<std::int64_t, tern::Vec3> was;  ///< where it was
  std::int64_t late = 0;                   ///< how long frames take, ns
  std::int64_t begun = kBegin;             ///< no frames are of an earlier time
  std::size_t most = 0;                    ///< things that were known at once

 private:
  void send_pose() {
    was[now] = position;
    onboard->add_pose({now, {tern_onboard::plus(position, drift), {1.0, 0.0, 0.0, 0.0}}}, now);
  }
  float noisy(double way) { return static_cast<float>(way + scene.noise * random_.real(-1.0, 1.0)); }
  void send_frames(std::int64_t stamp) {
    const double t = 1e-9 * static_cast<double>(stamp - kBegin);
    std::vector<float> depths, points;
    for (int v = 0; v < kRows; ++v) {
      for (int u = 0; u < kColumns; ++u) {
        const tern::Vec3 ray{1.0, (0.5 * (kColumns - 1) - u) / kFocus, (0.5 * (kRows - 1) - v) / kFocus};
        depths.push_back(noisy(scene.way(was[stamp], ray, t)));
        for (const double along : {ray.x, ray.y, ray.z}) points.push_back(depths.back() * static_cast<float>(along));
      }
    }
    const std::size_t row = 4 * static_cast<std::size_t>(kColumns);
    for (const int camera : cameras) {
      onboard->add_frame(
          camera, tern_onboard::DepthImage{stamp, depths.data(), kRows * row, kColumns, kRows, row, true, false}, now);
    }
    if (lidar < 0) return;
    onboard->add_frame(
        lidar, tern_onboard::PointScan{stamp, points.data(), 3 * kRows * row, kColumns, kRows, 3 * row, 12, 0, 4, 8},
        now);
  }

  tern_test::Random random_{1};
};

}  // namespace tern_test

#endif
