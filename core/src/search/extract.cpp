// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Follows the path of the search from the goal's node back, and writes its turning points.
#include "search/search.hpp"
#include "search/turn_writer.hpp"

namespace tern {
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
