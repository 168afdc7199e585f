// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Turns a sample of a trajectory into a setpoint for a multirotor's controller: thrust, attitude and body rates. A
// multirotor is differentially flat in position and yaw, so all three follow from acceleration, jerk and yaw (Mellinger
// and Kumar, ICRA 2011). Drag is not modelled.
#ifndef TERN_FLATNESS_HPP
#define TERN_FLATNESS_HPP

#include <stdint.h>

#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Standard gravity, m/s^2, along -z of the world.
constexpr double kGravity = 9.80665;

/// Thrust over mass, m/s^2. Below it, the direction of the thrust counts as undefined: free fall.
constexpr double kLeastThrust = 0.01;
/// Sine of the angle between the thrust and the horizontal line to the left of the nose. Below it, the direction of the
/// nose counts as undefined.
constexpr double kLeastHeading = 1e-3;

/// Where the nose points, seen from above. The angle is given by its cosine and sine, counter-clockwise from x of the
/// world; their common scale does not matter. If both are zero, or one is not finite, yaw 0 is used.
struct Yaw {
  double cosine;
  double sine;
  /// rad/s, counter-clockwise. Counts as 0 if it is not finite.
  double rate;
};

/// Why a flat state has substitute values: the attitude is undefined for that sample.
enum class Singularity : uint8_t {
  kNone = 0,   ///< no substitute values
  kFreeFall,   ///< thrust below kLeastThrust: level attitude, the yaw rate is the only body rate
  kHeading,    ///< thrust sideways, across the heading: the nose stays near the heading, no rate about the thrust
  kNotFinite,  ///< acceleration or jerk is not finite: level, hovering, no body rates
};

/// Thrust, attitude and body rates that fly a sample. Body frame: x forward, y left, z along the thrust.
struct FlatState {
  /// Thrust over mass, m/s^2, >= 0: |acceleration + (0, 0, kGravity)|.
  double thrust;
  /// Rotation matrix from body to world, row by row. Its columns are the body's axes in the world frame.
  double attitude[3][3];
  /// The attitude as a unit quaternion (w, x, y, z) with w >= 0.
  double quaternion[4];
  /// rad/s, in the body frame.
  Vec3 body_rates;
  Singularity singularity;
};

/// The flat state of `sample` (world frame) with the given yaw. Every input has an answer; see Singularity. Only the
/// sample's acceleration and jerk are read.
FlatState flat_state(const Sample& sample, const Yaw& yaw) noexcept;

}  // namespace tern

#endif
