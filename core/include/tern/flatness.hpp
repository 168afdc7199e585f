// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a multirotor's controller needs of a sample: a quadrotor is differentially flat in position and yaw, so that
// thrust, attitude and body rates follow from acceleration and jerk (Mellinger and Kumar, ICRA 2011).
#ifndef TERN_FLATNESS_HPP
#define TERN_FLATNESS_HPP

#include <stdint.h>

#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Standard gravity, m/s^2, along -z of the world.
constexpr double kGravity = 9.80665;

/// Thrust below which its direction counts as undefined, m/s^2: free fall.
constexpr double kLeastThrust = 0.01;
/// Sine of the angle between thrust and the heading's left below which the heading counts as undefined.
constexpr double kLeastHeading = 1e-3;

/// Where the nose should point, by cosine and sine of the yaw angle, so that the core needs no trigonometry. Any
/// length but zero; zero or not finite counts as yaw 0.
struct Yaw {
  double cosine;
  double sine;
  double rate;  ///< rad/s, counter-clockwise seen from above; not finite counts as 0
};

/// What of a flat state is a stand-in, because the vehicle's attitude is undefined there.
enum class Singularity : uint8_t {
  kNone = 0,
  kFreeFall,   ///< thrust below kLeastThrust: level attitude, body rates of the yaw alone
  kHeading,    ///< thrust along the heading's left or right: nose at the heading, no rate about the thrust
  kNotFinite,  ///< a sample that is not finite: level, hovering, no rates
};

/// Attitude and rates that fly a sample. Body frame: x forward, y left, z along the thrust.
struct FlatState {
  double thrust;          ///< mass-normalised, m/s^2, >= 0: |acceleration + gravity's opposite|
  double attitude[3][3];  ///< rotation from body to world; columns are the body axes, the third the thrust's direction
  double quaternion[4];   ///< the same rotation, (w, x, y, z), unit, w >= 0
  Vec3 body_rates;        ///< rad/s, in the body frame
  Singularity singularity;
};

/// Total in all inputs.
FlatState flat_state(const Sample& sample, const Yaw& yaw) noexcept;

}  // namespace tern

#endif
