// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/nearest_thing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host/track_sample.hpp"

namespace {

using tern_host::nearest_thing;
using tern_host::NearestThing;
using tern_host::Scenario;

Scenario world(const std::string& tracks) {
  return tern_host::parse_scenario(
      "boundary 0 0 0 20 10 4\nstart 2 5 2\ngoal 12 5 2\nstart_time 3\nrest_clear 2\n" + tracks, "things.txt");
}

/// 1 m/s along x, from (2, 5, 2) to (12, 5, 2); the clock shows 3 s at its beginning.
tern::Trajectory straight() {
  tern::Trajectory plan{};
  plan.begin = 3000000000;
  plan.origin = {2.0, 5.0, 2.0};
  plan.count = 1;
  plan.segments[0].duration = 10.0;
  for (int i = 0; i < tern::kControlPoints; ++i) plan.segments[0].points[i] = {10.0 * i / 7.0, 0.0, 0.0};
  return plan;
}

/// A ball of 0.5 m, 2 m beside x = 7; one that stands beyond the goal until 4 s; one that comes once the plan rests.
TEST(NearestThing, IsFoundWhereTheGapIsLeast) {
  const NearestThing man = nearest_thing(straight(), world("track man ball 0.5 at 7 7 2\n"
                                                           "track bird ball 0.5 at 12 5.2 2 until 4 gone\n"));
  EXPECT_EQ(man.index, 0);
  EXPECT_NEAR(man.gap, 1.5, 1e-9);
  EXPECT_NEAR(man.when, 5.0, 1e-3);
  const Scenario late = world("track man ball 0.5 at 7 7 2\ntrack bird ball 0.5 at 12 6 2 from 14\n");
  const NearestThing bird = nearest_thing(straight(), late);
  EXPECT_EQ(bird.index, 1);
  EXPECT_NEAR(bird.gap, 0.5, 1e-9);
  EXPECT_EQ(tern_host::nearest_thing_text(bird, late), "nearest bird at 0.500 m");
  EXPECT_EQ(nearest_thing(straight(), world("track bird ball 0.5 at 12 6 2 from 15.5\n")).index, -1);
  EXPECT_EQ(nearest_thing(straight(), world("")).index, -1);
}

/// The error grows by 0.3 m/s and the reach by 0.1 m/s, about where it was at first: 2 s later, both tubes hold a point
/// if they are 0.6 m and 0.2 m wider, and what is outside of one is clear.
TEST(TubeGap, IsThatOfTheTubeThatIsFartherAway) {
  const tern::Track curve =
      tern_host::tracks_of(world("track man ball 0.5 at 7 5 2 velocity 1 0 0 error 0 0.3 0\n").tracks)[0];
  EXPECT_NEAR(tern_host::tube_gap(curve, 5.0, {9.0, 7.0, 2.0}), 2.0 - 0.5 - 0.6, 1e-12);
  tern::Track reached = curve;
  reached.reach = 0.1;
  EXPECT_NEAR(tern_host::tube_gap(reached, 5.0, {9.0, 7.0, 2.0}), std::sqrt(8.0) - 0.5 - 0.2, 1e-12);
  EXPECT_NEAR(tern_host::tube_gap(reached, 5.0, {7.0, 5.0, 2.0}), 2.0 - 0.5 - 0.6, 1e-12);
  EXPECT_TRUE(std::isinf(tern_host::tube_gap(curve, 2.0, {9.0, 7.0, 2.0})));
}

}  // namespace
