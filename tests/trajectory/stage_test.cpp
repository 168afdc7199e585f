// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "curve/brake.hpp"
#include "curve/motion_limits.hpp"
#include "curve/rest.hpp"
#include "support/box_corridor.hpp"
#include "support/chain.hpp"
#include "trajectory/stop_and_go.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace {

using namespace tern;
using tern_test::box_around;
using tern_test::kTwo;
using tern_test::kUnlimited;
using tern_test::resting;

/// The speed limit alone decides how long a flight takes.
constexpr Limits kAgileLimits{{1.0, 1.0, 1.0}, {4.0, 4.0, 4.0}};

/// A plan with everything that it was made from and says about itself.
struct Flight {
  std::unique_ptr<TrajectoryStage> stage = std::make_unique<TrajectoryStage>();
  Trajectory plan;
  Status status;
  Operations spent = 0;

  /// Runs in slices; stopped once `budget` is spent.
  Flight(const Corridor& corridor, const TrajectoryQuery& query, std::uint32_t slice = kUnlimited, int fill = 0,
         std::uint32_t budget = kUnlimited) {
    std::memset(static_cast<void*>(stage.get()), fill, sizeof(TrajectoryStage));
    std::memset(static_cast<void*>(&plan), 0, sizeof(plan));
    tern_test::begin_trajectory(*stage, corridor, query);
    Progress progress = Progress::kMore;
    while (progress == Progress::kMore) {
      Work work = Work{slice}.within(kUnit * budget - spent);
      const Operations given = work.operations();
      progress = trajectory_advance(*stage, corridor, work, plan);
      spent += given - work.operations();
      if (progress == Progress::kMore && spent >= kUnit * budget) trajectory_stop(*stage);
    }
    status = stage->status;
  }
  bool same_plan(const Flight& other) const { return std::memcmp(&plan, &other.plan, sizeof(plan)) == 0; }
};

Corridor corner() {
  Corridor corridor{};
  corridor.count = 3;
  corridor.polyhedra[0] = box_around({0, 0, 1}, {4, 0, 1}, 0.4);
  corridor.polyhedra[1] = box_around({4, 0, 1}, {4, 3, 1}, 0.3);
  corridor.polyhedra[2] = box_around({4, 3, 1}, {8, 3, 2}, 0.5);
  return corridor;
}

TrajectoryQuery rest_to_rest(const Corridor& corridor) {
  return {resting(corridor.polyhedra[0].from), resting(corridor.polyhedra[corridor.count - 1].to), kTwo,
          kDefaultTimeWeight};
}

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

TEST(TrajectoryStage, NoBudgetIsStopAndGo) {
  const Corridor corridor = corner();
  const Flight run(corridor, rest_to_rest(corridor), kUnlimited, 0, 0);
  ASSERT_EQ(run.status, Status::kOk);
  EXPECT_EQ(run.stage->quality, Quality::kStopAndGo);
  EXPECT_EQ(run.stage->optimiser, Status::kBudgetOptimise);
  EXPECT_EQ(run.stage->solves, 0);
  EXPECT_EQ(run.plan.count, 3);
}

void every_budget_gives_a_plan(double weight, const Limits& limits) {
  const Corridor corridor = corner();
  TrajectoryQuery query = rest_to_rest(corridor);
  query.limits = limits;
  query.time_weight = weight;
  const Flight full(corridor, query);
  const auto all = static_cast<std::uint32_t>(full.spent / kUnit);
  const double rate = weight * full.stage->refinement.unit;
  double last = 1e9;
  const std::uint32_t stride = all / static_cast<std::uint32_t>(tern_test::scaled(200));
  for (std::uint32_t budget = 0; budget <= all + 1;
       budget = budget < all ? std::min(budget + stride, all) : budget + 1) {
    const Flight run(corridor, query, kUnlimited, 0, budget);
    ASSERT_EQ(run.status, Status::kOk);
    // More budget never gives a costlier plan; the whole of it gives the same bits as no bound.
    const double cost = snap_cost(run.plan) + rate * duration(run.plan);
    EXPECT_LE(cost, last * (1.0 + 1e-9));
    last = cost;
    if (budget > all) {
      EXPECT_EQ(run.stage->optimiser, Status::kOk);
      EXPECT_TRUE(run.same_plan(full));
    } else if (budget < all / 2) {
      EXPECT_EQ(run.stage->optimiser, Status::kBudgetOptimise);
    }
  }
}

TEST(TrajectoryStage, EveryBudgetGivesAPlan) {
  every_budget_gives_a_plan(kDefaultTimeWeight, kTwo);
}

TEST(TrajectoryStage, EveryBudgetGivesAPlanOnEveryRung) {
  every_budget_gives_a_plan(1000.0, kTwo);
}

TEST(TrajectoryStage, EveryBudgetGivesAPlanOnRungsBelow) {
  every_budget_gives_a_plan(kDefaultTimeWeight, kAgileLimits);
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

TEST(TrajectoryStage, SlicingChangesNothing) {
  const Corridor corridor = corner();
  const Flight whole(corridor, rest_to_rest(corridor));
  for (const std::uint32_t slice : {1u, 2u, 3u, 7u, 50u}) {
    const Flight sliced(corridor, rest_to_rest(corridor), slice);
    EXPECT_TRUE(sliced.same_plan(whole));
    EXPECT_EQ(sliced.stage->iterations, whole.stage->iterations);
    EXPECT_EQ(sliced.stage->solves, whole.stage->solves);
  }
}

TEST(TrajectoryStage, SlicingAndABudgetAgree) {
  const Corridor corridor = corner();
  for (std::uint32_t budget = 1; budget < 3000; budget += 1 + budget / 4) {
    const Flight whole(corridor, rest_to_rest(corridor), kUnlimited, 0, budget);
    for (const std::uint32_t slice : {1u, 2u, 5u}) {
      const Flight sliced(corridor, rest_to_rest(corridor), slice, 0, budget);
      EXPECT_TRUE(sliced.same_plan(whole));
      EXPECT_EQ(sliced.stage->optimiser, whole.stage->optimiser);
    }
  }
}

TEST(TrajectoryStage, NoWorkIsNoProgress) {
  const Corridor corridor = corner();
  const auto stage = std::make_unique<TrajectoryStage>();
  tern_test::begin_trajectory(*stage, corridor, rest_to_rest(corridor));
  Trajectory plan{};
  plan.count = 77;
  Work work{0};
  EXPECT_EQ(trajectory_advance(*stage, corridor, work, plan), Progress::kMore);
  EXPECT_EQ(stage->solves, 0);
  EXPECT_EQ(plan.count, 77);
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

TEST(TrajectoryStage, BrakesFirstWhereThereIsNoBudget) {
  Corridor corridor = corner();
  TrajectoryQuery query = rest_to_rest(corridor);
  query.start.velocity = {1.0, 0, 0};
  const Flight run(corridor, query, kUnlimited, 0, 0);
  ASSERT_EQ(run.status, Status::kOk);
  EXPECT_EQ(run.stage->quality, Quality::kStopAndGo);
  EXPECT_EQ(run.plan.count, kBrakeSegments + corridor.count);
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

TEST(TrajectoryStage, FullOfSegments) {
  tern_test::Random random(5);
  const auto corridor = std::make_unique<Corridor>(tern_test::random_corridor(random, kMaxSegments, 1.5, 0.3));
  const Flight run(*corridor, rest_to_rest(*corridor));
  ASSERT_EQ(run.status, Status::kOk);
  EXPECT_NE(run.stage->quality, Quality::kNone);
  EXPECT_EQ(run.plan.count, kMaxSegments);
}

}  // namespace
