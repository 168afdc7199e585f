// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Where a flight leads, and where it looks.
#include <gtest/gtest.h>

#include <memory>

#include "base/math.hpp"
#include "support/flight_room.hpp"
#include "support/same.hpp"

namespace {

using namespace tern;
using tern_test::expect_same;
using tern_test::FlightRoom;

/// What follows the failure of a plan.
NextPlan ask_again(FlightState& state, const Report& found) {
  return state.cycle.next_after_plan(state.facts, found, state.draft.takeover);
}

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
  state.cycle.aim.start.d[0] = room.start;
  const double lower[] = {-15.0, -15.0, -1.0};
  const double upper[] = {15.0, 15.0, 3.0};
  for (int a = 0; a < 3; ++a) {
    for (const double sign : {-1.0, 1.0}) {
      state.cycle.aim.target_place = room.start;
      axis(state.cycle.aim.target_place, a) += sign * 100.0;
      Vec3 expected = room.start;
      axis(expected, a) = sign < 0.0 ? lower[a] : upper[a];
      state.cycle.aim.choose_place(state.facts, 1000.0);
      expect_same(state.cycle.aim.place, expected);
      EXPECT_FALSE(state.cycle.aim.at_target);
      state.cycle.aim.choose_place(state.facts, 0.5);
      axis(expected, a) = axis(room.start, a) + sign * 0.5;
      expect_same(state.cycle.aim.place, expected);
    }
  }
  state.cycle.aim.target_place = {3.0, 4.0, 1.125};
  state.cycle.aim.choose_place(state.facts, 1000.0);
  expect_same(state.cycle.aim.place, state.cycle.aim.target_place);
  EXPECT_TRUE(state.cycle.aim.at_target);
}

/// The window follows a vehicle that has left its middle, unless that would cut off the end of the committed plan:
/// of the 16 m on each side, 9.25 may be lost to whole words, and 0.75 are the radius and a voxel.
TEST(FlightAim, TheWindowHoldsWhatIsFlown) {
  const auto follows = [](double at, double way) {
    FlightRoom room;
    FlightState& state = room.state();
    Trajectory& plan = state.facts.plans.in_flight.trajectory;
    plan = Trajectory{};
    plan.count = 1;
    plan.origin = {at, 0.125, 1.125};
    plan.segments[0].duration = 10.0;
    for (int i = 0; i < kControlPoints; ++i) plan.segments[0].points[i].x = way * i / kDegree;
    state.facts.follow_vehicle();
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
  state.cycle.aim.start.d[0] = room.start;
  state.cycle.aim.at_target = true;
  state.cycle.aim.choose_way_out(state.facts);
  expect_same(state.cycle.aim.place, {room.start.x - 0.5, room.start.y, room.start.z});
  EXPECT_FALSE(state.cycle.aim.at_target);
  room.mark(voxel_at(room, -2));
  state.cycle.aim.place = {7.0, 8.0, 9.0};
  state.cycle.aim.at_target = true;
  state.cycle.aim.choose_way_out(state.facts);
  expect_same(state.cycle.aim.place, {7.0, 8.0, 9.0});
  EXPECT_TRUE(state.cycle.aim.at_target);
}

/// The proof of resting ends at a voxel aside, or straight above: there is nothing to turn to there.
TEST(FlightAim, LooksAtAnObstacleFromAMetreAtLeast) {
  const Vec3 old{9.0, 9.0, 9.0};
  const auto look = [&](FlightRoom& room, const Box& box) {
    FlightState& state = room.state();
    room.mark(box);
    EXPECT_EQ(state.draft.proof.begin(room.map().safe(), state.facts.plans.in_flight.trajectory, 0.0, nullptr,
                                      Beyond::kSolid),
              Status::kRunning);
    EXPECT_EQ(state.draft.proof.step(1000), Status::kOk);
    EXPECT_EQ(state.draft.proof.report().finding, Finding::kObstacle);
    state.search.look_at = old;
    state.search.look_at_voxel(state.facts, state.draft.proof.report().voxel);
    return state.search.look_at;
  };
  FlightRoom aside;
  expect_same(look(aside, voxel_at(aside, 2)), {aside.start.x + 1.0, aside.start.y, aside.start.z});
  FlightRoom above;
  const Vec3& p = above.start;
  expect_same(look(above, {{p.x - 0.1, p.y - 0.1, p.z + 0.4}, {p.x + 0.1, p.y + 0.1, p.z + 0.6}}), old);
}

/// No way leads to the aim: the nearest point that one leads to takes its place, if nothing unseen was solid or nothing
/// else helped. Where the vehicle rests there already and nothing unseen was solid, the goal is cut off.
TEST(FlightAim, TheNearestReachablePointTakesTheAimsPlace) {
  const auto moves = [](Status status, bool all_free, double reachable, bool at_goal, FlightRoom& room) {
    room.flight.set_goal({8.125, 0.125, 1.125});
    FlightState& state = room.state();
    state.facts.time = state.draft.takeover = 2000000000;
    state.cycle.route.begin(room.map(), room.start, {0.0, 0.0, 0.0, false});
    for (int k = 0; k < 100000 && !state.cycle.route.done(); ++k)
      state.cycle.route.advance(room.map(), state.tick_work);
    EXPECT_TRUE(state.cycle.route.done());
    state.cycle.aim.start = joint_at(state.facts.plans.in_flight.trajectory, 0.0, kZero);
    state.cycle.aim.target_place = state.cycle.aim.place = {8.125, 0.125, 1.125};
    state.cycle.all_free = all_free;
    state.cycle.aim.at_target = at_goal;
    state.cycle.aim.asked_count = 0;
    Report found{};
    found.status = status;
    found.has_reachable = true;
    found.reachable = {room.start.x + reachable, room.start.y, room.start.z};
    return ask_again(state, found) == NextPlan::kAsked;
  };
  FlightRoom far;
  EXPECT_TRUE(moves(Status::kNoPath, true, 3.0, true, far));
  expect_same(far.state().cycle.aim.place, {far.start.x + 3.0, far.start.y, far.start.z});
  EXPECT_EQ(far.state().cycle.job, Job::kAskPlan);
  EXPECT_FALSE(far.state().cycle.aim.at_target);
  EXPECT_FALSE(far.state().cycle.cut_off);
  Report again{};
  again.status = Status::kNoPath;
  again.has_reachable = true;
  EXPECT_EQ(ask_again(far.state(), again), NextPlan::kNone);  // once
  FlightRoom unseen;
  EXPECT_FALSE(moves(Status::kNoPath, false, 3.0, true, unseen));
  FlightRoom last_resort;
  last_resort.state().cycle.is_last_resort = true;
  EXPECT_TRUE(moves(Status::kNoPath, false, 3.0, true, last_resort));
  last_resort.state().cycle.aim.at_reachable = false;
  EXPECT_FALSE(moves(Status::kNoPath, false, 0.2, true, last_resort));
  EXPECT_FALSE(last_resort.state().cycle.cut_off);
  FlightRoom other;
  EXPECT_FALSE(moves(Status::kBudgetSearch, true, 3.0, true, other));
  for (const bool at_goal : {true, false}) {
    FlightRoom there;
    EXPECT_FALSE(moves(Status::kNoPath, true, 0.2, at_goal, there));
    EXPECT_EQ(there.state().cycle.cut_off, at_goal);
  }
}

/// The goal is in an obstacle, and nothing free is nearer to it than the vehicle: it rests where it is.
TEST(FlightAim, GoalInAnObstacleBesideTheVehicleIsReachedAtOnce) {
  FlightRoom room(FlightRoom::flight_spec(), {{{1.0, -2.0, -2.0}, {3.0, 2.0, 4.0}}});
  room.tick_until([&] { return room.state().facts.rests(); });
  room.flight.set_goal({1.2, 0.125, 1.125});
  EXPECT_EQ(room.fly(100), FlightReason::kNearest);
  expect_same(room.position(), room.start);
  EXPECT_EQ(room.report.committed, 0u);
  EXPECT_EQ(room.state().search.idle_cycles, 0);
}

/// An aim in an obstacle moves to the nearest free point. The aim of the plan that is flown stays, if it is beside the
/// same goal and not much further away: two voxels.
TEST(FlightAim, OccupiedAimMovesToTheNearestFreePoint) {
  const Vec3 goal{8.125, 0.125, 1.125};
  const auto moved = [&](double nearest, double old, bool same_target, bool aims_at_goal = true) {
    FlightRoom room;
    FlightState& state = room.state();
    EXPECT_EQ(room.flight.set_goal(goal), Status::kOk);
    state.draft.takeover = 1000000000;
    state.cycle.aim.start.d[0] = room.start;
    state.cycle.aim.target_place = goal;
    state.cycle.remainder_is_free = state.facts.plans.in_flight.beside_target = true;
    state.facts.plans.in_flight.target = same_target ? 0 : 1;
    state.facts.plans.in_flight.place = {old, 0.125, 1.125};
    state.cycle.aim.at_target = aims_at_goal;
    Report found{};
    found.status = Status::kGoalOccupied;
    found.has_nearest_free = true;
    found.nearest_free = {nearest, 0.125, 1.125};
    EXPECT_EQ(ask_again(state, found), NextPlan::kAsked);
    EXPECT_EQ(state.cycle.job, Job::kAskPlan);
    EXPECT_EQ(state.cycle.aim.beside_target, aims_at_goal || same_target);
    EXPECT_FALSE(state.cycle.aim.at_target);
    return state.cycle.aim.place.x;
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
    state.draft.takeover = 1000000000;
    state.cycle.aim.start.d[0] = room.start;
    state.cycle.aim.target_place = {1.125, 0.125, 1.125};
    state.cycle.aim.asked_count = points;
    state.cycle.aim.asked[0].position = {0.125, 3.125, 1.125};
    Report found{};
    found.status = Status::kGoalOccupied;
    found.has_nearest_free = true;
    found.nearest_free = room.start;
    EXPECT_EQ(ask_again(state, found) == NextPlan::kAsked, points > 0);
    EXPECT_EQ(state.cycle.job, points > 0 ? Job::kAskPlan : Job::kIdle);
  }
}

TEST(FlightAim, OnlyOccupiedAimsMove) {
  FlightRoom room;
  FlightState& state = room.state();
  EXPECT_EQ(room.flight.set_goal({8.125, 0.125, 1.125}), Status::kOk);
  Report found{};
  found.status = Status::kNoPath;
  found.has_nearest_free = true;
  EXPECT_EQ(ask_again(state, found), NextPlan::kNone);
  found.status = Status::kGoalOccupied;
  state.cycle.aim.moved = true;
  EXPECT_EQ(ask_again(state, found), NextPlan::kNone);
  state.cycle.aim.moved = found.has_nearest_free = false;
  EXPECT_EQ(ask_again(state, found), NextPlan::kNone);
  EXPECT_FALSE(state.is_busy());
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
    state.facts.time = state.draft.takeover = 2000000000;
    state.cycle.aim.start = joint_at(state.facts.plans.in_flight.trajectory, 0.0, kZero);
    state.cycle.aim.target_place = state.cycle.aim.place = {8.125, 0.125, 1.125};
    state.cycle.all_free = true;
    state.cycle.aim.at_target = false;
    state.cycle.aim.beside_target = c.beside_goal;
    state.cycle.aim.asked_count = c.past_points ? 1 : 0;
    Report found{};
    found.status = Status::kNoPath;
    found.has_reachable = c.has_reachable;
    found.reachable = room.start;  // the vehicle rests there
    state.cycle.remainder_is_free = true;
    EXPECT_EQ(ask_again(state, found), c.cut_off ? NextPlan::kCutOff : NextPlan::kNone);
    EXPECT_EQ(state.cycle.cut_off, c.cut_off);
    expect_same(state.cycle.aim.place, {8.125, 0.125, 1.125});
  }
}

/// The rest of the plan that is flown leads to the old goal: with a new one it is no candidate, however free it is.
TEST(FlightAim, NewGoalDuringTheProofOfTheRestDropsIt) {
  for (const bool moves : {false, true}) {
    tern_test::Flying room;
    FlightState& state = room.state();
    for (int k = 0; k < 100000 && state.cycle.job != Job::kRemainder; ++k) room.advance(1);
    ASSERT_EQ(state.cycle.job, Job::kRemainder);
    if (moves) {
      ASSERT_EQ(room.flight.set_goal({8.125, 4.125, 1.125}), Status::kOk);
    }
    state.tick_work = tern::Work{};
    Work work{100000};
    ASSERT_EQ(state.cycle.prove_remainder(state.facts, state.draft, work), Progress::kDone);
    EXPECT_EQ(state.cycle.remainder_is_free, !moves);
  }
}

/// A ball of 0.3 m that comes to rest at a place after a second.
Track resting_at(const Vec3& place, const TrackPiece& still) {
  Track track;
  track.position = place;
  track.radius = 0.3;
  track.pieces = &still;
  track.piece_count = 1;
  return track;
}

// With 0.5 m kept and voxels of 0.25 m, a vehicle may end 0.925 m from its centre. Nearer aims move to 1.8 m.
TEST(FlightAim, LeavesRoomForWhatRestsThere) {
  const TrackPiece still{1.0, {}};
  const auto things = std::make_unique<TrackTable>();
  things->count = 1;
  const auto place_for = [&](const Vec3& goal, bool& moves) {
    Aim aim{};
    aim.start.d[0] = {0.0, 0.0, 1.0};
    aim.place = goal;
    aim.at_target = true;
    moves = aim.leave_room(*things, 0.5, 0.25);
    EXPECT_NE(aim.at_target, moves);
    return aim.place;
  };
  bool moves = false;
  things->tracks[0] = resting_at({10.0, 0.0, 1.0}, still);
  EXPECT_NEAR(place_for({10.0, 0.0, 1.0}, moves).x, 8.2, 1e-12);
  EXPECT_TRUE(moves);
  EXPECT_NEAR(place_for({10.5, 0.0, 1.0}, moves).x, 8.2, 1e-12);
  EXPECT_EQ(place_for({9.0, 0.0, 1.0}, moves).x, 9.0);
  EXPECT_FALSE(moves);
  EXPECT_NEAR(place_for({10.0, 0.84, 1.0}, moves).x, 10.0 - 1.6, 0.1);  // back along a way that passes beside it
  // Where there is no room on the way, it stays at its start.
  EXPECT_EQ(place_for({0.5, 0.0, 1.0}, moves).x, 0.5);
  things->tracks[0] = resting_at({0.5, 0.0, 1.0}, still);
  EXPECT_EQ(place_for({0.6, 0.0, 1.0}, moves).x, 0.0);
  EXPECT_TRUE(moves);
  // Out of the reach of one into that of the next.
  things->count = 2;
  things->tracks[0] = resting_at({10.0, 0.0, 1.0}, still);
  things->tracks[1] = resting_at({9.0, 0.0, 1.0}, still);
  EXPECT_NEAR(place_for({10.0, 0.0, 1.0}, moves).x, 7.2, 1e-12);
  // What stands still for certain counts likewise. What may move does not, nor what will be gone.
  things->count = 1;
  things->tracks[0].pieces = nullptr;
  things->tracks[0].piece_count = 0;
  EXPECT_NEAR(place_for({10.0, 0.0, 1.0}, moves).x, 8.2, 1e-12);
  things->tracks[0].error_growth = 1.0;
  EXPECT_EQ(place_for({10.0, 0.0, 1.0}, moves).x, 10.0);
  things->tracks[0] = resting_at({10.0, 0.0, 1.0}, still);
  things->tracks[0].end = TrackEnd::kGone;
  EXPECT_EQ(place_for({10.0, 0.0, 1.0}, moves).x, 10.0);
}

// Plans that fail because of things that move lead half as far, thrice; then the whole way again.
TEST(FlightAim, ShorterPlansFollowThoseThatMetThings) {
  FlightRoom room;
  Cycle& cycle = room.state().cycle;
  for (const double part : {1.0, 0.5, 0.25, 0.125, 1.0, 0.5}) {
    EXPECT_EQ(cycle.horizon(room.state().facts), part * room.spec.horizon);
    ++cycle.met_things;
  }
}

}  // namespace
