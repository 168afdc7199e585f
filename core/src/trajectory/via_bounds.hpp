// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the trajectory stage does besides for chains with vias.
#ifndef TERN_TRAJECTORY_VIA_BOUNDS_HPP
#define TERN_TRAJECTORY_VIA_BOUNDS_HPP

#include "base/work.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace tern {

/// After a programme that was too ill-conditioned: from now on the chain goes through its vias exactly, which improves
/// the conditioning. False if it already does.
bool give_up_tolerances(TrajectoryStage& stage) noexcept;

/// Reads what an abandoned programme tells about the durations of a chain with vias. Chains without vias do not use it.
void weigh_bound(TrajectoryStage& stage, Work& work) noexcept;

}  // namespace tern

#endif
