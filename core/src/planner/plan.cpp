// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/plan.hpp"

#include "base/math.hpp"
#include "base/work.hpp"
#include "planner/layout.hpp"

namespace tern {

void Plan::set_clock(ClockFn clock, void* context) noexcept {
  clock_ = clock;
  clock_context_ = context;
}

Status Plan::begin(const Grid& grid, const Request& request) noexcept {
  return begin_query(grid, request, {false, clock_ != nullptr, nullptr, 0.0});
}

Status Plan::begin(const Grid& grid, const Request& request, const Trajectory& pace, double pace_time) noexcept {
  return begin_query(grid, request, {false, clock_ != nullptr, &pace, pace_time});
}

/// A route has no trajectory, so the motion of its ends does not matter.
Status Plan::begin_route(const Grid& grid, const Request& request) noexcept {
  Request still = request;
  still.start = {request.start.position, kZero, kZero};
  still.goal = {request.goal.position, kZero, kZero};
  still.previous = nullptr;
  return begin_query(grid, still, {true, clock_ != nullptr, nullptr, 0.0});
}

Status Plan::begin_query(const Grid& grid, const Request& request, const PlanMode& mode) noexcept {
  begun_ = true;
  is_route_ = mode.route_only;
  grid_ = &grid;
  slice_ = Work{};
  const Status status = pipeline_.begin(grid, request, mode);
  version_ = grid.version();
  return status;
}

Status Plan::step(std::uint32_t work) noexcept {
  slice_.add(work);
  return step(slice_);
}

Status Plan::step(Work& work) noexcept {
  if (!begun_) return Status::kInvalidArgument;
  // Each stage uses up the slice, ends the plan, or enters the next stage. Some run again after a failure.
  while (pipeline_.status() == Status::kRunning) {
    const Stage stage = pipeline_.stage();
    if (!grid_->version().equals(version_)) return pipeline_.end(stage, Status::kMapChanged);
    const std::uint64_t before = ticks();
    const Progress progress = pipeline_.advance(work);
    pipeline_.count_ticks(stage, before, ticks());
    if (progress == Progress::kMore) return Status::kRunning;
  }
  return pipeline_.status();
}

Status Plan::finish(Trajectory& trajectory, Report& report) noexcept {
  const Status status = close(false, report);
  if (status == Status::kOk) {
    trajectory = memory_->trajectory;
    trajectory.begin = pipeline_.begin_time();
  }
  return status;
}

Status Plan::finish_route(Report& report) noexcept {
  return close(true, report);
}

/// Ends what was begun. `is_route` says which of the two calls asks for it.
Status Plan::close(bool is_route, Report& report) noexcept {
  const bool in_order = begun_ && pipeline_.status() != Status::kRunning && is_route == is_route_;
  if (begun_) {
    if (!in_order) pipeline_.refuse({Status::kInvalidArgument, Field::kCallOrder});
    pipeline_.write(report);
  } else {
    report = Report{};
    report.status = Status::kInvalidArgument;
    report.field = Field::kCallOrder;
  }
  begun_ = false;
  return report.status;
}

const Path* Plan::path() const noexcept {
  return pipeline_.results().path ? &memory_->path : nullptr;
}

const Corridor* Plan::corridor() const noexcept {
  return pipeline_.results().corridor ? &memory_->corridor : nullptr;
}

}  // namespace tern
