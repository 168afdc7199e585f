// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
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

/// A platform's monotonic tick counter; `context` is the caller's. Used for Report::stages[].ticks only: no result
/// depends on it.
using ClockFn = uint64_t (*)(void* context);

/// Grid and request in, checked trajectory out. The only facade; not thread-safe, but two planners over two
/// workspaces are independent. Holds no state outside the workspace and itself.
class Planner {
 public:
  /// `memory`: at least kWorkspaceBytes bytes, any alignment, any content; the caller's, must outlive the planner,
  /// which keeps there from plan to plan what it found out about the map: nobody else may write to it, another planner
  /// least. Too small or null is answered by the first call with kInvalidArgument (field kWorkspace).
  /// `configuration` is the caller's and stays away: where the caller's headers have other capacities than the library,
  /// every plan is refused with kInvalidArgument (field kConfiguration).
  Planner(void* memory, size_t bytes, uint64_t configuration = kConfigurationHash) noexcept;

  /// Ticks for the report. Null (the default) reports no times.
  void set_clock(ClockFn clock, void* context) noexcept;

  /// The next plan finds its map new, whatever it is. For measuring the first plan's time: it changes no result.
  void forget_map() noexcept;

  /// Plans in one call. kOk: `trajectory` holds the checked plan. Anything else: `trajectory` is untouched.
  /// `report` is always filled. The grid must be inflated.
  Status plan(const Grid& grid, const Request& request, Trajectory& trajectory, Report& report) noexcept;

  /// The same in slices, bit for bit: begin, then step until it is no longer kRunning, then finish. The grid must stay
  /// alive and unchanged between them (else kMapChanged). begin answers kRunning, or why the request is refused.
  Status begin(const Grid& grid, const Request& request) noexcept;
  /// Spends at most `work` units: a fence, an expansion, a sight line, a segment's polyhedron, a segment's duration, an
  /// iteration, a detour, a way to come to rest or a segment's check each.
  Status step(uint32_t work) noexcept;
  /// Ends a plan, whatever its state: copies the trajectory out where step answered kOk, fills the report.
  Status finish(Trajectory& trajectory, Report& report) noexcept;

  /// The last plan's path and corridor, for displays and logs; null where that stage was not reached. Local frame of
  /// the grid. Where the plan comes to rest first (Report::detours is 2) the path leads on from there, and the corridor
  /// begins with the polyhedra of the stop. Valid until the next begin or plan.
  const Path* path() const noexcept;
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
