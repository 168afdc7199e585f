// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/yaw/yaw_units.hpp"

#include <cmath>

#include "host/number.hpp"

namespace tern_host {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

double within(const std::string& key, double value, double most, const char* unit, const Place& place) {
  if (std::fabs(value) <= most) return value;
  throw RecordError(place, "'" + key + "' is in " + unit + ", at most " + brief(most) + ", found " + brief(value) +
                               "; if that is in degrees, write " + fixed(kDegree * value, 4));
}

}  // namespace

double yaw_angle(const std::string& key, double value, const Place& place) {
  return within(key, value, kMostYaw, "rad", place);
}

double yaw_rate(const std::string& key, double value, const Place& place) {
  return within(key, value, kMostYawRate, "rad/s", place);
}

double yaw_acceleration(const std::string& key, double value, const Place& place) {
  return within(key, value, kMostYawAcceleration, "rad/s^2", place);
}

}  // namespace tern_host
