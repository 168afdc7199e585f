// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// PX4 as the module sees it: a clock that the module's sleep lets run, topics that are recorded, and a vehicle that
// follows the setpoints as long as it is in offboard.
#pragma once

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "drivers/drv_hrt.h"
#include "uORB/topics/distance_sensor.h"
#include "uORB/topics/obstacle_distance.h"
#include "uORB/topics/offboard_control_mode.h"
#include "uORB/topics/trajectory_setpoint.h"
#include "uORB/topics/vehicle_attitude.h"
#include "uORB/topics/vehicle_land_detected.h"
#include "uORB/topics/vehicle_local_position.h"
#include "uORB/topics/vehicle_status.h"

constexpr uint8_t kOffboard = vehicle_status_s::NAVIGATION_STATE_OFFBOARD;
constexpr uint8_t kPosition = vehicle_status_s::NAVIGATION_STATE_POSCTL;
constexpr uint8_t kReturn = vehicle_status_s::NAVIGATION_STATE_AUTO_RTL;
constexpr uint8_t kArmed = vehicle_status_s::ARMING_STATE_ARMED;
constexpr uint8_t kDisarmed = vehicle_status_s::ARMING_STATE_DISARMED;

/// The last message of a sensor, and how many there were.
template <typename Message>
struct Sent {
  Message message{};
  unsigned sent = 0;
  void send(const Message& next) {
    message = next;
    ++sent;
  }
};

struct Px4 {
  hrt_abstime now = 1000000;
  hrt_abstime call_time = 0;  ///< that reading the clock takes
  vehicle_status_s status{0, kArmed, kPosition};
  vehicle_land_detected_s land{};
  vehicle_local_position_s local = hover();
  bool is_stale = false;          ///< the estimator has stopped
  float speed_parameter = 12.0f;  ///< MPC_XY_VEL_MAX
  std::function<void()> script;   ///< runs after each sleep
  int stack = 0;
  Sent<distance_sensor_s> distances[4];
  Sent<obstacle_distance_s> ring;
  std::vector<trajectory_setpoint_s> setpoints;
  std::vector<offboard_control_mode_s> modes;

  /// North 0.5, east -2, down -1.5: that is (-2, 0.5, 1.5) in east, north, up.
  static vehicle_local_position_s hover() {
    vehicle_local_position_s local{};
    local.xy_valid = local.z_valid = local.v_xy_valid = local.v_z_valid = true;
    local.x = 0.5f;
    local.y = -2.0f;
    local.z = -1.5f;
    local.heading = 1.0f;
    return local;
  }
  double seconds() const { return 1e-6 * static_cast<double>(now); }
  void follow() {
    if (setpoints.empty() || status.nav_state != kOffboard || status.arming_state != kArmed || land.landed) return;
    const trajectory_setpoint_s& s = setpoints.back();
    local.x = s.position[0];
    local.y = s.position[1];
    local.z = s.position[2];
    local.vx = s.velocity[0];
    local.vy = s.velocity[1];
    local.vz = s.velocity[2];
    local.heading = s.yaw;
  }
  /// Level.
  vehicle_attitude_s attitude() const {
    return {now, {std::cos(0.5f * local.heading), 0.0f, 0.0f, std::sin(0.5f * local.heading)}};
  }
};

extern Px4 px4;

/// The module's command line.
int call(std::vector<std::string> words);

constexpr float kStart[3] = {0.5f, -2.0f, -1.5f};
constexpr float kGoal[3] = {2.0f, 10.0f, -2.0f};
constexpr double kSwitch = 3.0;  // s: the pilot switches to offboard
constexpr double kMiddle = 7.0;  // s: in the middle of the plan
constexpr double kEnd = 40.0;    // s: the pilot takes over again

inline double distance(const float* a, const float* b) {
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

inline double speed(const trajectory_setpoint_s& s) {
  return std::hypot(std::hypot(s.velocity[0], s.velocity[1]), s.velocity[2]);
}

/// Flies to (10, 2, 2) in east, north, up, by the map of port/px4 alone; returns the module's answer. `script` runs
/// after each period, with the time in seconds.
inline int fly(const std::function<void(double)>& script) {
  px4.script = [script] { script(px4.seconds()); };
  return call({"tern_offboard", "start", "10", "2", "2", TERN_PX4_WORLD, "blind"});
}

inline std::string map_file(const std::string& lines) {
  const std::string path = "px4_map.txt";
  std::ofstream(path) << lines;
  return path;
}

/// A map without blocks.
constexpr const char* kOpen =
    "boundary -5 -10 0.5 15 10 6  # free\nresolution 0.4\nradius 0.3\n\ntracking_margin 0.3\nv_horizontal 1\nv_max 2 "
    "2 1\nstart 0 0 1\n";

/// Flies to (10, 2, 2) with a map of these lines.
inline int fly_with(const std::string& lines, const std::function<void(double)>& script, bool is_blind = false) {
  px4.script = [script] { script(px4.seconds()); };
  std::vector<std::string> words = {"tern_offboard", "start", "10", "2", "2", map_file(lines)};
  if (is_blind) words.push_back("blind");
  return call(words);
}

/// The pilot's switch: offboard from kSwitch to kEnd.
inline void switch_mode(double t) {
  px4.status.nav_state = t >= kSwitch && t < kEnd ? kOffboard : kPosition;
}

/// The largest step from a setpoint to the next, beyond what their velocities explain, m.
inline double largest_step() {
  double largest = 0.0;
  for (std::size_t i = 1; i < px4.setpoints.size(); ++i) {
    const trajectory_setpoint_s& a = px4.setpoints[i - 1];
    const trajectory_setpoint_s& b = px4.setpoints[i];
    const double dt = 1e-6 * static_cast<double>(b.timestamp - a.timestamp);
    largest = std::max(largest, distance(a.position, b.position) - dt * std::max(speed(a), speed(b)));
  }
  return largest;
}

/// Setpoints sent at times for which `when` holds.
template <typename When>
std::size_t count_setpoints(const When& when) {
  return static_cast<std::size_t>(std::count_if(px4.setpoints.begin(), px4.setpoints.end(), [&](const auto& s) {
    return when(1e-6 * static_cast<double>(s.timestamp));
  }));
}
