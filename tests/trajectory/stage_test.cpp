// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "curve/brake.hpp"
#include "curve/motion_limits.hpp"
#include "curve/rest.hpp"
#include "support/box_corridor.hpp"
#include "support/chain.hpp"
#include "trajectory/stage_flight.hpp"
#include "trajectory/stop_and_go.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace {

using namespace tern;
using tern_test::box_around;
using tern_test::corner;
using tern_test::Flight;
using tern_test::kAgileLimits;
using tern_test::kTwo;
using tern_test::kUnlimited;
using tern_test::rest_to_rest;

TEST(TrajectoryStage, StartIsGoalHovers) {
  Corridor corridor{};
  corridor.count = 1;
  corridor.polyhedra[0] = box_around({1, 2, 3}, {1, 2, 3}, 0.5);
  const Flight run(corridor, rest_to_rest(corridor));
  ASSERT_EQ(run.status, Status::kOk);
  EXPECT_EQ(run.stage->quality, Quality::kHover);
  EXPECT_EQ(run.stage->optimiser, Status::kOk);
  ASSERT_EQ(run.plan.count, 1);
  EXPECT_EQ(run.plan.segments[0].duration, kHoverDuration);
  for (const Vec3& point : run.plan.segments[0].points) EXPECT_EQ(point.y, 2.0);
}

TEST(TrajectoryStage, OneLongBoxIsFlownNearTheTrapezoid) {
  Corridor corridor{};
  corridor.count = 1;
  corridor.polyhedra[0] = box_around({0, 0, 0}, {14, 0, 0}, 1.0);
  TrajectoryQuery query = rest_to_rest(corridor);
  query.time_weight = 1000.0;
  const Flight run(corridor, query);
  ASSERT_EQ(run.status, Status::kOk);
  EXPECT_EQ(run.stage->quality, Quality::kOptimised);
  EXPECT_EQ(run.plan.count, 5);
  // The trapezoid takes 8 s with infinite jerk; one segment of degree 7 would take 15.3 s.
  EXPECT_GT(duration(run.plan), 8.0);
  EXPECT_LT(duration(run.plan), 9.2);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(run.plan.segments[i].polyhedron, 0);
}

TEST(TrajectoryStage, ACornerIsFlownFasterThanFromStopToStop) {
  const Corridor corridor = corner();
  const Flight run(corridor, rest_to_rest(corridor));
  TrajectoryQuery stopping = rest_to_rest(corridor);
  stopping.stop_and_go = true;
  const Flight stops(corridor, stopping);
  ASSERT_EQ(run.status, Status::kOk);
  ASSERT_EQ(run.stage->quality, Quality::kOptimised);
  EXPECT_EQ(run.stage->optimiser, Status::kOk);
  EXPECT_LT(duration(run.plan), 0.8 * duration(stops.plan));
  EXPECT_LE(run.stage->iterations, kTrajectoryBound);
  EXPECT_LE(run.stage->solves, kMaxQpSolves);
  EXPECT_GT(run.stage->active_high, 0);
  EXPECT_LT(run.stage->kkt_residual, 1e-6);
}

TEST(TrajectoryStage, ALimitIsReachedWhereTimeIsDear) {
  const Corridor corridor = corner();
  TrajectoryQuery query = rest_to_rest(corridor);
  query.time_weight = 1e4;
  const Flight run(corridor, query);
  double stretch = 0.0;
  for (int i = 0; i < run.plan.count; ++i) {
    stretch = std::fmax(stretch, stretch_to_limits(run.plan.segments[i], kTwo));
  }
  EXPECT_NEAR(stretch, 1.0, 1e-6);
}

TEST(TrajectoryStage, TheWeightTradesDurationAgainstSnap) {
  const Corridor corridor = corner();
  double last_duration = 1e9;
  double last_snap = 0.0;
  for (const double weight : {0.01, 0.3, 3.0, 40.0}) {
    TrajectoryQuery query = rest_to_rest(corridor);
    query.time_weight = weight;
    const Flight run(corridor, query);
    ASSERT_EQ(run.stage->quality, Quality::kOptimised);
    EXPECT_LT(duration(run.plan), last_duration);
    EXPECT_GT(snap_cost(run.plan), last_snap);
    last_duration = duration(run.plan);
    last_snap = snap_cost(run.plan);
  }
}

TEST(TrajectoryStage, APlanThatDoesNotBeatItsRivalIsNone) {
  const Corridor corridor = corner();
  TrajectoryQuery query = rest_to_rest(corridor);
  const Flight alone(corridor, query);
  query.rival = {duration(alone.plan), snap_cost(alone.plan)};
  const Flight beaten(corridor, query);
  EXPECT_EQ(beaten.status, Status::kNoTrajectory);
  EXPECT_EQ(beaten.stage->quality, Quality::kNone);
  EXPECT_EQ(beaten.stage->solves, 1);
  EXPECT_LT(4 * beaten.spent, alone.spent);
}

TEST(TrajectoryStage, APlanThatBeatsItsRivalIsFound) {
  const Corridor corridor = corner();
  TrajectoryQuery query = rest_to_rest(corridor);
  const Flight alone(corridor, query);
  query.rival = {1.5 * duration(alone.plan), snap_cost(alone.plan)};
  const Flight better(corridor, query);
  ASSERT_EQ(better.status, Status::kOk);
  EXPECT_EQ(better.stage->quality, Quality::kOptimised);
  const double rate = kDefaultTimeWeight * better.stage->refinement.unit;
  EXPECT_LT(snap_cost(better.plan) + rate * duration(better.plan), query.rival.snap + rate * query.rival.duration);
}

TEST(TrajectoryStage, AgileLimitsAreApproachedFromSmallerWeights) {
  const Corridor corridor = corner();
  TrajectoryQuery query = rest_to_rest(corridor);
  query.limits = kAgileLimits;
  const Flight run(corridor, query);
  ASSERT_EQ(run.stage->quality, Quality::kOptimised);
  EXPECT_EQ(run.stage->refinement.first_rung, -2);  // agility about 3.78 m / 0.25 m = 15.1
  EXPECT_EQ(run.stage->refinement.rung, 0);
  // 11.1 m at 1 m/s, and little more; some of it across the corner.
  EXPECT_LT(duration(run.plan), 11.4);
}

TEST(TrajectoryStage, TheWorkspacesContentDoesNotMatter) {
  const Corridor corridor = corner();
  const Flight zero(corridor, rest_to_rest(corridor));
  for (const int fill : {0xA5, 0xFF}) {
    const Flight garbage(corridor, rest_to_rest(corridor), kUnlimited, fill);
    EXPECT_TRUE(garbage.same_plan(zero));
    EXPECT_EQ(garbage.stage->iterations, zero.stage->iterations);
  }
}

TEST(TrajectoryStage, StartsExactlyAtTheLimitSpeed) {
  Corridor corridor = corner();
  TrajectoryQuery query = rest_to_rest(corridor);
  query.start.velocity = {2.0, 0, 0};
  const Flight run(corridor, query);
  ASSERT_EQ(run.status, Status::kOk);
  EXPECT_EQ(run.stage->quality, Quality::kOptimised);
  const Sample sample = evaluate(run.plan, 0.0);
  EXPECT_NEAR(sample.velocity.x, 2.0, 1e-9);
  EXPECT_NEAR(sample.jerk.x, 0.0, 1e-7);
}

TEST(TrajectoryStage, EndsMovingAndAccelerating) {
  Corridor corridor = corner();
  TrajectoryQuery query = rest_to_rest(corridor);
  query.goal.velocity = {1.0, 0, 0.2};
  query.goal.acceleration = {0.5, 0, 0};
  const Flight run(corridor, query);
  ASSERT_EQ(run.status, Status::kOk);
  EXPECT_EQ(run.stage->quality, Quality::kOptimised);
  const Sample sample = evaluate(run.plan, std::nextafter(duration(run.plan), 0.0));
  EXPECT_NEAR(sample.velocity.x, 1.0, 1e-7);
  EXPECT_NEAR(sample.acceleration.x, 0.5, 1e-6);
}

TEST(TrajectoryStage, TurnsAroundInABoxOfNoLength) {
  Corridor corridor{};
  corridor.count = 1;
  corridor.polyhedra[0] = box_around({0, 0, 0}, {0, 0, 0}, 2.0);
  TrajectoryQuery query = rest_to_rest(corridor);
  query.start.velocity = {1.0, 0, 0};
  const Flight run(corridor, query);
  ASSERT_EQ(run.status, Status::kOk);
  EXPECT_EQ(run.stage->quality, Quality::kOptimised);
  for (int i = 0; i < run.plan.count; ++i) EXPECT_TRUE(inside(run.plan.segments[i], corridor.polyhedra[0]));
}

TEST(TrajectoryStage, NoTrajectoryWhereAWallIsTooClose) {
  const Corridor corridor = corner();
  TrajectoryQuery query = rest_to_rest(corridor);
  query.start.velocity = {0, 2.0, 0};  // one metre to stop in, 0.4 m to the wall
  const Flight run(corridor, query);
  EXPECT_EQ(run.status, Status::kNoTrajectory);
  EXPECT_EQ(run.stage->quality, Quality::kNone);
  EXPECT_NE(run.stage->optimiser, Status::kOk);
  EXPECT_EQ(run.plan.count, 0);
}

}  // namespace
