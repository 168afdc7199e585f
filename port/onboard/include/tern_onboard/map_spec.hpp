// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From settings to what the core takes.
#ifndef TERN_ONBOARD_MAP_SPEC_HPP
#define TERN_ONBOARD_MAP_SPEC_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "tern/flight.hpp"
#include "tern/map.hpp"
#include "tern_onboard/settings.hpp"

namespace tern_onboard {

/// A ground at or below it, and a ceiling at or above it, are none.
constexpr double kNoGround = -1000.0;
constexpr double kNoCeiling = 1000.0;

tern::MapSpec map_spec_of(const MapSettings& settings);
tern::FlightSpec flight_spec_of(const Settings& settings);
/// Lowers the limits of speed for what may come from beyond the detector's range. kOk, or why no speed is slow enough.
tern::Status slow_for_beyond(const Settings& settings, tern::FlightSpec& spec);
/// The half-spaces below the ceiling and above the ground, in which the body's centre stays; returns how many.
std::int32_t height_planes(const Settings& settings, tern::Halfspace (&planes)[2]);
/// What is wrong with a mission, in words; empty if nothing is.
std::string mission_fault(const std::vector<tern::Via>& points, const Settings& settings);

}  // namespace tern_onboard

#endif
