// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_SUPPORT_CHAIN_HPP
#define TERN_TESTS_SUPPORT_CHAIN_HPP

#include "times/times_stage.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace tern_test {

/// The times stage, run to its end.
inline void make_chain(const tern::Corridor& corridor, const tern::State& start, const tern::State& goal,
                       const tern::MotionLimits& limits, tern::Chain& chain) {
  tern::TimesStage stage;
  tern::Work work{0xFFFFFFFFu};
  tern::times_begin(stage, corridor, {start, goal, limits}, chain);
  tern::times_advance(stage, corridor, work, chain);
}

/// The trajectory stage, begun with what the times stage gives it.
inline void begin_trajectory(tern::TrajectoryStage& stage, const tern::Corridor& corridor,
                             const tern::TrajectoryQuery& query) {
  tern::Chain chain;
  make_chain(corridor, query.start, query.goal, query.limits, chain);
  tern::trajectory_begin(stage, corridor, query, chain);
}

}  // namespace tern_test

#endif
