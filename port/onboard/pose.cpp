// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/pose.hpp"

#include <algorithm>
#include <cmath>

namespace tern_onboard {
namespace {

double dot(const double (&a)[4], const double (&b)[4]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

}  // namespace

tern::Vec3 minus(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

tern::Vec3 plus(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

tern::Vec3 times(const tern::Vec3& a, double k) {
  return {a.x * k, a.y * k, a.z * k};
}

double length(const tern::Vec3& a) {
  return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z);
}

bool is_finite(const tern::Vec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

tern::Vec3 turn(const double (&q)[4], const tern::Vec3& v) {
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  return {(1.0 - 2.0 * (y * y + z * z)) * v.x + 2.0 * (x * y - w * z) * v.y + 2.0 * (x * z + w * y) * v.z,
          2.0 * (x * y + w * z) * v.x + (1.0 - 2.0 * (x * x + z * z)) * v.y + 2.0 * (y * z - w * x) * v.z,
          2.0 * (x * z - w * y) * v.x + 2.0 * (y * z + w * x) * v.y + (1.0 - 2.0 * (x * x + y * y)) * v.z};
}

tern::Pose compose(const tern::Pose& outer, const tern::Pose& inner) {
  const double(&a)[4] = outer.quaternion;
  const double(&b)[4] = inner.quaternion;
  return {
      plus(outer.position, turn(a, inner.position)),
      {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
       a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]}};
}

tern::Pose between(const tern::Pose& a, const tern::Pose& b, double share) {
  tern::Pose pose{plus(a.position, times(minus(b.position, a.position), share)), {}};
  const double cosine = dot(a.quaternion, b.quaternion);
  const double side = cosine < 0.0 ? -1.0 : 1.0;  // q and -q are the same attitude
  const double angle = std::acos(std::min(1.0, side * cosine));
  // Nearly the same attitude: the sine is too small to divide by, and a straight line is the same.
  const double sine = std::sin(angle);
  const double from = sine < 1e-6 ? 1.0 - share : std::sin((1.0 - share) * angle) / sine;
  const double to = sine < 1e-6 ? share : std::sin(share * angle) / sine;
  for (int k = 0; k < 4; ++k) pose.quaternion[k] = from * a.quaternion[k] + side * to * b.quaternion[k];
  make_unit(pose.quaternion);
  return pose;
}

double angle_between(const double (&a)[4], const double (&b)[4]) {
  return 2.0 * std::acos(std::min(1.0, std::abs(dot(a, b))));
}

double heading_of(const double (&q)[4]) {
  return std::atan2(2.0 * (q[0] * q[3] + q[1] * q[2]), 1.0 - 2.0 * (q[2] * q[2] + q[3] * q[3]));
}

bool make_unit(double (&q)[4]) {
  constexpr double kTolerance = 0.01;
  const double norm = std::sqrt(dot(q, q));
  if (!(std::abs(norm - 1.0) <= kTolerance)) return false;
  for (double& number : q) number /= norm;
  return true;
}

}  // namespace tern_onboard
