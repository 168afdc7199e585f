// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The work of a plan: what each stage did over all its runs, and what the request's budget has left.
#ifndef TERN_PLANNER_LEDGER_HPP
#define TERN_PLANNER_LEDGER_HPP

#include <cstdint>

#include "base/work.hpp"
#include "planner/problem.hpp"
#include "tern/diagnostics.hpp"
#include "tern/status.hpp"

namespace tern {

class Ledger {
 public:
  /// Empties the ledger. `timed`: there is a clock.
  void clear(bool timed) noexcept;
  /// A run of a stage begins.
  void enter() noexcept { is_bound_ = false; }
  /// A slice of the stage took `operations`. The first slice of a run makes the stage's bound.
  void count(Stage stage, Operations operations, const Problem& problem, bool searched_again) noexcept;
  /// A slice of the stage began and ended at these ticks of the clock.
  void count_ticks(Stage stage, std::uint64_t begin, std::uint64_t end) noexcept;

  Operations spent(Stage stage) const noexcept { return spent_[static_cast<int>(stage)]; }
  /// What the budget has left for the stage; not more than 0 if it is spent. Some stages share a budget.
  Operations left(Stage stage, const Budget& budget) const noexcept;

  /// Writes the stages' entries. Without a clock that ran, they have no ticks.
  void write(Diagnostics& diagnostics) const noexcept;

 private:
  StageReport stages_[kStageCount];
  Operations spent_[kStageCount];
  bool is_bound_;  // the bound of the current run is made
  bool timed_;     // the clock ran so far
};

}  // namespace tern

#endif
