// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a flight leads, and where it looks.
#include <gtest/gtest.h>

#include "base/math.hpp"
#include "support/flight_room.hpp"
#include "support/same.hpp"

namespace {

using namespace tern;
using tern_test::expect_same;
using tern_test::FlightRoom;

/// The voxel whose centre is so many voxels along x away from the start.
Box voxel_at(const FlightRoom& room, int voxels) {
  const double x = room.start.x + FlightRoom::kCell * voxels;
  return {{x - 0.0625, room.start.y - 0.0625, room.start.z - 0.0625},
          {x + 0.0625, room.start.y + 0.0625, room.start.z + 0.0625}};
}

/// The aim is on the straight line to a goal that is far away: at most so far, and 1 m inside the window's faces.
TEST(FlightAim, AimsAreWithinReachAndTheWindow) {
  FlightRoom room;
  FlightState& state = room.state();
  const double lower[] = {-15.0, -15.0, -1.0};
  const double upper[] = {15.0, 15.0, 3.0};
  for (int a = 0; a < 3; ++a) {
    for (const double sign : {-1.0, 1.0}) {
      state.goal = room.start;
      axis(state.goal, a) += sign * 100.0;
      Vec3 expected = room.start;
      axis(expected, a) = sign < 0.0 ? lower[a] : upper[a];
      state.choose_aim(room.start, 1000.0);
      expect_same(state.aim, expected);
      EXPECT_FALSE(state.aims_at_goal);
      state.choose_aim(room.start, 0.5);
      axis(expected, a) = axis(room.start, a) + sign * 0.5;
      expect_same(state.aim, expected);
    }
  }
  state.goal = {3.0, 4.0, 1.125};
  state.choose_aim(room.start, 1000.0);
  expect_same(state.aim, state.goal);
  EXPECT_TRUE(state.aims_at_goal);
}

/// The window follows a vehicle that has left its middle, unless that would cut off the end of what is flown:
/// of the 16 m on each side, 9.25 may be lost to whole words, and 0.75 are the radius and a voxel.
TEST(FlightAim, TheWindowHoldsWhatIsFlown) {
  const auto follows = [](double at, double way) {
    FlightRoom room;
    FlightState& state = room.state();
    Trajectory& plan = state.now.flown;
    plan = Trajectory{};
    plan.count = 1;
    plan.origin = {at, 0.125, 1.125};
    plan.segments[0].duration = 10.0;
    for (int i = 0; i < kControlPoints; ++i) plan.segments[0].points[i].x = way * i / kDegree;
    state.follow_window();
    return room.map().busy();
  };
  EXPECT_FALSE(follows(1.0, 1.0));
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_TRUE(follows(12.0, 5.9 * sign));
    EXPECT_FALSE(follows(12.0, 6.1 * sign));
  }
}

/// Half a metre away from a thing; between two that are alike, there is no way out.
TEST(FlightAim, WayOutLeadsStraightAway) {
  FlightRoom room;
  FlightState& state = room.state();
  room.mark(voxel_at(room, 2));
  state.aims_at_goal = true;
  state.choose_way_out(room.start);
  expect_same(state.aim, {room.start.x - 0.5, room.start.y, room.start.z});
  EXPECT_FALSE(state.aims_at_goal);
  room.mark(voxel_at(room, -2));
  state.aim = {7.0, 8.0, 9.0};
  state.aims_at_goal = true;
  state.choose_way_out(room.start);
  expect_same(state.aim, {7.0, 8.0, 9.0});
  EXPECT_TRUE(state.aims_at_goal);
}

/// The proof of resting ends at a voxel aside, or straight above: there is nothing to turn to there.
TEST(FlightAim, LooksAtAnObstacleFromAMetreAtLeast) {
  const Vec3 old{9.0, 9.0, 9.0};
  const auto look = [&](FlightRoom& room, const Box& box) {
    FlightState& state = room.state();
    room.mark(box);
    EXPECT_EQ(state.proof.begin(room.map().safe(), state.now.flown, 0.0, nullptr, Beyond::kSolid), Status::kRunning);
    EXPECT_EQ(state.proof.step(1000), Status::kOk);
    EXPECT_EQ(state.proof.report().end, ProofEnd::kObstacle);
    state.look_at = old;
    state.look_at_obstacle();
    return state.look_at;
  };
  FlightRoom aside;
  expect_same(look(aside, voxel_at(aside, 2)), {aside.start.x + 1.0, aside.start.y, aside.start.z});
  FlightRoom above;
  const Vec3& p = above.start;
  expect_same(look(above, {{p.x - 0.1, p.y - 0.1, p.z + 0.4}, {p.x + 0.1, p.y + 0.1, p.z + 0.6}}), old);
}

/// No way leads to the aim: the nearest point that one leads to takes its place, if nothing unseen was solid. Where the
/// vehicle rests there already, the goal is cut off.
TEST(FlightAim, TheNearestReachablePointTakesTheAimsPlace) {
  const auto moves = [](Status status, bool all_free, double reachable, bool at_goal, FlightRoom& room) {
    room.flight.set_goal({8.125, 0.125, 1.125});
    FlightState& state = room.state();
    state.time = state.takeover = 2000000000;
    state.route.begin(room.map(), room.start, 0.0, 0.0, 0.0);
    for (int k = 0; k < 100000 && !state.route.done(); ++k) state.route.advance(room.map());
    EXPECT_TRUE(state.route.done());
    state.start = joint_at(state.now.flown, 0.0, kZero);
    state.goal = state.aim = {8.125, 0.125, 1.125};
    state.all_free = all_free;
    state.aims_at_goal = at_goal;
    state.asked_count = 0;
    Report found{};
    found.status = status;
    found.has_reachable = true;
    found.reachable = {room.start.x + reachable, room.start.y, room.start.z};
    return state.move_to_reachable(found);
  };
  FlightRoom far;
  EXPECT_TRUE(moves(Status::kNoPath, true, 3.0, true, far));
  expect_same(far.state().aim, {far.start.x + 3.0, far.start.y, far.start.z});
  EXPECT_EQ(far.state().job, Job::kPlan);
  EXPECT_FALSE(far.state().aims_at_goal);
  EXPECT_FALSE(far.state().cut_off);
  Report again{};
  again.status = Status::kNoPath;
  again.has_reachable = true;
  EXPECT_FALSE(far.state().move_to_reachable(again));  // once
  FlightRoom unseen;
  EXPECT_FALSE(moves(Status::kNoPath, false, 3.0, true, unseen));
  FlightRoom other;
  EXPECT_FALSE(moves(Status::kBudgetSearch, true, 3.0, true, other));
  for (const bool at_goal : {true, false}) {
    FlightRoom there;
    EXPECT_FALSE(moves(Status::kNoPath, true, 0.2, at_goal, there));
    EXPECT_EQ(there.state().cut_off, at_goal);
  }
}

/// The goal is in an obstacle, and nothing free is nearer to it than the vehicle: it rests where it is.
TEST(FlightAim, GoalInAnObstacleBesideTheVehicleIsReachedAtOnce) {
  FlightRoom room(FlightRoom::flight_spec(), {{{1.0, -2.0, -2.0}, {3.0, 2.0, 4.0}}});
  room.tick_until([&] { return room.state().rests(); });
  room.flight.set_goal({1.2, 0.125, 1.125});
  EXPECT_EQ(room.fly(100), FlightReason::kNearest);
  expect_same(room.position(), room.start);
  EXPECT_EQ(room.report.committed, 0u);
  EXPECT_EQ(room.state().idle_cycles, 0);
}

/// An aim in an obstacle moves to the nearest free point. The aim of the plan that is flown stays, if it is beside the
/// same goal and not much further away: two voxels.
TEST(FlightAim, OccupiedAimMovesToTheNearestFreePoint) {
  const Vec3 goal{8.125, 0.125, 1.125};
  const auto moved = [&](double nearest, double old, bool same_target, bool aims_at_goal = true) {
    FlightRoom room;
    FlightState& state = room.state();
    EXPECT_EQ(room.flight.set_goal(goal), Status::kOk);
    state.takeover = 1000000000;
    state.start.d[0] = room.start;
    state.goal = goal;
    state.keeps = state.now.beside_goal = true;
    state.now.target = same_target ? 0 : 1;
    state.now.aim = {old, 0.125, 1.125};
    state.aims_at_goal = aims_at_goal;
    Report found{};
    found.status = Status::kGoalOccupied;
    found.has_nearest_free = true;
    found.nearest_free = {nearest, 0.125, 1.125};
    EXPECT_TRUE(state.move_aim(found));
    EXPECT_EQ(state.job, Job::kPlan);
    EXPECT_EQ(state.beside_goal, aims_at_goal || same_target);
    EXPECT_FALSE(state.aims_at_goal);
    return state.aim.x;
  };
  EXPECT_EQ(moved(7.0, 6.75, true), 6.75);
  EXPECT_EQ(moved(7.0, 6.25, true), 7.0);
  EXPECT_EQ(moved(7.0, 6.75, false), 7.0);
  EXPECT_EQ(moved(7.0, 6.75, true, false), 6.75);
  EXPECT_EQ(moved(7.0, 6.75, false, false), 7.0);
}

/// The nearest free point is where the vehicle is: that ends the flight, unless it passes a point on the way.
TEST(FlightAim, OccupiedGoalAfterAPointIsFlownTo) {
  for (const std::int32_t points : {0, 1}) {
    FlightRoom room;
    FlightState& state = room.state();
    EXPECT_EQ(room.flight.set_goal({1.125, 0.125, 1.125}), Status::kOk);
    state.takeover = 1000000000;
    state.start.d[0] = room.start;
    state.goal = {1.125, 0.125, 1.125};
    state.asked_count = points;
    state.asked[0].position = {0.125, 3.125, 1.125};
    Report found{};
    found.status = Status::kGoalOccupied;
    found.has_nearest_free = true;
    found.nearest_free = room.start;
    EXPECT_EQ(state.move_aim(found), points > 0);
    EXPECT_EQ(state.job, points > 0 ? Job::kPlan : Job::kIdle);
  }
}

TEST(FlightAim, OnlyOccupiedAimsMove) {
  FlightRoom room;
  FlightState& state = room.state();
  EXPECT_EQ(room.flight.set_goal({8.125, 0.125, 1.125}), Status::kOk);
  Report found{};
  found.status = Status::kNoPath;
  found.has_nearest_free = true;
  EXPECT_FALSE(state.move_aim(found));
  found.status = Status::kGoalOccupied;
  state.moved_aim = true;
  EXPECT_FALSE(state.move_aim(found));
  state.moved_aim = found.has_nearest_free = false;
  EXPECT_FALSE(state.move_aim(found));
  EXPECT_EQ(state.job, Job::kIdle);
}

/// The same with points on the way, a goal whose nearest free point was the aim, and no place that can be reached.
TEST(FlightAim, OnlyPlansToTheAimAloneMoveToAReachablePoint) {
  struct Case {
    bool has_reachable, past_points, beside_goal, cut_off;
  };
  for (const Case& c : {Case{false, false, false, false}, Case{true, true, false, false},
                        Case{true, false, false, false}, Case{true, false, true, true}}) {
    FlightRoom room;
    room.flight.set_goal({8.125, 0.125, 1.125});
    FlightState& state = room.state();
    state.time = state.takeover = 2000000000;
    state.start = joint_at(state.now.flown, 0.0, kZero);
    state.goal = state.aim = {8.125, 0.125, 1.125};
    state.all_free = true;
    state.aims_at_goal = false;
    state.beside_goal = c.beside_goal;
    state.asked_count = c.past_points ? 1 : 0;
    Report found{};
    found.status = Status::kNoPath;
    found.has_reachable = c.has_reachable;
    found.reachable = room.start;  // the vehicle rests there
    EXPECT_FALSE(state.move_to_reachable(found));
    EXPECT_EQ(state.cut_off, c.cut_off);
    expect_same(state.aim, {8.125, 0.125, 1.125});
  }
}

/// The rest of the plan that is flown leads to the old goal: with a new one it is no candidate, however free it is.
TEST(FlightAim, NewGoalDuringTheProofOfTheRestDropsIt) {
  for (const bool moves : {false, true}) {
    tern_test::Flying room;
    FlightState& state = room.state();
    for (int k = 0; k < 100000 && state.job != Job::kKeep; ++k) room.advance(1);
    ASSERT_EQ(state.job, Job::kKeep);
    if (moves) {
      ASSERT_EQ(room.flight.set_goal({8.125, 4.125, 1.125}), Status::kOk);
    }
    state.owed = 0;
    Work work{100000};
    ASSERT_EQ(state.run_keep(work), Progress::kDone);
    EXPECT_EQ(state.keeps, !moves);
  }
}

}  // namespace
