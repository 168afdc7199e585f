// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// port/README.md: a plan in slices until a deadline.
#include <cstdint>

#include "tern/tern.hpp"
#include "tern_port/port.hpp"

static tern::Workspace workspace;
static std::uint64_t words[10329];

static tern::Status plan_until(std::uint64_t deadline, tern::Planner& planner, const tern::Grid& grid,
                               const tern::Request& request, tern::Trajectory& trajectory, tern::Report& report) {
  tern::Status status = planner.begin(grid, request);
  while (status == tern::Status::kRunning && tern_port::monotonic_nanoseconds() < deadline) {
    status = planner.step(50);  // units of work, about a thousand instructions each
  }
  status = planner.finish(trajectory, report);
  return status;
}

int main() {
  tern::Grid grid;
  grid.bind({{0, 0, 0}, 0.1, {100, 64, 40}, {{0, 0, 0}, {10, 6.4, 4}}, 0.25, 0}, words, 10329);
  grid.inflate();
  tern::Request request;
  request.start.position = {1, 1, 1};
  request.goal.position = {9, 5, 3};
  request.limits = {{2, 2, 1}, {2, 2, 1}};
  tern::Planner planner(&workspace, sizeof workspace);
  tern::Trajectory plan;
  tern::Report report;
  const std::uint64_t minute = 60000000000u;
  const std::uint64_t now = tern_port::monotonic_nanoseconds();
  const bool late = plan_until(now, planner, grid, request, plan, report) == tern::Status::kInvalidArgument &&
                    report.field == tern::Field::kCallOrder;
  return late && plan_until(now + minute, planner, grid, request, plan, report) == tern::Status::kOk ? 0 : 1;
}
