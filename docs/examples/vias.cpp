// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/missions.md: a plan through points in a known world.
#include <cstdint>
#include <memory>
#include <vector>

#include "tern/tern.hpp"

static tern::Status plan_mission(const tern::Grid& grid, tern::Planner& planner, tern::Trajectory& plan,
                                 tern::Report& report) {
  tern::Via vias[3];  // they must stay until the plan is done
  vias[0].position = {4.0, 6.0, 1.5};
  vias[1].position = {9.0, 6.0, 1.5};
  vias[1].tolerance = 0.3;
  vias[2].position = {9.0, 2.0, 1.5};
  vias[2].stop = true;
  tern::Request request;
  request.start.position = {1.0, 1.0, 1.5};
  request.goal.position = {1.0, 2.0, 1.5};
  request.limits = {{3.0, 3.0, 2.0}, {4.0, 4.0, 4.0}};
  request.vias = vias;
  request.via_count = 3;
  return planner.plan(grid, request, plan, report);
}

int main() {
  tern::GridSpec spec{};
  spec.cell = 0.1;
  spec.dims = {100, 80, 30};
  spec.boundary = {{0.0, 0.0, 0.0}, {10.0, 8.0, 3.0}};
  spec.radius = 0.3;
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  tern::Grid grid;
  if (grid.bind(spec, words.data(), words.size()) != tern::Status::kOk) return 1;
  grid.mark_box({{5.0, 0.0, 0.0}, {5.5, 4.0, 3.0}});
  grid.inflate();

  auto memory = std::make_unique<tern::Workspace>();
  tern::Planner planner(memory.get(), sizeof *memory);
  tern::Trajectory plan{};
  tern::Report report{};
  if (plan_mission(grid, planner, plan, report) != tern::Status::kOk) return 1;
  return report.vias[0].time < report.vias[1].time && report.vias[1].distance <= 0.3 + 1e-9 ? 0 : 1;
}
