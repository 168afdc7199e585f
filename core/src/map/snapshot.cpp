// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Snapshots of the route grid, in one go or plane by plane.
#include "base/direction.hpp"
#include "base/math.hpp"
#include "base/work.hpp"
#include "map/grid_words.hpp"
#include "map/map_state.hpp"

namespace tern {
namespace {

/// More units than any job needs.
constexpr std::uint32_t kWholeWork = ~std::uint32_t{0};

bool same_size(const GridSpec& a, const GridSpec& b) {
  return same(a.cell, b.cell) && same(a.dims, b.dims) && same(a.clearance(), b.clearance());
}

/// Binds the grid to the words, unless it is already bound to them with the size of the route grid.
Status place(Grid& grid, const Grid& route, std::uint64_t* words, std::size_t word_count) {
  const bool there = grid.bound() && GridWords(grid).lies_in(words) && same_size(grid.spec(), route.spec());
  return there ? Status::kOk : grid.bind(route.spec(), words, word_count);
}

}  // namespace

Status RollingMap::snapshot(Grid& grid, uint64_t* words, size_t word_count) noexcept {
  const Status status = begin_snapshot(grid, words, word_count);
  return status == Status::kRunning ? step(kWholeWork) : status;
}

Status RollingMap::begin_snapshot(Grid& grid, uint64_t* words, size_t word_count) noexcept {
  if (state_ == nullptr || busy()) return Status::kInvalidArgument;
  const Status status = place(grid, state_->route, words, word_count);
  if (status != Status::kOk) return status;
  GridWords(grid).begin_copy(state_->route);
  state_->copy = &grid;
  state_->begin(Task::kCopy);
  return Status::kRunning;
}

void MapState::copy_plane(std::int32_t z, Work& work) const noexcept {
  work.spend(ops::kPiece + 2 * ops::kElement * static_cast<Operations>(row(0, 1)));
  GridWords(*copy).copy_planes(route, z, z + 1);
  if (z + 1 == spec.dims.z) GridWords(*copy).end_copy(route);
}

}  // namespace tern
