// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The corridor stage builds polyhedra along the shortcut path. A leg usually gets one. It gets several if it is long,
// or if one polyhedron would exceed a capacity. It gets none if the polyhedron of the leg before contains it too.
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
#include "world/world.hpp"

namespace tern {

/// Legs longer than this, in metres, are cut into equal pieces if the capacity for segments allows it. A single box
/// around a long oblique leg would contain obstacles that are nowhere near the leg.
constexpr double kLongLeg = 8.0;

/// Segments that are not used for cutting legs, if the capacity is large: coming to rest needs some too.
constexpr std::int32_t kKeptForEnds = kMaxSegments < 16 ? 0 : 8;

/// The most times that a piece is halved because its polyhedron does not fit.
constexpr int kMaxHalvings = 6;

/// Polyhedra that one corridor may try. Each halving adds one piece, and there are at most kMaxSegments pieces; the
/// last attempt may fail.
constexpr std::uint32_t kCorridorTries = 2u * static_cast<std::uint32_t>(kMaxSegments) + 1u;

/// The waypoints and polyhedra at which a plan passes its vias, in order.
struct ViaMarks {
  std::int32_t count;
  std::int32_t waypoint[kMaxVias];    ///< index of the via's waypoint in the path; increasing
  std::int32_t polyhedron[kMaxVias];  ///< index of the corridor's polyhedron that begins at the via; increasing
};

/// Plain data; needs no initialisation before corridor_begin.
struct CorridorStage {
  Status status;             ///< why the stage failed; else kOk
  std::uint32_t tries;       ///< polyhedra begun so far; <= kCorridorTries
  std::int32_t planes_high;  ///< half-spaces of the fullest polyhedron
  std::int32_t boxes_high;   ///< boxes in the fullest local box

  std::int32_t leg;      ///< index of the current leg of the path
  std::int32_t piece;    ///< index of the current piece of the leg
  std::int32_t pieces;   ///< pieces of the leg
  ViaMarks* marks;       ///< null: no vias
  std::int32_t passed;   ///< vias that the current leg begins at or after
  bool at_via;           ///< the current piece begins at a via
  std::int32_t fixed;    ///< polyhedra before the one that begins at the last via
  bool is_timed;         ///< the path is a way in time
  std::int32_t built;    ///< polyhedra so far, dropped ones included; <= kMaxSegments
  Vec3 from;             ///< beginning of the next polyhedron
  std::int32_t pending;  ///< count of `ends`: the ends of the piece's halves, that of the next half last
  Vec3 ends[kMaxHalvings + 1];
  bool growing;  ///< the polyhedron of the piece is being grown
  Growth growth;
  GrowScratch grow;
};

/// `marks`, which must outlive the stage, says which waypoints are vias, and receives the polyhedra that begin there;
/// null means none. `is_timed`: the path is a way in time, which may lead to a place, wait there and come back.
void corridor_begin(CorridorStage& stage, const Path& path, ViaMarks* marks = nullptr, bool is_timed = false) noexcept;

/// The pieces of work are those of grow_advance. kDone: `out` is filled in. kFailed: kCorridorBlocked, kOutOfMap,
/// kObstaclesFull, kPlanesFull or kSegmentsFull, with `out` undefined.
///
/// When done, polyhedron i contains its `from` and `to`, and ends exactly where i + 1 begins. The first begins at the
/// path's first point, and the last ends at the path's last. The points in between are waypoints or ends of pieces, in
/// the path's order, but some may be skipped. A polyhedron takes over a neighbouring piece if it contains the far end
/// of that piece with kSightMargin of a voxel to spare. The polyhedron's line then leads straight to or from that end.
/// The first and the last piece of the path always have polyhedra of their own. No polyhedron spans a via. Of a way in
/// time, no waypoint is skipped that is not inside its polyhedron: the way may have gone there to wait.
///
/// Any two neighbours share a ball around their common point, if the interior legs of the path keep kSightMargin of a
/// voxel from everything that is not free. The ball's radius is kSightMargin * cell, less 1e-9 m of rounding.
Progress corridor_advance(CorridorStage& stage, const World& world, const Path& path, Work& work,
                          Corridor& out) noexcept;

}  // namespace tern

#endif
