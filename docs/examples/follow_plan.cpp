// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/architecture.md: the paper's map 5, planned in slices. Prints the page's tables. Run it in the folder of the
// checkout.
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <vector>

#include "host/grid_layout.hpp"
#include "host/scenario.hpp"
#include "tern/tern.hpp"

static tern::Workspace workspace;

/// Plans in slices of `units` of work and counts them.
static int plan_in_slices(tern::Planner& planner, const tern::Grid& grid, const tern::Request& request, uint32_t units,
                          tern::Trajectory& plan, tern::Report& report) {
  int slices = 0;
  tern::Status status = planner.begin(grid, request);
  while (status == tern::Status::kRunning) {
    status = planner.step(units);
    ++slices;
  }
  planner.finish(plan, report);
  return slices;
}

static void print_stages(const tern::Report& report) {
  for (int s = 1; s < tern::kStageCount; ++s) {
    const tern::StageReport& stage = report.diagnostics.stages[s];
    if (stage.bound == 0) continue;  // it did not run
    std::printf("| %s | %" PRIu64 " | %" PRIu64 " |\n", tern::stage_name(static_cast<tern::Stage>(s)), stage.work,
                stage.bound);
  }
}

static void print_marks(const tern::HighWater& mark) {
  std::printf("| nodes | %d | %d |\n", mark.nodes, tern::kMaxNodes);
  std::printf("| open list | %d | %d |\n", mark.open, tern::kMaxOpen);
  std::printf("| jump points | %d | %d |\n", mark.jump_points, tern::kMaxJumpPoints);
  std::printf("| segments | %d | %d |\n", mark.segments, tern::kMaxSegments);
  std::printf("| half-spaces of a polyhedron | %d | %d |\n", mark.planes, tern::kMaxPlanes);
  std::printf("| local boxes | %d | %d |\n", mark.local_boxes, tern::kMaxLocalBoxes);
  std::printf("| active rows | %d | %d |\n", mark.active, tern::kMaxActive);
  std::printf("| iterations of a programme | %d | %d |\n", mark.qp_iterations, tern::kMaxQpIterations);
  std::printf("| programmes | %d | %d |\n", mark.qp_solves, tern::kMaxQpSolves);
  std::printf("| planes off things | %d | %d |\n", mark.separations, tern::kMaxSeparations);
  std::printf("| words of a flood in time | %d | %d |\n", mark.flood_words, tern::kMaxFloodWords);
}

int main() {
  const tern_host::Scenario scenario = tern_host::read_scenario("bench/maps/map5.txt");
  const tern::GridSpec spec = tern_host::lay_out_grid(scenario);
  std::vector<uint64_t> words(tern::grid_words(spec.dims));
  tern::Grid grid;
  grid.bind(spec, words.data(), words.size());
  for (const tern_host::Block& block : scenario.blocks) grid.mark_box(block.box);
  grid.inflate();
  tern::Request request;
  request.start = scenario.start;
  request.goal = scenario.goal;
  request.limits = scenario.limits;

  tern::Planner planner(&workspace, sizeof workspace);
  static tern::Trajectory plan;
  static tern::Trajectory sliced;
  tern::Report report;
  const bool planned = planner.plan(grid, request, plan, report) == tern::Status::kOk;
  const int slices = plan_in_slices(planner, grid, request, 100, sliced, report);
  std::printf("%d x %d x %d voxels, %zu words\n", spec.dims.x, spec.dims.y, spec.dims.z, words.size());
  std::printf("%d jump points, %d waypoints, %d polyhedra, %d segments, %.2f s\n", planner.path()->raw_count,
              planner.path()->count, planner.corridor()->count, plan.count, tern::duration(plan));
  std::printf("%d slices of 100 units\n", slices);
  print_stages(report);
  print_marks(report.diagnostics.high_water);
  const size_t used = sizeof(tern::Segment) * static_cast<size_t>(plan.count);
  return planned && std::memcmp(plan.segments, sliced.segments, used) == 0 ? 0 : 1;
}
