// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From where a vehicle looks at what blocks its way: which places it chooses, and how it flies there.
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

/// A voxel two metres ahead, at the vehicle's height, that was not seen.
constexpr Vec3 kHidden{2.125, 0.125, 1.125};

/// At rest, about to seek a lookout.
struct Stuck : FlightRoom {
  explicit Stuck(const std::vector<Box>& solid = {}) : FlightRoom(flight_spec(), solid) {
    flight.set_goal({8.125, 0.125, 1.125});
    state().facts.time = 2000000000;
    state().cycle.aim.start.d[0] = start;
    state().draft.takeover = state().facts.time;
    state().block = {BlockedBy::kUnseen, kHidden, kNoFence};
    state().search.turned = true;
  }
  bool seeks() { return state().search.seek_lookout(state().facts, state().block, state().cycle.hemmed_in); }
  void begin() {
    EXPECT_TRUE(seeks());
    state().search.begin_lookout();
    state().cycle.job = Job::kLookout;
  }
  Vec3 place() { return state().search.lookout_place(map(), state().block, start, state().tick_work); }
  /// The place that is chosen, with the copy of the route still empty.
  Vec3 choose() {
    begin();
    state().tick_work = Work{100000};
    while (state().cycle.job == Job::kLookout) EXPECT_EQ(state().run_lookout(), Progress::kDone);
    EXPECT_EQ(state().cycle.job, Job::kCopy);
    return place();
  }
};

/// All is free: at the height of the hidden voxel, as near to the vehicle as a radius. The next one is in another
/// direction.
TEST(FlightLookout, IsLevelAndNear) {
  Stuck room;
  expect_same(room.choose(), {room.start.x - 0.5, kHidden.y, kHidden.z});
  EXPECT_EQ(room.state().search.sought, 1u << 4);
  const Vec3 second = room.choose();
  EXPECT_EQ(second.z, kHidden.z);
  EXPECT_NE(room.state().search.sought, 1u << 4);
}

/// A ceiling right above the hidden voxel leaves no level place: half a radius lower, as far away as may be, and along
/// the grid's axes, where the line of sight drops least across the voxel.
TEST(FlightLookout, IsAsFlatAsThereIsRoom) {
  Stuck room(std::vector<Box>{{{-15.0, -15.0, 1.75}, {15.0, 15.0, 2.0}}});
  room.state().block.at.z += 0.25;
  expect_same(room.choose(), {kHidden.x - 5.0, kHidden.y, kHidden.z});
}

/// Behind a wall nothing is seen of the voxel, and in a wall there is no place.
TEST(FlightLookout, SeesTheVoxelPastWhatIsKnown) {
  Stuck room(std::vector<Box>{{{1.25, -15.0, -2.0}, {1.5, 15.0, 4.0}}, {{2.75, -15.0, -2.0}, {3.0, 15.0, 4.0}}});
  EXPECT_DOUBLE_EQ(room.choose().x, kHidden.x);
  EXPECT_EQ(room.state().search.lookout.direction, 2);  // between the walls, a radius from each
  EXPECT_FALSE(room.state().search.lookout.is_straight);
}

/// The vehicle rests below a slab and the hidden voxel is above it. A place to which a straight way is free comes
/// before level ones above the slab.
TEST(FlightLookout, IsAtTheEndOfAStraightFreeWay) {
  Stuck room(std::vector<Box>{{{-15.0, -15.0, 2.25}, {3.0, 15.0, 2.5}}});
  room.state().block.at.z = 3.125;
  const Vec3 place = room.choose();
  EXPECT_TRUE(room.state().search.lookout.is_straight);
  EXPECT_GT(room.state().search.lookout.drop, 0.0);
  EXPECT_GT(place.x, 3.0);
  EXPECT_LT(place.z, 3.125);
}

/// None: the next step is another one.
TEST(FlightLookout, WhereThereIsNoneAllDirectionsWereTried) {
  Stuck room(std::vector<Box>{{{1.75, -15.0, -2.0}, {2.0, 15.0, 4.0}}, {{2.25, -15.0, -2.0}, {2.5, 15.0, 4.0}}});
  room.begin();
  room.state().tick_work = Work{100000};
  EXPECT_EQ(room.state().run_lookout(), Progress::kDone);
  EXPECT_EQ(room.state().search.sought, kAround);
  EXPECT_FALSE(room.state().search.seeks);
  EXPECT_EQ(room.state().cycle.job, Job::kCopy);
}

/// A search goes on in the next tick where it does not fit into one.
TEST(FlightLookout, IsSoughtInSlices) {
  Stuck whole;
  const Vec3 place = whole.choose();
  Stuck sliced;
  sliced.begin();
  int slices = 0;
  for (; sliced.state().cycle.job == Job::kLookout; ++slices) {
    sliced.state().tick_work = Work{1};
    sliced.state().run_lookout();
  }
  EXPECT_GT(slices, 2);
  expect_same(sliced.place(), place);
}

/// While the map slides, nothing is known of it: the search waits, and nothing new is said to be in the way.
TEST(FlightLookout, IsSoughtOnceTheMapIsThere) {
  Stuck room;
  FlightState& state = room.state();
  room.mark({{0.5, -0.5, 0.5}, {0.75, 0.5, 1.5}});
  room.begin();
  ASSERT_EQ(room.map().follow({20.0, 0.0, 1.0}), Status::kRunning);
  state.tick_work = Work{100000};
  EXPECT_EQ(state.run_lookout(), Progress::kMore);
  EXPECT_EQ(state.tick_work.units(), 100000u);
  EXPECT_EQ(state.cycle.job, Job::kLookout);
  EXPECT_EQ(state.search.searched, 0);
  EXPECT_EQ(state.block.note_near(state.facts.map, room.start, state.facts.map.safe(), state.tick_work), kAnywhere);
  expect_same(state.block.at, kHidden);
}

/// Plans that go on along the committed plan, or to the same place, lead to no other lookout.
TEST(FlightLookout, CountsOnceOnTheWayThere) {
  Stuck room;
  FlightState& state = room.state();
  state.search.seeks = true;
  state.draft.plan.place = {5.0, 0.0, 1.0};
  const auto counts_after = [&](bool extends, const Vec3& aim_before) {
    state.draft.extends = extends;
    state.facts.plans.in_flight.place = aim_before;
    state.search.note_commit(state.draft, state.facts.plans.in_flight);
    return state.search.lookouts;
  };
  EXPECT_EQ(counts_after(true, room.start), 0);
  EXPECT_EQ(counts_after(false, state.draft.plan.place), 0);
  EXPECT_TRUE(state.search.seeks);
  EXPECT_EQ(counts_after(false, room.start), 1);
  EXPECT_FALSE(state.search.seeks);
}

/// Straight away from the voxel, ten radii or up to what is in the way.
TEST(FlightLookout, TheWayAwayIsStraight) {
  Stuck room;
  room.state().search.sought = kAround;
  const auto away = [&] {
    EXPECT_TRUE(room.state().search.goes_away() || room.seeks());
    return room.place();
  };
  EXPECT_NEAR(away().x, room.start.x - 5.0, 1e-9);
  room.mark({{-2.25, -1.0, 0.0}, {-2.0, 1.0, 2.0}});
  EXPECT_NEAR(away().x, room.start.x - 1.5, 1e-9);
}

/// None before the look around, eight after it; none for a fence or the window's face, or if something is too near.
TEST(FlightLookout, AreFew) {
  Stuck room;
  FlightState& state = room.state();
  const auto seeks = [&](BlockedBy by, bool turned, int lookouts) {
    state.block.by = by;
    state.search.turned = turned;
    state.search.lookouts = lookouts;
    return room.seeks();
  };
  EXPECT_FALSE(seeks(BlockedBy::kUnseen, false, 0));
  EXPECT_TRUE(seeks(BlockedBy::kUnseen, true, 7));
  EXPECT_FALSE(seeks(BlockedBy::kUnseen, true, 8));
  EXPECT_TRUE(seeks(BlockedBy::kObstacle, true, 0));
  EXPECT_FALSE(seeks(BlockedBy::kFence, true, 0));
  EXPECT_FALSE(seeks(BlockedBy::kWindow, true, 0));
  state.cycle.hemmed_in = true;
  EXPECT_FALSE(seeks(BlockedBy::kUnseen, true, 0));
}

/// What was tried counts within four radii.
TEST(FlightLookout, WhatWasTriedElsewhereDoesNotCount) {
  Stuck room;
  FlightState& state = room.state();
  state.search.turned = true;
  state.search.sought = kAround;
  state.search.stuck_at = {room.start.x + 1.9, room.start.y, room.start.z};
  state.search.note_place(state.facts);
  EXPECT_TRUE(state.search.turned);
  EXPECT_EQ(state.search.sought, kAround);
  state.search.stuck_at = {room.start.x + 2.1, room.start.y, room.start.z};
  state.search.note_place(state.facts);
  EXPECT_FALSE(state.search.turned);
  EXPECT_EQ(state.search.sought, 0u);
  expect_same(state.search.stuck_at, room.start);
}

/// The vehicle flies to a lookout past no point of the mission, looks at the voxel all the way, and only then flies on.
/// It counts until the vehicle comes nearer.
TEST(FlightLookout, IsFlownToToItsEnd) {
  FlightRoom room;
  Via points[2];
  points[0].position = {5.0, 0.0, 1.125};
  points[1].position = {8.0, 0.0, 1.125};
  ASSERT_EQ(room.flight.set_mission(points, 2, ViaPolicy::kEnd), Status::kOk);
  FlightState& state = room.state();
  state.block = {BlockedBy::kUnseen, kHidden, kNoFence};
  state.facts.itinerary.nearest = 1.0;
  state.search.sought = kAround & ~1u;  // the far side
  state.search.seeks = true;
  ASSERT_TRUE(room.tick_until([&] { return room.report.committed == 1; }));
  const Vec3 place{kHidden.x + 1.5, kHidden.y, kHidden.z};
  expect_same(room.flight.rest_position(), place);
  EXPECT_FALSE(state.search.seeks);
  EXPECT_EQ(state.search.lookouts, 1);
  while (distance(room.position(), place) > 0.02 && room.time < 5000000000) {
    expect_same(room.flight.command(room.time).look_at, kHidden);
    expect_same(room.flight.rest_position(), place);
    room.tick();
  }
  EXPECT_EQ(state.search.lookouts, 1);
  EXPECT_EQ(room.fly(), FlightReason::kArrived);
  EXPECT_EQ(state.search.lookouts, 0);
}

}  // namespace
