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
#include "tern/workspace.hpp"

namespace tern {

struct Work;

/// A monotonic tick counter of the platform. `context` is the pointer that was given to Planner::set_clock. The ticks
/// go into Report::stages and nowhere else: no plan depends on them.
using ClockFn = uint64_t (*)(void* context);

/// The planner. It works in memory that you give it and holds no state elsewhere. A planner is not thread-safe; two
/// planners over two workspaces are independent. Construct one and keep it: it remembers what it found out about a map,
/// and plans faster on the same map again. That changes no result.
///
/// Memory contract: the workspace, the grid and its storage, and everything that a call is given belong to the caller.
/// The workspace must live as long as the planner. A grid must live, at the same address, until finish() ends the plan
/// on it. Once a call has returned, the planner reads nothing of the request, trajectory or report that it was given.
class Planner {
 public:
  /// `memory` is the workspace: `bytes` bytes, at least kWorkspaceBytes, with any alignment and any content. Nobody
  /// else may write to it while the planner lives. Where it is null or too small, every plan answers kInvalidArgument,
  /// field kWorkspace.
  ///
  /// Leave `configuration` at its default. It tells the library which capacities your program was compiled with. Where
  /// they differ from the library's, every plan answers kInvalidArgument, field kConfiguration.
  Planner(void* memory, size_t bytes, uint64_t configuration = kConfigurationHash) noexcept;

  /// The clock for Report::stages[].ticks. Null, the default: no times are reported. `context` is the caller's and is
  /// passed to each call of `clock`. A clock that stands still or runs backwards does no harm.
  void set_clock(ClockFn clock, void* context) noexcept;

  /// Makes the planner forget what it found out about maps. It changes no result. Use it to measure how long the first
  /// plan on a map takes.
  void forget_map() noexcept;

  /// Plans in one call. The grid must be inflated. With kOk `trajectory` is the plan, which passed the check. With any
  /// other answer `trajectory` is as it was, so that you can go on flying what is in it. `report` is always filled.
  Status plan(const Grid& grid, const Request& request, Trajectory& trajectory, Report& report) noexcept;

  /// Begins a plan in slices: call begin() once, step() until it no longer answers kRunning, then finish(). The result
  /// has the same bits as plan(). begin() checks the request and reads it, its fences and its previous plan; they may
  /// change afterwards. It answers kRunning, or the reason why the request is refused.
  ///
  /// The grid must not change before finish(). Where it does, the next step() answers kMapChanged.
  Status begin(const Grid& grid, const Request& request) noexcept;
  /// Goes on with the plan for at most `work` units. kRunning: there is more to do. Any other answer is that of the
  /// plan: call finish(). kInvalidArgument where no plan was begun.
  ///
  /// One unit is one of these: a node expanded or a line that joins an end to the grid, a line of sight or a trial of
  /// tightening, a polyhedron, the duration of a
  /// segment, an iteration of a quadratic programme, its assembly or its judgement, a polyhedron or a
  /// segment checked, a fence, a detour, a way to come to rest, a segment of the previous plan.
  Status step(uint32_t work) noexcept;
  /// Ends the plan and fills `report`. With kOk it copies the plan to `trajectory`; with any other answer `trajectory`
  /// is as it was. Called before step() is done, it gives the plan up and answers kInvalidArgument, field kCallOrder.
  Status finish(Trajectory& trajectory, Report& report) noexcept;

  /// The path of the last plan, in the grid's local frame, for displays and logs. Null where the plan has none. Where
  /// the plan stops first (Report::detours is 2 or 3), the path begins at that stop. It lies in the workspace and is
  /// valid until the next begin() or plan().
  const Path* path() const noexcept;
  /// The corridor of the last plan, likewise. Segment::polyhedron is an index into it. Where the plan stops first, it
  /// begins with the polyhedra of that stop.
  const Corridor* corridor() const noexcept;

 private:
  enum class Phase : uint8_t {
    kIdle,
    kFences,
    kPath,
    kCorridor,
    kTimes,
    kTrajectory,
    kDetour,
    kPrevious,
    kEscape,
    kCheck,
    kDone
  };

  Status end(Stage stage, Status status) noexcept;
  Status refuse(Status status, Field field) noexcept;
  Status run_phase(Work& work) noexcept;
  void set_ends() noexcept;
  Status accept_fences(const Request& request) noexcept;
  const Grid& world() const noexcept;
  Status run_fences(Work& work) noexcept;
  Status run_path(Work& work) noexcept;
  Status run_corridor(Work& work) noexcept;
  void begin_times() noexcept;
  Status run_times(Work& work) noexcept;
  void begin_trajectory() noexcept;
  Status run_trajectory(Work& work) noexcept;
  Status run_detour(Work& work) noexcept;
  Status run_check(Work& work) noexcept;
  Stage stage_of_phase() const noexcept;
  Status run_escape(Work& work) noexcept;
  Status run_previous(Work& work) noexcept;
  void begin_previous() noexcept;
  void follow_previous() noexcept;
  Vec3 start_jerk() const noexcept;
  bool previous_may_help(Status status) const noexcept;
  void begin_hulls() noexcept;
  void count_planes(uint32_t planes) noexcept;
  Status fail(Stage stage, Status status) noexcept;
  Status fall_back(Status why) noexcept;
  void report_trajectory() noexcept;
  bool escape_may_help(Status status) const noexcept;
  void begin_escape() noexcept;
  bool arrives(Work& work) noexcept;
  void rest_at_escapes() noexcept;
  State asked_end(int end) const noexcept;
  bool rests() const noexcept;
  uint32_t searches() const noexcept;
  uint32_t corridors() const noexcept;
  uint32_t checks() const noexcept;
  uint32_t escape_planes() const noexcept;
  uint32_t before(Stage stage) const noexcept { return before_[static_cast<int>(stage)]; }
  void count(Stage stage, uint32_t work, uint32_t budget, uint32_t bound) noexcept;
  void enter(Phase phase) noexcept;

  void* workspace_;  // aligned; null where the memory or the configuration does not do
  bool same_configuration_;
  const Grid* grid_ = nullptr;
  ClockFn clock_ = nullptr;
  void* clock_context_ = nullptr;
  GridVersion version_{};  // of the map that is planned on
  Phase phase_ = Phase::kIdle;
  bool has_fences_ = false;
  int32_t fences_blocked_ = 0;         // units of the fences' phase that are done
  uint32_t before_[kStageCount] = {};  // work of each stage when the phase began
  uint32_t escapes_ = 0;               // tried
  int32_t arrivals_ = 0;               // tried
  bool stop_and_go_ = false;           // the optimiser's plan was refused,
  Status refused_ = Status::kOk;       // for this
  Stage failed_stage_ = Stage::kRequest;
  Status failed_status_ = Status::kOk;
  bool has_path_ = false;
  bool has_corridor_ = false;
  Status status_ = Status::kInvalidArgument;
  Request asked_{};  // as given; its fences are not read again
  Report report_{};
};

}  // namespace tern

#endif
