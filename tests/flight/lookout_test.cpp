// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// When a flight looks for a lookout, how it flies there and looks, and when it goes on.
#include <gtest/gtest.h>

#include <vector>

#include "base/math.hpp"
#include "base/work.hpp"
#include "support/flight_room.hpp"
#include "support/same.hpp"

namespace {

using namespace tern;
using tern_test::expect_same;
using tern_test::FlightRoom;

constexpr Vec3 kGoal{8.125, 0.125, 1.125};
constexpr std::int64_t kSecond = 1000000000;

/// At rest before a plane of voxels that nobody saw, from 3 m to 3.5 m along x.
struct Stuck : FlightRoom {
  explicit Stuck(const std::vector<Box>& solid = {}) : FlightRoom(flight_spec(), solid) {
    EXPECT_EQ(flight.set_goal(kGoal), Status::kOk);
    set_seen(false);
    state().facts.time = 10 * kSecond;
    look().note_tick(state().facts, {0, 0});
  }
  Lookouts& look() { return state().lookouts; }
  void set_seen(bool seen) {
    Grid safe = map().safe();
    const Box box{{3.0, -16.0, -2.0}, {3.5, 16.0, 4.0}};
    EXPECT_EQ(seen ? safe.clear_box(box) : safe.mark_box(box), Status::kOk);
    safe.inflate();
  }
  /// So many nanoseconds, plans and frames later.
  bool is_called_for(std::int64_t later, std::uint32_t plans, std::uint64_t frames, std::uint32_t dropped = 0) {
    state().facts.time = 10 * kSecond + later;
    state().facts.frames = frames;
    return look().is_called_for(state().facts, state().nose, {plans, dropped});
  }
  /// Searches, in as many slices of `units` as it takes.
  int search(std::uint32_t units = 100000) {
    look().begin(state().facts, state().nose, kGoal);
    int slices = 0;
    for (; look().is_searching() && slices < 100000; ++slices) {
      Work work(units);
      look().advance(state().facts, work);
    }
    return slices;
  }
  void follow(std::int64_t later) {
    state().facts.time += later;
    look().follow(state().facts, state().nose, {state().report.asked, 0});
  }
};

/// The end of what is committed stands still for half a second, three plans that were not dropped, and four frames.
TEST(FlightLookout, IsCalledForOnceNothingGoesOn) {
  Stuck room;
  EXPECT_TRUE(room.is_called_for(500000000, 3, 4));
  EXPECT_FALSE(room.is_called_for(499999999, 3, 4));
  EXPECT_FALSE(room.is_called_for(500000000, 2, 4));
  EXPECT_FALSE(room.is_called_for(500000000, 4, 4, 2));
  EXPECT_FALSE(room.is_called_for(500000000, 3, 3));
  room.look().not_before = 11 * kSecond;
  EXPECT_FALSE(room.is_called_for(500000000, 3, 4));
  EXPECT_TRUE(room.is_called_for(kSecond, 3, 4));
}

/// A plan that ends elsewhere begins it all anew.
TEST(FlightLookout, IsNotCalledForWhilePlansLeadOn) {
  Stuck room;
  FlightState& state = room.state();
  state.facts.time = 11 * kSecond;
  state.facts.plans.in_flight.trajectory.origin.x += 0.3;
  room.look().note_tick(state.facts, {3, 0});
  EXPECT_TRUE(room.is_called_for(kSecond, 3, 4));
  state.facts.time = 11 * kSecond;
  state.facts.plans.in_flight.trajectory.origin.x += 0.2;
  room.look().note_tick(state.facts, {3, 0});
  EXPECT_FALSE(room.is_called_for(kSecond + 499999999, 6, 8));
  EXPECT_FALSE(room.is_called_for(kSecond + 500000000, 5, 8));
  EXPECT_TRUE(room.is_called_for(kSecond + 500000000, 6, 8));
}

TEST(FlightLookout, IsNotCalledForWithoutNeed) {
  Stuck room;
  FlightState& state = room.state();
  room.look().left = 0;
  EXPECT_FALSE(room.is_called_for(kSecond, 9, 9));
  room.look().left = 1;
  EXPECT_TRUE(room.is_called_for(kSecond, 9, 9));
  state.facts.plans.in_flight.at_target = true;
  state.facts.plans.in_flight.mission = state.facts.itinerary.number;
  state.facts.plans.in_flight.branch = 1e9;
  EXPECT_FALSE(room.is_called_for(kSecond, 9, 9)) << "the plan ends at the goal";
  state.facts.plans.in_flight.at_target = false;
  ASSERT_EQ(room.map().follow({20.0, 0.0, 1.0}), Status::kRunning);
  EXPECT_FALSE(room.is_called_for(kSecond, 9, 9)) << "the map slides";
}

/// A vehicle that flies back and forth before a goal within its horizon is called to look after six plans, and then
/// after six more. If its goal is further away, the last three of them must have shown nothing new.
TEST(FlightLookout, IsCalledForIfTheVehicleWanders) {
  for (const bool is_far : {false, true}) {
    Stuck room;
    FlightState& state = room.state();
    const double away = distance(state.facts.position(), kGoal);
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
  room.follow(kSecond);
  room.follow(kSecond);
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
  room.follow(2 * kSecond);  // the gimbal points there
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
  room.follow(4 * kSecond);
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
  EXPECT_EQ(room.flight.set_goal(kGoal), Status::kOk);
  EXPECT_EQ(room.flight.looked_in_vain(nullptr, 0), 0);
  EXPECT_EQ(Flight().looked_in_vain(found, kTriedVoxels), 0);
}

/// Without frames, a look ends after four seconds.
TEST(FlightLookout, LooksForFourSecondsAtMost) {
  Stuck room;
  room.search();
  room.follow(0);
  room.follow(4 * kSecond);
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
  room.follow(100 * kSecond);
  EXPECT_EQ(room.look().phase, LookoutPhase::kIdle) << "too late";
  EXPECT_EQ(room.look().tried.failures, 2);
}

/// A search for an end that is no longer committed says nothing, nor does one for another goal.
TEST(FlightLookout, OutdatedAnswersAreDropped) {
  for (const bool moves : {true, false}) {
    Stuck room;
    FlightState& state = room.state();
    room.look().begin(state.facts, state.nose, kGoal);
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
  EXPECT_LT(distance(room.look().place(), kGoal), 0.5);
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
    EXPECT_FALSE(look.is_hopeless()) << k;
    search_in_vain();
  }
  EXPECT_TRUE(look.is_hopeless());
  look.search.answer = LookoutAnswer::kNoWay;
  EXPECT_FALSE(look.is_hopeless()) << "it may be cut off";
  look.learned -= kLearned;
  search_in_vain();
  EXPECT_FALSE(look.is_hopeless());
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
