// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bounds of things, by class. docs/tracks.md#classes says where each figure is from.
#include "tern/track_class.hpp"

#include <cstdint>

namespace tern {
namespace {

struct ClassBounds {
  TrackShape shape;
  double radius;        // m
  double half_height;   // m, of a cylinder
  double speed;         // m/s
  double acceleration;  // m/s^2
};

constexpr ClassBounds kBounds[] = {
    {TrackShape::kCylinder, 0.4, 1.0, 3.0, 3.0},       // a person
    {TrackShape::kCylinder, 1.0, 1.0, 12.5, 6.0},      // a cyclist
    {TrackShape::kCylinder, 3.1, 1.0, 20.0, 9.0},      // a car
    {TrackShape::kCylinder, 9.5, 2.0, 28.0, 8.0},      // a truck
    {TrackShape::kBall, 0.7, 0.0, 23.0, 15.0},         // a bird
    {TrackShape::kBall, 0.8, 0.0, 20.0, 11.0},         // a drone
    {TrackShape::kCylinder, 40.0, 12.5, 130.0, 17.0},  // an aircraft
};
static_assert(sizeof kBounds / sizeof kBounds[0] == kTrackClasses);

}  // namespace

Status track_of_class(TrackClass kind, Track& track) noexcept {
  const auto index = static_cast<std::uint32_t>(kind);
  if (index >= static_cast<std::uint32_t>(kTrackClasses)) return Status::kInvalidArgument;
  const ClassBounds& bounds = kBounds[index];
  track = Track{};
  track.kind = index;
  track.shape = bounds.shape;
  track.radius = bounds.radius;
  track.half.z = bounds.half_height;
  track.reach = bounds.speed;
  track.error_growth = bounds.acceleration;
  return Status::kOk;
}

}  // namespace tern
