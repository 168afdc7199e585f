// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/flight_contact.hpp"

#include <algorithm>

#include "host/number.hpp"

namespace tern_host {
namespace {

std::string speed_of(double speed) {
  return fixed(speed, 2) + " m/s";
}

FlightEnding meets_what_appeared(const FlightContact& contact) {
  const ThreatContact& c = contact.threat;
  const std::string what =
      "the body touched what had appeared " + fixed(contact.appeared_before, 2) + " s before, at " + speed_of(c.speed);
  if (!c.shown) return {"collision", what + "; the map did not show in time that it was in the way"};
  const std::string brake = "; after an immediate brake at " + speed_of(c.brake_speed);
  if (!c.announced) return {"invariant", "threat: " + what + ", but the flight did not say so"};
  if (c.speed > c.brake_speed + c.tolerance) return {"invariant", "threat: " + what + brake};
  if (c.speed > c.announced_speed + c.tolerance) {
    return {"invariant", "threat: " + what + ", but the flight announced " + speed_of(c.announced_speed)};
  }
  return {"threat", what + brake};
}

}  // namespace

FlightEnding judge_contact(const FlightErrors& errors, FlightContact& contact) {
  if (contact.with_appeared) {
    contact.broken_assumption = "still_world";
    return meets_what_appeared(contact);
  }
  const std::string what = "the body touched something at " + speed_of(contact.speed);
  if (errors.pose_exceeded()) {
    contact.broken_assumption = "pose_margin";
    return {"collision", what + ": the estimated position was up to " + fixed(errors.pose, 3) +
                             " m off, and pose_margin is " + brief(errors.pose_margin) + " m"};
  }
  if (errors.tracking_exceeded()) {
    contact.broken_assumption = "tracking_margin";
    return {"collision", what + ": the tracking error was up to " + fixed(errors.tracking, 3) +
                             " m, and tracking_margin is " + brief(errors.tracking_margin) + " m"};
  }
  return {"collision", what};
}

}  // namespace tern_host
