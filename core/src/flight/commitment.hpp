// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is flown, and times.
#ifndef TERN_FLIGHT_COMMITMENT_HPP
#define TERN_FLIGHT_COMMITMENT_HPP

#include <cstdint>

#include "flight/flight_clock.hpp"
#include "flight/itinerary.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// A committed plan, or one that may become it.
struct Commitment {
  Trajectory flown;                    ///< ends at rest; proven
  Trajectory wished;                   ///< the plan whose first part is flown
  double branch;                       ///< seconds since the beginning up to which both are the same
  std::int64_t begin;                  ///< nanoseconds
  Vec3 aim;                            ///< where `wished` ends
  bool to_goal;                        ///< the aim is the target,
  bool beside_goal;                    ///< or the nearest free point to it
  std::uint32_t goal;                  ///< number of the mission that it was made for,
  std::int32_t target;                 ///< and the point that the aim is, or leads to
  Passage passage[kMaxMissionPoints];  ///< of the points that `wished` passes, in order
  std::int32_t passages;
  bool evades;  ///< a brake that was made for a threat, proven or not
  bool leaves;  ///< it begins at rest with something within the radius of this place, world frame
  Vec3 left;
  bool looks_out;  ///< it leads to where this may be seen, world frame
  Vec3 hidden;
};

/// The first instant at which what is flown is not proven.
struct Contact {
  std::int64_t time;  ///< nanoseconds
  double speed;       ///< m/s, there
};

/// What a brake that is not proven would do.
struct Evasion {
  int number;    ///< negative: none
  double until;  ///< seconds from its beginning; clear so far
  double speed;  ///< m/s, there
  bool known;    ///< clear of everything but the alarm
};

/// Seconds from `begin` to `t`.
inline double seconds_between(std::int64_t begin, std::int64_t t) noexcept {
  return static_cast<double>(t - begin) * 1e-9;
}

/// Nanoseconds, rounded down. No plan is flown for longer than kFarthest.
inline std::int64_t nanoseconds(double seconds) noexcept {
  const double exact = seconds * 1e9;
  return exact < static_cast<double>(kFarthest) ? static_cast<std::int64_t>(exact) : kFarthest;
}

}  // namespace tern

#endif
