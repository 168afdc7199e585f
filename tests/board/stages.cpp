// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What each stage of a plan counts with the profile fmu, as CSV for bench/timing/gate.py: the golden scenarios that
// drive a capacity the furthest, and the paper's first map. The longest units of work are those of slices of one unit.
#include <cstdint>

#include "baremetal/board.hpp"
#include "golden/corpus.hpp"
#include "golden/fmu_corpus.hpp"
#include "tern_port/port.hpp"

namespace {

using tern_board::print;

/// The map; the most segments, nodes, half-spaces and boxes; many active rows; and no path.
constexpr int kScenarios[] = {0, 121, 246, 85, 242, 89, 278};

TERN_BOARD_LARGE tern::Workspace workspace;
TERN_BOARD_LARGE std::uint64_t words[tern_golden::kFmuGridWords];
tern_golden::Scenario scenario;
tern::Trajectory trajectory;

void row(int index, const char* stage, std::uint64_t count, std::uint64_t work, std::uint64_t bound) {
  print("golden_", index, ",", stage, ",", count, ",", work, ",", bound, "\n");
}

/// The longest slice of one unit.
std::uint64_t longest_unit(const tern::Grid& grid, tern::Planner& planner) {
  std::uint64_t longest = 0;
  tern::Status status = planner.begin(grid, scenario.request);
  while (status == tern::Status::kRunning) {
    const std::uint64_t begin = tern_board::counter();
    status = planner.step(1);
    const std::uint64_t count = tern_board::counter() - begin;
    if (count > longest) longest = count;
  }
  return longest;
}

bool plan(int index, tern::Planner& planner) {
  tern::Grid grid;
  tern::Report report{};
  tern_golden::scenario(index, scenario);
  const std::uint64_t begin = tern_board::counter();
  if (tern_golden::build_grid(scenario, words, tern_golden::kFmuGridWords, grid) != tern::Status::kOk) return false;
  const std::uint64_t built = tern_board::counter();
  const tern::Status status = planner.plan(grid, scenario.request, trajectory, report);
  const std::uint64_t planned = tern_board::counter();
  row(index, "grid", built - begin, 0, 0);
  for (int s = 1; s < tern::kStageCount; ++s) {
    const tern::StageReport& stage = report.diagnostics.stages[s];
    if (stage.bound == 0) continue;  // did not run
    row(index, tern::stage_name(static_cast<tern::Stage>(s)), stage.ticks, stage.work, stage.bound);
  }
  row(index, "plan", planned - built, 0, 0);
  row(index, "unit", longest_unit(grid, planner), 1, 1);
  return status == tern::Status::kOk || status == tern::Status::kNoPath;
}

}  // namespace

int main() {
  print("# ", tern_board::name(), ", ", tern_board::counter_unit(), "\n# compiler ", __VERSION__, "\n");
  tern::Planner planner(&workspace, sizeof workspace);
  planner.set_clock(tern_port::ticks, nullptr);
  print("scenario,stage,count,work,bound\n");
  bool right = true;
  for (const int index : kScenarios) right = plan(index, planner) && right;
  return right ? 0 : 1;
}
