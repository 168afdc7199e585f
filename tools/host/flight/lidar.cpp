// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/lidar.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "host/flight/pixel_columns.hpp"
#include "host/flight/ray_length.hpp"
#include "host/flight/speckle_filter.hpp"
#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

/// From this distance on nothing comes back, in ranges.
constexpr double kNoReturn = 1.35;

/// Beams in rows of equal height around the lidar.
struct BeamGrid {
  explicit BeamGrid(const FlightSettings& s)
      : columns(static_cast<int>(std::ceil(kTurn / (0.5 * s.scan_pixel)))),
        rows(static_cast<int>(std::ceil(s.fov_vertical / (0.5 * s.scan_pixel)))),
        lowest(-0.5 * s.fov_vertical),
        high(s.fov_vertical / rows) {}
  double azimuth(double column) const { return kTurn * column / columns; }
  double elevation(double row) const { return lowest + high * row; }
  std::size_t count() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row * columns + column); }

  int columns, rows;
  double lowest, high;  ///< rad
};

/// What the driver says of a beam of this length, metres; 0: it does not know.
float range_of(double length, double sensor_range) {
  if (!(length > 0.0)) return std::numeric_limits<float>::quiet_NaN();
  if (length > kNoReturn * sensor_range) return std::numeric_limits<float>::infinity();
  return static_cast<float>(length);
}

/// What the beams measure, row by row. A beam shows what is nearest in its part of the view, between upright planes and
/// two falls for each metre along the middle between these.
std::vector<double> measured_lengths(const FlightWorld& world, const BeamGrid& beams, const tern::Vec3& eye,
                                     Noise& noise) {
  const FlightSettings& s = world.settings;
  const double far = kFarther * s.sensor_range;
  const double aside = std::tan(0.5 * kTurn / beams.columns);
  std::vector<double> lengths(beams.count());
  for (int c = 0; c < beams.columns; ++c) {
    const PixelColumns column(world, eye, beams.azimuth(c + 0.5), far, {-aside, aside});
    for (int r = 0; r < beams.rows; ++r) {
      double length = column.distance(0, -std::tan(beams.elevation(r + 1)), -std::tan(beams.elevation(r)));
      if (s.depth_noise > 0.0) length *= 1.0 + noise.within(-s.depth_noise, s.depth_noise);
      if (s.outliers > 0.0 && noise.chance(s.outliers)) length = noise.within(kNearestOutlier, far);
      lengths[beams.index(c, r)] = length;
    }
  }
  return lengths;
}

/// Beam k of those that fill the view of a Mid-360 evenly: the additive sequence of the plastic number.
tern::Vec3 scattered_beam(std::uint64_t k) {
  constexpr double kLowest = -0.12186934340514748;  // sine of -7 degrees
  constexpr double kHighest = 0.7880107536067220;   // and of 52
  const auto part = [k](double step) { return std::fmod(static_cast<double>(k) * step, 1.0); };
  const double azimuth = kTurn * part(0.7548776662466927);
  const double up = kLowest + (kHighest - kLowest) * part(0.5698402909980532);
  const double flat = std::sqrt(1.0 - up * up);
  return {flat * std::cos(azimuth), flat * std::sin(azimuth), up};
}

/// What is no farther than a lidar's range, as it says of it, may be seen.
FlightWorld nearby(const FlightWorld& world, const tern::Vec3& eye) {
  const double far = kNoReturn * world.settings.sensor_range;
  const auto is_near = [&](const auto& thing) { return distance_to(thing, eye) <= far; };
  FlightWorld near;
  near.boundary = world.boundary;
  std::copy_if(world.blocks.begin(), world.blocks.end(), std::back_inserter(near.blocks), is_near);
  std::copy_if(world.cylinders.begin(), world.cylinders.end(), std::back_inserter(near.cylinders), is_near);
  return near;
}

}  // namespace

tern::Beams LidarScan::beams() const {
  return {directions.data(), ranges.data(), ranges.size(), 0.0, std::numeric_limits<double>::infinity()};
}

tern::Vec3 LidarScan::point(std::size_t beam, double distance) const {
  const tern::Vec3& d = directions[beam];
  return {origin.x + distance * d.x, origin.y + distance * d.y, origin.z + distance * d.z};
}

std::size_t beam_count(const FlightSettings& settings) {
  return settings.beams > 0 ? static_cast<std::size_t>(settings.beams) : BeamGrid(settings).count();
}

LidarScan take_scattered_scan(const FlightWorld& world, const tern::Pose& lidar, const tern::Vec3& believed,
                              std::int64_t t, std::uint64_t first, Noise& noise) {
  const FlightSettings& s = world.settings;
  const FlightWorld near = nearby(world, lidar.position);
  LidarScan scan;
  scan.origin = believed;
  scan.taken = t;
  for (std::uint64_t k = first; k < first + beam_count(s); ++k) {
    scan.directions.push_back(turned(lidar, scattered_beam(k)));
    double length = ray_length(near, lidar.position, scan.directions.back());
    if (s.depth_noise > 0.0) length *= 1.0 + noise.within(-s.depth_noise, s.depth_noise);
    scan.ranges.push_back(range_of(length, s.sensor_range));
  }
  return scan;
}

LidarScan take_scan(const FlightWorld& world, const tern::Vec3& eye, const tern::Vec3& believed, std::int64_t t,
                    Noise& noise) {
  const FlightSettings& s = world.settings;
  const BeamGrid beams(s);
  std::vector<double> lengths = measured_lengths(world, beams, eye, noise);
  if (s.speckle_filter > 0) filter_speckle(lengths, beams.columns, beams.rows, s.depth_noise, Sides::kJoined);
  LidarScan scan;
  scan.origin = believed;
  scan.taken = t;
  for (int c = 0; c < beams.columns; ++c) {
    const double azimuth = beams.azimuth(c + 0.5);
    for (int r = 0; r < beams.rows; ++r) {
      const double elevation = beams.elevation(r + 0.5);
      const double flat = std::cos(elevation);
      scan.directions.push_back({flat * std::cos(azimuth), flat * std::sin(azimuth), std::sin(elevation)});
      scan.ranges.push_back(range_of(lengths[beams.index(c, r)], s.sensor_range));
    }
  }
  return scan;
}

}  // namespace tern_host
