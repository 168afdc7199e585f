// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Yaw plans beside the committed plan: one after the other, each from the angle, rate and acceleration that the last
// one has when it takes over. No trajectory depends on them.
#ifndef TERN_FLIGHT_NOSE_HPP
#define TERN_FLIGHT_NOSE_HPP

#include <cstdint>

#include "base/work.hpp"
#include "flight/flight_facts.hpp"
#include "tern/flight.hpp"
#include "tern/proof.hpp"
#include "tern/trajectory.hpp"
#include "tern/yaw.hpp"

namespace tern {

/// Ticks from the start of work on a yaw plan to its takeover, if ticks come in time.
constexpr int kNoseTicks = 8;

/// The wish that a yaw plan is made for. When it changes, the flight makes another yaw plan.
struct NoseWish {
  FlightYawMode mode;
  Vec3 point;             ///< for kTowardsPoint
  Heading heading;        ///< for kFixed
  std::uint32_t commits;  ///< plans committed so far
};

/// A yaw plan that is followed from `begin` on. It begins within half a turn of 0. `turns` counts whole turns, so that
/// the nose turns on from where it is.
struct NoseTurn {
  YawPlan plan;
  double turns;
  std::int64_t begin;  ///< nanoseconds
};

struct Nose {
  FlightYaw yaw;  ///< as asked for
  Heading headings[kMaxMissionPoints];
  bool is_planned;  ///< the flight plans yaws
  NoseTurn in_flight;
  NoseTurn waiting;  ///< while a yaw plan is pending, only `begin` is set
  bool has_waiting;

  // The pending yaw plan.
  bool is_pending;
  NoseWish wish;
  YawPlanner planner;
  Trajectory way;  ///< the committed plan from the yaw plan's takeover on
  TimedHeading timed[kMaxMissionPoints];

  // What the flight needs to see.
  double least_cosine;  ///< cosine of the largest angle from the nose within the field of view
  bool has_unseen;      ///< an unseen voxel ended the last proof
  Vec3 unseen;          ///< the centre of that voxel, world frame

  void set(const FlightFacts& flight, const FlightYaw& wanted) noexcept;
  /// Goes on with the pending yaw plan, or begins one if the wish has changed. `look_at`: the next thing to see.
  /// `looks_out`: a lookout needs the nose there. `commits`: plans committed so far.
  void turn(const FlightFacts& flight, const Vec3& look_at, bool looks_out, std::uint32_t commits, Work& work) noexcept;
  /// Notes whether something that was not seen yet ended the last proof.
  void note_view(const RollingMap& map, const ProofReport& found) noexcept;

  /// kOk, or the fault of the wanted yaw.
  Status check(const FlightSpec& spec, const FlightYaw& wanted) const noexcept;
  YawSample at(std::int64_t t) const noexcept;
  /// The wish at this tick; the arguments are those of turn().
  NoseWish wish_of(const FlightFacts& flight, const Vec3& look_at, bool looks_out,
                   std::uint32_t commits) const noexcept;
  /// The next thing to see is outside the field of view: the flight goes on once the nose has turned.
  bool waits_for_nose(const FlightFacts& flight) const noexcept;
  /// How long a look around takes to turn to the next direction and see there, seconds.
  double seconds_per_direction(const FlightSpec& spec) const noexcept;
  /// Asks for the heading of each point that the committed plan passes, at its time. If it passes none, asks for the
  /// heading of the next point.
  void time_headings(const FlightFacts& flight, YawRequest& request) noexcept;

 private:
  void drop_late(const FlightFacts& flight) noexcept;
  void begin(const FlightFacts& flight, const NoseWish& wanted) noexcept;
  void advance(const FlightFacts& flight, Work& work) noexcept;
};

}  // namespace tern

#endif
