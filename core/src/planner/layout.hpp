// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PLANNER_LAYOUT_HPP
#define TERN_PLANNER_LAYOUT_HPP

#include "check/check_stage.hpp"
#include "corridor/corridor_stage.hpp"
#include "grid/fence_layer.hpp"
#include "grid/fences.hpp"
#include "path/path_stage.hpp"
#include "tern/workspace.hpp"
#include "trajectory/trajectory_stage.hpp"

namespace tern {

/// What the workspace holds. Each stage's result outlives it, as do the stops of scans; the stages' own states never
/// live at the same time and share one piece of memory.
struct Layout {
  Path path;
  Corridor corridor;
  Trajectory trajectory;
  Fences fences;
  AskedFences asked_fences;  ///< the same as the caller gave them, for the check
  Grid fenced;               ///< the caller's grid with fence_layer as its blocked layer, for a request with fences
  FenceLayer fence_layer;
  ScanMap scans;  ///< what a search found out about the map serves the next one
  union {
    PathStage path;
    CorridorStage corridor;
    TrajectoryStage trajectory;
    CheckStage check;
  } stage;
};

static_assert(alignof(Layout) <= kWorkspaceAlignment, "raise kWorkspaceAlignment");
static_assert(sizeof(Layout) + kWorkspaceAlignment <= kWorkspaceBytes,
              "define TERN_WORKSPACE_BYTES: the estimate in workspace.hpp falls short");

}  // namespace tern

#endif
