// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner: a grid and a request in, a checked trajectory out. docs/architecture.md shows how.
#ifndef TERN_PLANNER_HPP
#define TERN_PLANNER_HPP

#include <stddef.h>
#include <stdint.h>

#include "tern/config.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/report.hpp"
#include "tern/request.hpp"
#include "tern/self_test.hpp"
#include "tern/trajectory.hpp"
#include "tern/work.hpp"
#include "tern/workspace.hpp"

namespace tern {

struct Layout;
struct PlanMode;

/// A monotonic tick counter of the platform. `context` is the pointer that you passed to Planner::set_clock. The ticks
/// go into Diagnostics::stages and nowhere else: no plan depends on them.
using ClockFn = uint64_t (*)(void* context);

/// The planner. It works in memory that you give it and holds no state elsewhere. A planner is not thread-safe; two
/// planners over two workspaces are independent. Construct one and keep it: it remembers what it learned about a map,
/// so later plans on the same map are faster. That changes no result.
///
/// Memory contract: the caller owns the workspace, the grid and its storage, and everything that it passes to a call.
/// The workspace must live as long as the planner. A grid must live, at the same address, until finish() ends the plan
/// on it. Once a call has returned, the planner no longer reads the request, trajectory or report that it was given.
class Planner {
 public:
  /// `memory` is the workspace: `bytes` bytes, at least kWorkspaceBytes, with any alignment and any content. Nobody
  /// else may write to it while the planner lives. If it is null or too small, every plan answers kInvalidArgument,
  /// field kWorkspace.
  ///
  /// Leave `configuration` at its default. It tells the library which capacities your program was compiled with. If
  /// they differ from the library's, every plan answers kInvalidArgument, field kConfiguration.
  Planner(void* memory, size_t bytes, uint64_t configuration = kConfigurationHash) noexcept;

  /// The clock for Diagnostics::stages[].ticks. With null, the default, no times are reported. Each call of `clock`
  /// gets `context`, which belongs to the caller. A clock that stands still or runs backwards does no harm.
  void set_clock(ClockFn clock, void* context) noexcept;

  /// Plans in one call. The grid must be inflated. With kOk, `trajectory` is the plan, which passed the check. With any
  /// other answer, `trajectory` is unchanged, so you can go on flying the plan in it. `report` is always filled in.
  Status plan(const Grid& grid, const Request& request, Trajectory& trajectory, Report& report) noexcept;

  /// Begins a plan in slices: call begin() once, step() until it no longer answers kRunning, then finish(). The result
  /// has the same bits as plan(). begin() checks the request and reads it, its fences and its previous plan; they may
  /// change afterwards. It answers kRunning, or the reason why it refuses the request.
  ///
  /// The grid must not change before finish(). If it does, the next step() answers kMapChanged.
  Status begin(const Grid& grid, const Request& request) noexcept;
  /// As begin(), for a request without a previous plan. As far as `pace` leads nearly the same way, the optimiser
  /// begins at its durations. This saves work, and gives another plan than without it. `pace` is a plan that passes the
  /// requested start `pace_time` seconds after its beginning; it is read at once and never followed. Answers
  /// kInvalidArgument, field kPrevious, if there is a previous plan, `pace` is no trajectory, or `pace_time` is
  /// negative or not finite.
  ///
  /// `must_beat` says that `pace` leads to the requested goal, and that you follow what is left of it unless there is a
  /// better plan. If the way leads near it, the optimiser then looks only for a plan of less cost (docs/trajectory.md,
  /// "Duration search"), and the answer is kNoTrajectory if it finds none. That takes less work than a plan that you
  /// would not follow. If a via of the request has a dwell, `must_beat` changes nothing.
  Status begin(const Grid& grid, const Request& request, const Trajectory& pace, double pace_time,
               bool must_beat = false) noexcept;
  /// Continues the plan as long as work is left. kRunning: there is more to do. Any other answer is the answer of the
  /// plan: call finish(). kInvalidArgument if no plan was begun.
  ///
  /// A piece of work is, for example, a node expanded, a line of sight, a step of a polyhedron, or an iteration of a
  /// quadratic programme. A call takes at most one piece more than is left.
  Status step(Work& work) noexcept;
  /// The same with `work` more units. What a call takes beyond them, the next calls take less. So step(n) takes about
  /// n thousand instructions in the mean, whatever the plan is doing.
  Status step(uint32_t work) noexcept;
  /// Ends the plan and fills in `report`. With kOk, it copies the plan to `trajectory`; with any other answer,
  /// `trajectory` is unchanged. If you call it before step() is done, it abandons the plan and answers
  /// kInvalidArgument, field kCallOrder.
  Status finish(Trajectory& trajectory, Report& report) noexcept;

  /// Finds a path alone, in one call: the path() of a plan that begins and ends at rest. It takes a small part of a
  /// plan's work. Of the request, it reads positions, fences, vias, goal mode, search mode and budget. The limits must
  /// be valid, but like motion and dwells they change nothing; the previous plan is ignored. With kOk, path() is the
  /// path. `report` is always filled in. Its quality is kNone, and its last stage is kShortcut.
  Status route(const Grid& grid, const Request& request, Report& report) noexcept;
  /// Begins to find a path in slices: call begin_route() once, step() until it no longer answers kRunning, then
  /// finish_route(). The path has the same bits as that of route(). Answers and duties are those of begin().
  Status begin_route(const Grid& grid, const Request& request) noexcept;
  /// Ends the route and fills in `report`. If you call it before step() is done, or after begin() instead of
  /// begin_route(), it abandons what was begun and answers kInvalidArgument, field kCallOrder. So does finish() after
  /// begin_route().
  Status finish_route(Report& report) noexcept;

  /// The stage that the next piece of work belongs to, or the last one of a plan that is done. kRequest if no plan was
  /// begun.
  Stage stage() const noexcept;

  /// The path of the last plan or route, in the grid's local frame. Null if it has none. If the plan stops first
  /// (Diagnostics::detours is 2 or 3), the path begins at that stop. It lies in the workspace and is valid until the
  /// next plan or route begins.
  const Path* path() const noexcept;
  /// The corridor of the last plan, along path(): frame, lifetime and null as there. Segment::polyhedron is an index
  /// into it, or kNoPolyhedron. An arrival or the rest of a previous plan has neither path nor corridor.
  const Corridor* corridor() const noexcept;

 private:
  friend class FarWay;

  /// As begin_route() for a request without vias, but the path ends with the search: it has no waypoints, and as many
  /// turns as Path::raw holds.
  Status begin_way(const Grid& grid, const Request& request) noexcept;
  Status begin_query(const Grid& grid, const Request& request, const PlanMode& mode) noexcept;
  Status close(bool is_route, Report& report) noexcept;
  Status refuse(Report& report) noexcept;

  Layout* memory_;  // the workspace, aligned; null if the memory or the configuration is refused
  bool same_configuration_;
  bool refused_ = false;  // a plan was begun without a workspace
};

}  // namespace tern

#endif
