// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What yaw plans of a flight are made for, what they cost, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/flight_room.hpp"
#include "support/numbers.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Flying;
using tern_test::kInfinity;
using tern_test::kNan;

FlightYaw yaw_of(FlightYawMode mode, double acceleration = 5.0) {
  FlightYaw yaw{};
  yaw.mode = mode;
  yaw.acceleration_max = acceleration;
  yaw.start = {1.0, 0.0};
  yaw.heading = {0.0, 1.0};
  return yaw;
}

FlightSpec turning(double rate, std::uint32_t work_per_tick = 4000) {
  FlightSpec spec = FlightRoom::flight_spec(work_per_tick);
  spec.yaw_rate = rate;
  return spec;
}

/// The heading at rest is read once; what a mode does not read may be anything.
TEST(FlightNose, HeadingsThatPointNowhereAreRefused) {
  for (const Heading& bad : {Heading{kNan, 1.0}, Heading{1.0, kNan}, Heading{kInfinity, 1.0}, Heading{0.0, -kInfinity},
                             Heading{0.0, 0.0}, Heading{-0.0, 0.0}}) {
    FlightRoom room;
    const bool is_finite = std::isfinite(bad.cosine) && std::isfinite(bad.sine);
    const Status refused = is_finite ? Status::kInvalidArgument : Status::kNonFiniteInput;
    FlightYaw yaw = yaw_of(FlightYawMode::kFixed);
    yaw.start = bad;
    EXPECT_EQ(room.flight.set_yaw(yaw), refused);
    yaw = yaw_of(FlightYawMode::kFixed);
    yaw.heading = bad;
    EXPECT_EQ(room.flight.set_yaw(yaw), refused);
    const Heading headings[] = {{1.0, 0.0}, bad, {0.0, -1.0}};
    yaw = yaw_of(FlightYawMode::kAtPoints);
    yaw.headings = headings;
    yaw.heading_count = 3;
    EXPECT_EQ(room.flight.set_yaw(yaw), refused);
    yaw.heading_count = 1;
    yaw.heading = bad;
    yaw.point = {kNan, 0.0, 0.0};
    EXPECT_EQ(room.flight.set_yaw(yaw), Status::kOk);
    yaw.start = bad;
    EXPECT_EQ(room.flight.set_yaw(yaw), Status::kOk);
    yaw.mode = FlightYawMode::kTowardsPoint;
    EXPECT_EQ(room.flight.set_yaw(yaw), Status::kNonFiniteInput);
  }
}

TEST(FlightNose, TooManyHeadingsOrNoneAreRefused) {
  FlightRoom room;
  const std::vector<Heading> headings(kMaxMissionPoints + 1, Heading{0.0, 1.0});
  FlightYaw yaw = yaw_of(FlightYawMode::kAtPoints);
  yaw.headings = headings.data();
  for (const std::int32_t count : {0, -1, kMaxMissionPoints + 1}) {
    yaw.heading_count = count;
    EXPECT_EQ(room.flight.set_yaw(yaw), Status::kInvalidArgument) << count;
  }
  yaw.heading_count = kMaxMissionPoints;
  EXPECT_EQ(room.flight.set_yaw(yaw), Status::kOk);
}

TEST(FlightNose, LimitsThatNoVehicleHasAreRefused) {
  for (const double rate : {0.009, 101.0}) {
    FlightRoom room(turning(rate));
    EXPECT_EQ(room.flight.set_yaw(yaw_of(FlightYawMode::kFixed)), Status::kLimitsInvalid) << rate;
  }
  FlightRoom room;
  for (const double acceleration : {0.009, 1001.0}) {
    EXPECT_EQ(room.flight.set_yaw(yaw_of(FlightYawMode::kFixed, acceleration)), Status::kLimitsInvalid);
  }
  EXPECT_EQ(room.flight.set_yaw(yaw_of(FlightYawMode::kFixed, kNan)), Status::kNonFiniteInput);
  EXPECT_EQ(room.flight.set_yaw(yaw_of(FlightYawMode::kFixed, 1000.0)), Status::kOk);
}

TEST(FlightNose, FieldsOfViewAreAtMostAFullTurn) {
  FlightRoom room;
  for (const double view : {-0.01, 6.2832}) {
    FlightYaw yaw = yaw_of(FlightYawMode::kFixed);
    yaw.field_of_view = view;
    EXPECT_EQ(room.flight.set_yaw(yaw), Status::kInvalidArgument) << view;
    yaw.field_of_view = 6.2831;
    EXPECT_EQ(room.flight.set_yaw(yaw), Status::kOk);
  }
}

/// At rest with a goal, the next plan needs to see its way, wherever the nose should point.
TEST(FlightNose, RestingVehiclesTurnToTheirWay) {
  FlightRoom room;
  ASSERT_EQ(room.flight.set_yaw(yaw_of(FlightYawMode::kFixed)), Status::kOk);
  FlightState& state = room.state();
  ASSERT_TRUE(room.tick_until([&] { return state.facts.rests(); }, 100));
  EXPECT_EQ(state.nose.wish_of(state.facts, state.search.look_at, false, state.report.committed).mode,
            FlightYawMode::kFixed);
  room.flight.set_goal({8.125, 0.125, 1.125});
  state.search.look_at = {3.0, -4.0, 1.0};
  const NoseWish wish = state.nose.wish_of(state.facts, state.search.look_at, false, state.report.committed);
  EXPECT_EQ(wish.mode, FlightYawMode::kTowardsPoint);
  EXPECT_EQ(wish.point.y, -4.0);
  state.facts.itinerary.parked = true;
  EXPECT_EQ(state.nose.wish_of(state.facts, state.search.look_at, false, state.report.committed).mode,
            FlightYawMode::kFixed);
}

/// Also on the way to a place from where something is to be seen.
TEST(FlightNose, VehiclesOnTheWayToALookoutLookAtWhatItIsFor) {
  Flying room;
  FlightState& state = room.state();
  ASSERT_EQ(room.flight.set_yaw(yaw_of(FlightYawMode::kFixed)), Status::kOk);
  state.facts.plans.in_flight.at_target = false;
  state.search.look_at = {3.0, -4.0, 1.0};
  EXPECT_EQ(state.nose.wish_of(state.facts, state.search.look_at, false, state.report.committed).mode,
            FlightYawMode::kFixed);
  EXPECT_EQ(state.nose.wish_of(state.facts, state.search.look_at, true, state.report.committed).mode,
            FlightYawMode::kTowardsPoint);
  EXPECT_EQ(state.nose.wish_of(state.facts, state.search.look_at, true, state.report.committed).point.y, -4.0);
}

TEST(FlightNose, YawPlansInWorkAreDroppedIfTheyTurnTooSharplyNow) {
  for (const double acceleration : {4.99, 5.0}) {
    FlightRoom room(turning(2.5, 400));
    ASSERT_EQ(room.flight.set_yaw(yaw_of(FlightYawMode::kFixed, 5.0)), Status::kOk);
    room.tick();
    ASSERT_TRUE(room.state().nose.is_pending);
    ASSERT_EQ(room.flight.set_yaw(yaw_of(FlightYawMode::kFixed, acceleration)), Status::kOk);
    EXPECT_EQ(room.state().nose.is_pending, acceleration >= 5.0);
  }
}

/// A nose that takes minutes for a turn has as many pieces as there may be.
TEST(FlightNose, SlowNosesTakeAllPieces) {
  const auto pieces = [](double rate, double acceleration) {
    FlightRoom room(turning(rate));
    EXPECT_EQ(room.flight.set_yaw(yaw_of(FlightYawMode::kFixed, acceleration)), Status::kOk);
    room.tick();
    for (int k = 0; k < 100; ++k) {
      room.tick();
      EXPECT_LE(std::fabs(room.flight.yaw(room.time).yaw.rate), rate + 1e-12);
    }
    return room.state().nose.in_flight.plan.count;
  };
  EXPECT_LT(pieces(2.5, 5.0), 77);
  EXPECT_EQ(pieces(0.02, 0.02), kMaxYawPieces);
}

/// A quarter of 400 units for eight ticks pays for the points and a few iterations: it is flown as it is.
TEST(FlightNose, YawPlanThatIsNotDoneInTimeIsFlownAsItIs) {
  FlightSpec spec = turning(2.5, 400);
  spec.limits.v_max = {1.0, 1.0, 1.0};  // so that the committed plan takes more than 4 s
  FlightRoom room(spec);
  const FlightState& state = room.state();
  room.flight.set_goal({8.125, 0.125, 1.125});
  ASSERT_TRUE(room.tick_until([&] { return room.speed() > 0.5; }, 400));
  ASSERT_EQ(room.flight.set_yaw(yaw_of(FlightYawMode::kFixed)), Status::kOk);
  const std::int64_t begin = room.time + kNoseTicks * room.spec.tick;
  while (room.time + room.spec.tick < begin) {
    room.tick();
    EXPECT_TRUE(state.nose.is_pending);
    EXPECT_EQ(state.nose.waiting.begin, begin);
  }
  room.tick();
  EXPECT_FALSE(state.nose.is_pending);
  EXPECT_TRUE(state.nose.has_waiting);
  for (std::int64_t t = room.time; t < room.time + 8000000000; t += 2000000) {
    EXPECT_LE(std::fabs(room.flight.yaw(t).yaw.rate), 2.5 + 1e-12);
    EXPECT_LE(std::fabs(room.flight.yaw(t).acceleration), 5.0 + 1e-9);
  }
}

/// Points of an older mission have no say; neither have those that are passed, or come after the brake begins.
TEST(FlightNose, PointsThatWillBePassedHaveTheirHeadings) {
  const Heading headings[] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
  FlightYaw yaw = yaw_of(FlightYawMode::kAtPoints);
  yaw.headings = headings;
  yaw.heading_count = 4;
  Flying room;
  FlightState& state = room.state();
  ASSERT_EQ(room.flight.set_yaw(yaw), Status::kOk);
  state.nose.waiting.begin = state.facts.plans.in_flight.begin() + 1000000000;
  state.facts.plans.in_flight.branch = 4.0;
  state.facts.plans.in_flight.passages = 5;
  const double times[] = {0.5, 2.0, 2.0, 3.0, 4.5};
  for (int i = 0; i < 5; ++i) state.facts.plans.in_flight.passage[i] = {i, times[i]};
  const auto timed = [&] {
    YawRequest request{};
    state.nose.time_headings(state.facts, request);
    return request;
  };
  const YawRequest both = timed();
  EXPECT_EQ(both.mode, YawMode::kTimed);
  ASSERT_EQ(both.timed_count, 2);
  EXPECT_NEAR(both.timed[0].time, 1.0, 1e-9);
  EXPECT_EQ(both.timed[0].heading.sine, 1.0);
  EXPECT_NEAR(both.timed[1].time, 2.0, 1e-9);
  EXPECT_EQ(both.timed[1].heading.sine, -1.0);
  state.facts.itinerary.leg = 2;
  ++state.facts.itinerary.number;
  const YawRequest none = timed();
  EXPECT_EQ(none.mode, YawMode::kFixed);
  EXPECT_EQ(none.timed_count, 0);
  EXPECT_EQ(none.heading.cosine, -1.0);
  state.facts.itinerary.leg = 9;
  EXPECT_EQ(timed().heading.sine, -1.0);  // the last one
}

/// The nose points along x, 90 degrees of view: something unseen behind the vehicle is out of view.
TEST(FlightNose, WaitsOnlyForWhatIsOutOfViewOnTheWay) {
  Flying room;
  FlightState& state = room.state();
  state.facts.time = room.time;
  state.nose.has_unseen = true;
  const Vec3 p = room.position();
  state.nose.unseen = {p.x - 2.0, p.y, p.z};
  EXPECT_FALSE(state.nose.waits_for_nose(state.facts));  // no yaw is planned
  FlightYaw yaw = yaw_of(FlightYawMode::kTowardsUnseen);
  ASSERT_EQ(room.flight.set_yaw(yaw), Status::kOk);
  EXPECT_FALSE(state.nose.waits_for_nose(state.facts));  // no field of view
  yaw.field_of_view = 0.5 * M_PI;
  ASSERT_EQ(room.flight.set_yaw(yaw), Status::kOk);
  EXPECT_TRUE(state.nose.waits_for_nose(state.facts));
  state.nose.unseen = {p.x + 2.0, p.y + 1.9, p.z};
  EXPECT_FALSE(state.nose.waits_for_nose(state.facts));
  state.nose.unseen = {p.x + 2.0, p.y + 2.1, p.z};
  EXPECT_TRUE(state.nose.waits_for_nose(state.facts));
  state.nose.has_unseen = false;
  EXPECT_FALSE(state.nose.waits_for_nose(state.facts));
  state.nose.has_unseen = true;
  state.facts.itinerary.parked = true;
  EXPECT_FALSE(state.nose.waits_for_nose(state.facts));
  state.facts.itinerary.parked = false;
  state.facts.itinerary.has_goal = false;
  EXPECT_FALSE(state.nose.waits_for_nose(state.facts));
  state.facts.itinerary.has_goal = true;
  EXPECT_TRUE(state.nose.waits_for_nose(state.facts));
}

/// A quarter of a turn at 2.5 rad/s and 0.3 s; with a planned nose, 0.5 s for 5 rad/s^2 and eight ticks more.
TEST(FlightNose, PlannedOnesHoldEachDirectionForLonger) {
  FlightRoom room;
  FlightState& state = room.state();
  const auto sector_after = [&](double seconds) {
    return state.search.sector_at(state.facts, state.nose, state.search.look_since + nanoseconds(seconds));
  };
  EXPECT_EQ(sector_after(0.928), 0);
  EXPECT_EQ(sector_after(0.929), 1);
  EXPECT_EQ(sector_after(4 * 0.9284), kLookDirections);
  EXPECT_EQ(sector_after(4 * 0.928 + 3.0), kLookDirections);
  EXPECT_EQ(sector_after(4 * 0.929 + 3.0), kLookDirections + 1);
  FlightYaw yaw{};
  yaw.acceleration_max = 5.0;
  yaw.start = {1.0, 0.0};
  ASSERT_EQ(room.flight.set_yaw(yaw), Status::kOk);
  EXPECT_EQ(sector_after(1.508), 0);
  EXPECT_EQ(sector_after(1.509), 1);
}

}  // namespace
