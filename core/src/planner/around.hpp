// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans around things that move. The plan that was made as if nothing moved is the seed: its corridor, its durations,
// and its curve, which says on which side to pass. The trajectory stage then makes a plan with planes between it and
// the things.
#ifndef TERN_PLANNER_AROUND_HPP
#define TERN_PLANNER_AROUND_HPP

#include "planner/curves.hpp"
#include "planner/end_stop.hpp"
#include "planner/problem.hpp"
#include "tern/report.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

namespace tern {

struct Around {
  bool is_active = false;            ///< the trajectory in memory, or the one that is being made, leads around things
  Quality quality = Quality::kNone;  ///< of the plan that was made as if nothing moved
  Status optimiser = Status::kOk;
  bool is_full = false;  ///< there were more planes than there is room for
};

/// True if there is a corridor and a plan of this quality to begin from.
constexpr bool may_lead_around(Quality quality, bool has_corridor) noexcept {
  return has_corridor && (quality == Quality::kOptimised || quality == Quality::kStopAndGo);
}

/// A seed's durations are lengthened by this factor: the way around is longer.
constexpr double kAroundSlack = 1.04;

/// Makes the chain and the scene of the seed, and begins its trajectory. The times stage has run: the memory has the
/// corridor and the chain's ends and vias. `alone` must stay until the trajectory is done.
void around_begin(const Problem& problem, const Ends& ends, const EndStop& start_stop, const Trajectory& alone,
                  CurveMemory& memory) noexcept;

}  // namespace tern

#endif
