// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PLANNER_LAYOUT_HPP
#define TERN_PLANNER_LAYOUT_HPP

#include "corridor/corridor_stage.hpp"
#include "path/reach_stage.hpp"
#include "path/search_stage.hpp"
#include "path/shortcut_stage.hpp"
#include "planner/escape.hpp"
#include "planner/plan.hpp"
#include "planner/previous.hpp"
#include "prove/check_stage.hpp"
#include "tern/via.hpp"
#include "tern/workspace.hpp"
#include "times/chain.hpp"
#include "times/times_stage.hpp"
#include "trajectory/trajectory_stage.hpp"
#include "world/world_memory.hpp"

namespace tern {

/// Both ends of the current flight. The states are relative to the requested start, which is, bit for bit, the origin
/// of the plan's frame. The other positions are in the grid's local frame, within its boundary.
struct FlightEnds {
  State start;
  State goal;
  Vec3 start_in_grid;
  Vec3 goal_in_grid;
  Vec3 origin_in_grid;  ///< of the plan's frame
};

/// The vias of the current plan.
struct Mission {
  Via vias[kMaxVias];            ///< as asked for, world frame
  ViaMarks marks;                ///< their waypoints on the path, and their polyhedra in the corridor without escapes
  Hold holds[kMaxVias];          ///< of the chain
  std::int32_t joint[kMaxVias];  ///< index of the trajectory's segment that begins at the via, or their count
  Path leg;                      ///< the path of the current leg
};

/// The times stage and the trajectory stage, with their input.
struct TrajectoryMemory {
  Corridor corridor;  ///< relative to the plan's origin
  TimesStage times;
  Chain chain;  ///< as the times stage made it
  TrajectoryStage stage;
};

/// The content of the workspace. The results of the stages outlive them, and so do the jump stops in `scans`. The
/// stages' own states are never needed at the same time, so they share memory.
struct Layout {
  Plan plan;
  Path path;
  Mission mission;
  Corridor corridor;
  Trajectory trajectory;
  FlightEnds ends;
  Escape escapes[2];  ///< the start's and the goal's
  Previous previous;
  AskedFences asked_fences;  ///< the fences as the caller gave them, for the check
  WorldMemory world;
  ScanMap scans;  ///< jump stops, which are kept for the next search
  union {
    SearchStage search;
    ReachStage reach;
    ShortcutStage shortcut;
    CorridorStage corridor;
    TrajectoryMemory trajectory;
    CheckStage check;
  } stage;
};

inline Layout& layout(void* workspace) noexcept {
  return *static_cast<Layout*>(workspace);
}

static_assert(alignof(Layout) <= kWorkspaceAlignment, "raise kWorkspaceAlignment");
static_assert(sizeof(Layout) + kWorkspaceAlignment <= kWorkspaceBytes,
              "define TERN_WORKSPACE_BYTES: the estimate in workspace.hpp falls short");

}  // namespace tern

#endif
