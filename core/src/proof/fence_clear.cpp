// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "proof/fence_clear.hpp"

#include "base/math.hpp"

namespace tern {
namespace {

/// Two planes have no edge if the squared sine of their angle is no more than this.
constexpr double kParallel = 1e-9;

/// normal . point <= offset, in the points' frame, with a normal of length 1.
struct Plane {
  Vec3 normal;
  double offset;
};

Plane plane_of(const Halfspace& world, const Vec3& frame) {
  const double scale = 1.0 / length(world.normal);
  return {scale * world.normal, scale * (world.offset - dot(world.normal, frame))};
}

/// True if all points lie beyond the plane by the distance. The normal may have any length.
bool lies_beyond(const Plane& plane, double distance, const Vec3* points, int count) {
  const double wanted = plane.offset + distance * length(plane.normal);
  for (int i = 0; i < count; ++i) {
    if (!(dot(plane.normal, points[i]) >= wanted)) return false;
  }
  return true;
}

/// The plane through the edge of planes a and b, at right angles to the line from that edge to `point`. The fence lies
/// behind it, because it lies behind both planes. False if one of the two planes is nearer than the edge.
bool edge_plane(const Plane& a, const Plane& b, const Vec3& point, Plane& edge) {
  const double depth_a = dot(a.normal, point) - a.offset;
  const double depth_b = dot(b.normal, point) - b.offset;
  const double cosine = dot(a.normal, b.normal);
  const double part_a = depth_a - cosine * depth_b;
  const double part_b = depth_b - cosine * depth_a;
  if (!(1.0 - cosine * cosine > kParallel) || !(part_a > 0.0) || !(part_b > 0.0)) return false;
  edge = {part_a * a.normal + part_b * b.normal, part_a * a.offset + part_b * b.offset};
  return true;
}

bool keeps_in(const Fence& fence, const FenceRule& rule, const Vec3* points, int count) {
  for (int k = 0; k < fence.count; ++k) {
    const Plane plane = plane_of(fence.planes[k], rule.frame);
    for (int i = 0; i < count; ++i) {
      if (!(dot(plane.normal, points[i]) <= plane.offset + rule.tolerance)) return false;
    }
  }
  return true;
}

/// True if a face or an edge of the fence cuts the hull off.
bool keeps_out(const Fence& fence, const FenceRule& rule, const Vec3* points, int count) {
  for (int k = 0; k < fence.count; ++k) {
    if (lies_beyond(plane_of(fence.planes[k], rule.frame), rule.distance, points, count)) return true;
  }
  const Vec3 middle = 0.5 * (points[0] + points[count - 1]);
  for (int k = 0; k < fence.count; ++k) {
    const Plane plane = plane_of(fence.planes[k], rule.frame);
    for (int l = k + 1; l < fence.count; ++l) {
      Plane edge;
      if (!edge_plane(plane, plane_of(fence.planes[l], rule.frame), middle, edge)) continue;
      if (lies_beyond(edge, rule.distance, points, count)) return true;
    }
  }
  return false;
}

}  // namespace

bool fence_clear(const Fence& fence, const FenceRule& rule, const Vec3* points, int count) noexcept {
  if (fence.kind == FenceKind::kKeepIn) return keeps_in(fence, rule, points, count);
  return keeps_out(fence, rule, points, count);
}

}  // namespace tern
