// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds a proven brake that leaves a draft at the end of its proof, or earlier.
#ifndef TERN_FLIGHT_BRANCH_SEARCH_HPP
#define TERN_FLIGHT_BRANCH_SEARCH_HPP

#include "base/progress.hpp"
#include "base/work.hpp"
#include "flight/branch.hpp"
#include "flight/draft.hpp"
#include "flight/flight_facts.hpp"

namespace tern {

/// Instants of a plan at which brakes are tried, and the brakes at each instant, the sharpest first. Sharp brakes need
/// the least room, but the sharpest may break the limits on jerk.
constexpr int kBranches = 16;
constexpr int kBranchShapes = kStops;

struct BranchSearch {
  double reached;   ///< until when the draft is proven, in seconds since its beginning
  int candidate;    ///< the number of the branch that was made last
  bool is_proving;  ///< that branch is being proven

  void begin(double until) noexcept;
  /// kDone: the draft branches off, and its brake is proven. kFailed: no candidate is left. May be called again after
  /// kDone, for the candidates that follow.
  Progress advance(const FlightFacts& flight, const Vec3& start, Draft& draft, Work& work) noexcept;

 private:
  bool make_candidate(const FlightFacts& flight, const Vec3& start, Draft& draft, Work& work) const noexcept;
};

/// True if a draft from `start` leads anywhere: a hop of less than a voxel from rest is no progress.
bool leads_on(const FlightFacts& flight, const Vec3& start, const Draft& draft) noexcept;

}  // namespace tern

#endif
