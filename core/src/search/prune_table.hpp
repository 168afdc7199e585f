// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The table behind prune.hpp, made at compile time. For every arrival, it has the natural moves and the moves that an
// obstacle may force. For each of the latter, it has the cells that prune the move if they are free.
#ifndef TERN_SEARCH_PRUNE_TABLE_HPP
#define TERN_SEARCH_PRUNE_TABLE_HPP

#include "base/direction.hpp"

namespace tern {
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
}  // namespace tern

#endif
