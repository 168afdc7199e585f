// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The planner, its grid and records through C: the plan of C++, in one call and in slices, and an answer to each null
// pointer.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "support/world.hpp"
#include "tern/tern.h"
#include "tern/tern_record.h"

namespace {

using tern::Status;
using tern_test::World;

constexpr std::uint8_t kOk = 0;
constexpr auto kInvalid = static_cast<std::uint8_t>(Status::kInvalidArgument);
constexpr auto kRunning = static_cast<std::uint8_t>(Status::kRunning);
constexpr tern_box kBlock{{0.9, 0.0, 0.0}, {1.1, 1.0, 1.0}};

/// A grid with one block, and a planner, in C.
struct PlannerInC {
  PlannerInC() : words(tern_grid_words({20, 20, 10})), memory(std::make_unique<tern::Workspace>()) {
    const tern_grid_spec spec{{0.0, 0.0, 0.0}, 0.1, {20, 20, 10}, {{0.0, 0.0, 0.0}, {2.0, 2.0, 1.0}}, 0.1, 0.0};
    EXPECT_EQ(tern_grid_bind(&grid, &spec, words.data(), words.size()), kOk);
    EXPECT_EQ(tern_grid_mark_box(&grid, &kBlock), kOk);
    EXPECT_EQ(tern_grid_inflate(&grid), kOk);
    EXPECT_EQ(tern_planner_init(&planner, memory.get(), sizeof *memory), kOk);
    tern_request_init(&request);
    request.start.position = {0.55, 0.55, 0.55};
    request.goal.position = {1.45, 0.55, 0.55};
    request.limits = {{2.0, 2.0, 2.0}, {4.0, 4.0, 4.0}};
  }
  std::uint8_t plan() { return tern_plan(&planner, &grid, &request, &trajectory, &report); }

  std::vector<std::uint64_t> words;
  std::unique_ptr<tern::Workspace> memory;
  tern_grid grid{};
  tern_planner planner{};
  tern_request request{};
  tern_trajectory trajectory{};
  tern_report report{};
};

std::uint64_t ticks(void* context) {
  return ++*static_cast<std::uint64_t*>(context);
}

TEST(CPlanner, PlansInSlicesAsInOneCallAndAsInCpp) {
  PlannerInC c;
  ASSERT_EQ(c.plan(), kOk);
  World world({20, 20, 10}, 0.1, 0.1);
  world.grid.mark_box(kBlock);
  world.from(c.request.start.position).to(c.request.goal.position);
  world.request.limits = c.request.limits;
  ASSERT_EQ(world.plan(), Status::kOk);
  EXPECT_EQ(tern_duration(&c.trajectory), tern::duration(world.trajectory));
  tern_trajectory sliced{};
  ASSERT_EQ(tern_plan_begin(&c.planner, &c.grid, &c.request), kRunning);
  int slices = 1;
  while (tern_plan_step(&c.planner, 3) == kRunning) ++slices;
  EXPECT_EQ(tern_plan_finish(&c.planner, &sliced, &c.report), kOk);
  EXPECT_GT(slices, 5);
  ASSERT_EQ(sliced.count, c.trajectory.count);
  for (int k = 0; k < sliced.count; ++k) {
    EXPECT_EQ(std::memcmp(sliced.segments[k].points, c.trajectory.segments[k].points, sizeof sliced.segments[k].points),
              0);
  }
}

TEST(CPlanner, FindsARouteAlone) {
  PlannerInC c;
  ASSERT_EQ(c.plan(), kOk);
  const std::int32_t count = tern_path(&c.planner, nullptr, 0);
  ASSERT_GT(count, 2);
  std::vector<tern_vec3> planned(static_cast<std::size_t>(count));
  ASSERT_EQ(tern_path(&c.planner, planned.data(), count), count);
  ASSERT_EQ(tern_route(&c.planner, &c.grid, &c.request, &c.report), kOk);
  std::vector<tern_vec3> alone(planned.size());
  ASSERT_EQ(tern_path(&c.planner, alone.data(), count), count);
  EXPECT_EQ(std::memcmp(alone.data(), planned.data(), sizeof(tern_vec3) * alone.size()), 0);
  ASSERT_EQ(tern_route_begin(&c.planner, &c.grid, &c.request), kRunning);
  EXPECT_EQ(tern_path(&c.planner, alone.data(), count), 0);
  while (tern_plan_step(&c.planner, 3) == kRunning) {
  }
  EXPECT_EQ(tern_route_finish(&c.planner, &c.report), kOk);
  EXPECT_EQ(tern_path(&c.planner, nullptr, count), count);
}

TEST(CPlanner, ChangesItsGrid) {
  PlannerInC c;
  ASSERT_EQ(c.plan(), kOk);
  const double around = tern_duration(&c.trajectory);
  EXPECT_EQ(tern_grid_clear_box(&c.grid, &kBlock), kOk);
  EXPECT_EQ(tern_grid_inflate(&c.grid), kOk);
  ASSERT_EQ(c.plan(), kOk);
  EXPECT_LT(tern_duration(&c.trajectory), around - 0.2);
  const tern_cylinder trunk{{1.45, 0.55, 0.0}, 0.1, 1.0};
  EXPECT_EQ(tern_grid_mark_cylinder(&c.grid, &trunk), kOk);
  EXPECT_EQ(tern_grid_inflate(&c.grid), kOk);
  EXPECT_EQ(c.plan(), static_cast<std::uint8_t>(Status::kGoalOccupied));
  const tern_vec3 points[] = {{0.55, 0.55, 0.55}, {9.0, 9.0, 9.0}};
  std::size_t inside = 0;
  EXPECT_EQ(tern_grid_mark_points(&c.grid, points, 2, &inside), kOk);
  EXPECT_EQ(inside, 1u);
  EXPECT_EQ(tern_grid_inflate(&c.grid), kOk);
  EXPECT_EQ(c.plan(), static_cast<std::uint8_t>(Status::kStartOccupied));
  // Bound once more, it is empty again; a spec that is refused leaves it as it was.
  tern_grid_spec spec{{0.0, 0.0, 0.0}, 0.0, {20, 20, 10}, {{0.0, 0.0, 0.0}, {2.0, 2.0, 1.0}}, 0.1, 0.0};
  EXPECT_NE(tern_grid_bind(&c.grid, &spec, c.words.data(), c.words.size()), kOk);
  EXPECT_EQ(c.plan(), static_cast<std::uint8_t>(Status::kStartOccupied));
  spec.cell = 0.1;
  EXPECT_EQ(tern_grid_bind(&c.grid, &spec, c.words.data(), c.words.size()), kOk);
  EXPECT_EQ(tern_grid_inflate(&c.grid), kOk);
  EXPECT_EQ(c.plan(), kOk);
}

TEST(CPlanner, MeasuresWithAClock) {
  PlannerInC c;
  std::uint64_t now = 0;
  EXPECT_EQ(tern_planner_set_clock(&c.planner, ticks, &now), kOk);
  ASSERT_EQ(c.plan(), kOk);
  EXPECT_TRUE(c.report.diagnostics.timing_known);
  EXPECT_GT(now, 10u);
}

TEST(CPlanner, AFineGridMarksACoarseOne) {
  const auto bind = [](tern_grid& grid, double cell, tern_voxel dims, std::vector<std::uint64_t>& words) {
    words.resize(tern_grid_words(dims));
    const tern_grid_spec spec{{0.0, 0.0, 0.0}, cell, dims, {{0.0, 0.0, 0.0}, {4.0, 1.0, 1.0}}, 0.0, 0.0};
    return tern_grid_bind(&grid, &spec, words.data(), words.size());
  };
  tern_grid fine{}, coarse{};
  std::vector<std::uint64_t> fine_words, coarse_words;
  ASSERT_EQ(bind(fine, 0.25, {16, 4, 4}, fine_words), kOk);
  ASSERT_EQ(bind(coarse, 1.0, {4, 1, 1}, coarse_words), kOk);
  const tern_box wall{{1.0, 0.0, 0.0}, {1.75, 1.0, 1.0}};
  ASSERT_EQ(tern_grid_mark_box(&fine, &wall), kOk);
  std::uint8_t field = 0;
  EXPECT_EQ(tern_grid_mark_grid(&coarse, &fine, &field), kInvalid);
  EXPECT_STREQ(tern_field_name(field), "grid not inflated");
  EXPECT_EQ(tern_grid_mark_grid(&coarse, nullptr, &field), kInvalid);
  EXPECT_STREQ(tern_field_name(field), "grid storage");
  ASSERT_EQ(tern_grid_inflate(&fine), kOk);
  const std::uint64_t* const row = coarse_words.data() + 8;  // behind the header
  EXPECT_EQ(*row, 0u);
  EXPECT_EQ(tern_grid_mark_grid(&coarse, &fine, nullptr), kOk);
  EXPECT_EQ(*row, 2u);
}

TEST(CPlanner, RefusesNullPointers) {
  PlannerInC c;
  tern_grid none{};
  EXPECT_EQ(tern_grid_bind(nullptr, nullptr, nullptr, 0), kInvalid);
  EXPECT_EQ(tern_grid_bind(&c.grid, nullptr, nullptr, 0), kInvalid);
  for (tern_grid* grid : {&none, static_cast<tern_grid*>(nullptr)}) {
    const tern_cylinder trunk{};
    EXPECT_EQ(tern_grid_mark_box(grid, &kBlock), kInvalid);
    EXPECT_EQ(tern_grid_clear_box(grid, &kBlock), kInvalid);
    EXPECT_EQ(tern_grid_mark_cylinder(grid, &trunk), kInvalid);
    EXPECT_EQ(tern_grid_mark_points(grid, &kBlock.lower, 1, nullptr), kInvalid);
    EXPECT_EQ(tern_grid_mark_grid(grid, &c.grid, nullptr), kInvalid);
    EXPECT_EQ(tern_grid_mark_grid(&c.grid, grid, nullptr), kInvalid);
    EXPECT_EQ(tern_grid_inflate(grid), kInvalid);
  }
  EXPECT_EQ(tern_grid_mark_box(&c.grid, nullptr), kInvalid);
  EXPECT_EQ(tern_grid_clear_box(&c.grid, nullptr), kInvalid);
  EXPECT_EQ(tern_grid_mark_cylinder(&c.grid, nullptr), kInvalid);
  EXPECT_EQ(tern_planner_set_clock(nullptr, nullptr, nullptr), kInvalid);
  EXPECT_EQ(tern_plan(nullptr, &c.grid, &c.request, &c.trajectory, &c.report), kInvalid);
  EXPECT_EQ(tern_plan(&c.planner, nullptr, &c.request, &c.trajectory, &c.report), kInvalid);
  EXPECT_EQ(tern_plan(&c.planner, &c.grid, nullptr, &c.trajectory, &c.report), kInvalid);
  EXPECT_EQ(tern_plan(&c.planner, &c.grid, &c.request, nullptr, &c.report), kInvalid);
  EXPECT_EQ(tern_plan(&c.planner, &c.grid, &c.request, &c.trajectory, nullptr), kInvalid);
  EXPECT_EQ(tern_plan_begin(nullptr, &c.grid, &c.request), kInvalid);
  EXPECT_EQ(tern_plan_begin(&c.planner, nullptr, &c.request), kInvalid);
  EXPECT_EQ(tern_plan_begin(&c.planner, &c.grid, nullptr), kInvalid);
  EXPECT_EQ(tern_plan_step(nullptr, 1), kInvalid);
  EXPECT_EQ(tern_plan_finish(nullptr, &c.trajectory, &c.report), kInvalid);
  EXPECT_EQ(tern_plan_finish(&c.planner, nullptr, &c.report), kInvalid);
  EXPECT_EQ(tern_plan_finish(&c.planner, &c.trajectory, nullptr), kInvalid);
  EXPECT_EQ(tern_route(nullptr, &c.grid, &c.request, &c.report), kInvalid);
  EXPECT_EQ(tern_route(&c.planner, nullptr, &c.request, &c.report), kInvalid);
  EXPECT_EQ(tern_route(&c.planner, &c.grid, nullptr, &c.report), kInvalid);
  EXPECT_EQ(tern_route(&c.planner, &c.grid, &c.request, nullptr), kInvalid);
  EXPECT_EQ(tern_route_begin(nullptr, &c.grid, &c.request), kInvalid);
  EXPECT_EQ(tern_route_begin(&c.planner, nullptr, &c.request), kInvalid);
  EXPECT_EQ(tern_route_begin(&c.planner, &c.grid, nullptr), kInvalid);
  EXPECT_EQ(tern_route_finish(nullptr, &c.report), kInvalid);
  EXPECT_EQ(tern_route_finish(&c.planner, nullptr), kInvalid);
  EXPECT_EQ(tern_path(nullptr, nullptr, 0), 0);
  tern_request_init(nullptr);
  EXPECT_EQ(c.plan(), kOk);
}

TEST(CPlanner, RefusesAGridThatWasNeverBound) {
  PlannerInC c;
  const tern_grid none{};
  EXPECT_EQ(tern_plan(&c.planner, &none, &c.request, &c.trajectory, &c.report), kInvalid);
  EXPECT_EQ(c.report.field, tern::Field::kStorage);
  EXPECT_EQ(tern_plan_begin(&c.planner, &none, &c.request), kInvalid);
  std::uint8_t bytes[8] = {};
  std::size_t used = 0;
  EXPECT_EQ(tern_record_plan(&none, &c.request, kOk, &c.trajectory, bytes, sizeof bytes, &used), kInvalid);
}

/// A planner without usable memory answers as one, whatever it is called for.
TEST(CPlanner, AnswersWithoutMemory) {
  PlannerInC c;
  EXPECT_EQ(tern_planner_init(nullptr, c.memory.get(), sizeof *c.memory), kInvalid);
  EXPECT_EQ(tern_planner_init_for(&c.planner, c.memory.get(), sizeof *c.memory, tern_header_hash() + 1), kInvalid);
  EXPECT_NE(c.plan(), kOk);
  EXPECT_EQ(c.report.field, tern::Field::kConfiguration);
  EXPECT_EQ(tern_planner_init(&c.planner, nullptr, sizeof *c.memory), kInvalid);
  EXPECT_NE(c.plan(), kOk);
  EXPECT_EQ(c.report.field, tern::Field::kWorkspace);
  EXPECT_EQ(tern_planner_init(&c.planner, c.memory.get(), tern::kWorkspaceBytes - 1), kInvalid);
  EXPECT_NE(c.plan(), kOk);
  EXPECT_EQ(tern_planner_set_clock(&c.planner, ticks, nullptr), kOk);
  EXPECT_EQ(tern_plan_step(&c.planner, 1), kInvalid);
  tern::Planner planner(nullptr, 0);
  EXPECT_EQ(planner.path(), nullptr);
  EXPECT_EQ(planner.corridor(), nullptr);
}

TEST(CPlanner, EvaluatesWithAndWithoutAPlan) {
  PlannerInC c;
  ASSERT_EQ(c.plan(), kOk);
  tern_sample sample{};
  tern_evaluate(&c.trajectory, 0.0, &sample);
  EXPECT_NEAR(sample.position.x, 0.55, 1e-9);
  tern_evaluate(nullptr, 0.0, &sample);
  EXPECT_EQ(sample.position.x, 0.0);
  tern_evaluate(&c.trajectory, 0.0, nullptr);
  EXPECT_EQ(tern_duration(nullptr), 0.0);
  tern_flat_state level{};
  tern_flat(nullptr, nullptr, &level);
  EXPECT_NEAR(level.quaternion[0], 1.0, 1e-12);
  const tern_yaw north{0.0, 1.0, 0.0};
  tern_flat_state turned{};
  tern_flat(&sample, &north, &turned);
  EXPECT_NEAR(turned.quaternion[3], 0.7071067811865476, 1e-12);
  tern_flat(&sample, &north, nullptr);
}

TEST(CPlanner, MakesHalfspacesOfABox) {
  tern_halfspace planes[6] = {};
  tern_box_halfspaces(nullptr, planes);
  EXPECT_EQ(planes[0].offset, 0.0);
  tern_box_halfspaces(&kBlock, nullptr);
  tern_box_halfspaces(&kBlock, planes);
  tern::Halfspace expected[tern::kBoxPlanes];
  tern::box_planes(kBlock, expected);
  EXPECT_EQ(std::memcmp(planes, expected, sizeof planes), 0);
}

TEST(CPlanner, RecordsAsCpp) {
  PlannerInC c;
  ASSERT_EQ(c.plan(), kOk);
  std::vector<std::uint8_t> bytes(tern_plan_record_bytes({20, 20, 10}));
  std::size_t used = 0;
  const auto record = [&](const tern_grid* grid, const tern_request* request, const tern_trajectory* plan) {
    return tern_record_plan(grid, request, kOk, plan, bytes.data(), bytes.size(), &used);
  };
  EXPECT_EQ(record(nullptr, &c.request, &c.trajectory), kInvalid);
  EXPECT_EQ(record(&c.grid, nullptr, &c.trajectory), kInvalid);
  EXPECT_EQ(record(&c.grid, &c.request, nullptr), kInvalid);
  ASSERT_EQ(record(&c.grid, &c.request, &c.trajectory), kOk);
  const auto read = std::make_unique<tern::PlanRecord>();
  ASSERT_EQ(tern::read_plan_record(bytes.data(), used, *read), Status::kOk);
  EXPECT_EQ(tern::duration(read->plan), tern_duration(&c.trajectory));
}

}  // namespace
