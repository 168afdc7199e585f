// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fence/fences.hpp"

#include "base/capacity.hpp"
#include "base/double_double.hpp"
#include "base/facet.hpp"
#include "base/math.hpp"
#include "fence/narrow_boundary.hpp"
#include "grid/distance.hpp"

namespace tern {
namespace {

/// Tolerances, as shares of the surroundings' scale. Each plane of a keep-out moves out by kHair. The hull of the
/// corners that are found then contains the whole keep-out, whatever rounding does to needles and nearly equal planes:
/// - the other planes cut a facet kSpare further out. That is more than the rounding of a cut (20 roundings, 2.2e-15),
///   so a facet loses only what rounding takes from its corners (4e-16 per cut, 3e-14 in all);
/// - a plane that the facet exceeds by at most kSpare does not cut it, so equal planes add no corners to edges;
/// - corners closer than kSame count as one. kSame is ten times kSpare, so facets at ordinary angles share corners.
/// hull + ball(kSame + 3e-14) then contains keep-out + ball(kHair), so the hull contains the keep-out with 3e-14 to
/// spare.
constexpr double kHair = 1e-13;
constexpr double kSpare = 4e-15;
constexpr double kSame = 4e-14;

/// Nearly equal planes make copies of a corner that are further apart than kSame. If the copies do not fit, kHair and
/// kSame grow by a factor of kCoarser, at most kTrials - 1 times over.
constexpr double kCoarser = 16.0;
constexpr int kTrials = 7;

/// An offset this large lies beyond every map: coordinates of maps are below 1e19.
constexpr double kBeyondAnyMap = 1e100;

/// The region where the robot's centre may be, grown by the radius: the boundary within keep-ins along the axes.
/// Nothing beyond it matters. A keep-in therefore cuts keep-outs short just as a boundary of its size does. The region
/// grows by a voxel at least: in a region without height, a keep-out would have no inside, and a path through the
/// keep-out would only touch it.
struct Surroundings {
  Vec3 center;
  double reach;  ///< radius of a ball about the centre that contains the box
  double scale;  ///< the largest coordinate that a grid of this size may involve; rounding is proportional to it
  Halfspace faces[kBoxPlanes];
};

Box grown(const Box& box, double all_round) {
  const Vec3 more{all_round, all_round, all_round};
  return {box.lower - more, box.upper + more};
}

Surroundings surroundings_of(const Grid& grid, const Fences& fences) {
  const GridSpec& spec = grid.spec();
  const double all_round = larger(spec.clearance(), spec.cell);
  const Box whole =
      grown({{0.0, 0.0, 0.0}, {spec.dims.x * spec.cell, spec.dims.y * spec.cell, spec.dims.z * spec.cell}}, all_round);
  Box box = grid.local_boundary();
  for (int a = 0; a < 3; ++a) box = within_keep_ins(fences, box, a);
  box = grown(box, all_round);
  const Vec3 center = 0.5 * (box.lower + box.upper);
  Surroundings around{center, distance(box.lower, box.upper), distance(whole.lower, whole.upper), {}};
  box_planes({box.lower - around.center, box.upper - around.center}, around.faces);
  return around;
}

/// The half-space in the local frame, with a unit normal. The offset is shifted without rounding: far from the world's
/// origin, both the offset and the shift are large, and between two nearly parallel planes a small error grows.
Halfspace to_local_plane(const Grid& grid, const Halfspace& world) {
  const double norm = length(world.normal);
  const bool far = absolute(world.offset) > kBeyondAnyMap;  // products would overflow, and the shift is negligible
  const double shifted = far ? world.offset : depth_of(world.offset, world.normal, grid.spec().origin).high;
  return {(1.0 / norm) * world.normal, shifted / norm};
}

bool known_corner(const Fences& fences, const KeepOut& fence, const Vec3& corner, double same) {
  for (int k = 0; k < fence.corners; ++k) {
    if (distance(fences.corners[fence.first_corner + k], corner) <= same) return true;
  }
  return false;
}

/// Tolerances for finding the corners of a keep-out, metres.
struct Fineness {
  double hair;
  double same;
  double spare;
};

Status add_corners(const Facet& facet, const Surroundings& around, double same, Fences& fences, KeepOut& fence) {
  for (int k = 0; k < facet.count; ++k) {
    const Vec3 corner = ((facet.foot + facet.corner[k][0] * facet.u) + facet.corner[k][1] * facet.v) + around.center;
    if (known_corner(fences, fence, corner, same)) continue;
    if (is_full(fences.corner_count == kMaxFenceCorners)) return Status::kFencePlanesFull;
    fences.corners[fences.corner_count++] = corner;
    ++fence.corners;
  }
  return Status::kOk;
}

/// Half-space `index` of the keep-out's half-spaces followed by the faces of the surroundings. It is relative to the
/// centre of the surroundings, and moved out by `out`.
Halfspace plane_about(const Fences& fences, const KeepOut& fence, const Surroundings& around, int index, double out) {
  const bool own = index < fence.planes;
  const Halfspace& plane = own ? fences.planes[fence.first_plane + index] : around.faces[index - fence.planes];
  const double offset = own ? plane.offset - dot(plane.normal, around.center) : plane.offset;
  return {plane.normal, offset + out};
}

/// Adds the corners of all facets.
Status find_corners(const Surroundings& around, const Fineness& fine, Fences& fences, KeepOut& fence) {
  const int count = fence.planes + kBoxPlanes;
  for (int i = 0; i < count; ++i) {
    const Halfspace plane = plane_about(fences, fence, around, i, fine.hair);
    if (absolute(plane.offset) > around.reach) continue;  // misses the surroundings
    Facet facet = square_on(plane, around.reach);
    bool left = true;
    for (int j = 0; j < count && left; ++j) {
      if (j != i) left = cut(plane_about(fences, fence, around, j, fine.hair + fine.spare), facet, fine.spare);
    }
    const Status status = left ? add_corners(facet, around, fine.same, fences, fence) : Status::kOk;
    if (status != Status::kOk) return status;
  }
  return Status::kOk;
}

/// Finds the corners, as finely as the capacity for corners allows.
Status find_corners_that_fit(const Surroundings& around, Fences& fences, KeepOut& fence) {
  Fineness fine{kHair * around.scale, kSame * around.scale, kSpare * around.scale};
  Status status = Status::kFencePlanesFull;
  for (int trial = 0; trial < kTrials && status == Status::kFencePlanesFull; ++trial) {
    fences.corner_count = fence.first_corner;
    fence.corners = 0;
    status = find_corners(around, fine, fences, fence);
    fine.hair *= kCoarser;
    fine.same *= kCoarser;
  }
  return status;
}

void load_keep_in(const Grid& grid, const Fence& from, std::int32_t index, Fences& fences) {
  for (std::int32_t p = 0; p < from.count; ++p) {
    fences.keep_in_index[fences.keep_in_count] = index;
    fences.keep_in[fences.keep_in_count++] = to_local_plane(grid, from.planes[p]);
  }
}

Status load_keep_out(const Grid& grid, const Surroundings& around, const Fence& from, std::int32_t index,
                     Fences& fences) {
  KeepOut fence{fences.plane_count, 0, fences.corner_count, 0, index};
  for (; fence.planes < from.count; ++fence.planes) {
    fences.planes[fence.first_plane + fence.planes] = to_local_plane(grid, from.planes[fence.planes]);
  }
  const Status status = find_corners_that_fit(around, fences, fence);
  if (status != Status::kOk || fence.corners == 0) return status;
  fences.plane_count += fence.planes;
  fences.keep_out[fences.keep_out_count++] = fence;
  return Status::kOk;
}

/// The least value of normal . p over the box.
double least_over(const Box& box, const Vec3& normal) {
  const Vec3 corner{normal.x < 0.0 ? box.upper.x : box.lower.x, normal.y < 0.0 ? box.upper.y : box.lower.y,
                    normal.z < 0.0 ? box.upper.z : box.lower.z};
  return dot(normal, corner);
}

/// Loads fences that find_fence_fault() has accepted. Not inlined: the stack of the two would add up.
__attribute__((noinline)) FenceFault load_accepted(const Grid& grid, const Fence* list, std::int32_t count,
                                                   Fences& fences) {
  fences.keep_in_count = 0;
  fences.keep_out_count = 0;
  fences.plane_count = 0;
  fences.corner_count = 0;
  for (std::int32_t i = 0; i < count; ++i) {
    if (list[i].kind == FenceKind::kKeepIn) load_keep_in(grid, list[i], i, fences);
  }
  const Surroundings around = surroundings_of(grid, fences);
  fences.touching = contact_tolerance(grid.spec()) + kHair * around.scale;
  for (std::int32_t i = 0; i < count; ++i) {
    if (list[i].kind == FenceKind::kKeepIn) continue;
    const Status status = load_keep_out(grid, around, list[i], i, fences);
    if (status != Status::kOk) return {status, i};
  }
  return {Status::kOk, kNoFence};
}

}  // namespace

void box_planes(const Box& box, Halfspace (&out)[kBoxPlanes]) noexcept {
  for (int a = 0; a < 3; ++a) {
    out[2 * a] = {{0.0, 0.0, 0.0}, axis(box.upper, a)};
    out[2 * a + 1] = {{0.0, 0.0, 0.0}, -axis(box.lower, a)};
    axis(out[2 * a].normal, a) = 1.0;
    axis(out[2 * a + 1].normal, a) = -1.0;
  }
}

FenceFault load_fences(const Grid& grid, const Fence* list, std::int32_t count, Fences& fences) noexcept {
  const FenceFault fault = find_fence_fault(list, count, grid.spec());
  return fault.status == Status::kOk ? load_accepted(grid, list, count, fences) : fault;
}

std::int32_t fence_broken(const Fences& fences, const Vec3& from, const Vec3& to, double radius) noexcept {
  for (int p = 0; p < fences.keep_in_count; ++p) {
    const Halfspace& plane = fences.keep_in[p];
    const double far = larger(dot(plane.normal, from), dot(plane.normal, to));
    if (far > plane.offset + fences.touching) return fences.keep_in_index[p];
  }
  for (int k = 0; k < fences.keep_out_count; ++k) {
    const KeepOut& fence = fences.keep_out[k];
    const Halfspace* faces = fences.planes + fence.first_plane;
    const HullGap gap = widest_gap(from, to, hull_of(fences, fence), faces, fence.planes, radius);
    if (gap.distance < radius - fences.touching) return fence.index;
  }
  return kNoFence;
}

std::int32_t fence_over(const Fences& fences, const Box& cube, double radius) noexcept {
  const double hair = 0.5 * kLatticeTolerance * (cube.upper.x - cube.lower.x);
  for (int p = 0; p < fences.keep_in_count; ++p) {
    const double most = -least_over(cube, -1.0 * fences.keep_in[p].normal);
    if (most > fences.keep_in[p].offset + hair) return fences.keep_in_index[p];
  }
  for (int k = 0; k < fences.keep_out_count; ++k) {
    const KeepOut& fence = fences.keep_out[k];
    const Hull hull = hull_of(fences, fence);
    bool beyond = false;
    for (int f = 0; f < fence.planes + kBoxPlanes && !beyond; ++f) {
      Vec3 normal{0.0, 0.0, 0.0};
      if (f < kBoxPlanes) axis(normal, f / 2) = f % 2 == 0 ? 1.0 : -1.0;
      if (f >= kBoxPlanes) normal = fences.planes[fence.first_plane + f - kBoxPlanes].normal;
      beyond = least_over(cube, normal) >= hull_reach(normal, hull) + radius - hair;
    }
    if (!beyond) return fence.index;
  }
  return kNoFence;
}

bool fences_clear(const Fences& fences, const Vec3& from, const Vec3& to, double radius) noexcept {
  return fence_broken(fences, from, to, radius) == kNoFence;
}

}  // namespace tern
