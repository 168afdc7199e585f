// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PLANNER_LAYOUT_HPP
#define TERN_PLANNER_LAYOUT_HPP

#include "corridor/corridor_stage.hpp"
#include "path/reach_stage.hpp"
#include "path/search_stage.hpp"
#include "path/shortcut_stage.hpp"
#include "planner/around.hpp"
#include "planner/curves.hpp"
#include "planner/end_stop.hpp"
#include "planner/moving.hpp"
#include "planner/pipeline.hpp"
#include "planner/previous.hpp"
#include "planner/vias.hpp"
#include "prove/check_stage.hpp"
#include "tern/workspace.hpp"
#include "world/world_memory.hpp"

namespace tern {

/// The calls of a planner: their order, and what they share.
struct PlannerCalls {
  Clock clock;
  bool begun;     ///< until finish() or finish_route()
  bool is_route;  ///< begun by begin_route()
  Work slice;     ///< the work given to step(); a debt between two calls
};

/// The content of the workspace. The results of the stages outlive them. The stages' own states are never needed at the
/// same time, so they share memory.
struct Layout {
  PlannerCalls calls;
  Pipeline pipeline;
  Path path;
  ViaMemory vias;
  Corridor corridor;
  Trajectory trajectory;
  AroundMemory around;
  Ends ends;
  EndStop stops[2];  ///< the start's and the goal's
  Previous previous;
  AskedWorld asked;  ///< the request's fences, for the check
  AskedTracks tracks;
  WorldMemory world;
  union {
    SearchStage search;
    ReachStage reach;
    ShortcutStage shortcut;
    CorridorStage corridor;
    CurveMemory trajectory;
    CheckStage check;
    TimedFlood flood;
  } stage;
};

static_assert(alignof(Layout) <= kWorkspaceAlignment, "raise kWorkspaceAlignment");
static_assert(sizeof(Layout) + kWorkspaceAlignment <= kWorkspaceBytes,
              "define TERN_WORKSPACE_BYTES: the estimate in workspace.hpp falls short");

}  // namespace tern

#endif
