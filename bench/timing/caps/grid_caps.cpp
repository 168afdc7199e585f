// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Marking and inflating the largest grid, and the largest radius. Inflation takes words x radius^2, and the two bounds
// together would run for days: each is driven alone.
#include "caps/cap.hpp"

namespace tern_caps {
namespace {

constexpr double kCell = 0.1;

/// As many voxels as there may be, one plane after another along z.
constexpr tern::Voxel kLargest{512, 512, static_cast<std::int32_t>(tern::kMaxCells / (512 * 512))};

std::uint64_t voxels(const tern::Voxel& dims) {
  return static_cast<std::uint64_t>(dims.x) * static_cast<std::uint64_t>(dims.y) * static_cast<std::uint64_t>(dims.z);
}

/// Of a layer whose rows are whole words.
std::uint64_t words(const tern::Voxel& dims) {
  return voxels(dims) / 64;
}

/// Posts so close that no part of the grid is empty, and what is empty is skipped.
void strew(tern::Grid& grid) {
  const tern::Voxel& dims = grid.spec().dims;
  for (std::int32_t z = 0; z < dims.z; z += 4) {
    for (std::int32_t y = 0; y < dims.y; y += 8) grid.mark_voxel({(y * 5 + z) % dims.x, y, z});
  }
}

void largest_grid(const char* name, double radius) {
  tern::Grid grid = make_grid(kLargest, kCell, radius);
  strew(grid);
  const std::uint64_t inflated = count([&] { grid.inflate(); });
  report({name, "inflate", inflated, voxels(grid.spec().dims), tern::kMaxCells, words(kLargest), 1});
}

void largest_radius() {
  const tern::Voxel dims{64, 64, 64};
  tern::Grid grid = make_grid(dims, kCell, tern::kMaxDimension * kCell);
  strew(grid);
  const std::uint64_t inflated = count([&] { grid.inflate(); });
  const auto cells = static_cast<std::uint64_t>(grid.spec().radius / kCell + 0.5);
  report({"radius", "inflate", inflated, cells, tern::kMaxDimension, words(dims), 1});
}

}  // namespace

void grid_caps() {
  tern::Grid grid = make_grid(kLargest, kCell, 0.0);
  const tern::Box all = grid.spec().boundary;
  const std::uint64_t marked = count([&] { grid.mark_box(all); });
  report({"grid_marked", "mark", marked, voxels(kLargest), tern::kMaxCells, words(kLargest), 1});
  largest_grid("grid_radius_3", 3 * kCell);
  largest_grid("grid_radius_10", 10 * kCell);
  largest_radius();
}

}  // namespace tern_caps
