// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/math.hpp"
#include "check/check_stage.hpp"

namespace tern {
namespace {

/// Halvings of a curve's parameter range before a bound is given up; the hull of a piece shrinks fourfold a level.
constexpr int kMaxDepth = 24;
/// Pieces looked at for one axis of one segment: a curve that needs more is refused.
constexpr int kMaxPieces = 4096;

/// Bernstein coefficients of one coordinate of a curve.
struct Curve {
  double c[kControlPoints];
  int degree;
};

Curve coordinate(const Segment& segment, int a) {
  Curve curve{};
  curve.degree = kDegree;
  for (int i = 0; i <= kDegree; ++i) curve.c[i] = axis(segment.points[i], a);
  return curve;
}

/// The hodograph: derivative with respect to time of a curve that lasts `duration` seconds.
Curve derivative(const Curve& curve, double duration) {
  Curve result{};
  result.degree = curve.degree - 1;
  for (int i = 0; i < curve.degree; ++i) result.c[i] = curve.degree * (curve.c[i + 1] - curve.c[i]) / duration;
  return result;
}

double largest(const Curve& curve) {
  double value = 0.0;
  for (int i = 0; i <= curve.degree; ++i) value = larger(value, absolute(curve.c[i]));
  return value;
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

/// True where |curve(u)| <= limit for all u in [0, 1], proven by hulls of ever smaller pieces.
bool bounded_by(Curve curve, double limit) {
  Curve stack[kMaxDepth + 1];
  int depth_of[kMaxDepth + 1];
  int height = 0;
  int depth = 0;
  for (int piece = 0; piece < kMaxPieces; ++piece) {
    if (largest(curve) <= limit) {
      if (height == 0) return true;
      --height;
      curve = stack[height];
      depth = depth_of[height];
      continue;
    }
    // The ends of a hull are values of the curve: above the limit there is nothing left to prove.
    if (absolute(curve.c[0]) > limit || absolute(curve.c[curve.degree]) > limit || depth == kMaxDepth) return false;
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

bool within(const Vec3& point, const Box& box) {
  for (int a = 0; a < 3; ++a) {
    if (axis(point, a) < axis(box.lower, a) - kCheckDistance || axis(point, a) > axis(box.upper, a) + kCheckDistance) {
      return false;
    }
  }
  return true;
}

/// Bezier curves lie in the hull of their control points: all inside means the curve is (the paper's Section 3.4.2).
bool points_inside(const Segment& segment, const Polyhedron& polyhedron, const Box& boundary) {
  for (const Vec3& point : segment.points) {
    if (!within(point, boundary)) return false;
    for (int p = 0; p < polyhedron.count; ++p) {
      if (dot(polyhedron.planes[p].normal, point) > polyhedron.planes[p].offset + kCheckDistance) return false;
    }
  }
  return true;
}

bool close(double a, double b) {
  return absolute(a - b) <= kCheckRelative * (1.0 + absolute(b));
}

/// Value and derivatives to jerk of a coordinate at its beginning or end.
struct Jet {
  double d[4];
};

Jet jet(const Segment& segment, int a, bool at_end) {
  Jet result{};
  Curve curve = coordinate(segment, a);
  for (int k = 0; k < 4; ++k) {
    result.d[k] = at_end ? curve.c[curve.degree] : curve.c[0];
    if (k < 3) curve = derivative(curve, segment.duration);
  }
  return result;
}

bool meets(const Jet& jet, const State& state, int a) {
  return close(jet.d[0], axis(state.position, a)) && close(jet.d[1], axis(state.velocity, a)) &&
         close(jet.d[2], axis(state.acceleration, a)) && absolute(jet.d[3]) <= 1e-5;
}

bool joins(const Segment& before, const Segment& after) {
  for (int a = 0; a < 3; ++a) {
    const Jet left = jet(before, a, true);
    const Jet right = jet(after, a, false);
    for (int k = 0; k < 4; ++k) {
      if (!close(left.d[k], right.d[k])) return false;
    }
  }
  return true;
}

bool boundary_met(const Segment& segment, const State& state, bool at_end) {
  for (int a = 0; a < 3; ++a) {
    if (!meets(jet(segment, a, at_end), state, a)) return false;
  }
  return true;
}

Finding check_limits(const Segment& segment, const Limits& limits) {
  for (int a = 0; a < 3; ++a) {
    const Curve velocity = derivative(coordinate(segment, a), segment.duration);
    if (!bounded_by(velocity, axis(limits.v_max, a) * (1.0 + kCheckRelative))) return Finding::kVelocity;
    const Curve acceleration = derivative(velocity, segment.duration);
    if (!bounded_by(acceleration, axis(limits.a_max, a) * (1.0 + kCheckRelative))) return Finding::kAcceleration;
  }
  return Finding::kNone;
}

}  // namespace

Finding check_segment(const Grid& grid, const Corridor& corridor, const Trajectory& trajectory, int index,
                      const CheckQuery& query) noexcept {
  const Segment& segment = trajectory.segments[index];
  if (!numbers_are_sane(segment, corridor)) return Finding::kMalformed;
  if (!points_inside(segment, corridor.polyhedra[segment.polyhedron], grid.local_boundary())) return Finding::kOutside;
  if (index == 0 && !boundary_met(segment, query.start, false)) return Finding::kBoundary;
  if (index == trajectory.count - 1 && !boundary_met(segment, query.goal, true)) return Finding::kBoundary;
  if (index > 0 && !joins(trajectory.segments[index - 1], segment)) return Finding::kJoint;
  return check_limits(segment, query.limits);
}

}  // namespace tern
