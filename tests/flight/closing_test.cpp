// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ways out of keep-outs that are about to begin, and how long they take.

#include "flight/closing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>

#include "base/math.hpp"
#include "base/work.hpp"
#include "flight/zone_flight.hpp"
#include "support/flight_room.hpp"
#include "support/random.hpp"
#include "tern/fence.hpp"

namespace {

using namespace tern;
using tern_test::ZoneFlight;
using tern_test::Zones;

/// The nearest side first, and each once in a turn. Above and below, the window ends before the zone does.
TEST(FlightClosing, WaysOutLeadThroughEachFace) {
  Zones zones;
  zones.add(FenceKind::kKeepOut, {{-4.0, -2.0, -9.0}, {1.0, 6.0, 9.0}}, 30.0, 40.0);
  ZoneFlight room(zones);
  const FlightFacts& facts = room.state().facts;
  const Vec3 ways[4] = {{2.0, 0.125, 1.125}, {0.125, -3.0, 1.125}, {-5.0, 0.125, 1.125}, {0.125, 7.0, 1.125}};
  Work work{100000};
  const Operations given = work.operations();
  for (int n = 0; n < 4; ++n) {
    EXPECT_LT(length(way_out_of(facts, facts.fences[0], room.start, n, work) - ways[n]), 1e-9) << n;
    EXPECT_LT(length(way_out_of(facts, facts.fences[0], room.start, n + 4, work) - ways[n]), 1e-9) << n;
  }
  EXPECT_GE(given - work.operations(), 8 * 6 * 4 * ops::kDot * 6) << "faces by faces";
}

/// From the room's middle, each side is 15 m away with what a vehicle keeps: 2 x 5 s and 3 s. Floor and ceiling are
/// nearer, but the faces below and above are beyond them.
TEST(FlightClosing, NobodyLeavesThroughFloorOrCeiling) {
  Zones zones;
  zones.add(FenceKind::kKeepOut, {{-14.0, -14.0, -2.5}, {14.0, 14.0, 4.5}}, 12.0, 30.0);
  ZoneFlight room(zones);
  const Vec3 middle{0.0, 0.0, 1.125};
  Work work(100000);
  EXPECT_EQ(closing_fence(room.state().facts, middle, 0, 0.9, work), 0);
  EXPECT_EQ(closing_fence(room.state().facts, middle, -2000000000, 0.9, work), kNoFence);
  for (int number = 0; number < 5; ++number) {
    const Vec3 out = way_out_of(room.state().facts, zones.list[0], middle, number, work);
    EXPECT_EQ(out.z, middle.z);
    EXPECT_NEAR(std::hypot(out.x, out.y), 15.0, 1e-9);
  }
}

/// Strips of 4 m side by side: to leave one for the next one is not to leave. Behind a wall is no way out either.
TEST(FlightClosing, PiecesSideBySideAreLeftTogether) {
  Zones zones;
  for (int k = -3; k <= 3; ++k) {
    zones.add(FenceKind::kKeepOut, {{-14.0, 4.0 * k - 2.0, -20.0}, {14.0, 4.0 * k + 2.0, 20.0}}, 12.0, 30.0);
  }
  ZoneFlight room(zones);
  const Vec3 middle{0.0, 0.0, 1.125};
  Work work(100000);
  EXPECT_EQ(closing_fence(room.state().facts, middle, 0, 0.9, work), 3);
  EXPECT_EQ(closing_fence(room.state().facts, middle, -2000000000, 0.9, work), kNoFence);
  EXPECT_EQ(way_out_of(room.state().facts, zones.list[3], middle, 0, work).x, 15.0);
  room.mark({{8.0, -16.0, -2.0}, {8.5, 16.0, 4.0}});
  for (int number = 0; number < 4; ++number) {
    const Vec3 out = way_out_of(room.state().facts, zones.list[3], middle, number, work);
    EXPECT_LT(out.x, 1.0);
    EXPECT_NEAR(std::hypot(out.x, out.y), 15.0, 1e-9);
  }
}

/// The clock of one fence says nothing of the times of another. A zone that has ended is no longer in the way of those
/// who leave its neighbour; one that begins as late as the neighbour may end is.
TEST(FlightClosing, EachZoneEndsByItsOwnClock) {
  struct Case {
    double from, until, error;
    double way_out;  ///< its x
  };
  // Through the second zone, the way is 5.875 m long, and the opposite one 5.125 m.
  for (const Case& c : {Case{-9.0, -0.3, 0.1, 2.0}, Case{-9.0, -0.3, 0.4, -5.0}, Case{30.3, 40.0, 0.1, -5.0},
                        Case{30.7, 40.0, 0.1, 2.0}}) {
    Zones zones;
    zones.add(FenceKind::kKeepOut, {{-4.0, -9.0, -9.0}, {1.0, 9.0, 9.0}}, 12.0, 30.0, 0.5);
    zones.add(FenceKind::kKeepOut, {{1.0, -9.0, -9.0}, {5.0, 9.0, 9.0}}, c.from, c.until, c.error);
    ZoneFlight room(zones);
    const FlightFacts& facts = room.state().facts;
    Work work{100000};
    EXPECT_NEAR(way_out_of(facts, facts.fences[0], room.start, 0, work).x, c.way_out, 1e-9) << c.until;
  }
}

}  // namespace
