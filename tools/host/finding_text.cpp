// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/finding_text.hpp"

#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Finding;
using tern::ProofReport;

std::string number_of(const char* what, int index) {
  return std::string(what) + " " + std::to_string(index);
}

/// As in the request's list, counted from 1.
std::string asked_number(const char* what, int index) {
  return number_of(what, index + 1);
}

std::string derivative_name(int derivative) {
  static const char* const kNames[] = {"position", "velocity", "acceleration", "jerk"};
  return derivative >= 0 && derivative < 4 ? kNames[derivative] : "motion";
}

std::string axis_text(int axis) {
  static const char* const kNames[] = {" on the x axis",          " on the y axis", " on the z axis",
                                       " in the horizontal norm", " in its thrust", " in its tilt"};
  return axis >= 0 && axis < 6 ? kNames[axis] : "";
}

std::string excess_text(const ProofReport& check) {
  static const char* const kUnits[] = {"m", "m/s", "m/s^2", "m/s^3"};
  const int derivative = check.derivative > 0 && check.derivative < 4 ? check.derivative : 0;
  return " by " + brief(check.excess) + " " + kUnits[derivative];
}

std::string segment_text(const ProofReport& check) {
  return number_of("segment", check.segment);
}

std::string time_text(const ProofReport& check) {
  return " from " + brief(check.until) + " s on,";
}

std::string obstacle_text(const ProofReport& check) {
  const tern::Voxel& voxel = check.voxel;
  return segment_text(check) + " is too near to the obstacle in voxel (" + std::to_string(voxel.x) + ", " +
         std::to_string(voxel.y) + ", " + std::to_string(voxel.z) + ")" + time_text(check) + excess_text(check);
}

/// Its number, or its name if there are names.
std::string track_text(const ProofReport& check, const std::vector<TrackRecord>& tracks) {
  const auto index = static_cast<std::size_t>(check.track);
  return index < tracks.size() ? tracks[index].id : asked_number("track", check.track);
}

std::string motion_text(const ProofReport& check, const char* fault) {
  return derivative_name(check.derivative) + " of " + number_of("segment", check.segment) + axis_text(check.axis) +
         " " + fault + excess_text(check);
}

}  // namespace

std::string describe_finding(const ProofReport& check, const std::vector<FenceRecord>& fences,
                             const std::vector<TrackRecord>& tracks) {
  switch (check.finding) {
    case Finding::kMalformed:
      return check.segment < 0 ? "the plan has no segments, or too many" : segment_text(check) + " is malformed";
    case Finding::kObstacle:
      return obstacle_text(check);
    case Finding::kOutside:
      return segment_text(check) + " is outside the boundary" + axis_text(check.axis) + time_text(check) +
             excess_text(check);
    case Finding::kPieces:
      return segment_text(check) + " needs too many pieces" + time_text(check) + " to be proven";
    case Finding::kVelocity:
    case Finding::kAcceleration:
    case Finding::kJerk:
      return motion_text(check, "is beyond its limit");
    case Finding::kBodyRate:
      return "body rate of " + segment_text(check) + " is beyond its limit by " + brief(check.excess) + " rad/s";
    case Finding::kJoint:
      return motion_text(check, "jumps from the segment before");
    case Finding::kFence:
      return segment_text(check) + " breaks " + asked_number("fence", check.fence) + zone_text(fences, check.fence) +
             time_text(check) + excess_text(check);
    case Finding::kBoundary:
      return motion_text(check, "misses the state that was asked for");
    case Finding::kVia:
      return derivative_name(check.derivative) + " at " + asked_number("via", check.via) +
             " is not what was asked for" + excess_text(check);
    case Finding::kTrack:
      return segment_text(check) + " is too near to " + track_text(check, tracks) + time_text(check) +
             excess_text(check);
    case Finding::kNone:
      break;
  }
  return "";
}

}  // namespace tern_host
