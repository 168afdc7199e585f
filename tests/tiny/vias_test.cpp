// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ways through vias that exceed a capacity of the tiny profile.
#include <gtest/gtest.h>

#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Status;
using tern::Via;

class TinyVias : public testing::Test {
 protected:
  Status plan(int count) {
    world_.request.vias = vias_;
    world_.request.via_count = count;
    return world_.plan();
  }

  World world_ = open_world();
  Via vias_[tern::kMaxVias + 1] = {};
};

TEST_F(TinyVias, MoreThanFitAreRefused) {
  EXPECT_EQ(plan(tern::kMaxVias + 1), Status::kViasFull);
  EXPECT_EQ(world_.report.field, tern::Field::kVias);
  EXPECT_EQ(world_.report.via, tern::kNoVia);
  EXPECT_TRUE(world_.trajectory_untouched());
}

TEST_F(TinyVias, AsManyAsFitHaveAPlan) {
  vias_[0].position = {1.05, 2.05, 1.05};
  vias_[1].position = {2.45, 1.55, 1.05};
  ASSERT_EQ(plan(tern::kMaxVias), Status::kOk);
  EXPECT_GT(world_.report.vias[1].time, world_.report.vias[0].time);
}

TEST_F(TinyVias, AWayOfTooManyLegsIsFull) {
  // To and fro around the end of a wall: each of three legs turns there, and four segments do not suffice.
  World plane({20, 12, 1}, 0.25, 0.0);
  plane.block({2.5, 0.0, 0.0}, {2.6, 2.1, 0.25}).from({0.375, 0.375, 0.125}).to({4.375, 0.625, 0.125});
  vias_[0].position = {4.375, 0.375, 0.125};
  vias_[1].position = {0.625, 0.375, 0.125};
  plane.request.vias = vias_;
  plane.request.via_count = tern::kMaxVias;
  EXPECT_EQ(plane.plan(), Status::kSegmentsFull);
  EXPECT_EQ(plane.report.diagnostics.high_water.segments, tern::kMaxSegments);
  EXPECT_TRUE(plane.trajectory_untouched());
  plane.request.via_count = 1;
  EXPECT_EQ(plane.plan(), Status::kOk);
}

/// A dwell takes a segment of its own, and the optimised plan has none left for it. Nor has stop-and-go, and past a via
/// in motion there is no stop-and-go.
TEST_F(TinyVias, ADwellForWhichNoSegmentIsLeftIsFull) {
  World plane({20, 12, 1}, 0.25, 0.0);
  plane.block({0.0, 1.25, 0.0}, {2.5, 1.5, 0.25}).from({4.375, 0.375, 0.125}).to({0.375, 1.625, 0.125});
  vias_[0].position = {0.375, 0.375, 0.125};
  vias_[1].position = {3.375, 1.375, 0.125};  // from which the last leg bends around the wall's end
  vias_[0].stop = true;
  vias_[1].velocity = {-0.1, 0.2, 0.0};
  plane.request.vias = vias_;
  plane.request.via_count = tern::kMaxVias;
  for (const bool moves : {false, true}) {
    vias_[1].has_velocity = moves;
    vias_[0].dwell = 0.0;
    EXPECT_EQ(plane.plan(), Status::kOk);
    EXPECT_EQ(plane.trajectory.count, tern::kMaxSegments);
    vias_[0].dwell = 1.0;
    EXPECT_EQ(plane.plan(), Status::kSegmentsFull);
    EXPECT_EQ(plane.report.diagnostics.high_water.segments, tern::kMaxSegments);
    EXPECT_TRUE(plane.trajectory_untouched());
  }
}

}  // namespace
}  // namespace tern_test
