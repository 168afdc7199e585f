// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans the corpus and compares one hash over every bit of every plan with the recorded one (contract C3).
//   tern_golden            compare; exit status 0 where equal
//   tern_golden --each     print each scenario's status and running hash as well, to find where two builds part
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <memory>

#include "golden/corpus.hpp"
#include "golden/golden_hash.hpp"

namespace {

struct Memory {
  std::uint64_t words[tern_golden::kGridWords];
  tern::Workspace workspace;
  tern_golden::Scenario scenario;
  tern::Trajectory trajectory;
};

}  // namespace

int main(int argc, char** argv) {
  const bool each = argc > 1 && std::strcmp(argv[1], "--each") == 0;
  std::uint32_t faults = 0;
  if (tern::self_test(tern::configuration_hash(), &faults) != tern::Status::kOk) {
    std::printf("self-test failed: faults 0x%" PRIx32 "\n", faults);
    return 1;
  }
  const auto memory = std::make_unique<Memory>();
  tern::Planner planner(&memory->workspace, sizeof memory->workspace);
  std::uint64_t hash = tern_golden::kHashSeed;
  int ok = 0;
  for (int i = 0; i < tern_golden::kScenarioCount; ++i) {
    tern::Grid grid;
    tern::Report report;
    tern_golden::scenario(i, memory->scenario);
    tern::Status status = tern_golden::build_grid(memory->scenario, memory->words, tern_golden::kGridWords, grid);
    if (status == tern::Status::kOk) status = planner.plan(grid, memory->scenario.request, memory->trajectory, report);
    hash = tern_golden::hash_plan(hash, status, memory->trajectory);
    ok += status == tern::Status::kOk ? 1 : 0;
    if (each) {
      std::printf("%3d %-20s quality %d optimiser %-16s %016" PRIx64 "\n", i, tern::status_name(status),
                  static_cast<int>(report.quality), tern::status_name(report.optimiser), hash);
    }
  }
  std::printf("golden hash %016" PRIx64 ", recorded %016" PRIx64 ": %s; %d of %d scenarios have a plan\n", hash,
              tern_golden::kGoldenHash, hash == tern_golden::kGoldenHash ? "equal" : "DIFFERENT", ok,
              tern_golden::kScenarioCount);
  return hash == tern_golden::kGoldenHash ? 0 : 1;
}
