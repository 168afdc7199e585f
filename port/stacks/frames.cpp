// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "tern_stacks/stacks.hpp"
#include "yaw/angle.hpp"

namespace tern {
namespace {

void assign(float (&out)[3], const Vec3& enu) {
  const Vec3 ned = ned_from_enu(enu);
  out[0] = static_cast<float>(ned.x);
  out[1] = static_cast<float>(ned.y);
  out[2] = static_cast<float>(ned.z);
}

}  // namespace

Vec3 ned_from_enu(const Vec3& v) noexcept {
  return {v.y, v.x, -v.z};
}

/// q_ned = (0, s, s, 0) q_enu (0, 1, 0, 0) with s = sqrt(1/2), multiplied out.
void attitude_ned(const double enu[4], double ned[4]) noexcept {
  const double s = square_root(0.5);
  const double w = enu[0];
  const double x = enu[1];
  const double y = enu[2];
  const double z = enu[3];
  const double q[4] = {-s * (w + z), -s * (x + y), s * (y - x), s * (z - w)};
  const double sign = q[0] < 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < 4; ++i) ned[i] = sign * q[i];
}

SetpointNed setpoint_ned(const Sample& sample, const Vec3& origin) noexcept {
  SetpointNed setpoint;
  assign(setpoint.position, sample.position - origin);
  assign(setpoint.velocity, sample.velocity);
  assign(setpoint.acceleration, sample.acceleration);
  assign(setpoint.jerk, sample.jerk);
  setpoint.yaw = setpoint.yaw_rate = __builtin_nanf("");
  return setpoint;
}

SetpointNed setpoint_ned(const Sample& sample, const YawSample& yaw, const Vec3& origin) noexcept {
  SetpointNed setpoint = setpoint_ned(sample, origin);
  // North is a quarter turn from east, and angles count clockwise.
  setpoint.yaw = static_cast<float>(angle_of({yaw.yaw.sine, yaw.yaw.cosine}));
  setpoint.yaw_rate = static_cast<float>(-yaw.yaw.rate);
  return setpoint;
}

}  // namespace tern
