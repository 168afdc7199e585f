// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Range sensors of the stand-in's vehicle, which look at one box.
#pragma once

#include <algorithm>
#include <cmath>

#include "stand_in.hpp"

struct Solid {
  double lower[3], upper[3];  // east, north, up
};

// In the way from (-2, 0.5, 1.5) to (10, 2, 2), and not in the map.
constexpr Solid kPillar = {{3.0, 0.6, 0.0}, {3.6, 1.6, 5.0}};

/// How far the solid is from (east, north, up).
inline double distance_of(const Solid& solid, const double* p) {
  double square = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double d = std::max({solid.lower[k] - p[k], p[k] - solid.upper[k], 0.0});
    square += d * d;
  }
  return std::sqrt(square);
}

/// How far a ray from the vehicle goes until it meets the solid; 100 if it does not. Angles clockwise from north, and
/// up.
inline double range_of(const Solid& solid, double bearing, double up) {
  const double from[3] = {px4.local.y, px4.local.x, -px4.local.z};
  const double along[3] = {std::sin(bearing) * std::cos(up), std::cos(bearing) * std::cos(up), std::sin(up)};
  double enter = 0.0, leave = 100.0;
  for (int k = 0; k < 3; ++k) {
    const double a = (solid.lower[k] - from[k]) / along[k], b = (solid.upper[k] - from[k]) / along[k];
    if (std::isnan(a) || std::isnan(b)) continue;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave ? enter : 100.0;
}

/// The nearest thing in a part of the view.
inline double nearest(const Solid& solid, double bearing, double width, double height) {
  double least = 100.0;
  for (int row = -10; row <= 10; ++row) {
    for (int column = -10; column <= 10; ++column) {
      least = std::min(least, range_of(solid, bearing + 0.05 * width * column, 0.05 * height * row));
    }
  }
  return least;
}

/// What a sensor that looks ahead says.
inline distance_sensor_s ahead(const Solid& solid, float h_fov, float v_fov) {
  distance_sensor_s sensor{};
  sensor.timestamp = px4.now;
  sensor.min_distance = 0.2f;
  sensor.max_distance = 12.0f;
  sensor.h_fov = h_fov;
  sensor.v_fov = v_fov;
  sensor.signal_quality = 100;
  const double heading = static_cast<double>(px4.local.heading);
  sensor.current_distance = static_cast<float>(nearest(solid, heading, h_fov, v_fov));
  return sensor;
}

/// The same by a sensor whose attitude is a quaternion: rolled over.
inline distance_sensor_s ahead_by_quaternion(const Solid& solid) {
  distance_sensor_s sensor = ahead(solid, 0.35f, 0.06f);
  sensor.orientation = distance_sensor_s::ROTATION_CUSTOM;
  sensor.q[1] = 1.0f;
  return sensor;
}

inline obstacle_distance_s around(const Solid& solid, uint8_t frame) {
  obstacle_distance_s ring{};
  ring.timestamp = px4.now;
  ring.frame = frame;
  ring.increment = 5.0f;
  ring.min_distance = 20;
  ring.max_distance = 1200;
  const bool is_body = frame == obstacle_distance_s::MAV_FRAME_BODY_FRD;
  for (int k = 0; k < 72; ++k) {
    const double bearing = (is_body ? static_cast<double>(px4.local.heading) : 0.0) + k * 0.0872665;
    const double range = nearest(solid, bearing, 0.0872665, 0.0);
    ring.distances[k] = range < 12.0 ? static_cast<uint16_t>(100.0 * range) : uint16_t{1201};
  }
  return ring;
}

/// Sends what `measure` says with 10 Hz.
template <typename Message, typename Measure>
void send(Sent<Message>& sensor, const Measure& measure) {
  if ((px4.now / 20000) % 5 == 0) sensor.send(measure());
}

/// The least distance of the setpoints from the solid, of those sent from a time on.
inline double least_distance(const Solid& solid, double since = 0.0) {
  double least = 100.0;
  for (const trajectory_setpoint_s& s : px4.setpoints) {
    if (1e-6 * static_cast<double>(s.timestamp) < since) continue;
    const double enu[3] = {s.position[1], s.position[0], -s.position[2]};
    least = std::min(least, distance_of(solid, enu));
  }
  return least;
}
