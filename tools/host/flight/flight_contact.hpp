// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a contact says about a flight.
#ifndef TERN_HOST_FLIGHT_FLIGHT_CONTACT_HPP
#define TERN_HOST_FLIGHT_FLIGHT_CONTACT_HPP

#include <string>

#include "host/flight/threat_watch.hpp"

namespace tern_host {

/// The body touches something.
struct FlightContact {
  bool happened = false;
  double time = 0.0;   ///< seconds
  double speed = 0.0;  ///< of the body, m/s
  bool with_appeared = false;
  double appeared_before = 0.0;  ///< seconds, for how long it was there
  ThreatContact threat;
  /// The assumption of the flight's promise that did not hold: tracking_margin, pose_margin or still_world. Empty where
  /// all did, and so a defect.
  std::string broken_assumption;
};

/// How far the vehicle was off so far, metres, and the margins.
struct FlightErrors {
  double tracking, tracking_margin;
  double pose, pose_margin;
  bool tracking_exceeded() const { return tracking > tracking_margin * (1.0 + 1e-9); }
  bool pose_exceeded() const { return pose > pose_margin * (1.0 + 1e-9); }
};

/// How a flight ends.
struct FlightEnding {
  std::string status, reason;
};

/// Names the assumption that did not hold, and says what that makes of the flight: `threat` where it met what appeared
/// as announced, and no faster than after an immediate brake; `invariant` where it broke such a promise; otherwise
/// `collision`.
FlightEnding judge_contact(const FlightErrors& errors, FlightContact& contact);

}  // namespace tern_host

#endif
