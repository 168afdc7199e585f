// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The moves that a search must follow from a voxel, given the move that reached it: natural and forced neighbours of
// jump point search in three dimensions, without corner cutting.
//
// Let p be the voxel before n, and m the voxel after it. The move to m is pruned if the 3x3x3 cells around n hold a
// path from p to m that avoids n and is shorter. It is also pruned if such a path is as long but begins with a move
// along more axes (space diagonals before plane diagonals before straight moves). Of all cheapest paths, the one that
// turns to moves along fewer axes as late as possible is never pruned.
#ifndef TERN_SEARCH_PRUNE_HPP
#define TERN_SEARCH_PRUNE_HPP

#include "base/direction.hpp"

namespace tern {

// The table behind these rules, made at compile time. For every arrival, it has the natural moves and the moves that an
// obstacle may force. For each of the latter, it has the cells that prune the move if they are free.

namespace prune {

/// Cells of the box that a move spans, the centre left out.
constexpr CellMask box_cells(int move) {
  const Voxel o = offset(move);
  CellMask cells = 0;
  for (int part = 1; part < 8; ++part) {
    const int d = direction((part & 1) != 0 ? o.x : 0, (part & 2) != 0 ? o.y : 0, (part & 4) != 0 ? o.z : 0);
    if (d != kHere) cells |= cell_bit(d);
  }
  return cells;
}

/// A move and the cells of two ways around the voxel that it starts from. The move is pruned if all cells of either way
/// are free. A mask with bits beyond kAllCells stands for no way.
struct WaysAround {
  CellMask first;
  CellMask second;
  int move;
};
constexpr CellMask kNoWay = ~CellMask{0};

/// The most moves that an arrival may force. A straight arrival has 8 moves sideways, and 8 both sideways and forwards.
/// A plane diagonal has 4 on each side of its plane.
constexpr int kMaxWaysAround = 16;

struct PruneRule {
  CellMask natural;
  CellMask watch;  ///< if all of these are free, nothing is forced
  int count;
  WaysAround ways[kMaxWaysAround];
};

struct PruneTable {
  CellMask box[kDirections];
  PruneRule rule[kDirections];
};

constexpr CellMask cell_at(const Voxel& o) {
  return cell_bit(direction(o.x, o.y, o.z));
}

constexpr void add(PruneRule& rule, const Voxel& move, CellMask first, CellMask second) {
  rule.ways[rule.count] = {first, second, direction(move.x, move.y, move.z)};
  ++rule.count;
}

/// Adds moves s and s + u for a straight arrival u from p = -u, with s at right angles to u. They are forced at n if an
/// obstacle keeps p from making the step s itself.
constexpr void add_straight_ways(PruneRule& rule, const Voxel& u, const Voxel& s) {
  const Voxel p{-u.x, -u.y, -u.z};
  rule.watch |= cell_at(p + s);
  if (axes_of(direction(s.x, s.y, s.z)) == 1) {
    add(rule, s, cell_at(p + s), kNoWay);
    add(rule, s + u, cell_at(p + s), kNoWay);
    return;
  }
  // a and b are the two straight parts of a sideways diagonal.
  const Voxel a = u.x != 0 ? Voxel{0, s.y, 0} : Voxel{s.x, 0, 0};
  const Voxel b = u.z != 0 ? Voxel{0, s.y, 0} : Voxel{0, 0, s.z};
  add(rule, s, cell_at(p + a), cell_at(p + b));
  add(rule, s + u, cell_at(p + a) | cell_at(p + b) | cell_at(p + s), kNoWay);
}

/// Adds the moves out of the plane of a plane diagonal u + v from p = -u - v, on the side of w. They are forced if an
/// obstacle keeps p from moving along the space diagonal u + v + w.
constexpr void add_plane_ways(PruneRule& rule, const Voxel& u, const Voxel& v, const Voxel& w) {
  const Voxel p{-u.x - v.x, -u.y - v.y, -u.z - v.z};
  const CellMask above = cell_at(p + w) | cell_at(p + u + w) | cell_at(p + v + w);
  rule.watch |= above;
  add(rule, w, above, kNoWay);
  add(rule, u + v + w, above, kNoWay);
  add(rule, u + w, above, cell_at(p + u + w) | cell_at(p + u + u + w) | cell_at(p + u + u));
  add(rule, v + w, above, cell_at(p + v + w) | cell_at(p + v + v + w) | cell_at(p + v + v));
}

constexpr PruneRule straight_rule(int arrival) {
  PruneRule rule{box_cells(arrival), 0, 0, {}};
  const Voxel u = offset(arrival);
  for (int d = 0; d < kDirections; ++d) {
    const Voxel s = offset(d);
    if (d != kHere && s.x * u.x + s.y * u.y + s.z * u.z == 0) add_straight_ways(rule, u, s);
  }
  return rule;
}

constexpr PruneRule plane_rule(int arrival) {
  PruneRule rule{box_cells(arrival), 0, 0, {}};
  const Voxel o = offset(arrival);
  const Voxel u = o.x != 0 ? Voxel{o.x, 0, 0} : Voxel{0, o.y, 0};
  const Voxel v = o.z != 0 ? Voxel{0, 0, o.z} : Voxel{0, o.y, 0};
  const Voxel w{o.x == 0 ? 1 : 0, o.y == 0 ? 1 : 0, o.z == 0 ? 1 : 0};
  add_plane_ways(rule, u, v, w);
  add_plane_ways(rule, u, v, {-w.x, -w.y, -w.z});
  return rule;
}

constexpr PruneTable make_table() {
  PruneTable table{};
  for (int d = 0; d < kDirections; ++d) {
    table.box[d] = box_cells(d);
    if (axes_of(d) == 0) table.rule[d] = {kAllCells & ~cell_bit(kHere), 0, 0, {}};
    if (axes_of(d) == 1) table.rule[d] = straight_rule(d);
    if (axes_of(d) == 2) table.rule[d] = plane_rule(d);
    // The whole box of a space diagonal is free, so p reaches every cell that is not natural as cheaply without n.
    if (axes_of(d) == 3) table.rule[d] = {box_cells(d), 0, 0, {}};
  }
  return table;
}

inline constexpr PruneTable kPrune = make_table();

/// Cells around a centre. straight[a]: one step along axis a. plane[a]: one step along each axis but a. space: one step
/// along all three.
struct CellSets {
  CellMask straight[3];
  CellMask plane[3];
  CellMask space;
};

constexpr CellSets make_sets() {
  CellSets sets{};
  for (int d = 0; d < kDirections; ++d) {
    const Voxel o = offset(d);
    const int axes = axes_of(d);
    if (axes == 1) sets.straight[o.x != 0 ? 0 : (o.y != 0 ? 1 : 2)] |= cell_bit(d);
    if (axes == 2) sets.plane[o.x == 0 ? 0 : (o.y == 0 ? 1 : 2)] |= cell_bit(d);
    if (axes == 3) sets.space |= cell_bit(d);
  }
  return sets;
}

inline constexpr CellSets kSets = make_sets();

constexpr bool covers(CellMask free, CellMask cells) {
  return (free & cells) == cells;
}

}  // namespace prune

/// True if the move is legal from the centre of a neighbourhood: every cell of its 1x2, 2x2 or 2x2x2 box is free.
inline bool legal_move(int move, CellMask free) noexcept {
  return prune::covers(free, prune::kPrune.box[move]);
}

/// All legal moves. A diagonal's box consists of its end and the boxes of its parts along fewer axes. A step along x, y
/// or z is 1, 3 or 9 places in the mask.
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
