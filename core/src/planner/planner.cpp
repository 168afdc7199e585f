// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/planner.hpp"

#include <cstddef>

#include "base/math.hpp"
#include "base/work.hpp"
#include "planner/layout.hpp"
#include "planner/validate.hpp"

namespace tern {
namespace {

/// The first aligned byte of the caller's memory; null where it does not hold a workspace.
void* align(void* memory, std::size_t bytes) {
  if (memory == nullptr || bytes < kWorkspaceBytes) return nullptr;
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t aligned = (address + kWorkspaceAlignment - 1) & ~(std::uintptr_t{kWorkspaceAlignment} - 1);
  return static_cast<unsigned char*>(memory) + (aligned - address);
}

/// A clock that never moved, or moved backwards, measured nothing: no ticks are better than wrong ones.
void settle_times(Report& report) {
  std::uint64_t sum = 0;
  for (const StageReport& stage : report.stages) sum |= stage.ticks;
  report.timing_known = report.timing_known && sum != 0;
  if (report.timing_known) return;
  for (StageReport& stage : report.stages) stage.ticks = 0;
}

/// One call of plan() steps at most this often; each step may spend 2^32 - 1 units and every stage is bounded far
/// below.
constexpr int kMaxSteps = 16;

}  // namespace

Planner::Planner(void* memory, std::size_t bytes, std::uint64_t configuration) noexcept
    : workspace_(configuration == kConfigurationHash ? align(memory, bytes) : nullptr),
      same_configuration_(configuration == kConfigurationHash) {
  forget_map();
}

void Planner::forget_map() noexcept {
  if (workspace_ != nullptr) scan_forget(static_cast<Layout*>(workspace_)->scans);
}

void Planner::set_clock(ClockFn clock, void* context) noexcept {
  clock_ = clock;
  clock_context_ = context;
}

Status Planner::plan(const Grid& grid, const Request& request, Trajectory& trajectory, Report& report) noexcept {
  Status status = begin(grid, request);
  for (int i = 0; i < kMaxSteps && status == Status::kRunning; ++i) status = step(0xFFFFFFFFu);
  return finish(trajectory, report);
}

Status Planner::refuse(Status status, Field field) noexcept {
  report_.field = field;
  return end(Stage::kRequest, status);
}

Status Planner::end(Stage stage, Status status) noexcept {
  phase_ = Phase::kDone;
  status_ = status;
  report_.stage = stage;
  const bool occupied = status == Status::kStartOccupied || status == Status::kGoalOccupied;
  if (!occupied) report_.raw_occupied = report_.has_nearest_free = false;
  if (status != Status::kOk) report_.quality = Quality::kNone;
  return status;
}

const Grid& Planner::world() const noexcept {
  return has_fences_ ? static_cast<const Layout*>(workspace_)->fenced : *grid_;
}

/// Reads the fences and holds start and goal against them; kRunning where all is well.
Status Planner::accept_fences(const Request& request) noexcept {
  has_fences_ = request.fence_count != 0;
  fences_blocked_ = 0;
  if (!has_fences_) return Status::kRunning;
  Layout& memory = *static_cast<Layout*>(workspace_);
  const Status loaded = load_fences(*grid_, request.fences, request.fence_count, memory.fences);
  if (loaded != Status::kOk) return refuse(loaded, Field::kFences);
  if (!copy_fences(request.fences, request.fence_count, memory.asked_fences)) {
    return refuse(Status::kFencePlanesFull, Field::kFences);
  }
  const double radius = grid_->spec().radius;
  const Vec3& start = memory.ends.start_in_grid;
  const Vec3& goal = memory.ends.goal_in_grid;
  report_.fence = fence_broken(memory.fences, start, start, radius);
  if (report_.fence != kNoFence) return refuse(Status::kStartFenced, Field::kStartPosition);
  report_.fence = fence_broken(memory.fences, goal, goal, radius);
  if (report_.fence != kNoFence) return refuse(Status::kGoalFenced, Field::kGoalPosition);
  const Status copied = copy_blocked(*grid_, memory.fence_layer, memory.fenced);
  return copied == Status::kOk ? Status::kRunning : refuse(copied, Field::kFences);
}

/// The plan's frame has its origin in the start, in world coordinates as they were given.
void Planner::set_ends() noexcept {
  const Request local = to_local(*grid_, asked_);
  FlightEnds& ends = static_cast<Layout*>(workspace_)->ends;
  ends.start_in_grid = local.start.position;
  ends.goal_in_grid = local.goal.position;
  ends.origin_in_grid = local.start.position;
  ends.start = asked_.start;
  ends.goal = asked_.goal;
  ends.start.position = {0.0, 0.0, 0.0};
  ends.goal.position = asked_.goal.position - asked_.start.position;
  for (Escape& escape : static_cast<Layout*>(workspace_)->escapes) escape.next = escape.count = 0;
  cut_previous(*grid_, asked_, static_cast<Layout*>(workspace_)->previous);
}

Status Planner::begin(const Grid& grid, const Request& request) noexcept {
  report_ = Report{};
  report_.timing_known = clock_ != nullptr;
  has_path_ = false;
  has_corridor_ = false;
  escapes_ = 0;
  arrivals_ = 0;
  stop_and_go_ = false;
  grid_ = &grid;
  if (!same_configuration_) return refuse(Status::kInvalidArgument, Field::kConfiguration);
  if (workspace_ == nullptr) return refuse(Status::kInvalidArgument, Field::kWorkspace);
  if (!grid.inflated()) return refuse(Status::kInvalidArgument, grid.bound() ? Field::kNotInflated : Field::kStorage);
  const Verdict verdict = validate(grid, request);
  if (verdict.status != Status::kOk) return refuse(verdict.status, verdict.field);
  asked_ = request;
  set_ends();
  const Status fences = accept_fences(request);
  if (fences != Status::kRunning) return fences;
  version_ = grid.version();
  status_ = Status::kRunning;
  enter(has_fences_ ? Phase::kFences : Phase::kPath);
  return status_;
}

Status Planner::step(std::uint32_t work) noexcept {
  if (phase_ == Phase::kIdle) return Status::kInvalidArgument;
  Work slice{work};
  // Phases follow one another, and once again after a detour; each ends the plan, ends the slice or enters the next.
  while (phase_ != Phase::kDone) {
    if (!grid_->version().equals(version_)) return end(stage_of_phase(), Status::kMapChanged);
    if (run_phase(slice) == Status::kRunning && slice.left == 0) return Status::kRunning;
  }
  return status_;
}

Status Planner::finish(Trajectory& trajectory, Report& report) noexcept {
  if (phase_ != Phase::kDone) {
    if (phase_ == Phase::kIdle) report_ = Report{};
    status_ = Status::kInvalidArgument;
    report_.field = Field::kCallOrder;
  }
  phase_ = Phase::kIdle;
  report_.status = status_;
  settle_times(report_);
  report = report_;
  if (status_ == Status::kOk) trajectory = static_cast<const Layout*>(workspace_)->trajectory;
  return status_;
}

const Path* Planner::path() const noexcept {
  return has_path_ ? &static_cast<const Layout*>(workspace_)->path : nullptr;
}

const Corridor* Planner::corridor() const noexcept {
  return has_corridor_ ? &static_cast<const Layout*>(workspace_)->corridor : nullptr;
}

}  // namespace tern
