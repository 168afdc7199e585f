// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Budgets and slices of the trajectory stage.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

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
using tern_test::corner;
using tern_test::Flight;
using tern_test::kAgileLimits;
using tern_test::kTwo;
using tern_test::kUnlimited;
using tern_test::rest_to_rest;

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

TEST(TrajectoryStage, BrakesFirstWhereThereIsNoBudget) {
  Corridor corridor = corner();
  TrajectoryQuery query = rest_to_rest(corridor);
  query.start.velocity = {1.0, 0, 0};
  const Flight run(corridor, query, kUnlimited, 0, 0);
  ASSERT_EQ(run.status, Status::kOk);
  EXPECT_EQ(run.stage->quality, Quality::kStopAndGo);
  EXPECT_EQ(run.plan.count, kBrakeSegments + corridor.count);
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
