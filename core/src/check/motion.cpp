// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "check/check_stage.hpp"

namespace tern {
namespace {

/// Halvings of a curve's parameter range before a bound is given up; the hull's excess shrinks fourfold a level.
constexpr int kMaxDepth = 16;
/// Pieces looked at for one derivative of one segment: a curve that needs more is refused.
constexpr int kMaxPieces = 4096;
/// Stands for an axis without a limit on jerk, m/s^3.
constexpr double kAnyJerk = 1e300;

/// Bernstein coefficients of a curve.
struct Curve {
  Vec3 c[kControlPoints];
  int degree;
};

Curve position_of(const Segment& segment) {
  Curve curve;
  curve.degree = kDegree;
  for (int i = 0; i <= kDegree; ++i) curve.c[i] = segment.points[i];
  return curve;
}

/// The hodograph: derivative with respect to time of a curve that lasts `duration` seconds.
Curve derivative(const Curve& curve, double duration) {
  Curve result{};
  result.degree = curve.degree - 1;
  for (int i = 0; i < curve.degree; ++i) result.c[i] = (curve.degree / duration) * (curve.c[i + 1] - curve.c[i]);
  return result;
}

/// de Casteljau at 1/2: `curve` becomes its left half, the right half is returned.
Curve split(Curve& curve) {
  Curve right{};
  right.degree = curve.degree;
  for (int level = 0; level < curve.degree; ++level) {
    right.c[curve.degree - level] = curve.c[curve.degree];
    for (int i = curve.degree; i > level; --i) curve.c[i] = 0.5 * (curve.c[i - 1] + curve.c[i]);
  }
  right.c[0] = curve.c[curve.degree];
  return right;
}

/// What a velocity or an acceleration may be, as the request says it, with the check's tolerance.
struct Allowed {
  Vec3 most;
  Vec3 least;
  double horizontal_squared;  ///< 0: no limit on the horizontal norm
};

/// `rounding`: of the values that are held against the limits.
Allowed allowed(const Vec3& most, const Vec3& least, double horizontal, double rounding) {
  constexpr double kWider = 1.0 + kCheckRelative;
  Allowed result{kWider * most, kWider * least, 0.0};
  for (int a = 0; a < 3; ++a) {
    if (!(axis(least, a) < 0.0)) axis(result.least, a) = -axis(result.most, a);
    axis(result.most, a) += rounding;
    axis(result.least, a) -= rounding;
  }
  if (horizontal > 0.0) {
    const double norm = kWider * horizontal + 2.0 * rounding;
    result.horizontal_squared = norm * norm;
  }
  return result;
}

bool allows(const Allowed& limit, const Vec3& value) {
  for (int a = 0; a < 3; ++a) {
    if (axis(value, a) > axis(limit.most, a) || axis(value, a) < axis(limit.least, a)) return false;
  }
  return !(limit.horizontal_squared > 0.0) || value.x * value.x + value.y * value.y <= limit.horizontal_squared;
}

constexpr int kHorizontal = 3;  // CheckReport::axis

/// The first axis on which the value is not allowed, and by how much. None where it is: the proof took too many pieces.
void describe(const Allowed& limit, const Vec3& value, CheckReport& found) {
  if (allows(limit, value)) return;
  for (int a = 0; a < 3; ++a) {
    found.axis = a;
    found.excess = larger(axis(value, a) - axis(limit.most, a), axis(limit.least, a) - axis(value, a));
    if (found.excess > 0.0) return;
  }
  found.axis = kHorizontal;
  const double norm = square_root(value.x * value.x + value.y * value.y);
  found.excess = larger(0.0, norm - square_root(limit.horizontal_squared));
}

/// What is allowed is convex: where it holds all control points it holds the curve.
bool allows_hull(const Allowed& limit, const Curve& curve) {
  for (int i = 0; i <= curve.degree; ++i) {
    if (!allows(limit, curve.c[i])) return false;
  }
  return true;
}

/// A control point of the piece that is not allowed: one that the curve goes through, where there is one.
Vec3 offending(const Curve& piece, const Allowed& limit) {
  const bool begins_well = allows(limit, piece.c[0]);
  if (begins_well && !allows(limit, piece.c[piece.degree])) return piece.c[piece.degree];
  for (int i = 0; i < piece.degree; ++i) {
    if (!allows(limit, piece.c[i])) return piece.c[i];
  }
  return piece.c[0];
}

/// True where the curve is allowed for all u in [0, 1], proven by hulls of ever smaller pieces. Else `curve` becomes
/// the piece for which there is no proof.
bool allowed_throughout(Curve& curve, const Allowed& limit) {
  Curve stack[kMaxDepth];
  int depth_of[kMaxDepth];
  int height = 0;
  int depth = 0;
  for (int piece = 0; piece < kMaxPieces; ++piece) {
    if (allows_hull(limit, curve)) {
      if (height == 0) return true;
      --height;
      curve = stack[height];
      depth = depth_of[height];
      continue;
    }
    // The ends of a hull are values of the curve: above the limit there is nothing left to prove.
    if (!allows(limit, curve.c[0]) || !allows(limit, curve.c[curve.degree]) || depth == kMaxDepth) return false;
    ++depth;
    stack[height] = split(curve);
    depth_of[height] = depth;
    ++height;
  }
  return false;
}

bool numbers_are_sane(const Segment& segment, const Corridor& corridor) {
  if (!finite(segment.duration) || segment.duration <= 0.0) return false;
  if (segment.polyhedron < 0 || segment.polyhedron >= corridor.count) return false;
  for (const Vec3& point : segment.points) {
    if (!finite(point)) return false;
  }
  return true;
}

/// The control points' frame as the grid and the request are seen from it.
struct PlanFrame {
  Vec3 from_grid;  ///< the frame's origin in the grid's local frame
  Box boundary;    ///< relative to the frame's origin
  double rounding;
};

PlanFrame frame_of(const Grid& grid, const Trajectory& trajectory) {
  const GridSpec& spec = grid.spec();
  const Vec3& origin = trajectory.origin;
  return {origin - spec.origin,
          {spec.boundary.lower - origin, spec.boundary.upper - origin},
          place_rounding(grid, trajectory)};
}

bool within(const Vec3& point, const Box& box, double tolerance) {
  for (int a = 0; a < 3; ++a) {
    if (axis(point, a) < axis(box.lower, a) - tolerance || axis(point, a) > axis(box.upper, a) + tolerance) {
      return false;
    }
  }
  return true;
}

/// The axis on which the point is furthest beyond the box.
bool refuse_beyond(const Vec3& point, const Box& box, double tolerance, CheckReport& found) {
  for (int a = 0; a < 3; ++a) {
    const double outside = larger(axis(box.lower, a) - axis(point, a), axis(point, a) - axis(box.upper, a));
    const double excess = larger(0.0, outside - tolerance);
    if (found.axis >= 0 && !(excess > found.excess)) continue;
    found.axis = a;
    found.excess = excess;
  }
  return refuse(Finding::kOutside, found);
}

/// Bezier curves lie in the hull of their control points: all inside means the curve is (the paper's Section 3.4.2).
bool points_inside(const Segment& segment, const Polyhedron& polyhedron, const PlanFrame& frame, const Grid& grid,
                   CheckReport& found) {
  const double tolerance = check_distance(grid) + frame.rounding + lattice_rounding(grid);
  for (const Vec3& point : segment.points) {
    if (!within(point, frame.boundary, tolerance)) return refuse_beyond(point, frame.boundary, tolerance, found);
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

/// Position and derivatives to jerk at a segment's beginning or end.
struct Jet {
  Vec3 d[4];
};

Jet jet(const Segment& segment, bool at_end) {
  Jet result{};
  Curve curve = position_of(segment);
  for (int k = 0; k < 4; ++k) {
    result.d[k] = at_end ? curve.c[curve.degree] : curve.c[0];
    if (k < 3) curve = derivative(curve, segment.duration);
  }
  return result;
}

/// True where derivative k of both is the same but for the tolerance. Else `found` gets the axis of the widest gap.
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

/// Positions are the same bits; derivatives agree but for the rounding of either side.
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

/// Both ends of the plan, where the segment has one.
bool ends_met(const Trajectory& trajectory, int index, const CheckQuery& query, double rounding, CheckReport& found) {
  const Segment& segment = trajectory.segments[index];
  const Jet start = asked_jet(query.start, trajectory.origin);
  const Jet goal = asked_jet(query.goal, trajectory.origin);
  if (index == 0 && !boundary_met(segment, start, rounding, false, found)) return false;
  return index < trajectory.count - 1 || boundary_met(segment, goal, rounding, true, found);
}

bool keeps(Curve curve, const Allowed& limit, int derivative, Finding finding, CheckReport& found) {
  if (allowed_throughout(curve, limit)) return true;
  found.derivative = derivative;
  describe(limit, offending(curve, limit), found);
  return refuse(finding, found);
}

/// Where the jerk is limited at all; an axis without a limit may have any.
bool jerk_holds(const Segment& segment, const Curve& jerk, const Limits& limits, CheckReport& found) {
  Vec3 most = limits.j_max;
  bool limited = limits.j_horizontal > 0.0;
  for (int a = 0; a < 3; ++a) {
    limited = limited || axis(most, a) > 0.0;
    if (!(axis(most, a) > 0.0)) axis(most, a) = kAnyJerk;
  }
  const Allowed jolt = allowed(most, Vec3{0.0, 0.0, 0.0}, limits.j_horizontal, hodograph_rounding(segment, 3));
  return !limited || keeps(jerk, jolt, 3, Finding::kJerk, found);
}

bool limits_hold(const Segment& segment, const Limits& limits, CheckReport& found) {
  const Curve velocity = derivative(position_of(segment), segment.duration);
  const Allowed speed = allowed(limits.v_max, limits.v_min, limits.v_horizontal, hodograph_rounding(segment, 1));
  if (!keeps(velocity, speed, 1, Finding::kVelocity, found)) return false;
  const Curve acceleration = derivative(velocity, segment.duration);
  const Allowed pull = allowed(limits.a_max, limits.a_min, limits.a_horizontal, hodograph_rounding(segment, 2));
  return keeps(acceleration, pull, 2, Finding::kAcceleration, found) &&
         jerk_holds(segment, derivative(acceleration, segment.duration), limits, found);
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
