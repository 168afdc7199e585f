// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Committed plans: the one in flight, and one that may wait for its takeover.
#ifndef TERN_FLIGHT_COMMITTED_PLANS_HPP
#define TERN_FLIGHT_COMMITTED_PLANS_HPP

#include <cstdint>

#include "flight/flight_clock.hpp"
#include "flight/track_table.hpp"
#include "tern/flight.hpp"
#include "tern/proof.hpp"
#include "tern/trajectory.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// When a plan passes a point.
struct Passage {
  std::int32_t point;  ///< of the itinerary
  double time;         ///< seconds since the plan's beginning
};

/// Later than any plan passes a point, seconds.
constexpr double kNever = 1e9;

/// Where a plan leads, and for which mission.
struct Destination {
  Vec3 place;             ///< where the plan ends, world frame
  bool at_target;         ///< the plan ends at the target
  bool beside_target;     ///< the plan ends at the nearest free point to the target
  std::uint32_t mission;  ///< number of the mission that the plan is made for
  std::int32_t target;    ///< the mission's point that the plan ends at, or leads to
};

/// A committed plan, or a draft of one.
struct Commitment : Destination {
  Trajectory trajectory;               ///< the curve that the vehicle follows, proven, up to rest
  Trajectory planned;                  ///< the planner's plan, which `trajectory` follows up to the branch
  double branch;                       ///< up to this time, both are the same; seconds since the beginning
  Passage passage[kMaxMissionPoints];  ///< when `planned` passes its points, in order
  std::int32_t passages;
  bool evades;       ///< a brake that was made for a threat, proven or not
  bool hemmed_in;    ///< the plan begins at rest at `departed`, with something within the radius
  Vec3 departed;     ///< world frame
  bool lifts;        ///< the plan leads straight up from `departed` on the ground, or straight down to it
  double ground;     ///< the height that the ground there does not exceed
  bool lands;        ///< it leads down to `departed`, to stay there
  bool looks_out;    ///< the plan leads to a lookout
  TrackTable tubes;  ///< of things that move: `trajectory` was proven with them

  /// The takeover, which the planner's request fixed. Nanoseconds since the flight's start, as all times of a flight.
  std::int64_t begin() const noexcept { return planned.begin; }
  /// The time on the plan, seconds since its beginning.
  double time_at(std::int64_t t) const noexcept { return time_on(planned, t); }
  /// Where the vehicle rests after `trajectory`, world frame, and from when on.
  Vec3 end() const noexcept;
  std::int64_t rests() const noexcept;
  /// When it passes the point, in seconds since its beginning; kNever if it does not.
  double time_of(std::int32_t point) const noexcept;
};

/// The first instant at which a committed plan is not proven.
struct Contact {
  std::int64_t time;  ///< nanoseconds
  double speed;       ///< m/s, at that time
};

/// Nanoseconds, rounded down. No plan is flown for longer than kFarthest.
inline std::int64_t nanoseconds(double seconds) noexcept {
  const double exact = seconds * 1e9;
  return exact < static_cast<double>(kFarthest) ? static_cast<std::int64_t>(exact) : kFarthest;
}

/// The grounds of every proof of a commitment. They point into the commitment.
ProofGrounds grounds_of(const FlightSpec& spec, const Commitment& commitment) noexcept;

struct CommittedPlans {
  Commitment in_flight;
  Commitment waiting;  ///< its takeover is still ahead
  bool has_waiting;

  /// The plan that the vehicle follows at time `t`.
  const Commitment& at(std::int64_t t) const noexcept {
    return has_waiting && t >= waiting.begin() ? waiting : in_flight;
  }
  /// The plan that will be followed to its end.
  const Commitment& latest() const noexcept { return has_waiting ? waiting : in_flight; }
  Sample sample_at(std::int64_t t) const noexcept;
  /// Where the vehicle was to be at a time that may be over. Of the plan before the one in flight, nothing is left: it
  /// is that plan, from its beginning back. False if that is too long ago.
  bool was_at(std::int64_t t, Vec3& position) const noexcept;
  /// When the plan in flight has come to rest.
  std::int64_t rest_begins() const noexcept;
  /// The plan in flight becomes one segment that stays at a place.
  void hover_at(const Vec3& position) noexcept;
  /// The vehicle stands where it hovers, on ground that is no higher than `ground`.
  void stand_on(double ground) noexcept;
  /// True if the waiting plan takes over at `time`.
  bool take_over(std::int64_t time) noexcept;
  void drop_waiting() noexcept { has_waiting = false; }
  /// An extension is the same curve as the plan in flight up to that plan's branch, so it replaces that plan in place.
  /// Any other draft becomes the waiting plan.
  void commit(const Commitment& draft, bool extends) noexcept;
};

}  // namespace tern

#endif
