// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "tern/export.hpp"

namespace tern {

Px4Limits px4_limits() noexcept {
  return {12.0, 3.0, 1.5, 3.0, 4.0, 3.0, 4.0};
}

ArdupilotLimits ardupilot_limits() noexcept {
  return {10.0, 2.5, 1.5, 2.5, 1.0, 5.0, 5.0};
}

Limits limits_from_px4(const Px4Limits& p) noexcept {
  Limits limits{};
  limits.v_max = {p.mpc_xy_vel_max, p.mpc_xy_vel_max, p.mpc_z_vel_max_up};
  limits.v_min = {-p.mpc_xy_vel_max, -p.mpc_xy_vel_max, -p.mpc_z_vel_max_dn};
  limits.v_horizontal = p.mpc_xy_vel_max;
  limits.a_max = {p.mpc_acc_hor, p.mpc_acc_hor, p.mpc_acc_up_max};
  limits.a_min = {-p.mpc_acc_hor, -p.mpc_acc_hor, -p.mpc_acc_down_max};
  limits.a_horizontal = p.mpc_acc_hor;
  limits.j_max = {p.mpc_jerk_auto, p.mpc_jerk_auto, p.mpc_jerk_auto};
  limits.j_horizontal = p.mpc_jerk_auto;
  return limits;
}

Limits limits_from_ardupilot(const ArdupilotLimits& p) noexcept {
  Limits limits{};
  limits.v_max = {p.wpnav_speed, p.wpnav_speed, p.wpnav_speed_up};
  limits.v_min = {-p.wpnav_speed, -p.wpnav_speed, -p.wpnav_speed_dn};
  limits.v_horizontal = p.wpnav_speed;
  limits.a_max = {p.wpnav_accel, p.wpnav_accel, p.wpnav_accel_z};
  limits.a_min = {-p.wpnav_accel, -p.wpnav_accel, -p.wpnav_accel_z};
  limits.a_horizontal = p.wpnav_accel;
  limits.j_max = {p.psc_jerk_xy, p.psc_jerk_xy, p.psc_jerk_z};
  limits.j_horizontal = p.psc_jerk_xy;
  return limits;
}

}  // namespace tern
