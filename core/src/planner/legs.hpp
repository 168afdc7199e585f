// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The way through the vias. Each leg, from a via to the next, is searched for and shortened by itself; the legs make
// one path.
#ifndef TERN_PLANNER_LEGS_HPP
#define TERN_PLANNER_LEGS_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "corridor/corridor_stage.hpp"
#include "path/search_stage.hpp"
#include "path/shortcut_stage.hpp"
#include "planner/problem.hpp"
#include "tern/path.hpp"
#include "tern/report.hpp"
#include "tern/status.hpp"

namespace tern {

/// Why an end of a leg joins no free voxel, for the report.
struct EndFault {
  bool raw_occupied;
  bool has_nearest_free;
  Vec3 nearest_free;   ///< world frame
  double finer_cell;   ///< a resolution at which an end that is too narrow would have a voxel; 0: none
  std::int32_t solid;  ///< the solid or wall that blocks such an end's voxel, if obstacles leave it free; else kNoSolid
};

/// How the way is made. A way that needs more segments than fit is made anew by the next choice.
enum class WayChoice : std::uint8_t {
  kAsked,     ///< by the search that the request asks for
  kCheapest,  ///< by the optimal search: a cheapest path often needs fewer segments
  kFewLegs,   ///< by the optimal search, and merging waypoints (path/merge.hpp)
};

struct Legs {
  std::int32_t leg;  ///< the current one, which leads to the via of this index, or to the goal
  WayChoice choice;
  Status status;     ///< why the search or the shortcut failed, as a status of the plan; else kOk
  std::int32_t via;  ///< the via that the leg could not leave, or leads to; kNoVia: start or goal
  EndFault fault;
  // Figures for the report.
  std::int32_t nodes_high;
  std::int32_t open_high;
  std::int32_t jump_points_high;
  std::int32_t segments_high;
  SearchUsed search_used;
  double search_bound;
};

/// The path's memory.
struct WayMemory {
  Path& path;  ///< of the whole way
  Path& leg;   ///< of the current leg, if there are vias; without vias, the path's only leg is the path
  ViaMarks& marks;
};

/// Begins the way anew, at its first leg.
void legs_begin(const Problem& problem, Legs& legs, Path& path) noexcept;
/// True if the current leg leads to the goal.
bool is_last_leg(const Problem& problem, const Legs& legs) noexcept;
/// The via or the requested goal that the current leg leads to, local frame. The leg may end before the goal, if the
/// plan is to come to rest before a goal in motion.
Vec3 leg_target(const Problem& problem, const Legs& legs) noexcept;

/// Searches for the current leg. leg_search_begin() returns the operations that it took. If the search fails,
/// legs.status, via and fault say why.
Operations leg_search_begin(const Problem& problem, const Ends& ends, const Legs& legs, SearchStage& stage) noexcept;
Progress leg_search_advance(const Problem& problem, SearchStage& stage, Legs& legs, WayMemory way, Work& work) noexcept;
/// Ends the search because its budget is spent.
void leg_search_stop(const Problem& problem, SearchStage& stage, Legs& legs) noexcept;

/// Shortens the current leg and appends it to the path. If that fails, legs.status and via say why.
void leg_shortcut_begin(const Problem& problem, const Legs& legs, WayMemory way, ShortcutStage& stage) noexcept;
Progress leg_shortcut_advance(const Problem& problem, ShortcutStage& stage, Legs& legs, WayMemory way,
                              Work& work) noexcept;

/// True if the way should be made anew by the next choice, because it needs more segments than fit.
bool choose_again(Status why, Legs& legs) noexcept;

}  // namespace tern

#endif
