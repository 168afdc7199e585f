// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/integration.md: a planner, a grid and a request in static memory.
#include <cstdint>

#include "tern/tern.hpp"

static tern::Workspace workspace;   // .bss, or a linker section of your own
static std::uint64_t words[10329];  // grid_words({100, 64, 40})

bool plan_once(tern::Trajectory& trajectory) {
  tern::Grid grid;
  tern::GridSpec spec{};
  spec.origin = {-5.0, -3.2, 0.0};
  spec.cell = 0.1;
  spec.dims = {100, 64, 40};
  spec.boundary = {{-5.0, -3.2, 0.0}, {5.0, 3.2, 4.0}};
  spec.radius = 0.25;
  if (grid.bind(spec, words, sizeof words / sizeof *words) != tern::Status::kOk) return false;
  grid.mark_box({{0.0, -3.2, 0.0}, {0.3, 1.0, 4.0}});
  grid.inflate();

  tern::Request request{};
  request.start.position = {-4.0, 0.0, 1.0};
  request.goal.position = {4.0, 0.0, 1.0};
  request.limits = {{2.0, 2.0, 1.0}, {2.0, 2.0, 1.0}};

  static tern::Planner planner(&workspace, sizeof workspace);
  tern::Report report;
  return planner.plan(grid, request, trajectory, report) == tern::Status::kOk;
}

int main() {
  tern::Trajectory trajectory;
  const bool exact = tern::grid_words({100, 64, 40}) == sizeof words / sizeof *words;
  return exact && plan_once(trajectory) && tern::duration(trajectory) > 4.0 ? 0 : 1;
}
