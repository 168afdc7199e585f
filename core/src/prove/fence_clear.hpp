// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tells whether the hull of a few points respects a fence.
#ifndef TERN_PROVE_FENCE_CLEAR_HPP
#define TERN_PROVE_FENCE_CLEAR_HPP

#include "base/work.hpp"
#include "tern/fence.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// What a hull keeps from fences.
struct FenceRule {
  Vec3 frame;        ///< of the points, in the world, metres
  double distance;   ///< from keep-outs, metres
  double tolerance;  ///< by which points may lie outside a keep-in, metres, >= 0
};

/// True only if the hull of the points lies in the keep-in, or a face, an edge or a corner of the keep-out cuts it off
/// by the distance. For a keep-out, the answer may be false although the hull keeps the distance, but hardly ever if
/// the points are close together.
bool fence_clear(const Fence& fence, const FenceRule& rule, const Vec3* points, int count) noexcept;

/// Of one call: each face, and each edge of a keep-out, against eight points.
Operations fence_operations(const Fence& fence) noexcept;

/// By how many metres too much a point is outside the keep-in, or too near to the keep-out as far as its faces tell.
double fence_excess(const Fence& fence, const FenceRule& rule, const Vec3& point) noexcept;

}  // namespace tern

#endif
