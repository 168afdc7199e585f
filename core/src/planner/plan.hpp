// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One plan on its way through the stages: which phase it is in, what was asked, and what the report says so far. It
// lies in the workspace, beside the stages' memory.
#ifndef TERN_PLANNER_PLAN_HPP
#define TERN_PLANNER_PLAN_HPP

#include <cstdint>

#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/planner.hpp"
#include "tern/report.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"

namespace tern {

struct Layout;
struct Work;

/// What a plan does next. Most phases are stages (tern/status.hpp); the others are ways on where a stage failed.
enum class Phase : std::uint8_t {
  kIdle,    ///< no plan
  kFences,  ///< fences taken from the free voxels
  kPath,    ///< search and shortcut
  kCorridor,
  kTimes,
  kTrajectory,
  kDetour,    ///< the path leads along the ends' motion first (detour.hpp)
  kPrevious,  ///< the rest of the previous plan (previous.hpp)
  kEscape,    ///< to rest first (escape.hpp)
  kCheck,
  kDone,  ///< until finish()
};

/// The calls are those of Planner.
class Plan {
 public:
  /// `memory` holds this plan and must outlive it.
  explicit Plan(Layout& memory) noexcept : memory_(&memory) {}

  void set_clock(ClockFn clock, void* context) noexcept;
  Status begin(const Grid& grid, const Request& request) noexcept;
  Status step(std::uint32_t work) noexcept;
  Status finish(Trajectory& trajectory, Report& report) noexcept;
  const Path* path() const noexcept;
  const Corridor* corridor() const noexcept;

 private:
  // plan.cpp: the calls.
  Status end(Stage stage, Status status) noexcept;
  Status refuse(Status status, Field field) noexcept;
  void set_ends() noexcept;
  Status accept_fences(const Request& request) noexcept;
  const Grid& world() const noexcept;

  // phases.cpp: which phase follows which.
  Stage stage_of_phase() const noexcept;
  void enter(Phase phase) noexcept;
  Status run_phase(Work& work) noexcept;

  // stage_phases.cpp: a slice of each stage.
  Status run_fences(Work& work) noexcept;
  Status run_path(Work& work) noexcept;
  Status run_corridor(Work& work) noexcept;
  void begin_times() noexcept;
  Status run_times(Work& work) noexcept;
  void begin_trajectory() noexcept;
  Status run_trajectory(Work& work) noexcept;
  Status run_check(Work& work) noexcept;
  Status fall_back(Status why) noexcept;
  void report_trajectory() noexcept;
  void count(Stage stage, std::uint32_t work, std::uint32_t budget, std::uint32_t bound) noexcept;
  std::uint32_t before(Stage stage) const noexcept { return before_[static_cast<int>(stage)]; }

  // moving_ends.cpp: ways on where an end moves.
  Status fail(Stage stage, Status status) noexcept;
  Status run_detour(Work& work) noexcept;
  bool escape_may_help(Status status) const noexcept;
  void begin_escape() noexcept;
  Status run_escape(Work& work) noexcept;
  bool arrives(Work& work) noexcept;
  void rest_at_escapes() noexcept;
  State asked_end(int end) const noexcept;
  bool rests() const noexcept;
  std::uint32_t searches() const noexcept;
  std::uint32_t corridors() const noexcept;
  std::uint32_t checks() const noexcept;
  std::uint32_t escape_planes() const noexcept;

  // previous_phase.cpp: the rest of the previous plan.
  bool previous_may_help(Status status) const noexcept;
  void begin_previous() noexcept;
  Status run_previous(Work& work) noexcept;
  void follow_previous() noexcept;
  Vec3 start_jerk() const noexcept;
  void begin_hulls() noexcept;
  void count_planes(std::uint32_t planes) noexcept;

  Layout* memory_;
  const Grid* grid_ = nullptr;
  ClockFn clock_ = nullptr;
  void* clock_context_ = nullptr;
  GridVersion version_{};  // of the map that is planned on
  Phase phase_ = Phase::kIdle;
  bool has_fences_ = false;
  std::int32_t fences_blocked_ = 0;         // units of the fences' phase that are done
  std::uint32_t before_[kStageCount] = {};  // work of each stage when the phase began
  std::uint32_t escapes_ = 0;               // tried
  std::int32_t arrivals_ = 0;               // tried
  bool stop_and_go_ = false;                // the optimiser's plan was refused,
  Status refused_ = Status::kOk;            // for this
  Stage failed_stage_ = Stage::kRequest;
  Status failed_status_ = Status::kOk;
  bool has_path_ = false;
  bool has_corridor_ = false;
  Status status_ = Status::kInvalidArgument;
  Request asked_{};  // as given; its fences and its previous plan are not read again
  Report report_{};
};

}  // namespace tern

#endif
