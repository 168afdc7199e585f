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

#include "golden/corpus_run.hpp"
#include "golden/fmu_corpus.hpp"
#include "golden/golden_hash.hpp"

namespace {

void print_scenario(int index, tern::Status status, const tern::Report& report, std::uint64_t hash) {
  std::printf("%3d %-20s quality %d optimiser %-16s %016" PRIx64 "\n", index, tern::status_name(status),
              static_cast<int>(report.quality), tern::status_name(report.optimiser), hash);
}

}  // namespace

int main(int argc, char** argv) {
  const bool each = argc > 1 && std::strcmp(argv[1], "--each") == 0;
  std::uint32_t faults = 0;
  if (tern::self_test(tern::configuration_hash(), &faults) != tern::Status::kOk) {
    std::printf("self-test failed: faults 0x%" PRIx32 "\n", faults);
    return 1;
  }
  const auto memory = std::make_unique<tern_golden::Memory>();
  std::uint64_t fmu_hash = tern_golden::kHashSeed;
  const auto see = [&](int index, tern::Status status, const tern::Report& report, std::uint64_t hash) {
    if (each) print_scenario(index, status, report, hash);
    if (tern_golden::is_fmu_scenario(index)) fmu_hash = tern_golden::hash_plan(fmu_hash, status, memory->trajectory);
  };
  const tern_golden::Totals totals = tern_golden::run_corpus(*memory, see);
  const bool equal = totals.hash == tern_golden::kGoldenHash;
  std::printf("golden hash %016" PRIx64 ", recorded %016" PRIx64 ": %s; %d of %d scenarios have a plan\n", totals.hash,
              tern_golden::kGoldenHash, equal ? "equal" : "DIFFERENT", totals.plans, tern_golden::kScenarioCount);
  const bool fmu_equal = fmu_hash == tern_golden::kFmuHash;
  std::printf("of the profile fmu's %d scenarios: %016" PRIx64 ", recorded %016" PRIx64 ": %s\n",
              tern_golden::kFmuScenarioCount, fmu_hash, tern_golden::kFmuHash, fmu_equal ? "equal" : "DIFFERENT");
  return equal && fmu_equal ? 0 : 1;
}
