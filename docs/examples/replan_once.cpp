// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/integration.md: a plan in place of the one that is being flown.
#include <cstdint>

#include "tern/tern.hpp"

static tern::Workspace workspace;
static std::uint64_t words[10329];

/// Replaces `plan` by a new one that begins when your clock shows `begin`, in nanoseconds. False: `plan` is as it was.
static bool replan(tern::Planner& planner, const tern::Grid& grid, tern::Request& request, std::int64_t begin,
                   tern::Trajectory& plan) {
  const double t = tern::time_on(plan, begin);  // s since the beginning of the old plan
  const tern::Sample then = tern::evaluate(plan, t);
  request.begin = begin;
  request.start = {then.position, then.velocity, then.acceleration, then.jerk};
  request.previous = &plan;
  request.previous_time = t;
  tern::Report report;
  return planner.plan(grid, request, plan, report) == tern::Status::kOk;
}

int main() {
  tern::Grid grid;
  grid.bind({{0, 0, 0}, 0.1, {100, 64, 40}, {{0, 0, 0}, {10, 6.4, 4}}, 0.25, 0}, words, 10329);
  grid.inflate();
  tern::Request request;
  request.start.position = {1, 1, 1};
  request.goal.position = {9, 5, 3};
  request.limits = {{2, 2, 1}, {2, 2, 1}};
  request.begin = 5000000000;  // what your clock shows at take-off
  tern::Planner planner(&workspace, sizeof workspace);
  tern::Trajectory plan;
  tern::Report report;
  if (planner.plan(grid, request, plan, report) != tern::Status::kOk) return 1;
  const double whole = tern::duration(plan);
  grid.mark_box({{6, 0, 0}, {6.5, 5, 4}});
  grid.inflate();
  const std::int64_t quarter = static_cast<std::int64_t>(0.25e9 * whole);
  const bool around = replan(planner, grid, request, request.begin + quarter, plan);
  request.budget.search = 0;  // no search: all that is left is the rest of the plan
  const tern::Trajectory before = plan;
  const bool along = replan(planner, grid, request, plan.begin + 500000000, plan);
  const bool same = plan.begin == before.begin && tern::duration(plan) == tern::duration(before);
  return around && along && same && plan.begin == 5000000000 + quarter ? 0 : 1;
}
