// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/keep_out.hpp"

#include "base/math.hpp"
#include "prove/fence_plane.hpp"

namespace tern {
namespace {

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
    const bool keeps_in = fence.kind == FenceKind::kKeepIn;
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

bool keep_out_cut_off(const Grid& grid, const Fence* fences, int count, int index, const Hints& hints,
                      const Apart& hull, FenceScratch& scratch) noexcept {
  const Surroundings around = surroundings_of(grid);
  find_solid(grid, fences, count, index, around, scratch.exact);
  if (scratch.exact.empty) return true;
  round_solid(scratch.exact, scratch.quick);
  const Normals normals{hints, fences[index]};
  // Doubles suffice for a fence without nearly parallel planes.
  for (int k = 0; k < normals.count(); ++k) {
    const Vec3 normal = normals.at(k);
    if (is_unit(normal) && lies_beyond(scratch.quick, rounded(asked_along(normal, hull, around.center)))) return true;
  }
  for (int k = 0; k < normals.count(); ++k) {
    const Vec3 normal = normals.at(k);
    if (is_unit(normal) && lies_beyond(scratch.exact, asked_along(normal, hull, around.center))) return true;
  }
  return false;
}

}  // namespace tern
