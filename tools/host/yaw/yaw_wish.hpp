// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where the nose should point during a flight, as a scenario says it, and the yaw plan for that.
#ifndef TERN_HOST_YAW_YAW_WISH_HPP
#define TERN_HOST_YAW_YAW_WISH_HPP

#include <vector>

#include "host/text_records.hpp"
#include "tern/yaw.hpp"

namespace tern_host {

/// Angles in rad, counter-clockwise from x of the world; rates in rad/s, accelerations in rad/s^2.
struct YawWish {
  tern::YawMode mode = tern::YawMode::kAlongMotion;
  double heading = 0.0;                   ///< for kFixed
  tern::Vec3 point{};                     ///< for kTowardsPoint: world frame, metres
  std::vector<tern::TimedHeading> timed;  ///< for kTimed
  double start = 0.0;
  double start_rate = 0.0;
  double start_acceleration = 0.0;
  double rate_max = 1.0;
  double acceleration_max = 2.0;
};

/// The word of a `yaw` record for this mode: "fixed", "motion", "point" or "timed".
const char* yaw_mode_word(tern::YawMode mode);

/// Reads a `yaw` record into the mode and what belongs to it. Throws RecordError.
void read_yaw_record(const Words& words, const Place& place, YawWish& wish);

/// The core's answer: kOk and a plan, or what is wrong with the wish.
tern::Status plan_yaw(const YawWish& wish, const tern::Trajectory& trajectory, tern::YawPlan& plan);

/// The largest |rate| and |acceleration| of a yaw plan, sampled 50 times a piece.
struct YawPeaks {
  double rate;
  double acceleration;
};
YawPeaks yaw_peaks(const tern::YawPlan& plan);

}  // namespace tern_host

#endif
