// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "companion/globe.hpp"

#include <cmath>

namespace tern_companion {
namespace {

constexpr double kPi = 3.14159265358979323846, kRadian = kPi / 180.0;
constexpr double kPx4Radius = 6371000.0;           // m
constexpr double kArdupilotDegree = 111318.84502;  // m

/// The shorter way round.
double turn_between(double from, double to) {
  return std::remainder(to - from, 360.0);
}

tern::Vec3 azimuthal(double latitude, double longitude, double to_latitude, double to_longitude) {
  const double from = kRadian * latitude, to = kRadian * to_latitude;
  const double turn = kRadian * turn_between(longitude, to_longitude);
  const double north = std::cos(from) * std::sin(to) - std::sin(from) * std::cos(to) * std::cos(turn);
  const double east = std::cos(to) * std::sin(turn);
  const double ahead = std::sin(from) * std::sin(to) + std::cos(from) * std::cos(to) * std::cos(turn);
  const double sine = std::hypot(north, east), angle = std::atan2(sine, ahead);
  const double stretch = sine > 0.0 ? kPx4Radius * angle / sine : kPx4Radius;
  return {stretch * east, stretch * north, 0.0};
}

tern::Vec3 flat(double latitude, double longitude, double to_latitude, double to_longitude) {
  const double shrink = std::cos(kRadian * 0.5 * (latitude + to_latitude));
  return {turn_between(longitude, to_longitude) * kArdupilotDegree * shrink,
          (to_latitude - latitude) * kArdupilotDegree, 0.0};
}

}  // namespace

std::optional<tern::Vec3> place_in(const LocalFrame& frame, double latitude, double longitude) {
  const double from = 1e-7 * frame.origin.latitude, around = 1e-7 * frame.origin.longitude;
  if (!(std::abs(from) <= kHighestLatitude && std::abs(latitude) <= 90.0 && std::abs(longitude) <= 360.0)) return {};
  const tern::Vec3 place = frame.projection == Projection::kAzimuthal ? azimuthal(from, around, latitude, longitude)
                                                                      : flat(from, around, latitude, longitude);
  if (!(std::hypot(place.x, place.y) <= kFurthestPlace)) return {};
  return place;
}

}  // namespace tern_companion
