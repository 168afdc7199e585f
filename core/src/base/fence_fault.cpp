// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/fence_fault.hpp"

#include "base/capacity.hpp"
#include "base/math.hpp"
#include "tern/config.hpp"

namespace tern {
namespace {

bool well_formed(const Fence& fence) {
  const bool known = fence.kind == FenceKind::kKeepIn || fence.kind == FenceKind::kKeepOut;
  return known && fence.planes != nullptr && fence.count >= 1;
}

Status check_plane(const Halfspace& plane) {
  if (!finite(plane.normal) || !finite(plane.offset)) return Status::kNonFiniteInput;
  const double norm = length(plane.normal);
  if (!(norm >= kMinFenceNormal) || norm > kMaxFenceNormal) return Status::kInvalidArgument;
  return finite(plane.offset / norm) ? Status::kOk : Status::kNonFiniteInput;
}

/// A fence that fits among half-spaces of which `left` are left.
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

FenceFault find_fence_fault(const Fence* list, std::int32_t count) noexcept {
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

}  // namespace tern
