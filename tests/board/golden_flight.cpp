// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The golden flight without an operating system (contract F5): the same commands as on every host, bit for bit; and
// what its ticks took.
#include <cstdint>

#include "baremetal/board.hpp"
#include "golden/flight_run.hpp"
#include "golden/flight_ticks.hpp"
#include "golden/golden_hash.hpp"

namespace {

using tern_board::hex;
using tern_board::print;

TERN_BOARD_LARGE tern_golden::FlightMemory<20000, 48000 + 25 * tern::kMaxFlightPieces> memory;
tern_golden::PillarCamera camera;
tern_golden::TickCosts costs;

}  // namespace

int main() {
  print(tern_board::name(), "\n");
  const auto see = [](const tern::FlightReport& before, const tern::FlightReport& report, std::uint64_t count) {
    costs.add(before, report, count);
  };
  tern_board::paint_stack();
  const tern_golden::FlightTotals totals =
      tern_golden::fly(tern_golden::kSmallFlight, memory, camera, camera.world, tern_board::counter, see);
  const std::size_t stack = tern_board::stack_used();
  const bool equal = totals.hash == tern_golden::kGoldenFlightHash;
  print("flight hash ", hex(totals.hash, 16), ", recorded ", hex(tern_golden::kGoldenFlightHash, 16),
        equal ? ": equal; " : ": DIFFERENT; ", totals.committed, " commits, at the goal in tick ", totals.arrived,
        "\n");
  print("memory: map and flight ", sizeof memory.map + sizeof memory.flight, "; stack high water ", stack, " bytes\n");
  for (int k = 0; k < tern_golden::kTickKinds; ++k) {
    print(tern_golden::kTickNames[k], ": ", costs.most[k].count, " ", tern_board::counter_unit(), " at most, ",
          costs.most[k].work, " units\n");
  }
  return equal && totals.started == tern::Status::kOk ? 0 : 1;
}
