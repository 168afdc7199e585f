// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shortening the jump-point path through lines of sight between its points.
#ifndef TERN_PATH_SHORTCUT_HPP
#define TERN_PATH_SHORTCUT_HPP

#include <cstdint>

#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/request.hpp"
#include "tern/status.hpp"

namespace tern {

/// Bound on lines of sight: one for each pair of points.
constexpr std::uint32_t kSightLineBound =
    static_cast<std::uint32_t>(kMaxJumpPoints) * static_cast<std::uint32_t>(kMaxJumpPoints - 1) / 2u;

/// What a leg costs besides its length, in voxels: between chains of nearly equal length the one with fewer segments is
/// worth more than a twentieth of a voxel.
constexpr double kLegPrice = 0.05;

/// The best known chain from the path's first point to one of its points.
struct ChainEnd {
  double cost;        ///< metres of length and leg prices
  std::int32_t from;  ///< the point before it
  bool refused;       ///< no sight from here to the point at hand
};

/// Plain data; needs no initialisation before shortcut_begin.
struct Shortcut {
  ShortcutMode mode;
  std::int32_t head;   ///< kShortestChain: the point whose best predecessor is sought; greedy: the last waypoint
  std::int32_t probe;  ///< the point that the next line of sight joins to head
  ChainEnd ends[kMaxJumpPoints];
};

/// `path.raw` holds the path to shorten: each point sees the next (a move of the grid, or a checked join).
void shortcut_begin(Shortcut& shortcut, const Grid& grid, ShortcutMode mode, Path& path) noexcept;

/// True while a line of sight is to be walked; false when the chain is complete.
bool shortcut_needs_line(const Shortcut& shortcut, const Path& path) noexcept;

/// Walks one line of sight. Call only while shortcut_needs_line().
void shortcut_walk_line(Shortcut& shortcut, const Grid& grid, Path& path) noexcept;

/// Writes path.points, count and length: kOk, or kSegmentsFull with `path` unchanged but for its points. Once, when no
/// line is needed any more.
Status shortcut_finish(Shortcut& shortcut, Path& path) noexcept;

}  // namespace tern

#endif
