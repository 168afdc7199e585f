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
constexpr double kNear = 20.0;  ///< m: the whole crowd is
constexpr bool kCrowds = tern::kMaxNeighbours >= 10;
constexpr tern_golden::FleetSetting kGolden{};
constexpr tern_golden::FleetSetting kCrowd{11, 10, 100, 50};
constexpr int kMembers = kCrowds ? kCrowd.members : kGolden.members;

TERN_BOARD_LARGE tern_golden::FleetRunMemory<kMembers> memory;

/// Ten neighbours by list, or by range if `join` is not 0. Without a fault, true.
bool crowds(const char* name, double join) {
  tern_golden::FleetSetting setting = kCrowd;
  setting.join = join;
  const tern_golden::FleetTotals crowd = tern_golden::fly_fleet(setting, memory, tern_board::counter);
  print(name, crowd.most, " ", tern_board::counter_unit(), " a tick at most, ",
        crowd.sum / static_cast<std::uint64_t>(kCrowd.ticks * kCrowd.members), " in the mean, ", crowd.most_units,
        " units of proofs; ", crowd.taken, " of ", crowd.announced, " plans taken over\n");
  const bool counts = tern_board::counter_unit()[0] == 'i';  // "instructions retired", not a timer's cycles
  return !counts || crowd.most <= kMostInstructions;
}

bool has_hash(const char* name, double join, std::uint64_t recorded) {
  tern_golden::FleetSetting setting = kGolden;
  setting.join = join;
  const tern_golden::FleetTotals totals = tern_golden::fly_fleet(setting, memory, tern_board::counter);
  const bool equal = totals.hash == recorded;
  print(name, hex(totals.hash, 16), ", recorded ", hex(recorded, 16), equal ? ": equal; " : ": DIFFERENT; ",
        totals.taken, " of ", totals.announced, " plans taken over\n");
  return equal;
}

}  // namespace

int main() {
  print(tern_board::name(), "\n");
  tern_board::paint_stack();
  bool is_fine = has_hash("fleet hash ", 0.0, tern_golden::kGoldenFleetHash);
  is_fine = has_hash("by range ", tern_golden::kGoldenJoin, tern_golden::kGoldenFleetRangeHash) && is_fine;
  print("memory: ", sizeof(tern::Fleet), " bytes a fleet; stack high water ", tern_board::stack_used(), " bytes\n");
  if constexpr (kCrowds) {
    is_fine = crowds("ten neighbours: ", 0.0) && is_fine;
    is_fine = crowds("ten neighbours by range: ", kNear) && is_fine;
  }
  return is_fine ? 0 : 1;
}
