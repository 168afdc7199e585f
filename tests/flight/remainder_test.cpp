// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is left of the plan in flight, against new plans to the same place.
#include <gtest/gtest.h>

#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::Flying;

Trajectory committed_plan(const Flying& room) {
  Trajectory plan{};
  EXPECT_EQ(room.flight.committed_plan(plan), Status::kOk);
  return plan;
}

TEST(Remainder, IsFlownOnWhereNothingIsBetter) {
  Flying room;
  const Trajectory first = committed_plan(room);
  const std::uint32_t asked = room.report.asked;
  const std::uint32_t failed = room.report.failed;
  bool is_rival = false;
  ASSERT_TRUE(room.tick_until([&] {
    is_rival = is_rival || room.state().cycle.must_beat;
    EXPECT_EQ(room.report.plan, Status::kOk);
    return room.position().x > 3.5;  // shorter ways have a style of their own
  }));
  EXPECT_TRUE(is_rival);
  EXPECT_GT(room.report.asked, asked + 3);
  EXPECT_EQ(room.report.failed, failed);
  EXPECT_EQ(committed_plan(room).begin, first.begin);
}

TEST(Remainder, GivesWayToAPlanElsewhere) {
  Flying room;
  const Trajectory first = committed_plan(room);
  room.flight.set_goal({8.125, 4.125, 1.125});
  EXPECT_TRUE(room.tick_until([&] { return room.report.reason == FlightReason::kArrived; }));
  EXPECT_NE(committed_plan(room).begin, first.begin);
  EXPECT_NEAR(room.position().y, 4.125, 1e-6);
}

}  // namespace
