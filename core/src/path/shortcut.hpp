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

/// A point's predecessor in the chain is sought among this many points before it. Lines of sight that skip more turns
/// are rare, and tightening finds most of them again.
constexpr int kSightWindow = 64;

/// Bound on pieces of work. Each point takes one for each candidate except the nearest, and one to go on to the next
/// point.
constexpr std::uint32_t kChainBound =
    static_cast<std::uint32_t>(kMaxJumpPoints) * static_cast<std::uint32_t>(kSightWindow);

/// The price of a leg, added to its length, in voxels.
constexpr double kLegPrice = 0.05;

/// The best known chain from the first point of the path to one of its points.
struct ChainEnd {
  double cost;        ///< metres of length and leg prices
  std::int32_t from;  ///< the point before it in the chain
};

/// Plain data; needs no initialisation before shortcut_begin.
struct Shortcut {
  std::int32_t head;   ///< the point whose best predecessor is sought
  std::int32_t probe;  ///< the next line of sight is from here to the head; -1 if none can beat the best known
  ChainEnd ends[kMaxJumpPoints];
  double onward[kMaxJumpPoints];  ///< cost of the chain that goes on from a candidate to the head
};

/// `path.raw` is the path to shorten. Each of its points sees the next, because the step is a move of the grid or a
/// checked join.
void shortcut_begin(Shortcut& shortcut, const Grid& grid, Path& path) noexcept;

/// True until the chain is complete.
bool shortcut_needs_step(const Shortcut& shortcut, const Path& path) noexcept;

/// Does one piece of work: walks at most one line of sight and ranks at most kSightWindow candidates. Call only while
/// shortcut_needs_step().
void shortcut_step(Shortcut& shortcut, const Grid& grid, Path& path) noexcept;

/// Writes path.points, count and length. Call it once, when the chain is complete. kOk, or kSegmentsFull with only
/// path.count changed.
Status shortcut_finish(Shortcut& shortcut, Path& path) noexcept;

}  // namespace tern

#endif
