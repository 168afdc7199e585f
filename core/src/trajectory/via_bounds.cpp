// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/via_bounds.hpp"

namespace tern {

bool give_up_tolerances(TrajectoryStage& stage) noexcept {
  bool had_some = false;
  for (int i = 0; i < stage.chain.via_joint_count; ++i) {
    had_some = had_some || stage.chain.via_joints[i].reach > 0.0;
    stage.chain.via_joints[i].reach = 0.0;
  }
  if (had_some) stage.warm_count = 0;
  return had_some;
}

void weigh_bound(TrajectoryStage& stage, Work& work) noexcept {
  Round& round = stage.round;
  const double bound = qp_lower_bound(stage.solver);
  round.bounded = stage.chain.via_joint_count > 0 && stage.best.found && bound > -kQpNoBound;
  if (!round.bounded) return;
  round.offer.snap = stage.scale.snap_per_cost * bound + stage.fixed_snap;
  qp_abandon(stage.solver, stage.problem, stage.solution);
  work.spend(stage.solver.spent + points_operations(stage.chain) + prices_operations(stage.chain, stage.solution));
  read_points(stage.chain, stage.scale, stage.solution, stage.points);
  time_prices(stage.chain, stage.problem, stage.solution, stage.scale, stage.points, round.prices);
}

}  // namespace tern
