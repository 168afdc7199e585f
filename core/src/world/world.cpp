// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/world.hpp"

#include "base/math.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

/// True if the cube lies beyond some face of the solid, or beyond the solid along an axis, by `by`.
bool lies_beyond(const Box& cube, const ConvexSolid& solid, double radius, double hair) {
  for (int f = 0; f < solid.face_count + kBoxPlanes; ++f) {
    Vec3 normal{0.0, 0.0, 0.0};
    if (f < kBoxPlanes) axis(normal, f / 2) = f % 2 == 0 ? 1.0 : -1.0;
    if (f >= kBoxPlanes) normal = solid.faces[f - kBoxPlanes].normal;
    if (least_over(cube, normal) >= solid_reach(normal, solid) + radius - hair) return true;
  }
  return false;
}

}  // namespace

double least_over(const Box& box, const Vec3& normal) noexcept {
  const Vec3 corner{normal.x < 0.0 ? box.upper.x : box.lower.x, normal.y < 0.0 ? box.upper.y : box.lower.y,
                    normal.z < 0.0 ? box.upper.z : box.lower.z};
  return dot(normal, corner);
}

double World::touching() const noexcept {
  return solids_ != nullptr ? solids_->touching : contact_tolerance(spec());
}

std::int32_t World::first_broken(const Vec3& from, const Vec3& to) const noexcept {
  if (solids_ == nullptr) return kNoSolid;
  for (int p = 0; p < solids_->wall_count; ++p) {
    const Halfspace& wall = solids_->walls[p];
    const double far = larger(dot(wall.normal, from), dot(wall.normal, to));
    if (far > wall.offset + solids_->touching) return solids_->wall_index[p];
  }
  const double radius = spec().clearance();
  for (int k = 0; k < solids_->solid_count; ++k) {
    const HullGap gap = solid_gap(from, to, solid(k), radius);
    if (gap.distance < radius - solids_->touching) return solids_->parts[k].index;
  }
  return kNoSolid;
}

std::int32_t World::first_over(const Box& cube) const noexcept {
  if (solids_ == nullptr) return kNoSolid;
  const double hair = 0.5 * kLatticeTolerance * (cube.upper.x - cube.lower.x);
  for (int p = 0; p < solids_->wall_count; ++p) {
    const double most = -least_over(cube, -1.0 * solids_->walls[p].normal);
    if (most > solids_->walls[p].offset + hair) return solids_->wall_index[p];
  }
  for (int k = 0; k < solids_->solid_count; ++k) {
    if (!lies_beyond(cube, solid(k), spec().clearance(), hair)) return solids_->parts[k].index;
  }
  return kNoSolid;
}

bool World::line_clear(const Vec3& from, const Vec3& to) const noexcept {
  return solids_clear(from, to) && segment_clear(*voxels_, from, to, spec().clearance());
}

}  // namespace tern
