// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A request's geofences as the stages use them: local frame, unit normals, the corners of keep-outs.
#ifndef TERN_FENCE_FENCES_HPP
#define TERN_FENCE_FENCES_HPP

#include <cstdint>

#include "grid/hull_gap.hpp"
#include "tern/config.hpp"
#include "tern/fence.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"

namespace tern {

/// A polyhedron with n facets has at most 2 n - 4 corners; six facets of each belong to the box that it is cut by.
constexpr int kMaxFenceCorners = 2 * kMaxFencePlanes + 8 * kMaxFences;

/// One keep-out: its half-spaces, and the corners of the part of it that can come within the radius of the boundary.
struct KeepOut {
  std::int32_t first_plane;
  std::int32_t planes;
  std::int32_t first_corner;
  std::int32_t corners;  ///< > 0
  std::int32_t index;    ///< in the request's list
};

/// Keep-ins come to one list of half-spaces that hold everywhere.
struct Fences {
  std::int32_t keep_in_count;
  std::int32_t keep_out_count;
  std::int32_t plane_count;
  std::int32_t corner_count;
  double touching;  ///< metres by which a point may be nearer than the radius: contact_tolerance, and the corners' own
  Halfspace keep_in[kMaxFencePlanes];
  std::int32_t keep_in_index[kMaxFencePlanes];  ///< the fence of each in the request's list
  KeepOut keep_out[kMaxFences];
  Halfspace planes[kMaxFencePlanes];  ///< of the keep-outs
  Vec3 corners[kMaxFenceCorners];
};

inline Hull hull_of(const Fences& fences, const KeepOut& fence) noexcept {
  return {fences.corners + fence.first_corner, fence.corners};
}

/// Reads `count` fences (world frame) for planning on `grid`. A keep-out that cannot come within the radius of the
/// boundary is left out. kOk; kInvalidArgument for null, a negative or zero count, a kind that is none or a normal that
/// is too short or long; kNonFiniteInput; kFencesFull; kFencePlanesFull. `fences` is undefined unless kOk.
Status load_fences(const Grid& grid, const Fence* list, std::int32_t count, Fences& fences) noexcept;

/// True where the segment (local frame; equal ends are a point) lies in each keep-in and keeps `radius` from each
/// keep-out, but for `touching`.
bool fences_clear(const Fences& fences, const Vec3& from, const Vec3& to, double radius) noexcept;

/// The first fence for which that does not hold, as its index in the request's list, keep-ins first; kNoFence for none.
std::int32_t fence_broken(const Fences& fences, const Vec3& from, const Vec3& to, double radius) noexcept;

}  // namespace tern

#endif
