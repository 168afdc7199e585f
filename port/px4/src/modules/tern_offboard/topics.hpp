// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the module hears from PX4 and what it says, in Tern's frame.
#pragma once

#include <drivers/drv_hrt.h>
#include <math.h>
#include <string.h>
#include <uORB/topics/offboard_control_mode.h>
#include <uORB/topics/trajectory_setpoint.h>
#include <uORB/topics/vehicle_attitude.h>
#include <uORB/topics/vehicle_land_detected.h>
#include <uORB/topics/vehicle_local_position.h>
#include <uORB/topics/vehicle_status.h>

#include <tern_stacks/stacks.hpp>
#include <uORB/Publication.hpp>
#include <uORB/Subscription.hpp>

namespace tern_offboard {

constexpr hrt_abstime kLongest = 200000;  // us between two setpoints, and since the estimate

/// A place to hover.
struct Hover {
  tern::Vec3 position;
  double heading;  ///< rad, PX4's: clockwise from north
};

/// What PX4 says at one time.
struct Seen {
  hrt_abstime now;
  bool offboard;
  bool flying;        ///< armed and off the ground
  bool valid;         ///< the estimate of position and velocity
  hrt_abstime stamp;  ///< of the estimate
  Hover here;
  double speed;
  uint8_t resets[5];  ///< how often the estimator has reset position, velocity and heading
  float attitude[4];  ///< quaternion (w, x, y, z) of the body; zeros if there is none
};

inline tern::Vec3 difference(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline double length(const tern::Vec3& v) {
  return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

inline bool is_valid(const vehicle_local_position_s& local, hrt_abstime now) {
  const bool fresh = local.timestamp + kLongest >= now && local.timestamp <= now + kLongest;
  const bool finite = fabsf(local.x) < 1e6f && fabsf(local.y) < 1e6f && fabsf(local.z) < 1e6f &&
                      fabsf(local.heading) < 10.f;  // false for NaN
  return fresh && finite && local.xy_valid && local.z_valid && local.v_xy_valid && local.v_z_valid;
}

class Topics {
 public:
  Seen look() {
    vehicle_status_s status{};
    vehicle_land_detected_s land{};
    vehicle_local_position_s local{};
    vehicle_attitude_s attitude{};
    const bool has_status = statuses_.copy(&status);
    const bool landed = lands_.copy(&land) && land.landed;
    const bool has_local = positions_.copy(&local);
    Seen seen{};
    seen.now = hrt_absolute_time();
    seen.offboard = has_status && status.nav_state == vehicle_status_s::NAVIGATION_STATE_OFFBOARD;
    seen.flying = has_status && status.arming_state == vehicle_status_s::ARMING_STATE_ARMED && !landed;
    seen.valid = has_local && is_valid(local, seen.now);
    seen.stamp = local.timestamp;
    seen.here.position =
        tern::ned_from_enu({static_cast<double>(local.x), static_cast<double>(local.y), static_cast<double>(local.z)});
    seen.here.heading = static_cast<double>(local.heading);
    seen.speed = sqrt(static_cast<double>(local.vx * local.vx + local.vy * local.vy + local.vz * local.vz));
    const uint8_t resets[] = {local.xy_reset_counter, local.z_reset_counter, local.vxy_reset_counter,
                              local.vz_reset_counter, local.heading_reset_counter};
    memcpy(seen.resets, resets, sizeof resets);
    if (attitudes_.copy(&attitude) && attitude.timestamp + kLongest >= seen.now) {
      memcpy(seen.attitude, attitude.q, sizeof seen.attitude);
    }
    return seen;
  }

  /// Proof of life, without which PX4 leaves offboard or does not enter it.
  void publish_mode() {
    offboard_control_mode_s mode{};
    mode.timestamp = hrt_absolute_time();
    mode.position = true;
    modes_.publish(mode);
  }

  void publish(const tern::Sample& sample, const tern::YawSample& yaw) {
    const tern::SetpointNed from = tern::setpoint_ned(sample, yaw, tern::Vec3{0.0, 0.0, 0.0});
    trajectory_setpoint_s setpoint{};
    setpoint.timestamp = hrt_absolute_time();
    memcpy(setpoint.position, from.position, sizeof from.position);
    memcpy(setpoint.velocity, from.velocity, sizeof from.velocity);
    memcpy(setpoint.acceleration, from.acceleration, sizeof from.acceleration);
    memcpy(setpoint.jerk, from.jerk, sizeof from.jerk);
    setpoint.yaw = from.yaw;
    setpoint.yawspeed = from.yaw_rate;
    setpoints_.publish(setpoint);
  }

 private:
  uORB::Publication<offboard_control_mode_s> modes_{ORB_ID(offboard_control_mode)};
  uORB::Publication<trajectory_setpoint_s> setpoints_{ORB_ID(trajectory_setpoint)};
  uORB::Subscription statuses_{ORB_ID(vehicle_status)};
  uORB::Subscription lands_{ORB_ID(vehicle_land_detected)};
  uORB::Subscription positions_{ORB_ID(vehicle_local_position)};
  uORB::Subscription attitudes_{ORB_ID(vehicle_attitude)};
};

}  // namespace tern_offboard
