// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The timing gate's image: plans every case of the corpus in one call, then again one unit of work at a time, and
// prints as CSV what each stage and the longest unit counted; then yaw plans, the jobs of rolling maps, a far way, and
// the longest ticks of flights. Lines that begin with # are notes. What the figures mean and leave out is in
// docs/timing.md.
#include <cstdint>

#include "baremetal-aarch64/counters.hpp"
#include "baremetal/board.hpp"
#include "golden/flight_run.hpp"
#include "golden/flight_ticks.hpp"
#include "tern_port/port.hpp"
#include "timing/case_grid.hpp"
#include "timing/far_rows.hpp"
#include "timing/hard_flights.hpp"
#include "timing/map_rows.hpp"
#include "timing/yaw_rows.hpp"

namespace {

using tern_board::print;
using tern_timing::Case;

/// Grids up to 16 M voxels.
constexpr std::size_t kGridWords = 2 * 16 * 1024 * 1024 / 64;

/// The flights use its workspace for the cases, too.
TERN_BOARD_LARGE tern_timing::FlightMemory flight_memory;
tern::Workspace& workspace = flight_memory.workspace;
TERN_BOARD_LARGE std::uint64_t words[kGridWords];
tern::Trajectory trajectory;

/// What a case cost beside the stages that the report counts.
struct Cost {
  std::uint64_t mark = 0;
  std::uint64_t inflate = 0;
  std::uint64_t plan = 0;             // the whole call
  std::uint64_t path_unit = 0;        // the longest unit of search and shortcut
  std::uint64_t corridor_unit = 0;    // of the corridor
  std::uint64_t trajectory_unit = 0;  // of trajectory, tracks and check
  std::uint64_t proof = 0;            // of the plan against its tracks, alone
  std::uint32_t proof_work = 0;
  std::size_t stack = 0;
};

tern::Status build(const Case& input, tern::Grid& grid, Cost& cost) {
  const tern::Status status = grid.bind(tern_timing::spec_of(input), words, kGridWords);
  if (status != tern::Status::kOk) return status;
  const std::uint64_t begin = tern_board::counter();
  for (int b = 0; b < input.block_count; ++b) grid.mark_box(input.blocks[b]);
  const std::uint64_t marked = tern_board::counter();
  grid.inflate();
  cost.mark = marked - begin;
  cost.inflate = tern_board::counter() - marked;
  return status;
}

/// Finds the longest units; a slice belongs to the stage that it began in.
tern::Status plan_in_units(const Case& input, const tern::Grid& grid, tern::Planner& planner, Cost& cost) {
  tern::Status status = planner.begin(grid, input.request);
  while (status == tern::Status::kRunning) {
    std::uint64_t& longest = planner.corridor() != nullptr ? cost.trajectory_unit
                             : planner.path() != nullptr   ? cost.corridor_unit
                                                           : cost.path_unit;
    const std::uint64_t begin = tern_board::counter();
    status = planner.step(1);
    const std::uint64_t count = tern_board::counter() - begin;
    if (count > longest) longest = count;
  }
  tern::Report report;
  return planner.finish(trajectory, report);
}

/// The proof against the tracks alone, from the plan's beginning to its end.
void prove_tracks(const Case& input, Cost& cost) {
  tern::TrackGrounds grounds;
  grounds.tracks = input.request.tracks;
  grounds.count = input.request.track_count;
  grounds.radius = input.radius;
  tern::ProofReport report;
  const std::uint64_t begin = tern_board::counter();
  tern::clear_until(trajectory, 0.0, grounds, &report);
  cost.proof = tern_board::counter() - begin;
  cost.proof_work = report.work;
}

tern::Status run(const Case& input, tern::Planner& planner, tern::Report& report, Cost& cost) {
  tern::Grid grid;
  const tern::Status status = build(input, grid, cost);
  if (status != tern::Status::kOk) return status;
  tern_board::paint_stack();
  const std::uint64_t begin = tern_board::counter();
  const tern::Status whole = planner.plan(grid, input.request, trajectory, report);
  cost.plan = tern_board::counter() - begin;
  cost.stack = tern_board::stack_used();
  if (whole != tern::Status::kOk) return whole;
  if (input.request.track_count > 0) prove_tracks(input, cost);
  return plan_in_units(input, grid, planner, cost);
}

void row(const Case& input, const char* stage, std::uint64_t count, std::uint64_t work, std::uint64_t bound) {
  print(input.name, ",", stage, ",", count, ",", work, ",", bound, "\n");
}

void report_case(const Case& input, tern::Status status, const tern::Report& report, const Cost& cost) {
  const tern::HighWater& high = report.diagnostics.high_water;
  print("# ", input.name, ": ", tern::status_name(status), ", optimiser ", tern::status_name(report.optimiser),
        "; nodes ", high.nodes, " heap ", high.open, " segments ", high.segments, " planes ", high.planes, " boxes ",
        high.local_boxes, " active ", high.active, " iterations ", high.qp_iterations, " solves ", high.qp_solves,
        " stack ", cost.stack, "\n");
  row(input, "mark", cost.mark, static_cast<std::uint32_t>(input.block_count), 0);
  row(input, "inflate", cost.inflate, 0, 0);
  for (int s = 1; s < tern::kStageCount; ++s) {
    const tern::StageReport& stage = report.diagnostics.stages[s];
    if (stage.bound == 0) continue;  // did not run
    row(input, tern::stage_name(static_cast<tern::Stage>(s)), stage.ticks, stage.work, stage.bound);
  }
  row(input, "plan", cost.plan, 0, 0);
  if (input.request.track_count > 0) row(input, "tracks proof", cost.proof, cost.proof_work, 0);
  row(input, "path unit", cost.path_unit, 1, 1);
  row(input, "corridor unit", cost.corridor_unit, 1, 1);
  row(input, "trajectory unit", cost.trajectory_unit, 1, 1);
}

/// Flies once, and prints the longest tick of each kind.
bool fly(const char* name, const tern_golden::FlightSetting& setting) {
  static tern_golden::PillarCamera camera;
  camera = tern_golden::PillarCamera{};
  tern_golden::TickCosts costs;
  const auto see = [&costs](const tern::FlightReport& before, const tern::FlightReport& report, std::uint64_t count) {
    costs.add(before, report, count);
  };
  const tern_golden::FlightTotals totals =
      tern_golden::fly(setting, flight_memory, camera, camera.world, tern_board::counter, see);
  print("# ", name, ": ", tern::status_name(totals.started), ", ", totals.committed, " commits, at the goal in tick ",
        totals.arrived, "\n");
  tern_timing::print_ticks(name, costs, setting.work_per_tick);
  return totals.arrived > 0;
}

/// Under -icount shift=0 a cycle is an instruction, and the cycle counter has 64 bits: where the two part, the
/// instruction counter's overflow was missed and the figures are wrong.
bool counters_agree() {
  constexpr std::uint64_t kReading = 4096;
  const std::uint64_t instructions = tern_board::instructions();
  const bool agree = tern_board::cycles() - instructions < kReading;
  if (!agree) print("# the counter lost an overflow: some stage took more than 2^31 instructions\n");
  return agree;
}

}  // namespace

int main() {
  print("# ", tern_board::name(), ", ", tern_board::counter_unit(), "\n# compiler ", __VERSION__, "\n");
  tern::Planner planner(&workspace, sizeof workspace);
  planner.set_clock(tern_port::ticks, nullptr);
  print("scenario,stage,count,work,bound\n");
  static tern_timing::YawRows yaw_rows;
  bool all_planned = true;
  for (int i = 0; i < tern_timing::kCaseCount; ++i) {
    const Case& input = tern_timing::kCases[i];
    tern::Report report{};
    Cost cost;
    const tern::Status status = run(input, planner, report, cost);
    report_case(input, status, report, cost);
    all_planned = all_planned && status == tern::Status::kOk && yaw_rows.add(trajectory);
  }
  yaw_rows.print();
  const bool all_mapped = tern_timing::print_map_rows();
  const bool led = tern_timing::print_far_rows(workspace);
  const bool flown = fly("flight_mcu", tern_golden::kSmallFlight) && fly("flight", tern_golden::kFullFlight) &&
                     tern_timing::print_hard_flights(flight_memory);
  return all_planned && all_mapped && led && flown && counters_agree() ? 0 : 1;
}
