// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a far way makes of each reason for which a flight rests.
#include <gtest/gtest.h>

#include <cstdint>

#include "flight/far_rest.hpp"
#include "support/far_world.hpp"

namespace {

using tern::FlightReason;
using tern::NearGoalEnd;
using tern::Vec3;
using tern_test::FarWorld;

struct ReasonCase {
  FlightReason reason;
  NearGoalEnd end;
};

constexpr ReasonCase kReasons[] = {
    {FlightReason::kNone, NearGoalEnd::kNone},           {FlightReason::kNoGoal, NearGoalEnd::kNone},
    {FlightReason::kArrived, NearGoalEnd::kNone},        {FlightReason::kNearest, NearGoalEnd::kForGood},
    {FlightReason::kNoProgress, NearGoalEnd::kForGood},  {FlightReason::kHemmedIn, NearGoalEnd::kForNow},
    {FlightReason::kViaBlocked, NearGoalEnd::kForGood},  {FlightReason::kViaUnreachable, NearGoalEnd::kForGood},
    {FlightReason::kMapStale, NearGoalEnd::kForNow},     {FlightReason::kStrays, NearGoalEnd::kNone},
    {FlightReason::kMarginExceeded, NearGoalEnd::kNone}, {FlightReason::kLanded, NearGoalEnd::kNone},
    {FlightReason::kGroundUnseen, NearGoalEnd::kNone},   {FlightReason::kGroundUneven, NearGoalEnd::kNone},
    {FlightReason::kGoalUnseen, NearGoalEnd::kForGood},  {FlightReason::kHeldUp, NearGoalEnd::kForNow},
};

TEST(FarWayRest, EveryReasonHasAMeaning) {
  std::uint8_t next = 0;
  for (const ReasonCase& each : kReasons) {
    EXPECT_EQ(static_cast<std::uint8_t>(each.reason), next++);
    EXPECT_EQ(tern::end_of_near_goal(each.reason), each.end) << int{next} - 1;
  }
  // This list is complete: the next number is no reason.
  EXPECT_STREQ(tern::flight_reason_text(static_cast<FlightReason>(next)), "unknown");
  EXPECT_EQ(tern::end_of_near_goal(static_cast<FlightReason>(next)), NearGoalEnd::kNone);
}

TEST(FarWayRest, OnlyAFlightThatRestsHasGivenUp) {
  tern::FlightReport report{};
  report.reason = FlightReason::kNoProgress;
  for (std::uint8_t mode = 0; mode <= static_cast<std::uint8_t>(tern::FlightMode::kThreat); ++mode) {
    report.mode = static_cast<tern::FlightMode>(mode);
    const bool rests = report.mode == tern::FlightMode::kRest;
    EXPECT_EQ(tern::end_of_near_goal(report), rests ? NearGoalEnd::kForGood : NearGoalEnd::kNone);
  }
}

/// For two seconds, where nothing is seen: only what the world refuses closes a cell.
TEST(FarWayRest, OnlyTheWorldClosesFreeCells) {
  for (const ReasonCase& each : kReasons) {
    FarWorld world({32, 32, 4});
    world.begin({122.0, 62.0, 6.0});
    const Vec3 at{6.0, 62.0, 6.0};
    world.find_way(at);
    for (int k = 0; k < 200; ++k) world.tick(at, each.reason);
    EXPECT_EQ(world.far.marked() > 0, each.end == NearGoalEnd::kForGood) << static_cast<int>(each.reason);
  }
}

/// After each `patience`, with the same near goal, so that the flight tries again.
TEST(FarWayRest, AFlightThatWaitsIsToldAgain) {
  FarWorld world({32, 32, 4});
  world.begin({122.0, 62.0, 6.0});
  const Vec3 at{6.0, 62.0, 6.0};
  world.find_way(at);
  const Vec3 near_goal = world.far.near_goal();
  int told = 0;
  for (int k = 0; k < 3500; ++k) {
    if (!world.tick(at, FlightReason::kHeldUp)) continue;
    ++told;
    EXPECT_EQ(world.far.near_goal().x, near_goal.x);
  }
  EXPECT_EQ(told, 3);
  EXPECT_EQ(world.far.searches(), 1);
  EXPECT_EQ(world.far.marked(), 0);
}

/// The rolling map shows a wall across the way. It is learned, but not before `patience` is over.
TEST(FarWayRest, AFlightThatWaitsLearnsWhatIsSeen) {
  FarWorld world({32, 32, 4}, {60.0, 32.0, 8.0});
  tern_test::build_streets(world);
  const Vec3 at{50.0, 12.0, 6.0};
  world.find_way({20.0, 40.0, 6.0});
  for (int k = 0; k < 990; ++k) world.tick(at, FlightReason::kMapStale);
  EXPECT_EQ(world.far.marked(), 0);
  for (int k = 0; k < 20; ++k) world.tick(at, FlightReason::kMapStale);
  EXPECT_EQ(world.far.marked(), 24);
  EXPECT_EQ(world.far.searches(), 2);
}

}  // namespace
