// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The plan that a programme's solution stands for, and the best plan so far.
#ifndef TERN_TRAJECTORY_CANDIDATE_HPP
#define TERN_TRAJECTORY_CANDIDATE_HPP

#include "base/bounds.hpp"
#include "tern/corridor.hpp"
#include "tern/request.hpp"
#include "tern/trajectory.hpp"
#include "times/chain.hpp"

namespace tern {

/// The chain's segments with control points of their own: chain.count rows, local frame. Both must outlive it.
struct Candidate {
  const Chain& chain;
  const Vec3 (*points)[kControlPoints];
};

/// A segment, before any stretch.
Segment segment_of(const Candidate& candidate, int index) noexcept;

/// Relative accuracy of a plan's body rates.
constexpr double kRateAccuracy = 1e-4;

/// Integral of squared snap, m^2/s^7.
double snap_of(const Candidate& candidate) noexcept;

/// The factor by which all durations must be multiplied for the peaks to meet the limits exactly. Only for plans from
/// rest to rest.
double stretch_to_limits(const Candidate& candidate, const MotionLimits& limits) noexcept;

/// True if the candidate, stretched by the factor, stays in its polyhedra and within the limits.
bool keeps_everything(const Candidate& candidate, double factor, const Corridor& corridor,
                      const MotionLimits& limits) noexcept;

/// The best plan so far: its control points and durations; the chain has its polyhedra.
struct BestPlan {
  bool found;
  double duration[kMaxSegments];  ///< before the refinement's stretch
  Vec3 points[kMaxSegments][kControlPoints];
  double kkt_residual;
};

/// Copies the candidate into the best plan.
void keep(const Candidate& candidate, BestPlan& best) noexcept;

/// Writes the best plan, stretched by the factor, to count and segments of `out`. `chain` has the polyhedra of the plan
/// that was kept.
void give_out(const BestPlan& best, double factor, const Chain& chain, Trajectory& out) noexcept;

}  // namespace tern

#endif
