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

double arrival(const Trajectory& plan) {
  return 1e-9 * static_cast<double>(plan.begin) + duration(plan);
}

TEST(Remainder, GivesWayOnlyToPlansThatArriveEarlier) {
  Flying room;
  double last = arrival(committed_plan(room));
  const std::uint32_t asked = room.report.asked;
  int plans = 0;
  int rivals = 0;
  const bool arrives = room.tick_until([&] {
    ++plans;
    rivals += room.state().cycle.must_beat ? 1 : 0;
    EXPECT_EQ(room.report.plan, Status::kOk);
    const double now = arrival(committed_plan(room));
    EXPECT_LE(now, last + 1e-9);
    last = now;
    return room.report.reason == FlightReason::kArrived;
  });
  ASSERT_TRUE(arrives);
  EXPECT_GT(rivals, plans / 2);
  EXPECT_GT(room.report.asked, asked + 3);
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
