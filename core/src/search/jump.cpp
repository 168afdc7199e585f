// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/jump.hpp"

#include "base/capacity.hpp"
#include "search/plane_walk.hpp"
#include "search/prune.hpp"
#include "search/straight_jump.hpp"

namespace tern {
namespace {

/// Records a path of cost g that arrives at `voxel` by the move `arrival`; h is the voxel's heuristic. A better path
/// replaces the known one. An equally good path adds its arrival. A worse path changes nothing.
void relax(const Expansion& from, const Voxel& voxel, Cost g, Cost h, int arrival) {
  Search& search = from.search;
  from.work.spend(ops::kNode);
  const std::uint32_t index = store_find_or_add(search.store, voxel);
  if (is_full(index == static_cast<std::uint32_t>(kMaxNodes))) {
    search.nodes_full = true;
    return;
  }
  SearchNode& node = search.store.nodes[index];
  const bool better = node.arrivals == 0 || g < node.g;
  if (!better && (g > node.g || (node.arrivals & cell_bit(arrival)) != 0)) return;
  if (better) {
    node.g = g;
    node.parent = from.node;
    node.arrivals = 0;
    node.followed = 0;
  }
  node.arrivals |= cell_bit(arrival);
  const bool room = !is_full(!open_put(search.open, search.store, index, open_key(g, h, node.voxel)));
  if (!room) search.open_full = true;
}

/// Jumps straight from a voxel that the expansion reaches at cost g.
template <int kAxis, bool kUp>
void jump_line(const Expansion& from, const Voxel& cursor, Cost g) {
  Search& search = from.search;
  from.work.spend(ops::kNode);
  const std::int32_t stop = jump_straight<kAxis, kUp>(search.stops[kAxis], from.grid, search.goal, cursor);
  if (stop == straight_jump::kNowhere) return;
  Voxel found = cursor;
  axis(found, kAxis) = stop;
  const std::int32_t steps = kUp ? stop - axis(cursor, kAxis) : axis(cursor, kAxis) - stop;
  g += static_cast<Cost>(steps) * kStraightCost;
  if (dominated_else_record(search.dominance, from.grid, found, g)) return;
  constexpr int kStep = kUp ? 1 : -1;
  relax(from, found, g, octile(found, search.goal),
        direction(kAxis == 0 ? kStep : 0, kAxis == 1 ? kStep : 0, kAxis == 2 ? kStep : 0));
}

template <int kAxis>
void jump_axis(const Expansion& from, const Voxel& cursor, Cost g, std::int32_t step) {
  if (step > 0) return jump_line<kAxis, true>(from, cursor, g);
  jump_line<kAxis, false>(from, cursor, g);
}

/// True if a sweep must end at a voxel and make it a node. g and h are the voxel's cost so far and heuristic. Only the
/// goal has h = 0.
bool stops_at(const Expansion& from, Cost g, Cost h, int step) {
  return step >= kSweepSteps || h == 0 || g + h > from.limit;
}

/// The number of steps `step` from `at` that stay inside the grid; at most kSweepSteps.
int steps_inside(const Grid& grid, const Voxel& at, const Voxel& step) {
  int steps = kSweepSteps;
  for (int a = 0; a < 3; ++a) {
    const std::int32_t room = axis(step, a) > 0 ? axis(grid.spec().dims, a) - 1 - axis(at, a) : axis(at, a);
    if (axis(step, a) != 0 && room < steps) steps = room;
  }
  return steps;
}

/// Sweeps along the plane diagonal `move`; kNormal is the axis at right angles to its plane. From every step,
/// jumps along both parts of the move.
template <int kNormal>
void sweep_plane(const Expansion& from, Voxel cursor, Cost g, int move) {
  constexpr int kFirst = kNormal == 0 ? 1 : 0;
  constexpr int kSecond = kNormal == 2 ? 1 : 2;
  const Voxel step = kMoveOf.at[move].step;
  const int steps = steps_inside(from.grid, cursor, step);
  PlaneWalk<kNormal> walk(from.grid, cursor, step);
  for (int k = 1; k <= steps && walk.step(); ++k) {
    cursor = cursor + step;
    g += kPlaneDiagonalCost;
    from.work.spend(ops::kNode);
    if (dominated_else_record(from.search.dominance, from.grid, cursor, g)) return;
    const Cost h = octile(cursor, from.search.goal);
    if (walk.forced() || stops_at(from, g, h, k)) return relax(from, cursor, g, h, move);
    jump_axis<kFirst>(from, cursor, g, axis(step, kFirst));
    jump_axis<kSecond>(from, cursor, g, axis(step, kSecond));
  }
}

/// Follows straight moves and plane diagonals from a voxel that the expansion reaches at cost g.
void follow(const Expansion& from, const Voxel& cursor, Cost g, int move) {
  const Voxel step = kMoveOf.at[move].step;
  if (axes_of(move) == 2) {
    if (step.x == 0) return sweep_plane<0>(from, cursor, g, move);
    if (step.y == 0) return sweep_plane<1>(from, cursor, g, move);
    return sweep_plane<2>(from, cursor, g, move);
  }
  if (step.x != 0) return jump_axis<0>(from, cursor, g, step.x);
  if (step.y != 0) return jump_axis<1>(from, cursor, g, step.y);
  jump_axis<2>(from, cursor, g, step.z);
}

/// Sweeps along a space diagonal. From every step, follows the parts of the move along fewer axes. A space diagonal
/// never forces a move.
void sweep_space(const Expansion& from, int move, CellMask free) {
  const CellMask parts = natural_moves(move) & ~cell_bit(move);
  const Voxel step = kMoveOf.at[move].step;
  Voxel cursor = from.at;
  Cost g = from.g;
  for (int k = 1; legal_move(move, free); ++k) {
    cursor = cursor + step;
    g += kSpaceDiagonalCost;
    from.work.spend(ops::kNode);
    if (dominated_else_record(from.search.dominance, from.grid, cursor, g)) return;
    const Cost h = octile(cursor, from.search.goal);
    if (stops_at(from, g, h, k)) return relax(from, cursor, g, h, move);
    for (CellMask left = parts; left != 0; left &= left - 1) follow(from, cursor, g, __builtin_ctz(left));
    free = free_cells(from.grid, cursor);
  }
}

}  // namespace

void step(const Expansion& expansion, int move) noexcept {
  const Move& taken = kMoveOf.at[move];
  const Voxel to = expansion.at + taken.step;
  relax(expansion, to, expansion.g + taken.cost, octile(to, expansion.search.goal), move);
}

void jump(const Expansion& expansion, int move, CellMask free) noexcept {
  if (axes_of(move) == 3) return sweep_space(expansion, move, free);
  follow(expansion, expansion.at, expansion.g, move);
}

}  // namespace tern
