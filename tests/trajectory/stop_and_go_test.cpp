// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/stop_and_go.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "base/math.hpp"
#include "curve/brake.hpp"
#include "curve/hermite.hpp"
#include "curve/motion_limits.hpp"
#include "curve/rest.hpp"
#include "support/box_corridor.hpp"

namespace {

using namespace tern;
using tern_test::box_around;
using tern_test::kTwo;
using tern_test::resting;

TEST(StraightSegment, LongOnesAreBoundBySpeed) {
  const Segment segment = straight_segment({0, 0, 0}, {16, 0, 0}, 3, kTwo);
  EXPECT_NEAR(segment.duration, 35.0 / 16.0 * 16.0 / 2.0, 1e-12);
  EXPECT_EQ(segment.polyhedron, 3);
  EXPECT_NEAR(stretch_to_limits(segment, kTwo), 1.0, 1e-6);
}

TEST(StraightSegment, ShortOnesAreBoundByAcceleration) {
  const Segment segment = straight_segment({0, 0, 0}, {0, 1, 0}, 0, kTwo);
  EXPECT_NEAR(segment.duration, std::sqrt(84.0 * std::sqrt(5.0) / 25.0 / 2.0), 1e-12);
  EXPECT_NEAR(stretch_to_limits(segment, kTwo), 1.0, 1e-6);
}

TEST(StraightSegment, OfNoLengthLastsTheMinimum) {
  EXPECT_EQ(straight_segment({1, 2, 3}, {1, 2, 3}, 0, kTwo).duration, kMinDuration);
}

TEST(StraightSegment, KeepsLimitsOfEveryAxisAndReachesOne) {
  tern_test::Random random(1);
  for (int i = 0; i < tern_test::scaled(500); ++i) {
    const Limits limits = tern_test::random_limits(random);
    const Vec3 to{random.real(-9.0, 9.0), random.real(-9.0, 9.0), random.real(-9.0, 9.0)};
    const Segment segment = straight_segment({1, 2, 3}, to, 0, limits);
    EXPECT_TRUE(within_limits(segment, limits));
    EXPECT_NEAR(stretch_to_limits(segment, limits), 1.0, 1e-6);
  }
}

TEST(StopAndGo, HoversWhereThereIsNoWay) {
  const auto corridor = std::make_unique<Corridor>();
  corridor->count = 2;
  for (int i = 0; i < 2; ++i) corridor->polyhedra[i] = box_around({1, 2, 3}, {1, 2, 3}, 0.5);
  Trajectory plan{};
  ASSERT_EQ(stop_and_go(*corridor, resting({1, 2, 3}), resting({1, 2, 3}), kTwo, plan), Status::kOk);
  ASSERT_EQ(plan.count, 1);
  EXPECT_EQ(plan.segments[0].duration, kHoverDuration);
  for (const Vec3& point : plan.segments[0].points) EXPECT_TRUE(same(point, {1, 2, 3}));
}

TEST(StopAndGo, VisitsEveryWaypoint) {
  tern_test::Random random(2);
  const Corridor corridor = tern_test::random_corridor(random, 5, 4.0, 0.1);
  const State start = resting(corridor.polyhedra[0].from);
  const State goal = resting(corridor.polyhedra[4].to);
  Trajectory plan{};
  ASSERT_EQ(stop_and_go(corridor, start, goal, kTwo, plan), Status::kOk);
  ASSERT_EQ(plan.count, 5);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(plan.segments[i].polyhedron, i);
    EXPECT_EQ(plan.segments[i].points[0].x, corridor.polyhedra[i].from.x);
    EXPECT_EQ(plan.segments[i].points[kDegree].z, corridor.polyhedra[i].to.z);
    EXPECT_TRUE(inside(plan.segments[i], corridor.polyhedra[i]));
  }
}

TEST(StopAndGo, BrakesFirstAndSpeedsUpLast) {
  Corridor corridor{};
  corridor.count = 1;
  corridor.polyhedra[0] = box_around({0, 0, 0}, {8, 0, 0}, 2.0);
  const State start{{0, 0, 0}, {0, 1.0, 0}, {0, 0, 0}};
  const State goal{{8, 0, 0}, {0.8, 0, 0}, {0.1, 0, 0}};
  Trajectory plan{};
  ASSERT_EQ(stop_and_go(corridor, start, goal, kTwo, plan), Status::kOk);
  ASSERT_EQ(plan.count, kBrakeSegments + 1 + kBrakeSegments);
  const Sample first = evaluate(plan, 0.0);
  EXPECT_NEAR(first.velocity.y, 1.0, 1e-12);
  const Sample last = evaluate(plan, std::nextafter(duration(plan), 0.0));
  EXPECT_NEAR(last.position.x, 8.0, 1e-12);
  EXPECT_NEAR(last.velocity.x, 0.8, 1e-9);
  EXPECT_NEAR(last.acceleration.x, 0.1, 1e-9);
  EXPECT_NEAR(last.jerk.x, 0.0, 1e-9);
  for (int i = 0; i < plan.count; ++i) {
    EXPECT_TRUE(inside(plan.segments[i], corridor.polyhedra[0]));
    EXPECT_TRUE(within_limits(plan.segments[i], kTwo));
  }
}

TEST(StopAndGo, LeavesOutLegsOfNoLength) {
  Corridor corridor{};
  corridor.count = 3;
  corridor.polyhedra[0] = box_around({0, 0, 0}, {1, 0, 0}, 0.5);
  corridor.polyhedra[1] = box_around({1, 0, 0}, {1, 0, 0}, 0.5);
  corridor.polyhedra[2] = box_around({1, 0, 0}, {1, 2, 0}, 0.5);
  Trajectory plan{};
  ASSERT_EQ(stop_and_go(corridor, resting({0, 0, 0}), resting({1, 2, 0}), kTwo, plan), Status::kOk);
  ASSERT_EQ(plan.count, 2);
  EXPECT_EQ(plan.segments[1].polyhedron, 2);
}

TEST(StopAndGo, LeavesTheOutputAloneWhereItFails) {
  Corridor corridor{};
  corridor.count = 1;
  corridor.polyhedra[0] = box_around({0, 0, 0}, {8, 0, 0}, 0.1);
  Trajectory plan{};
  plan.count = 77;
  EXPECT_EQ(stop_and_go(corridor, State{{0, 0, 0}, {0, 2, 0}, {0, 0, 0}}, resting({8, 0, 0}), kTwo, plan),
            Status::kNoTrajectory);
  EXPECT_EQ(plan.count, 77);
}

TEST(StopAndGo, NeedsSegmentsForBraking) {
  tern_test::Random random(3);
  const auto corridor = std::make_unique<Corridor>(tern_test::random_corridor(random, kMaxSegments, 1.0, 1.0));
  const State start{corridor->polyhedra[0].from, {0.1, 0, 0}, {0, 0, 0}};
  const State goal = resting(corridor->polyhedra[kMaxSegments - 1].to);
  Trajectory plan{};
  plan.count = 77;
  EXPECT_EQ(stop_and_go(*corridor, start, goal, kTwo, plan), Status::kSegmentsFull);
  EXPECT_EQ(plan.count, 77);
  EXPECT_EQ(stop_and_go(*corridor, resting(start.position), goal, kTwo, plan), Status::kOk);
}

}  // namespace
