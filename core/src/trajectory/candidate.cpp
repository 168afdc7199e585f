// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/candidate.hpp"

#include "base/math.hpp"
#include "curve/bezier.hpp"
#include "curve/body_rate.hpp"
#include "curve/motion_limits.hpp"

namespace tern {
namespace {

/// How often a plan is stretched for its body rates before the stretch that surely suffices.
constexpr int kRateStretches = 8;
/// A stretch by less than this part more than needed is good enough.
constexpr double kEnough = 1e-3;

/// The largest body rate of the plan with this stretch.
double peak_rate(const Candidate& candidate, double stretch) {
  double peak = 0.0;
  for (int i = 0; i < candidate.chain.count; ++i) {
    Segment segment = segment_of(candidate, i);
    segment.duration *= stretch;
    peak = larger(peak, peak_rate(segment, peak, kRateAccuracy));
  }
  return peak;
}

/// Stretches the plan further until its body rates keep the limit. A rate falls with the first to the third power of
/// the stretch, so the square root of the excess comes closer from either side.
double stretch_to_rate(const Candidate& candidate, double least, double limit) {
  double factor = least;
  for (int i = 0; i < kRateStretches; ++i) {
    const double excess = peak_rate(candidate, factor) / limit;
    if (excess <= 1.0 && (factor <= least || excess >= 1.0 - kEnough)) return factor;
    factor = larger(least, factor * square_root((1.0 + 0.5 * kEnough) * excess));
  }
  return factor * larger(1.0, peak_rate(candidate, factor) / limit);
}

}  // namespace

Segment segment_of(const Candidate& candidate, int index) noexcept {
  Segment segment;
  segment.duration = candidate.chain.duration[index];
  segment.polyhedron = candidate.chain.polyhedron[index];
  for (int k = 0; k < kControlPoints; ++k) segment.points[k] = candidate.points[index][k];
  return segment;
}

double snap_of(const Candidate& candidate) noexcept {
  double snap = 0.0;
  for (int i = 0; i < candidate.chain.count; ++i) {
    const Curve curve = snap_of(segment_of(candidate, i));
    snap += integral_of_product(curve, curve, candidate.chain.duration[i]);
  }
  return snap;
}

double stretch_to_limits(const Candidate& candidate, const MotionLimits& limits) noexcept {
  double factor = 0.0;
  for (int i = 0; i < candidate.chain.count; ++i) {
    factor = larger(factor, kMinDuration / candidate.chain.duration[i]);
    factor = larger(factor, stretch_to_limits(segment_of(candidate, i), limits));
  }
  return limits.rate > 0.0 ? stretch_to_rate(candidate, factor, limits.rate) : factor;
}

bool keeps_everything(const Candidate& candidate, double factor, const Corridor& corridor,
                      const MotionLimits& limits) noexcept {
  for (int i = 0; i < candidate.chain.count; ++i) {
    Segment segment = segment_of(candidate, i);
    segment.duration *= factor;
    if (!inside(segment, corridor.polyhedra[segment.polyhedron])) return false;
    if (!within_limits(segment, limits)) return false;
  }
  return true;
}

void keep(const Candidate& candidate, BestPlan& best) noexcept {
  best.found = true;
  for (int i = 0; i < candidate.chain.count; ++i) {
    best.duration[i] = candidate.chain.duration[i];
    for (int k = 0; k < kControlPoints; ++k) best.points[i][k] = candidate.points[i][k];
  }
}

void give_out(const BestPlan& best, double factor, const Chain& chain, Trajectory& out) noexcept {
  out.count = chain.count;
  for (int i = 0; i < chain.count; ++i) {
    out.segments[i].duration = factor * best.duration[i];
    out.segments[i].polyhedron = chain.polyhedron[i];
    for (int k = 0; k < kControlPoints; ++k) out.segments[i].points[k] = best.points[i][k];
  }
}

}  // namespace tern
