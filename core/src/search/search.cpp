// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "search/search.hpp"

#include "base/capacity.hpp"
#include "grid/bit_rows.hpp"
#include "search/jump.hpp"
#include "search/neighbourhood.hpp"
#include "search/prune.hpp"
#include "search/turn_writer.hpp"

namespace tern {
namespace {

/// While the search makes progress, it goes on step by step, for up to this many times its least number of steps.
constexpr std::uint32_t kMostSteps = 4;

/// A search begins step by step, as A* does, but without the moves that jump point search prunes. An easy query ends
/// this way before jumps would pay. True up to the least number of steps, and then while the progress so far suggests
/// that the search ends within the largest number.
bool steps_pay(const Search& search) {
  if (search.expanded <= search.steps) return true;
  const Cost whole = octile(search.start, search.goal) / kStraightCost;
  const Cost made = whole - search.least_h / kStraightCost;
  return search.expanded * whole <= kMostSteps * search.steps * made;
}

/// Clears the data that jumps read, and enters the voxels that steps have reached.
void begin_jumps(Search& search, const Grid& grid, Work& work) {
  search.jumps = true;
  work.spend(static_cast<Operations>(GridAccess::layer_words(grid)) + ops::kRow * search.store.count);
  for (int a = 0; a < 3; ++a) jump_stops_reset(search.stops[a], grid, a);
  dominance_reset(search.dominance, grid);
  for (std::uint32_t k = 0; k < search.store.count; ++k) {
    const SearchNode& node = search.store.nodes[k];
    dominated_else_record(search.dominance, grid, node.at(), node.g);
  }
}

/// The largest slack, in voxels. Sweeps go on until f exceeds the expanded node's by the slack. The slack is 0 at
/// first, so that easy queries do not sweep voxels that they never need. It grows as the search lasts, so that hard
/// queries open few nodes. Any slack gives a path of the same cost; these constants were tuned on the six maps and on
/// random ones.
constexpr Cost kMostSlack = 16;
constexpr Cost kSlackPace = 1024;  ///< expansions until the slack grows by a voxel

Cost sweep_slack(const Search& search) {
  const Cost grown = search.expanded / kSlackPace;
  return (grown < kMostSlack ? grown : kMostSlack) * kStraightCost;
}

/// Moves to follow from a node: those that some arrival calls for, except those already followed at this cost.
CellMask moves_to_follow(const SearchNode& node, CellMask free) {
  const CellMask legal = legal_moves(free);
  CellMask moves = 0;
  for (CellMask left = node.arrivals; left != 0; left &= left - 1) {
    moves |= successor_moves(__builtin_ctz(left), free, legal);
  }
  return moves & ~node.followed;
}

Status end_or_running(const Search& search) {
  if (search.nodes_full) return Status::kNodesFull;
  if (search.open_full) return Status::kOpenFull;
  return search.open.count > 0 ? Status::kRunning : Status::kNoPath;
}

}  // namespace

void search_begin(Search& search, const Grid& grid, const Voxel& start, const Voxel& goal,
                  std::uint32_t steps) noexcept {
  search.start = start;
  search.goal = goal;
  search.nodes_full = false;
  search.open_full = false;
  search.expanded = 0;
  search.jumped = 0;
  search.units = 0;
  store_reset(search.store, grid.spec().dims);
  search.jumps = false;
  search.steps = steps;
  search.least_h = octile(start, goal);
  open_reset(search.open, search.least_h);
  const std::uint32_t node = store_find_or_add(search.store, start);
  search.store.nodes[node].arrivals = cell_bit(kHere);
  open_put(search.open, search.store, node, open_key(0, search.least_h, search.store.nodes[node].voxel));
}

Status search_expand(Search& search, const Grid& grid, Work& work) noexcept {
  if (is_full(search.units == kExpansionBound)) return Status::kNodesFull;
  ++search.units;
  work.spend(6 * ops::kNode);
  if (!open_ready(search.open, search.store, search.goal)) return end_or_running(search);
  Cost f = 0;
  const std::uint32_t index = open_take(search.open, search.store, f);
  if (index == static_cast<std::uint32_t>(kMaxNodes)) return end_or_running(search);
  ++search.expanded;
  SearchNode& node = search.store.nodes[index];
  const Voxel at = node.at();
  if (same(at, search.goal)) return Status::kOk;
  if (f - node.g < search.least_h) search.least_h = f - node.g;
  if (!search.jumps && !steps_pay(search)) begin_jumps(search, grid, work);
  if (search.jumps) ++search.jumped;
  if (search.jumps && dominated_else_record(search.dominance, grid, at, node.g)) return end_or_running(search);
  const CellMask free = free_cells(grid, at);
  const CellMask moves = moves_to_follow(node, free);
  node.followed |= moves;
  const Expansion expansion{search, grid, work, index, at, node.g, f + sweep_slack(search)};
  for (CellMask left = moves; left != 0; left &= left - 1) {
    const int move = __builtin_ctz(left);
    if (search.jumps) {
      jump(expansion, move, free);
    } else {
      step(expansion, move);
    }
  }
  return end_or_running(search);
}

namespace {

std::int32_t sign(std::int32_t v) {
  return (v > 0 ? 1 : 0) - (v < 0 ? 1 : 0);
}

/// A jump goes along three axes first, then two, then one.
void write_jump(TurnWriter& writer, const Voxel& to) {
  const Voxel from = writer.last;
  const MoveCounts counts = octile_moves(from, to);
  const Voxel d{to.x - from.x, to.y - from.y, to.z - from.z};
  const std::int32_t middle = counts.space + counts.plane;
  const auto part = [&d](std::int32_t beyond) {
    return direction(magnitude(d.x) > beyond ? sign(d.x) : 0, magnitude(d.y) > beyond ? sign(d.y) : 0,
                     magnitude(d.z) > beyond ? sign(d.z) : 0);
  };
  writer.run(part(0), counts.space);
  writer.run(part(counts.space), counts.plane);
  writer.run(part(middle), counts.straight);
}

/// Reverses the parents between goal and start, so that they lead from start to goal. Returns the start's node.
std::uint32_t reverse_parents(NodeStore& store, std::uint32_t goal) {
  std::uint32_t next = goal;
  std::uint32_t node = goal;
  // A path holds each node once.
  for (std::uint32_t k = 0; k < store.count; ++k) {
    const std::uint32_t parent = store.nodes[node].parent;
    store.nodes[node].parent = next;
    if (parent == node) break;
    next = node;
    node = parent;
  }
  return node;
}

}  // namespace

Status search_extract(Search& search, const Grid& grid, int reserve, Path& path) noexcept {
  NodeStore& store = search.store;
  const std::uint32_t goal = store_find_or_add(store, search.goal);
  TurnWriter writer(grid, path, reserve, search.start);
  std::uint32_t node = reverse_parents(store, goal);
  for (std::uint32_t k = 0; k < store.count && node != goal; ++k) {
    node = store.nodes[node].parent;
    write_jump(writer, store.nodes[node].at());
  }
  return writer.finish();
}

}  // namespace tern
