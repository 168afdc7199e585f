// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Jumps: everything a node reaches along one of its successor moves.
#ifndef TERN_SEARCH_JUMP_HPP
#define TERN_SEARCH_JUMP_HPP

#include "base/direction.hpp"
#include "search/search.hpp"
#include "tern/grid.hpp"

namespace tern {

/// A node while it is expanded.
struct Expansion {
  Search& search;
  const Grid& grid;
  Work& work;
  std::uint32_t node;
  Voxel at;
  Cost g;
  Cost limit;  ///< once f = g + h exceeds this, a sweep ends and leaves an open node that can resume it
};

/// Puts the voxel next to expansion.at along the legal move `move` into the search.
void step(const Expansion& expansion, int move) noexcept;

/// Puts every jump point that the legal move `move` leads to into the search, with `expansion.node` as its parent.
/// Straight moves go to the next jump stop. Diagonal moves sweep step by step. From every step, a sweep jumps along
/// each part of the move along fewer axes. `free` holds the cells around expansion.at. A sweep ends at a jump point, at
/// its limit or at the goal. Expanding the node there continues the sweep. Overflows set nodes_full or open_full of the
/// search.
void jump(const Expansion& expansion, int move, CellMask free) noexcept;

}  // namespace tern

#endif
