// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Writes the shortcut's chain with fewer legs. It replaces two neighbouring points by one further out, which makes the
// path longer. The chain may have more points than a path.
#ifndef TERN_PATH_MERGE_HPP
#define TERN_PATH_MERGE_HPP

#include <cstdint>

#include "base/work.hpp"
#include "path/shortcut.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// Places that are tried for the one point. Each is twice as far out as the one before.
constexpr int kMergeTrials = 5;
/// How far out the first place is, in parts of the distance between the two points.
constexpr double kMergeNearest = 0.125;

/// Bound on pieces of work. A point is appended once, and takes the trials of a pair then. So does a merge, which
/// removes a point.
constexpr std::uint32_t kMergeBound = 2u * static_cast<std::uint32_t>(kMaxJumpPoints) * (kMergeTrials + 1u);

/// Plain data; needs no initialisation before merge_begin.
struct Merge {
  std::int32_t next;  ///< the chain's next point; -1 after the last
  int trial;          ///< of the last but one pair of waypoints; kMergeTrials: all failed
};

/// The chain must be complete. Reverses its links, so that it can be read from its first point on.
void merge_begin(Merge& merge, Shortcut& shortcut, Path& path) noexcept;

/// Operations of the next step.
Operations merge_operations(const Merge& merge, const Grid& grid, const Path& path) noexcept;

/// Does one piece of work: tests at most two lines of sight, or appends a point. Every new leg passes line_of_sight
/// with kSightMargin. kRunning; kOk if path.points, count and length are complete; or kSegmentsFull.
Status merge_step(Merge& merge, const Shortcut& shortcut, const Grid& grid, Path& path) noexcept;

}  // namespace tern

#endif
