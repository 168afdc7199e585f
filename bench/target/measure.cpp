// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "target/measure.hpp"

#include <iterator>
#include <stdexcept>

#include "golden/corpus.hpp"
#include "stage_rows.hpp"
#include "target/realtime.hpp"
#include "tern_port/port.hpp"

namespace tern_target {
namespace {

using tern_bench::kStageRows;
using tern_host::PlanResult;

constexpr std::size_t kRowCount = std::size(kStageRows);

std::uint64_t bits_of(const PlanResult& result) {
  return tern_golden::hash_plan(tern_golden::kHashSeed, result.report.status, result.trajectory);
}

/// A series of plans of one scenario with one clock.
struct Series {
  PlanResult last;
  std::uint64_t bits = 0;
  std::vector<double> samples[kRowCount];  ///< in the unit of the clock
};

PlanResult plan_once(tern_host::Session& session, const tern_host::Scenario& scenario) {
  PlanResult result = session.plan(scenario);
  if (!result.ok()) throw std::runtime_error(scenario.name + ": no plan: " + tern::status_name(result.report.status));
  return result;
}

Series run_series(tern_host::Session& session, const tern_host::Scenario& scenario, int repetitions) {
  Series out;
  out.last = plan_once(session, scenario);  // the first one also brings pages in: it is not counted
  out.bits = bits_of(out.last);
  for (int i = 0; i < repetitions; ++i) {
    const std::uint64_t begin = tern_port::monotonic_nanoseconds();
    out.last = plan_once(session, scenario);
    if (bits_of(out.last) != out.bits) throw std::runtime_error(scenario.name + ": the same plan has different bits");
    for (std::size_t r = 0; r < kRowCount; ++r) out.samples[r].push_back(kStageRows[r].time(out.last));
    rest_after(1e-9 * static_cast<double>(tern_port::monotonic_nanoseconds() - begin));
  }
  return out;
}

Spread spread_of(const std::vector<double>& samples, double scale) {
  if (samples.empty()) return {};
  return {scale * tern_bench::quantile(samples, 0.5), scale * tern_bench::quantile(samples, 0.99),
          scale * tern_bench::quantile(samples, 1.0)};
}

Figures figures_of(std::size_t row, const Series& timed, const Series& counted) {
  constexpr double kNanoseconds = 1e3;  // in a microsecond
  Figures out{};
  out.stage = kStageRows[row].name;
  out.nanoseconds = spread_of(timed.samples[row], kNanoseconds);
  out.cycles = spread_of(counted.samples[row], 1.0);
  out.has_work = kStageRows[row].work != nullptr;
  if (!out.has_work) return out;
  out.work = kStageRows[row].work(timed.last)->work;
  out.bound = kStageRows[row].work(timed.last)->bound;
  return out;
}

}  // namespace

Measurement::Measurement()
    : cycle_counter_(tern_port::PerfCounter::Event::kCycles),
      counted_(tern_host::Clock{tern_port::perf_ticks, &cycle_counter_, 1e6}) {}

CaseFigures Measurement::measure(const tern_host::Scenario& scenario, int repetitions) {
  const Series timed = run_series(timed_, scenario, repetitions);
  const Series counted = has_cycles() ? run_series(counted_, scenario, repetitions) : Series{};
  if (has_cycles() && counted.bits != timed.bits) {
    throw std::runtime_error(scenario.name + ": the same plan has different bits");
  }
  CaseFigures out{scenario.name, timed.bits, {}};
  for (std::size_t r = 0; r < kRowCount; ++r) out.rows.push_back(figures_of(r, timed, counted));
  return out;
}

}  // namespace tern_target
