// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planner/tube.hpp"

#include "base/capacity.hpp"
#include "corridor/hull_polyhedron.hpp"
#include "curve/bezier.hpp"

namespace tern {
namespace {

/// Appends the segment with a polyhedron around its hull.
bool append_whole(const Grid& grid, const Vec3& origin, const Segment& segment, GrowScratch& scratch, Tube& tube) {
  Vec3 points[kControlPoints];
  for (int k = 0; k < kControlPoints; ++k) points[k] = origin + segment.points[k];
  Polyhedron& polyhedron = tube.polyhedra[tube.count];
  if (enclose_hull(grid, {points, kControlPoints}, tube.slack, scratch, polyhedron) != Status::kOk) return false;
  tube.segments[tube.count] = segment;
  tube.segments[tube.count].polyhedron = tube.count;
  ++tube.count;
  return true;
}

Segment half_of(const Segment& whole, const Curve& curve) {
  Segment segment = whole;
  segment.duration = 0.5 * whole.duration;
  for (int k = 0; k < kControlPoints; ++k) segment.points[k] = curve.c[k];
  return segment;
}

/// Segments that wait for a polyhedron, the next one last.
struct Pending {
  int count;
  Segment segment[kTubeHalvings + 1];
  int halvings[kTubeHalvings + 1];

  void push(const Segment& next, int halved) {
    segment[count] = next;
    halvings[count++] = halved;
  }
};

}  // namespace

Status enclose(const Grid& grid, const Vec3& origin, const Segment& whole, GrowScratch& scratch, Tube& tube) noexcept {
  Pending pending;
  pending.count = 0;
  pending.push(whole, 0);
  // Each iteration appends a segment or halves one. A segment that does not fit ends the loop.
  while (pending.count > 0) {
    if (is_full(tube.count + pending.count > tube.capacity)) return Status::kSegmentsFull;
    const Segment segment = pending.segment[--pending.count];
    const int halvings = pending.halvings[pending.count];
    if (append_whole(grid, origin, segment, scratch, tube)) continue;
    if (halvings == kTubeHalvings) return Status::kCorridorBlocked;
    Curve first = curve_of(segment);
    const Curve second = split(first);
    pending.push(half_of(segment, second), halvings + 1);
    pending.push(half_of(segment, first), halvings + 1);
  }
  return Status::kOk;
}

}  // namespace tern
