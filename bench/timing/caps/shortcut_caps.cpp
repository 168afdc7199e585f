// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shortcut of a path with as many points as there may be, whose last point sees none of the others.
#include <cstddef>

#include "caps/cap.hpp"
#include "path/shortcut.hpp"

namespace tern_caps {
namespace {

constexpr double kCell = 0.1;
constexpr tern::Voxel kDims{512, tern::kMaxDimension, 32};
constexpr std::size_t kPathOffset = std::size_t{1} << 20;

/// Points along x at one end of the grid, each in sight of all others, and the last one far along y and z behind a
/// wall that its lines of sight meet in the end.
void lay_out(tern::Path& path) {
  const int last = tern::kMaxJumpPoints - 1;
  path.raw_count = tern::kMaxJumpPoints;
  for (int i = 0; i < last; ++i) path.raw[i] = {0.5 + 0.02 * i, 0.5, 0.5};
  path.raw[last] = {25.0, (kDims.y - 2) * kCell, (kDims.z - 2) * kCell};
}

tern::Grid walled_grid() {
  tern::Grid grid = make_grid(kDims, kCell, 0.0);
  tern::Box wall = grid.spec().boundary;
  wall.lower.y = (kDims.y - 5) * kCell;
  wall.upper.y = (kDims.y - 4) * kCell;
  grid.mark_box(wall);
  grid.inflate();
  return grid;
}

}  // namespace

void shortcut_caps() {
  auto& shortcut = state_at<tern::Shortcut>(0);
  auto& path = state_at<tern::Path>(kPathOffset);
  const tern::Grid grid = walled_grid();
  lay_out(path);
  const int last = tern::kMaxJumpPoints - 1;
  tern::shortcut_begin(shortcut, grid, path);
  while (shortcut.head < last) tern::shortcut_step(shortcut, grid, path);
  std::uint64_t instructions = 0;
  std::uint64_t steps = 0;
  for (; tern::shortcut_needs_step(shortcut, path); ++steps) {
    instructions += count([&] { tern::shortcut_step(shortcut, grid, path); });
  }
  report({"last_jump_point", "shortcut", instructions, steps, tern::kSightWindow, steps, tern::kMaxJumpPoints});
}

}  // namespace tern_caps
