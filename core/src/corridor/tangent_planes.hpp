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

/// Moves the boxes that no half-space cuts off by `radius` to the front, in their order. Returns how many.
int keep_uncut(const Polyhedron& polyhedron, double radius, LocalBox* boxes, int count) noexcept;

/// Step (2) of the paper's Section 3.3.1: adds half-spaces to `out` until each obstacle is beyond one of them by the
/// radius. The obstacles are those that `out` does not cut off yet. The next half-space is made for the obstacle that
/// the growing ellipsoid meets first; of two met at once, for the one with the lower index. It also settles every other
/// obstacle that it cuts off. Each pass settles at least one obstacle. kOk, kCorridorBlocked, kPlanesFull or
/// kBudgetCorridor.
Status append_tangents(const EllipsoidMetric& metric, const Obstacles& obstacles, const SegmentMargin& segment,
                       GrowScratch& scratch, Polyhedron& out) noexcept;

}  // namespace tern

#endif
