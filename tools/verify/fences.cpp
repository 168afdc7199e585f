// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geofences. A plane has a keep-out beyond it where multipliers of the keep-out's half-spaces say so (Farkas): for
// multipliers m >= 0 whose half-spaces' normals sum to -n, every point p of the keep-out has n . p >= -sum of m *
// offset.
#include <algorithm>
#include <optional>

#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A keep-out, cut to where it can matter: the boundary and the clearance around it.
std::vector<HalfSpace> cut_to(const Box& boundary, const Rational& reach, const Fence& fence) {
  std::vector<HalfSpace> planes = fence.planes;
  for (std::size_t a = 0; a < 3; ++a) {
    Point axis{0, 0, 0};
    axis[a] = 1;
    planes.push_back({axis, boundary.upper[a] + reach});
    axis[a] = -1;
    planes.push_back({axis, -(boundary.lower[a] - reach)});
  }
  return planes;
}

/// What three half-spaces prove of n . p, if their multipliers are >= 0.
std::optional<Rational> proven_by(const HalfSpace& a, const HalfSpace& b, const HalfSpace& c, const Point& n) {
  const Point bc = cross(b.normal, c.normal);
  const Rational volume = dot(a.normal, bc);
  if (volume == 0) return {};
  const Rational x = -dot(n, bc) / volume;
  const Rational y = -dot(n, cross(c.normal, a.normal)) / volume;
  const Rational z = -dot(n, cross(a.normal, b.normal)) / volume;
  if (x < 0 || y < 0 || z < 0) return {};
  return -(x * a.offset + y * b.offset + z * c.offset);
}

/// The least of n . p over the polyhedron: the best of all proofs.
std::optional<Rational> least_along(const Point& n, const std::vector<HalfSpace>& planes) {
  std::optional<Rational> best;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      for (std::size_t k = j + 1; k < planes.size(); ++k) {
        const std::optional<Rational> proven = proven_by(planes[i], planes[j], planes[k], n);
        if (proven && (!best || *proven > *best)) best = proven;
      }
    }
  }
  return best;
}

/// The directions that may part a segment from a keep-out: away from its faces, then the corridor's.
std::vector<Point> directions_of(const Fence& fence, const std::vector<HalfSpace>& polyhedron) {
  std::vector<Point> directions;
  for (const HalfSpace& plane : fence.planes) directions.push_back(-1 * plane.normal);
  for (const HalfSpace& plane : polyhedron) directions.push_back(plane.normal);
  return directions;
}

/// Metres, from below, between a hull and a keep-out along the direction that parts them best, less the clearance. Any
/// that leaves more than `enough` will do.
Rational keep_out_margin(const Polygon<3>& hull, const std::vector<HalfSpace>& planes,
                         const std::vector<Point>& directions, const Rational& clearance, const Tightest& tightest,
                         const Rational& tolerance) {
  std::optional<Rational> best;
  for (const Point& n : directions) {
    const std::optional<Rational> least = least_along(n, planes);
    if (!least) continue;
    Rational most = dot(n, hull.front());
    for (const Point& point : hull) most = std::max<Rational>(most, dot(n, point));
    const Rational gap = *least - most;
    const Rational square = dot(n, n);
    const Rational margin = gap / (gap < 0 ? root_below(square) : root_above(square)) - clearance;
    if (!best || margin > *best) best = margin;
    if (*best >= 0 && tightest.is_above(*best, tolerance)) break;
  }
  return best ? *best : Rational(-clearance - 1);
}

void prove_keep_in(const Subject& subject, const Fence& fence, Tightest& tightest) {
  for (std::size_t s = 0; s < subject.plan.segments.size(); ++s) {
    for (const Point& point : subject.world_points(s)) {
      for (const HalfSpace& plane : fence.planes) {
        const Rational inside = plane.offset - dot(plane.normal, point);
        const Rational square = dot(plane.normal, plane.normal);
        tightest.note(inside / (inside < 0 ? root_below(square) : root_above(square)), subject.tolerance.fence,
                      [&] { return "segment " + std::to_string(s); });
      }
    }
  }
}

void prove_keep_out(const Subject& subject, const Fence& fence, Tightest& tightest) {
  const Rational tolerance = subject.tolerance.fence + subject.tolerance.point;
  const Rational& clearance = subject.problem.clearance;
  const std::vector<HalfSpace> planes = cut_to(subject.problem.boundary, clearance, fence);
  for (std::size_t s = 0; s < subject.plan.segments.size(); ++s) {
    const std::vector<HalfSpace>& polyhedron = subject.plan.corridor[subject.plan.segments[s].polyhedron];
    const std::vector<Point> directions = directions_of(fence, polyhedron);
    const Polygon<3> hull = subject.world_points(s);
    tightest.note(keep_out_margin(hull, planes, directions, clearance, tightest, tolerance), tolerance,
                  [&] { return "segment " + std::to_string(s); });
  }
}

}  // namespace

void prove_fences(const Subject& subject, Claims& claims) {
  for (std::size_t f = 0; f < subject.problem.fences.size(); ++f) {
    const Fence& fence = subject.problem.fences[f];
    Tightest tightest("fence " + std::to_string(f + 1), "m");
    if (fence.keep_in) {
      prove_keep_in(subject, fence, tightest);
    } else {
      prove_keep_out(subject, fence, tightest);
    }
    claims.push_back(tightest.claim());
  }
}

}  // namespace tern_verify
