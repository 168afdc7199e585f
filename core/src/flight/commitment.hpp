// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Committed plans, and conversions of their times.
#ifndef TERN_FLIGHT_COMMITMENT_HPP
#define TERN_FLIGHT_COMMITMENT_HPP

#include <cstdint>

#include "flight/flight_clock.hpp"
#include "flight/itinerary.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// A committed plan, or a draft of one.
struct Commitment {
  Trajectory flown;                    ///< the trajectory to fly: it ends at rest, and is proven
  Trajectory wished;                   ///< the planner's plan, which `flown` follows up to the branch
  double branch;                       ///< seconds since the beginning: until then `flown` and `wished` are the same
  std::int64_t begin;                  ///< nanoseconds
  Vec3 aim;                            ///< where `wished` ends
  bool to_goal;                        ///< the aim is the target
  bool beside_goal;                    ///< the aim is the nearest free point to the target
  std::uint32_t goal;                  ///< number of the mission that the plan was made for
  std::int32_t target;                 ///< the mission's point that the aim is, or leads to
  Passage passage[kMaxMissionPoints];  ///< when `wished` passes its points, in order
  std::int32_t passages;
  bool evades;     ///< a brake that was made for a threat, proven or not
  bool leaves;     ///< it begins at rest at `left`, with something within the radius
  Vec3 left;       ///< world frame
  bool looks_out;  ///< it leads to a place from where `hidden` may be seen
  Vec3 hidden;     ///< world frame
};

/// The first instant at which a committed plan is not proven.
struct Contact {
  std::int64_t time;  ///< nanoseconds
  double speed;       ///< m/s, there
};

/// What would happen on a brake that is not proven clear.
struct Evasion {
  int number;    ///< negative: none
  double until;  ///< seconds since its beginning: until then it is clear
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
