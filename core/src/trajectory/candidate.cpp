// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/candidate.hpp"

#include "base/math.hpp"
#include "curve/bezier.hpp"
#include "curve/motion_limits.hpp"

namespace tern {
namespace {

Segment segment_of(const Candidate& candidate, int index) {
  Segment segment;
  segment.duration = candidate.chain.duration[index];
  segment.polyhedron = candidate.chain.polyhedron[index];
  for (int k = 0; k < kControlPoints; ++k) segment.points[k] = candidate.points[index][k];
  return segment;
}

}  // namespace

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
  return factor;
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
