// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Larger polyhedra around the same segment: half-spaces tangent to larger ellipsoids than the segment's own.
#ifndef TERN_CORRIDOR_IMPROVE_HPP
#define TERN_CORRIDOR_IMPROVE_HPP

#include "corridor/grow_scratch.hpp"
#include "corridor/separation.hpp"
#include "ellipsoid/ellipsoid_fit.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Rounds of a larger ellipsoid inside the polyhedron and new half-spaces around it. The first gives a tenth to a
/// sixth of volume, the second a few percent, further ones next to nothing.
constexpr int kImprovingRounds = 2;

/// Then half-spaces are left out, one at a time: what the others hold has a larger ellipsoid, and tangents to that may
/// make a larger polyhedron. So many trials at most, and none where the ellipsoid's size grows by less than this factor
/// (volumes by its root). In dense maps they give 2 % of volume in the mean, up to 5 % in the median.
constexpr int kLeaveOuts = 4;
constexpr double kWorthLeavingOut = 1.3;

/// What the trials for one segment have in common.
struct Enclosure {
  const Obstacles& obstacles;
  const SegmentMargin& segment;
  double least_slack;  ///< of the barrier, metres
  int given;           ///< half-spaces that come first and stay: the local box's faces, fences
};

/// Tries other half-spaces for the polyhedron `out`, which encloses the segment, and keeps the largest one, with its
/// analytic centre. A trial whose half-spaces do not fit is given up: there is a polyhedron already. kOk,
/// kCorridorBlocked or kBudgetCorridor. Uses scratch.trial and what append_tangents uses.
Status improve(const Enclosure& enclosure, GrowScratch& scratch, Polyhedron& out, Vec3& center) noexcept;

}  // namespace tern

#endif
