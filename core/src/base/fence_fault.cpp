// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/fence_fault.hpp"

#include "base/capacity.hpp"
#include "base/common_point.hpp"
#include "base/math.hpp"
#include "tern/config.hpp"

namespace tern {
namespace {

/// Each half-space moves out by this share of the map's scale. A fence is empty only if its half-spaces then still have
/// no common point. The planner moves the planes of keep-outs out by twice as much (world/corners.cpp), so that it
/// finds points in every fence that is accepted here.
constexpr double kFlat = 5e-14;

/// Centre and size of the map, the `center` and `scale` of a CommonPoint.
struct Around {
  Vec3 center;
  double scale;
};

/// Measures the whole grid, because the answer must not depend on the boundary or on keep-ins.
Around around(const GridSpec& grid) {
  const Vec3 size{grid.dims.x * grid.cell, grid.dims.y * grid.cell, grid.dims.z * grid.cell};
  return {grid.origin + 0.5 * size, length(size) + grid.clearance()};
}

CommonPoint anywhere(const Around& map) {
  return CommonPoint(map.center, kFlat * map.scale, map.scale);
}

/// Adds all half-spaces of the fence. False if no common point is left, or only one out of reach.
bool meets(const Fence& fence, CommonPoint& common) {
  for (std::int32_t p = 0; p < fence.count; ++p) {
    if (!common.add(fence.planes[p])) return false;
  }
  return common.within_reach();
}

std::int32_t empty_keep_in(const Fence* list, std::int32_t count, const Around& map) {
  CommonPoint common = anywhere(map);
  for (std::int32_t i = 0; i < count; ++i) {
    if (list[i].kind == FenceKind::kKeepIn && !is_timed(list[i]) && !meets(list[i], common)) return i;
  }
  return kNoFence;
}

/// Of fences that need no point in common with others.
std::int32_t empty_by_itself(const Fence* list, std::int32_t count, const Around& map) {
  for (std::int32_t i = 0; i < count; ++i) {
    if (list[i].kind == FenceKind::kKeepIn && !is_timed(list[i])) continue;
    CommonPoint common = anywhere(map);
    if (!meets(list[i], common)) return i;
  }
  return kNoFence;
}

bool well_formed(const Fence& fence) {
  const bool known = fence.kind == FenceKind::kKeepIn || fence.kind == FenceKind::kKeepOut;
  const bool is_in_order = fence.from <= fence.until && fence.clock_error >= 0.0 && finite(fence.clock_error);
  return known && is_in_order && fence.planes != nullptr && fence.count >= 1;
}

Status check_plane(const Halfspace& plane) {
  if (!finite(plane.normal) || !finite(plane.offset)) return Status::kNonFiniteInput;
  const double norm = length(plane.normal);
  if (!(norm >= kMinFenceNormal) || norm > kMaxFenceNormal) return Status::kInvalidArgument;
  return finite(plane.offset / norm) ? Status::kOk : Status::kNonFiniteInput;
}

/// Checks one fence by itself. There is room for `left` half-spaces.
Status check_fence(const Fence& fence, std::int32_t left) {
  if (!well_formed(fence)) return Status::kInvalidArgument;
  if (is_full(fence.count > left)) return Status::kFencePlanesFull;
  for (std::int32_t p = 0; p < fence.count; ++p) {
    const Status status = check_plane(fence.planes[p]);
    if (status != Status::kOk) return status;
  }
  return Status::kOk;
}

}  // namespace

FenceFault find_form_fault(const Fence* list, std::int32_t count) noexcept {
  if (count < 0 || (count > 0 && list == nullptr)) return {Status::kInvalidArgument, kNoFence};
  if (is_full(count > kMaxFences)) return {Status::kFencesFull, kNoFence};
  std::int32_t left = kMaxFencePlanes;
  for (std::int32_t i = 0; i < count; ++i) {
    const Status status = check_fence(list[i], left);
    if (status != Status::kOk) return {status, i};
    left -= list[i].count;
  }
  return {Status::kOk, kNoFence};
}

FenceFault find_fence_fault(const Fence* list, std::int32_t count, const GridSpec& grid) noexcept {
  const FenceFault fault = find_form_fault(list, count);
  if (fault.status != Status::kOk) return fault;
  const Around map = around(grid);
  std::int32_t empty = empty_keep_in(list, count, map);
  if (empty == kNoFence) empty = empty_by_itself(list, count, map);
  return {empty == kNoFence ? Status::kOk : Status::kFenceEmpty, empty};
}

}  // namespace tern
