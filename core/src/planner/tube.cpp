// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/tube.hpp"

#include "base/capacity.hpp"
#include "curve/bezier.hpp"

namespace tern {
namespace {

void push(SegmentEnclosure& enclosure, const Segment& next, int halved) {
  enclosure.segment[enclosure.pending] = next;
  enclosure.halvings[enclosure.pending++] = halved;
  enclose_begin(enclosure.growth);
}

/// Grows a polyhedron around the hull of the next part.
Progress enclose_next(SegmentEnclosure& enclosure, const World& world, const Vec3& origin, GrowScratch& scratch,
                      Tube& tube, Work& work) {
  const Segment& segment = enclosure.segment[enclosure.pending - 1];
  Vec3 points[kControlPoints];
  for (int k = 0; k < kControlPoints; ++k) points[k] = origin + segment.points[k];
  return enclose_advance(enclosure.growth, world, {points, kControlPoints}, tube.slack, scratch,
                         tube.polyhedra[tube.count], work);
}

/// Moves the next part, which now has a polyhedron, into the tube.
void append(SegmentEnclosure& enclosure, Tube& tube) {
  tube.segments[tube.count] = enclosure.segment[--enclosure.pending];
  tube.segments[tube.count].polyhedron = tube.count;
  ++tube.count;
  enclose_begin(enclosure.growth);
}

Segment half_of(const Segment& whole, const Curve& curve) {
  Segment segment = whole;
  segment.duration = 0.5 * whole.duration;
  for (int k = 0; k < kControlPoints; ++k) segment.points[k] = curve.c[k];
  return segment;
}

/// Halves the next part, which has no room as a whole. False if it is too small.
bool halve(SegmentEnclosure& enclosure) {
  const Segment segment = enclosure.segment[--enclosure.pending];
  const int halvings = enclosure.halvings[enclosure.pending];
  if (halvings == kTubeHalvings) return false;
  Curve first = curve_of(segment);
  const Curve second = split(first);
  push(enclosure, half_of(segment, second), halvings + 1);
  push(enclosure, half_of(segment, first), halvings + 1);
  return true;
}

}  // namespace

void append_begin(SegmentEnclosure& enclosure, const Segment& whole) noexcept {
  enclosure.status = Status::kOk;
  enclosure.pending = 0;
  push(enclosure, whole, 0);
}

Progress append_advance(SegmentEnclosure& enclosure, const World& world, const Vec3& origin, GrowScratch& scratch,
                        Tube& tube, Work& work) noexcept {
  // Each turn appends a part or halves one. A part that does not fit ends the loop.
  while (enclosure.pending > 0) {
    if (is_full(tube.count + enclosure.pending > tube.capacity))
      return conclude(Status::kSegmentsFull, enclosure.status);
    const Progress enclosed = enclose_next(enclosure, world, origin, scratch, tube, work);
    if (enclosed == Progress::kMore) return enclosed;
    if (enclosed == Progress::kDone) {
      append(enclosure, tube);
    } else if (!halve(enclosure)) {
      return conclude(Status::kCorridorBlocked, enclosure.status);
    }
  }
  return Progress::kDone;
}

Status enclose(const World& world, const Vec3& origin, const Segment& whole, GrowScratch& scratch,
               Tube& tube) noexcept {
  SegmentEnclosure enclosure;
  append_begin(enclosure, whole);
  Work all{0xFFFFFFFFu};
  append_advance(enclosure, world, origin, scratch, tube, all);
  return enclosure.status;
}

}  // namespace tern
