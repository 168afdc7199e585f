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
const Vector3d kRatesP(0.15, 0.15, 0.2);         // [MC_ROLLRATE_P, MC_YAWRATE_P]
const Vector3d kRatesI(0.2, 0.2, 0.1);
const Vector3d kRatesD(0.003, 0.003, 0.0);
constexpr double kMostRatesIntegral = 0.3;  // [MC_RR_INT_LIM]
constexpr double kRatesCutoff = 30.0;       // [IMU_DGYRO_CUTOFF] Hz
constexpr double kAttitudePeriod = 0.004;   // 250 Hz

/// What a full output of the rate loop accelerates the body with, rad/s^2. PX4's outputs have no unit; this is the body
/// that its gains fit.
const Vector3d kFullOutput(130.0, 130.0, 25.0);

constexpr double kPi = 3.14159265358979323846;

/// The part of a new value in a low pass of the first order.
double new_part(double cutoff, double dt) {
  return dt / (dt + 1.0 / (2.0 * kPi * cutoff));
}

Vector3d within(const Vector3d& v, const Vector3d& most) {
  return v.cwiseMax(-most).cwiseMin(most);
}

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

/// The attitude whose z is `up` and whose nose points along yaw.
Quaterniond attitude_of(const Vector3d& up, double yaw) {
  const Vector3d left = up.cross(Vector3d(std::cos(yaw), std::sin(yaw), 0.0)).normalized();
  Eigen::Matrix3d r;
  r << left.cross(up), left, up;
  return Quaterniond(r);
}

}  // namespace

void Px4Cascade::control_position(const Believed& state, double dt) {
  const Vector3d change = (state.velocity - last_velocity_) / dt;
  acceleration_ += new_part(kVelocityCutoff, dt) * (change - acceleration_);
  last_velocity_ = state.velocity;
  const Vector3d correction = kPositionP.cwiseProduct(to_eigen(setpoint_.sample.position) - state.position);
  const Vector3d off = limit_velocity(to_eigen(setpoint_.sample.velocity), correction, speed_max_) - state.velocity;
  const Vector3d wanted = to_eigen(setpoint_.sample.acceleration) + kVelocityP.cwiseProduct(off) + velocity_integral_ -
                          kVelocityD.cwiseProduct(acceleration_);
  velocity_integral_ += dt * kVelocityI.cwiseProduct(off);
  velocity_integral_.z() = std::clamp(velocity_integral_.z(), -tern::kGravity, tern::kGravity);
  // MPC_ACC_DECOUPLE: the tilt assumes that the thrust carries the weight and nothing more.
  Vector3d up(wanted.x(), wanted.y(), tern::kGravity);
  const double most = tern::kGravity * std::tan(kMostTilt);
  const double level = up.head<2>().norm();
  if (level > most) up.head<2>() *= most / level;
  up.normalize();
  wanted_ = attitude_of(up, setpoint_.yaw);
  thrust_ = std::max(0.0, Body::kMass * (wanted.z() + tern::kGravity) / up.z());
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

Vector3d Px4Cascade::control_rates(const Believed& state, double dt) {
  const Vector3d change = (state.body_rates - last_rates_) / dt;
  angular_ += new_part(kRatesCutoff, dt) * (change - angular_);
  last_rates_ = state.body_rates;
  const Vector3d off = wanted_rates_ - state.body_rates;
  const Vector3d output = kRatesP.cwiseProduct(off) + rates_integral_ - kRatesD.cwiseProduct(angular_);
  rates_integral_ = within(rates_integral_ + dt * kRatesI.cwiseProduct(off), Vector3d::Constant(kMostRatesIntegral));
  return within(output, Vector3d::Ones()).cwiseProduct(kFullOutput);
}

Wrench Px4Cascade::control(const Believed& state, double t, double step, const Setpoints& setpoints) {
  constexpr double kEarly = 1e-9;
  if (t >= next_setpoint_ - kEarly) {
    setpoint_ = setpoints(next_setpoint_);
    next_setpoint_ += tick_;
    control_position(state, tick_);
  }
  if (t >= next_attitude_ - kEarly) {
    next_attitude_ += kAttitudePeriod;
    control_attitude(state);
  }
  return {thrust_, Body::inertia().cwiseProduct(control_rates(state, step))};
}

}  // namespace tern_host
