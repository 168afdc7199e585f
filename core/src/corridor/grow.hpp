// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The polyhedron of one segment (the paper's Section 3.3.1). The obstacles in a box around the segment become solid
// boxes, and an ellipsoid is fitted between these. Half-spaces cut them off, the nearest in the ellipsoid's metric
// first. Every obstacle voxel of the whole grid ends up beyond one half-space by the grid's radius.
#ifndef TERN_CORRIDOR_GROW_HPP
#define TERN_CORRIDOR_GROW_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "corridor/grow_scratch.hpp"
#include "corridor/improve.hpp"
#include "corridor/separation.hpp"
#include "corridor/tangent_planes.hpp"
#include "ellipsoid/ellipsoid_fit.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"
#include "tern/vec3.hpp"
#include "world/world.hpp"

namespace tern {

/// How far the local box reaches beyond the segment: in metres, and at least this many voxels. If the obstacles or
/// half-spaces exceed their capacity, this margin is halved. There are kBoxLevels sizes in all.
constexpr double kLocalMargin = 2.0;
constexpr double kLocalMarginCells = 4.0;
constexpr int kBoxLevels = 6;

/// The phases of a growing polyhedron, each with its result.
enum class GrowPhase : std::uint8_t {
  kBox,      ///< the half-spaces of the local box, of walls and of solids
  kExtract,  ///< the obstacles in the local box
  kFit,      ///< the segment's ellipsoid between the obstacles
  kSieve,    ///< the obstacles that the half-spaces of kBox do not cut off
  kCutOff,   ///< half-spaces that cut off the obstacles that are left
  kImprove,  ///< a larger polyhedron
  kFinish,
};

/// A polyhedron that is being grown. Plain data; needs no initialisation before grow_begin.
struct Growth {
  Status status;  ///< why it failed; else kOk
  GrowPhase phase;
  int level;     ///< how often the local box was shrunk
  double reach;  ///< of the local box beyond the segment, metres
  SegmentMargin segment;
  int given;  ///< half-spaces of the local box, walls and solids
  EllipsoidFit fit;
  Sieve sieve;
  TangentPass pass;
  Improvement improvement;
};

/// Grows the polyhedron of the segment from `from` to `to` (local frame, metres; it may be a point). The segment must
/// keep the radius from everything in the world and lie inside the boundary.
void grow_begin(Growth& growth, const World& world, const Vec3& from, const Vec3& to) noexcept;

/// A piece of work is one of extract_advance, fit_advance, keep_uncut, tangents_advance or improve_advance, or makes
/// the half-spaces of phase kBox, or finishes the polyhedron.
///
/// kDone: `out` contains the segment. Each of its half-spaces made for an obstacle stays min(kSightMargin * cell, room)
/// away from the segment. Each obstacle voxel is beyond one half-space by the radius (to 1e-9 m). kFailed, with
/// growth.status. kOutOfMap: an end lies outside the boundary. kCorridorBlocked: something is nearer to the segment
/// than the radius. kObstaclesFull, kPlanesFull: even the smallest local box has too many; a shorter segment may fit.
/// `out` is undefined unless kDone.
Progress grow_advance(Growth& growth, const World& world, GrowScratch& scratch, Polyhedron& out, Work& work) noexcept;

}  // namespace tern

#endif
