// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_FLIGHT_SENSOR_HPP
#define TERN_FLIGHT_SENSOR_HPP

#include "tern/vec3.hpp"

namespace tern {

/// What the vehicle's sensor sees, for a flight that chooses from where to look. It turns with the vehicle's nose, or
/// with Command::look_at. If there are several, describe the one that sees most around the nose. No proof depends on
/// it: a description that is wrong costs time, never safety.
struct FlightSensor {
  /// Angles of view, rad. `horizontal`: > 0, at most 2 pi. Up to 3 rad it is a camera, whose view is a pyramid; beyond
  /// that a scanner, which sees all directions within half of it to either side of the nose. `vertical`: > 0, at most
  /// 3 rad.
  double horizontal;
  double vertical;
  /// How far the axis of the view is pitched up from level, rad, within -1.5 .. 1.5 and pitch_min <= pitch_max. They
  /// differ if a gimbal turns the sensor up and down to Command::look_at.
  double pitch_min;
  double pitch_max;
  /// Nothing nearer than this is measured, metres, >= 0.
  double nearest;
  /// Where the sensor is: metres ahead of the vehicle's centre, to its left, and up.
  Vec3 offset;
  /// Of a scanner: how far the middle of its vertical angle is above the plane that it turns in, rad, within -1.5
  /// .. 1.5: 0.39 for a Livox Mid-360, which sees from 7 degrees below that plane to 52 above. 0 for a camera.
  double raised;
};

/// A level depth camera: 87 by 58 degrees, from 0.1 m on, in the vehicle's centre.
constexpr FlightSensor kLevelCamera{1.518, 1.012, 0.0, 0.0, 0.1, {0.0, 0.0, 0.0}, 0.0};

}  // namespace tern

#endif
