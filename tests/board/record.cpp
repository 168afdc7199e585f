// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Records a plan of the golden corpus on the board, and prints the record's bytes in hexadecimal: what an autopilot
// would save. record.py reads them.
#include "tern/record.hpp"

#include <cstddef>
#include <cstdint>

#include "baremetal/board.hpp"
#include "golden/corpus.hpp"
#include "tern_port/port.hpp"

namespace {

using tern_board::hex;
using tern_board::print;

constexpr int kScenario = 2;  // the third map
constexpr std::size_t kRoom = 64 * 1024;
constexpr std::size_t kBytesOfLine = 32;

TERN_BOARD_LARGE tern::Workspace workspace;
TERN_BOARD_LARGE std::uint64_t words[tern_golden::kGridWords];
TERN_BOARD_LARGE std::uint8_t bytes[kRoom];
tern_golden::Scenario scenario;
tern::Trajectory trajectory;

}  // namespace

int main() {
  tern::Planner planner(&workspace, sizeof workspace);
  tern::Grid grid;
  tern::Report report{};
  tern_golden::scenario(kScenario, scenario);
  if (tern_golden::build_grid(scenario, words, tern_golden::kGridWords, grid) != tern::Status::kOk) return 1;
  const tern::Status status = planner.plan(grid, scenario.request, trajectory, report);
  std::size_t used = 0;
  const tern::Status recorded = tern::record_plan(grid, scenario.request, status, trajectory, bytes, kRoom, &used);
  if (status != tern::Status::kOk || recorded != tern::Status::kOk) return 1;
  for (std::size_t k = 0; k < used; ++k) {
    print(k % kBytesOfLine == 0 ? "\nrecord " : "", hex(bytes[k], 2));
  }
  print("\n");
  return 0;
}
