// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tells whether the hull of a few points respects a fence.
#ifndef TERN_PROOF_FENCE_CLEAR_HPP
#define TERN_PROOF_FENCE_CLEAR_HPP

#include "tern/fence.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// What a hull keeps from fences.
struct FenceRule {
  Vec3 frame;        ///< of the points, in the world, metres
  double distance;   ///< from keep-outs, metres, > 0
  double tolerance;  ///< by which points may lie outside a keep-in, metres, >= 0
};

/// True only if the hull of the points lies in the keep-in, or keeps the distance from the keep-out. For a keep-out,
/// the answer may be false although the hull keeps the distance: near a corner of the keep-out, or if the keep-out is
/// empty.
bool fence_clear(const Fence& fence, const FenceRule& rule, const Vec3* points, int count) noexcept;

}  // namespace tern

#endif
