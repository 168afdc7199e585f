// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which moves a search must follow from a voxel that it reached by a given move: natural and forced neighbours of jump
// point search in three dimensions, without corner cutting.
//
// Let p be the voxel before n, and m the voxel after it. The move to m is pruned if the 3x3x3 cells around n hold a
// path from p to m that avoids n and is shorter. It is also pruned if such a path is as long but begins with a move
// along more axes (space diagonals before plane diagonals before straight moves). Of all cheapest paths, the one that
// turns to moves along fewer axes as late as possible is never pruned.
#ifndef TERN_SEARCH_PRUNE_HPP
#define TERN_SEARCH_PRUNE_HPP

#include "base/direction.hpp"
#include "search/prune_table.hpp"

namespace tern {

/// True if the move is legal from the centre of a neighbourhood: every cell of its 1x2, 2x2 or 2x2x2 box is free.
inline bool legal_move(int move, CellMask free) noexcept {
  return prune::covers(free, prune::kPrune.box[move]);
}

/// All legal moves. A diagonal's box consists of its end and the boxes of its parts along fewer axes. A step along an
/// axis from a cell of one kind to a cell of the next is 1, 3 or 9 places in the mask.
inline CellMask legal_moves(CellMask free) noexcept {
  using prune::kSets;
  const CellMask x = free & kSets.straight[0];
  const CellMask y = free & kSets.straight[1];
  const CellMask z = free & kSets.straight[2];
  const CellMask xy = free & kSets.plane[2] & (x << 3 | x >> 3) & (y << 1 | y >> 1);
  const CellMask xz = free & kSets.plane[1] & (x << 9 | x >> 9) & (z << 1 | z >> 1);
  const CellMask yz = free & kSets.plane[0] & (y << 9 | y >> 9) & (z << 3 | z >> 3);
  const CellMask xyz = free & kSets.space & (xy << 9 | xy >> 9) & (xz << 3 | xz >> 3) & (yz << 1 | yz >> 1);
  return x | y | z | xy | xz | yz | xyz;
}

/// Moves that continue an arrival by `arrival` in any map: the arrival itself and its parts along fewer axes. For
/// kHere, with which a search starts, these are all moves. Some of them may not be legal.
inline CellMask natural_moves(int arrival) noexcept {
  return prune::kPrune.rule[arrival].natural;
}

/// False if nothing can be forced because the cells beside the voxel before are all free.
inline bool may_force(int arrival, CellMask free) noexcept {
  return !prune::covers(free, prune::kPrune.rule[arrival].watch);
}

/// Legal moves that are neither natural nor pruned. `free` holds the free cells around the voxel reached.
inline CellMask forced_moves(int arrival, CellMask free, CellMask legal) noexcept {
  if (!may_force(arrival, free)) return 0;
  const prune::PruneRule& rule = prune::kPrune.rule[arrival];
  CellMask moves = 0;
  for (int k = 0; k < rule.count; ++k) {
    const prune::WaysAround& around = rule.ways[k];
    const bool pruned = prune::covers(free, around.first) || prune::covers(free, around.second);
    moves |= pruned ? 0 : cell_bit(around.move);
  }
  return moves & legal;
}

/// Natural and forced moves that are legal.
inline CellMask successor_moves(int arrival, CellMask free, CellMask legal) noexcept {
  return (natural_moves(arrival) & legal) | forced_moves(arrival, free, legal);
}

}  // namespace tern

#endif
