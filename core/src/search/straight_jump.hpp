// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Straight jumps: from a voxel along one axis to the first jump point, 64 voxels a step. Callers spend the same for a
// jump whether or not it has to make its stops. Making stops takes 1 to 2 % of a search.
#ifndef TERN_SEARCH_STRAIGHT_JUMP_HPP
#define TERN_SEARCH_STRAIGHT_JUMP_HPP

#include "base/direction.hpp"
#include "grid/lattice.hpp"
#include "search/jump_stops.hpp"
#include "search/neighbourhood.hpp"
#include "search/prune.hpp"
#include "tern/grid.hpp"

namespace tern {

// Walks along y and z voxel by voxel, from the nine rows around the line.

/// Blocked cells across a line along kAxis (1 or 2) at a voxel: x - 1 .. x + 1 fastest, then three levels of the third
/// axis; the line's own cell is in bit 4.
template <int kAxis>
CellMask cross_section(const Grid& grid, const Voxel& v) noexcept {
  constexpr int kY = kAxis == 2 ? 1 : 0;
  constexpr int kZ = kAxis == 1 ? 1 : 0;
  return triple_at(grid, v.x, v.y - kY, v.z - kZ) | triple_at(grid, v.x, v.y, v.z) << 3 |
         triple_at(grid, v.x, v.y + kY, v.z + kZ) << 6;
}

/// True if an arrival at `at` from `from`, one step along the line, forces a move; `beyond` is one step further. The
/// same rule as in jump_stops.cpp, for one voxel.
inline bool section_forces(CellMask from, CellMask at, CellMask beyond) noexcept {
  constexpr CellMask kStraight = 1u << 1 | 1u << 3 | 1u << 5 | 1u << 7;
  constexpr CellMask kSquares[] = {0x1Bu, 0x36u, 0xD8u, 0x1B0u};  // around the corners 0, 2, 6 and 8
  const CellMask opens = from & ~at;
  if ((opens & kStraight) != 0) return true;
  for (int k = 0; k < 4; ++k) {
    const CellMask corner = 1u << ((k & 1) * 2 + (k >> 1) * 6);
    if ((opens & corner) != 0 && ((at | beyond) & kSquares[k]) == 0) return true;
  }
  return false;
}

/// The coordinate on kAxis of the first voxel after `from`, up to and including `last`, at which a jump stops. If there
/// is none: `last` + 1 if kUp, otherwise `last` - 1.
template <int kAxis, bool kUp>
std::int32_t walk_line(const Grid& grid, Voxel from, std::int32_t last) noexcept {
  constexpr CellMask kOwn = 1u << 4;
  std::int32_t& at = axis(from, kAxis);
  CellMask behind = cross_section<kAxis>(grid, from);
  while (at != last) {
    at += kUp ? 1 : -1;
    const CellMask here = cross_section<kAxis>(grid, from);
    if ((here & kOwn) != 0) return at;
    if ((behind & ~here) != 0) {
      Voxel next = from;
      axis(next, kAxis) += kUp ? 1 : -1;
      if (section_forces(behind, here, cross_section<kAxis>(grid, next))) return at;
    }
    behind = here;
  }
  return at + (kUp ? 1 : -1);
}

namespace straight_jump {

/// The result of a jump that has neither a jump point nor the goal ahead.
constexpr std::int32_t kNowhere = -1;

/// As jump_straight(), but voxel by voxel, for an axis without stops.
inline std::int32_t stepwise(const Grid& grid, const Voxel& goal, const Voxel& from, int move) noexcept {
  const Voxel step = offset(move);
  const int along = step.x != 0 ? 0 : (step.y != 0 ? 1 : 2);
  Voxel at = from + step;
  // At most kMaxDimension steps: nothing beyond the grid's face is free.
  while (grid.free(at)) {
    const CellMask free = free_cells(grid, at);
    if (same(at, goal) || forced_moves(move, free, legal_moves(free)) != 0) return axis(at, along);
    at = at + step;
  }
  return kNowhere;
}

/// Walks through word k of the line: from `from`, or from the beginning of the word if `from` lies before it. Counts
/// the steps through the tile. Returns the bit of the stop at which the walk ends; 0 if that lies beyond the word.
template <int kAxis, bool kUp>
std::uint64_t walk_word(JumpStopLayer& layer, std::int32_t tile, const Grid& grid, Voxel from,
                        std::int32_t k) noexcept {
  const std::int32_t count = axis(grid.spec().dims, kAxis);
  std::int32_t& at = axis(from, kAxis);
  if (kUp && at < k * 64) at = k * 64 - 1;
  if (!kUp && at > k * 64 + 63) at = k * 64 + 64;
  const std::int32_t last = kUp ? (k * 64 + 63 < count ? k * 64 + 63 : count - 1) : k * 64;
  const std::int32_t stop = walk_line<kAxis, kUp>(grid, from, last);
  const std::int32_t steps = kUp ? stop - at : at - stop;
  const std::int32_t walked = layer.walked[tile] + steps;
  layer.walked[tile] = static_cast<std::uint8_t>(walked < kWalkFirst ? walked : kWalkFirst);
  return stop >> 6 == k ? std::uint64_t{1} << (stop & 63) : 0;
}

/// The stops in word k of the line. If the tile is not made yet, only the first stop ahead: a walk finds it.
template <int kAxis, bool kUp>
std::uint64_t stops_in_word(JumpStopLayer& layer, const Grid& grid, const Voxel& from, std::int32_t k) noexcept {
  const std::int32_t index = jump_stops_index<kAxis>(layer, from, k);
  if constexpr (kAxis == 0) {
    if (!jump_stops_ready(layer, index)) {
      jump_stops_fill_row(layer, grid, from.y, from.z, k);
    }
  } else {
    const std::int32_t tile = jump_stops_tile<kAxis>(layer, from, k);
    if (!jump_stops_ready(layer, tile)) {
      if (layer.walked[tile] < kWalkFirst) return walk_word<kAxis, kUp>(layer, tile, grid, from, k);
      jump_stops_fill_tile(layer, grid, kAxis, from.x >> 6, kAxis == 2 ? from.y : from.z, k);
    }
  }
  return kUp ? layer.bits[index].up : layer.bits[index].down;
}

/// The first stop beyond `from` on its line; past the grid's face if there is none.
template <int kAxis, bool kUp>
std::int32_t next_stop(JumpStopLayer& layer, const Grid& grid, const Voxel& from) noexcept {
  const std::int32_t at = axis(from, kAxis);
  std::uint64_t ahead = kUp ? ~std::uint64_t{1} << (at & 63) : (std::uint64_t{1} << (at & 63)) - 1;
  for (std::int32_t k = at >> 6; kUp ? k < layer.words : k >= 0; k += kUp ? 1 : -1) {
    const std::uint64_t stops = ahead == 0 ? 0 : stops_in_word<kAxis, kUp>(layer, grid, from, k) & ahead;
    if (stops != 0) return k * 64 + (kUp ? __builtin_ctzll(stops) : 63 - __builtin_clzll(stops));
    ahead = ~std::uint64_t{0};
  }
  return kUp ? axis(grid.spec().dims, kAxis) : -1;
}

/// True if the goal lies on the line through `from`, after it and no later than `stop`.
template <int kAxis, bool kUp>
bool meets_goal(const Voxel& goal, const Voxel& from, std::int32_t stop) noexcept {
  constexpr int kB = (kAxis + 1) % 3;
  constexpr int kC = (kAxis + 2) % 3;
  if (axis(goal, kB) != axis(from, kB) || axis(goal, kC) != axis(from, kC)) return false;
  const std::int32_t at = axis(goal, kAxis);
  return kUp ? at > axis(from, kAxis) && at <= stop : at < axis(from, kAxis) && at >= stop;
}

}  // namespace straight_jump

/// Jumps along kAxis from `from`, towards greater (kUp) or lesser coordinates. Returns the coordinate on kAxis of the
/// first voxel that is the goal or has a forced neighbour; straight_jump::kNowhere if an obstacle or the grid's face
/// comes first. The goal must be free.
template <int kAxis, bool kUp>
std::int32_t jump_straight(JumpStopLayer& layer, const Grid& grid, const Voxel& goal, const Voxel& from) noexcept {
  constexpr int kStep = kUp ? 1 : -1;
  if (layer.words == 0) {
    return straight_jump::stepwise(grid, goal, from,
                                   direction(kAxis == 0 ? kStep : 0, kAxis == 1 ? kStep : 0, kAxis == 2 ? kStep : 0));
  }
  const std::int32_t stop = straight_jump::next_stop<kAxis, kUp>(layer, grid, from);
  if (straight_jump::meets_goal<kAxis, kUp>(goal, from, stop)) return axis(goal, kAxis);
  Voxel at = from;
  axis(at, kAxis) = stop;
  return grid.free(at) ? stop : straight_jump::kNowhere;
}

}  // namespace tern

#endif
