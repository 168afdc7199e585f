// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a flight says of a goal at once. The radius is 0.5 m, voxels are 0.25 m.
#include <gtest/gtest.h>

#include <cmath>

#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;

TEST(GoalCheck, WhatWasSeenIsNamed) {
  FlightRoom room(FlightRoom::flight_spec(), {{{5.0, 0.0, 0.0}, {5.25, 0.25, 2.0}}});
  FlightRefusal why;
  EXPECT_EQ(room.flight.check_goal({4.375, 0.125, 1.125}, &why), Status::kOk);
  EXPECT_EQ(why.field, Field::kNone);
  EXPECT_EQ(room.flight.check_goal({4.625, 0.125, 1.125}, &why), Status::kGoalOccupied);
  EXPECT_EQ(why.field, Field::kGoalPosition);
  EXPECT_EQ(why.blocked_by, BlockedBy::kObstacle);
  EXPECT_EQ(why.blocked_at.x, 5.125);
  EXPECT_EQ(why.distance, 0.375);
  EXPECT_EQ(why.needed, 0.5);
  EXPECT_EQ(room.flight.check_goal({4.625, 0.125, 1.125}), Status::kGoalOccupied);
  // Nothing is known beyond the window.
  EXPECT_EQ(room.flight.check_goal({500.0, 0.0, 1.0}, &why), Status::kOk);
}

/// Nothing was hit there: the operator said so.
TEST(GoalCheck, TheStatedGroundIsNamed) {
  FlightRoom room;
  ASSERT_EQ(room.map().assume_column({{2.0, 0.0, 0.25}, 1.0, 2.0}), Status::kOk);
  FlightRefusal why;
  EXPECT_EQ(room.flight.check_goal({2.0, 0.5, 0.75}, &why), Status::kOk);
  EXPECT_EQ(room.flight.check_goal({2.0, 0.5, 0.625}, &why), Status::kGoalOccupied);
  EXPECT_EQ(why.blocked_by, BlockedBy::kObstacle);
  EXPECT_EQ(why.blocked_at.z, 0.25);
  EXPECT_EQ(why.distance, 0.375);
  EXPECT_EQ(room.flight.check_goal({2.0, 0.5, 0.125}, &why), Status::kGoalOccupied);
  EXPECT_EQ(why.distance, 0.0);
  EXPECT_EQ(room.flight.check_goal({2.0, 1.5, 0.625}, &why), Status::kOk) << "beside the column";
}

TEST(GoalCheck, FencesAreNamed) {
  const Halfspace planes[] = {{{1.0, 0.0, 0.0}, 6.0}};
  Fence fence{};
  fence.kind = FenceKind::kKeepIn;
  fence.planes = planes;
  fence.count = 1;
  FlightSpec spec = FlightRoom::flight_spec();
  spec.fences = &fence;
  spec.fence_count = 1;
  FlightRoom room(spec);
  FlightRefusal why;
  EXPECT_EQ(room.flight.check_goal({6.0, 0.0, 1.0}, &why), Status::kOk);
  EXPECT_EQ(room.flight.check_goal({6.125, 0.0, 1.0}, &why), Status::kGoalFenced);
  EXPECT_EQ(why.fence, 0);
}

TEST(GoalCheck, NumbersThatAreNone) {
  FlightRoom room;
  FlightRefusal why;
  EXPECT_EQ(room.flight.check_goal({NAN, 0.0, 1.0}, &why), Status::kNonFiniteInput);
  EXPECT_EQ(why.field, Field::kGoalPosition);
  EXPECT_EQ(Flight{}.check_goal({1.0, 0.0, 1.0}), Status::kInvalidArgument);
}

}  // namespace
