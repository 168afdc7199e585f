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

/// What is allowed is convex: where it holds all control points it holds the curve.
bool allows_hull(const Allowed& limit, const Curve& curve) {
  for (int i = 0; i <= curve.degree; ++i) {
    if (!allows(limit, curve.c[i])) return false;
  }
  return true;
}

/// True where the curve is allowed for all u in [0, 1], proven by hulls of ever smaller pieces.
bool allowed_throughout(Curve curve, const Allowed& limit) {
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

/// Bezier curves lie in the hull of their control points: all inside means the curve is (the paper's Section 3.4.2).
bool points_inside(const Segment& segment, const Polyhedron& polyhedron, const PlanFrame& frame, const Grid& grid) {
  const double tolerance = check_distance(grid) + frame.rounding + lattice_rounding(grid);
  for (const Vec3& point : segment.points) {
    if (!within(point, frame.boundary, tolerance)) return false;
  }
  for (int p = 0; p < all_planes(polyhedron); ++p) {
    const Vec3& normal = polyhedron.planes[p].normal;
    const double room = polyhedron.planes[p].offset - dot(normal, frame.from_grid);
    for (const Vec3& point : segment.points) {
      if (dot(normal, point) > room + tolerance) return false;
    }
  }
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

/// Positions are the same bits; derivatives agree but for the rounding of either side.
bool joins(const Segment& before, const Segment& after) {
  const Jet left = jet(before, true);
  const Jet right = jet(after, false);
  if (!close(left.d[0], right.d[0], 0.0)) return false;
  for (int k = 1; k < 4; ++k) {
    if (!close(left.d[k], right.d[k], derivative_rounding(before, k) + derivative_rounding(after, k))) return false;
  }
  return true;
}

bool boundary_met(const Segment& segment, const State& state, const PlanFrame& frame, const Vec3& origin,
                  const Vec3& jerk, bool at_end) {
  const Jet end = jet(segment, at_end);
  return close(end.d[0], state.position - origin, frame.rounding) &&
         close(end.d[1], state.velocity, derivative_rounding(segment, 1)) &&
         close(end.d[2], state.acceleration, derivative_rounding(segment, 2)) &&
         close(end.d[3], jerk, derivative_rounding(segment, 3));
}

Finding check_limits(const Segment& segment, const Limits& limits) {
  const Curve velocity = derivative(position_of(segment), segment.duration);
  const Allowed speed = allowed(limits.v_max, limits.v_min, limits.v_horizontal, hodograph_rounding(segment, 1));
  if (!allowed_throughout(velocity, speed)) return Finding::kVelocity;
  const Curve acceleration = derivative(velocity, segment.duration);
  const Allowed pull = allowed(limits.a_max, limits.a_min, limits.a_horizontal, hodograph_rounding(segment, 2));
  return allowed_throughout(acceleration, pull) ? Finding::kNone : Finding::kAcceleration;
}

}  // namespace

Finding check_segment(const Grid& grid, const Corridor& corridor, const Trajectory& trajectory, int index,
                      const CheckQuery& query) noexcept {
  const Segment& segment = trajectory.segments[index];
  if (!numbers_are_sane(segment, corridor)) return Finding::kMalformed;
  const PlanFrame frame = frame_of(grid, trajectory);
  const Vec3& origin = trajectory.origin;
  if (!points_inside(segment, corridor.polyhedra[segment.polyhedron], frame, grid)) return Finding::kOutside;
  if (index == 0 && !boundary_met(segment, query.start, frame, origin, query.start_jerk, false))
    return Finding::kBoundary;
  const bool last = index == trajectory.count - 1;
  if (last && !boundary_met(segment, query.goal, frame, origin, {0.0, 0.0, 0.0}, true)) return Finding::kBoundary;
  if (index > 0 && !joins(trajectory.segments[index - 1], segment)) return Finding::kJoint;
  return check_limits(segment, query.limits);
}

}  // namespace tern
