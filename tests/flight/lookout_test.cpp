// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// When a flight looks for a lookout, how it flies there and looks, and when it goes on.

#include <gtest/gtest.h>

#include "base/math.hpp"
#include "base/work.hpp"
#include "flight/stuck.hpp"
#include "support/flight_room.hpp"
#include "support/same.hpp"

namespace {

using namespace tern;
using tern_test::expect_same;
using tern_test::FlightRoom;
using tern_test::kLookoutGoal;
using tern_test::Stuck;

constexpr std::int64_t kOneSecond = 1000000000;

/// The end of what is committed stands still for half a second, three plans that were not dropped, and four frames.
TEST(FlightLookout, IsCalledForOnceNothingGoesOn) {
  Stuck room;
  EXPECT_TRUE(room.is_called_for(500000000, 3, 4));
  EXPECT_FALSE(room.is_called_for(499999999, 3, 4));
  EXPECT_FALSE(room.is_called_for(500000000, 2, 4));
  EXPECT_FALSE(room.is_called_for(500000000, 4, 4, 2));
  EXPECT_FALSE(room.is_called_for(500000000, 3, 3));
  room.look().not_before = 11 * kOneSecond;
  EXPECT_FALSE(room.is_called_for(500000000, 3, 4));
  EXPECT_TRUE(room.is_called_for(kOneSecond, 3, 4));
}

/// A plan that ends elsewhere begins it all anew.
TEST(FlightLookout, IsNotCalledForWhilePlansLeadOn) {
  Stuck room;
  FlightState& state = room.state();
  state.facts.time = 11 * kOneSecond;
  state.facts.plans.in_flight.trajectory.origin.x += 0.3;
  room.look().note_tick(state.facts, {3, 0});
  EXPECT_TRUE(room.is_called_for(kOneSecond, 3, 4));
  state.facts.time = 11 * kOneSecond;
  state.facts.plans.in_flight.trajectory.origin.x += 0.2;
  room.look().note_tick(state.facts, {3, 0});
  EXPECT_FALSE(room.is_called_for(kOneSecond + 499999999, 6, 8));
  EXPECT_FALSE(room.is_called_for(kOneSecond + 500000000, 5, 8));
  EXPECT_TRUE(room.is_called_for(kOneSecond + 500000000, 6, 8));
}

TEST(FlightLookout, IsNotCalledForWithoutNeed) {
  Stuck room;
  FlightState& state = room.state();
  room.look().left = 0;
  EXPECT_FALSE(room.is_called_for(kOneSecond, 9, 9));
  room.look().left = 1;
  EXPECT_TRUE(room.is_called_for(kOneSecond, 9, 9));
  state.facts.plans.in_flight.at_target = true;
  state.facts.plans.in_flight.mission = state.facts.itinerary.number;
  state.facts.plans.in_flight.branch = 1e9;
  EXPECT_FALSE(room.is_called_for(kOneSecond, 9, 9)) << "the plan ends at the goal";
  state.facts.plans.in_flight.at_target = false;
  ASSERT_EQ(room.map().follow({20.0, 0.0, 1.0}), Status::kRunning);
  EXPECT_FALSE(room.is_called_for(kOneSecond, 9, 9)) << "the map slides";
}

/// A vehicle that flies back and forth before a goal within its horizon is called to look after six plans, and then
/// after six more. If its goal is further away, the last three of them must have shown nothing new.
TEST(FlightLookout, IsCalledForIfTheVehicleWanders) {
  for (const bool is_far : {false, true}) {
    Stuck room;
    FlightState& state = room.state();
    const double away = distance(state.facts.position(), kLookoutGoal);
    state.facts.spec.horizon = is_far ? away - 0.01 : away + 0.01;
    const auto is_called_for = [&](int wandering, int fruitless) {
      state.facts.itinerary.wandering = wandering;
      state.facts.itinerary.fruitless = fruitless;
      return room.is_called_for(1, 1, 1);
    };
    EXPECT_FALSE(is_called_for(5, 5));
    EXPECT_EQ(is_called_for(6, 2), !is_far);
    EXPECT_TRUE(is_called_for(6, 3));
    room.search();
    room.look().phase = LookoutPhase::kIdle;
    room.look().not_before = 0;
    EXPECT_FALSE(is_called_for(11, 11));
    EXPECT_TRUE(is_called_for(12, 12));
  }
}

/// Before a corner, the route turns back to a way that is more than 4 m longer: the vehicle looks first, once. It does
/// not if the route has another end, or leads back no further than the vehicle came.
TEST(FlightLookout, IsCalledForIfTheRouteTurnsAway) {
  Stuck room;
  Lookouts& look = room.look();
  const Vec3 to{20.0, 0.0, 1.0};
  EXPECT_FALSE(look.turns_away({{0.0, 0.0, 1.0}, to, 30.0}));
  EXPECT_FALSE(look.turns_away({{3.0, 0.0, 1.0}, to, 37.0}));  // 3 + 30 + 4
  EXPECT_FALSE(look.turns_away({{3.0, 0.0, 1.0}, {20.0, 0.2, 1.0}, 60.0}));
  EXPECT_FALSE(look.turns_away({{3.0, 0.0, 1.0}, to, 27.0}));
  EXPECT_FALSE(room.is_called_for(1, 1, 1));
  EXPECT_TRUE(look.turns_away({{5.0, 0.0, 1.0}, to, 33.01}));
  EXPECT_TRUE(room.is_called_for(1, 1, 1));
  room.search();
  EXPECT_FALSE(look.turns_away({{5.0, 0.0, 1.0}, to, 60.0})) << "on the way to a lookout";
  look.phase = LookoutPhase::kIdle;
  look.not_before = 0;
  EXPECT_FALSE(room.is_called_for(1, 1, 1));
  EXPECT_FALSE(look.turns_away({{5.0, 0.0, 1.0}, to, 33.01}));
  look.left = 0;
  EXPECT_FALSE(look.turns_away({{5.0, 0.0, 1.0}, to, 60.0}));
}

/// From where the vehicle is, the camera sees what is ahead: it stays, and looks.
TEST(FlightLookout, IsWhereTheVehicleIsIfThatWillDo) {
  Stuck room;
  room.search();
  EXPECT_EQ(room.look().phase, LookoutPhase::kOnWay);
  EXPECT_EQ(room.look().left, kMostLookouts - 1);
  expect_same(room.look().place(), room.start);
  EXPECT_TRUE(room.look().needs_no_plan(room.state().facts));
  room.follow(0);
  EXPECT_EQ(room.look().phase, LookoutPhase::kLooking);
  EXPECT_GT(room.state().looking_at(room.state().facts.time).x, 3.0);
}

/// As soon as the voxels are seen, the flight goes on.
TEST(FlightLookout, EndsOnceAllIsSeen) {
  Stuck room;
  room.search();
  room.follow(kOneSecond);
  room.follow(kOneSecond);
  EXPECT_TRUE(room.look().is_active());
  room.set_seen(true);
  room.follow(1);
  EXPECT_EQ(room.look().phase, LookoutPhase::kIdle);
  EXPECT_EQ(room.look().tried.failures, 0);
  EXPECT_EQ(room.look().tried.kept_voxels(), 0);
}

/// Voxels that do not come into sight are remembered, and so is the lookout.
TEST(FlightLookout, RemembersWhatItDidNotSee) {
  Stuck room;
  room.search();
  room.follow(0);
  room.follow(2 * kOneSecond);  // the gimbal points there
  EXPECT_GE(room.look().aligned, 0);
  room.state().facts.frames += 3;
  room.follow(149999999);
  EXPECT_TRUE(room.look().is_active());
  room.follow(1);
  EXPECT_EQ(room.look().phase, LookoutPhase::kIdle);
  EXPECT_EQ(room.look().tried.failures, 1);
  EXPECT_EQ(room.look().tried.kept_voxels(), smaller(room.look().search.lookout.hidden_count, kTriedVoxels));
}

/// The caller may ask what was looked at in vain, and from where, until there is a new goal.
TEST(FlightLookout, TellsWhatWasLookedAtInVain) {
  Stuck room;
  EXPECT_EQ(room.flight.looked_in_vain(nullptr, 0), 0);
  room.search();
  room.follow(0);
  room.follow(4 * kOneSecond);
  room.follow(1);
  const Viewpoint& lookout = room.look().search.lookout;
  const std::int32_t count = room.flight.looked_in_vain(nullptr, 0);
  ASSERT_EQ(count, smaller(lookout.hidden_count, kTriedVoxels));
  ASSERT_GT(count, 1);
  UnseenVoxel found[kTriedVoxels];
  found[1].views = -1;
  EXPECT_EQ(room.flight.looked_in_vain(found, 1), count);
  EXPECT_EQ(found[1].views, -1);
  EXPECT_EQ(room.flight.looked_in_vain(found, kTriedVoxels), count);
  for (std::int32_t k = 0; k < count; ++k) {
    EXPECT_EQ(found[k].views, 1);
    EXPECT_TRUE(is_unseen_at(room.map(), found[k].center));
    const Vec3 way = found[k].center - lookout.place;
    EXPECT_NEAR(dot(found[k].directions[0], way), length(way), 1e-12);
  }
  room.set_seen(true);
  EXPECT_EQ(room.flight.looked_in_vain(nullptr, 0), 0);
  room.set_seen(false);
  EXPECT_EQ(room.flight.set_goal(kLookoutGoal), Status::kOk);
  EXPECT_EQ(room.flight.looked_in_vain(nullptr, 0), 0);
  EXPECT_EQ(Flight().looked_in_vain(found, kTriedVoxels), 0);
}

/// Without frames, a look ends after four seconds.
TEST(FlightLookout, LooksForFourSecondsAtMost) {
  Stuck room;
  room.search();
  room.follow(0);
  room.follow(4 * kOneSecond);
  EXPECT_TRUE(room.look().is_active());
  room.follow(1);
  EXPECT_FALSE(room.look().is_active());
}

/// A lookout that cannot be flown to is of no use.
TEST(FlightLookout, IsGivenUpIfNoPlanLeadsThere) {
  Stuck room;
  room.search();
  room.look().search.lookout.place.y += 2.0;
  EXPECT_FALSE(room.look().needs_no_plan(room.state().facts));
  for (int k = 1; k < kFailedCycles; ++k) room.look().note_failure(room.state().facts);
  EXPECT_TRUE(room.look().leads());
  room.look().note_failure(room.state().facts);
  EXPECT_EQ(room.look().phase, LookoutPhase::kIdle);
  EXPECT_EQ(room.look().tried.failures, 1);
  room.search();
  room.look().search.lookout.place.y += 2.0;
  room.follow(100 * kOneSecond);
  EXPECT_EQ(room.look().phase, LookoutPhase::kIdle) << "too late";
  EXPECT_EQ(room.look().tried.failures, 2);
}

/// A search for an end that is no longer committed says nothing, nor does one for another goal.
TEST(FlightLookout, OutdatedAnswersAreDropped) {
  for (const bool moves : {true, false}) {
    Stuck room;
    FlightState& state = room.state();
    room.look().begin(state.facts, state.nose, kLookoutGoal);
    if (moves) state.facts.plans.in_flight.trajectory.origin.x += 1.0;
    if (!moves) state.facts.itinerary.points[0].position.y += 1.0;
    Work work(100000);
    room.look().advance(state.facts, work);
    EXPECT_EQ(room.look().phase, LookoutPhase::kIdle);
    EXPECT_EQ(room.look().left, kMostLookouts);
    EXPECT_GT(room.look().not_before, state.facts.time);
  }
}

/// All of the way is known: a vehicle at rest flies to the end of it, once.
TEST(FlightLookout, LeadsAlongAKnownWayOnce) {
  Stuck room;
  room.set_seen(true);
  room.search();
  EXPECT_EQ(room.look().phase, LookoutPhase::kOnWay);
  EXPECT_EQ(room.look().search.lookout.hidden_count, 0);
  EXPECT_LT(distance(room.look().place(), kLookoutGoal), 0.5);
  room.look().phase = LookoutPhase::kIdle;
  room.search();
  EXPECT_EQ(room.look().phase, LookoutPhase::kIdle);
  EXPECT_TRUE(room.look().found_nothing);
}

/// A search does not depend on its slices.
TEST(FlightLookout, IsSoughtInSlices) {
  Stuck whole;
  whole.search();
  Stuck sliced;
  EXPECT_GT(sliced.search(1), 10);
  expect_same(sliced.look().place(), whole.look().place());
  expect_same(sliced.look().search.lookout.look, whole.look().search.lookout.look);
}

/// Eight, unless the vehicle comes half a metre nearer to its goal.
TEST(FlightLookout, AreFew) {
  Stuck room;
  FlightState& state = room.state();
  EXPECT_TRUE(room.look().left == kMostLookouts);
  room.look().left = 3;
  state.facts.plans.in_flight.trajectory.origin.x += 0.4;
  room.look().note_tick(state.facts, {1, 0});
  EXPECT_EQ(room.look().left, 3);
  state.facts.plans.in_flight.trajectory.origin.x += 0.2;
  room.look().note_tick(state.facts, {1, 0});
  EXPECT_EQ(room.look().left, kMostLookouts);
}

/// Lookouts that show all that they should do not count as in vain, 32 times.
TEST(FlightLookout, CountsThoseInVain) {
  Stuck room;
  for (int k = 0; k < kMostShown + 2; ++k) {
    room.set_seen(false);
    room.search();
    ASSERT_TRUE(room.look().is_active());
    room.set_seen(true);
    room.follow(1);
    EXPECT_EQ(room.look().left, k < kMostShown ? kMostLookouts : kMostLookouts - 1 - (k - kMostShown));
  }
}

}  // namespace
