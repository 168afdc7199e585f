// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/finding_text.hpp"

#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::CheckReport;
using tern::Finding;

std::string number_of(const char* what, int index) {
  return std::string(what) + " " + std::to_string(index);
}

std::string derivative_name(int derivative) {
  static const char* const kNames[] = {"position", "velocity", "acceleration", "jerk"};
  return derivative >= 0 && derivative < 4 ? kNames[derivative] : "motion";
}

std::string axis_text(int axis) {
  static const char* const kNames[] = {" on the x axis", " on the y axis", " on the z axis", " in the horizontal norm"};
  return axis >= 0 && axis < 4 ? kNames[axis] : "";
}

std::string excess_text(const CheckReport& check) {
  static const char* const kUnits[] = {"m", "m/s", "m/s^2", "m/s^3"};
  const int derivative = check.derivative > 0 && check.derivative < 4 ? check.derivative : 0;
  return " by " + brief(check.excess) + " " + kUnits[derivative];
}

std::string malformed_text(const CheckReport& check) {
  if (check.segment >= 0) return number_of("segment", check.segment) + " is malformed";
  if (check.polyhedron >= 0) return number_of("polyhedron", check.polyhedron) + " is malformed";
  return "the plan has no segments or polyhedra, or too many";
}

std::string obstacle_text(const CheckReport& check) {
  const tern::Voxel& voxel = check.voxel;
  return number_of("polyhedron", check.polyhedron) + " is too near to the obstacle in voxel (" +
         std::to_string(voxel.x) + ", " + std::to_string(voxel.y) + ", " + std::to_string(voxel.z) + ") at " +
         number_of("half-space", check.plane) + excess_text(check);
}

std::string outside_text(const CheckReport& check) {
  const std::string segment = number_of("segment", check.segment) + " is outside ";
  if (check.plane < 0) return segment + "the boundary" + axis_text(check.axis) + excess_text(check);
  return segment + number_of("half-space", check.plane) + " of " + number_of("polyhedron", check.polyhedron) +
         excess_text(check);
}

std::string fence_text(const CheckReport& check) {
  const std::string fence = number_of("fence", check.fence);
  if (check.segment >= 0)
    return number_of("segment", check.segment) + " is outside keep-in " + fence + excess_text(check);
  return number_of("polyhedron", check.polyhedron) + " is too near to keep-out " + fence + excess_text(check);
}

std::string motion_text(const CheckReport& check, const char* fault) {
  return derivative_name(check.derivative) + " of " + number_of("segment", check.segment) + axis_text(check.axis) +
         " " + fault + excess_text(check);
}

}  // namespace

std::string describe_finding(const CheckReport& check) {
  switch (check.finding) {
    case Finding::kMalformed:
      return malformed_text(check);
    case Finding::kObstacle:
      return obstacle_text(check);
    case Finding::kOutside:
      return outside_text(check);
    case Finding::kVelocity:
    case Finding::kAcceleration:
    case Finding::kJerk:
      return motion_text(check, "is beyond its limit");
    case Finding::kJoint:
      return motion_text(check, "jumps from the segment before");
    case Finding::kFence:
      return fence_text(check);
    case Finding::kBoundary:
      return motion_text(check, "misses the state that was asked for");
    case Finding::kVia:
      return derivative_name(check.derivative) + " at " + number_of("via", check.via) + " is not what was asked for" +
             excess_text(check);
    case Finding::kNone:
      break;
  }
  return "";
}

}  // namespace tern_host
