// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geofences of a plan: each segment is inside the keep-ins, and a plane parts it from each keep-out.
#include <algorithm>
#include <optional>

#include "verify/polyhedron.hpp"
#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

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

/// The half-space cuts the box if its normal is along an axis; else false.
bool cut_box(const HalfSpace& plane, Box& box) {
  if (std::count(plane.normal.begin(), plane.normal.end(), Rational(0)) != 2) return false;
  for (std::size_t a = 0; a < 3; ++a) {
    const Rational& along = plane.normal[a];
    if (along > 0) box.upper[a] = std::min<Rational>(box.upper[a], plane.offset / along);
    if (along < 0) box.lower[a] = std::max<Rational>(box.lower[a], plane.offset / along);
  }
  return true;
}

/// What of a keep-out can be too near to a place inside the boundary and all keep-ins. It reaches a voxel beyond them
/// at least: in a flat boundary without a radius, a keep-out would have no inside, and the way through it would touch
/// it.
std::vector<HalfSpace> part_that_matters(const Problem& problem, const Fence& keep_out) {
  const Rational reach = std::max<Rational>(problem.clearance, problem.cell);
  Box box = problem.boundary;
  std::vector<HalfSpace> planes = keep_out.planes;
  for (const Fence& fence : problem.fences) {
    if (!fence.keep_in) continue;
    for (const HalfSpace& plane : fence.planes) {
      if (cut_box(plane, box)) continue;
      const Rational out = reach * root_above(dot(plane.normal, plane.normal));
      planes.push_back({plane.normal, plane.offset + out});
    }
  }
  return cut_to(box, reach, planes);
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
  const std::vector<HalfSpace> planes = part_that_matters(subject.problem, fence);
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
