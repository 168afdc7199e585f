// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/planner.hpp"

#include <cstddef>
#include <new>

#include "base/math.hpp"
#include "planner/layout.hpp"

namespace tern {
namespace {

/// The first aligned byte of the caller's memory; null if the memory is too small for a workspace.
Layout* align(void* memory, std::size_t bytes) {
  if (memory == nullptr || bytes < kWorkspaceBytes) return nullptr;
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t aligned = (address + kWorkspaceAlignment - 1) & ~(std::uintptr_t{kWorkspaceAlignment} - 1);
  return reinterpret_cast<Layout*>(static_cast<unsigned char*>(memory) + (aligned - address));
}

/// A route has no trajectory, so the motion of its ends does not matter.
Request between_rests(const Request& request) {
  Request still = request;
  still.start = {request.start.position, kZero, kZero};
  still.goal = {request.goal.position, kZero, kZero};
  still.previous = nullptr;
  return still;
}

/// The most steps of one call of plan(). Each step may spend 2^32 - 1 units, and every stage is bounded far below that.
constexpr int kMaxSteps = 16;

}  // namespace

Planner::Planner(void* memory, std::size_t bytes, std::uint64_t configuration) noexcept
    : memory_(configuration == kConfigurationHash ? align(memory, bytes) : nullptr),
      same_configuration_(configuration == kConfigurationHash) {
  if (memory_ == nullptr) return;
  new (&memory_->calls) PlannerCalls{};
  new (&memory_->pipeline) Pipeline(*memory_);
}

void Planner::set_clock(ClockFn clock, void* context) noexcept {
  if (memory_ != nullptr) memory_->calls.clock = {clock, context};
}

Status Planner::plan(const Grid& grid, const Request& request, Trajectory& trajectory, Report& report) noexcept {
  Status status = begin(grid, request);
  for (int i = 0; i < kMaxSteps && status == Status::kRunning; ++i) status = step(0xFFFFFFFFu);
  return finish(trajectory, report);
}

Status Planner::begin(const Grid& grid, const Request& request) noexcept {
  return begin_query(grid, request, {});
}

Status Planner::begin(const Grid& grid, const Request& request, const Trajectory& pace, double pace_time,
                      bool must_beat) noexcept {
  return begin_query(grid, request, {Asked::kPlan, &pace, pace_time, must_beat});
}

Status Planner::route(const Grid& grid, const Request& request, Report& report) noexcept {
  Status status = begin_route(grid, request);
  for (int i = 0; i < kMaxSteps && status == Status::kRunning; ++i) status = step(0xFFFFFFFFu);
  return finish_route(report);
}

Status Planner::begin_route(const Grid& grid, const Request& request) noexcept {
  return begin_query(grid, between_rests(request), {Asked::kRoute});
}

Status Planner::begin_way(const Grid& grid, const Request& request) noexcept {
  return begin_query(grid, between_rests(request), {Asked::kWay});
}

Status Planner::begin_query(const Grid& grid, const Request& request, const PlanMode& mode) noexcept {
  refused_ = memory_ == nullptr;
  if (refused_) return Status::kInvalidArgument;
  PlannerCalls& calls = memory_->calls;
  calls.begun = true;
  calls.is_route = mode.wanted != Asked::kPlan;
  calls.slice = Work{};
  return memory_->pipeline.begin(grid, request, mode, calls.clock);
}

Status Planner::step(std::uint32_t work) noexcept {
  if (memory_ == nullptr) return Status::kInvalidArgument;
  memory_->calls.slice.add(work);
  return step(memory_->calls.slice);
}

/// Each stage uses up the slice, ends the plan, or enters the next stage. Some run again after a failure.
Status Planner::step(Work& work) noexcept {
  if (memory_ == nullptr || !memory_->calls.begun) return Status::kInvalidArgument;
  Pipeline& pipeline = memory_->pipeline;
  while (pipeline.status() == Status::kRunning) {
    if (pipeline.advance(work) == Progress::kMore) return Status::kRunning;
  }
  return pipeline.status();
}

Status Planner::finish(Trajectory& trajectory, Report& report) noexcept {
  const Status status = close(false, report);
  if (status == Status::kOk) trajectory = memory_->trajectory;
  return status;
}

Status Planner::finish_route(Report& report) noexcept {
  return close(true, report);
}

/// Ends the plan or route that was begun. `is_route`: finish_route() asks for it, not finish().
Status Planner::close(bool is_route, Report& report) noexcept {
  if (memory_ == nullptr || !memory_->calls.begun) return refuse(report);
  PlannerCalls& calls = memory_->calls;
  Pipeline& pipeline = memory_->pipeline;
  const bool in_order = pipeline.status() != Status::kRunning && is_route == calls.is_route;
  if (!in_order) pipeline.refuse({Status::kInvalidArgument, Field::kCallOrder});
  pipeline.write(report);
  calls.begun = false;
  return report.status;
}

/// The answer if nothing was begun, and to every plan and route of a planner without a workspace.
Status Planner::refuse(Report& report) noexcept {
  report = Report{};
  report.status = Status::kInvalidArgument;
  report.field = same_configuration_ ? Field::kWorkspace : Field::kConfiguration;
  if (!refused_) report.field = Field::kCallOrder;
  refused_ = false;
  return report.status;
}

Stage Planner::stage() const noexcept {
  return memory_ == nullptr ? Stage::kRequest : memory_->pipeline.stage();
}

const Path* Planner::path() const noexcept {
  return memory_ != nullptr && memory_->pipeline.results().path ? &memory_->path : nullptr;
}

const Corridor* Planner::corridor() const noexcept {
  return memory_ != nullptr && memory_->pipeline.results().corridor ? &memory_->corridor : nullptr;
}

}  // namespace tern
