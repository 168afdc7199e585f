// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_FENCE_NARROW_BOUNDARY_HPP
#define TERN_FENCE_NARROW_BOUNDARY_HPP

#include "fence/fences.hpp"
#include "tern/grid.hpp"

namespace tern {

/// The boundary (local frame) within those planes of keep-ins that stand across axis `a`. A plane beyond the opposite
/// face of the boundary counts as on it. Faces that rounding leaves in the wrong order meet.
Box within_keep_ins(const Fences& fences, const Box& boundary, int a) noexcept;

/// Turns keep-ins that are thinner than voxels into a thin boundary (docs/grid.md). If the keep-in planes across an
/// axis leave no whole voxel of the boundary on it, they leave `fences` and become faces of the view's boundary. Some
/// point must obey the fences and the boundary, up to rounding. True if the boundary changed: the view's blocked layer
/// is then that of the old boundary.
bool narrow_boundary(Fences& fences, Grid& view) noexcept;

}  // namespace tern

#endif
