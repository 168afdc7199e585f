// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/vehicle/ardupilot_cascade.hpp"

#include <algorithm>
#include <cmath>

#include "host/vehicle/square_root.hpp"
#include "tern/flatness.hpp"

namespace tern_host {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector2d;
using Eigen::Vector3d;

// ArduPilot's defaults; in brackets the parameters' names.
namespace ap {

constexpr double kLoop = 0.0025;                    // [SCHED_LOOP_RATE] 400 Hz
constexpr double kPositionP = 1.0;                  // [PSC_POSXY_P, PSC_POSZ_P]
constexpr double kVelocityP = 2.0;                  // [PSC_VELXY_P]
constexpr double kVelocityI = 1.0;                  // [PSC_VELXY_I]
constexpr double kVelocityD = 0.25;                 // [PSC_VELXY_D]
constexpr double kVelocityCutoff = 5.0;             // [PSC_VELXY_FLTE, PSC_VELXY_FLTD, PSC_VELZ_FLTE] Hz
constexpr double kMostIntegral = 10.0;              // [PSC_VELXY_IMAX] m/s^2
constexpr double kClimbP = 5.0;                     // [PSC_VELZ_P]
constexpr double kMostLean = 0.523598775598298873;  // [ANGLE_MAX] 30 degrees

// Of the throttle, 0 to 1, for each m/s^2; half of it carries the weight, which these gains assume.
constexpr double kHover = 0.5;
constexpr double kThrottleP = 0.05;            // [PSC_ACCZ_P]
constexpr double kThrottleI = 0.1;             // [PSC_ACCZ_I]
constexpr double kMostThrottleIntegral = 0.8;  // [PSC_ACCZ_IMAX]
constexpr double kEffortCutoff = 20.0;         // [PSC_ACCZ_FLTE] Hz
constexpr double kThrottleCutoff = 2.0;        // Hz, of the throttle while the height is held

constexpr double kAttitudeP = 4.5;          // [ATC_ANG_RLL_P, _PIT_P, _YAW_P]
constexpr double kInputTime = 0.15;         // [ATC_INPUT_TC] s
const Vector3d kTurning(19.2, 19.2, 4.71);  // [ATC_ACCEL_R_MAX, _P_MAX, _Y_MAX] rad/s^2

// [ATC_RAT_RLL_P, _I, _D, _IMAX, _FLTD, _FLTT and those of pitch and yaw]
const RateGains kRates{Vector3d(0.135, 0.135, 0.18),
                       Vector3d(0.135, 0.135, 0.018),
                       Vector3d(0.0036, 0.0036, 0.0),
                       Vector3d::Constant(0.5),
                       20.0,
                       20.0};

}  // namespace ap

/// The turn as a rotation vector.
Vector3d rotation_vector(Quaterniond q) {
  if (q.w() < 0.0) q.coeffs() *= -1.0;
  const double sine = q.vec().norm();
  return sine < 1e-12 ? Vector3d(2.0 * q.vec()) : Vector3d(2.0 * std::atan2(sine, q.w()) / sine * q.vec());
}

Quaterniond turned_by(const Vector3d& rotation) {
  const double angle = rotation.norm();
  return angle < 1e-12 ? Quaterniond::Identity() : Quaterniond(Eigen::AngleAxisd(angle, rotation / angle));
}

/// From one attitude to another, in the first one's frame: the turn of the thrust as x and y, that of the heading as z.
Vector3d error_of(const Quaterniond& from, const Quaterniond& to) {
  const Quaterniond tilt = Quaterniond::FromTwoVectors(Vector3d::UnitZ(), from.conjugate() * (to * Vector3d::UnitZ()));
  const Quaterniond heading = tilt.conjugate() * from.conjugate() * to;
  return {rotation_vector(tilt).x(), rotation_vector(tilt).y(), rotation_vector(heading).z()};
}

}  // namespace

Vector2d ardupilot_limited_lean(const Vector2d& wanted, const Vector2d& velocity) {
  const double most = tern::kGravity * std::tan(ap::kMostLean);
  if (wanted.norm() <= most) return wanted;
  if (!(velocity.norm() > 0.0)) return no_longer(wanted, most);
  const Vector2d ahead = velocity.normalized();
  const Vector2d across = no_longer(wanted - ahead * ahead.dot(wanted), most);
  const double left = std::sqrt(std::max(0.0, most * most - across.squaredNorm()));
  return across + ahead * std::clamp(ahead.dot(wanted), -left, left);
}

ArdupilotCascade::ArdupilotCascade(const Setpoint& start, double begin, double tick, double speed)
    : tick_(tick),
      speed_(speed),
      next_message_(begin),
      next_loop_(begin),
      yaw_(start.yaw),
      target_(to_eigen(start.sample.position), speed),
      throttle_(ap::kHover),
      attitude_(attitude_of(Vector3d::UnitZ(), start.yaw)),
      rates_(ap::kRates) {}

/// Position P and velocity PID. The integral does not grow where the lean is at its limit.
void ArdupilotCascade::control_level(const Believed& state) {
  const Motion& desired = target_.desired();
  const double most = square_root_error(speed_, ap::kPositionP, kArdupilotAcceleration);
  const Vector2d off = no_longer((desired.position - state.position).head<2>(), most);
  target_.pull_to({state.position.x() + off.x(), state.position.y() + off.y(), desired.position.z()});
  const Vector2d correction = square_root(off, ap::kPositionP, kArdupilotAcceleration, ap::kLoop);
  const Vector2d before = lagging_.velocity.head<2>();
  const Vector2d slow = correction + (desired.velocity - state.velocity).head<2>();
  const Vector2d filtered = before + new_part(ap::kVelocityCutoff, ap::kLoop) * (slow - before);
  slope_ += new_part(ap::kVelocityCutoff, ap::kLoop) * ((filtered - before) / ap::kLoop - slope_);
  const Vector2d grown = integral_ + ap::kLoop * ap::kVelocityI * filtered;
  const bool into_limit = filtered.dot(lagging_.limit.head<2>()) > 0.0;
  integral_ = no_longer(grown, into_limit ? std::min(integral_.norm(), ap::kMostIntegral) : ap::kMostIntegral);
  const Vector2d wanted =
      ap::kVelocityP * filtered + integral_ + ap::kVelocityD * slope_ + desired.acceleration.head<2>();
  lean_ = ardupilot_limited_lean(wanted, desired.velocity.head<2>());
  lagging_.limit.head<2>() = lean_ == wanted ? Vector2d(Vector2d::Zero()) : wanted;
  lagging_.position.head<2>() = off;
  lagging_.velocity.head<2>() = filtered;
}

/// Position P, velocity P, and a PI from the acceleration to the throttle.
void ArdupilotCascade::control_upright(const Believed& state) {
  const Motion& desired = target_.desired();
  const double off = std::clamp(desired.position.z() - state.position.z(),
                                -square_root_error(kArdupilotDown, ap::kPositionP, kArdupilotAccelerationZ),
                                square_root_error(kArdupilotUp, ap::kPositionP, kArdupilotAccelerationZ));
  target_.pull_to({desired.position.x(), desired.position.y(), state.position.z() + off});
  const double slow =
      square_root(off, ap::kPositionP, kArdupilotAccelerationZ, ap::kLoop) + desired.velocity.z() - state.velocity.z();
  climb_off_ += new_part(ap::kVelocityCutoff, ap::kLoop) * (slow - climb_off_);
  const double climbing = (state.velocity.z() - last_climb_) / ap::kLoop;
  last_climb_ = state.velocity.z();
  const double effort = ap::kClimbP * climb_off_ + desired.acceleration.z() - climbing;
  effort_off_ += new_part(ap::kEffortCutoff, ap::kLoop) * (effort - effort_off_);
  const double integral = throttle_integral_ + ap::kLoop * ap::kThrottleI * effort_off_;
  const bool grows = std::fabs(integral) > std::fabs(throttle_integral_);
  if (lagging_.limit.z() == 0.0 || !grows) {
    throttle_integral_ = std::clamp(integral, -ap::kMostThrottleIntegral, ap::kMostThrottleIntegral);
  }
  const double asked = ap::kHover + ap::kThrottleP * effort_off_ + throttle_integral_;
  // What the lean takes from the lift is made up for.
  const double boosted = asked * std::sqrt(1.0 + lean_.squaredNorm() / (tern::kGravity * tern::kGravity));
  throttle_ += new_part(ap::kThrottleCutoff, ap::kLoop) * (std::clamp(boosted, 0.0, 1.0) - throttle_);
  lagging_.limit.z() = boosted >= 1.0 ? 1.0 : (boosted <= 0.0 ? -1.0 : 0.0);
  lagging_.position.z() = off;
  lagging_.velocity.z() = climb_off_;
}

/// The target attitude goes to the wanted one over ATC_INPUT_TC, and its rates are fed forward.
void ArdupilotCascade::control_attitude(const Believed& state) {
  attitude_ = (attitude_ * turned_by(ap::kLoop * turning_)).normalized();
  const Quaterniond wanted = attitude_of(Vector3d(lean_.x(), lean_.y(), tern::kGravity).normalized(), yaw_);
  const Vector3d ahead = error_of(attitude_, wanted);
  const Vector3d back = error_of(state.attitude, attitude_);
  const Vector3d spin = (state.attitude.conjugate() * attitude_) * turning_;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double fed = axis == 2 ? yaw_rate_ : 0.0;
    const double rate = fed + square_root(ahead[axis], 1.0 / ap::kInputTime, ap::kTurning[axis], ap::kLoop);
    turning_[axis] +=
        std::clamp(rate - turning_[axis], -ap::kTurning[axis] * ap::kLoop, ap::kTurning[axis] * ap::kLoop);
    wanted_rates_[axis] = spin[axis] + square_root(back[axis], ap::kAttitudeP, 0.5 * ap::kTurning[axis], ap::kLoop);
  }
}

void ArdupilotCascade::run(const Believed& state) {
  target_.advance(ap::kLoop, lagging_);
  control_level(state);
  control_upright(state);
  control_attitude(state);
}

Wrench ArdupilotCascade::control(const Believed& state, double t, double step, const Setpoints& setpoints) {
  constexpr double kEarly = 1e-9;
  if (t >= next_message_ - kEarly) {
    const Setpoint message = setpoints(next_message_);
    target_.take(message.sample);
    yaw_ = message.yaw;
    yaw_rate_ = message.yaw_rate;
    next_message_ += tick_;
  }
  if (t >= next_loop_ - kEarly) {
    next_loop_ += ap::kLoop;
    run(state);
  }
  return {Body::kMass * tern::kGravity * throttle_ / ap::kHover, rates_.torque(wanted_rates_, state.body_rates, step)};
}

}  // namespace tern_host
