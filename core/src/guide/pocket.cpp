// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "guide/pocket.hpp"

#include "base/capacity.hpp"

namespace tern {
namespace {

static_assert(kPocketPages + kSides < kGuidedOpen, "a page is on the list once at most");
static_assert(kPocketPages + kSides < kGuidePages, "a page is taken while there is room for those beside it");

/// Adds voxels of a page to those reached. During a flood, `closed` holds a page's free voxels, and `heads` says that
/// the page is on the list.
void enter(GuidedSearch& search, const Grid& grid, const Voxel& at, VoxelMask voxels) {
  const std::int32_t before = search.store.count;
  const std::int32_t index = page_find_or_add(search.store, {at.x * 4, at.y * 4, at.z * 4});
  Page& page = search.store.pages[index];
  if (search.store.count > before) page.closed = block_voxels(grid, at);
  const VoxelMask more = voxels & page.closed & ~page.reached;
  page.reached |= more;
  if (more == 0 || page.heads) return;
  page.heads = true;
  queue_put(search.open, 0, static_cast<std::uint32_t>(index));
}

bool in_grid(const Grid& grid, const Voxel& at) {
  const Voxel& dims = grid.spec().dims;
  return at.x >= 0 && at.y >= 0 && at.z >= 0 && 4 * at.x < dims.x && 4 * at.y < dims.y && 4 * at.z < dims.z;
}

}  // namespace

void pocket_begin(GuidedSearch& search, const Grid& grid, const Voxel& from) noexcept {
  queue_reset(search.open);
  page_store_reset(search.store);
  enter(search, grid, page_coordinates(from), VoxelMask{1} << place_in_page(from));
}

Status pocket_take(GuidedSearch& search, const Grid& grid, const Voxel& to) noexcept {
  if (search.open.count == 0) return Status::kNoPath;
  if (is_full(search.store.count > kPocketPages)) return Status::kNodesFull;
  Page& page = search.store.pages[queue_take(search.open)];
  page.heads = false;
  page.reached = connected(page.reached, page.closed);
  if (same(page.at, page_coordinates(to)) && (page.reached >> place_in_page(to) & 1u) != 0) return Status::kNodesFull;
  for (int side = 0; side < kSides; ++side) {
    const VoxelMask across = voxels_across(page.reached, side);
    const Voxel beside = page.at + offset(kSideMove[side]);
    if (across != 0 && in_grid(grid, beside)) enter(search, grid, beside, across);
  }
  return Status::kRunning;
}

}  // namespace tern
