// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "prove/bernstein.hpp"
#include "prove/check_stage.hpp"
#include "prove/grants.hpp"

namespace tern {
namespace {

/// A plan's state where it passes a via, and a segment there, for the rounding of its derivatives.
struct Passage {
  Jet state;
  const Segment& segment;
};

Passage passage_at(const Trajectory& trajectory, std::int32_t joint) {
  const bool at_end = joint == trajectory.count;
  const Segment& segment = trajectory.segments[at_end ? joint - 1 : joint];
  return {jet_of(segment, at_end), segment};
}

/// Always false.
bool refuse_excess(double excess, int derivative, ProofReport& found) {
  found.finding = Finding::kVia;
  found.derivative = derivative;
  found.excess = excess;
  return false;
}

/// True if derivative k is `asked`, up to rounding.
bool gives(const Passage& passage, const Vec3& asked, int k, ProofReport& found) {
  const Vec3 gap = passage.state.d[k] - asked;
  const double tolerance = derivative_rounding(passage.segment, k);
  for (int a = 0; a < 3; ++a) {
    if (absolute(axis(gap, a)) <= tolerance) continue;
    found.axis = a;
    return refuse_excess(absolute(axis(gap, a)) - tolerance, k, found);
  }
  return true;
}

bool is_near(const Passage& passage, const Via& via, const Vec3& origin, double tolerance, ProofReport& found) {
  const Vec3 gap = passage.state.d[0] - (via.position - origin);
  const double excess = length(gap) - (via.tolerance + tolerance);
  return !(excess > 0.0) || refuse_excess(excess, 0, found);
}

/// True if the segment at the joint rests for the via's dwell: its control points are all the same.
bool dwells(const Trajectory& trajectory, std::int32_t joint, const Via& via, ProofReport& found) {
  const bool exists = joint < trajectory.count;
  const double rested = exists ? trajectory.segments[joint].duration : 0.0;
  if (rested < via.dwell) return refuse_excess(via.dwell - rested, 0, found);
  const Segment& segment = trajectory.segments[joint];
  for (const Vec3& point : segment.points) {
    const double moved = distance(point, segment.points[0]);
    if (moved > 0.0) return refuse_excess(moved, 0, found);
  }
  return true;
}

/// Seconds until the segment begins.
double time_of(const Trajectory& trajectory, std::int32_t segment) {
  double time = 0.0;
  for (int i = 0; i < segment; ++i) time += trajectory.segments[i].duration;
  return time;
}

bool via_met(const Passage& passage, const Via& via, ProofReport& found) {
  constexpr Vec3 kRest{0.0, 0.0, 0.0};
  if (via.has_velocity && !gives(passage, via.velocity, 1, found)) return false;
  return !via.stop ||
         (gives(passage, kRest, 1, found) && gives(passage, kRest, 2, found) && gives(passage, kRest, 3, found));
}

}  // namespace

bool vias_met(const Grid& grid, const Trajectory& trajectory, const CheckQuery& query, ProofReport& found) noexcept {
  const double tolerance = check_distance(grid) + place_rounding(grid, trajectory);
  std::int32_t least = 0;
  for (std::int32_t v = 0; v < query.via_count; ++v) {
    const std::int32_t joint = query.joints[v];
    found.via = v;
    if (joint < least || joint > trajectory.count) return refuse_excess(0.0, -1, found);
    const Passage passage = passage_at(trajectory, joint);
    found.until = time_of(trajectory, joint);
    if (!is_near(passage, query.vias[v], trajectory.origin, tolerance, found)) return false;
    if (!via_met(passage, query.vias[v], found)) return false;
    if (query.vias[v].dwell > 0.0 && !dwells(trajectory, joint, query.vias[v], found)) return false;
    least = joint;
  }
  found.via = -1;
  return true;
}

}  // namespace tern
