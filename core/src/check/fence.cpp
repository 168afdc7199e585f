// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Checks the fences from the caller's half-spaces alone. They are moved into the frame of the check without rounding.
// So the proof depends neither on where the map is nor on how the earlier stages read the fences.
#include "base/math.hpp"
#include "check/check_stage.hpp"

namespace tern {
namespace {

/// An offset this large lies beyond every map, since coordinates of maps are below 1e19. Its products would overflow.
constexpr double kBeyondAnyMap = 1e100;
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

/// The half-space relative to the point `frame` + `center` of the world, with a normal of unit length up to rounding.
Plane<DoubleDouble> plane_about(const Halfspace& world, const Vec3& frame, const Vec3& center) {
  const double scale = 1.0 / length(world.normal);
  const DoubleDouble offset = depth_of(depth_of(DoubleDouble(world.offset), world.normal, frame), world.normal, center);
  return {{exact_product(scale, world.normal.x), exact_product(scale, world.normal.y),
           exact_product(scale, world.normal.z)},
          DoubleDouble(scale) * offset};
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
void find_solid(const Grid& grid, const AskedFences& fences, int keep_out, const Surroundings& around,
                Solid<DoubleDouble>& solid) {
  const double grown = reach_of(grid.spec());
  begin_solid(around, solid);
  for (int k = 0; k < fences.count; ++k) {
    const AskedFence& fence = fences.fence[k];
    const bool keeps_in = fence.kind == FenceKind::kKeepIn;
    if (!keeps_in && k != keep_out) continue;
    for (int p = 0; p < fence.count; ++p) {
      add_plane(fences.planes[fence.first + p], grid.spec().origin, around.center, keeps_in ? grown : 0.0, solid);
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

/// The distance that the solid must keep, and the tolerance of that, metres.
struct Asked {
  double radius;
  double tolerance;
};

/// What a half-space of the polyhedron requires of the solid: to lie beyond it by the radius, less the tolerance.
Plane<DoubleDouble> asked_by(const Halfspace& plane, const Vec3& center, const Asked& asked) {
  const DoubleDouble wanted =
      depth_of(DoubleDouble(plane.offset), plane.normal, center) + exact_sum(asked.radius, -asked.tolerance);
  return {{plane.normal.x, plane.normal.y, plane.normal.z}, wanted};
}

/// True if a half-space of the polyhedron cuts the fence off. Tries in doubles first, which suffices for a fence
/// without nearly parallel planes. If false, `found` receives the half-space that comes nearest, and the metres that it
/// lacks.
bool some_plane_cuts_off(const Polyhedron& polyhedron, const Vec3& center, const Asked& asked, FenceScratch& scratch,
                         CheckReport& found) {
  if (scratch.exact.empty) return true;
  round_solid(scratch.exact, scratch.quick);
  for (int p = 0; p < all_planes(polyhedron); ++p) {
    if (lies_beyond(scratch.quick, rounded(asked_by(polyhedron.planes[p], center, asked)))) return true;
  }
  int nearest = -1;
  double least = 0.0;
  for (int p = 0; p < all_planes(polyhedron); ++p) {
    const double missing = shortfall(scratch.exact, asked_by(polyhedron.planes[p], center, asked));
    if (!(missing > 0.0)) return true;
    if (nearest >= 0 && !(missing < least)) continue;
    nearest = p;
    least = missing;
  }
  found.plane = nearest;
  found.excess = least;
  return refuse(Finding::kFence, found);
}

/// True if normal . (frame + point) <= offset, to within the tolerance. If false, `found` receives the metres beyond
/// that.
bool holds(const Halfspace& world, const Vec3& frame, const Vec3& point, double tolerance, CheckReport& found) {
  if (absolute(world.offset) > kBeyondAnyMap) return world.offset > 0.0;
  const DoubleDouble depth = depth_of(depth_of(DoubleDouble(world.offset), world.normal, frame), world.normal, point);
  const double norm = length(world.normal);
  if (depth.high >= -tolerance * norm) return true;
  found.excess = larger(0.0, -depth.high / norm - tolerance);
  return false;
}

bool inside(const Halfspace& world, const Segment& segment, const Vec3& origin, double tolerance, CheckReport& found) {
  for (const Vec3& point : segment.points) {
    if (!holds(world, origin, point, tolerance, found)) return false;
  }
  return true;
}

}  // namespace

bool keep_outs_clear(const Grid& grid, const Polyhedron& polyhedron, const AskedFences& fences, FenceScratch& scratch,
                     CheckReport& found) noexcept {
  const Surroundings around = surroundings_of(grid);
  const Asked asked{grid.spec().clearance(), fence_tolerance(grid)};
  for (int k = 0; k < fences.count; ++k) {
    if (fences.fence[k].kind != FenceKind::kKeepOut) continue;
    find_solid(grid, fences, k, around, scratch.exact);
    if (some_plane_cuts_off(polyhedron, around.center, asked, scratch, found)) continue;
    found.fence = k;
    return false;
  }
  return true;
}

bool keep_ins_hold(const Segment& segment, const AskedFences& fences, const Vec3& origin, double tolerance,
                   CheckReport& found) noexcept {
  for (int k = 0; k < fences.count; ++k) {
    const AskedFence& fence = fences.fence[k];
    if (fence.kind != FenceKind::kKeepIn) continue;
    for (int p = 0; p < fence.count; ++p) {
      if (inside(fences.planes[fence.first + p], segment, origin, tolerance, found)) continue;
      found.fence = k;
      found.plane = p;
      return refuse(Finding::kFence, found);
    }
  }
  return true;
}

}  // namespace tern
