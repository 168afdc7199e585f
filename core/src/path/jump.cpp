// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "path/jump.hpp"

#include "path/neighbourhood.hpp"
#include "path/prune.hpp"
#include "path/scan.hpp"

namespace tern {
namespace {

/// Steps of one sweep: bounds the work of one expansion to a few thousand straight scans a space diagonal.
constexpr int kSweepSteps = 32;

/// Records a way to `voxel` that arrives by `arrival`: a better one replaces what was known, an equally good one adds
/// its arrival, a worse one is forgotten.
void relax(const Expansion& from, const Voxel& voxel, int arrival) {
  Search& search = from.search;
  const std::uint32_t index = store_find_or_add(search.store, voxel_index(from.grid, voxel));
  if (index == static_cast<std::uint32_t>(kMaxNodes)) {
    search.nodes_full = true;
    return;
  }
  SearchNode& node = search.store.nodes[index];
  const Cost g = from.g + octile(from.at, voxel);
  const bool better = node.arrivals == 0 || g < node.g;
  if (!better && (g > node.g || (node.arrivals & cell_bit(arrival)) != 0)) return;
  if (better) {
    node.g = g;
    node.parent = from.node;
    node.arrivals = 0;
    node.followed = 0;
  }
  node.arrivals |= cell_bit(arrival);
  const OpenKey key = open_key(g, octile(voxel, search.goal), node.voxel);
  if (!open_put(search.open, search.store, index, key)) search.heap_full = true;
}

void scan(const Expansion& from, const Voxel& cursor, int move) {
  Voxel found;
  if (scan_straight(from.search.map, from.grid, from.search.goal, cursor, move, found)) relax(from, found, move);
}

/// True where a sweep must leave the voxel to a node of its own.
bool stops_at(const Expansion& from, const Voxel& voxel, int move, CellMask free, int step) {
  if (same(voxel, from.search.goal) || forced_moves(move, free) != 0) return true;
  return step >= kSweepSteps || from.g + octile(from.at, voxel) + octile(voxel, from.search.goal) > from.limit;
}

/// The direction's part along the axes of `part`.
constexpr int kept(int move, int part) {
  const Voxel o = offset(move);
  return direction((part & 1) != 0 ? o.x : 0, (part & 2) != 0 ? o.y : 0, (part & 4) != 0 ? o.z : 0);
}

/// A diagonal sweep; `kAxes` of the move. Space diagonals sweep plane diagonals from every step, those scan.
template <int kAxes>
void sweep(const Expansion& from, Voxel cursor, int move, CellMask free) {
  for (int step = 1; legal_move(move, free); ++step) {
    cursor = cursor + offset(move);
    free = free_cells(from.grid, cursor);
    if (stops_at(from, cursor, move, free, step)) return relax(from, cursor, move);
    for (int part = 1; part < 7; ++part) {
      const int side = kept(move, part);
      const int axes = axes_of(side);
      if (side == move || (axes == 1 && (part & (part - 1)) != 0)) continue;
      if (axes == 1 && legal_move(side, free)) scan(from, cursor, side);
      if constexpr (kAxes == 3) {
        if (axes == 2) sweep<2>(from, cursor, side, free);
      }
    }
  }
}

}  // namespace

void jump(const Expansion& expansion, int move, CellMask free) noexcept {
  if (axes_of(move) == 1) return scan(expansion, expansion.at, move);
  if (axes_of(move) == 2) return sweep<2>(expansion, expansion.at, move, free);
  sweep<3>(expansion, expansion.at, move, free);
}

}  // namespace tern
