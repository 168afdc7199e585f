// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The work of a plan: what each stage did over all its runs, and what the request's budget has left.
#ifndef TERN_PLANNER_LEDGER_HPP
#define TERN_PLANNER_LEDGER_HPP

#include <cstdint>

#include "planner/problem.hpp"
#include "tern/diagnostics.hpp"
#include "tern/status.hpp"

namespace tern {

class Ledger {
 public:
  /// Empties the ledger. `timed`: there is a clock.
  void clear(bool timed) noexcept;
  /// A stage begins to run, perhaps once more.
  void begin_run(Stage stage) noexcept { before_ = work(stage); }
  /// The current run of the stage took `units` so far.
  void count(Stage stage, std::uint32_t units, const Problem& problem, bool searched_again) noexcept;
  /// A slice of the stage began and ended at these ticks of the clock.
  void count_ticks(Stage stage, std::uint64_t begin, std::uint64_t end) noexcept;

  std::uint32_t work(Stage stage) const noexcept { return stages_[static_cast<int>(stage)].work; }
  // What the stages have left of each budget.
  std::uint32_t expansions_left(const Budget& budget) const noexcept;
  std::uint32_t sight_lines_left(const Budget& budget) const noexcept;
  std::uint32_t planes_left(const Budget& budget) const noexcept;
  std::uint32_t iterations_left(const Budget& budget) const noexcept;

  /// Writes the stages' entries. Without a clock that ran, they have no ticks.
  void write(Diagnostics& diagnostics) const noexcept;

 private:
  StageReport stages_[kStageCount];
  std::uint32_t before_;  // work of the current stage when its current run began
  bool timed_;            // the clock ran so far
};

}  // namespace tern

#endif
