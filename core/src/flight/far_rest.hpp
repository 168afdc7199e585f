// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight that rests says of its near goal.
#ifndef TERN_FLIGHT_FAR_REST_HPP
#define TERN_FLIGHT_FAR_REST_HPP

#include <cstdint>

#include "tern/flight_report.hpp"

namespace tern {

enum class NearGoalEnd : std::uint8_t {
  kNone = 0,  ///< the flight goes on, has arrived, or was not on its way to a near goal
  kForNow,    ///< what keeps it may pass, and says nothing of the way: no cell is closed for it
  kForGood,   ///< the world is in the way
};

/// For every reason. The work that a plan takes does not pass: the same map takes as much again.
constexpr NearGoalEnd end_of_near_goal(FlightReason reason) noexcept {
  switch (reason) {
    case FlightReason::kNearest:
    case FlightReason::kNoProgress:
    case FlightReason::kViaBlocked:
    case FlightReason::kViaUnreachable:
    case FlightReason::kGoalUnseen:
      return NearGoalEnd::kForGood;
    case FlightReason::kHemmedIn:  // by what is beside the vehicle, wherever the way leads
    case FlightReason::kMapStale:
    case FlightReason::kHeldUp:
      return NearGoalEnd::kForNow;
    case FlightReason::kNone:
    case FlightReason::kNoGoal:
    case FlightReason::kArrived:
    case FlightReason::kStrays:
    case FlightReason::kMarginExceeded:
    case FlightReason::kLanded:
    case FlightReason::kGroundUnseen:
    case FlightReason::kGroundUneven:
      break;
  }
  return NearGoalEnd::kNone;
}

/// None unless the flight rests.
constexpr NearGoalEnd end_of_near_goal(const FlightReport& flight) noexcept {
  return flight.mode == FlightMode::kRest ? end_of_near_goal(flight.reason) : NearGoalEnd::kNone;
}

}  // namespace tern

#endif
