// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/plain_jps.hpp"

#include <algorithm>

#include "search/neighbourhood.hpp"
#include "search/prune.hpp"

namespace tern_bench {

using tern::CellMask;
using tern::Cost;
using tern::Voxel;

PlainJps::PlainJps(const tern::Grid& grid) : grid_(grid) {
  const Voxel& dims = grid.spec().dims;
  nodes_.resize(static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y * dims.z));
}

std::uint32_t PlainJps::index_of(const Voxel& v) const {
  const Voxel& dims = grid_.spec().dims;
  return static_cast<std::uint32_t>(v.x + dims.x * (v.y + dims.y * v.z));
}

Voxel PlainJps::voxel_of(std::uint32_t index) const {
  const Voxel& dims = grid_.spec().dims;
  const int i = static_cast<int>(index);
  return {i % dims.x, i / dims.x % dims.y, i / dims.x / dims.y};
}

bool PlainJps::jump(Voxel at, int move, Voxel& found) const {
  CellMask free = tern::free_cells(grid_, at);
  while (tern::legal_move(move, free)) {
    at = at + tern::offset(move);
    free = tern::free_cells(grid_, at);
    found = at;
    if (tern::same(at, goal_) || tern::forced_moves(move, free, tern::legal_moves(free)) != 0) return true;
    // A jump point along a natural part of a diagonal makes this voxel one, too.
    Voxel beyond{};
    for (CellMask left = tern::natural_moves(move); left != 0; left &= left - 1) {
      const int part = __builtin_ctz(left);
      if (part != move && jump(at, part, beyond)) return true;
    }
  }
  return false;
}

void PlainJps::relax(std::uint32_t from, const Voxel& to, int arrival) {
  const std::uint32_t index = index_of(to);
  const Cost g = nodes_[from].g + tern::octile(voxel_of(from), to);
  Node& node = nodes_[index];
  const bool better = node.arrivals == 0 || g < node.g;
  if (!better && (g > node.g || (node.arrivals & tern::cell_bit(arrival)) != 0)) return;
  if (better) node = {g, from, 0, 0};
  node.arrivals |= tern::cell_bit(arrival);
  const Cost h = tern::octile(to, goal_);
  open_.push({g + h, h, index});
}

void PlainJps::expand(std::uint32_t index) {
  const Voxel at = voxel_of(index);
  const CellMask free = tern::free_cells(grid_, at);
  const CellMask legal = tern::legal_moves(free);
  CellMask moves = 0;
  for (CellMask left = nodes_[index].arrivals; left != 0; left &= left - 1) {
    moves |= tern::successor_moves(__builtin_ctz(left), free, legal);
  }
  moves &= ~nodes_[index].followed;
  nodes_[index].followed |= moves;
  Voxel found{};
  for (CellMask left = moves; left != 0; left &= left - 1) {
    const int move = __builtin_ctz(left);
    if (jump(at, move, found)) relax(index, found, move);
  }
}

bool PlainJps::run(const Voxel& start, const Voxel& goal) {
  std::fill(nodes_.begin(), nodes_.end(), Node{0, 0, 0, 0});
  open_ = {};
  expanded_ = 0;
  goal_ = goal;
  const std::uint32_t first = index_of(start);
  nodes_[first] = {0, first, tern::cell_bit(tern::kHere), 0};
  open_.push({tern::octile(start, goal), tern::octile(start, goal), first});
  while (!open_.empty()) {
    const Entry entry = open_.top();
    open_.pop();
    // A better way came since the entry was made.
    if (entry.f - entry.h > nodes_[entry.index].g) continue;
    ++expanded_;
    cost_ = nodes_[entry.index].g;
    if (tern::same(voxel_of(entry.index), goal)) return true;
    expand(entry.index);
  }
  return false;
}

std::vector<Voxel> PlainJps::path() const {
  std::vector<Voxel> path;
  std::uint32_t index = index_of(goal_);
  if (nodes_[index].arrivals == 0) return path;
  for (; nodes_[index].parent != index; index = nodes_[index].parent) path.push_back(voxel_of(index));
  path.push_back(voxel_of(index));
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace tern_bench
