// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From where the search says that the vehicle should look.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "base/math.hpp"
#include "grid/distance.hpp"
#include "lookout/lookout_search.hpp"
#include "support/lookout_map.hpp"
#include "support/random.hpp"
#include "support/same.hpp"

namespace {

using namespace tern;
using tern_test::expect_same;
using tern_test::LookoutMap;
using tern_test::Random;
using tern_test::scaled;

/// A vehicle that looks along x.
struct Searching : LookoutMap {
  LookoutAnswer ask(const Vec3& from, const Vec3& goal, std::uint32_t units = 1000000) {
    memory.assign(LookoutSearch::words(map().safe().spec().dims), 0xA5A5A5A5A5A5A5A5u);
    search.optics = Optics(sensor, LookoutMap::spec_of_map());
    search.begin(map(), {from, goal, {1.0, 0.0}, {3.0, 6.0, 2.5, 8.0}, false}, memory.data());
    Work work;
    slices = 0;
    for (Progress progress = Progress::kMore; progress == Progress::kMore && slices < 100000; ++slices) {
      work.add(units);
      progress = search.advance(map(), tried, work);
    }
    spent = static_cast<std::int64_t>(units) * slices - work.operations() / kUnit;
    return search.answer;
  }
  const Viewpoint& found() const { return search.lookout; }

  FlightSensor sensor = kLevelCamera;
  Tried tried{};
  LookoutSearch search{};
  std::vector<std::uint64_t> memory;
  int slices = 0;
  std::int64_t spent = 0;
};

/// A goal right above, of which a level camera sees nothing: the vehicle flies aside and looks at the goal's
/// surroundings from there, all of them.
TEST(LookoutSearch, AGoalAboveIsSeenFromTheSide) {
  Searching room;
  room.see_free({2.0, 2.0, 1.0}, {14.0, 14.0, 4.0});
  const Vec3 from{8.125, 8.125, 2.125};
  const Vec3 goal{8.125, 8.125, 5.125};
  ASSERT_EQ(room.ask(from, goal), LookoutAnswer::kFound);
  const Viewpoint& lookout = room.found();
  EXPECT_GT(lookout.hidden_count, 20);
  EXPECT_GT(distance(lookout.place, from), 1.0);
  EXPECT_TRUE(point_clear(room.map().safe(), room.map().safe().to_local(lookout.place), 0.5));
  EXPECT_NEAR(lookout.heading.cosine * lookout.heading.cosine + lookout.heading.sine * lookout.heading.sine, 1.0, 1e-9);
  const SensorPose pose = room.search.optics.pose(lookout.place, lookout.heading, lookout.look);
  for (std::int32_t k = 0; k < lookout.hidden_count; ++k) {
    EXPECT_TRUE(room.search.optics.in_view(pose, lookout.hidden[k]));
    EXPECT_TRUE(is_unseen_at(room.map(), lookout.hidden[k]));
  }
  EXPECT_LT(room.spent, 30000);
}

/// A gimbal that turns up sees it from nearer, or sooner.
TEST(LookoutSearch, AGimbalSeesItSooner) {
  Searching room;
  room.see_free({2.0, 2.0, 1.0}, {14.0, 14.0, 4.0});
  ASSERT_EQ(room.ask({8.125, 8.125, 2.125}, {8.125, 8.125, 5.125}), LookoutAnswer::kFound);
  const double level = room.found().seconds;
  room.sensor.pitch_max = 1.2;
  ASSERT_EQ(room.ask({8.125, 8.125, 2.125}, {8.125, 8.125, 5.125}), LookoutAnswer::kFound);
  EXPECT_LT(room.found().seconds, level);
}

/// Straight ahead, and in view: the vehicle stays where it is.
TEST(LookoutSearch, WhatIsInViewNeedsNoFlight) {
  Searching room;
  room.see_free({2.0, 2.0, 1.0}, {10.0, 14.0, 7.0});
  const Vec3 from{5.125, 8.125, 4.125};
  ASSERT_EQ(room.ask(from, {12.125, 8.125, 4.125}), LookoutAnswer::kFound);
  expect_same(room.found().place, from);
  EXPECT_GT(room.found().heading.cosine, 0.99);
}

/// From a pocket of known space, nothing of the way up is in view. It would be from outside: the lookout lies in the
/// pocket, and shows the way out.
TEST(LookoutSearch, LooksForAWayOutOfAPocket) {
  for (const Vec3& low : {Vec3{7.5, 7.25, 2.25}, Vec3{6.75, 7.0, 2.25}}) {
    Searching room;
    room.see_free(low, {9.25, 9.0, 4.0});
    const Vec3 from{8.375, 8.125, 3.125};
    ASSERT_EQ(room.ask(from, {8.375, 8.125, 6.125}), LookoutAnswer::kFound);
    const Viewpoint& lookout = room.found();
    EXPECT_TRUE(point_clear(room.map().safe(), room.map().safe().to_local(lookout.place), 0.5));
    EXPECT_GT(lookout.hidden_count, 0);
    EXPECT_GT(horizontal_length(lookout.look - from), 0.5);
    EXPECT_LT(lookout.look.z, 4.5);
  }
}

/// A wall hides what is behind it: the lookout has a free line of sight past its edge.
TEST(LookoutSearch, LooksPastAWall) {
  Searching room;
  room.see_free({2.0, 2.0, 1.0}, {10.0, 14.0, 7.0});
  room.mark({{9.0, 0.0, 0.0}, {9.25, 12.0, 8.0}});
  ASSERT_EQ(room.ask({5.125, 8.125, 4.125}, {12.125, 8.125, 4.125}), LookoutAnswer::kFound);
  Work work;
  for (std::int32_t k = 0; k < room.found().hidden_count; ++k) {
    EXPECT_TRUE(room.search.optics.in_sight(room.map(), room.found().place, room.found().hidden[k], work));
  }
}

/// A wall without a gap: no way.
TEST(LookoutSearch, SaysThatThereIsNoWay) {
  Searching room;
  room.see_free({2.0, 2.0, 1.0}, {10.0, 14.0, 7.0});
  room.mark({{9.0, 0.0, 0.0}, {9.25, 16.0, 8.0}});
  EXPECT_EQ(room.ask({5.125, 8.125, 4.125}, {12.125, 8.125, 4.125}), LookoutAnswer::kNoWay);
}

/// All of the way is known: the answer is the last place of it.
TEST(LookoutSearch, LeadsAlongAKnownWay) {
  Searching room;
  room.see_free({2.0, 2.0, 1.0}, {20.0, 14.0, 7.0});
  ASSERT_EQ(room.ask({5.125, 8.125, 4.125}, {17.125, 8.125, 4.125}), LookoutAnswer::kNothingUnseen);
  EXPECT_EQ(room.found().hidden_count, 0);
  EXPECT_LT(distance(room.found().place, {17.125, 8.125, 4.125}), 0.5);
}

/// What was tried from all around is given up: nothing is in sight any more. A lookout that failed is not chosen again.
TEST(LookoutSearch, RemembersWhatWasTried) {
  Searching room;
  room.see_free({2.0, 2.0, 1.0}, {14.0, 14.0, 4.0});
  const Vec3 from{8.125, 8.125, 2.125};
  const Vec3 goal{8.125, 8.125, 5.125};
  ASSERT_EQ(room.ask(from, goal), LookoutAnswer::kFound);
  const Viewpoint first = room.found();
  room.tried.note_failure(first.place, first.look);
  ASSERT_EQ(room.ask(from, goal), LookoutAnswer::kFound);
  EXPECT_FALSE(same(room.found().place, first.place) && same(room.found().look, first.look));
}

/// From a goal beyond the octets, the way leads to the rim; nothing is wanted past it.
TEST(LookoutSearch, AGoalFarAwayLeadsToTheRim) {
  Searching room;
  room.see_free({2.0, 2.0, 1.0}, {10.0, 14.0, 7.0});
  ASSERT_EQ(room.ask({5.125, 8.125, 4.125}, {200.0, 8.125, 4.125}), LookoutAnswer::kFound);
  for (std::int32_t k = 0; k < room.found().hidden_count; ++k) EXPECT_GT(room.found().hidden[k].x, 9.0);
}

/// A search does not depend on its slices, and keeps its bound of work.
TEST(LookoutSearch, IsTheSameInSlices) {
  Random random(3);
  int found = 0;
  for (int n = 0; n < scaled(20); ++n) {
    Searching room;
    room.see_free({2.0, 2.0, 1.0}, {14.0, 14.0, 5.0});
    for (int k = 0; k < 4; ++k) {
      const Vec3 low{random.real(10.0, 16.0), random.real(1.0, 13.0), 0.0};
      room.mark({low, {low.x + 0.4, low.y + 1.5, 8.0}});
    }
    const Vec3 from{random.real(4.0, 8.0), random.real(5.0, 10.0), random.real(2.0, 4.0)};
    const Vec3 goal{random.real(4.0, 30.0), random.real(2.0, 14.0), random.real(1.0, 7.0)};
    const LookoutAnswer answer = room.ask(from, goal);
    const Viewpoint whole = room.found();
    EXPECT_LT(room.spent, 30000) << n;
    EXPECT_EQ(room.ask(from, goal, 1), answer);
    if (answer != LookoutAnswer::kFound) continue;
    ++found;
    expect_same(room.found().place, whole.place);
    expect_same(room.found().look, whole.look);
    EXPECT_EQ(room.found().hidden_count, whole.hidden_count);
    EXPECT_GT(room.slices, 100);
  }
  EXPECT_GT(found, 0);
}

}  // namespace
