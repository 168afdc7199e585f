// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_TESTS_GOLDEN_CORPUS_RUN_HPP
#define TERN_TESTS_GOLDEN_CORPUS_RUN_HPP

#include "golden/corpus.hpp"

namespace tern_golden {

/// What planning the corpus needs; too large for a stack.
struct Memory {
  std::uint64_t words[kGridWords];
  tern::Workspace workspace;
  Scenario scenario;
  tern::Trajectory trajectory;
};

struct Totals {
  std::uint64_t hash = kHashSeed;  ///< over every bit of every plan
  int plans = 0;                   ///< scenarios that have one
};

/// Plans every scenario; after each one calls see(index, status, report, hash so far).
template <typename See>
Totals run_corpus(Memory& memory, See see) {
  tern::Planner planner(&memory.workspace, sizeof memory.workspace);
  Totals totals;
  for (int i = 0; i < kScenarioCount; ++i) {
    tern::Grid grid;
    tern::Report report{};
    scenario(i, memory.scenario);
    tern::Status status = build_grid(memory.scenario, memory.words, kGridWords, grid);
    if (status == tern::Status::kOk) status = planner.plan(grid, memory.scenario.request, memory.trajectory, report);
    totals.hash = hash_plan(totals.hash, status, memory.trajectory);
    totals.plans += status == tern::Status::kOk ? 1 : 0;
    see(i, status, report, totals.hash);
  }
  return totals;
}

}  // namespace tern_golden

#endif
