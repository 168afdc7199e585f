// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "world/fences.hpp"

#include "base/capacity.hpp"
#include "base/double_double.hpp"
#include "base/math.hpp"
#include "grid/distance.hpp"
#include "world/corners.hpp"
#include "world/narrow_boundary.hpp"

namespace tern {
namespace {

/// An offset this large lies beyond every map: coordinates of maps are below 1e19.
constexpr double kBeyondAnyMap = 1e100;

/// The half-space in the local frame, with a unit normal. The offset is shifted without rounding: far from the world's
/// origin, both the offset and the shift are large, and between two nearly parallel planes a small error grows.
Halfspace to_local_plane(const Grid& grid, const Halfspace& world) {
  const double norm = length(world.normal);
  const bool far = absolute(world.offset) > kBeyondAnyMap;  // products would overflow, and the shift is negligible
  const double shifted = far ? world.offset : depth_of(world.offset, world.normal, grid.spec().origin).high;
  return {(1.0 / norm) * world.normal, shifted / norm};
}

/// How far from the places of the centre a solid matters: the radius, and a voxel at least. In a region without height,
/// a solid would otherwise have no inside, and a path through the solid would only touch it.
double reach_of(const GridSpec& spec) {
  return larger(spec.clearance(), spec.cell);
}

void load_keep_in(const Grid& grid, const Fence& from, std::int32_t index, Solids& solids) {
  for (std::int32_t p = 0; p < from.count; ++p) {
    solids.wall_index[solids.wall_count] = index;
    solids.walls[solids.wall_count++] = wall_on_lattice(grid.spec(), to_local_plane(grid, from.planes[p]));
  }
}

Status load_keep_out(const Grid& grid, const Vicinity& around, const Fence& from, std::int32_t index, Solids& solids) {
  SolidParts parts{solids.face_count, 0, solids.corner_count, 0, index};
  for (; parts.faces < from.count; ++parts.faces) {
    solids.faces[parts.first_face + parts.faces] = to_local_plane(grid, from.planes[parts.faces]);
  }
  if (!find_corners(around, solids, parts)) return Status::kFencePlanesFull;
  if (parts.corners == 0) return Status::kOk;
  solids.face_count += parts.faces;
  solids.parts[solids.solid_count + solids.timed_count] = parts;
  is_timed(from) ? ++solids.timed_count : ++solids.solid_count;
  return Status::kOk;
}

/// Loads the keep-outs that hold always, or those for a while.
FenceFault load_keep_outs(const Grid& grid, const Fence* list, std::int32_t count, bool timed, Solids& solids) {
  const Vicinity around = vicinity_of(grid, solids, reach_of(grid.spec()));
  solids.touching = contact_tolerance(grid.spec()) + corner_tolerance(around);
  for (std::int32_t i = 0; i < count; ++i) {
    if (list[i].kind == FenceKind::kKeepIn || is_timed(list[i]) != timed) continue;
    const Status status = load_keep_out(grid, around, list[i], i, solids);
    if (status != Status::kOk) return {status, i};
  }
  return {Status::kOk, kNoFence};
}

/// Loads fences that find_fence_fault() has accepted. Not inlined: the stack of the two would add up.
__attribute__((noinline)) FenceFault load_accepted(const Grid& grid, const Fence* list, std::int32_t count,
                                                   Solids& solids) {
  clear_solids(solids);
  for (std::int32_t i = 0; i < count; ++i) {
    if (list[i].kind == FenceKind::kKeepIn && !is_timed(list[i])) load_keep_in(grid, list[i], i, solids);
  }
  const FenceFault fault = load_keep_outs(grid, list, count, false, solids);
  return fault.status == Status::kOk ? load_keep_outs(grid, list, count, true, solids) : fault;
}

}  // namespace

static_assert(kNoSolid == kNoFence, "a world answers with indices of fences");

void clear_solids(Solids& solids) noexcept {
  solids.wall_count = 0;
  solids.solid_count = 0;
  solids.timed_count = 0;
  solids.face_count = 0;
  solids.corner_count = 0;
}

bool add_timed_box(const Grid& grid, const Box& box, Solids& solids) noexcept {
  const std::int32_t timed = solids.timed_count;
  const std::int32_t corners = solids.corner_count;
  const bool has_room = solids.solid_count + timed < kMaxSolids && solids.face_count + kBoxPlanes <= kMaxSolidFaces;
  if (is_full(!has_room)) return false;
  Halfspace planes[kBoxPlanes];
  box_planes(box, planes);
  const Vicinity around = vicinity_of(grid, solids, reach_of(grid.spec()));
  solids.touching = contact_tolerance(grid.spec()) + corner_tolerance(around);
  const Fence fence{planes, kBoxPlanes, FenceKind::kKeepOut, 0, 1};
  const bool fits = load_keep_out(grid, around, fence, kNoSolid, solids) == Status::kOk;
  if (!fits) solids.corner_count = corners;
  return fits && solids.timed_count > timed;
}

FenceFault load_fences(const Grid& grid, const Fence* list, std::int32_t count, Solids& solids) noexcept {
  const FenceFault fault = find_fence_fault(list, count, grid.spec());
  return fault.status == Status::kOk ? load_accepted(grid, list, count, solids) : fault;
}

FenceFault world_add(WorldMemory& memory, const Fence* list, std::int32_t count) noexcept {
  begin_solids(memory);
  return load_fences(*memory.grid, list, count, memory.solids);
}

}  // namespace tern
