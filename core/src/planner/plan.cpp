// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/plan.hpp"

#include "base/math.hpp"
#include "base/too_narrow.hpp"
#include "base/work.hpp"
#include "grid/bit_rows.hpp"
#include "planner/layout.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// Instructions of a turn of step(), besides what the stage counts.
constexpr std::uint32_t kTurnEffort = 250;
/// Instructions of begin() and finish() together, and of each fence that is read.
constexpr std::uint32_t kBeginEffort = 12000;
constexpr std::uint32_t kFenceEffort = 40000;

/// A clock that stood still or moved backwards has measured nothing. No ticks are better than wrong ones.
void settle_times(Report& report) {
  std::uint64_t sum = 0;
  for (const StageReport& stage : report.diagnostics.stages) sum |= stage.ticks;
  report.diagnostics.timing_known = report.diagnostics.timing_known && sum != 0;
  if (report.diagnostics.timing_known) return;
  for (StageReport& stage : report.diagnostics.stages) stage.ticks = 0;
}

}  // namespace

void Plan::set_clock(ClockFn clock, void* context) noexcept {
  clock_ = clock;
  clock_context_ = context;
}

Status Plan::refuse(Status status, Field field) noexcept {
  report_.field = field;
  return end(Stage::kRequest, status);
}

Status Plan::end(Stage stage, Status status) noexcept {
  life_ = Life::kEnded;
  status_ = status;
  report_.stage = stage;
  const bool narrow = is_too_narrow(status);
  const bool occupied =
      status == Status::kStartOccupied || status == Status::kGoalOccupied || status == Status::kViaOccupied;
  if (!occupied && !narrow) report_.raw_occupied = report_.has_nearest_free = false;
  if (!narrow) report_.finer_cell = 0.0;
  if (narrow) report_.fence = narrow_fence_;
  if (status != Status::kCheckFailed && report_.optimiser != Status::kCheckFailed) report_.check = ProofReport{};
  if (status != Status::kOk) report_.quality = Quality::kNone;
  if (status == Status::kOk) report_.via = kNoVia;
  return status;
}

World Plan::world() const noexcept {
  return world_of(memory_->world);
}

const Grid& Plan::voxels() const noexcept {
  return world().voxels();
}

/// Notes that the goal cannot be planned to. What remains is the nearest point that can be reached.
void Plan::give_up_goal() noexcept {
  if (asked_.goal_mode == GoalMode::kExact) report_.field = Field::kGoalPosition;
  failed_stage_ = Stage::kRequest;
  failed_status_ = Status::kGoalFenced;
  leg_ = via_count();
}

/// Reads the vias; kRunning if all are valid.
Status Plan::accept_vias(const Request& request) noexcept {
  Mission& mission = memory_->mission;
  mission.marks.count = 0;
  const Verdict verdict = validate_vias(*grid_, request, limits_, report_.via);
  if (verdict.status != Status::kOk) return refuse(verdict.status, verdict.field);
  mission.marks.count = request.via_count;
  for (std::int32_t v = 0; v < request.via_count; ++v) mission.vias[v] = request.vias[v];
  return Status::kRunning;
}

/// Checks a place (local frame) against the fences. If it breaks one, the report names that fence.
bool Plan::keeps_fences(const Vec3& place) noexcept {
  report_.fence = world().first_broken(place, place);
  return report_.fence == kNoFence;
}

/// Reads the fences and checks start, vias and goal against them; kRunning unless the request is refused.
Status Plan::accept_fences(const Request& request) noexcept {
  if (request.fence_count == 0) return Status::kRunning;
  Layout& memory = *memory_;
  const FenceFault fault = world_add(memory.world, request.fences, request.fence_count);
  report_.fence = fault.fence;
  if (fault.status != Status::kOk) return refuse(fault.status, Field::kFences);
  if (!copy_fences(request.fences, request.fence_count, memory.asked_fences)) {
    return refuse(Status::kFencePlanesFull, Field::kFences);
  }
  if (!keeps_fences(memory.ends.start_in_grid)) return refuse(Status::kStartFenced, Field::kStartPosition);
  for (std::int32_t v = 0; v < via_count(); ++v) {
    if (keeps_fences(to_local(*grid_, memory.mission.vias[v].position))) continue;
    report_.via = v;
    return refuse(Status::kViaFenced, Field::kVias);
  }
  if (!keeps_fences(memory.ends.goal_in_grid)) give_up_goal();
  effort_ += static_cast<std::uint32_t>(2 * GridView::layer_words(*grid_));
  const Status prepared = world_prepare(memory.world);
  if (prepared == Status::kOk) {
    place_ends();
    return Status::kRunning;
  }
  if (report_.field == Field::kGoalPosition) return refuse(Status::kGoalFenced, Field::kGoalPosition);
  return refuse(prepared, Field::kFences);
}

/// Puts both ends of the request into the grid.
void Plan::place_ends() noexcept {
  const Request local = to_local(voxels(), asked_);
  FlightEnds& ends = memory_->ends;
  ends.start_in_grid = local.start.position;
  ends.goal_in_grid = local.goal.position;
  ends.origin_in_grid = local.start.position;
}

/// Resets what belongs to one attempt. The plan's frame has its origin in the start, in world coordinates as they were
/// given.
void Plan::begin_attempt() noexcept {
  has_path_ = false;
  has_corridor_ = false;
  escapes_ = 0;
  arrivals_ = 0;
  stop_and_go_ = false;
  failed_status_ = Status::kOk;
  report_.diagnostics.detours = 0;
  place_ends();
  FlightEnds& ends = memory_->ends;
  ends.start = asked_.start;
  ends.goal = asked_.goal;
  ends.start.position = {0.0, 0.0, 0.0};
  ends.goal.position = asked_.goal.position - asked_.start.position;
  for (Escape& escape : memory_->escapes) {
    escape.next = escape.count = 0;
    escape.trying = false;
  }
  cut_previous(*grid_, asked_, memory_->previous);
  tries_rest_ = false;
}

Status Plan::begin(const Grid& grid, const Request& request) noexcept {
  return begin_query(grid, request, false);
}

Status Plan::begin(const Grid& grid, const Request& request, const Trajectory& pace, double pace_time) noexcept {
  const Status status = begin_query(grid, request, false);
  if (status != Status::kRunning) return status;
  const bool valid = request.previous == nullptr && is_trajectory(pace) && finite(pace_time) && pace_time >= 0.0;
  if (!valid) return refuse(Status::kInvalidArgument, Field::kPrevious);
  memory_->previous.plan = pace;
  has_pace_ = true;
  pace_from_ = pace_time;
  return status;
}

/// A route has no trajectory, so the motion of its ends does not matter.
Status Plan::begin_route(const Grid& grid, const Request& request) noexcept {
  Request still = request;
  still.start = {request.start.position, kZero, kZero};
  still.goal = {request.goal.position, kZero, kZero};
  still.previous = nullptr;
  return begin_query(grid, still, true);
}

Status Plan::begin_query(const Grid& grid, const Request& request, bool route_only) noexcept {
  route_only_ = route_only;
  report_ = Report{};
  report_.diagnostics.timing_known = clock_ != nullptr;
  has_path_ = false;
  has_corridor_ = false;
  searched_again_ = 0;
  grid_ = &grid;
  world_begin(memory_->world, grid);
  effort_ = kBeginEffort + static_cast<std::uint32_t>(request.fence_count > 0 ? request.fence_count : 0) * kFenceEffort;
  if (!grid.inflated()) return refuse(Status::kInvalidArgument, grid.bound() ? Field::kNotInflated : Field::kStorage);
  const Verdict verdict = validate(grid, request, limits_);
  if (verdict.status != Status::kOk) return refuse(verdict.status, verdict.field);
  const Status vias = accept_vias(request);
  if (vias != Status::kRunning) return vias;
  asked_ = request;
  has_pace_ = request.previous != nullptr;
  pace_from_ = request.previous_time;
  given_at_rest_ = rests();
  begin_attempt();
  const Status fences = accept_fences(request);
  if (fences != Status::kRunning) return fences;
  version_ = grid.version();
  status_ = Status::kRunning;
  life_ = Life::kBegun;
  if (memory_->world.has_solids) {
    enter(Stage::kFences);
  } else {
    begin_with_rest();
  }
  return status_;
}

Status Plan::step(std::uint32_t work) noexcept {
  if (life_ == Life::kIdle) return Status::kInvalidArgument;
  Work slice{work};
  // Each stage uses up the slice, ends the plan, or enters the next stage. Some run again after a detour or an escape.
  while (life_ == Life::kBegun) {
    if (!grid_->version().equals(version_)) return end(stage_, Status::kMapChanged);
    slice.effort = kTurnEffort;
    const Progress progress = advance(slice);
    effort_ += slice.effort;
    if (progress == Progress::kMore) return Status::kRunning;
  }
  return status_;
}

Status Plan::finish(Trajectory& trajectory, Report& report) noexcept {
  const Status status = close(false, report);
  if (status == Status::kOk) {
    trajectory = memory_->trajectory;
    trajectory.begin = asked_.begin;
  }
  return status;
}

Status Plan::finish_route(Report& report) noexcept {
  return close(true, report);
}

/// Ends what was begun. `route_only` says which of the two calls asks for it.
Status Plan::close(bool route_only, Report& report) noexcept {
  if (life_ != Life::kEnded || route_only != route_only_) {
    if (life_ == Life::kIdle) report_ = Report{};
    status_ = Status::kInvalidArgument;
    report_.field = Field::kCallOrder;
    report_.check = ProofReport{};
  }
  life_ = Life::kIdle;
  report_.status = status_;
  settle_times(report_);
  report = report_;
  return status_;
}

const Path* Plan::path() const noexcept {
  return has_path_ ? &memory_->path : nullptr;
}

const Corridor* Plan::corridor() const noexcept {
  return has_corridor_ ? &memory_->corridor : nullptr;
}

}  // namespace tern
