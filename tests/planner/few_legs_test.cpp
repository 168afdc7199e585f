// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A way that needs more segments than fit is made anew, by the optimal search and then with fewer legs.
#include <gtest/gtest.h>

#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::SearchMode;
using tern::Stage;
using tern::Status;

/// Walls across the way, with a gap at one end, then at the other. A taut path bends at both corners of each gap.
World slalom(int walls) {
  World world({12 * (walls + 1), 30, 1}, 1.0, 0.0);
  for (int w = 0; w < walls; ++w) {
    const double x = 12.0 * (w + 1);
    world.block({x, w % 2 == 0 ? 0.0 : 8.0, 0.0}, {x + 3.0, w % 2 == 0 ? 22.0 : 30.0, 1.0});
  }
  world.from({2.5, 2.5, 0.5}).to({12.0 * walls + 10.5, 2.5, 0.5});
  world.request.budget.trajectory = 0;  // stop-and-go takes less time
  return world;
}

TEST(FewLegs, APlanOfMoreCornersThanSegments) {
  World world = slalom(tern::kMaxSegments - 8);
  for (const SearchMode search : {SearchMode::kFast, SearchMode::kOptimal}) {
    world.request.search = search;
    ASSERT_EQ(world.plan(), Status::kOk);
    EXPECT_LE(world.planner.path()->count, tern::kMaxWaypoints);
    for (const tern::StageReport& stage : world.report.diagnostics.stages) EXPECT_LE(stage.work, stage.bound);
  }
}

TEST(FewLegs, MoreGapsThanSegmentsAreFull) {
  World world = slalom(tern::kMaxSegments + 8);
  EXPECT_EQ(world.plan(), Status::kSegmentsFull);
  EXPECT_EQ(world.report.stage, Stage::kShortcut);
  EXPECT_EQ(world.report.diagnostics.high_water.segments, tern::kMaxSegments);
  EXPECT_TRUE(world.trajectory_untouched());
}

}  // namespace
}  // namespace tern_test
