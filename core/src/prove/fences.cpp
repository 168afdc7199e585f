// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/fences.hpp"

#include "base/math.hpp"
#include "prove/half_space.hpp"

namespace tern {
namespace {

/// Two planes have no edge, and three no corner, if the squared sine of their angle, or their squared volume, is no
/// more than this.
constexpr double kParallel = 1e-9;

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

bool keeps_in(const Fence& fence, const FenceRule& rule, const Vec3* points, int count, Work& work) {
  work.spend(ops::kPiece + kFaceOperations * fence.count);
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

bool edge_cuts_off(const Solidity& solid, Work& work) {
  work.spend(kEdgeOperations * (solid.fence.count * (solid.fence.count - 1) / 2));
  Halfspace plane;
  for (int k = 0; k < solid.fence.count; ++k) {
    const Halfspace a = solid.face(k);
    for (int l = k + 1; l < solid.fence.count; ++l) {
      if (edge_plane(a, solid.face(l), solid.middle, plane) && solid.is_behind(plane)) return true;
    }
  }
  return false;
}

bool corner_cuts_off(const Solidity& solid, Work& work) {
  const int count = solid.fence.count;
  if (count > kCornerFaces) return false;
  work.spend(kCornerOperations * (count * (count - 1) * (count - 2) / 6));
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

bool keeps_out(const Fence& fence, const FenceRule& rule, const Vec3* points, int count, Work& work) {
  work.spend(ops::kPiece + kFaceOperations * fence.count);
  for (int k = 0; k < fence.count; ++k) {
    if (lies_beyond(local_plane(fence.planes[k], rule.frame), rule.distance, points, count)) return true;
  }
  const Solidity solid{fence, rule, points, count, 0.5 * (points[0] + points[count - 1])};
  return edge_cuts_off(solid, work) || corner_cuts_off(solid, work);
}

/// Relative amount that is added to the box around a keep-out, and to the distance by which keep-ins grow. It exceeds
/// the rounding of these sizes.
constexpr double kHair = 1e-14;

/// How far beyond the places of the robot's centre a keep-out matters, metres. A part beyond the radius cannot be too
/// near. The distance is a voxel at least: without a radius, a keep-out in a flat boundary would be flat, and a line
/// inside it would only touch it.
double reach_of(const GridSpec& spec) {
  return (1.0 + kHair) * larger(spec.clearance(), spec.cell);
}

/// The boundary grown by reach_of(), local frame.
struct Surroundings {
  Vec3 center;
  Vec3 half;
};

Surroundings surroundings_of(const Grid& grid) {
  const Box boundary = grid.local_boundary();
  Surroundings around{0.5 * (boundary.lower + boundary.upper), {0.0, 0.0, 0.0}};
  for (int a = 0; a < 3; ++a) {
    const double across =
        larger(axis(boundary.upper, a) - axis(around.center, a), axis(around.center, a) - axis(boundary.lower, a));
    axis(around.half, a) = (1.0 + kHair) * across + reach_of(grid.spec());
  }
  return around;
}

void begin_solid(const Surroundings& around, Solid<DoubleDouble>& solid) {
  solid.count = 0;
  solid.empty = false;
  solid.reach = (1.0 + kHair) * length(around.half);
  for (int a = 0; a < 3; ++a) solid.half[a] = axis(around.half, a);
}

void add_faces(Solid<DoubleDouble>& solid) {
  const DoubleDouble none(0.0);
  for (int k = 0; k < kSolidFaces; ++k) {
    const DoubleDouble sign(k % 2 == 0 ? 1.0 : -1.0);
    const int a = k / 2;
    solid.planes[solid.count + k] = {{a == 0 ? sign : none, a == 1 ? sign : none, a == 2 ? sign : none},
                                     DoubleDouble(solid.half[a])};
  }
}

/// Adds the half-space, moved out by `out` metres. One that contains the whole box is left out. One that contains none
/// of the box makes the solid empty.
void add_plane(const Halfspace& world, const Vec3& frame, const Vec3& center, double out, Solid<DoubleDouble>& solid) {
  if (absolute(world.offset) > kBeyondAnyMap) {
    solid.empty = solid.empty || world.offset < 0.0;
    return;
  }
  Plane<DoubleDouble> plane = plane_about(world, frame, center);
  plane.offset = plane.offset + DoubleDouble(out);
  if (plane.offset.high < -solid.reach) solid.empty = true;
  if (absolute(plane.offset.high) <= solid.reach) solid.planes[solid.count++] = plane;
}

/// Finds the part of a keep-out that can be too near to a centre inside the boundary and all keep-ins.
void find_solid(const Grid& grid, const Fence* fences, int count, int keep_out, const Surroundings& around,
                Solid<DoubleDouble>& solid) {
  const double grown = reach_of(grid.spec());
  begin_solid(around, solid);
  for (int k = 0; k < count; ++k) {
    const Fence& fence = fences[k];
    const bool keeps_in = fence.kind == FenceKind::kKeepIn && !is_timed(fence);
    if (!keeps_in && k != keep_out) continue;
    for (int p = 0; p < fence.count; ++p) {
      add_plane(fence.planes[p], grid.spec().origin, around.center, keeps_in ? grown : 0.0, solid);
    }
  }
  add_faces(solid);
}

Plane<double> rounded(const Plane<DoubleDouble>& plane) {
  return {{plane.normal.x.high, plane.normal.y.high, plane.normal.z.high}, plane.offset.high};
}

void round_solid(const Solid<DoubleDouble>& from, Solid<double>& to) {
  to.count = from.count;
  to.empty = from.empty;
  to.reach = from.reach;
  for (int a = 0; a < 3; ++a) to.half[a] = from.half[a];
  for (int p = 0; p < from.count + kSolidFaces; ++p) to.planes[p] = rounded(from.planes[p]);
}

/// What the hull requires of the solid: to lie beyond the hull's furthest point along the normal, by the distance.
Plane<DoubleDouble> asked_along(const Vec3& normal, const Apart& hull, const Vec3& center) {
  const double offset = support_of(normal, hull.points, hull.count) + hull.distance * length(normal);
  return {{normal.x, normal.y, normal.z}, depth_of(DoubleDouble(offset), normal, center)};
}

/// The normals that are tried: those of the hints, then those that point at the keep-out's faces.
struct Normals {
  const Hints& hints;
  const Fence& fence;

  int count() const { return hints.count + fence.count; }
  Vec3 at(int k) const {
    if (k < hints.count) return hints.planes[k].normal;
    const Vec3& outward = fence.planes[k - hints.count].normal;
    return (-1.0 / length(outward)) * outward;
  }
};

}  // namespace

bool copy_asked(const Fence* list, std::int32_t count, AskedWorld& asked) noexcept {
  asked.count = 0;
  if (count > kMaxFences) return false;
  std::int32_t planes = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    if (list[i].count > kMaxFencePlanes - planes) return false;
    asked.fence[i] = list[i];
    asked.fence[i].planes = asked.planes + planes;
    for (std::int32_t p = 0; p < list[i].count; ++p) asked.planes[planes++] = list[i].planes[p];
  }
  asked.count = count;
  return true;
}

bool fence_clear(const Fence& fence, const FenceRule& rule, const Vec3* points, int count, Work& work) noexcept {
  if (fence.kind == FenceKind::kKeepIn) return keeps_in(fence, rule, points, count, work);
  return keeps_out(fence, rule, points, count, work);
}

double fence_excess(const Fence& fence, const FenceRule& rule, const Vec3& point) noexcept {
  double most = -__builtin_inf();
  for (int k = 0; k < fence.count; ++k) {
    const Halfspace plane = local_plane(fence.planes[k], rule.frame);
    most = larger(most, dot(plane.normal, point) - plane.offset);
  }
  return fence.kind == FenceKind::kKeepIn ? most - rule.tolerance : rule.distance - most;
}

bool keep_out_cut_off(const Grid& grid, const Fence* fences, int count, int index, const Hints& hints,
                      const Apart& hull, FenceScratch& scratch, Work& work) noexcept {
  work.spend(kKeepOutOperations);
  const Surroundings around = surroundings_of(grid);
  find_solid(grid, fences, count, index, around, scratch.exact);
  if (scratch.exact.empty) return true;
  round_solid(scratch.exact, scratch.quick);
  const Normals normals{hints, fences[index]};
  // Doubles suffice for a fence without nearly parallel planes.
  for (int k = 0; k < normals.count(); ++k) {
    const Vec3 normal = normals.at(k);
    work.spend(kQuickOperations);
    if (is_unit(normal) && lies_beyond(scratch.quick, rounded(asked_along(normal, hull, around.center)))) return true;
  }
  for (int k = 0; k < normals.count(); ++k) {
    const Vec3 normal = normals.at(k);
    work.spend(kExactOperations);
    if (is_unit(normal) && lies_beyond(scratch.exact, asked_along(normal, hull, around.center))) return true;
  }
  return false;
}

}  // namespace tern
