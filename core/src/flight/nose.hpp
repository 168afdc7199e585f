// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The yaw plan beside the committed plan. No trajectory depends on it.
#ifndef TERN_FLIGHT_NOSE_HPP
#define TERN_FLIGHT_NOSE_HPP

#include <cstdint>

#include "flight/itinerary.hpp"
#include "tern/flight.hpp"
#include "tern/trajectory.hpp"
#include "tern/yaw.hpp"

namespace tern {

/// Ticks from the start of work on a yaw plan to its takeover, if ticks come in time.
constexpr int kNoseTicks = 8;

/// What a yaw plan is made for. When this changes, the flight makes another one.
struct NoseWish {
  FlightYawMode mode;
  Vec3 point;             ///< for kTowardsPoint
  Heading heading;        ///< for kFixed
  std::uint32_t commits;  ///< plans committed so far
};

struct Nose {
  FlightYaw yaw;  ///< as asked for
  Heading headings[kMaxMissionPoints];
  bool planned;  ///< the flight plans yaws

  /// A yaw plan begins within half a turn of 0. `turns` counts whole turns, so that the nose turns on from where it is.
  YawPlan now;
  double turns;
  std::int64_t begin;  ///< nanoseconds
  YawPlan next;
  double next_turns;
  std::int64_t next_begin;
  bool has_next;

  // The pending yaw plan.
  bool busy;
  NoseWish wish;
  YawPlanner planner;
  Trajectory way;  ///< the committed plan from the yaw plan's takeover on
  TimedHeading timed[kMaxMissionPoints];

  // What the flight needs to see.
  double least_cosine;  ///< cosine of the largest angle from the nose within the field of view
  bool has_unseen;      ///< something unseen ended the last proof
  Vec3 unseen;          ///< where that is, world frame
};

}  // namespace tern

#endif
