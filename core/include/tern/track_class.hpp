// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bounds of things that move, by class, for tracks whose bounds nobody gave.
#ifndef TERN_TRACK_CLASS_HPP
#define TERN_TRACK_CLASS_HPP

#include <stdint.h>

#include "tern/status.hpp"
#include "tern/track.hpp"

namespace tern {

/// Classes of things, each with bounds of its size and motion: docs/tracks.md#classes has the figures, and why. A class
/// is a start: bounds of your own are better wherever you know more.
enum class TrackClass : uint8_t {
  kPerson = 0,  ///< walks or jogs
  kCyclist,     ///< on a bicycle or a scooter
  kCar,         ///< in a town; motorcycles, too
  kTruck,       ///< and buses, with their trailers
  kBird,        ///< up to the size of a gull
  kDrone,       ///< up to some 10 kg
  kAircraft,    ///< with people aboard, below 10,000 ft
};
constexpr int32_t kTrackClasses = 7;

/// A thing of a class, still to be placed: sets its shape, size, largest acceleration (Track::error_growth) and speed
/// (Track::reach), and the class's number as Track::kind. All other members become zero: fill in who, when, where, how
/// fast and how wrong. kOk; kInvalidArgument for a number that is no class, and `track` is untouched.
Status track_of_class(TrackClass kind, Track& track) noexcept;

}  // namespace tern

#endif
