// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Straight scans: from a voxel along one axis to the first jump point, 64 voxels a step. Callers spend the same for a
// scan whether its stops are kept from an earlier search or made now, which takes 1 to 2 % of a search. So what a
// search spends does not depend on what the planner did before.
#ifndef TERN_SEARCH_SCAN_HPP
#define TERN_SEARCH_SCAN_HPP

#include "base/direction.hpp"
#include "grid/lattice.hpp"
#include "search/jump_stops.hpp"
#include "search/line_walk.hpp"
#include "tern/grid.hpp"

namespace tern {

namespace scan {

/// The result of a scan that has neither a jump point nor the goal ahead.
constexpr std::int32_t kNowhere = -1;

/// Does what scan_straight does, but voxel by voxel, along an axis whose layer has no stops.
std::int32_t stepwise(const Grid& grid, const Voxel& goal, const Voxel& from, int move) noexcept;

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

/// The stops ahead in word k of the line. If the tile has not been made yet, only the first of them, which a walk
/// finds.
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

}  // namespace scan

/// Scans along kAxis from `from`, towards greater (kUp) or lesser coordinates. Returns the coordinate on kAxis of the
/// first voxel that is the goal or has a forced neighbour; scan::kNowhere if an obstacle or the grid's face comes
/// first. The goal must be free.
template <int kAxis, bool kUp>
std::int32_t scan_straight(JumpStopLayer& layer, const Grid& grid, const Voxel& goal, const Voxel& from) noexcept {
  constexpr int kStep = kUp ? 1 : -1;
  if (layer.words == 0) {
    return scan::stepwise(grid, goal, from,
                          direction(kAxis == 0 ? kStep : 0, kAxis == 1 ? kStep : 0, kAxis == 2 ? kStep : 0));
  }
  const std::int32_t stop = scan::next_stop<kAxis, kUp>(layer, grid, from);
  if (scan::meets_goal<kAxis, kUp>(goal, from, stop)) return axis(goal, kAxis);
  Voxel at = from;
  axis(at, kAxis) = stop;
  return grid.free(at) ? stop : scan::kNowhere;
}

}  // namespace tern

#endif
