// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Larger polyhedra around the same segment: their half-spaces are tangent to ellipsoids larger than the segment's own.
#ifndef TERN_CORRIDOR_IMPROVE_HPP
#define TERN_CORRIDOR_IMPROVE_HPP

#include "base/progress.hpp"
#include "base/work.hpp"
#include "corridor/grow_scratch.hpp"
#include "corridor/separation.hpp"
#include "corridor/tangent_planes.hpp"
#include "ellipsoid/barrier_ellipsoid.hpp"
#include "ellipsoid/ellipsoid_fit.hpp"
#include "tern/corridor.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"

namespace tern {

/// Rounds: each finds a larger ellipsoid inside the polyhedron and makes new half-spaces tangent to it. The first round
/// adds a tenth to a sixth to the volume, the second a few percent, and further ones next to nothing.
constexpr int kImprovingRounds = 2;

/// The most trials after the rounds. Each leaves out one half-space: the polyhedron of the others has a larger
/// ellipsoid, and tangents to that may give a larger polyhedron. A trial is skipped if the ellipsoid's size grows by
/// less than kWorthLeavingOut (the volume by its square root). In dense maps, the trials add a mean of 2 % to the
/// volume.
constexpr int kLeaveOuts = 4;
constexpr double kWorthLeavingOut = 1.3;

/// The inputs of all rounds and trials for one segment.
struct Enclosure {
  Obstacles obstacles;
  const SegmentMargin& segment;
  double least_slack;  ///< of the barrier, metres
  int given;           ///< half-spaces that come first and stay: those of the local box, walls and solids
};

/// The phases of an improvement.
enum class ImprovePhase : std::uint8_t {
  kBegin,     ///< finds the ellipsoid in the polyhedron as it is
  kTangents,  ///< makes half-spaces tangent to an ellipsoid, in a round or a trial
  kCompare,   ///< keeps the polyhedron of these half-spaces if it is larger
  kLeaveOut,  ///< begins the next trial
};

/// An improvement in progress. Plain data; needs no initialisation before improve_begin.
struct Improvement {
  ImprovePhase phase;
  int rounds;              ///< rounds done
  int plane;               ///< the half-space that the next trial leaves out
  int trials;              ///< trials begun
  BarrierEllipsoid inner;  ///< the current half-spaces are tangent to it
  TangentPass pass;        ///< makes the current half-spaces
  Vector center;           ///< analytic centre of the largest polyhedron so far
  double size;             ///< BarrierEllipsoid::size of the largest polyhedron so far
};

/// Tries other half-spaces for the polyhedron `out`, which encloses the segment. `out` becomes the largest polyhedron
/// found, and `center` its analytic centre. A trial whose half-spaces do not fit is given up, because there already is
/// a polyhedron. Uses scratch.trial and everything that tangents_advance uses.
void improve_begin(Improvement& improvement) noexcept;

/// A piece of work is one of tangents_advance, or finds one ellipsoid. kDone, or kFailed with `status`
/// kCorridorBlocked.
Progress improve_advance(Improvement& improvement, const Enclosure& enclosure, GrowScratch& scratch, Polyhedron& out,
                         Work& work, Status& status) noexcept;

}  // namespace tern

#endif
