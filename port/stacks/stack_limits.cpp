// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "tern/flatness.hpp"
#include "tern_stacks/stacks.hpp"
#include "yaw/angle.hpp"

namespace tern {
namespace {

/// The least that any parameter may be, in metres and seconds.
constexpr double kLeast = 0.01;
constexpr double kRadians = kPi / 180.0;
/// A Crazyflie's full thrust.
constexpr double kFullThrust = 65535.0;

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

/// The hover is between the least and the largest thrust.
Status judge_thrusts(double least, double hover, double most, Field* field) {
  const Parameter thrusts[] = {{hover, 0.98 * most, Field::kThrustMax}, {least, 0.98 * hover, Field::kThrustMin}};
  return judge(thrusts, field);
}

double tangent(double degrees) {
  const Heading tilt = heading_of(kRadians * degrees);
  return tilt.sine / tilt.cosine;
}

/// A parameter of which 0 is no limit, as one that may be judged.
double given(double value) {
  return value < 0.0 || value > 0.0 || !finite(value) ? value : kLeast;
}

/// The limit on roll and pitch together: 0 is none.
double rate_of(double roll, double pitch) {
  const double degrees = roll > 0.0 && pitch > 0.0 ? smaller(roll, pitch) : larger(roll, pitch);
  return kRadians * degrees;
}

}  // namespace

Px4Limits px4_limits() noexcept {
  return {12.0, 3.0, 1.5, 3.0, 4.0, 3.0, 4.0, 45.0, 0.5, 0.12, 1.0, 220.0, 220.0};
}

ArdupilotLimits ardupilot_limits() noexcept {
  return {10.0, 2.5, 1.5, 2.5, 1.0, 5.0, 5.0, 30.0, 0.35, 0.0, 0.0};
}

CrazyflieLimits crazyflie_limits() noexcept {
  return {1.0, 1.0, 1.0, 20.0, 20.0, 36000.0, 20000.0};
}

Status limits_from_px4(const Px4Limits& p, Limits& limits, Field* field) noexcept {
  const Parameter all[] = {
      {p.mpc_xy_vel_max, 20.0, Field::kVHorizontal}, {p.mpc_z_vel_max_up, 8.0, Field::kVMax},
      {p.mpc_z_vel_max_dn, 4.0, Field::kVMin},       {p.mpc_acc_hor, 15.0, Field::kAHorizontal},
      {p.mpc_acc_up_max, 15.0, Field::kAMax},        {p.mpc_acc_down_max, 15.0, Field::kAMin},
      {p.mpc_jerk_auto, 80.0, Field::kJMax},         {p.mpc_tiltmax_air, 89.0, Field::kTiltTangent},
      {p.mpc_thr_hover, 0.8, Field::kThrustMax},     {p.mpc_thr_max, 1.0, Field::kThrustMax},
      {p.mpc_thr_min, 0.5, Field::kThrustMin},       {p.mc_rollrate_max, 1800.0, Field::kRateMax},
      {p.mc_pitchrate_max, 1800.0, Field::kRateMax}};
  Status status = judge(all, field);
  if (status == Status::kOk) status = judge_thrusts(p.mpc_thr_min, p.mpc_thr_hover, p.mpc_thr_max, field);
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
  limits.tilt_tangent = tangent(p.mpc_tiltmax_air);
  limits.thrust_max = kGravity * p.mpc_thr_max / p.mpc_thr_hover;
  limits.thrust_min = kGravity * p.mpc_thr_min / p.mpc_thr_hover;
  limits.rate_max = rate_of(p.mc_rollrate_max, p.mc_pitchrate_max);
  return status;
}

Status limits_from_ardupilot(const ArdupilotLimits& p, Limits& limits, Field* field) noexcept {
  // In centimetres, the least that ArduPilot's documentation allows is 10 for speeds and 50 for accelerations.
  const Parameter all[] = {{p.wpnav_speed_m_s, 20.0, Field::kVHorizontal},
                           {p.wpnav_speed_up_m_s, 10.0, Field::kVMax},
                           {p.wpnav_speed_dn_m_s, 5.0, Field::kVMin},
                           {p.wpnav_accel_m_s2, 5.0, Field::kAHorizontal},
                           {p.wpnav_accel_z_m_s2, 5.0, Field::kAMax},
                           {p.psc_jerk_xy_m_s3, 20.0, Field::kJHorizontal},
                           {p.psc_jerk_z_m_s3, 50.0, Field::kJMax},
                           {p.angle_max_deg, 80.0, Field::kTiltTangent},
                           {p.mot_thst_hover, 0.6875, Field::kThrustMax},
                           {given(p.atc_rate_r_max_deg), 1080.0, Field::kRateMax},
                           {given(p.atc_rate_p_max_deg), 1080.0, Field::kRateMax}};
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
  limits.tilt_tangent = tangent(p.angle_max_deg);
  limits.thrust_max = kGravity / p.mot_thst_hover;
  limits.thrust_min = kGravity - p.wpnav_accel_z_m_s2;
  limits.rate_max = rate_of(p.atc_rate_r_max_deg, p.atc_rate_p_max_deg);
  return status;
}

Status limits_from_crazyflie(const CrazyflieLimits& p, Limits& limits, Field* field) noexcept {
  // The firmware names no ranges; a Crazyflie reaches none of these.
  const double hover = p.thrust_base / kFullThrust;
  const double least = p.thrust_min / kFullThrust;
  const Parameter all[] = {{p.x_vel_max, 10.0, Field::kVHorizontal}, {p.y_vel_max, 10.0, Field::kVHorizontal},
                           {p.z_vel_max, 10.0, Field::kVMax},        {p.r_limit, 80.0, Field::kTiltTangent},
                           {p.p_limit, 80.0, Field::kTiltTangent},   {hover, 1.0, Field::kThrustMax},
                           {least, 1.0, Field::kThrustMin}};
  Status status = judge(all, field);
  if (status == Status::kOk) status = judge_thrusts(least, hover, 1.0, field);
  if (status != Status::kOk) return status;
  const double speed = smaller(p.x_vel_max, p.y_vel_max);
  limits = Limits{};
  limits.v_max = {speed, speed, p.z_vel_max};
  limits.v_horizontal = speed;
  limits.tilt_tangent = tangent(smaller(p.r_limit, p.p_limit));
  limits.thrust_max = kGravity / hover;
  limits.thrust_min = kGravity * least / hover;
  // A box around all that thrust and tilt allow.
  limits.a_max = {limits.thrust_max, limits.thrust_max, limits.thrust_max - kGravity};
  limits.a_min.z = limits.thrust_min - kGravity;
  return status;
}

}  // namespace tern
