// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random corridors with the limits of a vehicle: plans keep them at dense samples, and fast ones use them.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "base/math.hpp"
#include "support/box_corridor.hpp"
#include "support/chain.hpp"
#include "support/vehicle_limits.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace {

using namespace tern;

struct VehiclePlan {
  std::unique_ptr<TrajectoryStage> stage = std::make_unique<TrajectoryStage>();
  Trajectory plan{};

  Status make(const Corridor& corridor, const TrajectoryQuery& query) {
    tern_test::begin_trajectory(*stage, corridor, query);
    Work work{0xFFFFFFFFu};
    trajectory_advance(*stage, corridor, work, plan);
    return stage->status;
  }
  double use(const Limits& limits) const {
    double most = 0.0;
    const int steps = 100 * plan.count;
    for (int i = 0; i <= steps; ++i) {
      const Sample s = evaluate(plan, duration(plan) * i / steps);
      most = std::fmax(most, tern_test::vehicle_use(limits, s.acceleration, s.jerk));
    }
    return most;
  }
};

TEST(VehiclePlans, KeepAndUseTheLimits) {
  tern_test::Random random(41);
  VehiclePlan fast;
  int moving = 0;
  int optimised = 0;
  const int cases = tern_test::scaled(100);
  for (int i = 0; i < cases; ++i) {
    const Corridor corridor = tern_test::random_corridor(random, random.integer(1, 7), 12.0, 0.3);
    const Limits limits = tern_test::random_vehicle(random);
    TrajectoryQuery query{};
    query.start = tern_test::resting(corridor.polyhedra[0].from);
    query.goal = tern_test::resting(corridor.polyhedra[corridor.count - 1].to);
    query.limits = limits;
    query.time_weight = i % 2 == 0 ? 1000.0 : 40.0;
    query.stop_and_go = i % 10 == 9;
    const bool moves = i % 4 == 1;
    if (moves) {
      const Vec3 leg = corridor.polyhedra[0].to - corridor.polyhedra[0].from;
      query.start.velocity = (random.real(0.1, 1.0) / length(leg)) * leg;
      query.start.acceleration = {0.3 * random.unit(), 0.0, 0.3 * random.unit()};
    }
    const Status status = fast.make(corridor, query);
    if (moves && status == Status::kNoTrajectory) continue;
    ASSERT_EQ(status, Status::kOk) << i;
    moving += moves ? 1 : 0;
    EXPECT_LE(fast.use(limits), 1.0 + 1e-7) << i;
    if (fast.stage->quality != Quality::kOptimised) continue;
    ++optimised;
    EXPECT_TRUE(moves || query.time_weight < 1000.0 || fast.use(limits) > 0.5) << i << ": " << fast.use(limits);
  }
  EXPECT_GT(optimised, cases * 7 / 10);
  EXPECT_GT(moving, cases / 6);
}

}  // namespace
