// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Angles in files are in rad. Numbers that are most likely in degrees are refused.
#ifndef TERN_HOST_YAW_YAW_UNITS_HPP
#define TERN_HOST_YAW_YAW_UNITS_HPP

#include <string>

#include "host/text_records.hpp"

namespace tern_host {

/// One turn, rad.
constexpr double kTurn = 6.28318530717958648;
/// One turn in a file, rad, with room for 6.2832.
constexpr double kMostYaw = 6.2832;
/// 1800 degrees a second, rad/s: what autopilots allow at most.
constexpr double kMostYawRate = 31.416;
/// rad/s^2; no multirotor turns so hard.
constexpr double kMostYawAcceleration = 100.0;

/// `value` if it is an angle, a rate or an acceleration of the yaw within those limits. `key` is the record's name.
/// Throws RecordError.
double yaw_angle(const std::string& key, double value, const Place& place);
double yaw_rate(const std::string& key, double value, const Place& place);
double yaw_acceleration(const std::string& key, double value, const Place& place);

}  // namespace tern_host

#endif
