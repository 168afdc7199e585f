// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_LIDAR_HPP
#define TERN_HOST_FLIGHT_LIDAR_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/flight/noise.hpp"
#include "tern/map.hpp"

namespace tern_host {

/// One scan: directions in the world, and ranges. Beams without a return are infinite. Those that the filter finds no
/// length for are NaN: nothing is known there.
struct LidarScan {
  std::vector<tern::Vec3> directions;
  std::vector<float> ranges;
  tern::Vec3 origin{};
  std::int64_t taken = 0;

  tern::Beams beams() const;
  /// So many metres along a beam.
  tern::Vec3 point(std::size_t beam, double distance) const;
};

/// The middle of the view of scattered beams is so far above the lidar's level, rad: of -7 and 52 degrees.
constexpr double kScatteredRaised = 0.39269908169872414;

/// The beams of a scan.
std::size_t beam_count(const FlightSettings& settings);

/// What a lidar with this pose sees whose thin beams fill its view bit by bit, as those of a Livox Mid-360 do: from 7
/// degrees below its level to 52 above, all around. `first` is the number of its first beam: no two scans with other
/// numbers have the same beams. Its axes are x ahead, y left, z up. It has no outliers and no filter.
LidarScan take_scattered_scan(const FlightWorld& world, const tern::Pose& lidar, const tern::Vec3& believed,
                              std::int64_t t, std::uint64_t first, Noise& noise);

/// What a level lidar at `eye` sees all around, sensor_fov's vertical angle from its lowest beam to its highest, with
/// noise and outliers, and filtered where speckle_filter says so. It takes itself to be at `believed`. Beams are half
/// of scan_pixel apart, as the map demands; each shows what is nearest in its part of the view.
LidarScan take_scan(const FlightWorld& world, const tern::Vec3& eye, const tern::Vec3& believed, std::int64_t t,
                    Noise& noise);

}  // namespace tern_host

#endif
