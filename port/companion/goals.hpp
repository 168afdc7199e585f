// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Goals that a ground station sends to the companion: SET_POSITION_TARGET_LOCAL_NED, and the commands DO_REPOSITION
// and DO_PAUSE_CONTINUE.
#ifndef TERN_COMPANION_GOALS_HPP
#define TERN_COMPANION_GOALS_HPP

#include <cstdint>
#include <optional>
#include <string>

#include "companion/frame.hpp"
#include "companion/globe.hpp"
#include "tern/vec3.hpp"

namespace tern_companion {

/// What a message asks for.
struct GoalMessage {
  enum class Kind : std::uint8_t { kGoal, kStop, kContinue, kRefused } kind = Kind::kRefused;
  tern::Vec3 goal{};          ///< east, north, up from the local origin
  std::uint16_t command = 0;  ///< to be acknowledged; 0: it was none
  std::string reason;         ///< of a refusal
};

/// What the frame asks for, if it is for the component `target` of the system. `local`: null if its origin is not
/// known, which refuses goals by latitude and longitude.
std::optional<GoalMessage> read_goal(const Frame& frame, const Sender& target, const LocalFrame* local);

}  // namespace tern_companion

#endif
