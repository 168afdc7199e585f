// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How long each stage takes on each of the paper's maps. One repetition is one whole plan; the time of a row is that
// stage's, by the planner's own report, so that a stage is measured with the caches and inputs that it has in a plan.
// Median, p99 and max over the repetitions; counters tell the stage's work and its bound.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host/session.hpp"

namespace {

using tern::Stage;

constexpr int kRepetitions = 100;

struct Row {
  const char* name;
  Stage stage;
};
constexpr Row kRows[] = {{"search", Stage::kSearch},
                         {"shortcut", Stage::kShortcut},
                         {"corridor", Stage::kCorridor},
                         {"trajectory", Stage::kTrajectory},
                         {"check", Stage::kCheck}};

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
}

/// Runs the plan and hands `microseconds` of it to the benchmark as its time.
template <typename Microseconds>
void run(benchmark::State& state, const tern_host::Scenario& scenario, Microseconds microseconds) {
  static tern_host::Session session;
  for (auto _ : state) {
    const tern_host::PlanResult result = session.plan(scenario);
    if (!result.ok()) state.SkipWithError(tern::status_name(result.report.status));
    state.SetIterationTime(1e-6 * microseconds(result, state));
  }
}

/// Registers a row whose time is `microseconds(result, state)` of each plan.
template <typename Microseconds>
void add(const std::string& name, const tern_host::Scenario& scenario, Microseconds microseconds) {
  const auto body = [scenario, microseconds](benchmark::State& state) { run(state, scenario, microseconds); };
  benchmark::RegisterBenchmark(name.c_str(), body)
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond)
      ->Iterations(1)
      ->Repetitions(kRepetitions)
      ->ReportAggregatesOnly(true)
      ->ComputeStatistics("p99", [](const std::vector<double>& v) { return quantile(v, 0.99); })
      ->ComputeStatistics("max", [](const std::vector<double>& v) { return quantile(v, 1.0); });
}

double stage_time(const tern_host::PlanResult& result, benchmark::State& state, Stage stage) {
  const tern::StageReport& report = result.report.stages[static_cast<int>(stage)];
  state.counters["work"] = report.work;
  state.counters["bound"] = report.bound;
  return result.timing.of(stage);
}

void add_map(const std::string& name, const tern_host::Scenario& scenario) {
  using tern_host::PlanResult;
  add(name + "/inflate", scenario, [](const PlanResult& result, benchmark::State&) { return result.timing.inflate; });
  for (const Row& row : kRows) {
    const Stage stage = row.stage;
    add(name + "/" + row.name, scenario,
        [stage](const PlanResult& result, benchmark::State& state) { return stage_time(result, state, stage); });
  }
  add(name + "/total", scenario, [](const PlanResult& result, benchmark::State&) { return result.timing.total(); });
}

}  // namespace

int main(int argc, char** argv) {
  for (int map = 1; map <= 6; ++map) {
    const std::string name = "map" + std::to_string(map);
    add_map(name, tern_host::read_scenario(std::string(TERN_MAPS_DIR) + "/" + name + ".txt"));
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
