// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/lidar.hpp"

#include <algorithm>
#include <cmath>

#include "host/flight/ray_fan.hpp"

namespace tern_host {
namespace {

constexpr double kTurn = 6.28318530717958648;
/// Distance that a beam is followed to, in ranges.
constexpr double kFarther = 1.5;
/// Distance of an outlier at least, metres.
constexpr double kNearestOutlier = 0.1;

/// Beams in rows of equal height around the lidar.
struct BeamGrid {
  explicit BeamGrid(const FlightSettings& s)
      : columns(static_cast<int>(std::ceil(kTurn / (0.5 * s.scan_pixel)))),
        rows(static_cast<int>(std::ceil(s.fov_vertical * kTurn / 360.0 / (0.5 * s.scan_pixel)))),
        lowest(-0.5 * s.fov_vertical * kTurn / 360.0),
        high(s.fov_vertical * kTurn / 360.0 / rows) {}
  double azimuth(double column) const { return kTurn * column / columns; }
  double elevation(double row) const { return lowest + high * row; }

  int columns, rows;
  double lowest, high;  ///< rad
};

/// Distances along the beams' borders, (columns + 1) x (rows + 1).
std::vector<double> border_distances(const FlightWorld& world, const BeamGrid& beams, const tern::Vec3& eye,
                                     double far) {
  const FlightWorld near = nearby(world, eye, far);
  std::vector<double> distances;
  for (int c = 0; c <= beams.columns; ++c) {
    const double azimuth = beams.azimuth(c);
    const RayFan fan(near, eye, far, std::cos(azimuth), std::sin(azimuth));
    for (int r = 0; r <= beams.rows; ++r) {
      const double elevation = beams.elevation(r);
      distances.push_back(fan.distance(-std::tan(elevation)) / std::cos(elevation));
    }
  }
  return distances;
}

}  // namespace

std::size_t beam_count(const FlightSettings& settings) {
  const BeamGrid beams(settings);
  return static_cast<std::size_t>(beams.columns) * static_cast<std::size_t>(beams.rows);
}

LidarScan take_scan(const FlightWorld& world, const tern::Vec3& eye, const tern::Vec3& believed, std::int64_t t,
                    Noise& noise) {
  const FlightSettings& s = world.settings;
  const BeamGrid beams(s);
  const double far = kFarther * s.sensor_range;
  const std::vector<double> borders = border_distances(world, beams, eye, far);
  const auto border = [&](int c, int r) { return borders[static_cast<std::size_t>(c * (beams.rows + 1) + r)]; };
  LidarScan scan;
  scan.origin = believed;
  scan.taken = t;
  for (int c = 0; c < beams.columns; ++c) {
    const double azimuth = beams.azimuth(c + 0.5);
    for (int r = 0; r < beams.rows; ++r) {
      double length = std::min({border(c, r), border(c, r + 1), border(c + 1, r), border(c + 1, r + 1)});
      if (s.depth_noise > 0.0) length *= 1.0 + noise.within(-s.depth_noise, s.depth_noise);
      if (s.outliers > 0.0 && noise.chance(s.outliers)) length = noise.within(kNearestOutlier, far);
      const double elevation = beams.elevation(r + 0.5);
      const double flat = length * std::cos(elevation);
      scan.points.push_back({believed.x + flat * std::cos(azimuth), believed.y + flat * std::sin(azimuth),
                             believed.z + length * std::sin(elevation)});
    }
  }
  return scan;
}

}  // namespace tern_host
