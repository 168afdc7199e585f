// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shortcut stage turns the path over voxels into few straight legs, and then pulls them tight. If legs must be
// fewer still, it merges waypoints in between.
#ifndef TERN_PATH_SHORTCUT_STAGE_HPP
#define TERN_PATH_SHORTCUT_STAGE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "path/merge.hpp"
#include "path/shortcut.hpp"
#include "path/tighten.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// The most pieces of work of one run of the stage.
constexpr std::uint32_t kShortcutBound = kChainBound + kMergeBound + kTightenBound;

enum class ShortcutPhase : std::uint8_t { kChain, kMerge, kTighten };

/// Plain data; needs no initialisation before shortcut_begin.
struct ShortcutStage {
  Status status;               ///< why the stage failed; else kOk
  std::uint32_t pieces;        ///< steps of the chain and of merging, trials of tightening; <= kShortcutBound
  std::int32_t segments_high;  ///< legs of the shortcut path; kMaxSegments if it needs more

  bool few_legs;  ///< waypoints are merged
  ShortcutPhase phase;
  Merge merge;
  union {
    Shortcut shortcut;
    Tighten tighten;  ///< begins when the shortcut's chain is complete and, with few_legs, merged
  };
};

/// `path` holds the raw path of the search stage. The grid must not change until the stage ends. With `few_legs`, the
/// path may be longer than without, and has fewer legs where there is room for that.
void shortcut_begin(ShortcutStage& stage, const Grid& grid, Path& path, bool few_legs = false) noexcept;

/// A piece of work is one step of the shortcut (at most one line of sight), or one of merging or one trial of
/// tightening (at most two lines of sight each). kDone: `path` is complete. kFailed: kSegmentsFull; the raw path stays,
/// and the rest of `path` is undefined. Pass the same `path` in every call.
///
/// Every leg of the path lies in free voxels and keeps kSightMargin of a voxel (max norm) from all others. The first
/// and the last leg may come closer if the exact start or goal does. Such a leg leads straight to the centre of the
/// point's own voxel. If that voxel is not free, it leads to a free voxel near it along a line that keeps the radius.
Progress shortcut_advance(ShortcutStage& stage, const Grid& grid, Work& work, Path& path) noexcept;

}  // namespace tern

#endif
