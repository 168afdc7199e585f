// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// docs/record.md: a query and its answer as bytes, which read back as they were.
#include "tern/record.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "tern/tern.hpp"

static tern::Workspace workspace;
static std::uint64_t words[9729];  // grid_words({100, 80, 30})
static std::uint8_t bytes[200000];
static std::uint8_t saved[sizeof bytes];
static tern::PlanRecord record;

/// Stands for a file or a link.
static void save(const std::uint8_t* from, std::size_t count) {
  std::memcpy(saved, from, count);
}

int main() {
  tern::Grid grid;
  grid.bind({{0, 0, 0}, 0.1, {100, 80, 30}, {{0, 0, 0}, {10, 8, 3}}, 0.3, 0.0}, words, sizeof words / sizeof *words);
  grid.mark_box({{4, 0, 0}, {5, 6, 3}});
  grid.inflate();
  tern::Request request;
  request.start.position = {1, 1, 1};
  request.goal.position = {9, 1, 1};
  request.limits = {{2, 2, 1}, {4, 4, 2}};
  tern::Planner planner(&workspace, sizeof workspace);
  tern::Trajectory plan;
  tern::Report report;

  const tern::Status answer = planner.plan(grid, request, plan, report);
  std::size_t used = 0;
  if (tern::record_plan(grid, request, answer, plan, bytes, sizeof bytes, &used) == tern::Status::kOk)
    save(bytes, used);

  const tern::Status read = tern::read_plan_record(saved, used, record);
  return read == tern::Status::kOk && record.plan.count == plan.count && record.request.goal.position.x == 9.0 ? 0 : 1;
}
