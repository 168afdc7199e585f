// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The attempts at one goal, and why they fail. Each attempt's state is changed only by the functions of its own file.
#ifndef TERN_PLANNER_ATTEMPTS_HPP
#define TERN_PLANNER_ATTEMPTS_HPP

#include <cstdint>

#include "base/math.hpp"
#include "planner/around.hpp"
#include "planner/detour.hpp"
#include "planner/follow.hpp"
#include "planner/goal_free.hpp"
#include "planner/legs.hpp"
#include "planner/moving.hpp"
#include "planner/nearest_point.hpp"
#include "planner/stop_first.hpp"
#include "tern/status.hpp"

namespace tern {

/// What the current plan does about an end in motion. The numbers are those of Diagnostics::detours.
enum class Attempt : std::int32_t {
  kDirect = 0,     ///< nothing
  kDetour = 1,     ///< leads the path along the motion first
  kStopFirst = 2,  ///< stops first, or arrives by one curve
  kFollow = 3,     ///< begins with the remainder of the previous plan
};

constexpr std::int32_t detours_of(Attempt attempt) noexcept {
  return static_cast<std::int32_t>(attempt);
}

struct Attempts {
  Attempt current;
  Detour detour;
  Follow follow;
  StopFirst stop_first;
  NearestPoint nearest;
  Waiting waiting;
  Around around;
};

/// s: a plan that waits is of use if it takes no longer. Around things, it takes the place of one that was found; and a
/// remainder that leads to the goal would take its own.
inline double longest_of(const Around& around, const Follow& follow) noexcept {
  if (!around.is_active) return __builtin_inf();
  const double longest = around.found + kWorthWaiting * (around.found - around.alone);
  return follow.proven ? smaller(longest, follow.proven_duration) : longest;
}

/// Why there is no plan.
struct Failure {
  Stage stage;
  Status status;
  std::int32_t via;  ///< the via at fault, or kNoVia
  EndFault end;      ///< if the status is about an end that joins no voxel
};

}  // namespace tern

#endif
