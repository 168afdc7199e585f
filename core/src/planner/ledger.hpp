// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The work of a plan: that of each stage over all its runs, and the rest of the request's budget.
#ifndef TERN_PLANNER_LEDGER_HPP
#define TERN_PLANNER_LEDGER_HPP

#include <cstdint>

#include "base/work.hpp"
#include "planner/goal_free.hpp"
#include "planner/moving.hpp"
#include "planner/problem.hpp"
#include "tern/diagnostics.hpp"
#include "tern/planner.hpp"
#include "tern/status.hpp"

namespace tern {

/// Contract C2: the most work of one run of a stage, known before it runs. It follows from capacities, and from the
/// size of the grid if a capacity would say far more.
struct StageBound {
  std::uint64_t pieces;  ///< the most pieces of work
  Operations piece;      ///< the most operations of one of them

  /// Units of `runs` runs.
  std::uint64_t units(std::uint64_t runs) const noexcept {
    return runs * pieces * (static_cast<std::uint64_t>(piece) / kUnit + 1);
  }
};

StageBound stage_bound(Stage stage, const GridSpec& spec) noexcept;
/// Of what the trajectory stage does besides for so many tracks.
StageBound around_bound(std::int32_t count) noexcept;
/// Of the floods in time for one leg of a plan, between vias.
StageBound timed_bound(std::int32_t count, const GridSpec& spec) noexcept;
/// Of the proof of one plan against so many tracks.
StageBound tracks_bound(std::int32_t count) noexcept;
/// Of such a proof against fences for a while, on top.
StageBound windows_bound() noexcept;

/// The most proofs of the stage that looks for a time.
constexpr int kTimedProofs = 2 * (kWaitingTries + kWaitHalvings) + 2 + kGoalLooks + kGoalHalvings;

/// A budget that is not limited: more than any plan takes.
constexpr std::uint32_t kNoBudget = 0xFFFFFFFFu;

/// The caller's clock; none if `now` is null.
struct Clock {
  ClockFn now;
  void* context;

  std::uint64_t ticks() const noexcept { return now != nullptr ? now(context) : 0; }
};

class Ledger {
 public:
  /// Empties the ledger.
  void clear(const Clock& clock) noexcept;
  /// A run of a stage begins.
  void enter() noexcept { is_bound_ = false; }
  void begin_slice() noexcept { slice_begin_ = clock_.ticks(); }
  /// The slice took these operations for the stage. The first slice of a run makes the stage's bound. The way has been
  /// made anew at most `remade` times.
  void count(Stage stage, Operations operations, const Problem& problem, std::uint32_t remade) noexcept;
  void end_slice(Stage stage) noexcept;

  Operations spent(Stage stage) const noexcept { return spent_[static_cast<int>(stage)]; }
  /// The operations that the budget has left for the stage; 0 or less if it is spent. Some stages share a budget.
  Operations left(Stage stage, const Budget& budget) const noexcept;

  /// Writes the stages' entries. Without a clock that ran, they have no ticks.
  void write(Diagnostics& diagnostics) const noexcept;

 private:
  StageReport stages_[kStageCount];
  Operations spent_[kStageCount];
  Clock clock_;
  std::uint64_t slice_begin_;  // ticks
  bool is_bound_;              // the bound of the current run is made
  bool timed_;                 // the clock ran so far
};

}  // namespace tern

#endif
