// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The convex solids of a world, and the walls around it. Local frame, metres.
#ifndef TERN_WORLD_SOLIDS_HPP
#define TERN_WORLD_SOLIDS_HPP

#include <cstdint>

#include "tern/config.hpp"
#include "tern/halfspace.hpp"
#include "tern/vec3.hpp"
#include "world/hull_gap.hpp"

namespace tern {

/// Capacities of a world: those of fences, because only fences bring walls and solids so far.
constexpr int kMaxWalls = kMaxFencePlanes;
constexpr int kMaxSolids = kMaxFences;
constexpr int kMaxSolidFaces = kMaxFencePlanes;
/// A polyhedron with n faces has at most 2 n - 4 corners. Each solid has six more faces from the box that cuts it.
constexpr int kMaxSolidCorners = 2 * kMaxSolidFaces + 8 * kMaxSolids;

/// Means "no wall and no solid" in place of an index in the request's list.
constexpr std::int32_t kNoSolid = -1;

/// A convex solid that the centre keeps its clearance from. The functions below are all that the stages ask of its
/// shape.
struct ConvexSolid {
  Hull hull;               ///< of the corners of the part that matters
  const Halfspace* faces;  ///< of the whole solid; unit normals
  int face_count;
};

/// The hull of some points, without faces.
inline ConvexSolid solid_of(const Vec3* points, int count) noexcept {
  return {{points, count}, nullptr, 0};
}

/// How far the solid reaches along a normal: the least and the largest value of normal . p.
inline double solid_support(const Vec3& normal, const ConvexSolid& solid) noexcept {
  return hull_support(normal, solid.hull);
}
inline double solid_reach(const Vec3& normal, const ConvexSolid& solid) noexcept {
  return hull_reach(normal, solid.hull);
}

/// The widest gap between a hull and the solid, as hull_gap.
inline HullGap solid_gap(const Hull& hull, const ConvexSolid& solid) noexcept {
  return hull_gap(hull, solid.hull);
}

/// The widest gap between a segment (equal ends are a point) and the solid, as widest_gap.
inline HullGap solid_gap(const Vec3& from, const Vec3& to, const ConvexSolid& solid, double enough) noexcept {
  return widest_gap(from, to, solid.hull, solid.faces, solid.face_count, enough);
}

/// Where the parts of a solid lie in Solids.
struct SolidParts {
  std::int32_t first_face;
  std::int32_t faces;
  std::int32_t first_corner;
  std::int32_t corners;  ///< > 0
  std::int32_t index;    ///< in the request's list
};

/// Storage of walls and solids. A wall is a half-space that the centre stays in; it must satisfy all of them.
struct Solids {
  std::int32_t wall_count;
  std::int32_t solid_count;
  std::int32_t timed_count;  ///< behind these: solids of fences for a while, which no world has
  std::int32_t face_count;
  std::int32_t corner_count;
  double touching;  ///< metres that a point may be too close: contact_tolerance plus the corners' tolerance
  Halfspace walls[kMaxWalls];
  std::int32_t wall_index[kMaxWalls];  ///< index of each wall's fence in the request's list
  SolidParts parts[kMaxSolids];
  Halfspace faces[kMaxSolidFaces];
  Vec3 corners[kMaxSolidCorners];
};

inline ConvexSolid solid_of(const Solids& solids, const SolidParts& parts) noexcept {
  return {{solids.corners + parts.first_corner, parts.corners}, solids.faces + parts.first_face, parts.faces};
}

}  // namespace tern

#endif
