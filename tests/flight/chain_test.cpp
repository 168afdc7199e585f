// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights in a chain of keep-ins for a while: a vehicle goes on to the next one before the one around it ends.
#include "flight/chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/math.hpp"
#include "base/work.hpp"
#include "flight/closing.hpp"
#include "flight/zone_flight.hpp"
#include "support/random.hpp"
#include "tern/fence.hpp"

namespace {

using namespace tern;
using tern_test::ZoneFlight;
using tern_test::Zones;

constexpr double kForEver = 1e6;
constexpr std::int64_t kLongTick = 50000000;  // flights of minutes

/// The vehicle's own link, and three that meet it beyond x = 3.
struct Branches {
  Branches() {
    zones.add(FenceKind::kKeepIn, {{-3.0, -3.0, -3.0}, {4.0, 3.0, 5.0}}, -1.0, 20.0);
    zones.add(FenceKind::kKeepIn, {{3.0, -9.0, -3.0}, {5.0, 9.0, 5.0}}, 15.0, 40.0);
    zones.add(FenceKind::kKeepIn, {{2.0, -3.0, -3.0}, {5.0, 0.0, 5.0}}, 10.0, 30.0, 0.5);
    zones.add(FenceKind::kKeepIn, {{-9.0, -6.0, -3.0}, {9.0, -2.0, 5.0}}, 25.0, kForEver);
    zones.add(FenceKind::kKeepIn, {{3.5, 0.0, -3.0}, {5.0, 3.0, 5.0}}, 20.5, kForEver);
  }
  Zones zones;
};

TEST(FlightChain, WaysLeadToTheLinksAfterWhichTheVehicleMayStayLongest) {
  const Branches branches;
  ZoneFlight room(branches.zones);
  const FlightFacts& facts = room.state().facts;
  Work work{100000};
  const WaysOn ways = ways_on(facts, room.start, 0, work);
  ASSERT_EQ(ways.count, 2);  // the last one begins too late to go there
  // Both lead to the last but one, which never ends.
  EXPECT_EQ(ways.way[0].to, 1);
  EXPECT_EQ(ways.way[1].to, 2);
  for (int k = 0; k < 2; ++k) {
    const WayOn& way = ways.way[k];
    EXPECT_EQ(way.from, 0);
    EXPECT_EQ(way.until, 20.0);
    EXPECT_NEAR(way.lasts, kForEver, 1e-6);
  }
  Vec3 found;
  ASSERT_TRUE(place_on(facts, ways.way[0], room.start, found, work));
  EXPECT_LT(length(found - Vec3{3.5, 0.125, 1.125}), 1e-9);  // two voxels behind the face
  ASSERT_TRUE(place_on(facts, ways.way[1], room.start, found, work));
  EXPECT_LT(length(found - Vec3{2.5, -0.5, 1.125}), 1e-9);
}

TEST(FlightChain, NoWayLeadsOnWhereNothingLastsLonger) {
  Zones zones;
  zones.add(FenceKind::kKeepIn, {{-3.0, -3.0, -3.0}, {4.0, 3.0, 5.0}}, -1.0, 20.0);
  zones.add(FenceKind::kKeepIn, {{-1.0, -3.0, -3.0}, {4.0, 3.0, 5.0}}, 19.0, 30.0);
  zones.add(FenceKind::kKeepIn, {{3.0, -3.0, -3.0}, {9.0, 3.0, 5.0}}, 0.0, 30.0);
  zones.add(FenceKind::kKeepIn, {{8.0, -3.0, -3.0}, {9.0, 3.0, 5.0}}, 30.1, 90.0);
  ZoneFlight room(zones);
  Work work{100000};
  EXPECT_EQ(ways_on(room.state().facts, room.start, 0, work).count, 0);
  EXPECT_EQ(ways_on(room.state().facts, {-2.0, 0.0, 1.125}, 0, work).count, 2);  // that place ends at 20 s
  EXPECT_EQ(ways_on(room.state().facts, {-9.0, 0.0, 1.125}, 0, work).count, 0);  // outside
}

/// Links that only touch are passed through their common face.
TEST(FlightChain, LinksThatTouchMeet) {
  Zones zones;
  zones.add(FenceKind::kKeepIn, {{-3.0, -3.0, -3.0}, {4.0, 3.0, 5.0}}, -1.0, 20.0);
  zones.add(FenceKind::kKeepIn, {{4.0, -3.0, -3.0}, {9.0, 3.0, 5.0}}, 0.0, 30.0);
  zones.add(FenceKind::kKeepIn, {{-20.0, -2.5, -30.0}, {20.0, 20.0, 50.0}}, 0.0, 0.0);
  ZoneFlight room(zones);
  Work work{100000};
  const WaysOn ways = ways_on(room.state().facts, room.start, 0, work);
  ASSERT_EQ(ways.count, 1);
  Vec3 found;
  ASSERT_TRUE(place_on(room.state().facts, ways.way[0], room.start, found, work));
  EXPECT_LT(length(found - Vec3{4.0, 0.125, 1.125}), 1e-9);
}

TEST(FlightChain, AVehicleGoesOnBeforeItsLinkEnds) {
  const Branches branches;
  ZoneFlight room(branches.zones, kLongTick);
  room.flight.set_goal(room.start);
  EXPECT_TRUE(room.fly_to(10.0));
  EXPECT_TRUE(room.is_at(room.start));
  EXPECT_EQ(room.report.reason, FlightReason::kArrived);
  EXPECT_TRUE(room.fly_to(45.0));
}

/// A goal in a link that ends is flown to, if there is time to come back, and left again.
TEST(FlightChain, ALinkThatEndsIsLeftAgain) {
  for (const double ends : {30.0, 8.0}) {
    Zones zones;
    zones.add(FenceKind::kKeepIn, {{-3.0, -3.0, -3.0}, {4.0, 3.0, 5.0}}, -1.0, kForEver);
    zones.add(FenceKind::kKeepIn, {{2.0, -3.0, -3.0}, {9.0, 3.0, 5.0}}, -1.0, ends);
    ZoneFlight room(zones, kLongTick);
    const Vec3 goal{8.125, 0.125, 1.125};
    room.flight.set_goal(goal);
    EXPECT_TRUE(room.fly_to(7.0));
    EXPECT_EQ(room.is_at(goal), ends > 8.0);
    EXPECT_TRUE(room.fly_to(32.0));
  }
}

/// Along a random way, one link a leg. Each is there for long enough to fly through it.
Zones random_chain(tern_test::Random& random) {
  Zones zones;
  Vec3 from{0.125, 0.125, 0.0};
  double ends = random.real(25.0, 40.0);
  double begins = -1.0;
  const int count = random.integer(2, 5);
  for (int k = 0; k < count; ++k) {
    const Vec3 to{random.real(-10.0, 10.0), random.real(-10.0, 10.0), 0.0};
    const double wide = random.real(0.75, 2.0);
    Box box;
    box.lower = {std::min(from.x, to.x) - wide, std::min(from.y, to.y) - wide, -9.0};
    box.upper = {std::max(from.x, to.x) + wide, std::max(from.y, to.y) + wide, 9.0};
    zones.add(FenceKind::kKeepIn, box, begins, k + 1 < count ? ends : kForEver, random.real(0.0, 0.3));
    begins = ends - random.real(8.0, 15.0);
    ends = begins + random.real(30.0, 45.0);
    from = to;
  }
  return zones;
}

/// Wherever its goal is, the vehicle is in a link that holds at all times.
TEST(FlightChain, RandomChainsAreNeverLeft) {
  tern_test::Random random(4402);
  const int count = tern_test::scaled(6);
  for (int k = 0; k < count; ++k) {
    const Zones zones = random_chain(random);
    ZoneFlight room(zones, kLongTick);
    const Box& last =
        zones.boxes[static_cast<std::size_t>(random.integer(0, static_cast<int>(zones.boxes.size()) - 1))];
    room.flight.set_goal({random.real(last.lower.x, last.upper.x), random.real(last.lower.y, last.upper.y), 1.125});
    EXPECT_TRUE(room.fly_to(1e-9 * static_cast<double>(zones.list.back().from) + 20.0))
        << k << " at " << 1e-9 * static_cast<double>(room.time) << " " << room.position().x << " " << room.position().y;
  }
}

}  // namespace
