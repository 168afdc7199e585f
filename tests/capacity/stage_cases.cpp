// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Capacities and budgets of the planner's stages, from the search to the optimiser.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/math.hpp"
#include "capacity/cases.hpp"
#include "capacity/requests.hpp"
#include "support/tiny_cases.hpp"
#include "support/world.hpp"

namespace tern_capacity {
namespace {

using tern::HighWater;
using tern::Status;
using tern::Vec3;
using tern_test::slalom;
using tern_test::World;

using Mark = std::int32_t HighWater::*;

struct MarkedCapacity {
  Mark mark;
  std::int32_t capacity;
};
constexpr MarkedCapacity kMarked[] = {{&HighWater::nodes, tern::kMaxNodes},
                                      {&HighWater::open, tern::kMaxOpen},
                                      {&HighWater::jump_points, tern::kMaxJumpPoints},
                                      {&HighWater::segments, tern::kMaxSegments},
                                      {&HighWater::planes, tern::kMaxPlanes},
                                      {&HighWater::local_boxes, tern::kMaxLocalBoxes},
                                      {&HighWater::active, tern::kMaxActive},
                                      {&HighWater::qp_iterations, tern::kMaxQpIterations},
                                      {&HighWater::qp_solves, tern::kMaxQpSolves}};

/// True where the plan used all of one capacity, and some of each other one was left.
bool only_full(const tern::Report& report, Mark mark) {
  for (const MarkedCapacity& each : kMarked) {
    const std::int32_t used = report.diagnostics.high_water.*each.mark;
    if (used > each.capacity || (used == each.capacity) != (each.mark == mark)) return false;
  }
  return true;
}

/// The answer, if the plan used up this capacity alone and left the output as it was.
Status only(const World& world, Mark mark) {
  return only_full(world.report, mark) && world.trajectory_untouched() ? world.report.status : kNotThis;
}

/// The same of the first random request that ends with a status.
Status of_random_request(Status status, Mark mark) {
  constexpr std::uint64_t kMost = 20000;
  for (std::uint64_t seed = 0; seed < kMost; ++seed) {
    const auto asked = random_request(seed);
    if (asked->world.replan() == status && only_full(asked->world.report, mark)) return only(asked->world, mark);
  }
  return kNotThis;
}

bool some_random_plan_has(Mark mark, std::int32_t least) {
  constexpr std::uint64_t kMost = 20000;
  for (std::uint64_t seed = 0; seed < kMost; ++seed) {
    const auto asked = random_request(seed);
    if (asked->world.replan() == Status::kOk && asked->world.report.diagnostics.high_water.*mark >= least) return true;
  }
  return false;
}

// ---- the search and the path

Status plan_slalom(int walls) {
  World world = slalom(walls);
  world.plan();
  return world.report.status == Status::kOk ? Status::kOk : only(world, &HighWater::segments);
}

std::vector<Exceeded> path_capacities() {
  const auto has = [](Mark mark, std::int32_t least) { return [=] { return some_random_plan_has(mark, least); }; };
  const auto full = [](Status status, Mark mark) { return [=] { return of_random_request(status, mark); }; };
  return {{"TERN_MAX_NODES", Status::kNodesFull, has(&HighWater::nodes, tern::kMaxNodes - 8),
           full(Status::kNodesFull, &HighWater::nodes)},
          {"TERN_MAX_OPEN", Status::kOpenFull, has(&HighWater::open, tern::kMaxOpen - 1),
           full(Status::kOpenFull, &HighWater::open)},
          {"TERN_MAX_JUMP_POINTS", Status::kJumpPointsFull, has(&HighWater::jump_points, tern::kMaxJumpPoints - 1),
           full(Status::kJumpPointsFull, &HighWater::jump_points)},
          {"TERN_MAX_SEGMENTS", Status::kSegmentsFull, [] { return plan_slalom(2) == Status::kOk; },
           [] { return plan_slalom(3); }}};
}

// ---- the corridor

/// So short a way that its polyhedron cannot be halved, in a keep-in of so many faces, each as near as the others.
Status plan_in_pipe(int faces) {
  World world({40, 40, 20}, 0.05, 0.0);
  world.from({1.025, 1.025, 0.525}).to({1.025 + 1e-7, 1.025, 0.525});
  std::vector<tern::Halfspace> planes;
  for (int k = 0; k < faces; ++k) {
    const double turn = 2.0 * 3.14159265358979 * k / faces;
    const Vec3 normal{0.0, std::cos(turn), std::sin(turn)};
    planes.push_back({normal, tern::dot(normal, {0.0, 1.025, 0.525}) + 0.045});
  }
  const tern::Fence fence{planes.data(), faces, tern::FenceKind::kKeepIn};
  world.request.fences = &fence;
  world.request.fence_count = 1;
  const Status status = world.plan();
  return status == Status::kOk ? status : only(world, &HighWater::planes);
}

/// A checkerboard in space around a point's own voxel, as near as the radius: every voxel is a box of its own.
Status plan_in_checkerboard(int thickness) {
  World world({16, 16, 16}, 0.1, 0.3);
  for (int z = 0; z < 16; ++z) {
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        const int away = std::max({std::abs(x - 8), std::abs(y - 8), std::abs(z - 8)});
        if ((x + y + z) % 2 == 0 && away >= 4 && away < 4 + thickness) world.grid.mark_voxel({x, y, z});
      }
    }
  }
  world.from({0.85, 0.85, 0.85}).to({0.85 + 1e-7, 0.85, 0.85});
  const Status status = world.plan();
  return status == Status::kOk ? status : only(world, &HighWater::local_boxes);
}

std::vector<Exceeded> corridor_capacities() {
  return {{"TERN_MAX_PLANES", Status::kPlanesFull, [] { return plan_in_pipe(3) == Status::kOk; },
           [] { return plan_in_pipe(tern::kMaxPlanes); }},
          {"TERN_MAX_LOCAL_BOXES", Status::kObstaclesFull, [] { return plan_in_checkerboard(0) == Status::kOk; },
           [] { return plan_in_checkerboard(1); }}};
}

// ---- the optimiser

/// Six points, each beyond so many planes of its own: as many rows are active.
Status solve_with_rows(int planes) {
  static_assert(tern::kMaxActive == 12, "six points, two planes");
  tern_test::QpBench bench;
  bench.start({1.0, 1.0, 1.0, 1.0, 1.0, 1.0});
  for (int i = 0; i < 6; ++i) bench.add_point({0.0, 0.0, 0.0}, i, {1.0});
  for (int a = 0; a < planes; ++a) {
    Vec3 normal{0.0, 0.0, 0.0};
    tern::axis(normal, a) = -1.0;
    bench.add_plane(normal, -1.0);
  }
  bench.add_group(0, 6, 0, planes);
  return bench.solve();
}

/// The first tight programme to end so.
Status solve_until(Status status) {
  tern_test::Random random(31);
  tern_test::QpBench bench;
  for (int n = 0; n < 200; ++n) {
    if (solve_tight_programme(random, bench) == status) return status;
  }
  return kNotThis;
}

/// The first random request whose plan is the best of so many programmes.
Status plan_of_solves(int solves) {
  constexpr std::uint64_t kMost = 1000;
  for (std::uint64_t seed = 0; seed < kMost; ++seed) {
    const auto asked = random_request(seed);
    const Status status = asked->world.replan();
    if (status == Status::kOk && asked->world.report.diagnostics.high_water.qp_solves == solves) return status;
  }
  return kNotThis;
}

std::vector<Exceeded> optimiser_capacities() {
  return {{"TERN_MAX_ACTIVE", Status::kWorkingSetFull, [] { return solve_with_rows(2) == Status::kOk; },
           [] { return solve_with_rows(3); }},
          {"TERN_MAX_QP_ITERATIONS", Status::kIterationLimit, [] { return solve_until(Status::kOk) == Status::kOk; },
           [] { return solve_until(Status::kIterationLimit); }},
          {"TERN_MAX_QP_SOLVES", Status::kOk, [] { return plan_of_solves(tern::kMaxQpSolves - 1) == Status::kOk; },
           [] { return plan_of_solves(tern::kMaxQpSolves); }}};
}

// ---- budgets

/// The answer to a plan with the work that it needs in a stage, or with a part of it.
Status plan_within(std::uint32_t tern::Budget::*budget, tern::Stage stage, std::uint64_t part) {
  World world = slalom(1);
  if (world.plan() != Status::kOk) return kNotThis;
  world.request.budget.*budget =
      static_cast<std::uint32_t>(world.report.diagnostics.stages[static_cast<int>(stage)].work / part);
  const Status status = world.replan();
  return status == Status::kOk ? world.report.optimiser : status;
}

Exceeded budget(const char* name, std::uint32_t tern::Budget::*member, tern::Stage stage, Status status) {
  return {name, status, [=] { return plan_within(member, stage, 1) == Status::kOk; },
          [=] { return plan_within(member, stage, 4); }};
}

std::vector<Exceeded> budgets() {
  return {budget("Budget::search", &tern::Budget::search, tern::Stage::kSearch, Status::kBudgetSearch),
          budget("Budget::shortcut", &tern::Budget::shortcut, tern::Stage::kShortcut, Status::kBudgetShortcut),
          budget("Budget::corridor", &tern::Budget::corridor, tern::Stage::kCorridor, Status::kBudgetCorridor),
          budget("Budget::trajectory", &tern::Budget::trajectory, tern::Stage::kTrajectory, Status::kBudgetOptimise)};
}

}  // namespace

std::vector<Exceeded> stage_capacities() {
  return joined({path_capacities(), corridor_capacities(), optimiser_capacities(), budgets()});
}

}  // namespace tern_capacity
