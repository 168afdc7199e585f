// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The timer that the port of port/README.md asks for, and a plan whose report is timed by that port.
#include <cstdio>
#include <memory>

#include "tern/tern.hpp"
#include "tern_port/port.hpp"

// A microsecond a reading: enough for a report whose every stage took time.
extern "C" unsigned long long my_timer_count() {
  static unsigned long long count = 0;
  return ++count;
}

int main() {
  static std::uint64_t words[2 * 64];
  tern::GridSpec spec{};
  spec.cell = 0.5;
  spec.dims = {8, 8, 4};
  spec.boundary = {{0.0, 0.0, 0.0}, {4.0, 4.0, 2.0}};
  spec.radius = 0.2;
  tern::Grid grid;
  if (grid.bind(spec, words, sizeof words / sizeof *words) != tern::Status::kOk) return 1;
  grid.inflate();
  tern::Request request{};
  request.start.position = {1.0, 1.0, 1.0};
  request.goal.position = {3.0, 3.0, 1.0};
  request.limits.v_max = {2.0, 2.0, 2.0};
  request.limits.a_max = {2.0, 2.0, 2.0};

  const auto workspace = std::make_unique<tern::Workspace>();
  tern::Planner planner(workspace.get(), sizeof *workspace);
  planner.set_clock(tern_port::ticks, nullptr);
  tern::Trajectory trajectory;
  tern::Report report;
  const tern::Status status = planner.plan(grid, request, trajectory, report);
  const std::uint64_t ticks = report.diagnostics.stages[static_cast<int>(tern::Stage::kSearch)].ticks;
  const bool runs_on = tern_port::monotonic_nanoseconds() < tern_port::monotonic_nanoseconds();
  std::printf("%s, timing %s, search %llu ticks\n", tern::status_name(status),
              report.diagnostics.timing_known ? "known" : "unknown", static_cast<unsigned long long>(ticks));
  return status == tern::Status::kOk && report.diagnostics.timing_known && ticks > 0 && runs_on &&
                 tern_port::ticks_per_second() == 1e6
             ? 0
             : 1;
}
