// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files for flight stacks, and how far what they say is from the plan. `origin` is the point of the world, metres in
// its axes, that becomes 0 in a file. Files end at export_end() (held_end.hpp). Functions throw std::runtime_error if a
// plan does not fit a form.
#ifndef TERN_HOST_EXPORT_PLAN_EXPORT_HPP
#define TERN_HOST_EXPORT_PLAN_EXPORT_HPP

#include <string>
#include <vector>

#include "host/session.hpp"
#include "tern_stacks/stacks.hpp"

namespace tern_host {

/// A Crazyflie's pieces in raw form.
struct RawForm {
  std::vector<tern::Poly4d> pieces;
  tern::ExportError error;

  /// As the firmware stores them: little-endian, one after the other.
  std::string bytes() const;
  /// As a table: duration, then eight coefficients each of x, y, z and yaw.
  std::string csv() const;
};
RawForm crazyflie_raw(const PlanResult& result, const tern::Vec3& origin);

/// The compressed form, and the curve that it flies, in the world.
struct CompressedForm {
  std::string bytes;
  tern::Trajectory curve;
  tern::ExportError error;
};
CompressedForm crazyflie_compressed(const PlanResult& result, const tern::Vec3& origin);

/// Setpoints at a rate, from 0 to export_end(). They are those of the times that the file says.
struct SetpointStream {
  std::string content;
  int count;
  tern::ExportError error;
};

/// MAVLink 2: SET_POSITION_TARGET_LOCAL_NED to system 1, component 1. `rate`: frames a second, at most 1000. Throws
/// std::invalid_argument for another rate, or one that makes more than a million frames.
SetpointStream mavlink_stream(const PlanResult& result, double rate, const tern::Vec3& origin);

/// trajectory_msgs/MultiDOFJointTrajectory as YAML, in the frame `map`, `rate` points a second. Throws as the other.
SetpointStream multidof_yaml(const PlanResult& result, double rate, const tern::Vec3& origin);

}  // namespace tern_host

#endif
