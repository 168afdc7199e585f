// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/tube.hpp"

#include "base/capacity.hpp"
#include "curve/bezier.hpp"

namespace tern {
namespace {

void push(Appending& appending, const Segment& next, int halved) {
  appending.segment[appending.pending] = next;
  appending.halvings[appending.pending++] = halved;
  enclose_begin(appending.growth);
}

/// Grows a polyhedron around the hull of the next part.
Progress enclose_next(Appending& appending, const World& world, const Vec3& origin, GrowScratch& scratch, Tube& tube,
                      Work& work) {
  const Segment& segment = appending.segment[appending.pending - 1];
  Vec3 points[kControlPoints];
  for (int k = 0; k < kControlPoints; ++k) points[k] = origin + segment.points[k];
  return enclose_advance(appending.growth, world, {points, kControlPoints}, tube.slack, scratch,
                         tube.polyhedra[tube.count], work);
}

/// Moves the next part, which now has a polyhedron, into the tube.
void append(Appending& appending, Tube& tube) {
  tube.segments[tube.count] = appending.segment[--appending.pending];
  tube.segments[tube.count].polyhedron = tube.count;
  ++tube.count;
  enclose_begin(appending.growth);
}

Segment half_of(const Segment& whole, const Curve& curve) {
  Segment segment = whole;
  segment.duration = 0.5 * whole.duration;
  for (int k = 0; k < kControlPoints; ++k) segment.points[k] = curve.c[k];
  return segment;
}

/// Halves the next part, which has no room as a whole. False if it is too small.
bool halve(Appending& appending) {
  const Segment segment = appending.segment[--appending.pending];
  const int halvings = appending.halvings[appending.pending];
  if (halvings == kTubeHalvings) return false;
  Curve first = curve_of(segment);
  const Curve second = split(first);
  push(appending, half_of(segment, second), halvings + 1);
  push(appending, half_of(segment, first), halvings + 1);
  return true;
}

}  // namespace

void append_begin(Appending& appending, const Segment& whole) noexcept {
  appending.status = Status::kOk;
  appending.pending = 0;
  push(appending, whole, 0);
}

Progress append_advance(Appending& appending, const World& world, const Vec3& origin, GrowScratch& scratch, Tube& tube,
                        Work& work) noexcept {
  // Each turn appends a part or halves one. A part that does not fit ends the loop.
  while (appending.pending > 0) {
    if (is_full(tube.count + appending.pending > tube.capacity))
      return conclude(Status::kSegmentsFull, appending.status);
    const Progress enclosed = enclose_next(appending, world, origin, scratch, tube, work);
    if (enclosed == Progress::kMore) return enclosed;
    if (enclosed == Progress::kDone) {
      append(appending, tube);
    } else if (!halve(appending)) {
      return conclude(Status::kCorridorBlocked, appending.status);
    }
  }
  return Progress::kDone;
}

Status enclose(const World& world, const Vec3& origin, const Segment& whole, GrowScratch& scratch,
               Tube& tube) noexcept {
  Appending appending;
  append_begin(appending, whole);
  Work all{0xFFFFFFFFu};
  append_advance(appending, world, origin, scratch, tube, all);
  return appending.status;
}

}  // namespace tern
