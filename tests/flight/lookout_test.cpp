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
    state().time = 2000000000;
    state().start.d[0] = start;
    state().takeover = state().time;
    state().block = {BlockedBy::kUnseen, kHidden, kNoFence};
    state().turned = true;
  }
  /// The place that is chosen, with the copy of the route still empty.
  Vec3 choose() {
    EXPECT_TRUE(state().seek_lookout());
    state().begin_lookout();
    Work work{100000};
    while (state().job == Job::kLookout) EXPECT_EQ(state().run_lookout(work), Progress::kDone);
    EXPECT_EQ(state().job, Job::kCopy);
    state().aim_at_lookout();
    return state().aim;
  }
};

/// All is free: at the height of the hidden voxel, as near to the vehicle as a radius. The next one is in another
/// direction.
TEST(FlightLookout, IsLevelAndNear) {
  Stuck room;
  expect_same(room.choose(), {room.start.x - 0.5, kHidden.y, kHidden.z});
  EXPECT_FALSE(room.state().aims_at_goal);
  EXPECT_EQ(room.state().sought, 1u << 4);
  const Vec3 second = room.choose();
  EXPECT_EQ(second.z, kHidden.z);
  EXPECT_NE(room.state().sought, 1u << 4);
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
  EXPECT_EQ(room.state().lookout.direction, 2);  // between the walls, a radius from each
  EXPECT_FALSE(room.state().lookout.is_straight);
}

/// The vehicle rests below a slab and the hidden voxel is above it. A place to which a straight way is free comes
/// before level ones above the slab.
TEST(FlightLookout, IsAtTheEndOfAStraightFreeWay) {
  Stuck room(std::vector<Box>{{{-15.0, -15.0, 2.25}, {3.0, 15.0, 2.5}}});
  room.state().block.at.z = 3.125;
  const Vec3 place = room.choose();
  EXPECT_TRUE(room.state().lookout.is_straight);
  EXPECT_GT(room.state().lookout.drop, 0.0);
  EXPECT_GT(place.x, 3.0);
  EXPECT_LT(place.z, 3.125);
}

/// None: the next step is another one.
TEST(FlightLookout, WhereThereIsNoneAllDirectionsWereTried) {
  Stuck room(std::vector<Box>{{{1.75, -15.0, -2.0}, {2.0, 15.0, 4.0}}, {{2.25, -15.0, -2.0}, {2.5, 15.0, 4.0}}});
  EXPECT_TRUE(room.state().seek_lookout());
  room.state().begin_lookout();
  Work work{100000};
  EXPECT_EQ(room.state().run_lookout(work), Progress::kDone);
  EXPECT_EQ(room.state().sought, kAround);
  EXPECT_FALSE(room.state().seeks);
  EXPECT_EQ(room.state().job, Job::kCopy);
}

/// A search goes on in the next tick where it does not fit into one.
TEST(FlightLookout, IsSoughtInSlices) {
  Stuck whole;
  const Vec3 place = whole.choose();
  Stuck sliced;
  EXPECT_TRUE(sliced.state().seek_lookout());
  sliced.state().begin_lookout();
  int slices = 0;
  for (; sliced.state().job == Job::kLookout; ++slices) {
    Work work{1};
    sliced.state().run_lookout(work);
  }
  EXPECT_GT(slices, 2);
  sliced.state().aim_at_lookout();
  expect_same(sliced.state().aim, place);
}

/// While the map slides, nothing is known of it: the search waits, and nothing new is said to be in the way.
TEST(FlightLookout, IsSoughtOnceTheMapIsThere) {
  Stuck room;
  FlightState& state = room.state();
  room.mark({{0.5, -0.5, 0.5}, {0.75, 0.5, 1.5}});
  EXPECT_TRUE(state.seek_lookout());
  state.begin_lookout();
  ASSERT_EQ(room.map().follow({20.0, 0.0, 1.0}), Status::kRunning);
  Work work{100000};
  EXPECT_EQ(state.run_lookout(work), Progress::kMore);
  EXPECT_EQ(work.left, 100000u);
  EXPECT_EQ(state.job, Job::kLookout);
  EXPECT_EQ(state.searched, 0);
  EXPECT_EQ(state.note_block_near(room.start, state.map.safe()), kAnywhere);
  expect_same(state.block.at, kHidden);
}

/// Plans that go on along what is flown, or to the same place, lead to no other lookout.
TEST(FlightLookout, CountsOnceOnTheWayThere) {
  Stuck room;
  FlightState& state = room.state();
  state.seeks = true;
  state.draft.aim = {5.0, 0.0, 1.0};
  const auto counts_after = [&](bool extends, const Vec3& aim_before) {
    state.extends = extends;
    state.now.aim = aim_before;
    state.note_lookout();
    return state.lookouts;
  };
  EXPECT_EQ(counts_after(true, room.start), 0);
  EXPECT_EQ(counts_after(false, state.draft.aim), 0);
  EXPECT_TRUE(state.seeks);
  EXPECT_EQ(counts_after(false, room.start), 1);
  EXPECT_FALSE(state.seeks);
}

/// Straight away from the voxel, ten radii or up to what is in the way.
TEST(FlightLookout, TheWayAwayIsStraight) {
  Stuck room;
  room.state().sought = kAround;
  const auto away = [&] {
    EXPECT_TRUE(room.state().goes_away() || room.state().seek_lookout());
    room.state().aim_at_lookout();
    return room.state().aim;
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
    state.turned = turned;
    state.lookouts = lookouts;
    return state.seek_lookout();
  };
  EXPECT_FALSE(seeks(BlockedBy::kUnseen, false, 0));
  EXPECT_TRUE(seeks(BlockedBy::kUnseen, true, 7));
  EXPECT_FALSE(seeks(BlockedBy::kUnseen, true, 8));
  EXPECT_TRUE(seeks(BlockedBy::kObstacle, true, 0));
  EXPECT_FALSE(seeks(BlockedBy::kFence, true, 0));
  EXPECT_FALSE(seeks(BlockedBy::kWindow, true, 0));
  state.leaves = true;
  EXPECT_FALSE(seeks(BlockedBy::kUnseen, true, 0));
}

/// What was tried counts within four radii.
TEST(FlightLookout, WhatWasTriedElsewhereDoesNotCount) {
  Stuck room;
  FlightState& state = room.state();
  state.turned = true;
  state.sought = kAround;
  state.stuck_at = {room.start.x + 1.9, room.start.y, room.start.z};
  state.note_place();
  EXPECT_TRUE(state.turned);
  EXPECT_EQ(state.sought, kAround);
  state.stuck_at = {room.start.x + 2.1, room.start.y, room.start.z};
  state.note_place();
  EXPECT_FALSE(state.turned);
  EXPECT_EQ(state.sought, 0u);
  expect_same(state.stuck_at, room.start);
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
  state.nearest = 1.0;
  state.sought = kAround & ~1u;  // the far side
  state.seeks = true;
  ASSERT_TRUE(room.tick_until([&] { return room.report.committed == 1; }));
  const Vec3 place{kHidden.x + 1.5, kHidden.y, kHidden.z};
  expect_same(room.flight.rest_position(), place);
  EXPECT_FALSE(state.seeks);
  EXPECT_EQ(state.lookouts, 1);
  while (distance(room.position(), place) > 0.02 && room.time < 5000000000) {
    expect_same(room.flight.command(room.time).look_at, kHidden);
    expect_same(room.flight.rest_position(), place);
    room.tick();
  }
  EXPECT_EQ(state.lookouts, 1);
  EXPECT_EQ(room.fly(), FlightReason::kArrived);
  EXPECT_EQ(state.lookouts, 0);
}

}  // namespace
