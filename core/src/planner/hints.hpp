// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Hints for the proof that a plan keeps off solids. If the faces of a keep-out are nearly parallel, the certifier finds
// no plane through its edges in doubles. The gap between the keep-out and the curve gives the normal of one. The
// certifier does not trust a hint, but without one it may refuse a good curve. The corridor's half-spaces are hints,
// too, but it has none for a solid that several of them keep off together, and stops and the rest of a previous plan
// have no corridor.
#ifndef TERN_PLANNER_HINTS_HPP
#define TERN_PLANNER_HINTS_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "prove/fences.hpp"
#include "tern/trajectory.hpp"
#include "world/world.hpp"

namespace tern {

/// A segment whose hull is not clear of a solid is halved at most this many times: the curve may go around the solid.
constexpr int kHintHalvings = 3;
/// Parts of a segment that are looked at for one solid.
constexpr int kHintParts = (2 << kHintHalvings) - 1;
/// A part that gets a hint is not halved any further, so a segment and a solid have one hint for each part of the
/// smallest size at most.
static_assert(kMaxFenceHints >= (kMaxSolids << kHintHalvings), "there is room for all hints");
/// Edges of a solid are tried among so many of its faces.
constexpr int kHintFaces = 12;
/// Normals that are tried for a part that its gap tells nothing about: along the axes and at right angles to them, and
/// at right angles to edges.
constexpr int kHintNormals = 12 + kHintFaces * (kHintFaces - 1);

/// Pieces of work for one curve: a solid for each segment.
constexpr std::uint32_t kHintBound = kMaxSegments * std::uint32_t{kMaxSolids};
/// The most operations of one of them.
constexpr Operations kHintOperations =
    kHintParts * (gap_operations(kControlPoints + kMaxSolidCorners) + 2 * ops::kCurve +
                  ops::kDot * kControlPoints * kMaxSolidFaces +
                  ops::kDot * (kHintNormals + kMaxFenceHints) * Operations{kControlPoints + kMaxSolidCorners}) +
    2 * ops::kPiece + ops::kDot * kMaxPlanes * Operations{kMaxSolidCorners};

/// Gives each segment the normals along which it keeps its clearance from the solids, as far as neither a solid's faces
/// nor the segment's polyhedron tell. kDone, or kMore. A world without solids takes no work. `corridor` may be null:
/// then no segment has a polyhedron.
Progress hints_advance(const World& world, const Corridor* corridor, const Trajectory& curve, PlanHints& hints,
                       Work& work) noexcept;

}  // namespace tern

#endif
