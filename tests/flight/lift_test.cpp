// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the ground straight up, and straight down to it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/flown.hpp"

namespace {

using tern::BlockedBy;
using tern::FlightReason;
using tern::Status;
using tern::Vec3;
using tern_test::Flown;

constexpr double kGround = 0.05;
constexpr double kStand = 0.15;  // of the vehicle's centre above the ground
constexpr double kTop = kGround + 0.35 + 2 * 0.2;

/// On the floor, with a column stated above it.
tern_test::FlightSettings on_the_ground() {
  tern_test::FlightSettings s;
  s.start = {0.03, -0.02, kStand};
  s.assumed = 0.0;
  s.column = {{s.start.x, s.start.y, kGround}, 1.3, 3.0};
  return s;
}

/// A flight from the floor of a world, which may land where it began.
struct FromGround : Flown {
  explicit FromGround(const tern_test::Scene& world, const tern_test::FlightSettings& s = on_the_ground())
      : Flown(world, s) {
    pads.push_back({s.start.x, s.start.y, kGround});
  }
  void land(double x, double y, double speed = 0.5) {
    pads.push_back({x, y, kGround});
    EXPECT_EQ(flight.land({x, y, kStand}, kGround, speed), Status::kOk);
  }
};

TEST(Lift, LeavesTheGroundStraightUp) {
  FromGround flown({});
  ASSERT_EQ(flown.started, Status::kOk);
  EXPECT_EQ(flown.refusal.field, tern::Field::kNone);
  ASSERT_EQ(flown.flight.set_goal({8.0, 1.0, 1.5}), Status::kOk);
  double lowest_aside = 1e9;
  while (flown.report.reason != FlightReason::kArrived && flown.time < 15000000000) {
    flown.tick();
    ASSERT_FALSE(HasFatalFailure());
    const Vec3 p = flown.position();
    if (std::hypot(p.x - 0.03, p.y + 0.02) > 1e-9) lowest_aside = std::min(lowest_aside, p.z);
    EXPECT_NE(flown.report.mode, tern::FlightMode::kThreat);
  }
  EXPECT_EQ(flown.report.reason, FlightReason::kArrived);
  EXPECT_GE(lowest_aside, kTop - 1e-6);
  EXPECT_LE(1e-9 * static_cast<double>(flown.time), 8.0);
}

TEST(Lift, NeedsAStatementOfTheGround) {
  auto s = on_the_ground();
  s.column.radius = 0.0;
  Flown flown({}, s);
  EXPECT_EQ(flown.started, Status::kStartOccupied);
  EXPECT_EQ(flown.refusal.blocked_by, BlockedBy::kUnseen);
}

/// 0.35 m and one and a half voxels.
TEST(Lift, NeedsAsMuchGroundAroundAsMayBeNear) {
  auto s = on_the_ground();
  s.column.radius = 0.64;
  EXPECT_EQ(Flown({}, s).started, Status::kStartOccupied);
  s.column.radius = 0.66;
  EXPECT_EQ(Flown({}, s).started, Status::kOk);
  s.start.x += 0.02;
  EXPECT_EQ(Flown({}, s).started, Status::kStartOccupied);
}

/// Up to the top of the way up and the radius above it.
TEST(Lift, NeedsAColumnThatIsHighEnough) {
  auto s = on_the_ground();
  s.column.height = kTop + 0.35 - kGround - 0.2;
  const Flown low({}, s);
  EXPECT_EQ(low.started, Status::kStartOccupied);
  EXPECT_EQ(low.refusal.field, tern::Field::kStartPosition);
  EXPECT_EQ(low.refusal.blocked_by, BlockedBy::kUnseen);
  EXPECT_GT(low.refusal.blocked_at.z, kTop);
  s.column.height = kTop + 0.35 - kGround + 0.2;
  EXPECT_EQ(Flown({}, s).started, Status::kOk);
}

/// Starts on the ground of a map with something marked in it.
struct MarkedStart {
  explicit MarkedStart(const tern::Box& marked) : flown({}, on_the_ground()) {
    EXPECT_EQ(flown.owned.map.mark_box(marked), Status::kOk);
    status = flown.flight.start(flown.spec, flown.owned.map, flown.planner, flown.words.data(), flown.words.size(),
                                flown.settings.start, 0, &refusal);
  }
  Flown flown;
  tern::FlightRefusal refusal;
  Status status;
};

/// The statement says what is free, but not that a hit is wrong.
TEST(Lift, NoStatementOverridesWhatWasSeen) {
  const MarkedStart above({{0.2, 0.2, 0.7}, {0.3, 0.3, 0.75}});
  EXPECT_EQ(above.status, Status::kStartOccupied);
  EXPECT_EQ(above.refusal.blocked_by, BlockedBy::kObstacle);
  EXPECT_NEAR(above.refusal.blocked_at.z, 0.7, 1e-9);
  EXPECT_EQ(MarkedStart({{0.0, 0.0, -0.1}, {0.4, 0.4, 0.04}}).status, Status::kOk) << "the ground";
  EXPECT_EQ(MarkedStart({{0.3, -0.1, 0.21}, {0.35, 0.1, 0.3}}).status, Status::kStartOccupied) << "a stone on it";
  EXPECT_EQ(MarkedStart({{0.61, -0.1, 0.21}, {0.65, 0.1, 0.3}}).status, Status::kOk) << "a stone away from it";
}

TEST(Lift, LandsWhereTheGroundWasSeen) {
  FromGround flown({});
  flown.land(9.0, 2.0);
  EXPECT_EQ(flown.fly(30.0), FlightReason::kLanded) << tern::flight_reason_text(flown.report.reason);
  EXPECT_NEAR(flown.position().x, 9.0, 1e-6);
  EXPECT_NEAR(flown.position().y, 2.0, 1e-6);
  EXPECT_NEAR(flown.position().z, kStand, 1e-6);
  // It stays, and takes off again.
  for (int k = 0; k < 100; ++k) flown.tick();
  EXPECT_EQ(flown.report.reason, FlightReason::kLanded);
  EXPECT_EQ(flown.report.mode, tern::FlightMode::kRest);
  ASSERT_EQ(flown.flight.set_goal({4.0, 0.0, 1.5}), Status::kOk);
  EXPECT_EQ(flown.fly(20.0), FlightReason::kArrived);
}

TEST(Lift, DescendsNoFasterThanAsked) {
  FromGround flown({});
  flown.land(6.0, 0.0, 0.2);
  double fastest = 0.0;
  while (flown.report.reason != FlightReason::kLanded && flown.time < 30000000000) {
    flown.tick();
    ASSERT_FALSE(HasFatalFailure());
    if (flown.position().x > 6.0 - 1e-7)
      fastest = std::max(fastest, -flown.flight.command(flown.time).sample.velocity.z);
  }
  EXPECT_EQ(flown.report.reason, FlightReason::kLanded);
  EXPECT_LE(fastest, 0.2);
  EXPECT_GE(fastest, 0.19);
}

/// What was stated of the ground holds for the way back.
TEST(Lift, LandsWhereItBegan) {
  FromGround flown({});
  ASSERT_EQ(flown.flight.set_goal({5.0, 0.0, 1.5}), Status::kOk);
  ASSERT_EQ(flown.fly(20.0), FlightReason::kArrived);
  flown.land(0.03, -0.02);
  EXPECT_EQ(flown.fly(20.0), FlightReason::kLanded) << tern::flight_reason_text(flown.report.reason);
}

/// A low stone, and one that is in the way of the point above the place.
TEST(Lift, LandsOnNoStone) {
  for (const double top : {0.25, 0.45}) {
    SCOPED_TRACE(top);
    tern_test::Scene scene;
    scene.boxes.push_back({{8.8, -0.2, 0.0}, {9.2, 0.2, top}});
    FromGround flown(scene);
    flown.land(9.1, 0.3);
    EXPECT_EQ(flown.fly(30.0), FlightReason::kGroundUneven) << tern::flight_reason_text(flown.report.reason);
    EXPECT_EQ(flown.report.blocked_by, BlockedBy::kObstacle);
    EXPECT_GT(flown.position().z, kTop - 1e-6);
  }
}

TEST(Lift, LandsAgainElsewhere) {
  FromGround flown({});
  flown.land(4.0, 1.0);
  ASSERT_EQ(flown.fly(20.0), FlightReason::kLanded);
  flown.land(8.0, 0.0);
  EXPECT_EQ(flown.fly(20.0), FlightReason::kLanded);
  EXPECT_NEAR(flown.position().x, 8.0, 1e-6);
}

/// Where it hovers, its camera does not see what is below.
TEST(Lift, LandsNowhereUnseen) {
  tern_test::FlightSettings s;
  Flown flown({}, s);
  flown.pads.push_back({0.0, 0.0, kGround});
  flown.images = tern_test::Images::kBlind;
  ASSERT_EQ(flown.flight.land({0.0, 0.0, kStand}, kGround, 0.5), Status::kOk);
  const FlightReason why = flown.fly(60.0);
  EXPECT_TRUE(why == FlightReason::kGroundUnseen || why == FlightReason::kGoalUnseen || why == FlightReason::kNearest)
      << tern::flight_reason_text(why);
  EXPECT_GT(flown.position().z, kTop - 1e-6);
}

/// A level camera sees the ground below only from aside: it looks from there first.
TEST(Lift, LooksForTheGroundBelowIt) {
  for (const double x : {0.0, 0.1, 1.5}) {
    SCOPED_TRACE(x);
    tern_test::FlightSettings s;
    s.assumed = 1.55;
    Flown flown({}, s);
    flown.pads.push_back({x, 0.0, 0.15});
    ASSERT_EQ(flown.flight.land({x, 0.0, kStand}, 0.15, 0.5), Status::kOk);
    EXPECT_EQ(flown.fly(25.0), FlightReason::kLanded) << tern::flight_reason_text(flown.report.reason);
  }
}

TEST(Lift, RefusesWhatIsNoLanding) {
  FromGround flown({});
  EXPECT_EQ(flown.flight.land({5.0, 0.0, kStand}, kGround, 0.0), Status::kInvalidArgument);
  EXPECT_EQ(flown.flight.land({5.0, 0.0, kTop + 0.01}, kGround, 0.5), Status::kInvalidArgument);
  EXPECT_EQ(flown.flight.land({NAN, 0.0, kStand}, kGround, 0.5), Status::kNonFiniteInput);
  EXPECT_EQ(flown.flight.land({5.0, 0.0, kStand}, INFINITY, 0.5), Status::kNonFiniteInput);
  EXPECT_EQ(flown.flight.land({5.0, 0.0, kStand}, kGround, NAN), Status::kNonFiniteInput);
  EXPECT_EQ(tern::Flight{}.land({5.0, 0.0, kStand}, kGround, 0.5), Status::kInvalidArgument);
}

/// Stopped on its way down, it stays there; with a goal, it climbs first.
TEST(Lift, AStopOnTheWayDownIsFollowedByAClimb) {
  FromGround flown({});
  flown.land(6.0, 0.0, 0.2);
  while (flown.time < 30000000000 && !(flown.position().x > 6.0 - 1e-7 && flown.position().z < kTop - 0.2)) {
    flown.tick();
    ASSERT_FALSE(HasFatalFailure());
  }
  ASSERT_EQ(flown.flight.stop(), Status::kOk);
  for (int k = 0; k < 200; ++k) flown.tick();
  const double stopped = flown.position().z;
  EXPECT_GT(stopped, kStand + 0.1);
  EXPECT_LT(stopped, kTop - 0.2);
  EXPECT_EQ(flown.report.reason, FlightReason::kNoGoal);
  ASSERT_EQ(flown.flight.set_goal({4.0, 1.0, 1.5}), Status::kOk);
  EXPECT_EQ(flown.fly(20.0), FlightReason::kArrived);
}

}  // namespace
