// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights among fences for a while: across zones that open and close, out of one that is about to begin, and what a
// vehicle that cannot leave does.

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "base/math.hpp"
#include "base/work.hpp"
#include "flight/closing.hpp"
#include "flight/zone_flight.hpp"
#include "support/flight_room.hpp"
#include "support/random.hpp"
#include "tern/fence.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::gap;
using tern_test::ZoneFlight;
using tern_test::Zones;

const Box kWall{{3.0, -20.0, -3.0}, {5.0, 20.0, 5.0}};
const Vec3 kBehind{8.125, 0.125, 1.125};

TEST(FlightWindows, AZoneThatOpensIsWaitedForAndCrossed) {
  Zones zones;
  zones.add(FenceKind::kKeepOut, kWall, 0.0, 20.0);
  ZoneFlight room(zones);
  room.flight.set_goal(kBehind);
  EXPECT_TRUE(room.fly_to(19.0));
  EXPECT_EQ(room.report.reason, FlightReason::kNone);
  EXPECT_TRUE(room.fly_to(26.0));
  EXPECT_EQ(room.report.reason, FlightReason::kArrived);
  EXPECT_TRUE(room.is_at(kBehind));
}

/// Plans wait for a minute at most; the flight, for as long as it takes.
TEST(FlightWindows, TheReportNamesAZoneThatIsClosedForLong) {
  Zones zones;
  zones.add(FenceKind::kKeepOut, kWall, 0.0, 100.0);
  ZoneFlight room(zones);
  room.flight.set_goal(kBehind);
  EXPECT_TRUE(room.fly_to(30.0));
  EXPECT_EQ(room.report.reason, FlightReason::kNone);
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kFence);
  EXPECT_EQ(room.report.blocked_fence, 0);
  EXPECT_TRUE(room.fly_to(110.0));
  EXPECT_TRUE(room.is_at(kBehind));
}

TEST(FlightWindows, AZoneThatClosesIsCrossedBeforeOrAfter) {
  for (const double closes : {30.0, 1.5}) {
    Zones zones;
    zones.add(FenceKind::kKeepOut, kWall, closes, 50.0, 0.25);
    ZoneFlight room(zones);
    room.flight.set_goal(kBehind);
    EXPECT_TRUE(room.fly_to(10.0));
    EXPECT_EQ(room.report.reason == FlightReason::kArrived, closes > 10.0);
    EXPECT_TRUE(room.fly_to(58.0));
    EXPECT_TRUE(room.is_at(kBehind)) << closes;
  }
}

TEST(FlightWindows, AVehicleLeavesAPlaceBeforeItIsClosedAndComesBack) {
  Zones zones;
  zones.add(FenceKind::kKeepOut, {{5.0, -3.0, -3.0}, {11.0, 3.0, 5.0}}, 30.0, 40.0);
  ZoneFlight room(zones);
  room.flight.set_goal(kBehind);
  EXPECT_TRUE(room.fly_to(10.0));
  EXPECT_EQ(room.report.reason, FlightReason::kArrived);
  EXPECT_EQ(room.flight.rest_clear_until(), 30000000000);
  EXPECT_TRUE(room.fly_to(35.0));
  EXPECT_FALSE(room.is_at(kBehind));
  EXPECT_EQ(room.flight.rest_clear_until(), INT64_MAX);
  EXPECT_TRUE(room.fly_to(50.0));
  EXPECT_EQ(room.report.reason, FlightReason::kArrived);
  EXPECT_TRUE(room.is_at(kBehind));
}

TEST(FlightWindows, AVehicleThatWasStoppedStays) {
  Zones zones;
  zones.add(FenceKind::kKeepOut, {{-3.0, -3.0, -3.0}, {3.0, 3.0, 5.0}}, 5.0, 9.0);
  ZoneFlight room(zones);
  EXPECT_FALSE(room.fly_to(8.0));
  EXPECT_TRUE(room.is_at(room.start));
  room.flight.set_goal(kBehind);
  for (int k = 0; k < 1200; ++k) room.tick();
  EXPECT_TRUE(room.is_at(kBehind));
}

TEST(FlightWindows, AChainOfKeepInsIsFlownFromLinkToLink) {
  Zones zones;
  zones.add(FenceKind::kKeepIn, {{-3.0, -3.0, -3.0}, {4.0, 3.0, 5.0}}, -1.0, 20.0);
  zones.add(FenceKind::kKeepIn, {{2.0, -3.0, -3.0}, {12.0, 3.0, 5.0}}, 10.0, 1000.0);
  ZoneFlight room(zones);
  room.flight.set_goal(kBehind);
  EXPECT_TRUE(room.fly_to(30.0));
  EXPECT_TRUE(room.is_at(kBehind));
}

/// No keep-in begins any more: nothing is left to wait for.
TEST(FlightWindows, AChainThatHasEndedIsGivenUp) {
  Zones zones;
  zones.add(FenceKind::kKeepIn, {{-3.0, -3.0, -3.0}, {4.0, 3.0, 5.0}}, -1.0, 5.0);
  zones.add(FenceKind::kKeepIn, {{-3.0, -3.0, -3.0}, {4.0, 3.0, 5.0}}, 4.0, 10.0);
  ZoneFlight room(zones);
  EXPECT_TRUE(room.fly_to(9.5));
  room.flight.set_goal(kBehind);
  EXPECT_EQ(room.fly(), FlightReason::kNoProgress);
  EXPECT_EQ(room.report.blocked_by, BlockedBy::kFence);
  EXPECT_TRUE(room.is_at(room.start));
}

/// One begins late: until then it may be flown to.
TEST(FlightWindows, AChainThatGoesOnLaterIsWaitedFor) {
  Zones zones;
  zones.add(FenceKind::kKeepIn, {{-3.0, -3.0, -3.0}, {4.0, 3.0, 5.0}}, -1.0, 200.0);
  zones.add(FenceKind::kKeepIn, {{2.0, -3.0, -3.0}, {12.0, 3.0, 5.0}}, 90.0, 1000.0);
  ZoneFlight room(zones);
  room.flight.set_goal(kBehind);
  EXPECT_TRUE(room.fly_to(89.0));
  EXPECT_EQ(room.report.reason, FlightReason::kNone);
  EXPECT_TRUE(room.fly_to(110.0));
  EXPECT_TRUE(room.is_at(kBehind));
}

TEST(FlightWindows, AClockThatIsSetMovesThem) {
  Zones zones;
  zones.add(FenceKind::kKeepOut, kWall, 1000.0, 1010.0);
  ZoneFlight room(zones);
  room.flight.set_goal(kBehind);
  room.time = 1002000000000;
  EXPECT_EQ(room.flight.set_clock(room.time), Status::kOk);
  EXPECT_TRUE(room.fly_to(1009.0));
  EXPECT_LT(room.position().x, 3.0);
  EXPECT_TRUE(room.fly_to(1020.0));
  EXPECT_TRUE(room.is_at(kBehind));
}

TEST(FlightWindows, AStartInAZoneThatHoldsIsRefused) {
  const Box around{{-1.0, -1.0, -1.0}, {1.0, 1.0, 3.0}};
  struct Case {
    double from;
    double until;
    Status status;
  };
  for (const Case& c : {Case{-5.0, 5.0, Status::kStartFenced}, Case{1.0, 5.0, Status::kOk},
                        Case{5.0, 1.0, Status::kInvalidArgument}, Case{-9.2e9, 9.2e9, Status::kStartFenced},
                        Case{9.0e9, 9.2e9, Status::kOk}, Case{-9.2e9, -9.0e9, Status::kOk}}) {
    Zones zones;
    zones.add(FenceKind::kKeepOut, around, c.from, c.until);
    FlightRoom room;
    FlightRefusal refusal;
    EXPECT_EQ(room.flight.start(ZoneFlight::with(zones), room.map(), room.planner, room.words.data(), room.words.size(),
                                room.start, 0, &refusal),
              c.status)
        << c.from;
    EXPECT_EQ(refusal.fence, c.status == Status::kOk ? kNoFence : 0);
  }
}

TEST(FlightWindows, AGoalMayBeClosedForAWhile) {
  Zones zones;
  zones.add(FenceKind::kKeepOut, {{7.0, -1.0, -1.0}, {9.0, 1.0, 3.0}}, 0.0, 20.0);
  ZoneFlight room(zones);
  EXPECT_EQ(room.flight.check_goal(kBehind), Status::kOk);
  room.flight.set_goal(kBehind);
  EXPECT_TRUE(room.fly_to(30.0));
  EXPECT_TRUE(room.is_at(kBehind));
}

/// A vehicle on its way is in no zone that holds, whatever opens and closes; at rest it leaves in time.
TEST(FlightWindows, RandomZonesAreNeverEnteredWhileTheyHold) {
  tern_test::Random random(4401);
  int arrived = 0;
  const int count = tern_test::scaled(20);
  for (int k = 0; k < count; ++k) {
    Zones zones;
    for (int z = 0; z < 6; ++z) {
      const Vec3 at{random.real(-6.0, 12.0), random.real(-8.0, 8.0), 0.0};
      const Vec3 half{random.real(0.5, 4.0), random.real(0.5, 4.0), 9.0};
      const double from = random.real(-5.0, 40.0);
      zones.add(FenceKind::kKeepOut, {at - half, at + half}, from, from + random.real(1.0, 20.0),
                random.real(0.0, 0.3));
      if (gap(zones.boxes.back(), {0.125, 0.125, 1.125}) < 1.0 && from < 12.0) zones.list.back().from += 30000000000;
      zones.list.back().until = std::max(zones.list.back().until, zones.list.back().from + std::int64_t{1000000000});
    }
    ZoneFlight room(zones);
    room.flight.set_goal({random.real(6.0, 11.0), random.real(-6.0, 6.0), 1.125});
    EXPECT_TRUE(room.fly_to(100.0)) << k << " at " << 1e-9 * static_cast<double>(room.time) << " fence "
                                    << room.broken() << " at " << room.position().x << " " << room.position().y;
    arrived += room.report.reason == FlightReason::kArrived ? 1 : 0;
  }
  EXPECT_EQ(arrived, count);
}

}  // namespace
