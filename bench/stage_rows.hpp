// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the tables of times have in common: their rows, and how a row's samples become figures.
#ifndef TERN_BENCH_STAGE_ROWS_HPP
#define TERN_BENCH_STAGE_ROWS_HPP

#include "host/session.hpp"
#include "quantile.hpp"

namespace tern_bench {

/// A stage, or what stands around the stages.
struct StageRow {
  const char* name;
  /// What the row took in one plan, in the unit of the session's clock.
  double (*time)(const tern_host::PlanResult& result);
  /// The stage's work and its bound; null for a row that counts none.
  const tern::StageReport* (*work)(const tern_host::PlanResult& result);
};

namespace rows {

using tern_host::PlanResult;

inline double inflate(const PlanResult& result) {
  return result.timing.inflate;
}
inline double total(const PlanResult& result) {
  return result.timing.total();
}
template <tern::Stage kStage>
double time_of(const PlanResult& result) {
  return result.timing.of(kStage);
}
template <tern::Stage kStage>
const tern::StageReport* work_of(const PlanResult& result) {
  return &result.report.diagnostics.stages[static_cast<int>(kStage)];
}
template <tern::Stage kStage>
constexpr StageRow stage(const char* name) {
  return {name, time_of<kStage>, work_of<kStage>};
}

}  // namespace rows

constexpr StageRow kStageRows[] = {{"inflate", rows::inflate, nullptr},
                                   rows::stage<tern::Stage::kSearch>("search"),
                                   rows::stage<tern::Stage::kShortcut>("shortcut"),
                                   rows::stage<tern::Stage::kCorridor>("corridor"),
                                   rows::stage<tern::Stage::kTrajectory>("trajectory"),
                                   rows::stage<tern::Stage::kCheck>("check"),
                                   {"total", rows::total, nullptr}};

}  // namespace tern_bench

#endif
