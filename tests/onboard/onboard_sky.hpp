// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A vehicle with a camera in a true world, for tests of Onboard: it flies what it is told, and its messages can be
// spoiled.
#ifndef TERN_TESTS_ONBOARD_SKY_HPP
#define TERN_TESTS_ONBOARD_SKY_HPP

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/flight/depth_camera.hpp"
#include "host/flight/flight_world.hpp"
#include "tern_onboard/onboard.hpp"

namespace tern_test {

inline constexpr std::int64_t kMs = 1000000;

/// Settings that fit a world of the simulator.
inline tern_onboard::Settings settings_of(const tern_host::FlightWorld& world) {
  const tern_host::FlightSettings& s = world.settings;
  tern_onboard::Settings settings;
  settings.map.cell = s.cell;
  settings.map.window = s.window;
  settings.map.radius = s.body_radius + s.pose_margin;
  settings.map.tracking_margin = s.tracking_margin;
  settings.map.range = s.sensor_range;
  settings.map.pose_margin = 0.01;
  settings.map.angle_margin = 0.0;
  settings.map.depth_margin = s.depth_margin;
  settings.fly.horizon = 0.8 * s.sensor_range;
  settings.fly.speed = settings.fly.climb = settings.fly.sink = s.v_max;
  settings.fly.acceleration = settings.fly.acceleration_z = s.a_max;
  settings.fly.jerk = 0.0;
  settings.fly.yaw_rate = s.yaw_rate;
  settings.fly.yaw_acceleration = s.yaw_acceleration;
  settings.fly.field_of_view = s.fov_horizontal;
  return settings;
}

class Sky {
 public:
  explicit Sky(const std::string& family, const std::function<void(tern_onboard::Settings&)>& change = {})
      : world(tern_host::read_flight_world(family, {})), noise_(1), onboard(changed(world, change)) {
    position = world.start;
    yaw = std::atan2(world.goal.y - position.y, world.goal.x - position.x);
    camera = onboard.add_sensor({"camera", tern_onboard::SensorKind::kDepth, {0.1, 1000.0, false, 0.0}});
    const tern_host::DepthFrame frame = tern_host::take_frame(world, position, yaw, 0, noise_);
    onboard.set_lens(camera,
                     {frame.view.width, frame.view.height, frame.view.fx, frame.view.fy, frame.view.cx, frame.view.cy});
    onboard.set_mounting(camera, {{0.0, 0.0, 0.0}, {0.5, -0.5, 0.5, -0.5}});
  }

  tern_onboard::StampedPose pose() const {
    return {now, {tern_onboard::plus(position, drift), {std::cos(0.5 * yaw), 0.0, 0.0, std::sin(0.5 * yaw)}}};
  }
  void send_pose() { onboard.add_pose(pose(), now); }
  void send_frame() {
    const tern_host::DepthFrame frame = tern_host::take_frame(world, position, yaw, now, noise_);
    onboard.add_frame(camera, image_of(frame, now), now);
  }
  tern_onboard::DepthImage image_of(const tern_host::DepthFrame& frame, std::int64_t stamp) const {
    const auto row = 4 * static_cast<std::size_t>(frame.view.width);
    return {stamp, frame.depths.data(), 4 * frame.depths.size(), frame.view.width, frame.view.height, row, true, false};
  }
  /// The estimate jumps, and with the next pose everybody knows.
  void jump(const tern::Vec3& by) {
    drift = tern_onboard::plus(drift, by);
    now += kMs;
    send_pose();
  }
  /// Ten milliseconds: a tick, a pose, every third time a frame. The vehicle is where it is told to be.
  void step() {
    now += 10 * kMs;
    onboard.tick(now);
    const tern_onboard::Setpoint setpoint = onboard.setpoint(now);
    if (setpoint.valid && follows) {
      position = tern_onboard::plus(tern_onboard::minus(setpoint.position, drift), off);
      yaw = setpoint.yaw;
    }
    if (poses) send_pose();
    if (frames && ++steps_ % 3 == 0) send_frame();
    least_clearance = std::min(least_clearance, tern_host::clearance(world, position));
  }
  /// Until the flight rests for a reason, or the time is up.
  tern::FlightReason fly(double seconds) {
    for (const std::int64_t end = now + std::llround(1e9 * seconds); now < end;) {
      step();
      const tern::FlightReport report = onboard.status(now).report;
      if (report.mode == tern::FlightMode::kRest && report.reason != tern::FlightReason::kNone) return report.reason;
    }
    return tern::FlightReason::kNone;
  }
  /// Begins with a pose and the world's goal.
  tern_onboard::Answer begin() {
    send_pose();
    return onboard.set_goal(world.goal, now);
  }

  tern_host::FlightWorld world;

 private:
  static tern_onboard::Settings changed(const tern_host::FlightWorld& world,
                                        const std::function<void(tern_onboard::Settings&)>& change) {
    tern_onboard::Settings settings = settings_of(world);
    if (change) change(settings);
    return settings;
  }
  tern_host::Noise noise_;
  int steps_ = 0;

 public:
  tern_onboard::Onboard onboard;
  int camera = 0;
  std::int64_t now = 5000 * kMs;
  tern::Vec3 position{};
  double yaw = 0.0;
  tern::Vec3 drift{};  ///< of the estimate off the truth
  tern::Vec3 off{};    ///< of the vehicle off its setpoint
  bool poses = true, frames = true, follows = true;
  double least_clearance = 1e9;
};

}  // namespace tern_test

#endif
