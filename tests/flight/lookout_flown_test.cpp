// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lookouts that flights fly to, and those that they have looked from in vain.

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
using tern_test::Stuck;

constexpr Vec3 kGoal = tern_test::kLookoutGoal;
constexpr std::int64_t kSecond = 1000000000;

/// The map stands still during a search, and no other plan is made; then the vehicle flies to the lookout past no point
/// of the mission, looks at what it should see, and goes on to its goal once it has seen that.
TEST(FlightLookout, IsFlownTo) {
  FlightRoom room;
  Via points[2];
  points[0].position = {6.0, 0.0, 1.125};
  points[1].position = kGoal;
  ASSERT_EQ(room.flight.set_mission(points, 2, ViaPolicy::kEnd), Status::kOk);
  FlightState& state = room.state();
  Grid safe = room.map().safe();
  const Box hidden{{3.0, -16.0, -2.0}, {3.5, 16.0, 4.0}};
  ASSERT_EQ(safe.mark_box(hidden), Status::kOk);
  safe.inflate();
  ASSERT_TRUE(room.tick_until([&] { return room.report.committed > 0; }));
  state.lookouts.begin(state.facts, state.nose, kGoal);
  ASSERT_TRUE(room.tick_until([&] { return state.lookouts.leads(); }));
  const Vec3 place = state.lookouts.place();
  EXPECT_GT(distance(place, room.position()), 0.9);
  ASSERT_TRUE(room.tick_until([&] { return state.facts.plans.latest().looks_out; }));
  expect_same(room.flight.rest_position(), place);
  EXPECT_EQ(state.facts.plans.latest().passages, 0);
  ASSERT_TRUE(room.tick_until([&] { return room.report.mode == FlightMode::kLook; }));
  EXPECT_LT(distance(room.position(), place), 0.06);
  EXPECT_EQ(state.lookouts.phase, LookoutPhase::kLooking);
  Grid now = room.map().safe();  // the window slid
  ASSERT_EQ(now.clear_box(hidden), Status::kOk);
  now.inflate();
  EXPECT_EQ(room.fly(), FlightReason::kArrived);
}

/// A vehicle at rest waits for a lookout before it looks around, as long as frames come and lookouts are left.
TEST(FlightLookout, ComesBeforeALookAround) {
  Stuck room;
  FlightState& state = room.state();
  state.facts.frames = 1;
  state.facts.frame_time = state.facts.time;
  for (int k = 0; k < 2 * kIdleCycles; ++k) state.give_up();
  EXPECT_FALSE(state.search.is_looking);
  room.look().found_nothing = true;
  state.give_up();
  EXPECT_TRUE(state.search.is_looking);
  EXPECT_TRUE(room.look().left > 0 && !room.look().may_help(state.facts));
  room.look().found_nothing = false;
  EXPECT_TRUE(room.look().may_help(state.facts));
  state.facts.time += kSecond;
  EXPECT_FALSE(room.look().may_help(state.facts));
}

/// Where it begins its way to a goal beyond the horizon, a vehicle looks in all directions before it looks for a
/// lookout, once. Nearer to the goal, or further on its way, it does not.
TEST(FlightLookout, ComesAfterASurveyWhereTheWayBegins) {
  Stuck room;
  FlightState& state = room.state();
  ASSERT_EQ(room.flight.set_goal({10.125, 0.125, 1.125}), Status::kOk);
  EXPECT_TRUE(state.search.wants_survey(state.facts));
  state.facts.frames = 1;
  state.facts.frame_time = state.facts.time;
  for (int k = 0; k < kIdleCycles; ++k) state.give_up();
  EXPECT_TRUE(state.search.is_looking);
  state.facts.time += 3720000000;  // four directions of 0.928 s, and no stare
  state.facts.frame_time = state.facts.time;
  state.give_up();
  EXPECT_FALSE(state.search.is_looking);
  EXPECT_FALSE(state.search.turned);
  EXPECT_FALSE(state.search.wants_survey(state.facts));
  ASSERT_EQ(room.flight.set_goal({10.125, 0.125, 1.125}), Status::kOk);
  EXPECT_TRUE(state.search.wants_survey(state.facts));
  state.facts.plans.in_flight.trajectory.origin.x -= 2.125;  // more than four radii
  EXPECT_FALSE(state.search.wants_survey(state.facts));
  ASSERT_EQ(room.flight.set_goal(kGoal), Status::kOk);
  state.facts.plans.in_flight.trajectory.origin.x += 2.125;
  EXPECT_FALSE(state.search.wants_survey(state.facts));
}

/// A vehicle that gains centimetres at a time never looks around: after five searches in vain, what was tried is
/// forgotten, once.
TEST(FlightLookout, ForgetsWhatItTriedAfterFiveSearchesInVain) {
  Stuck room;
  room.set_seen(true);
  room.search();  // all of the way is known: it leads on, once
  room.look().phase = LookoutPhase::kIdle;
  room.look().tried.note_voxel({3.125, 1.125, 1.125}, room.start, FlightRoom::kCell);
  for (int k = 1; k < kInVain; ++k) room.search();
  EXPECT_EQ(room.look().tried.kept_voxels(), 1);
  EXPECT_FALSE(room.look().is_last_try);
  room.search();
  EXPECT_EQ(room.look().tried.kept_voxels(), 0);
  EXPECT_TRUE(room.look().is_last_try);
}

/// A flight that gives up names the voxel that it looked at from the most directions and did not see.
TEST(FlightLookout, NamesWhatItLookedAtInVain) {
  Stuck room;
  FlightState& state = room.state();
  const Vec3 once{3.125, 1.125, 1.125};
  const Vec3 twice{3.125, 0.125, 1.125};
  const Vec3 seen{2.125, 0.125, 1.125};
  room.look().tried.note_voxel(once, room.start, FlightRoom::kCell);
  for (int k = 0; k < 2; ++k) room.look().tried.note_voxel(twice, room.start, FlightRoom::kCell);
  for (int k = 0; k < 3; ++k) room.look().tried.note_voxel(seen, room.start, FlightRoom::kCell);
  state.park(FlightReason::kNoProgress);
  EXPECT_EQ(state.facts.itinerary.reason, FlightReason::kGoalUnseen);
  EXPECT_EQ(state.block.by, BlockedBy::kUnseen);
  expect_same(state.block.at, twice);
}

/// If what the way needs can be seen from nowhere, that is the reason, and its first voxel is named; unless a fence is
/// in the way.
TEST(FlightLookout, SaysWhatCanBeSeenFromNowhere) {
  struct Case {
    LookoutAnswer answer;
    BlockedBy by;
    FlightReason why;
  };
  for (const Case& c : {Case{LookoutAnswer::kNoSight, BlockedBy::kUnseen, FlightReason::kGoalUnseen},
                        Case{LookoutAnswer::kNoSight, BlockedBy::kFence, FlightReason::kNoProgress},
                        Case{LookoutAnswer::kNoWay, BlockedBy::kUnseen, FlightReason::kNoProgress}}) {
    Stuck room;
    FlightState& state = room.state();
    room.search();
    ASSERT_TRUE(room.look().search.has_needed);
    EXPECT_NEAR(room.look().search.needed.x, 3.125, 1e-9);  // the near side of what nobody saw
    room.look().search.answer = c.answer;
    room.look().found_nothing = true;
    state.block = {c.by, room.start, kNoFence};
    state.park(FlightReason::kNoProgress);
    EXPECT_EQ(state.facts.itinerary.reason, c.why);
    expect_same(state.block.at, c.why == FlightReason::kGoalUnseen ? room.look().search.needed : room.start);
  }
}

/// Searches that find nothing, kInVain of them and as many after what was tried is forgotten: there is no hope. If one
/// learns something in between, all is begun anew.
TEST(FlightLookout, IsHopelessAfterSearchesInVain) {
  Stuck room;
  room.set_seen(true);
  Lookouts& look = room.look();
  const FlightFacts& facts = room.state().facts;
  // All of the way is known: it leads on, once before what was tried is forgotten and once after.
  const auto search_in_vain = [&] {
    const int before = look.in_vain;
    for (int k = 0; k < 2 && look.in_vain == before; ++k) {
      room.search();
      look.phase = LookoutPhase::kIdle;
    }
    look.search.answer = LookoutAnswer::kNoSight;
  };
  for (int k = 0; k < 2 * kInVain; ++k) {
    EXPECT_FALSE(look.is_hopeless(facts)) << k;
    search_in_vain();
  }
  EXPECT_TRUE(look.is_hopeless(facts));
  look.search.answer = LookoutAnswer::kNoWay;
  EXPECT_FALSE(look.is_hopeless(facts)) << "it may be cut off";
  look.learned -= kLearned;
  search_in_vain();
  EXPECT_FALSE(look.is_hopeless(facts));
}

/// No lookout is left: a hundred plans to and fro, and there is no hope; unless they show something, or there is a
/// lookout again.
TEST(FlightLookout, IsHopelessToAndFroAfterTheLast) {
  Stuck room;
  Lookouts& look = room.look();
  FlightFacts& facts = room.state().facts;
  look.left = 0;
  look.learned = facts.map.learned();
  facts.itinerary.wandering = look.wandering_due + kPlansAfterLast - 1;
  EXPECT_FALSE(look.is_hopeless(facts));
  ++facts.itinerary.wandering;
  EXPECT_TRUE(look.is_hopeless(facts));
  look.learned -= kPlansAfterLast * kLearned;
  EXPECT_FALSE(look.is_hopeless(facts));
  look.learned += kPlansAfterLast * kLearned;
  look.left = 1;
  EXPECT_FALSE(look.is_hopeless(facts));
}

/// On the way to a lookout, the vehicle flies only as far as it gets.
TEST(FlightLookout, IsLeftIfTheWayThereLeadsNoFurther) {
  for (const std::uint32_t plans : {2u, 3u}) {
    Stuck room;
    FlightState& state = room.state();
    room.search();
    ASSERT_EQ(room.look().phase, LookoutPhase::kOnWay);
    room.look().search.lookout.place.x += 2.0;
    room.look().note_tick(state.facts, {state.report.asked, 0});
    state.report.asked += plans;
    state.facts.frames += 4;
    room.follow(500000000);
    EXPECT_EQ(room.look().phase, plans == 3 ? LookoutPhase::kIdle : LookoutPhase::kOnWay);
  }
}

/// After a look around, a search may find what it did not find before: the flight gives up only after that.
TEST(FlightLookout, IsSoughtOnceMoreAfterALookAround) {
  Stuck room;
  FlightState& state = room.state();
  room.look().found_nothing = true;
  state.facts.frames = 1;
  for (int k = 0; k < kIdleCycles; ++k) state.give_up();
  EXPECT_TRUE(state.search.is_looking);
  state.facts.time += 6720000000;
  state.facts.frame_time = state.facts.time;
  state.give_up();
  EXPECT_TRUE(state.search.turned);
  EXPECT_FALSE(state.facts.itinerary.parked);
  EXPECT_FALSE(room.look().found_nothing);
  room.look().found_nothing = true;
  state.give_up();
  EXPECT_EQ(state.facts.itinerary.reason, FlightReason::kNoProgress);
}

}  // namespace
