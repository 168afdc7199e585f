// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The golden fleet without an operating system: the same packets, answers and places as on every host, bit for bit.
// With room for ten neighbours, also what a vehicle's tick takes among them, which must not exceed its budget where
// instructions are counted.
#include <cstdint>

#include "baremetal/board.hpp"
#include "golden/fleet_run.hpp"
#include "golden/golden_hash.hpp"

namespace {

using tern_board::hex;
using tern_board::print;

/// Of receiving what came, proving, deciding and sending.
constexpr std::uint64_t kMostInstructions = 500000;
constexpr bool kCrowds = tern::kMaxNeighbours >= 10;
constexpr tern_golden::FleetSetting kGolden{};
constexpr tern_golden::FleetSetting kCrowd{11, 10, 100, 50};
constexpr int kMembers = kCrowds ? kCrowd.members : kGolden.members;

TERN_BOARD_LARGE tern_golden::FleetRunMemory<kMembers> memory;

/// Without a fault, true.
bool crowds() {
  const tern_golden::FleetTotals crowd = tern_golden::fly_fleet(kCrowd, memory, tern_board::counter);
  print("ten neighbours: ", crowd.most, " ", tern_board::counter_unit(), " a tick at most, ",
        crowd.sum / static_cast<std::uint64_t>(kCrowd.ticks * kCrowd.members), " in the mean, ", crowd.most_units,
        " units of proofs; ", crowd.taken, " of ", crowd.announced, " plans taken over\n");
  const bool counts = tern_board::counter_unit()[0] == 'i';  // "instructions retired", not a timer's cycles
  return !counts || crowd.most <= kMostInstructions;
}

}  // namespace

int main() {
  print(tern_board::name(), "\n");
  tern_board::paint_stack();
  const tern_golden::FleetTotals totals = tern_golden::fly_fleet(kGolden, memory, tern_board::counter);
  const std::size_t stack = tern_board::stack_used();
  const bool equal = totals.hash == tern_golden::kGoldenFleetHash;
  print("fleet hash ", hex(totals.hash, 16), ", recorded ", hex(tern_golden::kGoldenFleetHash, 16),
        equal ? ": equal; " : ": DIFFERENT; ", totals.taken, " of ", totals.announced, " plans taken over\n");
  print("memory: ", sizeof(tern::Fleet), " bytes a fleet; stack high water ", stack, " bytes\n");
  bool within = true;
  if constexpr (kCrowds) within = crowds();
  return equal && within ? 0 : 1;
}
