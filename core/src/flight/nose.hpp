// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The yaw plan beside what is flown. Nothing that is flown depends on it.
#ifndef TERN_FLIGHT_NOSE_HPP
#define TERN_FLIGHT_NOSE_HPP

#include <cstdint>

#include "flight/itinerary.hpp"
#include "tern/flight.hpp"
#include "tern/trajectory.hpp"
#include "tern/yaw.hpp"

namespace tern {

/// Ticks from the beginning of a yaw plan to the instant when it takes over, where ticks come in time.
constexpr int kNoseTicks = 8;

/// What a yaw plan is made for; another one is made where this changes.
struct NoseWish {
  FlightYawMode mode;
  Vec3 point;             ///< for kTowardsPoint
  Heading heading;        ///< for kFixed
  std::uint32_t commits;  ///< so far
};

struct Nose {
  FlightYaw yaw;  ///< as asked for
  Heading headings[kMaxMissionPoints];
  bool planned;  ///< the flight plans yaws

  /// A plan begins within half a turn of 0. The nose turns on from where it is: whole turns are counted.
  YawPlan now;
  double turns;
  std::int64_t begin;  ///< nanoseconds
  YawPlan next;
  double next_turns;
  std::int64_t next_begin;
  bool has_next;

  // The plan in work.
  bool busy;
  NoseWish wish;
  YawPlanner planner;
  Trajectory way;  ///< what is flown from the takeover on
  TimedHeading timed[kMaxMissionPoints];

  // What the flight needs to see.
  double least_cosine;  ///< of the angle from the nose, within the field of view
  bool has_unseen;      ///< something unseen ended the last proof:
  Vec3 unseen;          ///< this, world frame
};

}  // namespace tern

#endif
