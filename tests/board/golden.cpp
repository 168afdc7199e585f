// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The golden corpus without an operating system (contract C3): the same hash as on every host, from the firmware build.
//   board_golden            compare; exit status 0 where equal
//   board_golden --each     print each scenario's status and running hash as well, to find where two builds part
#include <cstdint>

#include "baremetal/board.hpp"
#include "golden/corpus.hpp"
#include "golden/fmu_corpus.hpp"
#include "golden/golden_hash.hpp"
#include "tern_port/port.hpp"

namespace {

using tern_board::column;
using tern_board::hex;
using tern_board::print;

// The profile fmu plans the part of the corpus that fits it.
#ifdef TERN_PROFILE_FMU
constexpr std::size_t kGridWords = tern_golden::kFmuGridWords;
constexpr int kCount = tern_golden::kFmuScenarioCount;
constexpr std::uint64_t kHash = tern_golden::kFmuHash;
constexpr int index_of(int k) {
  return tern_golden::kFmuScenarios[k];
}
static_assert(sizeof(tern::Workspace) + sizeof(std::uint64_t) * kGridWords <= tern_golden::kFmuBytes,
              "what the profile promises");
#else
constexpr std::size_t kGridWords = tern_golden::kGridWords;
constexpr int kCount = tern_golden::kScenarioCount;
constexpr std::uint64_t kHash = tern_golden::kGoldenHash;
constexpr int index_of(int k) {
  return k;
}
#endif

TERN_BOARD_LARGE tern::Workspace workspace;
TERN_BOARD_LARGE std::uint64_t words[kGridWords];
tern_golden::Scenario scenario;
tern::Trajectory trajectory;

/// What all plans of the corpus come to.
struct Totals {
  std::uint64_t hash = tern_golden::kHashSeed;
  int plans = 0;
  std::uint64_t ticks = 0;
  std::uint64_t most_ticks = 0;
  int slowest = 0;
  std::size_t stack = 0;
};

/// Everything of one plan is on this stack and below it, so its high-water mark is the planner's.
__attribute__((noinline)) tern::Status plan(tern::Planner& planner, tern::Report& report) {
  tern::Grid grid;
  const tern::Status status = tern_golden::build_grid(scenario, words, kGridWords, grid);
  return status == tern::Status::kOk ? planner.plan(grid, scenario.request, trajectory, report) : status;
}

void run(int index, tern::Planner& planner, bool each, Totals& totals) {
  tern::Report report{};
  tern_golden::scenario(index, scenario);
  tern_board::paint_stack();
  const std::uint64_t before = tern_board::counter();
  const tern::Status status = plan(planner, report);
  const std::uint64_t ticks = tern_board::counter() - before;
  const std::size_t stack = tern_board::stack_used();
  totals.hash = tern_golden::hash_plan(totals.hash, status, trajectory);
  totals.plans += status == tern::Status::kOk ? 1 : 0;
  totals.ticks += ticks;
  if (ticks > totals.most_ticks) {
    totals.most_ticks = ticks;
    totals.slowest = index;
  }
  if (stack > totals.stack) totals.stack = stack;
  if (!each) return;
  print(column(static_cast<std::uint64_t>(index), 3), " ", column(tern::status_name(status), 20), " quality ",
        static_cast<int>(report.quality), " optimiser ", column(tern::status_name(report.optimiser), 16), " ",
        hex(totals.hash, 16), "\n");
}

bool is_each(const char* text) {
  const char* const expected = "--each";
  int i = 0;
  while (expected[i] != '\0' && text[i] == expected[i]) ++i;
  return expected[i] == text[i];
}

}  // namespace

int main(int argc, char** argv) {
  print(tern_board::name(), "\n");
  std::uint32_t faults = 0;
  if (tern::self_test(tern::configuration_hash(), &faults) != tern::Status::kOk) {
    print("self-test failed: faults 0x", hex(faults, 2), "\n");
    return 1;
  }
  tern::Planner planner(&workspace, sizeof workspace);
  Totals totals;
  const bool each = argc > 1 && is_each(argv[1]);
  for (int k = 0; k < kCount; ++k) run(index_of(k), planner, each, totals);
  const bool equal = totals.hash == kHash;
  print("golden hash ", hex(totals.hash, 16), ", recorded ", hex(kHash, 16), equal ? ": equal; " : ": DIFFERENT; ",
        totals.plans, " of ", kCount, " scenarios have a plan\n");
  print("memory: workspace ", sizeof workspace, ", grid ", sizeof words, ", trajectory ", sizeof trajectory,
        "; stack high water ", totals.stack, " of ", tern_board::stack_size(), " bytes\n");
  print("grid and plan: ", totals.ticks, " ", tern_board::counter_unit(), " in all, ", totals.most_ticks,
        " at most (scenario ", totals.slowest, ")\n");
  return equal ? 0 : 1;
}
