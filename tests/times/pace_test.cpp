// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "times/pace.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tern/trajectory.hpp"

namespace tern_test {
namespace {

using tern::Pace;
using tern::PaceWalk;
using tern::Trajectory;
using tern::Vec3;

/// Appends a segment that is flown at constant velocity.
void fly_straight(const Vec3& from, const Vec3& to, double duration, Trajectory& plan) {
  tern::Segment& segment = plan.segments[plan.count++];
  segment.duration = duration;
  for (int k = 0; k < tern::kControlPoints; ++k) {
    const double u = static_cast<double>(k) / tern::kDegree;
    segment.points[k] = {from.x + u * (to.x - from.x), from.y + u * (to.y - from.y), from.z + u * (to.z - from.z)};
  }
}

class PaceOfAPlan : public testing::Test {
 protected:
  /// 8 m along x in 4 s, then 8 m along y in 2 s.
  PaceOfAPlan() {
    fly_straight({0.0, 0.0, 0.0}, {8.0, 0.0, 0.0}, 4.0, plan_);
    fly_straight({8.0, 0.0, 0.0}, {8.0, 8.0, 0.0}, 2.0, plan_);
  }
  PaceWalk begin(double from, const Vec3& offset = {0.0, 0.0, 0.0}) {
    pace_ = Pace{&plan_, from, offset};
    PaceWalk walk;
    tern::pace_begin(pace_, walk);
    return walk;
  }

  Trajectory plan_{};
  Pace pace_;
  int pieces_ = 0;
};

TEST_F(PaceOfAPlan, BeginsInThePieceThatIsFlown) {
  // Pieces of the first segment take 0.5 s and are 1 m long, those of the second take 0.25 s.
  PaceWalk walk = begin(1.7);
  EXPECT_EQ(walk.piece, 3);
  EXPECT_NEAR(walk.begin.x, 3.0, 1e-12);
  EXPECT_NEAR(walk.begin_time, 1.5, 1e-12);
  EXPECT_EQ(walk.time, 1.7);
  walk = begin(4.0, {10.0, 20.0, 30.0});
  EXPECT_EQ(walk.piece, 8);
  EXPECT_NEAR(walk.begin.x, 18.0, 1e-12);
  EXPECT_NEAR(walk.begin.y, 20.0, 1e-12);
  EXPECT_NEAR(walk.begin.z, 30.0, 1e-12);
}

TEST_F(PaceOfAPlan, TellsWhenItPassesAPlaceAndHowNear) {
  PaceWalk walk = begin(0.0);
  EXPECT_NEAR(tern::pace_to(pace_, {2.25, 0.5, 0.0}, walk, pieces_), 0.5, 1e-12);
  EXPECT_NEAR(walk.time, 1.125, 1e-12);
  EXPECT_EQ(walk.piece, 2);
  // Round the corner: 5 m along y take 1.25 s.
  EXPECT_NEAR(tern::pace_to(pace_, {7.0, 5.0, 0.0}, walk, pieces_), 1.0, 1e-12);
  EXPECT_NEAR(walk.time, 5.25, 1e-12);
}

TEST_F(PaceOfAPlan, NeverGoesBack) {
  PaceWalk walk = begin(0.0);
  tern::pace_to(pace_, {6.5, 0.0, 0.0}, walk, pieces_);
  EXPECT_NEAR(walk.time, 3.25, 1e-12);
  // Behind it: what is nearest of the piece at hand is its beginning, at 3 s, but the instant stays.
  EXPECT_NEAR(tern::pace_to(pace_, {5.0, 0.0, 0.0}, walk, pieces_), 1.0, 1e-12);
  EXPECT_NEAR(walk.time, 3.25, 1e-12);
}

TEST_F(PaceOfAPlan, LooksOnlySoFarAhead) {
  // Away for 32 pieces, then back to where it began.
  Trajectory& plan = plan_;
  plan.count = 0;
  for (int i = 0; i < 4; ++i) fly_straight({8.0 * i, 0.0, 0.0}, {8.0 * (i + 1), 0.0, 0.0}, 1.0, plan);
  fly_straight({32.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 1.0, plan);
  PaceWalk walk = begin(0.0);
  pieces_ = 0;
  EXPECT_NEAR(tern::pace_to(pace_, {-1.0, 1.0, 0.0}, walk, pieces_), std::sqrt(2.0), 1e-12);
  EXPECT_EQ(walk.piece, 0);
  EXPECT_EQ(pieces_, 1 + tern::kPaceLookahead);
}

TEST_F(PaceOfAPlan, IsFarFromEverythingOnceItIsOver) {
  PaceWalk walk = begin(6.0);
  EXPECT_EQ(walk.piece, 16);
  EXPECT_EQ(tern::pace_to(pace_, {8.0, 8.0, 0.0}, walk, pieces_), 1e300);
  EXPECT_EQ(walk.time, 6.0);
  EXPECT_EQ(pieces_, 0);
}

/// x = t^4 has a snap of 24 m/s^4: an integral of 576 m^2/s^8 for each second.
TEST_F(PaceOfAPlan, TellsWhatIsLeftOfIt) {
  tern::Segment& curved = plan_.segments[plan_.count++];
  curved.duration = 0.5;
  for (int k = 0; k < tern::kControlPoints; ++k) {
    const double choices = k < 4 ? 0.0 : (k == 4 ? 1.0 : (k == 5 ? 5.0 : (k == 6 ? 15.0 : 35.0)));
    curved.points[k] = {0.0625 * choices / 35.0, 0.0, 0.0};
  }
  for (const double from : {0.0, 5.0, 6.0, 6.125, 6.4375}) {
    pace_ = Pace{&plan_, from, {}};
    const tern::Rival rest = tern::rest_of(pace_);
    EXPECT_NEAR(rest.duration, 6.5 - from, 1e-12) << from;
    EXPECT_NEAR(rest.snap, 576.0 * std::min(0.5, 6.5 - from), 1e-8) << from;
  }
  pace_ = Pace{&plan_, 7.0, {}};
  EXPECT_EQ(tern::rest_of(pace_).duration, 0.0);
}

TEST_F(PaceOfAPlan, StandsStillWhereThePlanDoes) {
  plan_.count = 0;
  fly_straight({1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 1.0, plan_);
  PaceWalk walk = begin(0.25);
  EXPECT_NEAR(tern::pace_to(pace_, {1.0, 0.0, 2.0}, walk, pieces_), 2.0, 1e-12);
  EXPECT_EQ(walk.time, 0.25);
}

}  // namespace
}  // namespace tern_test
