// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One plan in progress: the current stage, the request, and the report so far. It lies in the workspace, next to the
// memory of the stages.
#ifndef TERN_PLANNER_PLAN_HPP
#define TERN_PLANNER_PLAN_HPP

#include <cstdint>

#include "base/bounds.hpp"
#include "base/progress.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/planner.hpp"
#include "tern/report.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"
#include "times/pace.hpp"

namespace tern {

class World;
struct Layout;
struct Work;

/// The state of a plan between calls.
enum class Life : std::uint8_t {
  kIdle,   ///< no plan
  kBegun,  ///< in some stage
  kEnded,  ///< until finish()
};

/// The public calls are those of Planner.
class Plan {
 public:
  /// `memory` holds this plan and must outlive it.
  explicit Plan(Layout& memory) noexcept : memory_(&memory) {}

  void set_clock(ClockFn clock, void* context) noexcept;
  Status begin(const Grid& grid, const Request& request) noexcept;
  Status begin(const Grid& grid, const Request& request, const Trajectory& pace, double pace_time) noexcept;
  Status begin_route(const Grid& grid, const Request& request) noexcept;
  Status step(std::uint32_t work) noexcept;
  Status finish(Trajectory& trajectory, Report& report) noexcept;
  Status finish_route(Report& report) noexcept;
  Stage stage() const noexcept { return stage_; }
  /// What the plan took so far, in instructions (see Work); modulo 2^32.
  std::uint32_t effort() const noexcept { return effort_; }
  const Path* path() const noexcept;
  const Corridor* corridor() const noexcept;

 private:
  // plan.cpp: the calls.
  Status begin_query(const Grid& grid, const Request& request, bool route_only) noexcept;
  Status close(bool route_only, Report& report) noexcept;
  Status end(Stage stage, Status status) noexcept;
  Status refuse(Status status, Field field) noexcept;
  void place_ends() noexcept;
  void begin_attempt() noexcept;
  void give_up_goal() noexcept;
  Status accept_vias(const Request& request) noexcept;
  Status accept_fences(const Request& request) noexcept;
  bool keeps_fences(const Vec3& place) noexcept;
  World world() const noexcept;
  const Grid& voxels() const noexcept;

  // stages.cpp: the current stage.
  void enter(Stage stage) noexcept;
  Progress run_stage(Work& work) noexcept;
  Progress advance(Work& work) noexcept;

  // legs.cpp: the way through the vias.
  void begin_way() noexcept;
  std::int32_t via_count() const noexcept;
  Vec3 leg_from() const noexcept;
  Vec3 leg_to() const noexcept;
  Path& leg_path() noexcept;
  Status join_leg() noexcept;
  Status status_of_leg(Status status) const noexcept;
  std::int32_t via_at_fault(Stage stage) const noexcept;
  void make_holds() noexcept;
  void locate_vias() noexcept;
  bool add_dwells() noexcept;
  void report_vias() noexcept;

  // run_stages.cpp: runs a slice of each stage, and enters the next one. kMore if the slice is used up.
  Progress run_world(Work& work) noexcept;
  void begin_search() noexcept;
  Progress run_search(Work& work) noexcept;
  void note_narrowness() noexcept;
  void begin_shortcut() noexcept;
  Progress run_shortcut(Work& work) noexcept;
  bool search_again(Status why) noexcept;
  void begin_corridor() noexcept;
  Progress run_corridor(Work& work) noexcept;
  void fail_corridor(Status status) noexcept;
  Pace pace() const noexcept;
  void begin_times() noexcept;
  Progress run_times(Work& work) noexcept;
  void begin_trajectory() noexcept;
  Progress run_trajectory(Work& work) noexcept;
  void end_trajectory() noexcept;
  Progress run_check(Work& work) noexcept;
  void fall_back(Status why) noexcept;
  void report_trajectory() noexcept;
  void count(Stage stage, std::uint32_t work, std::uint32_t budget, std::uint32_t bound) noexcept;
  std::uint32_t before(Stage stage) const noexcept { return before_[static_cast<int>(stage)]; }
  std::uint32_t expansions_left() const noexcept;
  std::uint32_t sight_lines_left() const noexcept;
  std::uint32_t planes_left() const noexcept;

  // moving_ends.cpp: further attempts if an end is in motion.
  void fail(Stage stage, Status status) noexcept;
  Progress run_detour(Work& work) noexcept;
  bool escape_may_help(Stage stage, Status status) const noexcept;
  void begin_escape() noexcept;
  void count_escape() noexcept;
  void fly(Quality quality, std::int32_t detours) noexcept;
  Progress run_escape(Work& work) noexcept;
  Progress run_arrivals(Work& work) noexcept;
  Progress run_choices(int end, Work& work) noexcept;
  void rest_at_escapes() noexcept;
  State asked_end(int end) const noexcept;
  bool rests() const noexcept;
  std::uint32_t attempts() const noexcept;
  std::uint32_t searches() const noexcept;
  std::uint32_t legs_searched(std::uint32_t bound) const noexcept;
  std::uint32_t corridors() const noexcept;
  std::uint32_t checks() const noexcept;

  // run_previous.cpp: the rest of the previous plan. A new plan must arrive earlier than it.
  bool previous_may_help(Status status) const noexcept;
  void begin_previous() noexcept;
  Progress run_previous(Work& work) noexcept;
  Progress drop_previous(Status why) noexcept;
  void follow_previous() noexcept;
  void begin_with_rest() noexcept;
  Progress end_trial(bool holds) noexcept;
  bool prefers_rest() const noexcept;
  void return_to_rest() noexcept;
  Vec3 start_jerk() const noexcept;
  void begin_hulls() noexcept;

  // run_reach.cpp: the point nearest to a goal that cannot be planned to.
  void give_up() noexcept;
  void begin_reach() noexcept;
  Progress run_reach(Work& work) noexcept;
  Vec3 reachable_point(const Voxel& voxel) const noexcept;
  void plan_to_reachable() noexcept;

  Layout* memory_;
  const Grid* grid_ = nullptr;
  ClockFn clock_ = nullptr;
  void* clock_context_ = nullptr;
  GridVersion version_{};  // of the grid when the plan began
  Life life_ = Life::kIdle;
  bool route_only_ = false;  // the path is the result
  std::uint32_t effort_ = 0;
  Stage stage_ = Stage::kRequest;           // the current one
  std::int32_t narrow_fence_ = kNoFence;    // Report::fence if a point is too narrow
  std::int32_t leg_ = 0;                    // index of the leg being searched for: to via `leg_`, or to the goal
  bool given_at_rest_ = false;              // both ends of the request as given are at rest
  std::uint32_t before_[kStageCount] = {};  // work of each stage when the current one began
  std::uint32_t escapes_ = 0;               // escapes tried
  std::int32_t arrivals_ = 0;               // arrivals tried
  std::uint32_t searched_again_ = 0;        // 1 if the optimal search followed a fast path with too many segments
  bool stop_and_go_ = false;                // the optimiser's plan was refused
  Status refused_ = Status::kOk;            // why the optimiser's plan was refused
  Status undetoured_ = Status::kOk;         // why there is no trajectory without a detour
  Stage failed_stage_ = Stage::kRequest;
  Status failed_status_ = Status::kOk;
  bool tries_rest_ = false;        // the rest of the previous plan is being tried, before a new plan
  std::int32_t rest_try_ = 0;      // number of the try whose rest holds, 1 .. kPreviousTries; 0: none
  double rest_time_ = 0.0;         // duration of the rest that holds, s
  std::uint32_t rest_planes_ = 0;  // half-spaces that it takes to enclose the rest that holds
  bool has_pace_ = false;          // previous.plan is being flown
  double pace_from_ = 0.0;         // time at which previous.plan is at the requested start, s
  bool has_path_ = false;
  bool has_corridor_ = false;
  Status status_ = Status::kInvalidArgument;
  MotionLimits limits_{};  // the request's
  Request asked_{};        // the request as given, or to the reachable point; its fences, vias and previous plan are
                           // not read again
  Report report_{};
};

}  // namespace tern

#endif
