// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rows of a limit on body rates: a plan is within the rows that follow from it, and touches some of them.
#include "trajectory/turning_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "base/math.hpp"
#include "support/box_corridor.hpp"
#include "support/chain.hpp"
#include "support/vehicle_limits.hpp"
#include "trajectory/trajectory_stage.hpp"
#include "trajectory/turning.hpp"

namespace {

using namespace tern;

/// The plan's own value of a programme's point, in the programme's unit.
Vec3 own_point(const TrajectoryStage& stage, int point) {
  const PointOrigin& origin = stage.scale.origin[point];
  Vec3 sum = kZero;
  for (int k = 0; k < kControlPoints; ++k) {
    sum = sum + points_of(origin.order).weights[origin.index][k] * stage.best.points[origin.segment][k];
  }
  const double power = power_of(stage.chain.duration[origin.segment], origin.order);
  return (1.0 / (power * stage.scale.unit[origin.order])) * sum;
}

/// The most that the plan exceeds one of its rows, of the row's bound; below 0 if it is within all.
double excess(const TrajectoryStage& stage) {
  double most = -1.0;
  for (int g = 0; g < stage.problem.group_count; ++g) {
    const QpGroup& group = stage.problem.groups[g];
    const int order = stage.scale.origin[group.point_begin].order;
    if (order < 2 || group.plane_begin < stage.scale.turning) continue;
    for (int point = group.point_begin; point < group.point_end; ++point) {
      for (int p = group.plane_begin; p < group.plane_end; ++p) {
        const Halfspace& plane = stage.problem.planes[p];
        const double over = dot(plane.normal, own_point(stage, point)) - plane.offset;
        most = std::fmax(most, over / (1.0 + std::fabs(plane.offset)));
      }
    }
  }
  return most;
}

TEST(TurningRows, HoldThePlanThatTheyFollow) {
  tern_test::Random random(43);
  const auto stage = std::make_unique<TrajectoryStage>();
  Trajectory plan{};
  int held = 0;
  for (int i = 0; i < tern_test::scaled(40); ++i) {
    const Corridor corridor = tern_test::random_corridor(random, random.integer(2, 6), 12.0, 0.3);
    TrajectoryQuery query{};
    query.start = tern_test::resting(corridor.polyhedra[0].from);
    query.goal = tern_test::resting(corridor.polyhedra[corridor.count - 1].to);
    query.limits = tern_test::random_vehicle(random);
    query.time_weight = 200.0;
    if (!(query.limits.rate > 0.0)) continue;
    tern_test::begin_trajectory(*stage, corridor, query);
    Work work{0xFFFFFFFFu};
    trajectory_advance(*stage, corridor, work, plan);
    if (stage->quality != Quality::kOptimised) continue;
    for (int k = 0; k < plan.count; ++k) {
      stage->chain.duration[k] = plan.segments[k].duration;
      for (double& share : stage->turning.share[k]) share = 1.0;
    }
    follow_turning({stage->chain, stage->best.points}, query.limits, stage->turning);
    assemble(stage->chain, corridor, query.limits, &stage->turning, stage->problem, stage->scale);
    EXPECT_LE(excess(*stage), 1e-9) << i;
    EXPECT_GT(excess(*stage), -0.5) << i;
    ++held;
  }
  EXPECT_GT(held, 0);
}

}  // namespace
