// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The vias of a plan: where its chain and its trajectory pass them.
#ifndef TERN_PLANNER_VIAS_HPP
#define TERN_PLANNER_VIAS_HPP

#include <cstdint>

#include "corridor/corridor_stage.hpp"
#include "planner/problem.hpp"
#include "tern/config.hpp"
#include "tern/path.hpp"
#include "tern/report.hpp"
#include "tern/trajectory.hpp"
#include "tern/via.hpp"
#include "times/chain.hpp"

namespace tern {

struct ViaMemory {
  Via vias[kMaxVias];             ///< as asked for, world frame
  ViaMarks marks;                 ///< their waypoints on the path, and their polyhedra in the corridor of the path
  ViaJoint via_joints[kMaxVias];  ///< their joints in the chain
  std::int32_t joint[kMaxVias];   ///< index of the segment that begins at the via, or the number of segments
  Path leg;                       ///< the path of the current leg
};

/// What the chain must do at the vias. The plan passes exactly through a via whose voxel is not free. The legs that
/// join such a via to the grid are short, and a programme in which such a leg has free ends is too ill-conditioned.
ViaJoints make_via_joints(const Problem& problem, ViaMemory& memory) noexcept;

/// Finds the joints where the finished trajectory passes the vias, and lets it rest at those with a dwell. False if one
/// more segment does not fit.
bool add_dwells(const Problem& problem, ViaMemory& memory, Trajectory& trajectory) noexcept;

/// Writes when and how near the finished trajectory passes each via; one entry a via.
void write_passages(const Problem& problem, const ViaMemory& memory, const Trajectory& trajectory,
                    ViaPassage* passages) noexcept;

}  // namespace tern

#endif
