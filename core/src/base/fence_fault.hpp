// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Finds the fault in a caller's fences. Plans, flights and proofs all use this check, so they give the same answer.
#ifndef TERN_BASE_FENCE_FAULT_HPP
#define TERN_BASE_FENCE_FAULT_HPP

#include <cstdint>

#include "tern/fence.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"

namespace tern {

/// kOk, or why the fences are refused and the index of the fence at fault: kNoFence if the list itself is at fault.
struct FenceFault {
  Status status;
  std::int32_t fence;
};

/// As find_fence_fault(), but does not look for points: never kFenceEmpty.
FenceFault find_form_fault(const Fence* list, std::int32_t count) noexcept;

/// Checks `count` fences, world frame, on a grid that is bound. Returns kOk, kNonFiniteInput, kFencesFull,
/// kFencePlanesFull, or one of two others. kInvalidArgument: a null pointer, a negative `count`, a fence without
/// half-spaces, an unknown kind, an end before the beginning, or a normal that is too short or too long. kFenceEmpty:
/// the first keep-in that has no point in common with the keep-ins before it, or a keep-out or a fence for a while
/// without a point. tern/fence.hpp says when a fence counts as having no point.
FenceFault find_fence_fault(const Fence* list, std::int32_t count, const GridSpec& grid) noexcept;

}  // namespace tern

#endif
