// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How a plan is made: straight through the stages, and what follows if one fails. Each stage and each attempt is a
// structure with a begin and an advance, which get what they may touch as arguments; only enter() and run() hand it
// out, one line a stage. Only go_on() and what it calls decide what comes next.
#ifndef TERN_PLANNER_PIPELINE_HPP
#define TERN_PLANNER_PIPELINE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "planner/attempts.hpp"
#include "planner/curves.hpp"
#include "planner/ledger.hpp"
#include "planner/legs.hpp"
#include "planner/problem.hpp"
#include "prove/check_stage.hpp"
#include "tern/report.hpp"
#include "tern/status.hpp"
#include "tern/trajectory.hpp"

namespace tern {

struct Layout;

/// Which results are in memory.
struct Results {
  bool path;
  bool corridor;
};

/// What is asked for.
enum class Asked : std::uint8_t {
  kPlan,
  kRoute,  ///< the path
  kWay,    ///< the raw path, without vias
};

/// How a request is to be planned.
struct PlanMode {
  Asked wanted = Asked::kPlan;
  const Trajectory* pace = nullptr;  ///< a plan that sets the pace, for a request without a previous plan; null: none
  double pace_time = 0.0;            ///< when that plan passes the start, s since its beginning
  bool must_beat = false;            ///< only a plan that is better than what is left of it is of use
};

class Pipeline {
 public:
  /// `memory` must outlive the pipeline.
  explicit Pipeline(Layout& memory) noexcept : memory_(&memory) {}

  /// Reads the request. kRunning, or why it is refused.
  Status begin(const Grid& grid, const Request& request, const PlanMode& mode, const Clock& clock) noexcept;
  /// Runs a slice of the current stage, and at its end enters what follows. Only while status() is kRunning. Ends the
  /// plan if the grid has changed.
  Progress advance(Work& work) noexcept;
  /// Ends the plan because the request or a call is wrong.
  Status refuse(const RequestFault& fault) noexcept;

  /// kRunning, or how the plan has ended.
  Status status() const noexcept { return status_; }
  Stage stage() const noexcept { return stage_; }
  const Results& results() const noexcept { return results_; }
  /// The whole report, from what each part noted.
  void write(Report& report) const noexcept;

 private:
  // pipeline.cpp: the stages.
  Status read(const Request& request, const PlanMode& mode) noexcept;
  void enter(Stage stage) noexcept;
  Progress run(Work& work) noexcept;
  Progress look_for_time(Work& work) noexcept;
  Progress end_for_budget(Work& work) noexcept;
  Progress end_tracks_for_budget() noexcept;
  Status end(Stage stage, Status status) noexcept;

  // order.cpp: what follows a stage.
  void begin_goal() noexcept;
  void begin_attempts() noexcept;
  void begin_way() noexcept;
  void go_on(bool done) noexcept;
  void go_on_from_search(bool done) noexcept;
  void go_on_from_shortcut(bool done) noexcept;
  void go_on_from_corridor(bool done) noexcept;
  void go_on_from_trajectory(bool done) noexcept;
  void go_on_from_check(bool done) noexcept;
  void take_plan() noexcept;
  void note_rest() noexcept;
  void end_plan() noexcept;
  void go_on_from_previous(bool done) noexcept;
  void go_on_from_stop(bool done) noexcept;
  void go_on_from_nearest(bool done) noexcept;
  void meet_track() noexcept;
  void go_on_from_tracks(bool done) noexcept;
  void end_trial(bool proven) noexcept;
  void check_as_is(Quality quality, Attempt attempt) noexcept;
  void stop_at_waypoints(Status why) noexcept;
  void fail(Stage stage, Status status) noexcept;
  void give_up() noexcept;

  // around_order.cpp: what follows a stage while a plan around things is made.
  void begin_around() noexcept;
  void go_on_around(bool done) noexcept;
  void judge_around(bool is_clear) noexcept;
  void keep_found() noexcept;
  void take_found() noexcept;
  void take_alone() noexcept;
  void begin_wait() noexcept;
  void end_wait(bool may_wait) noexcept;
  void next_seed() noexcept;
  void end_around() noexcept;

  // closed_order.cpp: what follows a stage while a plan is led around closed fences.
  bool begin_closed(std::int32_t fence, std::int32_t track) noexcept;
  bool close(std::int32_t fence, std::int32_t track) noexcept;
  void close_all() noexcept;
  void go_on_closed(bool done) noexcept;
  void judge_closed(bool is_clear) noexcept;
  void end_closed() noexcept;

  Operations kept_for_seeds() const noexcept;

  /// What is made leads around things, along a way from the flood in time or from a seed.
  bool is_around() const noexcept { return attempts_.around.is_active && !attempts_.around.is_closed; }
  /// The trajectory in memory is the previous plan.
  bool follows() const noexcept { return quality_ == Quality::kPrevious; }
  /// When the plan enters the trajectory in memory, s since its beginning.
  double entered() const noexcept { return follows() ? problem_.asked.previous_time : 0.0; }

  Layout* memory_;
  Asked wanted_ = Asked::kPlan;
  Problem problem_{};
  RequestFault fault_{};
  Stage stage_ = Stage::kRequest;             // the current one
  Status status_ = Status::kInvalidArgument;  // kRunning until the plan ends
  Stage ended_in_ = Stage::kRequest;
  Failure failure_{};
  Attempts attempts_{};
  Legs legs_{};
  Rooms rooms_{};
  Curves curves_{};
  Conflict conflict_{};  // what the first plan met
  GoalFree goal_free_{};
  std::int32_t left_ = kNoTrack;  // the first track that the plan begins too near to
  double rest_until_ = __builtin_inf();
  ProofReport refused_{};             // why the check refused the last plan that it refused
  Quality quality_ = Quality::kNone;  // of the trajectory in memory
  Status optimiser_ = Status::kOk;    // how optimising that trajectory ended
  Results results_{};
  std::int32_t flood_words_ = 0;  // of the largest flood in time
  bool segments_full_ = false;    // an attempt had too many segments
  bool reopens_ = false;          // the stage `world` takes the closed fences out again
  Operations begun_ = 0;          // what beginnings took, and no slice has paid yet
  Ledger ledger_{};
};

}  // namespace tern

#endif
