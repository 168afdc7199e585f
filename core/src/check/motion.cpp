// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "check/check_stage.hpp"
#include "check/hodograph.hpp"

namespace tern {
namespace {

using checked::Jet;
using checked::jet;

bool numbers_are_sane(const Segment& segment, const Corridor& corridor) {
  if (!finite(segment.duration) || segment.duration <= 0.0) return false;
  if (segment.polyhedron < 0 || segment.polyhedron >= corridor.count) return false;
  for (const Vec3& point : segment.points) {
    if (!finite(point)) return false;
  }
  return true;
}

/// The frame of the control points, and the boundary in it.
struct PlanFrame {
  Vec3 from_grid;  ///< the frame's origin in the grid's local frame
  Box boundary;    ///< where a control point may be, relative to the frame's origin
  double rounding;
};

PlanFrame frame_of(const Grid& grid, const Trajectory& trajectory) {
  const GridSpec& spec = grid.spec();
  const Vec3& origin = trajectory.origin;
  Box boundary{spec.boundary.lower - origin, spec.boundary.upper - origin};
  for (int a = 0; a < 3; ++a) {
    axis(boundary.lower, a) -= face_tolerance(grid, axis(spec.boundary.lower, a));
    axis(boundary.upper, a) += face_tolerance(grid, axis(spec.boundary.upper, a));
  }
  return {origin - spec.origin, boundary, place_rounding(grid, trajectory)};
}

bool within(const Vec3& point, const Box& box) {
  for (int a = 0; a < 3; ++a) {
    if (axis(point, a) < axis(box.lower, a) || axis(point, a) > axis(box.upper, a)) return false;
  }
  return true;
}

/// Notes the axis on which the point is furthest beyond the box, and how far.
bool refuse_beyond(const Vec3& point, const Box& box, CheckReport& found) {
  for (int a = 0; a < 3; ++a) {
    const double outside = larger(axis(box.lower, a) - axis(point, a), axis(point, a) - axis(box.upper, a));
    const double excess = larger(0.0, outside);
    if (found.axis >= 0 && !(excess > found.excess)) continue;
    found.axis = a;
    found.excess = excess;
  }
  return refuse(Finding::kOutside, found);
}

/// True if all control points are inside the polyhedron and the boundary. A Bezier curve lies in the hull of its
/// control points, so the curve is then inside too (the paper's Section 3.4.2).
bool points_inside(const Segment& segment, const Polyhedron& polyhedron, const PlanFrame& frame, const Grid& grid,
                   CheckReport& found) {
  const double tolerance = check_distance(grid) + frame.rounding + lattice_rounding(grid);
  for (const Vec3& point : segment.points) {
    if (!within(point, frame.boundary)) return refuse_beyond(point, frame.boundary, found);
  }
  found.polyhedron = segment.polyhedron;
  for (int p = 0; p < all_planes(polyhedron); ++p) {
    const Vec3& normal = polyhedron.planes[p].normal;
    const double room = polyhedron.planes[p].offset - dot(normal, frame.from_grid);
    for (const Vec3& point : segment.points) {
      if (!(dot(normal, point) > room + tolerance)) continue;
      found.plane = p;
      found.excess = dot(normal, point) - (room + tolerance);
      return refuse(Finding::kOutside, found);
    }
  }
  found.polyhedron = -1;
  return true;
}

bool close(const Vec3& a, const Vec3& b, double tolerance) {
  return absolute(a.x - b.x) <= tolerance && absolute(a.y - b.y) <= tolerance && absolute(a.z - b.z) <= tolerance;
}

/// True if derivative k of both is the same to within the tolerance. If false, `found` receives the axis of the widest
/// gap.
bool agrees(const Jet& a, const Jet& b, int k, double tolerance, CheckReport& found) {
  if (close(a.d[k], b.d[k], tolerance)) return true;
  found.derivative = k;
  for (int i = 0; i < 3; ++i) {
    const double excess = larger(0.0, absolute(axis(a.d[k], i) - axis(b.d[k], i)) - tolerance);
    if (found.axis >= 0 && !(excess > found.excess)) continue;
    found.axis = i;
    found.excess = excess;
  }
  return false;
}

/// True if the positions have the same bits, and the derivatives agree to within the rounding of both sides.
bool joins(const Segment& before, const Segment& after, CheckReport& found) {
  const Jet left = jet(before, true);
  const Jet right = jet(after, false);
  for (int k = 0; k < 4; ++k) {
    const double tolerance = k == 0 ? 0.0 : derivative_rounding(before, k) + derivative_rounding(after, k);
    if (!agrees(left, right, k, tolerance, found)) return refuse(Finding::kJoint, found);
  }
  return true;
}

bool boundary_met(const Segment& segment, const Jet& asked, double rounding, bool at_end, CheckReport& found) {
  const Jet end = jet(segment, at_end);
  for (int k = 0; k < 4; ++k) {
    const double tolerance = k == 0 ? rounding : derivative_rounding(segment, k);
    if (!agrees(end, asked, k, tolerance, found)) return refuse(Finding::kBoundary, found);
  }
  return true;
}

Jet asked_jet(const State& state, const Vec3& origin) {
  return {{state.position - origin, state.velocity, state.acceleration, state.jerk}};
}

/// True if the first segment begins at the start state, and the last one ends at the goal state.
bool ends_met(const Trajectory& trajectory, int index, const CheckQuery& query, double rounding, CheckReport& found) {
  const Segment& segment = trajectory.segments[index];
  const Jet start = asked_jet(query.start, trajectory.origin);
  const Jet goal = asked_jet(query.goal, trajectory.origin);
  if (index == 0 && !boundary_met(segment, start, rounding, false, found)) return false;
  return index < trajectory.count - 1 || boundary_met(segment, goal, rounding, true, found);
}

}  // namespace

bool segment_holds(const Grid& grid, const Corridor& corridor, const Trajectory& trajectory, int index,
                   const CheckQuery& query, CheckReport& found) noexcept {
  const Segment& segment = trajectory.segments[index];
  if (!numbers_are_sane(segment, corridor)) return refuse(Finding::kMalformed, found);
  const PlanFrame frame = frame_of(grid, trajectory);
  return points_inside(segment, corridor.polyhedra[segment.polyhedron], frame, grid, found) &&
         ends_met(trajectory, index, query, frame.rounding, found) &&
         (index == 0 || joins(trajectory.segments[index - 1], segment, found)) &&
         limits_hold(segment, query.limits, found);
}

}  // namespace tern
