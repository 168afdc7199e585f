// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The points of a mission, and how far it has come.
#ifndef TERN_FLIGHT_ITINERARY_HPP
#define TERN_FLIGHT_ITINERARY_HPP

#include <cstdint>

#include "tern/flight.hpp"
#include "tern/via.hpp"

namespace tern {

/// How many plans must find a point blocked before it counts as unreachable. A wrong pixel does not block it for that
/// long.
constexpr int kBlockedPlans = 3;

struct Itinerary {
  Via points[kMaxMissionPoints];  ///< the last one is the goal
  PointState state[kMaxMissionPoints];
  std::int32_t count;
  std::int32_t leg;  ///< the next point
  ViaPolicy policy;
  std::int32_t suspect;  ///< the point that was last found blocked
  int suspicions;        ///< how many plans found the suspect blocked

  std::int32_t last() const noexcept { return count - 1; }
  bool is_ahead(std::int32_t point) const noexcept { return point >= leg && state[point] == PointState::kAhead; }
  /// The first point after `point` that is not skipped. The goal is never skipped.
  std::int32_t after(std::int32_t point) const noexcept {
    while (point < last() && state[++point] == PointState::kSkipped) {
    }
    return point;
  }
};

/// When a plan passes a point.
struct Passage {
  std::int32_t point;  ///< of the itinerary
  double time;         ///< seconds since the plan's beginning
};

}  // namespace tern

#endif
