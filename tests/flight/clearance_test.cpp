// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans that wait until others agree to them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "support/flight_room.hpp"
#include "support/random.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;

constexpr Vec3 kAskedGoal{12.125, 0.125, 1.125};

FlightSpec asking(std::int64_t clearance = 300000000) {
  FlightSpec spec = FlightRoom::flight_spec();
  spec.clearance = clearance;
  return spec;
}

bool same_state(const Sample& a, const Sample& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

struct AskingRoom : FlightRoom {
  explicit AskingRoom(std::int64_t clearance = 300000000) : FlightRoom(asking(clearance)) {
    flight.set_goal(kAskedGoal);
  }

  /// Ticks until a plan waits for its answer.
  std::uint32_t wait_for_question(int most = 400) {
    tick_until([&] { return flight.proposal(plan, takeover) != 0; }, most);
    return flight.proposal(plan, takeover);
  }
  Trajectory plan{};
  std::int64_t takeover = 0;
};

TEST(FlightClearance, NothingIsFlownWithoutAnAnswer) {
  AskingRoom room;
  const std::uint32_t first = room.wait_for_question();
  EXPECT_NE(first, 0u);
  EXPECT_GT(room.takeover, room.time);
  EXPECT_EQ(room.plan.begin, room.takeover);
  std::uint32_t last = first;
  for (int k = 0; k < 300; ++k) {
    room.tick();
    EXPECT_EQ(room.speed(), 0.0);
    const std::uint32_t next = room.flight.proposal(room.plan, room.takeover);
    EXPECT_TRUE(next == 0 || next == last || next == last + 1);
    if (next != 0) last = next;
  }
  EXPECT_GT(last, first + 3);
  EXPECT_EQ(room.report.committed, 0u);
  EXPECT_EQ(room.report.dropped, last - (room.flight.proposal(room.plan, room.takeover) != 0 ? 1u : 0u));
}

TEST(FlightClearance, OnlyTheQuestionThatWaitsIsAnswered) {
  AskingRoom room;
  EXPECT_EQ(room.flight.answer(0, true), Status::kInvalidArgument);
  const std::uint32_t number = room.wait_for_question();
  EXPECT_EQ(room.flight.answer(number + 1, true), Status::kInvalidArgument);
  EXPECT_EQ(room.flight.answer(number, false), Status::kOk);
  EXPECT_EQ(room.flight.answer(number, true), Status::kInvalidArgument);
  EXPECT_EQ(room.report.committed, 0u);
  const std::uint32_t next = room.wait_for_question();
  EXPECT_EQ(next, number + 1);
  EXPECT_EQ(room.report.failed, 1u);
  EXPECT_EQ(room.flight.answer(next, true), Status::kOk);
  EXPECT_EQ(room.flight.proposal(room.plan, room.takeover), 0u);
  EXPECT_TRUE(room.tick_until([&] { return room.report.committed == 1; }, 10));
  EXPECT_EQ(Flight{}.answer(1, true), Status::kInvalidArgument);
  EXPECT_EQ(Flight{}.proposal(room.plan, room.takeover), 0u);
}

// Answers come late and at random, a third of them say no. The vehicle flies nothing but what was proposed and cleared,
// and arrives.
TEST(FlightClearance, WhatIsFlownWasCleared) {
  tern_test::Random random(4301);
  for (int flown = 0; flown < tern_test::scaled(10); ++flown) {
    AskingRoom room;
    Trajectory before{}, cleared{};
    std::uint32_t asked = 0, committed = 0;
    int answer_in = 0;
    room.flight.committed_plan(before);
    const bool arrived = room.tick_until(
        [&] {
          Trajectory now{};
          room.flight.committed_plan(now);
          if (room.report.committed > committed) {
            EXPECT_EQ(std::memcmp(&now, &cleared, sizeof now), 0);
            committed = room.report.committed;
          } else {
            EXPECT_EQ(now.begin, before.begin);
            EXPECT_EQ(now.count, before.count);
          }
          before = now;
          const std::uint32_t number = room.flight.proposal(room.plan, room.takeover);
          if (number != asked && number != 0) answer_in = random.integer(0, 24);
          if (number != 0) asked = number;
          if (number != 0 && answer_in-- == 0) {
            // Up to the takeover, it is the committed plan.
            const Sample flown_then = evaluate(now, time_on(now, room.takeover));
            if (now.begin <= room.takeover) {
              EXPECT_TRUE(same_state(flown_then, evaluate(room.plan, time_on(room.plan, room.takeover))) ||
                          distance(flown_then.position, room.plan.origin) < 1e-9);
            }
            cleared = room.plan;
            EXPECT_EQ(room.flight.answer(number, random.integer(0, 2) > 0), Status::kOk);
          }
          return room.report.reason == FlightReason::kArrived;
        },
        4000);
    EXPECT_TRUE(arrived) << flown;
    EXPECT_GT(committed, 1u);
  }
}

// Neither a question nor a plan that was cleared outlives its goal. Who cleared it hears of that.
TEST(FlightClearance, ANewGoalTakesTheQuestionBack) {
  AskingRoom room;
  const std::uint32_t first = room.wait_for_question();
  room.flight.set_goal({0.125, 12.125, 1.125});
  EXPECT_EQ(room.flight.answer(first, true), Status::kInvalidArgument);
  EXPECT_EQ(room.report.dropped, 0u);
  const std::uint32_t second = room.wait_for_question();
  EXPECT_EQ(room.flight.answer(second, true), Status::kOk);
  room.flight.stop();
  room.tick();
  EXPECT_EQ(room.report.dropped, 1u);
  EXPECT_EQ(room.report.committed, 0u);
}

// What was marked while the plan waited is in the way: it was cleared, and is not flown.
TEST(FlightClearance, AClearedPlanIsProvenOnTheMapAsItIs) {
  AskingRoom room;
  const std::uint32_t number = room.wait_for_question();
  const Vec3 ahead = evaluate(room.plan, 0.5 * duration(room.plan)).position;
  room.mark({ahead - Vec3{0.3, 0.3, 0.3}, ahead + Vec3{0.3, 0.3, 0.3}});
  EXPECT_EQ(room.flight.answer(number, true), Status::kOk);
  room.tick_until([&] { return room.report.failed > 0 || room.report.committed > 0; }, 40);
  EXPECT_EQ(room.report.committed, 0u);
  EXPECT_EQ(room.report.failed, 1u);
}

/// On its way, with a committed plan and no question.
struct AskingInFlight : AskingRoom {
  AskingInFlight() {
    EXPECT_TRUE(tick_until(
        [&] {
          const std::uint32_t number = flight.proposal(plan, takeover);
          if (number != 0) {
            EXPECT_EQ(flight.answer(number, true), Status::kOk);
          }
          return speed() > 2.5;
        },
        600));
  }
};

TEST(FlightClearance, AStopFollowsTheCommittedPlanToItsEnd) {
  AskingInFlight room;
  Trajectory committed{};
  room.flight.stop();
  EXPECT_EQ(room.flight.committed_plan(committed), Status::kOk);
  for (int k = 0; k < 800; ++k) {
    room.tick();
    Trajectory now{};
    room.flight.committed_plan(now);
    ASSERT_EQ(std::memcmp(&now, &committed, sizeof now), 0) << k;
  }
  EXPECT_LT(distance(room.position(), room.flight.rest_position()), 1e-9);
  EXPECT_EQ(room.flight.proposal(room.plan, room.takeover), 0u);
}

// Who clears plans agreed to it. A thing that is measured is a threat all the same.
TEST(FlightClearance, AnotherVehiclesCurveIsNoThreat) {
  AskingInFlight room;
  TrackPiece across{0.9, {}};
  for (int k = 0; k < kControlPoints; ++k) across.points[k] = {0.0, 2.0 * k / 7.0, 0.0};
  Track vehicle;
  vehicle.measured = room.time;
  vehicle.position = room.position() + Vec3{3.0, -2.0, 0.0};
  vehicle.radius = 0.3;
  vehicle.pieces = &across;
  vehicle.piece_count = 1;
  EXPECT_EQ(room.flight.update_track(vehicle), Status::kOk);
  room.tick();
  EXPECT_NE(room.report.mode, FlightMode::kThreat);
  vehicle.id = 2;
  vehicle.position.y += 2.0;
  vehicle.pieces = nullptr;
  vehicle.piece_count = 0;
  EXPECT_EQ(room.flight.update_track(vehicle), Status::kOk);
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kThreat);
}

// Until the takeover, a yes may become a no: before the plan is committed, and after.
TEST(FlightClearance, AnAnswerMayBeTakenBackUntilTheTakeover) {
  AskingInFlight room;
  for (int ticks = 0; ticks <= 8; ticks += 4) {
    room.flight.set_goal(kAskedGoal);
    Trajectory before{}, after{};
    room.flight.committed_plan(before);
    const std::uint32_t number = room.wait_for_question();
    ASSERT_NE(number, 0u);
    EXPECT_EQ(room.flight.answer(number, true), Status::kOk);
    for (int k = 0; k < ticks; ++k) room.tick();
    EXPECT_EQ(room.flight.committed_plan(after), Status::kOk);
    EXPECT_EQ(after.begin == room.plan.begin, ticks > 0);
    const std::uint32_t dropped = room.report.dropped;
    EXPECT_EQ(room.flight.answer(number, false), Status::kOk);
    EXPECT_EQ(room.flight.answer(number, false), Status::kInvalidArgument);
    room.flight.committed_plan(after);
    EXPECT_EQ(std::memcmp(&before, &after, sizeof before), 0) << ticks;
    room.tick();
    EXPECT_EQ(room.report.dropped, dropped + 1);
    EXPECT_TRUE(room.tick_until([&] { return room.time > room.takeover; }, 60));
    room.flight.committed_plan(after);
    EXPECT_EQ(std::memcmp(&before, &after, sizeof before), 0) << ticks;
  }
  const std::uint32_t number = room.wait_for_question();
  EXPECT_EQ(room.flight.answer(number, true), Status::kOk);
  EXPECT_TRUE(room.tick_until([&] { return room.time > room.takeover; }, 60));
  EXPECT_EQ(room.flight.answer(number, false), Status::kInvalidArgument);
}

TEST(FlightClearance, TheTimeForAnswersMayChange) {
  AskingRoom room;
  room.wait_for_question();
  const std::int64_t first = room.takeover - room.time;
  EXPECT_EQ(room.flight.set_clearance(2000000000), Status::kOk);
  EXPECT_EQ(room.flight.answer(room.flight.proposal(room.plan, room.takeover), false), Status::kOk);
  room.wait_for_question();
  EXPECT_NEAR(static_cast<double>(room.takeover - room.time - first), 1.7e9, 0.3e9);
  for (const std::int64_t time : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{10000000001}}) {
    EXPECT_EQ(room.flight.set_clearance(time), Status::kInvalidArgument);
  }
  EXPECT_EQ(FlightRoom().flight.set_clearance(1000), Status::kInvalidArgument);
  EXPECT_EQ(Flight{}.set_clearance(1000), Status::kInvalidArgument);
}

TEST(FlightClearance, ABrakeForAThreatDoesNotAsk) {
  AskingInFlight room;
  const Vec3 ahead = room.position() + Vec3{2.5, 0.0, 0.0};
  room.mark({ahead - Vec3{0.2, 1.5, 1.0}, ahead + Vec3{0.2, 1.5, 1.0}});
  EXPECT_TRUE(room.tick_until([&] { return room.speed() == 0.0; }, 200));
  EXPECT_LT(room.position().x, ahead.x - 0.2 - FlightRoom::kRadius + 1e-6);
}

TEST(FlightClearance, TimesOutOfRangeAreRefused) {
  for (const std::int64_t time : {std::int64_t{-1}, std::int64_t{10000000001}}) {
    FlightRoom room;
    FlightRefusal why{};
    const FlightSpec spec = asking(time);
    EXPECT_EQ(
        room.flight.start(spec, room.map(), room.planner, room.words.data(), room.words.size(), room.start, 0, &why),
        Status::kInvalidArgument);
    EXPECT_EQ(why.field, Field::kClearance);
  }
}

}  // namespace
