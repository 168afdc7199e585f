// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which points of a mission the next plan is asked for, and what follows where it fails.
#include <gtest/gtest.h>

#include <vector>

#include "base/math.hpp"
#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;

/// A wall from 4.5 to 5.5 m along x, around the third of the points below.
const Box kWall{{4.5, -1.0, -2.0}, {5.5, 1.0, 4.0}};

/// A mission along x: points at 1, 3, 5, 7 and 20 m.
struct Way : FlightRoom {
  explicit Way(ViaPolicy policy = ViaPolicy::kSkip, const std::vector<Box>& solid = {})
      : FlightRoom(flight_spec(), solid) {
    Via points[5];
    const double xs[] = {1.0, 3.0, 5.0, 7.0, 20.0};
    for (int i = 0; i < 5; ++i) points[i].position = {xs[i], 0.125, 1.125};
    EXPECT_EQ(flight.set_mission(points, 5, policy), Status::kOk);
    state().draft.takeover = 0;
    state().cycle.aim.start.d[0] = start;
    state().cycle.aim.choose_points(state().facts, state().draft.takeover);
    state().cycle.aim.place = state().cycle.aim.target_place;
  }
};

/// What follows the failure of a plan.
NextPlan ask_again(FlightState& state, const Report& report) {
  return state.cycle.next_after_plan(state.facts, report, state.draft.takeover);
}

Report found(Status status, std::int32_t via = kNoVia) {
  Report report{};
  report.status = status;
  report.via = via;
  return report;
}

/// Clear of the window's faces by the radius of 0.5 m and two voxels: 1 m.
TEST(FlightPoints, WindowEndsBeforeItsFaces) {
  FlightRoom room;
  const Vec3 middle{0.0, 0.0, 1.0};
  const double lower[] = {-15.0, -15.0, -1.0};
  const double upper[] = {15.0, 15.0, 3.0};
  for (int a = 0; a < 3; ++a) {
    Vec3 place = middle;
    const auto in_window = [&](double at) {
      axis(place, a) = at;
      return room.state().facts.in_window(place);
    };
    EXPECT_TRUE(in_window(lower[a]));
    EXPECT_FALSE(in_window(lower[a] - 0.01));
    EXPECT_TRUE(in_window(upper[a]));
    EXPECT_FALSE(in_window(upper[a] + 0.01));
  }
}

/// Points within the horizon of 8 m are passed, but for those beyond the window.
TEST(FlightPoints, PointsWithinTheHorizonAndTheWindowArePassed) {
  Way way;
  FlightState& state = way.state();
  EXPECT_EQ(state.cycle.aim.asked_count, 4);
  EXPECT_EQ(state.cycle.aim.target, 4);
  EXPECT_EQ(state.cycle.aim.target_place.x, 20.0);
  state.facts.itinerary.points[2].position.z = 3.5;
  state.cycle.aim.choose_points(state.facts, state.draft.takeover);
  EXPECT_EQ(state.cycle.aim.asked_count, 2);
  EXPECT_EQ(state.cycle.aim.target, 2);
  EXPECT_EQ(state.cycle.aim.target_place.z, 3.5);
  state.facts.itinerary.points[2].position = {5.0, 7.0, 1.125};  // 0.9 + 2 + 7.2 m
  state.cycle.aim.choose_points(state.facts, state.draft.takeover);
  EXPECT_EQ(state.cycle.aim.asked_count, 2);
}

/// A point that was taken for blocked and is clear on the map as it is now.
TEST(FlightPoints, SuspicionEndsWhereThePointIsSeenClear) {
  Way way(ViaPolicy::kSkip, {kWall});
  FlightState& state = way.state();
  const auto suspicions_of = [&](std::int32_t point) {
    state.facts.itinerary.suspect = point;
    state.facts.itinerary.suspicions = 2;
    state.facts.itinerary.clear_suspicion(state.facts);
    return state.facts.itinerary.suspicions;
  };
  EXPECT_EQ(suspicions_of(2), 2);
  EXPECT_EQ(suspicions_of(3), 0);
  EXPECT_EQ(suspicions_of(4), 0);  // beyond the window, where nothing was seen
  ASSERT_EQ(way.map().follow({20.0, 0.0, 1.0}), Status::kRunning);
  EXPECT_EQ(suspicions_of(3), 2);  // not known while the window slides
}

TEST(FlightPoints, PlanFitsWhileItsPointsAreAhead) {
  Way way;
  FlightState& state = way.state();
  state.facts.plans.in_flight.passages = 2;
  state.facts.plans.in_flight.passage[0] = {1, 0.5};
  state.facts.plans.in_flight.passage[1] = {2, 1.0};
  state.facts.plans.in_flight.target = 3;
  EXPECT_TRUE(state.facts.itinerary.still_fits(state.facts.plans.in_flight));
  state.facts.itinerary.state[1] = PointState::kPassed;
  EXPECT_TRUE(state.facts.itinerary.still_fits(state.facts.plans.in_flight));
  state.facts.itinerary.state[2] = PointState::kSkipped;
  EXPECT_FALSE(state.facts.itinerary.still_fits(state.facts.plans.in_flight));
  state.facts.plans.in_flight.passages = 1;
  EXPECT_TRUE(state.facts.itinerary.still_fits(state.facts.plans.in_flight));
  state.facts.itinerary.state[3] = PointState::kSkipped;
  EXPECT_FALSE(state.facts.itinerary.still_fits(state.facts.plans.in_flight));
}

/// A plan that does not lead to the next point passes it neither earlier nor later.
TEST(FlightPoints, OnlyAPlanThatPassesTheNextPointKeepsOneThatPassesItLater) {
  Way way;
  FlightState& state = way.state();
  state.draft.takeover = 2000000000;  // 2 s into the plan that is flown
  state.facts.plans.in_flight.passages = state.draft.plan.passages = 0;
  EXPECT_FALSE(state.draft.passes_later(state.facts));
  state.draft.plan.passages = 1;
  state.draft.plan.passage[0] = {state.facts.itinerary.leg, 5.0};
  EXPECT_FALSE(state.draft.passes_later(state.facts));
  state.facts.plans.in_flight.passages = 1;
  state.facts.plans.in_flight.passage[0] = {state.facts.itinerary.leg, 4.0};  // 2 s ahead
  EXPECT_TRUE(state.draft.passes_later(state.facts));
  state.draft.plan.passage[0].time = 2.2;
  EXPECT_FALSE(state.draft.passes_later(state.facts));
  state.draft.plan.passages = 0;
  EXPECT_TRUE(state.draft.passes_later(state.facts));
}

/// After a failure on the way to a point, the next plan ends at the one before; after any other one at the next point.
TEST(FlightPoints, NextPlanEndsBeforeWhereTheLastOneFailed) {
  const auto target_after = [](const Report& report) {
    Way way;
    EXPECT_EQ(ask_again(way.state(), report), NextPlan::kAsked);
    EXPECT_EQ(way.state().cycle.aim.asked_count, way.state().cycle.aim.target);
    EXPECT_TRUE(way.state().cycle.aim.at_target);
    EXPECT_EQ(way.state().cycle.aim.place.x,
              way.state().facts.itinerary.points[way.state().cycle.aim.target].position.x);
    EXPECT_EQ(way.state().cycle.job, Job::kAskPlan);
    return way.state().cycle.aim.target;
  };
  for (const Status status :
       {Status::kNoPath, Status::kViaOccupied, Status::kViaFenced, Status::kGoalOccupied, Status::kGoalFenced}) {
    EXPECT_EQ(target_after(found(status)), 3);  // on the last leg
    EXPECT_EQ(target_after(found(status, 3)), 2);
    EXPECT_EQ(target_after(found(status, 2)), 1);
    EXPECT_EQ(target_after(found(status, 1)), 0);
    EXPECT_EQ(target_after(found(status, 0)), 0);
  }
  EXPECT_EQ(target_after(found(Status::kBudgetSearch)), 0);
  EXPECT_EQ(target_after(found(Status::kBudgetSearch, 3)), 0);
}

TEST(FlightPoints, NothingIsLeftToAskForLessOf) {
  Way way;
  FlightState& state = way.state();
  state.cycle.remainder_is_free = true;
  EXPECT_EQ(ask_again(state, found(Status::kNoPath)), NextPlan::kNone);
  state.cycle.remainder_is_free = false;
  state.cycle.aim.asked_count = 0;
  EXPECT_EQ(ask_again(state, found(Status::kNoPath)), NextPlan::kNone);
}

TEST(FlightPoints, NothingComesAfterTheGoal) {
  Way way;
  FlightState& state = way.state();
  state.facts.itinerary.state[2] = state.facts.itinerary.state[3] = PointState::kSkipped;
  state.facts.itinerary.go_on_from(1);
  EXPECT_EQ(state.facts.itinerary.leg, 4);
  state.facts.itinerary.go_on_from(4);
  EXPECT_EQ(state.facts.itinerary.leg, 4);
}

TEST(FlightPoints, PlansFailAtAViaOrAtThePointThatTheyEndAt) {
  Way way;
  FlightState& state = way.state();
  EXPECT_EQ(state.cycle.aim.point_at_fault(found(Status::kViaOccupied, 2), state.facts.itinerary), 2);
  EXPECT_EQ(state.cycle.aim.point_at_fault(found(Status::kViaFenced, 1), state.facts.itinerary), 1);
  EXPECT_EQ(state.cycle.aim.point_at_fault(found(Status::kViaOccupied), state.facts.itinerary), -1);
  EXPECT_EQ(state.cycle.aim.point_at_fault(found(Status::kNoPath, 2), state.facts.itinerary), -1);
  state.cycle.aim.at_target = true;
  EXPECT_EQ(state.cycle.aim.point_at_fault(found(Status::kGoalOccupied), state.facts.itinerary),
            -1);  // the goal is never left out
  state.cycle.aim.end_at_point(1, state.facts.itinerary);
  EXPECT_EQ(state.cycle.aim.point_at_fault(found(Status::kGoalOccupied), state.facts.itinerary), 1);
  EXPECT_EQ(state.cycle.aim.point_at_fault(found(Status::kGoalFenced), state.facts.itinerary), 1);
  state.cycle.aim.at_target = false;
  EXPECT_EQ(state.cycle.aim.point_at_fault(found(Status::kGoalFenced), state.facts.itinerary), -1);
}

/// A fence is a fact; what was seen is believed at the third time.
TEST(FlightPoints, FencedPointsAreLeftOutAtOnce) {
  for (const Status status : {Status::kViaFenced, Status::kGoalFenced}) {
    Way way;
    FlightState& state = way.state();
    if (status == Status::kGoalFenced) state.cycle.aim.end_at_point(2, state.facts.itinerary);
    EXPECT_TRUE(state.note_fault(found(status, 2)));
    EXPECT_EQ(way.flight.point_state(2), PointState::kSkipped);
  }
}

TEST(FlightPoints, OccupiedPointsAreLeftOutAtTheThirdTime) {
  Way way(ViaPolicy::kSkip, {kWall});
  FlightState& state = way.state();
  const Report blocked = found(Status::kViaOccupied, 2);
  const Report clear = found(Status::kViaOccupied, 3);
  EXPECT_FALSE(state.note_fault(blocked));
  EXPECT_FALSE(state.note_fault(clear));  // the route says otherwise
  EXPECT_EQ(state.facts.itinerary.suspicions, 1);
  EXPECT_FALSE(state.note_fault(blocked));
  EXPECT_EQ(way.flight.point_state(2), PointState::kAhead);
  ASSERT_EQ(way.map().follow({20.0, 0.0, 1.0}), Status::kRunning);  // while the window slides, nothing is known
  EXPECT_FALSE(state.note_fault(blocked));
  EXPECT_EQ(state.facts.itinerary.suspicions, 2);
  while (way.map().step(100000) == Status::kRunning) {
  }
  EXPECT_TRUE(state.note_fault(blocked));
  EXPECT_EQ(way.flight.point_state(2), PointState::kSkipped);
}

/// The goal is reached at rest, whatever tolerance it has.
TEST(FlightPoints, GoalHasNoTolerance) {
  FlightRoom room;
  Via goal;
  goal.position = {3.0, 0.5, 1.0};
  goal.tolerance = 2.0;
  ASSERT_EQ(room.flight.set_mission(&goal, 1, ViaPolicy::kEnd), Status::kOk);
  while (room.time < 20000000000 && room.report.reason != FlightReason::kArrived) {
    EXPECT_EQ(room.flight.point_state(0), PointState::kAhead);
    room.tick();
  }
  EXPECT_EQ(room.report.passed, 1);
  EXPECT_NEAR(room.position().x, 3.0, 1e-9);
  EXPECT_EQ(room.speed(), 0.0);
}

/// The next plan to the same aim passes the points that the plan being flown still has ahead of it.
TEST(FlightPoints, KeptPlansPassWhatIsAhead) {
  FlightRoom room;
  const Via points[3] = {{{1.625, 1.125, 1.125}}, {{3.125, -0.875, 1.125}}, {{4.625, 0.125, 1.125}}};
  ASSERT_EQ(room.flight.set_mission(points, 3, ViaPolicy::kEnd), Status::kOk);
  FlightState& state = room.state();
  ASSERT_TRUE(room.tick_until(
      [&] { return state.facts.plans.in_flight.at_target && state.facts.plans.in_flight.passages == 3; }, 400));
  ASSERT_EQ(state.facts.plans.in_flight.target, 2);
  const auto kept = [&](std::int64_t at) {
    state.draft.takeover = at;
    state.cycle.aim.follow_points(state.facts.plans.in_flight, state.facts.itinerary, state.draft.takeover);
    std::vector<std::int32_t> numbers(state.cycle.aim.asked_point,
                                      state.cycle.aim.asked_point + state.cycle.aim.asked_count);
    EXPECT_EQ(state.cycle.aim.target, 2);
    return numbers;
  };
  const auto passed = [&](int k) {
    return state.facts.plans.in_flight.begin() +
           static_cast<std::int64_t>(1e9 * state.facts.plans.in_flight.passage[k].time);
  };
  EXPECT_EQ(kept(state.facts.plans.in_flight.begin()), (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(kept(passed(0) + 1000), std::vector<std::int32_t>{1});
  EXPECT_EQ(kept(passed(1) + 1000), std::vector<std::int32_t>{});
}

}  // namespace
