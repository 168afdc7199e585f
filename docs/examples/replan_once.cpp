// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/integration.md: a plan in place of the one that is being flown.
#include <cstdint>

#include "tern/tern.hpp"

static tern::Workspace workspace;
static std::uint64_t words[10409];

/// Replaces `plan` by a new one that begins at time t of the old one. False: `plan` is as it was; see below.
static bool replan(tern::Planner& planner, const tern::Grid& grid, tern::Request& request, double t,
                   tern::Trajectory& plan) {
  const tern::Sample now = tern::evaluate(plan, t);
  request.start = {now.position, now.velocity, now.acceleration, now.jerk};
  request.previous = &plan;
  request.previous_time = t;
  tern::Report report;
  return planner.plan(grid, request, plan, report) == tern::Status::kOk;
}

int main() {
  tern::Grid grid;
  grid.bind({{0, 0, 0}, 0.1, {100, 64, 40}, {{0, 0, 0}, {10, 6.4, 4}}, 0.25, 0}, words, 10409);
  grid.inflate();
  tern::Request request;
  request.start.position = {1, 1, 1};
  request.goal.position = {9, 5, 3};
  request.limits = {{2, 2, 1}, {2, 2, 1}};
  tern::Planner planner(&workspace, sizeof workspace);
  tern::Trajectory plan;
  tern::Report report;
  if (planner.plan(grid, request, plan, report) != tern::Status::kOk) return 1;
  const double whole = tern::duration(plan);
  grid.mark_box({{6, 0, 0}, {6.5, 3, 4}});
  grid.inflate();
  const bool around = replan(planner, grid, request, 0.25 * whole, plan);
  request.budget.expansions = 0;  // no search: all that is left is the rest of the plan
  const double rest = tern::duration(plan) - 0.5;
  const bool along = replan(planner, grid, request, 0.5, plan);
  const double error = tern::duration(plan) - rest;
  return around && along && error < 1e-9 && error > -1e-9 ? 0 : 1;
}
