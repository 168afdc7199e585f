// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is wrong with a caller's fences. Plans, flights and proofs ask the same question and give the same answer.
#ifndef TERN_BASE_FENCE_FAULT_HPP
#define TERN_BASE_FENCE_FAULT_HPP

#include <cstdint>

#include "tern/fence.hpp"
#include "tern/status.hpp"

namespace tern {

/// kOk; or why the fences are refused, and the index of the one that is wrong: kNoFence where it is the list itself.
struct FenceFault {
  Status status;
  std::int32_t fence;
};

/// Of `count` fences, world frame. kOk; kInvalidArgument for a null pointer, a negative `count`, a fence without
/// half-spaces, an unknown kind, or a normal that is too short or too long; kNonFiniteInput; kFencesFull;
/// kFencePlanesFull.
FenceFault find_fence_fault(const Fence* list, std::int32_t count) noexcept;

}  // namespace tern

#endif
