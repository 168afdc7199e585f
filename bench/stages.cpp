// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How long each stage takes on each of the paper's maps. One repetition is one whole plan; the time of a row is that
// stage's, by the planner's own report, so that a stage is measured with the caches and inputs that it has in a plan.
// Median, p99 and max over the repetitions; counters tell the stage's work and its bound. On a board that has no Google
// Benchmark, tern_target_bench measures the same rows.
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "host/session.hpp"
#include "stage_rows.hpp"

namespace {

using tern_bench::quantile;
using tern_bench::StageRow;

constexpr int kRepetitions = 100;

/// Runs the plan and hands the row's part of it to the benchmark as its time.
void run(benchmark::State& state, const tern_host::Scenario& scenario, const StageRow& row) {
  static tern_host::Session session;
  for (auto _ : state) {
    const tern_host::PlanResult result = session.plan(scenario);
    if (!result.ok()) state.SkipWithError(tern::status_name(result.report.status));
    state.SetIterationTime(1e-6 * row.time(result));
    if (row.work == nullptr) continue;
    state.counters["work"] = static_cast<double>(row.work(result)->work);
    state.counters["bound"] = static_cast<double>(row.work(result)->bound);
  }
}

void add(const std::string& name, const tern_host::Scenario& scenario, const StageRow& row) {
  const auto body = [scenario, row](benchmark::State& state) { run(state, scenario, row); };
  benchmark::RegisterBenchmark((name + "/" + row.name).c_str(), body)
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond)
      ->Iterations(1)
      ->Repetitions(kRepetitions)
      ->ReportAggregatesOnly(true)
      ->ComputeStatistics("p99", [](const std::vector<double>& v) { return quantile(v, 0.99); })
      ->ComputeStatistics("max", [](const std::vector<double>& v) { return quantile(v, 1.0); });
}

}  // namespace

int main(int argc, char** argv) {
  for (int map = 1; map <= 6; ++map) {
    const std::string name = "map" + std::to_string(map);
    const tern_host::Scenario scenario = tern_host::read_scenario(std::string(TERN_MAPS_DIR) + "/" + name + ".txt");
    for (const StageRow& row : tern_bench::kStageRows) add(name, scenario, row);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
