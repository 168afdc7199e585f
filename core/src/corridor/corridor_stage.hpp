// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The corridor stage: polyhedra along the shortcut path, one a leg where that does, more where a leg is long or its
// polyhedron does not fit its capacities, none where the one before holds it.
#ifndef TERN_CORRIDOR_CORRIDOR_STAGE_HPP
#define TERN_CORRIDOR_CORRIDOR_STAGE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "corridor/grow.hpp"
#include "tern/corridor.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// Legs longer than this, in metres, are cut into equal pieces where the capacity for segments allows: one box around
/// a long oblique leg would hold obstacles that are nowhere near it.
constexpr double kLongLeg = 8.0;

/// Segments that cutting legs leaves over, where there are many: coming to rest takes some of its own.
constexpr std::int32_t kKeptForEnds = kMaxSegments < 16 ? 0 : 8;

/// A piece whose polyhedron does not fit is halved, so often at most.
constexpr int kMaxHalvings = 6;

/// Polyhedra that one corridor may try: each halving leaves one piece more, and the pieces are kMaxSegments at most;
/// the last try may fail.
constexpr std::uint32_t kCorridorTries = 2u * static_cast<std::uint32_t>(kMaxSegments) + 1u;

/// Bound on CorridorStage::planes.
constexpr std::uint32_t kCorridorBound = kCorridorTries * kGrowBound;

/// Plain data; needs no initialisation before corridor_begin.
struct CorridorStage {
  Status status;             ///< why the stage failed; else kOk
  std::uint32_t planes;      ///< half-spaces made so far, discarded ones included; <= kCorridorBound and the budget
  std::int32_t planes_high;  ///< of the fullest polyhedron
  std::int32_t boxes_high;   ///< of the busiest local box

  std::int32_t leg;    ///< index of the path's leg at hand
  std::int32_t piece;  ///< piece of the leg at hand, and how many there are
  std::int32_t pieces;
  std::int32_t built;    ///< polyhedra so far, dropped ones included; <= kMaxSegments
  Vec3 from;             ///< where the next polyhedron begins
  std::int32_t pending;  ///< ends of the halves that the piece was cut into, the next one last
  Vec3 ends[kMaxHalvings + 1];
  GrowScratch grow;
};

/// `max_planes` is the budget on half-spaces (Budget::planes); `fences` must outlive the stage, null for none.
void corridor_begin(CorridorStage& stage, const Grid& grid, const Path& path, std::uint32_t max_planes,
                    const Fences* fences = nullptr) noexcept;

/// One unit of work is one polyhedron. kDone with `out` full: polyhedron i holds its `from` and
/// `to` and ends exactly where i + 1 begins; the first begins at the path's first point, the last ends at its last.
/// Those ends are waypoints, or ends of pieces of legs, in the path's order, but not all of them: a polyhedron that
/// holds the piece after its own, or the beginning of the segment before it, with kSightMargin of a voxel to spare at
/// that point, has the straight line to or from there for its segment. The first and
/// the last piece of the path have polyhedra of their own. kFailed: kCorridorBlocked, kOutOfMap,
/// kObstaclesFull, kPlanesFull, kSegmentsFull or kBudgetCorridor, with `out` undefined.
///
/// A path whose interior legs keep kSightMargin of a voxel from whatever is not free gives every pair of neighbours a
/// common ball of radius kSightMargin * cell about their common point (less 1e-9 m of rounding).
Progress corridor_advance(CorridorStage& stage, const Grid& grid, const Path& path, Work& work, Corridor& out) noexcept;

}  // namespace tern

#endif
