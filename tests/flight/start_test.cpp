// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flight's first moments, and what it answers before it began.
#include <gtest/gtest.h>

#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;

TEST(FlightStart, BeforeItThereIsNowhereToRest) {
  const Vec3 nowhere = Flight{}.rest_position();
  EXPECT_EQ(nowhere.x, 0.0);
  EXPECT_EQ(nowhere.y, 0.0);
  EXPECT_EQ(nowhere.z, 0.0);
  FlightRoom room;
  EXPECT_EQ(room.flight.rest_position().x, room.start.x);
}

TEST(FlightStart, VehicleRestsUntilItsFirstPlanTakesOver) {
  FlightRoom room;
  ASSERT_EQ(room.flight.set_goal({8.125, 0.125, 1.125}), Status::kOk);
  bool committed = false;
  while (!room.state().facts.plans.has_waiting || room.time < room.state().facts.plans.waiting.begin()) {
    ASSERT_LT(room.time, 1000000000);
    room.tick();
    committed = committed || room.report.committed;
    EXPECT_EQ(room.report.mode, FlightMode::kRest) << room.time;
  }
  EXPECT_TRUE(committed);
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kFly);
}

TEST(FlightStart, RouteCopyNeedsItsWords) {
  FlightRoom room;
  const std::size_t count = grid_words(FlightRoom::map_spec().dims);
  std::vector<std::uint64_t> words(count, 0xA5A5A5A5A5A5A5A5u);
  RouteCopy copy;
  EXPECT_EQ(copy.bind(room.map(), words.data(), count - 1), Status::kInvalidArgument);
  EXPECT_FALSE(copy.grid().bound());
  EXPECT_EQ(copy.bind(room.map(), words.data(), count), Status::kOk);
  EXPECT_TRUE(copy.grid().bound());
}

/// A planner without memory refuses every plan, and the vehicle stays where it is.
TEST(FlightStart, PlannerWithoutAWorkspaceLeavesTheVehicleAtRest) {
  tern_test::FlightRoom room;
  Planner nothing(nullptr, 0);
  Flight flight;
  std::vector<std::uint64_t> words(flight_words(tern_test::FlightRoom::map_spec().dims));
  ASSERT_EQ(flight.start(room.spec, room.map(), nothing, words.data(), words.size(), room.start, 0), Status::kOk);
  ASSERT_EQ(flight.set_goal({8.125, 0.125, 1.125}), Status::kOk);
  FlightReport report{};
  for (int k = 0; k < 400; ++k) {
    ASSERT_EQ(flight.tick(k * room.spec.tick, report), Status::kOk);
    ASSERT_LE(report.work, room.spec.work_per_tick);
  }
  EXPECT_EQ(report.plan, Status::kInvalidArgument);
  EXPECT_EQ(report.committed, 0u);
  EXPECT_GT(report.asked, 0u);
  EXPECT_EQ(flight.command(400 * room.spec.tick).sample.position.x, room.start.x);
}

}  // namespace
