// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A C++ program compiled with other capacities than the archive, with memory enough for any of them: its planner
// refuses.
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "tern/tern.hpp"

int main() {
  const size_t bytes = size_t{256} << 20;  // not touched, so not taken
  void* const memory = malloc(bytes);
  static uint64_t words[4096];
  tern::GridSpec spec{};
  spec.cell = 0.1;
  spec.dims = {20, 10, 10};
  spec.boundary = {{0.0, 0.0, 0.0}, {2.0, 1.0, 1.0}};
  spec.radius = 0.1;
  tern::Grid grid;
  if (memory == nullptr || grid.bind(spec, words, sizeof words / sizeof *words) != tern::Status::kOk) return 1;
  grid.inflate();
  tern::Planner planner(memory, bytes);
  tern::Request request{};
  request.start.position = {0.5, 0.5, 0.5};
  request.goal.position = {1.5, 0.5, 0.5};
  request.limits.v_max = request.limits.a_max = {2.0, 2.0, 2.0};
  tern::Trajectory trajectory;
  trajectory.count = -1;
  tern::Report report;
  const tern::Status status = planner.plan(grid, request, trajectory, report);
  printf("%s, field %s\n", tern::status_name(status), tern::field_name(report.field));
  const bool refused = status == tern::Status::kInvalidArgument && report.field == tern::Field::kConfiguration;
  free(memory);
  return refused && trajectory.count == -1 && planner.path() == nullptr ? 0 : 1;
}
