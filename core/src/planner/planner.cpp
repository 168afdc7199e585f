// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern/planner.hpp"

#include <cstddef>
#include <new>

#include "planner/layout.hpp"

namespace tern {
namespace {

/// The first aligned byte of the caller's memory; null if the memory is too small for a workspace.
void* align(void* memory, std::size_t bytes) {
  if (memory == nullptr || bytes < kWorkspaceBytes) return nullptr;
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t aligned = (address + kWorkspaceAlignment - 1) & ~(std::uintptr_t{kWorkspaceAlignment} - 1);
  return static_cast<unsigned char*>(memory) + (aligned - address);
}

/// The most steps of one call of plan(). Each step may spend 2^32 - 1 units, and every stage is bounded far below that.
constexpr int kMaxSteps = 16;

}  // namespace

Planner::Planner(void* memory, std::size_t bytes, std::uint64_t configuration) noexcept
    : workspace_(configuration == kConfigurationHash ? align(memory, bytes) : nullptr),
      same_configuration_(configuration == kConfigurationHash) {
  if (workspace_ == nullptr) return;
  new (&current_plan()) Plan(layout(workspace_));
}

const Plan& Planner::current_plan() const noexcept {
  return layout(workspace_).plan;
}

Plan& Planner::current_plan() noexcept {
  return layout(workspace_).plan;
}

void Planner::set_clock(ClockFn clock, void* context) noexcept {
  if (workspace_ != nullptr) current_plan().set_clock(clock, context);
}

Status Planner::plan(const Grid& grid, const Request& request, Trajectory& trajectory, Report& report) noexcept {
  Status status = begin(grid, request);
  for (int i = 0; i < kMaxSteps && status == Status::kRunning; ++i) status = step(0xFFFFFFFFu);
  return finish(trajectory, report);
}

Status Planner::begin(const Grid& grid, const Request& request) noexcept {
  refused_ = workspace_ == nullptr;
  return refused_ ? Status::kInvalidArgument : current_plan().begin(grid, request);
}

Status Planner::begin(const Grid& grid, const Request& request, const Trajectory& pace, double pace_time) noexcept {
  refused_ = workspace_ == nullptr;
  return refused_ ? Status::kInvalidArgument : current_plan().begin(grid, request, pace, pace_time);
}

Status Planner::route(const Grid& grid, const Request& request, Report& report) noexcept {
  Status status = begin_route(grid, request);
  for (int i = 0; i < kMaxSteps && status == Status::kRunning; ++i) status = step(0xFFFFFFFFu);
  return finish_route(report);
}

Status Planner::begin_route(const Grid& grid, const Request& request) noexcept {
  refused_ = workspace_ == nullptr;
  return refused_ ? Status::kInvalidArgument : current_plan().begin_route(grid, request);
}

Status Planner::step(Work& work) noexcept {
  return workspace_ == nullptr ? Status::kInvalidArgument : current_plan().step(work);
}

Status Planner::step(std::uint32_t work) noexcept {
  return workspace_ == nullptr ? Status::kInvalidArgument : current_plan().step(work);
}

Status Planner::finish(Trajectory& trajectory, Report& report) noexcept {
  return workspace_ == nullptr ? refuse(report) : current_plan().finish(trajectory, report);
}

Status Planner::finish_route(Report& report) noexcept {
  return workspace_ == nullptr ? refuse(report) : current_plan().finish_route(report);
}

/// The answer to every plan and route of a planner without a workspace.
Status Planner::refuse(Report& report) noexcept {
  report = Report{};
  report.status = Status::kInvalidArgument;
  report.field = same_configuration_ ? Field::kWorkspace : Field::kConfiguration;
  if (!refused_) report.field = Field::kCallOrder;
  refused_ = false;
  return report.status;
}

Stage Planner::stage() const noexcept {
  return workspace_ == nullptr ? Stage::kRequest : current_plan().stage();
}

const Path* Planner::path() const noexcept {
  return workspace_ == nullptr ? nullptr : current_plan().path();
}

const Corridor* Planner::corridor() const noexcept {
  return workspace_ == nullptr ? nullptr : current_plan().corridor();
}

}  // namespace tern
