// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Jump point search in three dimensions: 26 neighbours, no corner cutting, optimal. docs/search.md has the rules and
// why they lose no optimal path.
#ifndef TERN_SEARCH_SEARCH_HPP
#define TERN_SEARCH_SEARCH_HPP

#include <cstdint>

#include "base/direction.hpp"
#include "base/work.hpp"
#include "search/dominance.hpp"
#include "search/node_store.hpp"
#include "search/open_list.hpp"
#include "search/straight_jump.hpp"
#include "tern/grid.hpp"
#include "tern/path.hpp"
#include "tern/status.hpp"

namespace tern {

/// Bound on the pieces of work of one search. Expansions alone stay below it. The heuristic is consistent, so the cost
/// of a node is final when the node is first expanded. It is expanded again only after an arrival by another of the 26
/// moves. Outdated entries of the open list and the sorting of bins are pieces too. They have no such bound, because a
/// node may be improved many times before it is expanded. So search_expand counts its pieces, and gives up at the
/// bound.
constexpr std::uint32_t kExpansionBound =
    static_cast<std::uint32_t>(kDirections) * static_cast<std::uint32_t>(kMaxNodes);

/// The least number of expansions step by step with which a search begins (docs/search.md). Steps take more nodes than
/// sweeps do, so there are fewer steps if the store is small. The profiles mcu and companion have the same number, so
/// that they break ties alike.
constexpr std::uint32_t kLeastSteps = kMaxNodes < 32 * 1024 ? kMaxNodes / 128 : 32;

/// A search between two free voxels. Plain data; needs no initialisation before search_begin.
struct Search {
  Voxel start;
  Voxel goal;
  bool nodes_full;
  bool open_full;
  bool jumps;              ///< false while the search goes step by step
  std::uint32_t steps;     ///< least number of expansions that go step by step
  std::uint32_t expanded;  ///< nodes expanded so far
  std::uint32_t jumped;    ///< expanded nodes that jumped
  std::uint32_t units;     ///< pieces of work so far; <= kExpansionBound
  Cost least_h;            ///< least h of the nodes expanded so far
  NodeStore store;
  OpenList open;
  JumpStopLayer stops[3];  ///< by axis; valid once the search jumps
  DominanceMap dominance;
};

/// Opens the start. Both voxels must be free in the grid's blocked layer, which must not change until the search ends.
/// `steps`, at most 2^24, changes the cost of the search, and which of the cheapest paths it finds; with 0, the search
/// jumps at once.
void search_begin(Search& search, const Grid& grid, const Voxel& start, const Voxel& goal,
                  std::uint32_t steps = kLeastSteps) noexcept;

/// Does one piece of the search: expands a node, skips an outdated entry of the open list, or sorts a part of the list.
/// kRunning, or the end: kOk, kNoPath, kNodesFull, kOpenFull. Also kNodesFull after kExpansionBound pieces: a larger
/// store has a larger bound. Must not be called after the end.
Status search_expand(Search& search, const Grid& grid, Work& work) noexcept;

/// Appends the turning points of the path found to path.raw, from the start to the goal voxel, each at its
/// free_point(). Sets path.grid_length. Leaves room for `reserve` more points: kOk or kJumpPointsFull. Call it once,
/// after kOk.
Status search_extract(Search& search, const Grid& grid, int reserve, Path& path) noexcept;

}  // namespace tern

#endif
