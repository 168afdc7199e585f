// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/flatness.hpp"

#include "base/linear.hpp"

namespace tern {
namespace {

/// Horizontal unit vectors: the direction in which the nose should point, and the direction to its left.
struct Heading {
  Vector forward;
  Vector left;
};

Heading heading_of(const Yaw& yaw) {
  const double norm = square_root(yaw.cosine * yaw.cosine + yaw.sine * yaw.sine);
  const bool usable = finite(norm) && norm > 0.0;
  const double c = usable ? yaw.cosine / norm : 1.0;
  const double s = usable ? yaw.sine / norm : 0.0;
  return {Vector(c, s, 0.0), Vector(-s, c, 0.0)};
}

/// Sets the quaternion by Shepperd's method: it divides by the largest of the four components, which is at least 1/2.
void set_quaternion(const Matrix& r, FlatState& state) {
  const double trace = r(0, 0) + r(1, 1) + r(2, 2);
  const double squares[4] = {trace, r(0, 0), r(1, 1), r(2, 2)};
  int largest = 0;
  for (int i = 1; i < 4; ++i) largest = squares[i] > squares[largest] ? i : largest;
  double q[4];
  if (largest == 0) {
    q[0] = 0.5 * square_root(1.0 + trace);
    const double scale = 0.25 / q[0];
    q[1] = scale * (r(2, 1) - r(1, 2));
    q[2] = scale * (r(0, 2) - r(2, 0));
    q[3] = scale * (r(1, 0) - r(0, 1));
  } else {
    const int i = largest - 1;
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    q[1 + i] = 0.5 * square_root(1.0 + r(i, i) - r(j, j) - r(k, k));
    const double scale = 0.25 / q[1 + i];
    q[0] = scale * (r(k, j) - r(j, k));
    q[1 + j] = scale * (r(j, i) + r(i, j));
    q[1 + k] = scale * (r(k, i) + r(i, k));
  }
  for (int i = 0; i < 4; ++i) state.quaternion[i] = q[0] < 0.0 ? -q[i] : q[i];
}

/// Sets the attitude from the body's axes in the world frame.
void set_attitude(const Vector& x, const Vector& y, const Vector& z, FlatState& state) {
  Matrix body;
  body << x, y, z;
  matrix_of(state.attitude) = body;
  set_quaternion(body, state);
}

FlatState level(const Heading& heading, double thrust, double yaw_rate, Singularity why) {
  FlatState state{};
  state.thrust = thrust;
  state.body_rates = {0.0, 0.0, yaw_rate};
  state.singularity = why;
  set_attitude(heading.forward, heading.left, Vector::UnitZ(), state);
  return state;
}

bool is_finite(const Vec3& v) {
  return finite(v.x) && finite(v.y) && finite(v.z) && finite(dot(v, v));
}

}  // namespace

FlatState flat_state(const Sample& sample, const Yaw& yaw) noexcept {
  const Heading heading = heading_of(yaw);
  if (!is_finite(sample.acceleration) || !is_finite(sample.jerk)) {
    return level(heading, kGravity, 0.0, Singularity::kNotFinite);
  }
  const double yaw_rate = finite(yaw.rate) ? yaw.rate : 0.0;
  const Vector force = to_vector(sample.acceleration) + kGravity * Vector::UnitZ();
  const double thrust = length(force);
  if (thrust < kLeastThrust) return level(heading, thrust, yaw_rate, Singularity::kFreeFall);
  const Vector z = (1.0 / thrust) * force;
  const Vector nose = cross(heading.left, z);
  const double sine = length(nose);
  const bool lost = sine < kLeastHeading;
  // If the thrust points along heading.left, it is at right angles to heading.forward. So the nose can point along
  // heading.forward, up to rounding.
  const Vector ahead = lost ? Vector(heading.forward - dot(heading.forward, z) * z) : nose;
  const Vector x = (1.0 / length(ahead)) * ahead;
  const Vector y = cross(z, x);
  // The jerk across the thrust turns the thrust's direction. The rate about the thrust follows from the heading.
  const Vector jerk = to_vector(sample.jerk);
  const Vector turn = (1.0 / thrust) * (jerk - dot(jerk, z) * z);
  FlatState state{};
  state.thrust = thrust;
  state.body_rates.x = -dot(turn, y);
  state.body_rates.y = dot(turn, x);
  const double about = yaw_rate * dot(heading.forward, x) + state.body_rates.y * dot(heading.left, z);
  state.body_rates.z = lost ? 0.0 : about / sine;
  state.singularity = lost ? Singularity::kHeading : Singularity::kNone;
  set_attitude(x, y, z, state);
  return state;
}

}  // namespace tern
