// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shortcut stage: the jump-point path in few straight legs, which are then pulled tight.
#ifndef TERN_PATH_SHORTCUT_STAGE_HPP
#define TERN_PATH_SHORTCUT_STAGE_HPP

#include <cstdint>

#include "base/progress.hpp"
#include "base/work.hpp"
#include "path/shortcut.hpp"
#include "path/tighten.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// Bound on ShortcutStage::sight_lines.
constexpr std::uint32_t kShortcutBound = kChainBound + kTightenBound;

enum class ShortcutPhase : std::uint8_t { kChain, kTighten };

/// Plain data; needs no initialisation before shortcut_begin.
struct ShortcutStage {
  Status status;               ///< why the stage failed; else kOk
  std::uint32_t sight_lines;   ///< steps of the shortcut, trials of tightening; <= kShortcutBound and the budget
  std::int32_t segments_high;  ///< segments of the shortcut path; kMaxSegments where more would have been needed

  ShortcutPhase phase;
  std::uint32_t max_sight_lines;
  union {
    Shortcut shortcut;
    Tighten tighten;  ///< begins when the shortcut's chain is complete
  };
};

/// `path` has the raw path of the search stage. `max_sight_lines`: what is left of Budget::sight_lines. The grid must
/// not change until the stage ends.
void shortcut_begin(ShortcutStage& stage, const Grid& grid, std::uint32_t max_sight_lines, Path& path) noexcept;

/// One unit of work is one step of the shortcut, which walks one line of sight at most, or one trial of tightening,
/// which walks two lines at most. kDone with `path` complete. kFailed: kSegmentsFull (its raw path is as it was) or
/// kBudgetShortcut, with the rest of `path` undefined. `path` must be the same object until then.
///
/// Every segment of the path lies in free voxels and keeps kSightMargin of a voxel (max norm) from all others, but for
/// the first and the last one where the exact start or goal is itself nearer: it then leads straight to the centre of
/// the point's own voxel, or, where that voxel is not free, along a line that keeps the radius to a free voxel near it.
Progress shortcut_advance(ShortcutStage& stage, const Grid& grid, Work& work, Path& path) noexcept;

}  // namespace tern

#endif
