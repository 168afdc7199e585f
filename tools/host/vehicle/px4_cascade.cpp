// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/vehicle/px4_cascade.hpp"

#include <algorithm>
#include <cmath>

#include "tern/flatness.hpp"

namespace tern_host {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;

// PX4's defaults; in brackets the parameters' names.
const Vector3d kPositionP(0.95, 0.95, 1.0);      // [MPC_XY_P, MPC_Z_P]
const Vector3d kVelocityP(1.8, 1.8, 4.0);        // [MPC_XY_VEL_P_ACC, MPC_Z_VEL_P_ACC]
const Vector3d kVelocityI(0.4, 0.4, 2.0);        // [.._VEL_I_ACC]
const Vector3d kVelocityD(0.2, 0.2, 0.0);        // [.._VEL_D_ACC]
constexpr double kMostUp = 3.0;                  // [MPC_Z_VEL_MAX_UP] m/s
constexpr double kMostDown = 1.5;                // [MPC_Z_VEL_MAX_DN]
constexpr double kMostTilt = 0.785398163397448;  // [MPC_TILTMAX_AIR] 45 degrees
constexpr double kVelocityCutoff = 5.0;          // [MPC_VELD_LP] Hz
const Vector3d kAttitudeP(6.5, 6.5, 2.8);        // [MC_ROLL_P, MC_PITCH_P, MC_YAW_P]
constexpr double kYawWeight = 0.4;               // [MC_YAW_WEIGHT]
const Vector3d kMostRates(3.84, 3.84, 3.49);     // [MC_ROLLRATE_MAX 220, MC_YAWRATE_MAX 200] rad/s
constexpr double kPositionPeriod = 0.01;         // with the estimator, 100 Hz
constexpr double kAttitudePeriod = 0.004;        // 250 Hz

// Thrusts are shares of the weight, which a thrust of [MPC_THR_HOVER] 0.5 carries.
constexpr double kPx4LeastThrust = 0.12 / 0.5 * tern::kGravity;  // [MPC_THR_MIN]
constexpr double kPx4MostThrust = 1.0 / 0.5 * tern::kGravity;    // [MPC_THR_MAX]
constexpr double kSideways = 0.3 / 0.5 * tern::kGravity;         // [MPC_THR_XY_MARG]

// [MC_ROLLRATE_P, _I, _D and those of pitch and yaw, MC_RR_INT_LIM, IMU_DGYRO_CUTOFF]
const RateGains kPx4Rates{Vector3d(0.15, 0.15, 0.2),
                          Vector3d(0.2, 0.2, 0.1),
                          Vector3d(0.003, 0.003, 0.0),
                          Vector3d::Constant(0.3),
                          30.0,
                          0.0};

/// The horizontal velocity to follow. Where correction and commanded velocity together are more than the limit, PX4
/// keeps the correction, and as much of the commanded velocity as there is room for.
Vector2d limit_horizontal(const Vector2d& commanded, const Vector2d& correction, double most) {
  constexpr double kNothing = 1e-3;
  if ((commanded + correction).norm() <= most) return commanded + correction;
  if (correction.norm() >= most || commanded.norm() < kNothing) return most * correction.normalized();
  const Vector2d along = commanded.normalized();
  const double ahead = along.dot(correction);
  return correction + along * (std::sqrt(ahead * ahead + most * most - correction.squaredNorm()) - ahead);
}

Vector3d limit_velocity(const Vector3d& commanded, const Vector3d& correction, double most_horizontal) {
  Vector3d velocity;
  velocity.head<2>() = limit_horizontal(commanded.head<2>(), correction.head<2>(), most_horizontal);
  velocity.z() = std::clamp(commanded.z() + correction.z(), -kMostDown, kMostUp);
  return velocity;
}

}  // namespace

Vector3d px4_asked_thrust(const Vector3d& wanted) {
  // MPC_ACC_DECOUPLE: the tilt assumes that the thrust carries the weight and nothing more.
  Vector3d up(wanted.x(), wanted.y(), tern::kGravity);
  up.head<2>() = no_longer(up.head<2>(), tern::kGravity * std::tan(kMostTilt));
  up.normalize();
  return std::max(kPx4LeastThrust, (wanted.z() + tern::kGravity) / up.z()) * up;
}

Vector3d px4_limited_thrust(const Vector3d& thrust) {
  constexpr double kSquare = kPx4MostThrust * kPx4MostThrust;
  const double kept = std::min(thrust.head<2>().norm(), kSideways);
  Vector3d limited = thrust;
  limited.z() = std::min(thrust.z(), std::sqrt(kSquare - kept * kept));
  limited.head<2>() = no_longer(thrust.head<2>(), std::sqrt(std::max(0.0, kSquare - limited.z() * limited.z())));
  return limited;
}

Px4Cascade::Px4Cascade(double begin, double tick, double speed_max)
    : tick_(tick),
      speed_max_(speed_max),
      next_setpoint_(begin),
      next_position_(begin),
      next_attitude_(begin),
      rates_(kPx4Rates) {}

/// PX4's anti-windup: upright, nothing is added where the thrust is at its limit. Sideways, what the thrust gives short
/// of `wanted` is taken back. That is also where it sinks: the tilt of MPC_ACC_DECOUPLE then gives less.
void Px4Cascade::integrate(Vector3d off, const Vector3d& wanted, double dt) {
  const Vector3d asked = px4_asked_thrust(wanted);
  const Vector3d given = px4_limited_thrust(asked);
  const bool is_low = asked.z() <= kPx4LeastThrust && off.z() <= 0.0;
  const bool is_high = asked.z() >= kPx4MostThrust && off.z() >= 0.0;
  if (is_low || is_high) off.z() = 0.0;
  const Vector2d short_of = (wanted - given).head<2>();
  if (wanted.head<2>().norm() > given.head<2>().norm()) off.head<2>() -= 2.0 / kVelocityP.x() * short_of;
  velocity_integral_ += dt * kVelocityI.cwiseProduct(off);
  velocity_integral_.z() = std::clamp(velocity_integral_.z(), -tern::kGravity, tern::kGravity);
}

void Px4Cascade::control_position(const Believed& state, double dt) {
  const Vector3d change = (state.velocity - last_velocity_) / dt;
  acceleration_ += new_part(kVelocityCutoff, dt) * (change - acceleration_);
  last_velocity_ = state.velocity;
  const Vector3d correction = kPositionP.cwiseProduct(to_eigen(setpoint_.sample.position) - state.position);
  const Vector3d off = limit_velocity(to_eigen(setpoint_.sample.velocity), correction, speed_max_) - state.velocity;
  const Vector3d wanted = to_eigen(setpoint_.sample.acceleration) + kVelocityP.cwiseProduct(off) + velocity_integral_ -
                          kVelocityD.cwiseProduct(acceleration_);
  const Vector3d thrust = px4_limited_thrust(px4_asked_thrust(wanted));
  integrate(off, wanted, dt);
  wanted_ = attitude_of(thrust.normalized(), setpoint_.yaw);
  thrust_ = Body::kMass * thrust.norm();
}

/// PX4's attitude control: the thrust's direction first, yaw with less weight.
void Px4Cascade::control_attitude(const Believed& state) {
  const Quaterniond& q = state.attitude;
  const Quaterniond reduced = Quaterniond::FromTwoVectors(q * Vector3d::UnitZ(), wanted_ * Vector3d::UnitZ()) * q;
  Quaterniond mix = reduced.conjugate() * wanted_;
  if (mix.w() < 0.0) mix.coeffs() *= -1.0;
  const double w = std::cos(kYawWeight * std::acos(std::clamp(mix.w(), -1.0, 1.0)));
  const double z = std::sin(kYawWeight * std::asin(std::clamp(mix.z(), -1.0, 1.0)));
  Quaterniond off = q.conjugate() * (reduced * Quaterniond(w, 0.0, 0.0, z));
  if (off.w() < 0.0) off.coeffs() *= -1.0;
  Vector3d gain = kAttitudeP;
  gain.z() /= kYawWeight;
  wanted_rates_ = 2.0 * gain.cwiseProduct(off.vec());
  wanted_rates_ += q.conjugate() * Vector3d(0.0, 0.0, setpoint_.yaw_rate);
  wanted_rates_ = within(wanted_rates_, kMostRates);
}

Wrench Px4Cascade::control(const Believed& state, double t, double step, const Setpoints& setpoints) {
  constexpr double kEarly = 1e-9;
  if (t >= next_setpoint_ - kEarly) {
    setpoint_ = setpoints(next_setpoint_);
    next_setpoint_ += tick_;
  }
  if (t >= next_position_ - kEarly) {
    next_position_ += kPositionPeriod;
    control_position(state, kPositionPeriod);
  }
  if (t >= next_attitude_ - kEarly) {
    next_attitude_ += kAttitudePeriod;
    control_attitude(state);
  }
  return {thrust_, rates_.torque(wanted_rates_, state.body_rates, step)};
}

}  // namespace tern_host
