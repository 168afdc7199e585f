// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight does, and why it rests, in words.
#include "tern/flight.hpp"

// One line a value: tables.
// clang-format off
namespace tern {

const char* flight_mode_name(FlightMode mode) noexcept {
  switch (mode) {
    case FlightMode::kRest: return "rest";
    case FlightMode::kLook: return "look";
    case FlightMode::kFly: return "fly";
    case FlightMode::kStop: return "stop";
    case FlightMode::kThreat: return "threat";
  }
  return "unknown";
}

const char* flight_reason_text(FlightReason reason) noexcept {
  switch (reason) {
    case FlightReason::kNone: return "it goes on";
    case FlightReason::kNoGoal: return "there is no goal";
    case FlightReason::kArrived: return "it is at the goal";
    case FlightReason::kNearest: return "the goal is occupied or cut off, and no way leads to a point nearer to it";
    case FlightReason::kNoProgress: return "there is no way that can be proven free, or none that leads nearer to the goal";
    case FlightReason::kHemmedIn: return "something is nearer to the vehicle than the radius, and no way leads away from it";
    case FlightReason::kViaBlocked: return "the next point of the mission is occupied or fenced";
    case FlightReason::kViaUnreachable: return "there is no way to the next point of the mission that can be proven free";
    case FlightReason::kStrays: return "it flies slower: it strays from the plan by most of the tracking margin";
    case FlightReason::kMarginExceeded: return "it strayed from the plan by more than the tracking margin, and flies slower";
    case FlightReason::kLanded: return "it stands where it was to land";
    case FlightReason::kGroundUnseen: return "it cannot land: the ground there, or what is above it, was not seen";
    case FlightReason::kGroundUneven: return "it cannot land: the ground there is not flat, or something is on it";
    case FlightReason::kGoalUnseen: return "no view shows what the way to the goal needs: it was looked at in vain, or is seen from nowhere";
    case FlightReason::kHeldUp: return "things that move have kept it from going on for a minute, without a way that can be proven";
    case FlightReason::kMapStale: return "no new frames come, and there is no way through what the map knows";
  }
  return "unknown";
}

const char* blocked_by_text(BlockedBy by) noexcept {
  switch (by) {
    case BlockedBy::kNothing: return "nothing that is known";
    case BlockedBy::kUnseen: return "a voxel that was not seen free yet";
    case BlockedBy::kObstacle: return "an obstacle";
    case BlockedBy::kWindow: return "the face of the map's window";
    case BlockedBy::kFence: return "a fence";
    case BlockedBy::kTrack: return "something that moves";
  }
  return "unknown";
}

}  // namespace tern
// clang-format on
