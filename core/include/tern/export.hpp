// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans in the formats that flight stacks take: setpoints in north-east-down, MAVLink frames, and the Crazyflie's
// polynomials. Tern's world is east-north-up, its body forward-left-up; this is the only place that turns frames.
// docs/export.md says what each stack does with them.
#ifndef TERN_EXPORT_HPP
#define TERN_EXPORT_HPP

#include <stdint.h>

#include "tern/request.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"
#include "tern/yaw.hpp"

namespace tern {

/// East-north-up to north-east-down, and back: (x, y, z) becomes (y, x, -z).
Vec3 ned_from_enu(const Vec3& v) noexcept;

/// The attitude of a FlatState, from a forward-left-up body to east-north-up, as one from forward-right-down to
/// north-east-down. Quaternions are (w, x, y, z), w >= 0 in the result. `ned` may be `enu`.
void attitude_ned(const double enu[4], double ned[4]) noexcept;

/// A setpoint as PX4's TrajectorySetpoint and MAVLink's SET_POSITION_TARGET_LOCAL_NED have it: north, east, down.
struct SetpointNed {
  float position[3];      ///< m
  float velocity[3];      ///< m/s
  float acceleration[3];  ///< m/s^2
  float jerk[3];          ///< m/s^3; MAVLink does not carry it
  float yaw;              ///< rad, clockwise from north, in (-pi, pi]
  float yaw_rate;         ///< rad/s, clockwise
};

/// The setpoint of a sample and a yaw, both of the same time. Take `origin`, world frame, as the stack's local origin.
SetpointNed setpoint_ned(const Sample& sample, const YawSample& yaw, const Vec3& origin) noexcept;

/// Bytes of one SET_POSITION_TARGET_LOCAL_NED frame of MAVLink 2, at most.
constexpr int32_t kMavlinkSetpointBytes = 65;

/// Who sends a MAVLink frame, to whom, and when.
struct MavlinkHeader {
  uint8_t system, component;                ///< the sender's
  uint8_t target_system, target_component;  ///< the autopilot's, usually 1 and 1
  uint8_t sequence;                         ///< one more with each frame of this sender
  uint32_t time_boot_ms;
};

/// Writes the frame: position, velocity, acceleration, yaw and yaw rate in LOCAL_NED, none of them masked. `frame` has
/// room for kMavlinkSetpointBytes. Returns the bytes in use: MAVLink leaves out zeros at the payload's end.
int32_t mavlink_setpoint(const SetpointNed& setpoint, const MavlinkHeader& header, uint8_t* frame) noexcept;

/// One piece of a Crazyflie's trajectory in raw form, 132 bytes as the firmware stores it: polynomials of x, y, z (m,
/// world frame) and yaw (rad), coefficients by rising powers of the time in seconds.
struct Poly4d {
  float p[4][8];
  float duration;
};

/// Pieces that fit into the firmware's trajectory memory of 4096 bytes.
constexpr int32_t kCrazyfliePieces = 31;

/// Segment number `segment` as a piece. x, y and z are the segment's, rounded to float. Yaw is the polynomial of degree
/// 7 that agrees with `yaw` in angle, rate and acceleration at both ends of the segment and in angle at a third and two
/// thirds of it; a null `yaw` is yaw 0. kOk, or kInvalidArgument if there is no such segment.
Status poly4d(const Trajectory& trajectory, const YawPlan* yaw, int32_t segment, Poly4d& piece) noexcept;

/// Bytes that crazyflie_compressed() needs for so many segments, at most.
constexpr int32_t crazyflie_compressed_bytes(int32_t segments) {
  return 8 + 59 * segments + 3;
}

/// Writes the Crazyflie's compressed form: Bezier control points in millimetres, yaw in tenths of a degree, durations
/// in milliseconds. It begins at the plan's start and ends with a piece of duration 0. Rounding changes the curve:
/// prove what crazyflie_decompressed() reads back. `used`: bytes written. kOk; kInvalidArgument for an empty plan, too
/// little room, a segment shorter than 1 ms or longer than 65.535 s, or coordinates beyond 32.767 m.
Status crazyflie_compressed(const Trajectory& trajectory, const YawPlan* yaw, uint8_t* bytes, int32_t room,
                            int32_t& used) noexcept;

/// The trajectory that a compressed form flies; each segment has the polyhedron number of `original`'s. kOk, or
/// kInvalidArgument if the bytes are not of crazyflie_compressed().
Status crazyflie_decompressed(const uint8_t* bytes, int32_t count, const Trajectory& original,
                              Trajectory& trajectory) noexcept;

/// PX4's parameters of the same names, m/s, m/s^2 and m/s^3. px4_limits() has the firmware's defaults.
struct Px4Limits {
  double mpc_xy_vel_max, mpc_z_vel_max_up, mpc_z_vel_max_dn;
  double mpc_acc_hor, mpc_acc_up_max, mpc_acc_down_max;
  double mpc_jerk_auto;
};
Px4Limits px4_limits() noexcept;

/// ArduPilot's parameters, in metres where ArduPilot has centimetres. ardupilot_limits() has the firmware's defaults.
struct ArdupilotLimits {
  double wpnav_speed, wpnav_speed_up, wpnav_speed_dn;
  double wpnav_accel, wpnav_accel_z;
  double psc_jerk_xy, psc_jerk_z;
};
ArdupilotLimits ardupilot_limits() noexcept;

/// Limits of plans that the autopilot can follow: horizontal ones on the norm, climb and descent apart.
Limits limits_from_px4(const Px4Limits& parameters) noexcept;
Limits limits_from_ardupilot(const ArdupilotLimits& parameters) noexcept;

}  // namespace tern

#endif
