// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// When a flight leaves out a point, and when it gives up.
#include <gtest/gtest.h>

#include <vector>

#include "base/math.hpp"
#include "support/flight_room.hpp"
#include "support/same.hpp"

namespace {

using namespace tern;
using tern_test::expect_same;
using tern_test::FlightRoom;

/// No plan leads anywhere, and no lookout helps: the vehicle looks around, stares at what blocks its way, and gives up.
TEST(FlightGivesUp, WhatBlocksTheWayIsLookedAtBeforeItGivesUp) {
  FlightRoom room;
  room.flight.set_goal({8.125, 0.125, 1.125});
  FlightState& state = room.state();
  state.facts.time = 2000000000;
  EXPECT_TRUE(state.facts.rests());
  state.block = {BlockedBy::kUnseen, {1.125, 0.125, 1.125}, kNoFence};
  for (int k = 1; k < kIdleCycles; ++k) state.give_up();
  EXPECT_FALSE(state.search.is_looking);
  state.give_up();
  EXPECT_TRUE(state.search.is_looking);
  state.give_up();
  EXPECT_TRUE(state.search.is_looking);
  state.facts.time += 6700000000;  // four directions of 0.928 s, and 3 s
  state.give_up();
  EXPECT_FALSE(state.facts.itinerary.parked);
  state.facts.time += 20000000;
  state.give_up();
  EXPECT_TRUE(state.facts.itinerary.parked);
  EXPECT_EQ(state.facts.itinerary.reason, FlightReason::kNoProgress);
}

/// Something is within the radius: after a look around the vehicle gives up.
TEST(FlightGivesUp, HemmedInItLooksForNoPlaceToLookFrom) {
  FlightRoom room;
  room.flight.set_goal({8.125, 0.125, 1.125});
  FlightState& state = room.state();
  state.facts.time = 2000000000;
  state.block = {BlockedBy::kUnseen, {1.125, 0.125, 1.125}, kNoFence};
  state.cycle.hemmed_in = true;
  for (int k = 0; k < kIdleCycles; ++k) state.give_up();
  EXPECT_TRUE(state.search.is_looking);
  state.facts.time += 6720000000;  // four directions of 0.928 s, and 3 s
  state.give_up();
  EXPECT_TRUE(state.facts.itinerary.parked);
  EXPECT_EQ(state.facts.itinerary.reason, FlightReason::kHemmedIn);
}

/// No way leads on to a point of a mission: the next one is the goal now.
TEST(FlightGivesUp, PointsThatNoWayLeadsToAreLeftOut) {
  FlightRoom room;
  const Via points[2] = {{{4.125, 0.125, 1.125}}, {{8.125, 0.125, 1.125}}};
  ASSERT_EQ(room.flight.set_mission(points, 2, ViaPolicy::kSkip), Status::kOk);
  FlightState& state = room.state();
  state.park(FlightReason::kNoProgress);
  EXPECT_FALSE(state.facts.itinerary.parked);
  EXPECT_EQ(room.flight.point_state(0), PointState::kSkipped);
  EXPECT_EQ(state.facts.itinerary.leg, 1);
  state.park(FlightReason::kNoProgress);
  EXPECT_TRUE(state.facts.itinerary.parked);
  EXPECT_EQ(state.facts.itinerary.reason, FlightReason::kNoProgress);
}

/// After a look around, a goal that no way leads to is as near as it gets, unless something is within the radius.
TEST(FlightGivesUp, AGoalThatIsCutOffIsNotRetreatedFrom) {
  for (const bool leaves : {false, true}) {
    FlightRoom room;
    room.flight.set_goal({8.125, 0.125, 1.125});
    FlightState& state = room.state();
    state.facts.time = 2000000000;
    state.cycle.hemmed_in = leaves;
    state.cycle.cut_off = true;
    for (int k = 0; k <= kIdleCycles; ++k) state.give_up();
    EXPECT_TRUE(state.search.is_looking);
    EXPECT_FALSE(state.facts.itinerary.parked);
    state.facts.time += 6720000000;  // four directions of 0.928 s, and 3 s
    state.give_up();
    EXPECT_TRUE(state.facts.itinerary.parked);
    EXPECT_EQ(state.facts.itinerary.reason, leaves ? FlightReason::kHemmedIn : FlightReason::kNearest);
  }
}

/// Right before a goal in an obstacle that was seen, the vehicle stares at it for three seconds, and does not look
/// around or go back. Further away it does.
TEST(FlightGivesUp, VehicleBeforeAnOccupiedGoalStaresAtIt) {
  for (const bool is_near : {true, false}) {
    FlightRoom room(FlightRoom::flight_spec(), {{{is_near ? 1.5 : 3.0, -2.0, -2.0}, {4.0, 2.0, 4.0}}});
    ASSERT_EQ(room.flight.set_goal({is_near ? 1.3 : 2.8, 0.125, 1.125}), Status::kOk);
    FlightState& state = room.state();
    state.facts.time = 20000000000;
    EXPECT_EQ(state.facts.itinerary.is_right_before(state.facts), is_near);
    for (int k = 0; k < kIdleCycles; ++k) state.give_up();
    EXPECT_TRUE(state.search.is_looking);
    EXPECT_EQ(state.search.sector_at(state.facts, state.nose, state.facts.time), is_near ? kLookDirections : 0);
    state.facts.time += 3200000000;
    state.give_up();
    EXPECT_EQ(state.facts.itinerary.parked, is_near);
    EXPECT_EQ(state.facts.itinerary.reason, is_near ? FlightReason::kNearest : FlightReason::kNone);
  }
}

/// A point of a mission likewise, that the plan would end at: the mission ends, or goes on without it.
TEST(FlightGivesUp, PointInAnObstacleBesideTheVehicleIsLeftOut) {
  for (const ViaPolicy policy : {ViaPolicy::kEnd, ViaPolicy::kSkip}) {
    FlightRoom room(FlightRoom::flight_spec(), {{{1.0, -2.0, -2.0}, {3.0, 2.0, 4.0}}});
    Via points[2];
    points[0].position = {1.2, 0.125, 1.125};
    points[1].position = {-2.0, 0.125, 1.125};
    ASSERT_EQ(room.flight.set_mission(points, 2, policy), Status::kOk);
    const bool skips = policy == ViaPolicy::kSkip;
    EXPECT_EQ(room.fly(1000), skips ? FlightReason::kArrived : FlightReason::kViaBlocked);
    EXPECT_EQ(room.report.skipped, skips ? 1 : 0);
    EXPECT_EQ(room.report.passed, skips ? 1 : 0);
  }
}

/// Walls on all sides, nearer than the radius.
std::vector<Box> cage(const Vec3& p) {
  constexpr double kNear = 0.4;
  constexpr double kFar = 2.0;
  std::vector<Box> walls;
  for (int a = 0; a < 3; ++a) {
    for (const double sign : {-1.0, 1.0}) {
      Box wall{{p.x - kFar, p.y - kFar, p.z - kFar}, {p.x + kFar, p.y + kFar, p.z + kFar}};
      axis(sign < 0.0 ? wall.upper : wall.lower, a) = axis(p, a) + sign * kNear;
      walls.push_back(wall);
    }
  }
  return walls;
}

/// There is no way out: the vehicle looks around and says so. No point of a mission is left out for that.
TEST(FlightGivesUp, HemmedInItSaysSo) {
  FlightSpec slow = FlightRoom::flight_spec();
  slow.tick = 100000000;
  for (const int count : {1, 2}) {
    FlightRoom room(slow);
    for (const Box& wall : cage(room.start)) room.mark(wall);
    Via points[2];
    points[0].position = {5.0, 0.0, 1.125};
    points[1].position = {8.0, 0.0, 1.125};
    ASSERT_EQ(room.flight.set_mission(points, count, ViaPolicy::kSkip), Status::kOk);
    EXPECT_EQ(room.fly(1000), FlightReason::kHemmedIn);
    expect_same(room.position(), room.start);
    EXPECT_EQ(room.report.skipped, 0);
    EXPECT_GE(room.time, 6700000000);  // four directions of 0.928 s, and 3 s
  }
}

/// As near to the goal as it gets: where the goal was seen in an obstacle, that is the end.
TEST(FlightGivesUp, NearestPlaceToAnOccupiedGoalIsTheEnd) {
  FlightRoom room(FlightRoom::flight_spec(), {{{1.0, -2.0, -2.0}, {3.0, 2.0, 4.0}}});
  FlightState& state = room.state();
  state.facts.itinerary.has_goal = true;
  state.facts.itinerary.count = 1;
  const auto next_plan = [&](const Vec3& goal, const Vec3& aim, bool aims_at_goal) {
    state.cycle.aim.start.d[0] = room.start;
    state.draft.takeover = 1000000000;
    state.cycle.aim.target_place = goal;
    state.cycle.aim.place = aim;
    state.cycle.aim.at_target = aims_at_goal;
    state.cycle.aim.moved = false;
    Report found{};
    found.status = Status::kGoalOccupied;
    found.has_nearest_free = true;
    found.nearest_free = aim;
    return state.cycle.next_after_plan(state.facts, found, state.draft.takeover);
  };
  const Vec3 occupied{1.2, 0.125, 1.125};
  const Vec3 free{-3.0, 0.125, 1.125};
  EXPECT_EQ(next_plan(occupied, {0.875, 0.125, 1.125}, true), NextPlan::kAsked);    // 0.75 m nearer
  EXPECT_EQ(next_plan(occupied, {0.375, 0.125, 1.125}, true), NextPlan::kNearest);  // a voxel nearer
  EXPECT_EQ(next_plan(occupied, {0.375, 0.125, 1.125}, false), NextPlan::kNone);    // the aim was on the way to it
  EXPECT_EQ(next_plan(free, {0.0, 0.125, 1.125}, true), NextPlan::kNone);           // something unseen was in it
  ASSERT_EQ(room.map().follow({20.0, 0.0, 1.0}), Status::kRunning);  // the map is sliding: nothing is known
  EXPECT_EQ(next_plan(occupied, {0.375, 0.125, 1.125}, true), NextPlan::kNone);
}

/// A fence stays where it is. But there may be a way around it to a goal behind, and out of an obstacle.
TEST(FlightGivesUp, OnlyAtAFencedGoalWithoutALook) {
  const auto looks = [](bool aims_at_goal, bool leaves) {
    FlightRoom room;
    FlightState& state = room.state();
    room.flight.set_goal({8.0, 0.0, 1.125});
    state.facts.time = 1000000000;
    state.report.plan = Status::kGoalFenced;
    state.cycle.aim.at_target = aims_at_goal;
    state.cycle.hemmed_in = leaves;
    state.search.idle_cycles = kIdleCycles - 1;
    state.give_up();
    EXPECT_NE(state.search.is_looking, state.facts.itinerary.parked);
    return state.search.is_looking;
  };
  EXPECT_FALSE(looks(true, false));
  EXPECT_TRUE(looks(false, false));
  EXPECT_TRUE(looks(true, true));
}

/// Beside a goal in an obstacle; not beside one beyond the window's face, or while the map slides.
TEST(FlightGivesUp, BeforeAGoalThatIsKnownToBeOccupied) {
  FlightRoom room(FlightRoom::flight_spec(), {{{1.0, -1.0, 0.0}, {1.25, 1.0, 4.0}}});
  FlightState& state = room.state();
  const auto is_before = [&](const Vec3& goal) {
    EXPECT_EQ(room.flight.set_goal(goal), Status::kOk);
    return state.facts.itinerary.is_right_before(state.facts);
  };
  EXPECT_TRUE(is_before({1.125, 0.125, 1.125}));
  EXPECT_FALSE(is_before({-1.125, 0.125, 1.125}));
  state.facts.plans.in_flight.trajectory.origin.z = 3.25;
  EXPECT_TRUE(is_before({0.625, 0.125, 3.875}));
  EXPECT_FALSE(is_before({0.625, 0.125, 4.125}));
  ASSERT_EQ(room.map().follow({20.0, 0.0, 1.0}), Status::kRunning);
  EXPECT_FALSE(is_before({0.625, 0.125, 3.875}));
}

/// Learning something alone keeps no vehicle on the way for ever.
TEST(FlightGivesUp, WanderingEnds) {
  FlightRoom room;
  FlightState& state = room.state();
  room.flight.set_goal({8.0, 0.0, 1.125});
  state.facts.itinerary.nearest = 1.0;
  state.facts.itinerary.wandering = kWandering - 1;
  state.facts.itinerary.learned = state.facts.map.learned() - kLearned;
  EXPECT_FALSE(state.facts.itinerary.count_plan(state.facts, room.start));
  EXPECT_EQ(state.facts.itinerary.fruitless, 0);
  EXPECT_FALSE(state.facts.itinerary.is_hopeless());
  state.facts.itinerary.learned = state.facts.map.learned() - kLearned;
  EXPECT_FALSE(state.facts.itinerary.count_plan(state.facts, room.start));
  EXPECT_EQ(state.facts.itinerary.fruitless, 0);
  EXPECT_TRUE(state.facts.itinerary.is_hopeless());
}

/// A point of a mission that cannot be reached is left out, and the reason says whether it is in an obstacle.
TEST(FlightGivesUp, PointsThatAreCutOffAreUnreachableAndNotBlocked) {
  for (const bool cut_off : {false, true}) {
    FlightRoom room;
    FlightState& state = room.state();
    const Via points[2] = {{{4.125, 0.125, 1.125}}, {{8.125, 0.125, 1.125}}};
    ASSERT_EQ(room.flight.set_mission(points, 2, ViaPolicy::kEnd), Status::kOk);
    state.cycle.cut_off = cut_off;
    state.park(FlightReason::kNearest);
    EXPECT_EQ(state.facts.itinerary.reason, cut_off ? FlightReason::kViaUnreachable : FlightReason::kViaBlocked);
    EXPECT_TRUE(state.facts.itinerary.parked);
  }
}

/// A room with closed walls, and a goal beyond the horizon outside: the vehicle goes as near to it as it gets.
TEST(FlightGivesUp, ClosedRoomEndsAtTheWallNearestToTheGoal) {
  const std::vector<Box> walls = {{{3.0, -3.0, -2.0}, {3.25, 3.25, 4.0}},
                                  {{-3.0, -3.0, -2.0}, {-2.75, 3.25, 4.0}},
                                  {{-3.0, -3.0, -2.0}, {3.25, -2.75, 4.0}},
                                  {{-3.0, 3.0, -2.0}, {3.25, 3.25, 4.0}}};
  FlightRoom room(FlightRoom::flight_spec(), walls);
  ASSERT_EQ(room.flight.set_goal({14.125, 0.125, 1.125}), Status::kOk);
  EXPECT_EQ(room.fly(6000), FlightReason::kNearest);
  EXPECT_GT(room.position().x, 3.0 - FlightRoom::kRadius - 2.0 * FlightRoom::kCell);
  EXPECT_EQ(room.report.reason, FlightReason::kNearest);
}

}  // namespace
