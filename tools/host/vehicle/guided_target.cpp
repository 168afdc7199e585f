// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/vehicle/guided_target.hpp"

#include <algorithm>

#include "host/vehicle/rate_loop.hpp"
#include "host/vehicle/rigid_body.hpp"
#include "host/vehicle/square_root.hpp"

namespace tern_host {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kArdupilotJerk = 5.0;  // PSC_JERK_XY and PSC_JERK_Z, m/s^3

/// `step`, or 0 where it leads on into the limit and away from the body.
template <typename V>
V unless_limited(const V& step, const V& limit, const V& off) {
  return step.dot(limit) > 0.0 && off.dot(limit) > 0.0 ? V(V::Zero()) : step;
}

}  // namespace

GuidedTarget::GuidedTarget(const Vector3d& position, double speed) : speed_(speed) {
  message_.position = position;
  desired_.position = position;
}

void GuidedTarget::take(const tern::Sample& message) {
  message_ = {to_eigen(message.position), to_eigen(message.velocity), to_eigen(message.acceleration)};
}

void GuidedTarget::advance(double dt, const Lagging& lagging) {
  move(dt, lagging);
  shape_level(dt);
  shape_upright(dt);
  message_.position += dt * message_.velocity + 0.5 * dt * dt * message_.acceleration;
  message_.velocity += dt * message_.acceleration;
}

void GuidedTarget::move(double dt, const Lagging& lagging) {
  const Vector3d way = dt * desired_.velocity + 0.5 * dt * dt * desired_.acceleration;
  const Vector3d change = dt * desired_.acceleration;
  const Vector2d level = lagging.limit.head<2>();
  const bool brakes = desired_.velocity.head<2>().dot(level) < 0.0;
  desired_.position.head<2>() += unless_limited<Vector2d>(way.head<2>(), level, lagging.position.head<2>());
  desired_.velocity.head<2>() += brakes ? Vector2d(change.head<2>())
                                        : unless_limited<Vector2d>(change.head<2>(), level, lagging.velocity.head<2>());
  using Upright = Eigen::Matrix<double, 1, 1>;
  desired_.position.tail<1>() +=
      unless_limited<Upright>(way.tail<1>(), lagging.limit.tail<1>(), lagging.position.tail<1>());
  desired_.velocity.tail<1>() +=
      unless_limited<Upright>(change.tail<1>(), lagging.limit.tail<1>(), lagging.velocity.tail<1>());
}

void GuidedTarget::shape_level(double dt) {
  constexpr double kGain = kArdupilotJerk / kArdupilotAcceleration;
  const Vector2d off = (message_.position - desired_.position).head<2>();
  const Vector2d correction = no_longer(square_root(off, kGain, kArdupilotAcceleration, dt), speed_);
  const Vector2d slow = message_.velocity.head<2>() + correction - desired_.velocity.head<2>();
  const Vector2d wanted =
      message_.acceleration.head<2>() + no_longer(square_root(slow, kGain, kArdupilotJerk, dt), kArdupilotAcceleration);
  desired_.acceleration.head<2>() += no_longer(wanted - desired_.acceleration.head<2>(), kArdupilotJerk * dt);
}

void GuidedTarget::shape_upright(double dt) {
  constexpr double kGain = kArdupilotJerk / kArdupilotAccelerationZ;
  const double off = message_.position.z() - desired_.position.z();
  const double correction =
      std::clamp(square_root(off, kGain, kArdupilotAccelerationZ, dt), -kArdupilotDown, kArdupilotUp);
  const double slow = message_.velocity.z() + correction - desired_.velocity.z();
  const double wanted = message_.acceleration.z() + std::clamp(square_root(slow, kGain, kArdupilotJerk, dt),
                                                               -kArdupilotAccelerationZ, kArdupilotAccelerationZ);
  desired_.acceleration.z() +=
      std::clamp(wanted - desired_.acceleration.z(), -kArdupilotJerk * dt, kArdupilotJerk * dt);
}

}  // namespace tern_host
