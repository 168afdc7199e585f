/* Copyright (c) 2026, the Tern authors
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Plans for flight stacks, in C99: tern_stacks/stacks.hpp under C names, which explains every field and answer. */
#ifndef TERN_STACKS_H
#define TERN_STACKS_H

#include "tern/tern_yaw.h"

#ifdef __cplusplus
#include "tern_stacks/stacks.hpp"
typedef tern::SetpointNed tern_setpoint;
typedef tern::MavlinkHeader tern_mavlink_header;
typedef tern::ExportError tern_export_error;
typedef tern::Poly4d tern_crazyflie_piece;
typedef tern::Px4Limits tern_px4_parameters;
typedef tern::ArdupilotLimits tern_ardupilot_parameters;
typedef tern::CrazyflieLimits tern_crazyflie_parameters;
extern "C" {
#else
/* clang-format off */
/* North, east, down; yaw clockwise from north, or NaN: tern::SetpointNed. */
typedef struct { float position[3], velocity[3], acceleration[3], jerk[3], yaw, yaw_rate; } tern_setpoint;
/* How far an export is from the plan, at most: m, m/s, m/s^2, m/s^3, rad, rad/s. tern::ExportError. */
typedef struct { double position, velocity, acceleration, jerk, yaw, yaw_rate; } tern_export_error;
/* Sender, receiver and time of a MAVLink frame: tern::MavlinkHeader. */
typedef struct {
  uint8_t system, component, target_system, target_component, sequence; uint32_t time_boot_ms;
} tern_mavlink_header;
/* A piece of a Crazyflie's trajectory in raw form: tern::Poly4d. */
typedef struct { float p[4][8]; float duration; } tern_crazyflie_piece;
/* Parameters of PX4, ArduPilot and the Crazyflie: tern::Px4Limits, tern::ArdupilotLimits, tern::CrazyflieLimits. */
typedef struct {
  double mpc_xy_vel_max, mpc_z_vel_max_up, mpc_z_vel_max_dn, mpc_acc_hor, mpc_acc_up_max, mpc_acc_down_max,
         mpc_jerk_auto, mpc_tiltmax_air, mpc_thr_hover, mpc_thr_min, mpc_thr_max,
         mc_rollrate_max, mc_pitchrate_max;
} tern_px4_parameters;
typedef struct {
  double wpnav_speed_m_s, wpnav_speed_up_m_s, wpnav_speed_dn_m_s, wpnav_accel_m_s2, wpnav_accel_z_m_s2,
         psc_jerk_xy_m_s3, psc_jerk_z_m_s3, angle_max_deg, mot_thst_hover, atc_rate_r_max_deg, atc_rate_p_max_deg;
} tern_ardupilot_parameters;
typedef struct {
  double x_vel_max, y_vel_max, z_vel_max, r_limit, p_limit, thrust_base, thrust_min;
} tern_crazyflie_parameters;
/* clang-format on */
#endif

/* Room for one MAVLink frame, and for a compressed plan of so many pieces. */
#define TERN_MAVLINK_SETPOINT_BYTES 65
#define TERN_CRAZYFLIE_COMPRESSED_BYTES(pieces) (8 + 59 * (pieces) + 3)

/* Pieces that fit into a Crazyflie's memory. */
#define TERN_CRAZYFLIE_PIECES 31

/* In all calls below, `origin` is the point of the world that becomes 0; null: the world's origin. `yaw` may be null.
 *
 * The setpoint of a sample and a yaw. A null sample counts as zeros; without a yaw, yaw and yaw rate are NaN. */
void tern_setpoint_ned(const tern_sample* sample, const tern_yaw_sample* yaw, const tern_vec3* origin,
                       tern_setpoint* setpoint);
/* What tern_setpoint_ned() loses of a plan by rounding to float. ok or invalid_argument. */
uint8_t tern_setpoint_error(const tern_trajectory* trajectory, const tern_yaw_plan* yaw, const tern_vec3* origin,
                            tern_export_error* error);
/* The attitude of a tern_flat_state for an autopilot: (w, x, y, z), forward-right-down to north-east-down. */
void tern_attitude_ned(const double enu[4], double ned[4]);
/* Writes SET_POSITION_TARGET_LOCAL_NED, whose type mask excepts what is NaN; returns its bytes, 0 for a null pointer
 * or a number that is infinite. */
int32_t tern_mavlink_setpoint(const tern_setpoint* setpoint, const tern_mavlink_header* header, uint8_t* frame);
/* The plan as pieces in raw form; `room` for TERN_CRAZYFLIE_PIECES is enough. ok or invalid_argument. */
uint8_t tern_crazyflie_raw(const tern_trajectory* trajectory, const tern_yaw_plan* yaw, const tern_vec3* origin,
                           tern_crazyflie_piece* pieces, int32_t room, int32_t* count, tern_export_error* error);
/* The Crazyflie's compressed form, and back. ok or invalid_argument. */
uint8_t tern_crazyflie_compressed(const tern_trajectory* trajectory, const tern_yaw_plan* yaw, const tern_vec3* origin,
                                  uint8_t* bytes, int32_t room, int32_t* used, tern_export_error* error);
uint8_t tern_crazyflie_decompressed(const uint8_t* bytes, int32_t count, const tern_vec3* origin,
                                    tern_trajectory* trajectory);
/* The firmwares' default parameters, and limits of plans that the autopilot can follow. ok; non_finite_input,
 * limits_invalid or, for a null pointer, invalid_argument: `limits` is then as it was. `field`, which may be null, gets
 * the number of the limit that a bad parameter would have become: tern_field_name() has its name. */
void tern_px4_defaults(tern_px4_parameters* parameters);
void tern_ardupilot_defaults(tern_ardupilot_parameters* parameters);
void tern_crazyflie_defaults(tern_crazyflie_parameters* parameters);
uint8_t tern_limits_from_px4(const tern_px4_parameters* parameters, tern_limits* limits, uint8_t* field);
uint8_t tern_limits_from_ardupilot(const tern_ardupilot_parameters* parameters, tern_limits* limits, uint8_t* field);
uint8_t tern_limits_from_crazyflie(const tern_crazyflie_parameters* parameters, tern_limits* limits, uint8_t* field);

#ifdef __cplusplus
} /* extern "C" */
#endif

#endif
