// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The guided search up to its limit of expansions, and a flood up to its limit of pages.
#include "caps/cap.hpp"
#include "guide/pocket.hpp"
#include "support/random.hpp"

namespace tern_caps {
namespace {

constexpr double kCell = 0.1;
/// A fast search runs its guided search twice at most, and a flood around each end.
constexpr std::uint64_t kTimes = 2;
/// Units after which the counter is read.
constexpr std::uint32_t kSlice = 1000;

struct Run {
  std::uint64_t count;
  std::uint64_t units;
};

/// A winding lane through a grid of nearly TERN_MAX_CELLS voxels. Its path is longer than the limit of expansions. The
/// walls are thinner than a block and split the blocks beside them.
tern::Grid winding_lane() {
  constexpr std::int32_t kSide = 1024;
  constexpr std::int32_t kHeight = 60;
  constexpr std::int32_t kWidth = 16;
  tern::Grid grid = make_grid({kSide, kSide, kHeight}, kCell, 0.0);
  for (std::int32_t x = kWidth + 1; x < kSide; x += kWidth) {
    const std::int32_t open_at_end = x / kWidth % 2 * kWidth;
    const std::int32_t from = kWidth - open_at_end;
    for (std::int32_t y = from; y < from + kSide - kWidth; ++y) {
      for (std::int32_t z = 0; z < kHeight; ++z) grid.mark_voxel({x, y, z});
    }
  }
  grid.inflate();
  return grid;
}

void guided_cap() {
  auto& search = state_at<tern::GuidedSearch>(0);
  const tern::Grid grid = winding_lane();
  const tern::Voxel& dims = grid.spec().dims;
  tern::guided_begin(search, grid, {2, 2, 2}, {dims.x - 2, 2, dims.z - 2});
  tern::guided_reopen(search, grid);  // it shall not stall
  Run run{};
  tern::Status status = tern::Status::kRunning;
  while (status == tern::Status::kRunning) {
    tern::Work slice{kSlice};
    run.count += count([&] { status = tern::guided_advance(search, grid, slice); });
    run.units += kSlice;
  }
  // The search ends as it is about to exceed the limit.
  const std::uint32_t expanded = status == tern::Status::kNodesFull ? search.expanded - 1 : 0;
  report({"guided", "search", run.count, expanded, tern::kGuidedExpansions, run.units, kTimes});
}

/// Half of the voxels are blocked, so that the flood comes back to many pages.
tern::Grid labyrinth(std::int32_t side) {
  tern_test::Random random(1);
  tern::Grid grid = make_grid({side, side, side}, kCell, 0.0);
  const tern::Voxel start{side / 2, side / 2, side / 2};
  for (std::int32_t z = 0; z < side; ++z) {
    for (std::int32_t y = 0; y < side; ++y) {
      for (std::int32_t x = 0; x < side; ++x) {
        if (random.chance(0.5)) grid.mark_voxel({x, y, z});
      }
    }
  }
  grid.clear_voxel(start);
  grid.inflate();
  return grid;
}

void pocket_cap() {
  constexpr std::int32_t kSide = 96;
  auto& search = state_at<tern::GuidedSearch>(0);
  const tern::Grid grid = labyrinth(kSide);
  Run run{};
  run.count = count([&] { tern::pocket_begin(search, grid, {kSide / 2, kSide / 2, kSide / 2}); });
  tern::Status status = tern::Status::kRunning;
  for (; status == tern::Status::kRunning; ++run.units) {
    run.count += count([&] { status = tern::pocket_take(search, grid, {0, 0, 0}); });
  }
  run.units = run.units * tern::kPocketOperations / tern::kUnit;
  const bool full = status == tern::Status::kNodesFull && search.store.count > tern::kPocketPages;
  report({"pocket", "search", run.count, full ? tern::kPocketPages : std::uint64_t{0}, tern::kPocketPages, run.units,
          kTimes});
}

}  // namespace

void guided_caps() {
  guided_cap();
  pocket_cap();
}

}  // namespace tern_caps
