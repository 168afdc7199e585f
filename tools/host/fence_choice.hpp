// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// More fences than a request takes: those that matter to one plan.
#ifndef TERN_HOST_FENCE_CHOICE_HPP
#define TERN_HOST_FENCE_CHOICE_HPP

#include <cstddef>
#include <memory>
#include <vector>

#include "host/scenario.hpp"
#include "tern/report.hpp"
#include "tern/trajectory.hpp"

namespace tern_host {

struct GridMap;

/// Begins with the keep-ins. A keep-out is added once a plan breaks it. Where a request takes no more, the keep-out
/// that was added first is marked in the grid instead, rounded outwards to voxels; those that hold for a while come
/// last, and are then closed at all times. A plan is proven clear of all fences, as they were given, by the certifier,
/// one after the other. Each fence is added once and marked once, so that there are at most twice as many plans as
/// fences.
class FenceChoice {
 public:
  /// Throws ScenarioError where the boundary does not fit a grid.
  explicit FenceChoice(const Scenario& scenario);
  ~FenceChoice();
  FenceChoice(const FenceChoice&) = delete;
  FenceChoice& operator=(const FenceChoice&) = delete;

  /// The scenario with the fences that were added so far.
  Scenario chosen() const;

  /// Proves the plan against each fence that the planner did not have, and adds the one that it breaks first. False if
  /// there is none: the plan is proven clear of all.
  bool add_broken(const tern::Trajectory& plan);

  /// Marks the keep-out that was added first in the grid: the planner has no room for it. False if there is none left.
  bool mark_first();

  /// The index among all fences of one of chosen(); kNoFence stays what it is.
  std::int32_t index_of(std::int32_t chosen) const;

 private:
  bool is_full() const;
  FenceRecord record(std::size_t i) const;
  double clear_until(const FenceRecord& record, const tern::Trajectory& plan) const;

  const Scenario& scenario_;
  std::unique_ptr<GridMap> map_;     // nothing in the boundary, for proofs
  std::vector<std::size_t> added_;   // in order
  std::vector<std::size_t> marked_;  // in the grid
  std::vector<bool> closed_;         // at all times
};

}  // namespace tern_host

#endif
