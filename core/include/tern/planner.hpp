// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_PLANNER_HPP
#define TERN_PLANNER_HPP

#include <cstddef>
#include <cstdint>

#include "tern/config.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/report.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"
#include "tern/workspace.hpp"

namespace tern {

struct Work;

/// A platform's monotonic tick counter; `context` is the caller's. Used for Report::stages[].ticks only: no result
/// depends on it.
using ClockFn = std::uint64_t (*)(void* context);

/// Grid and request in, checked trajectory out. The only facade; not thread-safe, but two planners over two
/// workspaces are independent. Holds no state outside the workspace and itself.
class Planner {
 public:
  /// `memory`: at least kWorkspaceBytes bytes, any alignment, any content; the caller's, must outlive the planner,
  /// which keeps there from plan to plan what it found out about the map: nobody else may write to it, another planner
  /// least. Too small or null is answered by the first call with kInvalidArgument (field kWorkspace).
  Planner(void* memory, std::size_t bytes) noexcept;

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
  /// Spends at most `work` units: a fence, an expansion, a sight line, a segment's polyhedron, an iteration, a detour
  /// or a segment's check each.
  Status step(std::uint32_t work) noexcept;
  /// Ends a plan, whatever its state: copies the trajectory out where step answered kOk, fills the report.
  Status finish(Trajectory& trajectory, Report& report) noexcept;

  /// The last plan's path and corridor, for displays and logs; null where that stage was not reached. Local frame of
  /// the grid. Valid until the next begin or plan.
  const Path* path() const noexcept;
  const Corridor* corridor() const noexcept;

 private:
  enum class Phase : std::uint8_t { kIdle, kFences, kPath, kCorridor, kTimes, kTrajectory, kDetour, kCheck, kDone };

  Status end(Stage stage, Status status) noexcept;
  Status refuse(Status status, Field field) noexcept;
  Status run_phase(Work& work) noexcept;
  Status accept_fences(const Request& request) noexcept;
  const Grid& world() const noexcept;
  Status run_fences(Work& work) noexcept;
  Status run_path(Work& work) noexcept;
  Status run_corridor(Work& work) noexcept;
  Status run_times() noexcept;
  Status run_trajectory(Work& work) noexcept;
  Status run_detour(Work& work) noexcept;
  Status run_check(Work& work) noexcept;
  Stage stage_of_phase() const noexcept;
  std::uint32_t attempts() const noexcept;
  void enter(Phase phase) noexcept;

  void* workspace_;  // aligned; null where the memory does not do
  const Grid* grid_ = nullptr;
  ClockFn clock_ = nullptr;
  void* clock_context_ = nullptr;
  GridVersion version_{};  // of the map that is planned on
  Phase phase_ = Phase::kIdle;
  bool has_fences_ = false;
  std::int32_t fences_blocked_ = 0;  // units of the fences' phase that are done
  std::uint32_t planes_before_ = 0;  // work of the stages before the detour
  std::uint32_t iterations_before_ = 0;
  bool has_path_ = false;
  bool has_corridor_ = false;
  Status status_ = Status::kInvalidArgument;
  Request local_{};  // the request in the grid's local frame
  Report report_{};
};

}  // namespace tern

#endif
