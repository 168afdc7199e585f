// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shortening the jump-point path through lines of sight between its points.
#ifndef TERN_PATH_SHORTCUT_HPP
#define TERN_PATH_SHORTCUT_HPP

#include <cstdint>

#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// Points before one of the path's among which its predecessor in the chain is sought. Lines of sight that skip more
/// turns than these are rare, and tightening finds most of them again.
constexpr int kSightWindow = 64;

/// Bound on units: for each point one line from each candidate before it but the nearest, and one
/// that goes on to the next point.
constexpr std::uint32_t kChainBound =
    static_cast<std::uint32_t>(kMaxJumpPoints) * static_cast<std::uint32_t>(kSightWindow);

/// What a leg costs besides its length, in voxels: between chains of nearly equal length the one with fewer segments is
/// worth more than a twentieth of a voxel.
constexpr double kLegPrice = 0.05;

/// The best known chain from the path's first point to one of its points.
struct ChainEnd {
  double cost;        ///< metres of length and leg prices
  double onward;      ///< cost of the chain that goes on from here to the head, while this is one of its candidates
  std::int32_t from;  ///< the point before it
};

/// Plain data; needs no initialisation before shortcut_begin.
struct Shortcut {
  std::int32_t head;   ///< the point whose best predecessor is sought
  std::int32_t probe;  ///< the point that the next line of sight joins to head; -1 where none would beat its own leg
  ChainEnd ends[kMaxJumpPoints];
};

/// `path.raw` holds the path to shorten: each point sees the next (a move of the grid, or a checked join).
void shortcut_begin(Shortcut& shortcut, const Grid& grid, Path& path) noexcept;

/// True while there are units of work to be done; false when the chain is complete.
bool shortcut_needs_step(const Shortcut& shortcut, const Path& path) noexcept;

/// Does one unit of work: walks at most one line of sight and ranks at most kSightWindow candidates. Call only while
/// shortcut_needs_step().
void shortcut_step(Shortcut& shortcut, const Grid& grid, Path& path) noexcept;

/// Writes path.points, count and length: kOk, or kSegmentsFull with `path` unchanged but for its points. Once, when no
/// unit is left.
Status shortcut_finish(Shortcut& shortcut, Path& path) noexcept;

}  // namespace tern

#endif
