// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random corridors with the limits of a vehicle: plans keep them at dense samples, fast ones use them, and none depends
// on what was planned before.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
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
  bool same_bits(const VehiclePlan& other) const {
    bool same = plan.count == other.plan.count;
    for (int i = 0; same && i < plan.count; ++i) {
      const Segment& a = plan.segments[i];
      const Segment& b = other.plan.segments[i];
      same = std::memcmp(&a.duration, &b.duration, sizeof a.duration) == 0 &&
             std::memcmp(a.points, b.points, sizeof a.points) == 0;
    }
    return same;
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

/// Every other plan turns back to where it starts, in one segment: its programme has no unknowns.
TEST(VehiclePlans, DependOnNothingThatWasPlannedBefore) {
  tern_test::Random random(42);
  VehiclePlan used;
  int alone = 0;
  const int cases = tern_test::scaled(100);
  for (int i = 0; i < cases; ++i) {
    const bool turns_back = i % 2 == 1;
    Corridor corridor = tern_test::random_corridor(random, turns_back ? 1 : 3, 12.0, 0.3);
    TrajectoryQuery query{};
    query.start = tern_test::resting(corridor.polyhedra[0].from);
    query.goal = tern_test::resting(corridor.polyhedra[corridor.count - 1].to);
    query.limits = tern_test::random_vehicle(random);
    query.time_weight = 40.0;
    if (turns_back) {
      corridor.polyhedra[0] = tern_test::box_around(query.start.position, query.start.position, 2.0);
      query.goal.position = query.start.position;
      query.start.velocity = {random.real(-0.1, 0.1), random.real(-0.1, 0.1), random.real(-0.1, 0.1)};
    }
    VehiclePlan fresh;
    ASSERT_EQ(used.make(corridor, query), fresh.make(corridor, query)) << i;
    ASSERT_TRUE(used.same_bits(fresh)) << i;
    ASSERT_EQ(used.stage->optimiser, fresh.stage->optimiser) << i;
    ASSERT_EQ(used.stage->iterations, fresh.stage->iterations) << i;
    alone += turns_back && fresh.stage->chain.count == 1 ? 1 : 0;
  }
  EXPECT_GE(alone, cases / 4);
}

}  // namespace
