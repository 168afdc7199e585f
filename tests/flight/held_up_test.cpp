// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights that things that move hold up, or push about, for long.

#include <gtest/gtest.h>

#include <cstdint>

#include "flight/balls.hpp"
#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Hunter;
using tern_test::kBallRadius;
using tern_test::seen;

constexpr Vec3 kCoveredGoal{6.125, 0.125, 1.125};

/// The vehicle is to go where a ball rests, which is ball 1.
void lay_at_goal(FlightRoom& room) {
  room.flight.set_goal(kCoveredGoal);
  Track track = seen(1, kCoveredGoal, {}, 0, 0.0);
  track.error_speed = 0.0;
  EXPECT_EQ(room.flight.update_track(track), Status::kOk);
}

// A ball that stays where the vehicle has to pass, or comes after it for ever: it gives up after a minute, and says
// why. A new goal makes it try again.
TEST(FlightTracks, GivesUpWhereThingsHoldItUpForAMinute) {
  FlightRoom room;
  lay_at_goal(room);
  EXPECT_EQ(room.fly(6500), FlightReason::kHeldUp);
  EXPECT_GT(room.time, kPatience);
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kTrack);
  EXPECT_EQ(room.flight.forget_track(1), Status::kOk);
  room.flight.set_goal(kCoveredGoal);
  EXPECT_EQ(room.fly(), FlightReason::kArrived);
}

// Hunters from four sides pin the vehicle or push it about: the flight ends.
TEST(FlightTracks, GivesUpWhereItIsPushedOrPinnedForEver) {
  FlightRoom room;
  room.flight.set_goal({12.125, 0.125, 1.125});
  Hunter hunters[4];
  for (int k = 0; k < 4; ++k) {
    const double far = k < 2 ? 3.0 : -3.0;
    hunters[k] = {{k % 2 == 0 ? far : 0.0, k % 2 == 0 ? 0.0 : far, 1.0}, {}, 6.0, 3.0};
  }
  int ticks = 0;
  for (; ticks < 10000 && !room.state().facts.itinerary.parked; ++ticks) {
    for (std::uint32_t id = 0; id < 4 && ticks % 10 == 0; ++id) {
      Track track = seen(id, hunters[id].position, hunters[id].velocity, room.time, hunters[id].acceleration);
      track.reach = hunters[id].top;
      EXPECT_EQ(room.flight.update_track(track), Status::kOk);
    }
    room.tick();
    for (Hunter& hunter : hunters) hunter.move(room.position(), 1e-9 * static_cast<double>(room.spec.tick));
  }
  EXPECT_EQ(room.report.reason, FlightReason::kHeldUp);
}

// For a minute, it waits before the ball and does not give up; it arrives once the ball is gone.
TEST(FlightTracks, WaitsForAThingAtItsGoal) {
  FlightRoom room;
  lay_at_goal(room);
  for (int k = 0; k < 1500; ++k) room.tick();
  EXPECT_EQ(room.report.reason, FlightReason::kNone);
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kTrack);
  EXPECT_GE(distance(room.position(), kCoveredGoal), FlightRoom::kRadius + kBallRadius);
  EXPECT_EQ(room.flight.forget_track(1), Status::kOk);
  EXPECT_EQ(room.fly(), FlightReason::kArrived);
}

}  // namespace
