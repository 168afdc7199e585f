// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a contact is called, and which broken assumption its reason names.
#include "host/flight/flight_contact.hpp"

#include <gtest/gtest.h>

#include <string>

namespace {

using tern_host::FlightContact;
using tern_host::FlightEnding;
using tern_host::FlightErrors;

constexpr FlightErrors kWithinMargins{0.1, 0.1, 0.05, 0.05};

TEST(FlightContact, WithTheStillWorldIsACollision) {
  FlightContact contact;
  contact.speed = 1.25;
  const FlightEnding ending = judge_contact(kWithinMargins, contact);
  EXPECT_EQ(ending.status, "collision");
  EXPECT_EQ(ending.reason, "the body touched something at 1.25 m/s");
  EXPECT_EQ(contact.broken_assumption, "");
}

TEST(FlightContact, SaysThatAMarginWasExceeded) {
  FlightContact contact;
  FlightErrors errors = kWithinMargins;
  errors.tracking = 0.2131;
  EXPECT_NE(
      judge_contact(errors, contact).reason.find("tracking error was up to 0.213 m, and tracking_margin is 0.1 m"),
      std::string::npos);
  EXPECT_EQ(contact.broken_assumption, "tracking_margin");
  errors.pose = 0.2;
  EXPECT_NE(judge_contact(errors, contact).reason.find("up to 0.200 m off, and pose_margin is 0.05 m"),
            std::string::npos);
  EXPECT_EQ(contact.broken_assumption, "pose_margin");
}

/// With something that appeared, at 2 m/s; an immediate brake at 1.9 m/s.
FlightContact met() {
  FlightContact contact;
  contact.with_appeared = true;
  contact.threat.shown = contact.threat.announced = true;
  contact.threat.speed = 2.0;
  contact.threat.brake_speed = 1.9;
  contact.threat.announced_speed = 2.2;
  contact.threat.tolerance = 0.2;
  return contact;
}

std::string status_of(FlightContact contact) {
  const std::string status = judge_contact(kWithinMargins, contact).status;
  EXPECT_EQ(contact.broken_assumption, "still_world");
  return status;
}

TEST(FlightContact, WithWhatAppearedIsAThreatWhereAllPromisesWereKept) {
  EXPECT_EQ(status_of(met()), "threat");
  FlightContact contact = met();
  contact.threat.brake_speed = 1.7;
  EXPECT_EQ(status_of(contact), "invariant");
  contact = met();
  contact.threat.announced_speed = 1.7;
  EXPECT_EQ(status_of(contact), "invariant");
  contact = met();
  contact.threat.announced = false;
  EXPECT_EQ(status_of(contact), "invariant");
  contact.threat.shown = false;
  EXPECT_EQ(status_of(contact), "collision");
}

}  // namespace
