// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Vehicles that are measured to be off their plan.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <deque>
#include <limits>

#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;

constexpr double kMargin = 0.25;
constexpr std::int64_t kSecond = 1000000000;
constexpr std::int64_t kLongAfter = 3 * kSecond + 1;

MapSpec mapped() {
  MapSpec spec = FlightRoom::map_spec();
  spec.tracking_margin = kMargin;
  return spec;
}

/// On the way to 12 m along x, at nearly 3 m/s, off the plan along y.
struct StrayRoom : FlightRoom {
  StrayRoom() : FlightRoom(flight_spec(), {}, mapped()) {
    flight.set_goal({12.125, 0.125, 1.125});
    EXPECT_TRUE(tick_until([&] { return speed() > 2.9; }, 400));
  }
  void tick_off(double margins) {
    Vec3 measured = position();
    measured.y += margins * kMargin;
    EXPECT_EQ(flight.note_position(measured, time), Status::kOk);
    tick();
  }
  /// For so many seconds; the largest speed.
  double fly_off(double margins, double seconds) {
    double most = 0.0;
    for (int k = 0; k < 100.0 * seconds; ++k) {
      tick_off(margins);
      most = std::fmax(most, speed());
      EXPECT_NEAR(position().y, 0.125, 1e-6);
    }
    return most;
  }
};

// A margin of 1 m. The speed is halved beyond 0.6 m, and again beyond 0.8 m.
TEST(FlightStray, ShareOfTheSpeedFollowsTheMargin) {
  const auto share = [](double error) {
    Stray stray{};
    stray.note(error, 1.0, 0);
    return stray.speed_share();
  };
  EXPECT_EQ(share(0.6), 1.0);
  EXPECT_EQ(share(0.61), 0.5);
  EXPECT_EQ(share(0.8), 0.5);
  EXPECT_EQ(share(0.81), 0.25);
  EXPECT_EQ(share(1.0), 0.25);
  EXPECT_EQ(share(50.0), 0.25);
}

// From beyond the margin back to full speed in steps of 3 s, in which no error was more than 0.5, 0.4 and 0.3 m.
TEST(FlightStray, SpeedComesBackAStepAtATime) {
  Stray stray{};
  EXPECT_TRUE(stray.note(1.01, 1.0, 0));
  EXPECT_EQ(stray.reason(), FlightReason::kMarginExceeded);
  EXPECT_FALSE(stray.note(0.5, 1.0, kLongAfter - 1));
  EXPECT_EQ(stray.reason(), FlightReason::kMarginExceeded);
  stray.note(0.5, 1.0, kLongAfter);
  EXPECT_EQ(stray.reason(), FlightReason::kStrays);
  EXPECT_EQ(stray.speed_share(), 0.25);
  stray.note(0.41, 1.0, 2 * kLongAfter);
  EXPECT_EQ(stray.speed_share(), 0.25);
  stray.note(0.39, 1.0, 3 * kLongAfter);
  EXPECT_EQ(stray.speed_share(), 0.5);
  stray.note(0.29, 1.0, 4 * kLongAfter);
  EXPECT_EQ(stray.speed_share(), 1.0);
  EXPECT_EQ(stray.reason(), FlightReason::kNone);
}

TEST(FlightStray, LimitsOfSpeedAloneAreShared) {
  Stray stray{};
  stray.note(0.7, 1.0, 0);
  Limits full{{3.0, 2.0, 1.0}, {6.0, 6.0, 6.0}};
  full.v_min.z = -0.5;
  full.v_horizontal = 2.5;
  full.j_max = {20.0, 20.0, 20.0};
  Limits half = full;
  half.v_max = {1.5, 1.0, 0.5};
  half.v_min.z = -0.25;
  half.v_horizontal = 1.25;
  const Limits left = stray.limits(full);
  EXPECT_EQ(std::memcmp(&left, &half, sizeof left), 0);
}

TEST(FlightStray, BrakesAlongThePathAndFliesOnSlower) {
  for (const double margins : {0.7, 0.9}) {
    const double left = margins < 0.8 ? 1.5 : 0.75;
    StrayRoom room;
    room.fly_off(margins, 1.4);
    EXPECT_EQ(room.report.reason, FlightReason::kStrays);
    EXPECT_EQ(room.report.speed_share, left / 3.0);
    EXPECT_NEAR(room.report.stray, margins * kMargin, 1e-6);
    const double flown = room.fly_off(margins, 0.8);
    EXPECT_GT(flown, 0.8 * left);
    EXPECT_LT(flown, 1.001 * left);
    EXPECT_LT(room.fly_off(0.1, 2.9), 1.001 * left);
    EXPECT_GT(room.fly_off(0.1, 1.0), 1.2 * left);  // 3 s after the last error that was not small
    while (room.report.reason != FlightReason::kArrived && room.time < 40 * kSecond) room.tick_off(0.1);
    EXPECT_NEAR(room.position().x, 12.125, 1e-6);
  }
}

/// It never comes to rest for that.
TEST(FlightStray, SlowerPlanTakesOverFromTheBrake) {
  StrayRoom room;
  double least = 3.0;
  for (int k = 0; k < 200; ++k) {
    room.tick_off(0.7);
    least = std::fmin(least, room.speed());
  }
  EXPECT_GT(least, 0.5);
}

TEST(FlightStray, SaysThatTheMarginIsExceeded) {
  StrayRoom room;
  room.tick_off(1.01);
  EXPECT_EQ(room.report.reason, FlightReason::kMarginExceeded);
  EXPECT_EQ(room.report.speed_share, 0.25);
}

/// Reasons to rest stay what they are.
TEST(FlightStray, SaysNothingAtRest) {
  StrayRoom room;
  room.fly_off(0.7, 1.0);
  room.flight.stop();
  ASSERT_TRUE(room.tick_until([&] { return room.report.mode == FlightMode::kRest; }, 400));
  room.tick_off(2.0);
  EXPECT_EQ(room.report.reason, FlightReason::kNoGoal);
  EXPECT_EQ(room.report.speed_share, 0.25);
}

TEST(FlightStray, WithoutAMarginNothingIsSlower) {
  FlightRoom room;
  room.flight.set_goal({8.125, 0.125, 1.125});
  ASSERT_TRUE(room.tick_until([&] { return room.speed() > 2.5; }, 400));
  EXPECT_EQ(room.flight.note_position({0.0, 0.0, 0.0}, room.time), Status::kOk);
  room.tick();
  EXPECT_GT(room.report.stray, 1.0);
  EXPECT_EQ(room.report.reason, FlightReason::kNone);
}

/// Also just after another plan has taken over, whose beginning is later.
TEST(FlightStray, LatePositionsAreHeldAgainstThePlanOfTheirTime) {
  for (const int ticks : {2, 9}) {
    StrayRoom room;
    std::deque<Vec3> flown;
    const std::uint32_t before = room.report.committed;
    for (int k = 0; k < 300; ++k) {
      flown.push_back(room.position());
      const std::int64_t then = room.time - ticks * room.spec.tick;
      const Vec3& measured = flown[static_cast<std::size_t>(k < ticks ? 0 : k - ticks)];
      if (k >= ticks) room.flight.note_position(measured, then);
      if (k % 60 == 30) room.flight.set_goal({12.125, k % 120 == 30 ? 6.125 : -6.125, 1.125});
      room.tick();
      EXPECT_LT(room.report.stray, 3e-3) << k;
    }
    EXPECT_GT(room.report.committed, before + 3);
  }
}

TEST(FlightStray, PositionsFromLongAgoMeanNothing) {
  StrayRoom room;
  room.flight.set_goal({0.125, 8.125, 1.125});
  const std::uint32_t before = room.report.committed;
  ASSERT_TRUE(room.tick_until([&] { return room.report.committed > before; }, 400));
  ASSERT_TRUE(room.tick_until([&] { return !room.state().facts.plans.has_waiting; }, 400));
  const std::int64_t begin = room.state().facts.plans.in_flight.begin();
  EXPECT_EQ(room.flight.note_position({0.0, 0.0, 0.0}, begin - kSecond / 5), Status::kOk);
  room.tick();
  EXPECT_EQ(room.report.stray, 0.0);
}

TEST(FlightStray, RefusesWhatIsNoPosition) {
  EXPECT_EQ(Flight{}.note_position({0.0, 0.0, 0.0}, 0), Status::kInvalidArgument);
  FlightRoom room;
  EXPECT_EQ(room.flight.note_position({0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}, 0),
            Status::kNonFiniteInput);
}

/// A vehicle that keeps within 60 % of the margin flies the same bits as one that nobody measures.
TEST(FlightStray, ChangesNothingWithinMostOfTheMargin) {
  StrayRoom measured;
  StrayRoom unmeasured;
  for (int k = 0; k < 300; ++k) {
    measured.tick_off(0.55);
    unmeasured.tick();
    const Command a = measured.flight.command(measured.time);
    const Command b = unmeasured.flight.command(unmeasured.time);
    ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << k;
  }
}

/// Something comes into the way of a vehicle that slows down: the threat is braked for.
TEST(FlightStray, ThreatsComeFirst) {
  StrayRoom room;
  room.tick_off(0.7);
  const Vec3 p = room.position();
  room.mark({{p.x + 3.0, -4.0, -2.0}, {p.x + 3.5, 4.0, 4.0}});
  double nearest = 10.0;
  for (int k = 0; k < 300; ++k) {
    room.tick_off(0.7);
    if (room.position().x < p.x + 3.0) nearest = std::fmin(nearest, p.x + 3.0 - room.position().x);
  }
  EXPECT_GE(nearest, FlightRoom::kRadius + kMargin - 1e-6);
}

}  // namespace
