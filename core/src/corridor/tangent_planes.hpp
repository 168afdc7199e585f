// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TERN_CORRIDOR_TANGENT_PLANES_HPP
#define TERN_CORRIDOR_TANGENT_PLANES_HPP

#include "corridor/grow_scratch.hpp"
#include "corridor/separation.hpp"
#include "ellipsoid/ellipsoid_fit.hpp"
#include "ellipsoid/ellipsoid_metric.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"

namespace tern {

/// Step (2) of the paper's Section 3.3.1: adds half-spaces to `out` until each obstacle is beyond one of its
/// half-spaces by the radius. The obstacle that the swelling ellipsoid meets first is next, the lower index where two
/// are met at once; its half-space removes every obstacle that lies beyond it too. Each pass takes one obstacle at
/// least. kOk, kCorridorBlocked, kPlanesFull or kBudgetCorridor.
Status append_tangents(const EllipsoidMetric& metric, const Obstacles& obstacles, const SegmentMargin& segment,
                       GrowScratch& scratch, Polyhedron& out) noexcept;

}  // namespace tern

#endif
