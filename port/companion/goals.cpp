// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "companion/goals.hpp"

#include <cmath>

#include "companion/ned.hpp"

namespace tern_companion {
namespace {

constexpr std::uint16_t kNoPosition = 7;
constexpr std::uint16_t kPauseContinue = 193;
constexpr char kUnknown[] = "only DO_REPOSITION and DO_PAUSE_CONTINUE are known";

bool is_for(const Sender& target, std::uint8_t system, std::uint8_t component) {
  return system == target.system && component == target.component;
}

GoalMessage refuse(std::uint16_t command, const std::string& reason) {
  return {GoalMessage::Kind::kRefused, {}, command, reason};
}

GoalMessage go_to(const tern::Vec3& goal, std::uint16_t command) {
  if (!std::isfinite(goal.x) || !std::isfinite(goal.y) || !std::isfinite(goal.z)) {
    return refuse(command, "a coordinate of the goal is no number");
  }
  return {GoalMessage::Kind::kGoal, goal, command, ""};
}

GoalMessage read(const SetPositionTarget& target) {
  if (target.coordinate_frame != kLocalNed) return refuse(0, "goals are in the frame LOCAL_NED (1)");
  if ((target.type_mask & kNoPosition) != 0) return refuse(0, "a goal needs a position");
  return go_to(enu_from_ned(target.position), 0);
}

GoalMessage read_global(double latitude, double longitude, double up, const LocalFrame* local) {
  if (local == nullptr) return refuse(kDoReposition, "the autopilot has not sent GPS_GLOBAL_ORIGIN");
  std::optional<tern::Vec3> place = place_in(*local, latitude, longitude);
  if (!place) return refuse(kDoReposition, "it is more than 10 km from the local origin, or that is near a pole");
  place->z = up;
  return go_to(*place, kDoReposition);
}

GoalMessage reposition(const CommandInt& command, const LocalFrame* local) {
  const double x = command.x, y = command.y, z = command.z;
  switch (command.frame) {
    case kLocalNed:  // in ten-thousandths of a metre, as MAVLink has it for COMMAND_INT
      return go_to({1e-4 * y, 1e-4 * x, -z}, kDoReposition);
    case kGlobal:
    case kGlobalInt:
      return read_global(1e-7 * x, 1e-7 * y, local == nullptr ? z : z - 1e-3 * local->origin.altitude, local);
    case kGlobalRelative:
    case kGlobalRelativeInt:
      return read_global(1e-7 * x, 1e-7 * y, z, local);
    default:
      return refuse(kDoReposition, "frame " + std::to_string(command.frame) +
                                       " is not read; LOCAL_NED (1), GLOBAL (0, 5) and GLOBAL_RELATIVE_ALT (3, 6) are");
  }
}

GoalMessage read(const CommandLong& command) {
  if (command.command == kPauseContinue) {
    const bool stops = command.params[0] == 0.0f;
    return {stops ? GoalMessage::Kind::kStop : GoalMessage::Kind::kContinue, {}, command.command, ""};
  }
  if (command.command == kDoReposition) {
    return refuse(command.command, "send DO_REPOSITION as COMMAND_INT: the numbers of COMMAND_LONG are a metre coarse");
  }
  return refuse(command.command, kUnknown);
}

}  // namespace

std::optional<GoalMessage> read_goal(const Frame& frame, const Sender& target, const LocalFrame* local) {
  if (frame.id == SetPositionTarget::kId) {
    const auto message = parse<SetPositionTarget>(frame);
    if (is_for(target, message.target_system, message.target_component)) return read(message);
  }
  if (frame.id == CommandInt::kId) {
    const auto message = parse<CommandInt>(frame);
    if (!is_for(target, message.target_system, message.target_component)) return {};
    if (message.command == kDoReposition) return reposition(message, local);
    return refuse(message.command, kUnknown);
  }
  if (frame.id == CommandLong::kId) {
    const auto message = parse<CommandLong>(frame);
    if (is_for(target, message.target_system, message.target_component)) return read(message);
  }
  return {};
}

}  // namespace tern_companion
