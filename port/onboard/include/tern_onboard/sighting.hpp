// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things that move, as detectors, transponders and other vehicles report them, and the tracks that a flight gets of
// them.
#ifndef TERN_ONBOARD_SIGHTING_HPP
#define TERN_ONBOARD_SIGHTING_HPP

#include <cstdint>
#include <string>

#include "tern/track_class.hpp"
#include "tern/vec3.hpp"

namespace tern_onboard {

/// What was reported of a thing. World frame of the poses, z up. Errors are of two kinds, because reports have both:
/// standard deviations, which count `thing_sigmas` times, and bounds, which count once.
struct Sighting {
  /// Who it is: the same in each of its reports, and different from all others, of whatever source.
  std::string name;
  tern::TrackClass kind = tern::TrackClass::kPerson;
  std::int64_t stamp = 0;  ///< ns: when it was there, on the clock of Onboard::tick()
  tern::Vec3 position{};   ///< m, of its centre
  /// Its velocity, m/s. Without one, it may move anywhere at the largest speed of its class.
  bool has_velocity = false;
  tern::Vec3 velocity{};
  double deviation = 0.0;        ///< m: the largest of the position along any direction
  double speed_deviation = 0.0;  ///< m/s: the largest of the velocity along any direction
  double error = 0.0;            ///< m: bound of what else the position may be off by
  double speed_error = 0.0;      ///< m/s: and the velocity
  double height_error = 0.0;     ///< m: bound of what else the height may be off by
  double time_error = 0.0;       ///< s: bound of the stamp's error
  /// m, of its size, as an upright cylinder: the radius, and half its height. 0: those of its class.
  double radius = 0.0;
  double half_height = 0.0;
};

/// The track of a sighting, without an id: an upright cylinder, with what its class may do. Heights that are not well
/// known make it taller and not wider. A thing that was seen to be faster than its class has its own speed as
/// Track::reach.
tern::Track track_of(const Sighting& sighting, double sigmas);

/// What a thing keeps of its last track, so that sizes that jitter are no news each time: sizes and bounds of its
/// motion that are smaller than before, but not by half, stay as they were.
void keep_bounds(const tern::Track& before, tern::Track& track);

/// The largest standard deviation along any direction, or more: the square root of the largest sum of a row of absolute
/// values, which no eigenvalue exceeds. `covariance`: 3 x 3, by rows. NaN for a matrix with a negative variance or a
/// number that is not finite.
double largest_deviation(const double (&covariance)[9]);

}  // namespace tern_onboard

#endif
