// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tern's part of a flight: its memory, the map, the limits, and how the flight begins.
#pragma once

#include <tern/tern.hpp>

#include "topics.hpp"
#include "world.hpp"

namespace tern_offboard {

constexpr int64_t kTick = 20000000;  // ns: as often as setpoints are sent
constexpr double kScanPixel = 0.1;   // rad, MapSpec::scan_pixel
constexpr double kRange = 6.0;       // m up to which sensors are used

/// The yaw of PX4's heading, which is clockwise from north; Tern's is counter-clockwise from east.
inline tern::YawSample yaw_at(double heading) {
  return {{sin(heading), cos(heading), 0.0}, 0.0, 1.57079632679489662 - heading};
}

/// The time of PX4's clock as Tern's.
inline int64_t nanoseconds(hrt_abstime now) {
  return static_cast<int64_t>(now) * 1000;
}

/// Reads the map and PX4's limits, and begins a flight to find out whether that can be done `from` here. False: the log
/// says why not.
bool prepare(const char* map_path, const Hover& from, const tern::Vec3& goal, hrt_abstime now);

/// Begins a flight from rest. `has_sensors`: it stays near the heights of start and goal, at which they look.
/// `new_map`: what was seen no longer holds. False: the log says why not.
bool begin_flight(const Hover& from, const tern::Vec3& goal, bool has_sensors, bool new_map, hrt_abstime now);

/// The only ones of their kind.
tern::Flight& the_flight();
tern::RollingMap& the_map();

}  // namespace tern_offboard
