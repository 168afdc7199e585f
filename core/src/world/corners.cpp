// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/corners.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "world/facet.hpp"
#include "world/narrow_boundary.hpp"

namespace tern {
namespace {

/// Tolerances, as shares of the vicinity's scale. Each face of a solid moves out by kHair. The hull of the corners that
/// are found then contains the whole solid, whatever rounding does to needles and nearly equal planes:
/// - the other planes cut a facet kSpare further out. That is more than the rounding of a cut (20 roundings, 2.2e-15),
///   so a facet loses only what rounding takes from its corners (4e-16 per cut, 3e-14 in all);
/// - a plane that the facet exceeds by at most kSpare does not cut it, so equal planes add no corners to edges;
/// - corners closer than kSame count as one. kSame is ten times kSpare, so facets at ordinary angles share corners.
/// hull + ball(kSame + 3e-14) then contains solid + ball(kHair), so the hull contains the solid with 3e-14 to spare.
constexpr double kHair = 1e-13;
constexpr double kSpare = 4e-15;
constexpr double kSame = 4e-14;

/// Nearly equal planes make copies of a corner that are further apart than kSame. If the copies do not fit, kHair and
/// kSame grow by a factor of kCoarser, at most kTrials - 1 times over.
constexpr double kCoarser = 16.0;
constexpr int kTrials = 7;

Box grown(const Box& box, double all_round) {
  const Vec3 more{all_round, all_round, all_round};
  return {box.lower - more, box.upper + more};
}

bool known_corner(const Solids& solids, const SolidParts& parts, const Vec3& corner, double same) {
  for (int k = 0; k < parts.corners; ++k) {
    if (distance(solids.corners[parts.first_corner + k], corner) <= same) return true;
  }
  return false;
}

/// Tolerances for finding the corners of a solid, metres.
struct Fineness {
  double hair;
  double same;
  double spare;
};

/// False if they do not fit.
bool add_corners(const Facet& facet, const Vicinity& around, double same, Solids& solids, SolidParts& parts) {
  for (int k = 0; k < facet.count; ++k) {
    const Vec3 corner = ((facet.foot + facet.corner[k][0] * facet.u) + facet.corner[k][1] * facet.v) + around.center;
    if (known_corner(solids, parts, corner, same)) continue;
    if (is_full(solids.corner_count == kMaxSolidCorners)) return false;
    solids.corners[solids.corner_count++] = corner;
    ++parts.corners;
  }
  return true;
}

/// Half-space `index` of the solid's faces followed by those of the vicinity. It is relative to the centre of the
/// vicinity, and moved out by `out`.
Halfspace plane_about(const Solids& solids, const SolidParts& parts, const Vicinity& around, int index, double out) {
  const bool own = index < parts.faces;
  const Halfspace& plane = own ? solids.faces[parts.first_face + index] : around.faces[index - parts.faces];
  const double offset = own ? plane.offset - dot(plane.normal, around.center) : plane.offset;
  return {plane.normal, offset + out};
}

/// Adds the corners of all facets. False if they do not fit.
bool add_all_corners(const Vicinity& around, const Fineness& fine, Solids& solids, SolidParts& parts) {
  const int count = parts.faces + kBoxPlanes;
  for (int i = 0; i < count; ++i) {
    const Halfspace plane = plane_about(solids, parts, around, i, fine.hair);
    if (absolute(plane.offset) > around.reach) continue;  // misses the vicinity
    Facet facet = square_on(plane, around.reach);
    bool left = true;
    for (int j = 0; j < count && left; ++j) {
      if (j != i) left = cut(plane_about(solids, parts, around, j, fine.hair + fine.spare), facet, fine.spare);
    }
    if (left && !add_corners(facet, around, fine.same, solids, parts)) return false;
  }
  return true;
}

}  // namespace

Vicinity vicinity_of(const Grid& grid, const Solids& solids, double all_round) noexcept {
  const GridSpec& spec = grid.spec();
  const Box whole =
      grown({{0.0, 0.0, 0.0}, {spec.dims.x * spec.cell, spec.dims.y * spec.cell, spec.dims.z * spec.cell}}, all_round);
  Box box = grid.local_boundary();
  for (int a = 0; a < 3; ++a) box = within_walls(solids, box, a);
  box = grown(box, all_round);
  const Vec3 center = 0.5 * (box.lower + box.upper);
  Vicinity around{center, distance(box.lower, box.upper), distance(whole.lower, whole.upper), {}};
  box_planes({box.lower - around.center, box.upper - around.center}, around.faces);
  return around;
}

double corner_tolerance(const Vicinity& around) noexcept {
  return kHair * around.scale;
}

bool find_corners(const Vicinity& around, Solids& solids, SolidParts& parts) noexcept {
  Fineness fine{kHair * around.scale, kSame * around.scale, kSpare * around.scale};
  for (int trial = 0; trial < kTrials; ++trial) {
    solids.corner_count = parts.first_corner;
    parts.corners = 0;
    if (add_all_corners(around, fine, solids, parts)) return true;
    fine.hair *= kCoarser;
    fine.same *= kCoarser;
  }
  return false;
}

}  // namespace tern
