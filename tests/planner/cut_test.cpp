// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is taken of a previous plan: all of it if it ends as the goal asks, else segments made anew.
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "planner/previous.hpp"
#include "support/world.hpp"

namespace tern_test {
namespace {

using tern::Previous;
using tern::Trajectory;
using tern::Vec3;

constexpr double kUlp = 0x1p-52;  ///< of numbers from 1 to 2
const Vec3 kOrigin{1.0, 2.0, 1.0};

/// Along x at 1 m/s, in segments that take so long.
Trajectory straight_on(const std::vector<double>& durations) {
  Trajectory plan{};
  plan.origin = kOrigin;
  double begin = 0.0;
  for (const double duration : durations) {
    tern::Segment& segment = plan.segments[plan.count++];
    segment.duration = duration;
    for (int k = 0; k < tern::kControlPoints; ++k) segment.points[k] = {begin + duration * k / tern::kDegree, 0.0, 0.0};
    begin += duration;
  }
  return plan;
}

class CutPlan : public testing::Test {
 protected:
  CutPlan() : world_({80, 40, 20}, 0.1, 0.2) {}
  /// Takes what is left at `time`. The goal is so far from the plan's end; its speed is so much more than that there.
  void cut(const Trajectory& plan, double time, double beside = 0.0, double faster = 0.0) {
    plan_ = plan;
    tern::Request& request = world_.request;
    const tern::Sample now = evaluate(plan_, time);
    request.start = {now.position, now.velocity, now.acceleration, now.jerk};
    request.previous = &plan_;
    request.previous_time = time;
    request.goal = {{kOrigin.x + duration(plan_), kOrigin.y + beside, kOrigin.z}, {1.0 + faster, 0.0, 0.0}, {}};
    ASSERT_TRUE(previous_fits(request));
    tern::take_rest(world_.grid, request, *rest_);
  }

  World world_;
  Trajectory plan_{};
  std::unique_ptr<Previous> rest_ = std::make_unique<Previous>();
};

/// The first segment lasts 1.5 ulp more than 0.25 s. Both that and 1.25 s add up to 1.5 + 2 ulp, as a tie rounds to an
/// even number. One ulp before, 1.25 s less half an ulp have gone since the first segment, and that tie rounds to
/// 1.25 s: the second segment is over, although the sum is not reached.
TEST_F(CutPlan, SegmentIsOverWhereTheTimeLeftRoundsToNone) {
  const double first = 0.25 + 1.5 * kUlp;
  const double time = 1.5 + kUlp;
  ASSERT_LT(time, first + 1.25);
  ASSERT_EQ(time - first, 1.25);
  cut(straight_on({first, 1.25, 0.5}), time, 0.5);
  ASSERT_EQ(rest_->count, 1);
  EXPECT_EQ(rest_->segments[0].duration, 0.5);
  EXPECT_FALSE(rest_->meets_goal);
  // Nothing follows: nothing is left, however near the goal is.
  cut(straight_on({first, 1.25}), time);
  EXPECT_FALSE(rest_->meets_goal);
}

/// Where the plan ends as the goal asks, nothing is made anew. The position and each derivative count.
TEST_F(CutPlan, MeetsTheGoalInItsMotionAlone) {
  cut(straight_on({1.0, 1.0}), 0.5);
  EXPECT_TRUE(rest_->meets_goal);
  EXPECT_EQ(rest_->count, 0);
  for (const double off : {1e-6, 0.5}) {
    cut(straight_on({1.0, 1.0}), 0.5, off);
    EXPECT_FALSE(rest_->meets_goal);
    EXPECT_EQ(rest_->count, 2);
    cut(straight_on({1.0, 1.0}), 0.5, 0.0, off);
    EXPECT_FALSE(rest_->meets_goal);
    EXPECT_EQ(rest_->count, 2);
  }
  cut(straight_on({1.0, 1.0}), 2.0);
  EXPECT_FALSE(rest_->meets_goal);
}

/// Half of the last segment is left, then one and a half.
TEST_F(CutPlan, EndsElsewhereInItsOwnMotion) {
  for (const double time : {1.5, 0.5}) {
    cut(straight_on({1.0, 1.0}), time, 0.5);
    ASSERT_EQ(rest_->count, time > 1.0 ? 1 : 2);
    EXPECT_EQ(rest_->segments[0].duration, 0.5);
    const tern::Segment& last = rest_->segments[rest_->count - 1];
    EXPECT_NEAR(last.points[7].x, 2.0 - time, 1e-12);
    EXPECT_NEAR((last.points[7].x - last.points[6].x) * 7.0 / last.duration, 1.0, 1e-12);
  }
}

/// However little is left of a segment, it is made anew from the states at its ends; but a plan of which so little is
/// left is as good as over.
TEST_F(CutPlan, ShortRemaindersStayOfTheFirstSegmentAlone) {
  constexpr double kLeft = 0x1p-11;
  cut(straight_on({1.0, 1.0, 0.5}), 1.0 - kLeft, 0.5);
  ASSERT_EQ(rest_->count, 3);
  EXPECT_EQ(rest_->segments[0].duration, kLeft);
  EXPECT_EQ(rest_->segments[1].duration, 1.0);
  EXPECT_EQ(rest_->segments[2].duration, 0.5);
  EXPECT_EQ(rest_->segments[0].points[0].x, 0.0);
  EXPECT_NEAR(rest_->segments[0].points[7].x, kLeft, 1e-12);
  EXPECT_NEAR(rest_->segments[1].points[7].x, kLeft + 1.0, 1e-12);
  cut(straight_on({1.0}), 1.0 - kLeft, 0.5);
  EXPECT_EQ(rest_->count, 0);
}

}  // namespace
}  // namespace tern_test
