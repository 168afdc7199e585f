// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A program in gnu++11, as ArduPilot's are, against the archive, which is C++17: a plan by the C interface and the same
// by the C++ one, bit for bit; and the fields of the C interface where C has them.
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "layout.h"
#include "tern/tern.h"
#include "tern/tern.hpp"

extern "C" const layout_entry* layout_of_c(size_t* count);

#if __cplusplus >= 201402L
#error "this program shows that C++11 is enough"
#endif

namespace {

uint64_t words[2048];
alignas(tern::kWorkspaceAlignment) unsigned char memory[sizeof(tern::Workspace)];
tern_trajectory first, second;

const layout_entry kLayout[] = {TERN_LAYOUT(TERN_LAYOUT_ENTRY)};

int layouts_differ() {
  size_t count = 0;
  const layout_entry* c = layout_of_c(&count);
  if (count != sizeof kLayout / sizeof *kLayout) return 1;
  int faults = 0;
  for (size_t i = 0; i < count; ++i) {
    const layout_entry& cpp = kLayout[i];
    if (c[i].offset == cpp.offset && c[i].size == cpp.size && c[i].whole == cpp.whole) continue;
    printf("%s.%s lies elsewhere in C\n", cpp.type, cpp.field);
    ++faults;
  }
  return faults;
}

tern_grid_spec room() {
  tern_grid_spec spec = {{-1.0, 0.0, 0.0}, 0.1, {30, 30, 20}, {{-1.0, 0.0, 0.0}, {2.0, 3.0, 2.0}}, 0.15, 0.0};
  return spec;
}

tern_request across() {
  tern_request request;
  tern_request_init(&request);
  request.start.position = {-0.5, 0.5, 1.0};
  request.goal.position = {1.5, 0.5, 1.0};
  request.limits.v_max = {2.0, 2.0, 1.0};
  request.limits.a_max = {2.0, 2.0, 1.0};
  return request;
}

const tern_box kWall = {{0.4, 0.0, 0.0}, {0.6, 2.0, 2.0}};

bool plan_in_c() {
  tern_grid grid;
  tern_planner planner;
  tern_report report;
  const tern_grid_spec spec = room();
  const tern_request request = across();
  return tern_grid_bind(&grid, &spec, words, sizeof words / sizeof *words) == 0 &&
         tern_grid_mark_box(&grid, &kWall) == 0 && tern_grid_inflate(&grid) == 0 &&
         tern_planner_init(&planner, memory, sizeof memory) == 0 &&
         tern_plan(&planner, &grid, &request, &first, &report) == 0 && first.count >= 2;
}

bool plan_in_cpp() {
  tern::Grid grid;
  if (grid.bind(room(), words, sizeof words / sizeof *words) != tern::Status::kOk) return false;
  if (grid.mark_box(kWall) != tern::Status::kOk) return false;
  grid.inflate();
  tern::Planner planner(memory, sizeof memory);
  tern::Report report;
  return planner.plan(grid, across(), second, report) == tern::Status::kOk;
}

bool equal_plans() {
  if (first.count != second.count) return false;
  for (int i = 0; i < first.count; ++i) {
    const tern_segment& a = first.segments[i];
    const tern_segment& b = second.segments[i];
    if (memcmp(&a.duration, &b.duration, sizeof a.duration) != 0) return false;
    if (memcmp(a.points, b.points, sizeof a.points) != 0) return false;
  }
  return true;
}

}  // namespace

int main() {
  uint32_t faults = 0;
  const bool healthy = tern::self_test(tern::configuration_hash(), &faults) == tern::Status::kOk;
  const bool planned = plan_in_c() && plan_in_cpp() && equal_plans();
  const int differences = layouts_differ();
  printf("gnu++11: self-test faults %x, plans %s, %d fields elsewhere\n", static_cast<unsigned>(faults),
         planned ? "equal" : "wrong", differences);
  return healthy && planned && differences == 0 ? 0 : 1;
}
