// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "attack/solid.hpp"

namespace tern_attack {
namespace {

/// Sine of an angle between planes below which they have no edge of their own.
constexpr Real kParallel = 1e-9L;

/// Within the rounding of long double of a plane, or behind it.
bool behind(const Plane& plane, const Point& p) {
  return dot(plane.normal, p) - plane.offset <= 8e-19L * (1 + largest(p) + std::fabs(plane.offset)) * 4;
}

/// The point common to three planes, improved once by its own residual. False where they have none.
bool common_point(const Plane& a, const Plane& b, const Plane& c, Point& p) {
  const Point u = cross(b.normal, c.normal);
  const Point v = cross(c.normal, a.normal);
  const Point w = cross(a.normal, b.normal);
  const Real determinant = dot(a.normal, u);
  if (std::fabs(determinant) < kParallel) return false;
  p = {{0, 0, 0}};
  for (int round = 0; round < 3; ++round) {
    const Real ra = (a.offset - dot(a.normal, p)) / determinant;
    const Real rb = (b.offset - dot(b.normal, p)) / determinant;
    const Real rc = (c.offset - dot(c.normal, p)) / determinant;
    p = p + (ra * u + (rb * v + rc * w));
  }
  return true;
}

void keep_nearer(const Point& p, const Point& candidate, Real& best, Point* nearest) {
  const Real far = length(p - candidate);
  if (far >= best) return;
  best = far;
  if (nearest != nullptr) *nearest = candidate;
}

}  // namespace

std::vector<Plane> planes_of(const World& world, const tern::Fence& fence) {
  std::vector<Plane> planes;
  const Point origin = point(world.spec.origin);
  for (int k = 0; k < fence.count; ++k) {
    const Point normal = point(fence.planes[k].normal);
    const Real size = length(normal);
    planes.push_back({(1 / size) * normal, (fence.planes[k].offset - dot(normal, origin)) / size});
  }
  return planes;
}

Solid::Solid(const World& world, const tern::Fence& fence) : planes_(planes_of(world, fence)) {
  // A voxel more than what can be too near: in a flat boundary without a radius, a keep-out needs an inside.
  const Real reach = static_cast<Real>(world.spec.radius) + world.spec.cell;
  for (int a = 0; a < 3; ++a) {
    Point up{{0, 0, 0}};
    up[a] = 1;
    const Real origin = axis(world.spec.origin, a);
    planes_.push_back({up, axis(world.spec.boundary.upper, a) - origin + reach});
    planes_.push_back({-1.0L * up, origin - axis(world.spec.boundary.lower, a) + reach});
  }
  find_edges();
  find_corners();
}

void Solid::find_edges() {
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    for (std::size_t j = i + 1; j < planes_.size(); ++j) {
      const Point along = cross(planes_[i].normal, planes_[j].normal);
      const Real sine = length(along);
      if (sine < kParallel) continue;
      const Plane across{(1 / sine) * along, 0};
      Point on{};
      if (common_point(planes_[i], planes_[j], across, on)) edges_.push_back({on, across.normal});
    }
  }
}

void Solid::find_corners() {
  const std::size_t count = planes_.size();
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      for (std::size_t k = j + 1; k < count; ++k) {
        Point p{};
        if (common_point(planes_[i], planes_[j], planes_[k], p) && holds(p)) corners_.push_back(p);
      }
    }
  }
}

bool Solid::holds(const Point& p) const {
  for (const Plane& plane : planes_) {
    if (!behind(plane, p)) return false;
  }
  return true;
}

Real Solid::distance(const Point& p, Point* nearest) const {
  Real outmost = -1e30L;
  for (const Plane& plane : planes_) outmost = std::max(outmost, dot(plane.normal, p) - plane.offset);
  if (outmost <= 0) return corners_.empty() ? 1e30L : outmost;
  Real best = 1e30L;
  for (const Point& corner : corners_) keep_nearer(p, corner, best, nearest);
  for (const Plane& plane : planes_) {
    const Real height = dot(plane.normal, p) - plane.offset;
    if (height <= 0 || height >= best) continue;
    const Point foot = p - height * plane.normal;
    if (holds(foot)) keep_nearer(p, foot, best, nearest);
  }
  for (const Edge& edge : edges_) {
    const Point foot = edge.on + dot(edge.along, p - edge.on) * edge.along;
    if (length(p - foot) < best && holds(foot)) keep_nearer(p, foot, best, nearest);
  }
  return best;
}

/// True where some plane proves that the hull of the piece keeps `least`: a face of the solid, or the one that touches
/// it where it is nearest to the piece's middle.
bool Solid::apart(const Curve& curve, Real least) const {
  const auto beyond = [&](const Point& normal, Real offset) {
    for (int i = 0; i <= curve.degree; ++i) {
      if (dot(normal, curve.p[i]) - offset < least) return false;
    }
    return true;
  };
  for (const Plane& plane : planes_) {
    if (beyond(plane.normal, plane.offset)) return true;
  }
  const Point middle = 0.5L * (curve.first() + curve.last());
  Point on{};
  const Real far = distance(middle, &on);
  if (far > 1e29L) return true;
  if (far <= 0) return false;
  const Point normal = (1 / far) * (middle - on);
  return beyond(normal, dot(normal, on));
}

Verdict Solid::keeps(const Curve& whole, Real least) const {
  constexpr int kMostPieces = 2000;
  std::vector<Curve> open{whole};
  for (int pieces = 0; !open.empty(); ++pieces) {
    const Curve curve = open.back();
    open.pop_back();
    if (apart(curve, least)) continue;
    if (distance(curve.first()) < least) return {Proof::kBroken, curve.from};
    if (distance(curve.last()) < least) return {Proof::kBroken, curve.to};
    if (pieces == kMostPieces) return {Proof::kUnproven, curve.from};
    Curve left;
    Curve right;
    split(curve, left, right);
    open.push_back(right);
    open.push_back(left);
  }
  return {Proof::kProven, 0};
}

}  // namespace tern_attack
