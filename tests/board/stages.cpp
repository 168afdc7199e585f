// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What each stage of a plan counts with the profile fmu, as CSV for bench/timing/gate.py: the golden scenarios that
// drive a capacity the furthest, and the paper's first map, which is also planned among as many things that move as
// fit. The longest units of work are those of slices of one unit.
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

tern::Track things[tern::kMaxTracks];
const char* among = "";

void row(int index, const char* stage, std::uint64_t count, std::uint64_t work, std::uint64_t bound) {
  print("golden_", index, among, ",", stage, ",", count, ",", work, ",", bound, "\n");
}

/// Balls that cross the straight way from start to goal, one after the other, where a vehicle at 1 m/s would be then.
void add_things() {
  const tern::Vec3& from = scenario.request.start.position;
  const tern::Vec3& to = scenario.request.goal.position;
  const tern::Vec3 way{to.x - from.x, to.y - from.y, to.z - from.z};
  const double length = __builtin_sqrt(way.x * way.x + way.y * way.y + way.z * way.z);
  for (int k = 0; k < tern::kMaxTracks; ++k) {
    const double share = (k + 1.0) / (tern::kMaxTracks + 1.0);
    const double speed = k % 2 == 0 ? 0.5 : -0.5;
    tern::Track& thing = things[k];
    thing.velocity = {-speed * way.y / length, speed * way.x / length, 0.0};
    thing.position = {from.x + share * way.x - share * length * thing.velocity.x,
                      from.y + share * way.y - share * length * thing.velocity.y, from.z + share * way.z};
    thing.radius = 0.14;
    thing.error = 0.02;
    thing.error_speed = 0.02;
  }
  scenario.request.tracks = things;
  scenario.request.track_count = tern::kMaxTracks;
  among = "_things";
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

bool plan(int index, bool has_things, tern::Planner& planner) {
  tern::Grid grid;
  tern::Report report{};
  tern_golden::scenario(index, scenario);
  if (has_things) add_things();
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
  if (status == tern::Status::kOk || status == tern::Status::kNoPath) return true;
  print("fails: scenario ", index, ", ", tern::status_name(status), "\n");
  return false;
}

}  // namespace

int main() {
  print("# ", tern_board::name(), ", ", tern_board::counter_unit(), "\n# compiler ", __VERSION__, "\n");
  tern::Planner planner(&workspace, sizeof workspace);
  planner.set_clock(tern_port::ticks, nullptr);
  print("scenario,stage,count,work,bound\n");
  bool right = true;
  for (const int index : kScenarios) right = plan(index, false, planner) && right;
  right = plan(0, true, planner) && right;
  return right ? 0 : 1;
}
