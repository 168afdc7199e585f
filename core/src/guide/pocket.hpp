// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A flood of the voxels around one end, a page at a time. It proves within a few hundred pages that an end lies in a
// closed pocket, however thin the pocket's walls are. The guide cannot: walls thinner than a block split blocks.
#ifndef TERN_GUIDE_POCKET_HPP
#define TERN_GUIDE_POCKET_HPP

#include <cstdint>

#include "guide/guided_search.hpp"
#include "tern/grid.hpp"
#include "tern/status.hpp"

namespace tern {

/// Pages that a flood reaches before it gives up: on the companion profile, a room of 30 voxels in each direction.
constexpr std::int32_t kPocketPages = kGuidePages / 8;

/// Pieces of work of one flood. A page comes back to the list only with a voxel more than before.
constexpr std::uint32_t kPocketBound = 64u * static_cast<std::uint32_t>(kPocketPages + kSides) + 2u;

/// Begins at a free voxel, in the memory of the search of voxels: the content of `open` and `store` is lost.
void pocket_begin(GuidedSearch& search, const Grid& grid, const Voxel& from) noexcept;

/// Takes one page off the list, a piece of work. kRunning; kNoPath: the blocked layer does not connect the two voxels;
/// kNodesFull: they are connected, or the flood reached more than kPocketPages pages.
Status pocket_take(GuidedSearch& search, const Grid& grid, const Voxel& to) noexcept;
/// Operations of one page: its flood, and the pages on its six sides.
constexpr Operations kPocketOperations = 9 * ops::kNode;

}  // namespace tern

#endif
