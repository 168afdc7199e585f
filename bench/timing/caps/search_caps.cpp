// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Searches that end where their capacity or their budget does.
#include "caps/cap.hpp"
#include "support/random.hpp"

namespace tern_caps {
namespace {

constexpr double kCell = 0.1;
constexpr std::uint32_t kBudget = 20000;
/// What the companion profile has; this image has less (config.hpp).
constexpr std::uint64_t kCompanionNodes = 512 * 1024;
constexpr std::uint64_t kCompanionHeap = 512 * 1024;

/// Opens the start and closes a shell around the goal: whoever looks for it looks everywhere.
void finish_world(tern::Grid& grid, const tern::Voxel& start, const tern::Voxel& goal) {
  constexpr std::int32_t kClear = 6;
  const double cell = grid.spec().cell;
  const auto box = [cell](const tern::Voxel& v, std::int32_t reach) {
    return tern::Box{{(v.x - reach) * cell, (v.y - reach) * cell, (v.z - reach) * cell},
                     {(v.x + reach) * cell, (v.y + reach) * cell, (v.z + reach) * cell}};
  };
  grid.clear_box(box(start, kClear));
  grid.mark_box(box(goal, kClear + 2));
  grid.clear_box(box(goal, kClear));
  grid.inflate();
}

/// Single voxels strewn thinly at random: most of what is found stays open.
void strew_voxels(tern::Grid& grid) {
  tern_test::Random random(1);
  const tern::Voxel& dims = grid.spec().dims;
  for (int left = dims.x * dims.y / 50 * dims.z; left > 0; --left) {
    grid.mark_voxel({random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)});
  }
}

/// Pillars of 0.3 m to 1 m, three in four of them up to the ceiling.
void strew_pillars(tern::Grid& grid) {
  tern_test::Random random(1);
  const tern::Voxel& dims = grid.spec().dims;
  for (int left = dims.x * dims.y / 170; left > 0; --left) {
    const int x = random.integer(0, dims.x);
    const int y = random.integer(0, dims.y);
    const int top = random.chance(0.25) ? random.integer(dims.z / 4, dims.z) : dims.z;
    grid.mark_box({{x * kCell, y * kCell, 0.0},
                   {(x + random.integer(3, 10)) * kCell, (y + random.integer(3, 10)) * kCell, top * kCell}});
  }
}

/// Two winding lanes one after the other: walls across y, open at alternating ends, and a way back beside the way out.
/// From one corner to the other beside it, a path has four turns for each wall's place along x.
tern::Grid serpentine() {
  const std::int32_t length = tern::kMaxDimension - 1;
  tern::Grid grid = make_grid({length, 9, 1}, kCell, 0.0);
  for (std::int32_t x = 0; x < length; ++x) {
    const bool last = x + 1 == length;
    if (!last) grid.mark_voxel({x, 4, 0});
    if (x % 2 == 0) continue;
    const std::int32_t gap = x % 4 == 1 ? 3 : 0;
    for (std::int32_t y = 0; y < 4; ++y) {
      if (y == gap) continue;
      grid.mark_voxel({x, y, 0});
      grid.mark_voxel({x, 8 - y, 0});
    }
  }
  grid.inflate();
  return grid;
}

struct Run {
  tern::Status status;
  tern::Report report;
  std::uint64_t count;
};

/// Plans from a voxel to another, whichever stage it ends in. In slices, because the counter must be read between.
Run run(const tern::Grid& grid, const tern::Voxel& from, const tern::Voxel& to, std::uint32_t budget,
        tern::SearchMode search = tern::SearchMode::kOptimal) {
  constexpr std::uint32_t kSlice = 1000;
  tern::Planner planner(memory(), kMemoryBytes);
  tern::Request request = request_between(grid.center(from), grid.center(to));
  request.budget.search = budget;
  request.search = search;
  Run run{};
  run.count = count([&] { run.status = planner.begin(grid, request); });
  while (run.status == tern::Status::kRunning) run.count += count([&] { run.status = planner.step(kSlice); });
  static tern::Trajectory trajectory;
  planner.finish(trajectory, run.report);
  return run;
}

std::uint64_t marked(std::int32_t mark) {
  return static_cast<std::uint64_t>(mark);
}

/// A row that counts only where the search ended for the reason given.
void report_search(const char* name, const Run& run, tern::Status reason, std::uint64_t mark, std::uint64_t capacity,
                   std::uint64_t times) {
  const std::uint64_t units = run.report.diagnostics.stages[static_cast<int>(tern::Stage::kSearch)].work;
  report({name, "search", run.count, run.status == reason ? mark : 0, capacity, units, times});
}

void pillar_caps() {
  const tern::Voxel start{8, 8, 20};
  const tern::Voxel goal{590, 590, 20};
  tern::Grid grid = make_grid({600, 600, 40}, kCell, 0.25);
  strew_pillars(grid);
  finish_world(grid, start, goal);
  const Run nodes = run(grid, start, goal, 0xFFFFFFFFu);
  report_search("nodes", nodes, tern::Status::kNodesFull, marked(nodes.report.diagnostics.high_water.nodes),
                tern::kMaxNodes, kCompanionNodes / tern::kMaxNodes);
  const Run budget = run(grid, start, goal, kBudget);
  report_search("search_budget", budget, tern::Status::kBudgetSearch, kBudget, kBudget, 1);
}

void noise_caps() {
  const tern::Voxel start{8, 8, 8};
  const tern::Voxel goal{245, 245, 117};
  tern::Grid grid = make_grid({256, 256, 128}, kCell, 0.0);
  strew_voxels(grid);
  finish_world(grid, start, goal);
  const Run heap = run(grid, start, goal, 0xFFFFFFFFu);
  report_search("heap", heap, tern::Status::kOpenFull, marked(heap.report.diagnostics.high_water.open), tern::kMaxOpen,
                (kCompanionHeap + tern::kMaxOpen - 1) / tern::kMaxOpen);
}

}  // namespace

void search_caps() {
  pillar_caps();
  noise_caps();
  const tern::Grid lane = serpentine();
  const Run points = run(lane, {0, 0, 0}, {0, 8, 0}, 0xFFFFFFFFu);
  report_search("jump_points", points, tern::Status::kJumpPointsFull,
                marked(points.report.diagnostics.high_water.jump_points), tern::kMaxJumpPoints, 1);
}

}  // namespace tern_caps
