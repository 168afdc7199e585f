// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files for flight stacks, and how far what they fly is from the plan.
#ifndef TERN_HOST_EXPORT_PLAN_EXPORT_HPP
#define TERN_HOST_EXPORT_PLAN_EXPORT_HPP

#include <string>

#include "host/session.hpp"
#include "tern/export.hpp"

namespace tern_host {

/// All pieces in the firmware's raw form, little-endian, one after the other. Throws std::runtime_error where the
/// firmware's memory does not hold them.
std::string crazyflie_raw(const PlanResult& result);

/// The same as a table: duration, then eight coefficients each of x, y, z and yaw.
std::string crazyflie_csv(const PlanResult& result);

/// The compressed form. Throws std::runtime_error where the plan does not fit it.
std::string crazyflie_compressed(const PlanResult& result);

/// MAVLink 2: SET_POSITION_TARGET_LOCAL_NED at `rate` frames a second, from 0 to the end of the plan, to system 1,
/// component 1. Throws std::invalid_argument where that makes more than a million frames.
std::string mavlink_stream(const PlanResult& result, double rate);

/// trajectory_msgs/MultiDOFJointTrajectory as YAML, in the frame `map`, `rate` points a second.
std::string multidof_yaml(const PlanResult& result, double rate);

/// The largest distances between the plan and what an export flies, sampled every millisecond.
struct ExportError {
  double position;      ///< m
  double velocity;      ///< m/s
  double acceleration;  ///< m/s^2
};
ExportError raw_error(const PlanResult& result);

/// What the compressed form flies, judged anew.
struct CompressedCurve {
  tern::Trajectory trajectory;
  ExportError error;   ///< at equal parts of each segment, whose durations are rounded
  double clear_until;  ///< s; until when it is proven on the map
  bool clear;          ///< proven to its end
};
CompressedCurve compressed_curve(const PlanResult& result, const std::string& bytes);

}  // namespace tern_host

#endif
