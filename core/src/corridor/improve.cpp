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

/// The barrier's ellipsoid inside scratch.trial.
void find_ellipsoid(Improvement& improvement, const Enclosure& enclosure, const Vector& inside,
                    const GrowScratch& scratch, Work& work) {
  improvement.inner = barrier_ellipsoid(scratch.trial, inside, enclosure.least_slack, work);
  work.spend(2 * ops::kTurn * scratch.trial.count);
}

/// Begins to make half-spaces tangent to the ellipsoid, after those that stay.
void begin_tangents(Improvement& improvement, const Enclosure& enclosure, GrowScratch& scratch) {
  scratch.trial.count = enclosure.given;
  tangents_begin(improvement.pass, improvement.inner.metric);
  improvement.phase = ImprovePhase::kTangents;
}

void begin(Improvement& improvement, const Enclosure& enclosure, GrowScratch& scratch, const Polyhedron& out,
           Work& work) {
  const SegmentMargin& segment = enclosure.segment;
  copy_planes(out, scratch.trial);
  find_ellipsoid(improvement, enclosure, to_vector(0.5 * (segment.from + segment.to)), scratch, work);
  improvement.center = improvement.inner.metric.center;
  improvement.size = improvement.inner.size;
  improvement.plane = enclosure.given;
  begin_tangents(improvement, enclosure, scratch);
}

/// Keeps the polyhedron of the new half-spaces if it is the largest so far.
void compare(Improvement& improvement, const Enclosure& enclosure, const GrowScratch& scratch, Polyhedron& out,
             Work& work) {
  find_ellipsoid(improvement, enclosure, improvement.pass.metric.center, scratch, work);
  if (improvement.inner.size <= improvement.size) return;
  improvement.size = improvement.inner.size;
  improvement.center = improvement.inner.metric.center;
  copy_planes(scratch.trial, out);
}

/// Goes on after a round or a trial. If its half-spaces did not fit (`fits` is false), there are no further rounds.
void go_on(Improvement& improvement, const Enclosure& enclosure, GrowScratch& scratch, bool fits) {
  improvement.phase = ImprovePhase::kLeaveOut;
  if (improvement.rounds == kImprovingRounds) return;
  improvement.rounds = fits ? improvement.rounds + 1 : kImprovingRounds;
  if (improvement.rounds < kImprovingRounds) begin_tangents(improvement, enclosure, scratch);
}

/// Leaves out the next half-space, and begins a trial without it if that is promising.
void leave_out(Improvement& improvement, const Enclosure& enclosure, GrowScratch& scratch, const Polyhedron& out,
               Work& work) {
  copy_all_but(improvement.plane++, out, scratch.trial);
  find_ellipsoid(improvement, enclosure, improvement.center, scratch, work);
  if (improvement.inner.size < kWorthLeavingOut * improvement.size) return;
  ++improvement.trials;
  begin_tangents(improvement, enclosure, scratch);
}

/// Does a piece of work outside tangents_advance().
void find_next(Improvement& improvement, const Enclosure& enclosure, GrowScratch& scratch, Polyhedron& out,
               Work& work) {
  if (improvement.phase == ImprovePhase::kBegin) return begin(improvement, enclosure, scratch, out, work);
  if (improvement.phase == ImprovePhase::kLeaveOut) return leave_out(improvement, enclosure, scratch, out, work);
  compare(improvement, enclosure, scratch, out, work);
  go_on(improvement, enclosure, scratch, true);
}

bool is_done(const Improvement& improvement, const Polyhedron& out) {
  return improvement.phase == ImprovePhase::kLeaveOut &&
         (improvement.plane >= out.count || improvement.trials == kLeaveOuts);
}

}  // namespace

void improve_begin(Improvement& improvement) noexcept {
  improvement.phase = ImprovePhase::kBegin;
  improvement.rounds = 0;
  improvement.trials = 0;
}

Progress improve_advance(Improvement& improvement, const Enclosure& enclosure, GrowScratch& scratch, Polyhedron& out,
                         Work& work, Status& status) noexcept {
  // Each turn but the last one makes half-spaces, of a round or a trial, or finds an ellipsoid.
  while (!is_done(improvement, out)) {
    if (improvement.phase != ImprovePhase::kTangents) {
      if (!work.left()) return Progress::kMore;
      find_next(improvement, enclosure, scratch, out, work);
      continue;
    }
    const Progress made = tangents_advance(improvement.pass, enclosure.obstacles, enclosure.segment, scratch,
                                           scratch.trial, work, status);
    if (made == Progress::kDone) improvement.phase = ImprovePhase::kCompare;
    if (made == Progress::kMore || (made == Progress::kFailed && status != Status::kPlanesFull)) return made;
    if (made == Progress::kFailed) go_on(improvement, enclosure, scratch, false);
  }
  return conclude(Status::kOk, status);
}

}  // namespace tern
