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
  new (&plan_at_hand()) Plan(layout(workspace_));
  forget_map();
}

const Plan& Planner::plan_at_hand() const noexcept {
  return layout(workspace_).plan;
}

Plan& Planner::plan_at_hand() noexcept {
  return layout(workspace_).plan;
}

void Planner::forget_map() noexcept {
  if (workspace_ != nullptr) scan_forget(layout(workspace_).scans);
}

void Planner::set_clock(ClockFn clock, void* context) noexcept {
  if (workspace_ != nullptr) plan_at_hand().set_clock(clock, context);
}

Status Planner::plan(const Grid& grid, const Request& request, Trajectory& trajectory, Report& report) noexcept {
  Status status = begin(grid, request);
  for (int i = 0; i < kMaxSteps && status == Status::kRunning; ++i) status = step(0xFFFFFFFFu);
  return finish(trajectory, report);
}

Status Planner::begin(const Grid& grid, const Request& request) noexcept {
  refused_ = workspace_ == nullptr;
  return refused_ ? Status::kInvalidArgument : plan_at_hand().begin(grid, request);
}

Status Planner::step(std::uint32_t work) noexcept {
  return workspace_ == nullptr ? Status::kInvalidArgument : plan_at_hand().step(work);
}

Status Planner::finish(Trajectory& trajectory, Report& report) noexcept {
  if (workspace_ != nullptr) return plan_at_hand().finish(trajectory, report);
  report = Report{};
  report.status = Status::kInvalidArgument;
  report.field = same_configuration_ ? Field::kWorkspace : Field::kConfiguration;
  if (!refused_) report.field = Field::kCallOrder;
  refused_ = false;
  return report.status;
}

void Planner::set_pace(const Trajectory& plan, double from) noexcept {
  if (workspace_ != nullptr) plan_at_hand().set_pace(plan, from);
}

std::uint32_t Planner::effort() const noexcept {
  return workspace_ == nullptr ? 0 : plan_at_hand().effort();
}

Stage Planner::stage() const noexcept {
  return workspace_ == nullptr ? Stage::kRequest : plan_at_hand().stage();
}

const Path* Planner::path() const noexcept {
  return workspace_ == nullptr ? nullptr : plan_at_hand().path();
}

const Corridor* Planner::corridor() const noexcept {
  return workspace_ == nullptr ? nullptr : plan_at_hand().corridor();
}

}  // namespace tern
