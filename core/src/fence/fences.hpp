// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A request's geofences as the stages use them: local frame, unit normals, the corners of keep-outs.
#ifndef TERN_FENCE_FENCES_HPP
#define TERN_FENCE_FENCES_HPP

#include <cstdint>

#include "base/fence_fault.hpp"
#include "grid/hull_gap.hpp"
#include "tern/config.hpp"
#include "tern/fence.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"

namespace tern {

/// A polyhedron with n facets has at most 2 n - 4 corners. Each keep-out has six more facets from the box that cuts it.
constexpr int kMaxFenceCorners = 2 * kMaxFencePlanes + 8 * kMaxFences;

/// One keep-out: its half-spaces, and the corners of the part of it that matters. This part lies within the radius of
/// the boundary and of each keep-in half-space that stands across an axis.
struct KeepOut {
  std::int32_t first_plane;
  std::int32_t planes;
  std::int32_t first_corner;
  std::int32_t corners;  ///< > 0
  std::int32_t index;    ///< in the request's list
};

/// All keep-ins together form one list of half-spaces; the centre must satisfy all of them.
struct Fences {
  std::int32_t keep_in_count;
  std::int32_t keep_out_count;
  std::int32_t plane_count;
  std::int32_t corner_count;
  double touching;  ///< metres that a point may be too close: contact_tolerance plus the corners' tolerance
  Halfspace keep_in[kMaxFencePlanes];
  std::int32_t keep_in_index[kMaxFencePlanes];  ///< index of each one's fence in the request's list
  KeepOut keep_out[kMaxFences];
  Halfspace planes[kMaxFencePlanes];  ///< of the keep-outs
  Vec3 corners[kMaxFenceCorners];
};

inline Hull hull_of(const Fences& fences, const KeepOut& fence) noexcept {
  return {fences.corners + fence.first_corner, fence.corners};
}

/// Reads `count` fences (world frame) for planning on `grid`. A keep-out without a part that matters is left out. kOk;
/// what find_fence_fault() says; kFencePlanesFull if the corners of a keep-out do not fit. `fences` is undefined unless
/// kOk.
FenceFault load_fences(const Grid& grid, const Fence* list, std::int32_t count, Fences& fences) noexcept;

/// True if the segment (local frame; equal ends make a point) lies inside every keep-in and keeps `radius` from every
/// keep-out, both to within `touching`.
bool fences_clear(const Fences& fences, const Vec3& from, const Vec3& to, double radius) noexcept;

/// The first fence that the closed cube of a voxel breaks, as its index in the request's list: a keep-in that does not
/// contain the whole cube, or a keep-out for which the cube is not beyond any face, or side along an axis, by the
/// radius. kNoFence if there is none: then the fence layer leaves a voxel with this cube free (fence/fence_layer.hpp).
std::int32_t fence_over(const Fences& fences, const Box& cube, double radius) noexcept;

/// The first fence for which fences_clear does not hold, as its index in the request's list. Keep-ins are tested first.
/// kNoFence if all hold.
std::int32_t fence_broken(const Fences& fences, const Vec3& from, const Vec3& to, double radius) noexcept;

}  // namespace tern

#endif
