// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What must be true before the companion flies, one thing after the other, and what it does once one of them ends.
#ifndef TERN_COMPANION_ENGAGEMENT_HPP
#define TERN_COMPANION_ENGAGEMENT_HPP

#include <cstdint>

namespace tern_companion {

enum class Phase : std::uint8_t {
  kNoAutopilot = 0,  ///< no heartbeat of an autopilot that is known
  kNoTime,           ///< it does not answer TIMESYNC, so stamps mean nothing
  kNoPose,           ///< no estimate, or an old one
  kNoFrames,         ///< no sensor sends
  kDisarmed,
  kOnGround,
  kOtherMode,  ///< ready: the pilot decides when
  kSettling,   ///< it has the vehicle, and holds it where it was until it rests
  kNoGoal,     ///< it holds the vehicle, and waits for a goal
  kFlying,
  kGivenUp,   ///< the vehicle strayed, or its heading jumped: it holds the place, and a person decides
  kLinkLost,  ///< the autopilot has fallen silent: the vehicle is brought to rest
  kEnding,    ///< the program is to end: likewise
};

/// Facts of one instant.
struct Facts {
  bool heartbeat = false;  ///< not older than the limit
  bool was_heard = false;  ///< there was one, ever
  bool time = false, pose = false, frames = false;
  bool armed = false, in_air = false, in_mode = false;
  bool rests = false, has_goal = false, begun = false, lost = false, ending = false;
};

/// Whether setpoints are followed, so far as the autopilot has said. A lost link does not change that: the vehicle goes
/// on following, and must be brought to rest.
inline bool has_vehicle(const Facts& f) {
  return f.was_heard && f.armed && f.in_air && f.in_mode;
}

inline Phase phase_of(const Facts& f) {
  if (has_vehicle(f) && f.ending) return Phase::kEnding;
  if (has_vehicle(f) && !f.heartbeat) return Phase::kLinkLost;
  if (has_vehicle(f) && f.lost) return Phase::kGivenUp;
  if (has_vehicle(f) && f.begun) return Phase::kFlying;
  if (!f.heartbeat) return Phase::kNoAutopilot;
  if (!f.time) return Phase::kNoTime;
  if (!f.pose) return Phase::kNoPose;
  if (!f.frames) return Phase::kNoFrames;
  if (!f.armed) return Phase::kDisarmed;
  if (!f.in_air) return Phase::kOnGround;
  if (!f.in_mode) return Phase::kOtherMode;
  if (!f.rests) return Phase::kSettling;
  return f.has_goal ? Phase::kSettling : Phase::kNoGoal;
}

inline const char* phase_text(Phase phase) {
  static const char* const kTexts[] = {
      "waits for the heartbeat of an autopilot",
      "waits for answers to TIMESYNC",
      "waits for an estimate of pose and velocity",
      "waits for frames of depth",
      "waits to be armed",
      "waits for take-off",
      "ready: switch the mode",
      "has the vehicle: holds it until it rests",
      "has the vehicle: holds it, and waits for a goal",
      "flies",
      "holds the vehicle: leave the mode and come back, or send a goal, and it flies on from here",
      "the link is lost: comes to rest",
      "is to end: comes to rest",
  };
  return kTexts[static_cast<int>(phase)];
}

}  // namespace tern_companion

#endif
