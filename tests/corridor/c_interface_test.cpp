// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The corridor in C: the planner's own polyhedra, and an answer to every misuse.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <vector>

#include "tern/tern_corridor.h"

namespace {

/// A planner that has planned past a wall with a gap at one end.
class CorridorInC : public testing::Test {
 protected:
  void SetUp() override {
    const tern_grid_spec spec{{0, 0, 0}, 0.1, {100, 80, 30}, {{0, 0, 0}, {10, 8, 3}}, 0.3, 0.0};
    words.resize(tern_grid_words(spec.dims));
    ASSERT_EQ(tern_grid_bind(&grid, &spec, words.data(), words.size()), 0);
    const tern_box wall{{4, 0, 0}, {5, 6, 3}};
    ASSERT_EQ(tern_grid_mark_box(&grid, &wall), 0);
    ASSERT_EQ(tern_grid_inflate(&grid), 0);
    ASSERT_EQ(tern_planner_init(&planner, workspace.get(), sizeof *workspace), 0);
    tern_request_init(&request);
    request.start.position = {1, 1, 1};
    request.goal.position = {9, 1, 1};
    request.limits.v_max = {2, 2, 1};
    request.limits.a_max = {4, 4, 2};
  }

  std::vector<std::uint64_t> words;
  tern_grid grid{};
  tern_planner planner{};
  tern_request request{};
  tern_trajectory trajectory{};
  tern_report report{};
  std::unique_ptr<tern::Workspace> workspace = std::make_unique<tern::Workspace>();
};

TEST_F(CorridorInC, HoldsTheCurveOfEachSegment) {
  ASSERT_EQ(tern_plan(&planner, &grid, &request, &trajectory, &report), 0);
  std::vector<tern_polyhedron> polyhedra(TERN_MAX_SEGMENTS);
  const std::int32_t count = tern_corridor(&planner, polyhedra.data(), TERN_MAX_SEGMENTS);
  ASSERT_GE(count, 3);  // around the wall's end: no two convex polyhedra reach from start to goal
  double begin = 0.0;
  for (int s = 0; s < trajectory.count; ++s) {
    const tern_segment& segment = trajectory.segments[s];
    ASSERT_LT(segment.polyhedron, count);
    const tern_polyhedron& polyhedron = polyhedra[static_cast<std::size_t>(segment.polyhedron)];
    ASSERT_GT(polyhedron.count, 3);
    for (int i = 0; i < polyhedron.count; ++i) {
      for (int k = 0; k < 20; ++k) {
        tern_sample at;  // the grid's origin is the world's
        tern_evaluate(&trajectory, begin + k * segment.duration / 20.0, &at);
        const tern_vec3& normal = polyhedron.planes[i].normal;
        EXPECT_LE(normal.x * at.position.x + normal.y * at.position.y + normal.z * at.position.z,
                  polyhedron.planes[i].offset + 1e-6);
      }
    }
    begin += segment.duration;
  }
}

TEST_F(CorridorInC, CopiesNoMoreThanThereIsRoomFor) {
  ASSERT_EQ(tern_plan(&planner, &grid, &request, &trajectory, &report), 0);
  const std::int32_t count = tern_corridor(&planner, nullptr, 0);
  ASSERT_GE(count, 3);
  EXPECT_EQ(tern_corridor(&planner, nullptr, 5), count);
  std::vector<tern_polyhedron> two(2);
  std::memset(static_cast<void*>(two.data()), 0, 2 * sizeof two[0]);
  EXPECT_EQ(tern_corridor(&planner, two.data(), -1), count);
  EXPECT_EQ(two[0].count, 0);
  EXPECT_EQ(tern_corridor(&planner, two.data(), 1), count);
  EXPECT_GT(two[0].count, 0);
  EXPECT_EQ(two[1].count, 0);
}

TEST_F(CorridorInC, IsEmptyWithoutAPlan) {
  tern_polyhedron one;
  EXPECT_EQ(tern_corridor(nullptr, &one, 1), 0);
  EXPECT_EQ(tern_corridor(&planner, &one, 1), 0);
  request.goal.position = {4.5, 1, 1};  // in the wall
  ASSERT_NE(tern_plan(&planner, &grid, &request, &trajectory, &report), 0);
  EXPECT_EQ(tern_corridor(&planner, &one, 1), 0);
}

}  // namespace
