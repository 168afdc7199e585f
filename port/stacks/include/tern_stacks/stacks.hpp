// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans in the formats that flight stacks take: setpoints in north-east-down, MAVLink frames, and the Crazyflie's
// polynomials. Tern's world is east-north-up, its body forward-left-up; this is the only place that turns frames. Link
// the library tern_stacks, whose functions are in Tern's namespace.
// docs/export.md says what each stack does with them.
#ifndef TERN_STACKS_HPP
#define TERN_STACKS_HPP

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
  float yaw;              ///< rad, clockwise from north, in (-pi, pi]; NaN: the stack may choose
  float yaw_rate;         ///< rad/s, clockwise; NaN: the stack may choose
};

/// The setpoint of a sample and a yaw, both of the same time. `origin`, world frame, is the stack's local origin: the
/// point of the world that becomes 0. It is subtracted in double precision. Floats are coarse far from 0 (0.25 m at
/// 4,000 km), so let it be near the plan.
SetpointNed setpoint_ned(const Sample& sample, const YawSample& yaw, const Vec3& origin) noexcept;

/// The setpoint of a sample without a yaw plan: yaw and yaw rate are NaN.
SetpointNed setpoint_ned(const Sample& sample, const Vec3& origin) noexcept;

/// How far an export is from the plan, at equal times since the beginning: bounds for all times, not samples.
struct ExportError {
  double position;      ///< m
  double velocity;      ///< m/s
  double acceleration;  ///< m/s^2
  double jerk;          ///< m/s^3
  double yaw;           ///< rad; 0 without a yaw plan
  double yaw_rate;      ///< rad/s; 0 without a yaw plan
};

/// What setpoint_ned() loses of a plan by rounding to float. `yaw` may be null.
ExportError setpoint_error(const Trajectory& trajectory, const YawPlan* yaw, const Vec3& origin) noexcept;

/// Bytes of one SET_POSITION_TARGET_LOCAL_NED frame of MAVLink 2, at most.
constexpr int32_t kMavlinkSetpointBytes = 65;

/// Who sends a MAVLink frame, to whom, and when.
struct MavlinkHeader {
  uint8_t system, component;                ///< the sender's
  uint8_t target_system, target_component;  ///< the autopilot's, usually 1 and 1
  uint8_t sequence;                         ///< one more with each frame of this sender
  uint32_t time_boot_ms;
};

/// Writes the frame: position, velocity, acceleration, yaw and yaw rate in LOCAL_NED. The type mask tells the autopilot
/// to ignore fields that are NaN. `frame` has room for kMavlinkSetpointBytes. Returns the bytes in use, or 0 if a
/// number is infinite: then there is nothing to send.
int32_t mavlink_setpoint(const SetpointNed& setpoint, const MavlinkHeader& header, uint8_t* frame) noexcept;

/// One piece of a Crazyflie's trajectory in raw form, 132 bytes as the firmware stores it: polynomials of x, y, z (m,
/// world frame) and yaw (rad), coefficients by rising powers of the time in seconds.
struct Poly4d {
  float p[4][8];
  float duration;
};

/// Pieces that fit into the firmware's trajectory memory of 4096 bytes.
constexpr int32_t kCrazyfliePieces = 31;

/// The yaw of a Crazyflie's pieces keeps this near to the yaw plan, rad, if there is room to halve pieces that would be
/// further off. ExportError::yaw says how near it is.
constexpr double kCrazyflieYaw = 0.05;

/// The plan as pieces, relative to `origin`, a point of the world: one piece for each segment, or for parts of it if
/// the yaw needs them. Numbers are rounded to float; `error` says how far that moves the plan. Times are those of the
/// rounded durations, added up. The yaw polynomial of a piece agrees with `yaw` in angle, rate and acceleration at both
/// ends and in angle at a third and two thirds; a null `yaw` is yaw 0. kOk; kInvalidArgument, with nothing but pieces
/// written, for an empty plan, a segment too short for float, or more segments than `room` or kCrazyfliePieces.
Status crazyflie_raw(const Trajectory& trajectory, const YawPlan* yaw, const Vec3& origin, Poly4d* pieces, int32_t room,
                     int32_t& count, ExportError& error) noexcept;

/// Bytes that crazyflie_compressed() needs for so many pieces, at most. It makes kMaxSegments pieces at most.
constexpr int32_t crazyflie_compressed_bytes(int32_t pieces) {
  return 8 + 59 * pieces + 3;
}

/// Writes the Crazyflie's compressed form: Bezier control points in millimetres relative to `origin`, yaw in tenths of
/// a degree, times since the beginning rounded to milliseconds. It begins at the plan's start and ends with a piece of
/// duration 0. Pieces are halved for the yaw as in raw form, if the halves last a second and there is room. Rounding
/// changes the curve, `error` says by how much: prove what crazyflie_decompressed() reads back. `used`: bytes written.
/// kOk; kInvalidArgument for an empty plan, too little room, a piece that lasts 0 ms once rounded or more than
/// 65.535 s, or coordinates beyond 32.767 m.
Status crazyflie_compressed(const Trajectory& trajectory, const YawPlan* yaw, const Vec3& origin, uint8_t* bytes,
                            int32_t room, int32_t& used, ExportError& error) noexcept;

/// The trajectory that a compressed form flies, relative to the `origin` that it was written with. It belongs to no
/// corridor: its polyhedron numbers are 0. kOk, or kInvalidArgument if the bytes are not of crazyflie_compressed().
Status crazyflie_decompressed(const uint8_t* bytes, int32_t count, const Vec3& origin, Trajectory& trajectory) noexcept;

/// PX4's parameters of the same names, m/s, m/s^2 and m/s^3. px4_limits() has the firmware's defaults. The limits of
/// thrust are the shares over MPC_THR_HOVER, times gravity. So set the share at which the vehicle hovers with its
/// payload.
struct Px4Limits {
  double mpc_xy_vel_max, mpc_z_vel_max_up, mpc_z_vel_max_dn;
  double mpc_acc_hor, mpc_acc_up_max, mpc_acc_down_max;
  double mpc_jerk_auto;
  double mpc_tiltmax_air;                          ///< degrees
  double mpc_thr_hover, mpc_thr_min, mpc_thr_max;  ///< shares of the full thrust
  double mc_rollrate_max, mc_pitchrate_max;        ///< degrees per second
};
Px4Limits px4_limits() noexcept;

/// ArduPilot's parameters of the same names, with their units in Tern. Releases before 4.7 give speeds and
/// accelerations in centimetres: divide those by 100. From 4.7 on, they are in metres and called WP_SPD, WP_SPD_UP,
/// WP_SPD_DN, WP_ACC, WP_ACC_Z, PSC_JERK_NE and PSC_JERK_D. ardupilot_limits() has the firmware's defaults.
struct ArdupilotLimits {
  double wpnav_speed_m_s, wpnav_speed_up_m_s, wpnav_speed_dn_m_s;
  double wpnav_accel_m_s2, wpnav_accel_z_m_s2;
  double psc_jerk_xy_m_s3, psc_jerk_z_m_s3;
  double angle_max_deg;                           ///< ANGLE_MAX is in hundredths of a degree
  double mot_thst_hover;                          ///< share of the full thrust, with the payload
  double atc_rate_r_max_deg, atc_rate_p_max_deg;  ///< degrees per second; 0: no limit
};
ArdupilotLimits ardupilot_limits() noexcept;

/// The Crazyflie's parameters of the group posCtlPid, and the thrust at which it hovers with its decks. Speeds and tilt
/// are those of its PID controller; the other controllers follow faster plans. crazyflie_limits() has the firmware's
/// defaults.
struct CrazyflieLimits {
  double x_vel_max, y_vel_max, z_vel_max;  ///< xVelMax, yVelMax, zVelMax, m/s
  double r_limit, p_limit;                 ///< rLimit, pLimit: roll and pitch, degrees
  double thrust_base, thrust_min;          ///< thrustBase, thrustMin: at hover and at least, of 65535
};
CrazyflieLimits crazyflie_limits() noexcept;

/// The share of PX4's speed limits that plans use. PX4 clips the sum of the plan's velocity and its own correction at
/// MPC_XY_VEL_MAX: at a share of 1, a vehicle that lags cannot catch up. docs/integration/px4.md has measurements.
constexpr double kPx4SpeedShare = 0.7;
/// The share of ArduPilot's jerk limits that plans use, for the same reason. In guided mode, ArduPilot does not clip
/// speeds.
constexpr double kArdupilotJerkShare = 0.9;

/// Limits of plans that the autopilot can follow: horizontal ones on the norm, climb and descent apart, thrust, tilt
/// and body rates. kOk; kNonFiniteInput; or kLimitsInvalid for a parameter below 0.01 or above what its autopilot's
/// documentation allows, for example one in centimetres in place of metres (docs/export.md has the ranges). `limits` is
/// then as it was, and `field` names the limit that would have come from the parameter. `field` may be null.
Status limits_from_px4(const Px4Limits& parameters, Limits& limits, Field* field = nullptr) noexcept;
Status limits_from_ardupilot(const ArdupilotLimits& parameters, Limits& limits, Field* field = nullptr) noexcept;
Status limits_from_crazyflie(const CrazyflieLimits& parameters, Limits& limits, Field* field = nullptr) noexcept;

}  // namespace tern

#endif
