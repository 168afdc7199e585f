// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/sighting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tern_onboard/pose.hpp"

namespace tern_onboard {
namespace {

double kept(double before, double now) {
  return now < before && now > 0.5 * before ? before : now;
}

}  // namespace

tern::Track track_of(const Sighting& sighting, double sigmas) {
  tern::Track track;
  tern::track_of_class(sighting.kind, track);
  const bool is_ball = track.shape == tern::TrackShape::kBall;
  const double class_half = is_ball ? track.radius : track.half.z;
  track.shape = tern::TrackShape::kCylinder;
  if (sighting.radius > 0.0) track.radius = sighting.radius;
  track.half.z = (sighting.half_height > 0.0 ? sighting.half_height : class_half) + sighting.height_error;
  track.measured = sighting.stamp;
  track.position = sighting.position;
  const double speed = sighting.has_velocity ? length(sighting.velocity) : 0.0;
  track.reach = std::max(track.reach, speed);
  track.error = sigmas * sighting.deviation + sighting.error;
  if (sighting.has_velocity) {
    track.velocity = sighting.velocity;
    track.error_speed = sigmas * sighting.speed_deviation + sighting.speed_error;
  } else {
    track.error_speed = track.reach;
  }
  track.error += sighting.time_error * (sighting.has_velocity ? speed + track.error_speed : track.reach);
  return track;
}

void keep_bounds(const tern::Track& before, tern::Track& track) {
  track.radius = kept(before.radius, track.radius);
  track.half.z = kept(before.half.z, track.half.z);
  track.error_growth = kept(before.error_growth, track.error_growth);
  track.reach = kept(before.reach, track.reach);
}

double largest_deviation(const double (&covariance)[9]) {
  double largest = 0.0;
  for (int row = 0; row < 3; ++row) {
    const double* c = covariance + 3 * row;
    const double sum = std::abs(c[0]) + std::abs(c[1]) + std::abs(c[2]);
    if (!(c[row] >= 0.0) || !std::isfinite(sum)) return std::numeric_limits<double>::quiet_NaN();
    largest = std::max(largest, sum);
  }
  return std::sqrt(largest);
}

}  // namespace tern_onboard
