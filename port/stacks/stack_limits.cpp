// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "tern_stacks/stacks.hpp"

namespace tern {
namespace {

/// The least that any parameter may be, in metres and seconds.
constexpr double kLeast = 0.01;

/// A parameter, the most that its autopilot's documentation allows, and the limit that comes from it.
struct Parameter {
  double value;
  double most;
  Field field;
};

template <int kCount>
Status judge(const Parameter (&parameters)[kCount], Field* field) {
  for (const Parameter& p : parameters) {
    if (finite(p.value) && p.value >= kLeast && p.value <= p.most) continue;
    if (field != nullptr) *field = p.field;
    return finite(p.value) ? Status::kLimitsInvalid : Status::kNonFiniteInput;
  }
  if (field != nullptr) *field = Field::kNone;
  return Status::kOk;
}

}  // namespace

Px4Limits px4_limits() noexcept {
  return {12.0, 3.0, 1.5, 3.0, 4.0, 3.0, 4.0};
}

ArdupilotLimits ardupilot_limits() noexcept {
  return {10.0, 2.5, 1.5, 2.5, 1.0, 5.0, 5.0};
}

Status limits_from_px4(const Px4Limits& p, Limits& limits, Field* field) noexcept {
  const Parameter all[] = {{p.mpc_xy_vel_max, 20.0, Field::kVHorizontal}, {p.mpc_z_vel_max_up, 8.0, Field::kVMax},
                           {p.mpc_z_vel_max_dn, 4.0, Field::kVMin},       {p.mpc_acc_hor, 15.0, Field::kAHorizontal},
                           {p.mpc_acc_up_max, 15.0, Field::kAMax},        {p.mpc_acc_down_max, 15.0, Field::kAMin},
                           {p.mpc_jerk_auto, 80.0, Field::kJMax}};
  const Status status = judge(all, field);
  if (status != Status::kOk) return status;
  const double speed = kPx4SpeedShare * p.mpc_xy_vel_max;
  limits = Limits{};
  limits.v_max = {speed, speed, kPx4SpeedShare * p.mpc_z_vel_max_up};
  limits.v_min = {-speed, -speed, -(kPx4SpeedShare * p.mpc_z_vel_max_dn)};
  limits.v_horizontal = speed;
  limits.a_max = {p.mpc_acc_hor, p.mpc_acc_hor, p.mpc_acc_up_max};
  limits.a_min = {-p.mpc_acc_hor, -p.mpc_acc_hor, -p.mpc_acc_down_max};
  limits.a_horizontal = p.mpc_acc_hor;
  limits.j_max = {p.mpc_jerk_auto, p.mpc_jerk_auto, p.mpc_jerk_auto};
  limits.j_horizontal = p.mpc_jerk_auto;
  return status;
}

Status limits_from_ardupilot(const ArdupilotLimits& p, Limits& limits, Field* field) noexcept {
  // In centimetres, the least that ArduPilot's documentation allows is 10 for speeds and 50 for accelerations.
  const Parameter all[] = {
      {p.wpnav_speed_m_s, 20.0, Field::kVHorizontal}, {p.wpnav_speed_up_m_s, 10.0, Field::kVMax},
      {p.wpnav_speed_dn_m_s, 5.0, Field::kVMin},      {p.wpnav_accel_m_s2, 5.0, Field::kAHorizontal},
      {p.wpnav_accel_z_m_s2, 5.0, Field::kAMax},      {p.psc_jerk_xy_m_s3, 20.0, Field::kJHorizontal},
      {p.psc_jerk_z_m_s3, 50.0, Field::kJMax}};
  const Status status = judge(all, field);
  if (status != Status::kOk) return status;
  const double jerk = kArdupilotJerkShare * p.psc_jerk_xy_m_s3;
  limits = Limits{};
  limits.v_max = {p.wpnav_speed_m_s, p.wpnav_speed_m_s, p.wpnav_speed_up_m_s};
  limits.v_min = {-p.wpnav_speed_m_s, -p.wpnav_speed_m_s, -p.wpnav_speed_dn_m_s};
  limits.v_horizontal = p.wpnav_speed_m_s;
  limits.a_max = {p.wpnav_accel_m_s2, p.wpnav_accel_m_s2, p.wpnav_accel_z_m_s2};
  limits.a_min = {-p.wpnav_accel_m_s2, -p.wpnav_accel_m_s2, -p.wpnav_accel_z_m_s2};
  limits.a_horizontal = p.wpnav_accel_m_s2;
  limits.j_max = {jerk, jerk, kArdupilotJerkShare * p.psc_jerk_z_m_s3};
  limits.j_horizontal = jerk;
  return status;
}

}  // namespace tern
