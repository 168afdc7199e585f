// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fences once more, from their half-spaces alone: a linear programme by the dual simplex method, whose every step holds
// a proven bound. The corridor works with corners instead.
#include "base/math.hpp"
#include "check/check_stage.hpp"

namespace tern {
namespace {

/// Steps of one linear programme; each raises the bound. One that needs more is not proven, and so refused.
constexpr int kMaxPivots = 4 * kMaxFencePlanes;
/// Metres by which a point may be outside a half-space and count as in it, and the least pivot.
constexpr double kFeasible = 1e-10;
constexpr double kLeastPivot = 1e-12;

/// A keep-out's half-spaces, then the faces of the boundary grown by the radius.
struct Solid {
  const Halfspace* planes;
  int count;
  Halfspace faces[6];
};

const Halfspace& plane_of(const Solid& solid, int index) {
  return index < solid.count ? solid.planes[index] : solid.faces[index - solid.count];
}

/// Three half-spaces; where their planes meet is the vertex.
struct Basis {
  int index[3];
  Vec3 across[3];  ///< rows of the inverse of the normals, transposed: vertex = sum of offset * across
};

bool invert(const Solid& solid, Basis& basis) {
  const Vec3& a = plane_of(solid, basis.index[0]).normal;
  const Vec3& b = plane_of(solid, basis.index[1]).normal;
  const Vec3& c = plane_of(solid, basis.index[2]).normal;
  const double determinant = dot(a, cross(b, c));
  if (absolute(determinant) < kLeastPivot) return false;
  basis.across[0] = (1.0 / determinant) * cross(b, c);
  basis.across[1] = (1.0 / determinant) * cross(c, a);
  basis.across[2] = (1.0 / determinant) * cross(a, b);
  return true;
}

Vec3 vertex_of(const Solid& solid, const Basis& basis) {
  Vec3 vertex{0.0, 0.0, 0.0};
  for (int k = 0; k < 3; ++k) vertex = vertex + plane_of(solid, basis.index[k]).offset * basis.across[k];
  return vertex;
}

/// The half-space that the vertex breaks most; -1 where it is in all.
int most_broken(const Solid& solid, const Vec3& vertex) {
  int worst = -1;
  double excess = kFeasible;
  for (int p = 0; p < solid.count + 6; ++p) {
    const double beyond = dot(plane_of(solid, p).normal, vertex) - plane_of(solid, p).offset;
    if (beyond <= excess) continue;
    excess = beyond;
    worst = p;
  }
  return worst;
}

/// The member of the basis that has to leave for half-space `entering`, so that all multipliers of `normal` stay >= 0:
/// normal + sum of multiplier * basis normal = 0. -1 where none can: the half-spaces have no point in common.
int leaving(const Solid& solid, const Basis& basis, const Vec3& normal, int entering) {
  int best = -1;
  double least = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double share = dot(plane_of(solid, entering).normal, basis.across[k]);
    if (share <= kLeastPivot) continue;
    const double ratio = larger(-dot(normal, basis.across[k]), 0.0) / share;
    if (best >= 0 && ratio >= least) continue;
    least = ratio;
    best = k;
  }
  return best;
}

/// True where normal . p >= wanted is proven for all of the solid.
bool lies_beyond(const Solid& solid, const Vec3& normal, double wanted) {
  Basis basis;
  for (int a = 0; a < 3; ++a) basis.index[a] = solid.count + 2 * a + (axis(normal, a) < 0.0 ? 0 : 1);
  for (int pivot = 0; pivot < kMaxPivots; ++pivot) {
    if (!invert(solid, basis)) return false;
    const Vec3 vertex = vertex_of(solid, basis);
    if (dot(normal, vertex) >= wanted) return true;
    const int entering = most_broken(solid, vertex);
    if (entering < 0) return false;
    const int out = leaving(solid, basis, normal, entering);
    if (out < 0) return true;
    basis.index[out] = entering;
  }
  return false;
}

Solid solid_of(const Grid& grid, const Fences& fences, const KeepOut& fence) {
  const Box boundary = grid.local_boundary();
  const double radius = grid.spec().radius;
  Solid solid{fences.planes + fence.first_plane, fence.planes, {}};
  for (int a = 0; a < 3; ++a) {
    solid.faces[2 * a] = {{0.0, 0.0, 0.0}, axis(boundary.upper, a) + radius};
    solid.faces[2 * a + 1] = {{0.0, 0.0, 0.0}, radius - axis(boundary.lower, a)};
    axis(solid.faces[2 * a].normal, a) = 1.0;
    axis(solid.faces[2 * a + 1].normal, a) = -1.0;
  }
  return solid;
}

bool some_plane_cuts_off(const Polyhedron& polyhedron, const Solid& solid, double radius) {
  for (int p = 0; p < all_planes(polyhedron); ++p) {
    const Halfspace& plane = polyhedron.planes[p];
    if (lies_beyond(solid, plane.normal, plane.offset + radius - kCheckDistance)) return true;
  }
  return false;
}

}  // namespace

bool keep_outs_clear(const Grid& grid, const Polyhedron& polyhedron, const Fences& fences) noexcept {
  for (int k = 0; k < fences.keep_out_count; ++k) {
    const Solid solid = solid_of(grid, fences, fences.keep_out[k]);
    if (!some_plane_cuts_off(polyhedron, solid, grid.spec().radius)) return false;
  }
  return true;
}

bool keep_ins_hold(const Segment& segment, const Fences& fences) noexcept {
  for (const Vec3& point : segment.points) {
    for (int p = 0; p < fences.keep_in_count; ++p) {
      if (dot(fences.keep_in[p].normal, point) > fences.keep_in[p].offset + kCheckDistance) return false;
    }
  }
  return true;
}

}  // namespace tern
