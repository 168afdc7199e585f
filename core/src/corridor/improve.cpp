// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "corridor/improve.hpp"

#include "base/linear.hpp"
#include "corridor/tangent_planes.hpp"
#include "ellipsoid/barrier_ellipsoid.hpp"

namespace tern {
namespace {

/// Copies only the half-spaces in use.
void copy_planes(const Polyhedron& from, Polyhedron& to) {
  to.count = from.count;
  for (int p = 0; p < from.count; ++p) to.planes[p] = from.planes[p];
}

void copy_all_but(int left_out, const Polyhedron& from, Polyhedron& to) {
  to.count = 0;
  for (int p = 0; p < from.count; ++p) {
    if (p != left_out) to.planes[to.count++] = from.planes[p];
  }
}

/// The largest polyhedron so far.
struct Largest {
  Polyhedron& polyhedron;
  Vector center;
  double size;
};

/// Makes the half-spaces tangent to `ellipsoid`, and keeps their polyhedron if it is the largest so far. `ellipsoid`
/// becomes the barrier's ellipsoid inside the new polyhedron. kPlanesFull if the half-spaces do not fit.
Status try_tangents(const Enclosure& enclosure, GrowScratch& scratch, BarrierEllipsoid& ellipsoid, Largest& largest) {
  Polyhedron& trial = scratch.trial;
  trial.count = enclosure.given;
  const Status status = append_tangents(ellipsoid.metric, enclosure.obstacles, enclosure.segment, scratch, trial);
  if (status != Status::kOk) return status;
  ellipsoid = barrier_ellipsoid(trial, ellipsoid.metric.center, enclosure.least_slack);
  if (ellipsoid.size <= largest.size) return Status::kOk;
  largest.size = ellipsoid.size;
  largest.center = ellipsoid.metric.center;
  copy_planes(trial, largest.polyhedron);
  return Status::kOk;
}

Status leave_out_each(const Enclosure& enclosure, GrowScratch& scratch, Largest& largest) {
  int trials = 0;
  for (int p = enclosure.given; p < largest.polyhedron.count && trials < kLeaveOuts; ++p) {
    copy_all_but(p, largest.polyhedron, scratch.trial);
    BarrierEllipsoid inner = barrier_ellipsoid(scratch.trial, largest.center, enclosure.least_slack);
    if (inner.size < kWorthLeavingOut * largest.size) continue;
    ++trials;
    const Status status = try_tangents(enclosure, scratch, inner, largest);
    if (status != Status::kOk && status != Status::kPlanesFull) return status;
  }
  return Status::kOk;
}

}  // namespace

Status improve(const Enclosure& enclosure, GrowScratch& scratch, Polyhedron& out, Vec3& center) noexcept {
  const SegmentMargin& segment = enclosure.segment;
  BarrierEllipsoid inner = barrier_ellipsoid(out, to_vector(0.5 * (segment.from + segment.to)), enclosure.least_slack);
  Largest largest{out, inner.metric.center, inner.size};
  copy_planes(out, scratch.trial);
  Status status = Status::kOk;
  for (int round = 0; round < kImprovingRounds && status == Status::kOk; ++round) {
    status = try_tangents(enclosure, scratch, inner, largest);
  }
  if (status == Status::kOk || status == Status::kPlanesFull) status = leave_out_each(enclosure, scratch, largest);
  center = to_vec3(largest.center);
  return status;
}

}  // namespace tern
