// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What PX4 and ArduPilot each call the mode in which they follow setpoints, and what they ask for.
#ifndef TERN_COMPANION_MODE_RULES_HPP
#define TERN_COMPANION_MODE_RULES_HPP

#include <cstdint>

#include "companion/globe.hpp"
#include "companion/messages.hpp"

namespace tern_companion {

struct ModeRules {
  std::uint8_t autopilot;  ///< as in HEARTBEAT
  const char* name;
  const char* mode_name;
  /// The mode in HEARTBEAT::custom_mode, where these bits are.
  std::uint32_t mode, mask;
  /// The second and third parameter of MAV_CMD_DO_SET_MODE.
  float main_mode, sub_mode;
  /// PX4 takes the mode only after it saw setpoints for a second, and ignores them until then. ArduPilot needs none.
  bool streams_before;
  /// It says in EXTENDED_SYS_STATE whether it flies. ArduPilot says so in HEARTBEAT::system_status.
  bool says_landed;
  /// ODOMETRY with a counter of resets; otherwise ATTITUDE_QUATERNION and LOCAL_POSITION_NED.
  bool has_odometry;
  /// How it draws the globe in its local frame.
  Projection projection;

  bool is_in(const Heartbeat& heartbeat) const {
    return (heartbeat.base_mode & kCustomModeFlag) != 0 && (heartbeat.custom_mode & mask) == mode;
  }
};

constexpr ModeRules kPx4Rules = {kPx4, "PX4", "offboard", 6u << 16, 0xFFu << 16,           6.0f,
                                 0.0f, true,  true,       true,     Projection::kAzimuthal};
constexpr ModeRules kArdupilotRules = {kArdupilot, "ArduPilot", "guided", 4u,    0xFFFFFFFFu,      4.0f,
                                       0.0f,       false,       false,    false, Projection::kFlat};

/// Null for autopilots that are not known.
inline const ModeRules* rules_of(std::uint8_t autopilot) {
  if (autopilot == kPx4) return &kPx4Rules;
  return autopilot == kArdupilot ? &kArdupilotRules : nullptr;
}

}  // namespace tern_companion

#endif
