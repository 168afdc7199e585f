// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/fence_clear.hpp"

#include "base/math.hpp"
#include "prove/fence_plane.hpp"

namespace tern {
namespace {

/// Two planes have no edge, and three no corner, if the squared sine of their angle, or their squared volume, is no
/// more than this.
constexpr double kParallel = 1e-9;
/// Corners are looked for if a keep-out has no more faces than this.
constexpr int kCornerFaces = 12;

/// True if all points lie beyond the plane by the distance. The normal may have any length.
bool lies_beyond(const Halfspace& plane, double distance, const Vec3* points, int count) {
  const double wanted = plane.offset + distance * length(plane.normal);
  for (int i = 0; i < count; ++i) {
    if (!(dot(plane.normal, points[i]) >= wanted)) return false;
  }
  return true;
}

/// The plane through the edge of planes a and b, at right angles to the line from that edge to `point`. The fence lies
/// behind it, because it lies behind both planes. False if one of the two planes is nearer than the edge.
bool edge_plane(const Halfspace& a, const Halfspace& b, const Vec3& point, Halfspace& edge) {
  const double depth_a = dot(a.normal, point) - a.offset;
  const double depth_b = dot(b.normal, point) - b.offset;
  const double cosine = dot(a.normal, b.normal);
  const double part_a = depth_a - cosine * depth_b;
  const double part_b = depth_b - cosine * depth_a;
  if (!(1.0 - cosine * cosine > kParallel) || !(part_a > 0.0) || !(part_b > 0.0)) return false;
  edge = {part_a * a.normal + part_b * b.normal, part_a * a.offset + part_b * b.offset};
  return true;
}

/// The plane through the corner of three planes, at right angles to the line from that corner to `point`. The fence
/// lies behind it, because it lies behind all three. False if an edge or a face is nearer than the corner.
bool corner_plane(const Halfspace& a, const Halfspace& b, const Halfspace& c, const Vec3& point, Halfspace& corner) {
  const Vec3 across_a = cross(b.normal, c.normal);
  const Vec3 across_b = cross(c.normal, a.normal);
  const Vec3 across_c = cross(a.normal, b.normal);
  const double volume = dot(a.normal, across_a);
  if (!(volume * volume > kParallel)) return false;
  // From the corner to the point, times the volume.
  const Vec3 away = volume * point - (a.offset * across_a + b.offset * across_b + c.offset * across_c);
  const double part_a = dot(away, across_a);
  const double part_b = dot(away, across_b);
  const double part_c = dot(away, across_c);
  if (!(part_a > 0.0) || !(part_b > 0.0) || !(part_c > 0.0)) return false;
  corner = {(part_a * a.normal + part_b * b.normal) + part_c * c.normal,
            (part_a * a.offset + part_b * b.offset) + part_c * c.offset};
  return true;
}

bool keeps_in(const Fence& fence, const FenceRule& rule, const Vec3* points, int count) {
  for (int k = 0; k < fence.count; ++k) {
    const Halfspace plane = local_plane(fence.planes[k], rule.frame);
    for (int i = 0; i < count; ++i) {
      if (!(dot(plane.normal, points[i]) <= plane.offset + rule.tolerance)) return false;
    }
  }
  return true;
}

/// A keep-out whose faces do not cut a hull off.
struct Solidity {
  const Fence& fence;
  const FenceRule& rule;
  const Vec3* points;
  int count;
  Vec3 middle;

  Halfspace face(int k) const { return local_plane(fence.planes[k], rule.frame); }
  bool is_behind(const Halfspace& plane) const { return lies_beyond(plane, rule.distance, points, count); }
};

bool edge_cuts_off(const Solidity& solid) {
  Halfspace plane;
  for (int k = 0; k < solid.fence.count; ++k) {
    const Halfspace a = solid.face(k);
    for (int l = k + 1; l < solid.fence.count; ++l) {
      if (edge_plane(a, solid.face(l), solid.middle, plane) && solid.is_behind(plane)) return true;
    }
  }
  return false;
}

bool corner_cuts_off(const Solidity& solid) {
  if (solid.fence.count > kCornerFaces) return false;
  Halfspace faces[kCornerFaces];
  Halfspace plane;
  for (int k = 0; k < solid.fence.count; ++k) {
    faces[k] = solid.face(k);
    for (int l = 0; l < k; ++l) {
      for (int m = 0; m < l; ++m) {
        if (corner_plane(faces[k], faces[l], faces[m], solid.middle, plane) && solid.is_behind(plane)) return true;
      }
    }
  }
  return false;
}

bool keeps_out(const Fence& fence, const FenceRule& rule, const Vec3* points, int count) {
  for (int k = 0; k < fence.count; ++k) {
    if (lies_beyond(local_plane(fence.planes[k], rule.frame), rule.distance, points, count)) return true;
  }
  const Solidity solid{fence, rule, points, count, 0.5 * (points[0] + points[count - 1])};
  return edge_cuts_off(solid) || corner_cuts_off(solid);
}

}  // namespace

bool fence_clear(const Fence& fence, const FenceRule& rule, const Vec3* points, int count) noexcept {
  if (fence.kind == FenceKind::kKeepIn) return keeps_in(fence, rule, points, count);
  return keeps_out(fence, rule, points, count);
}

Operations fence_operations(const Fence& fence) noexcept {
  const Operations edges = fence.kind == FenceKind::kKeepOut ? fence.count * (fence.count - 1) / 2 : 0;
  return ops::kPiece + 16 * ops::kDot * (fence.count + edges);
}

double fence_excess(const Fence& fence, const FenceRule& rule, const Vec3& point) noexcept {
  double most = -__builtin_inf();
  for (int k = 0; k < fence.count; ++k) {
    const Halfspace plane = local_plane(fence.planes[k], rule.frame);
    most = larger(most, dot(plane.normal, point) - plane.offset);
  }
  return fence.kind == FenceKind::kKeepIn ? most - rule.tolerance : rule.distance - most;
}

}  // namespace tern
