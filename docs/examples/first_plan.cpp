// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The README's first program: a flight around a wall.
#include <cstdio>

#include "tern/tern.hpp"

static tern::Workspace workspace;  // all the memory that planning takes
static uint64_t words[9729];       // the grid's: tern::grid_words({100, 80, 30})

int main() {
  tern::Grid grid;  // 10 x 8 x 3 m in voxels of 0.1 m; the robot's radius is 0.3 m
  grid.bind({{0, 0, 0}, 0.1, {100, 80, 30}, {{0, 0, 0}, {10, 8, 3}}, 0.3, 0}, words, 9729);
  grid.mark_box({{4, 0, 0}, {5, 6, 3}});  // a wall with a gap at one end
  grid.inflate();
  tern::Request request;
  request.start.position = {1, 1, 1};
  request.goal.position = {9, 1, 1};
  request.limits = {{2, 2, 1}, {4, 4, 2}};  // m/s, m/s^2 on x, y and z
  tern::Planner planner(&workspace, sizeof workspace);
  tern::Trajectory plan;
  tern::Report report;
  if (planner.plan(grid, request, plan, report) != tern::Status::kOk) return 1;
  const tern::Vec3 p = tern::evaluate(plan, 3.0).position;
  std::printf("%.1f s; after 3 s at %.1f %.1f %.1f\n", tern::duration(plan), p.x, p.y, p.z);
}
