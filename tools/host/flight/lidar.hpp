// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_HOST_FLIGHT_LIDAR_HPP
#define TERN_HOST_FLIGHT_LIDAR_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/flight/noise.hpp"

namespace tern_host {

/// One scan: a point in the world for each beam. Beams without a return end beyond the range. Those that the filter
/// finds no length for end at the origin, which tells the map nothing.
struct LidarScan {
  std::vector<tern::Vec3> points;
  tern::Vec3 origin{};
  std::int64_t taken = 0;
};

/// The points of a scan.
std::size_t beam_count(const FlightSettings& settings);

/// What a level lidar at `eye` sees all around, sensor_fov's vertical angle from its lowest beam to its highest, with
/// noise and outliers, and filtered where speckle_filter says so. It takes itself to be at `believed`. Beams are half
/// of scan_pixel apart, as the map demands; each shows what is nearest in its part of the view.
LidarScan take_scan(const FlightWorld& world, const tern::Vec3& eye, const tern::Vec3& believed, std::int64_t t,
                    Noise& noise);

}  // namespace tern_host

#endif
