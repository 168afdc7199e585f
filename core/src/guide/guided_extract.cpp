// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Follows the moves of the guided search back from the goal, and writes the turning points.
#include "guide/guided_search.hpp"
#include "search/turn_writer.hpp"

namespace tern {
namespace {

/// The stored move of a voxel on the path: the move that reaches it, or, once the moves are reversed, the one that
/// leaves it.
std::uint8_t& move_at(GuidedSearch& search, const Voxel& voxel) {
  return search.store.pages[page_find_or_add(search.store, voxel)].arrival[place_in_block(voxel)];
}

/// Reverses the moves, which then lead from the start to the goal.
void reverse_moves(GuidedSearch& search) {
  Voxel at = search.goal;
  std::uint8_t departure = kHere;
  // A path contains each expanded voxel at most once.
  for (std::uint32_t k = 0; k <= kGuidedExpansions; ++k) {
    std::uint8_t& move = move_at(search, at);
    const std::uint8_t arrival = move;
    move = departure;
    if (arrival == kHere) return;
    const Voxel step = offset(arrival);
    at = {at.x - step.x, at.y - step.y, at.z - step.z};
    departure = arrival;
  }
}

}  // namespace

Status guided_extract(GuidedSearch& search, const Grid& grid, int reserve, Path& path) noexcept {
  reverse_moves(search);
  TurnWriter writer(grid, path, reserve, search.start);
  for (std::uint32_t k = 0; k <= kGuidedExpansions && !same(writer.last, search.goal); ++k) {
    writer.run(move_at(search, writer.last), 1);
  }
  return writer.finish();
}

}  // namespace tern
