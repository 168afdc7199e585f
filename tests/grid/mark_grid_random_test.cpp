// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Grid::mark_grid() against the same rule, voxel by voxel.
#include <gtest/gtest.h>

#include <vector>

#include "support/grid_storage.hpp"
#include "support/random.hpp"
#include "tern/grid.hpp"

namespace {

using tern::Status;
using tern::Voxel;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

using Labels = std::vector<int>;

int index_in(const Voxel& dims, const Voxel& v) {
  return v.x + dims.x * (v.y + dims.y * v.z);
}

bool same_cell(const Voxel& a, const Voxel& b) {
  return a.x / 4 == b.x / 4 && a.y / 4 == b.y / 4 && a.z / 4 == b.z / 4;
}

Voxel moved(Voxel v, int side) {
  (side / 2 == 0 ? v.x : (side / 2 == 1 ? v.y : v.z)) += side % 2 == 0 ? -1 : 1;
  return v;
}

/// Gives all free voxels that hang together with `seed` the label, within its cell alone or everywhere. Returns how
/// many they are.
int label_from(const tern::Grid& grid, const Voxel& seed, int label, bool in_cell, Labels& labels) {
  const Voxel dims = grid.spec().dims;
  std::vector<Voxel> open{seed};
  labels[index_in(dims, seed)] = label;
  int count = 0;
  while (!open.empty()) {
    const Voxel at = open.back();
    open.pop_back();
    ++count;
    for (int side = 0; side < 6; ++side) {
      const Voxel next = moved(at, side);
      if (!grid.free(next) || (in_cell && !same_cell(next, at)) || labels[index_in(dims, next)] != 0) continue;
      labels[index_in(dims, next)] = label;
      open.push_back(next);
    }
  }
  return count;
}

/// The cells' free parts, each with its cell's number + 1 as the label; 0 for all other voxels. `sizes` by cell.
Labels parts_of_cells(const tern::Grid& fine, const Voxel& cells, std::vector<int>& sizes) {
  Labels labels(index_in(fine.spec().dims, {0, 0, fine.spec().dims.z}));
  Labels best = labels;
  sizes.assign(index_in(cells, {0, 0, cells.z}), 0);
  int next = 1;
  tern_test::for_each_voxel(fine.spec().dims, [&](const Voxel& v) {
    if (!fine.free(v) || labels[index_in(fine.spec().dims, v)] != 0) return;
    const int label = next++;
    const int cell = index_in(cells, {v.x / 4, v.y / 4, v.z / 4});
    const int size = label_from(fine, v, label, true, labels);
    if (size < 32 || size <= sizes[cell]) return;
    sizes[cell] = size;
    for (std::size_t k = 0; k < labels.size(); ++k) {
      if (best[k] == cell + 1) best[k] = 0;
      if (labels[k] == label) best[k] = cell + 1;
    }
  });
  return best;
}

/// How many pairs of voxels of two cells' parts share a face.
int contacts(const Labels& parts, const Voxel& dims, int a, int b) {
  int count = 0;
  tern_test::for_each_voxel(dims, [&](const Voxel& v) {
    for (int side = 1; side < 6; side += 2) {
      const Voxel next = moved(v, side);
      if (next.x >= dims.x || next.y >= dims.y || next.z >= dims.z) continue;
      const int one = parts[index_in(dims, v)];
      const int other = parts[index_in(dims, next)];
      count += (one == a + 1 && other == b + 1) || (one == b + 1 && other == a + 1) ? 1 : 0;
    }
  });
  return count;
}

bool is_inside(const Voxel& dims, const Voxel& v) {
  return v.x >= 0 && v.y >= 0 && v.z >= 0 && v.x < dims.x && v.y < dims.y && v.z < dims.z;
}

bool closes(const Labels& parts, const std::vector<int>& sizes, const Voxel& dims, const Voxel& cells,
            const Voxel& cell) {
  const int own = index_in(cells, cell);
  if (sizes[own] == 0) return true;
  for (int side = 0; side < 6; ++side) {
    const Voxel beside = moved(cell, side);
    if (!is_inside(cells, beside)) continue;
    const int other = index_in(cells, beside);
    if (sizes[other] == 0 || contacts(parts, dims, own, other) > 0) continue;
    if (sizes[own] < sizes[other] || (sizes[own] == sizes[other] && side % 2 == 0)) return true;
  }
  return false;
}

/// Random clutter: single voxels, and plates that part cells.
void clutter(tern::Grid& fine, tern_test::Random& random) {
  const Voxel dims = fine.spec().dims;
  const int plates = random.integer(0, 16);
  for (int k = 0; k < plates; ++k) {
    Voxel lower{random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(0, dims.z - 1)};
    Voxel size{random.integer(4, 12), random.integer(4, 12), random.integer(4, 12)};
    const int thin = random.integer(0, 2);
    (thin == 0 ? size.x : (thin == 1 ? size.y : size.z)) = 1;
    tern_test::for_each_voxel(size, [&](const Voxel& v) {
      fine.mark_voxel({lower.x + v.x, lower.y + v.y, lower.z + v.z});
    });
  }
  const double share = random.real(-0.1, 0.5);
  tern_test::for_each_voxel(dims, [&](const Voxel& v) {
    if (random.chance(share)) fine.mark_voxel(v);
  });
  fine.inflate();
}

TEST(GridMarkGridRandom, IsTheRuleVoxelByVoxel) {
  tern_test::Random random(2026);
  int closed = 0;
  int only_by_neighbours = 0;
  const int worlds = tern_test::scaled(200);
  for (int world = 0; world < worlds; ++world) {
    const Voxel cells{random.integer(1, 5), random.integer(1, 3), random.integer(1, 3)};
    const Voxel dims{4 * cells.x, 4 * cells.y, 4 * cells.z};
    OwnedGrid fine{whole_grid(dims, 0.1, 0.0, {0.4, -0.8, 1.2})};
    OwnedGrid coarse{whole_grid({cells.x + 1, cells.y + 2, cells.z + 3}, 0.4, 0.0, {0.0, -1.6, 0.0})};
    clutter(fine.grid, random);
    ASSERT_EQ(coarse.grid.mark_grid(fine.grid), Status::kOk);
    std::vector<int> sizes;
    const Labels parts = parts_of_cells(fine.grid, cells, sizes);
    tern_test::for_each_voxel(cells, [&](const Voxel& cell) {
      const bool expected = closes(parts, sizes, dims, cells, cell);
      EXPECT_EQ(coarse.grid.obstacle({cell.x + 1, cell.y + 2, cell.z + 3}), expected) << "world " << world;
      closed += expected ? 1 : 0;
      only_by_neighbours += expected && sizes[index_in(cells, cell)] > 0 ? 1 : 0;
    });
  }
  EXPECT_GT(closed, 2 * worlds);
  EXPECT_GE(10 * only_by_neighbours, worlds);
}

TEST(GridMarkGridRandom, EachWayThroughOpenCellsIsOneThroughFreeVoxels) {
  tern_test::Random random(7);
  int joined = 0;
  const int worlds = tern_test::scaled(200);
  for (int world = 0; world < worlds; ++world) {
    const Voxel cells{random.integer(2, 18), random.integer(1, 4), random.integer(1, 3)};
    const Voxel dims{4 * cells.x, 4 * cells.y, 4 * cells.z};
    OwnedGrid fine{whole_grid(dims, 0.25, 0.0)};
    OwnedGrid coarse{whole_grid(cells, 1.0, 0.0)};
    clutter(fine.grid, random);
    ASSERT_EQ(coarse.grid.mark_grid(fine.grid), Status::kOk);
    coarse.grid.inflate();
    Labels regions(index_in(dims, {0, 0, dims.z}));
    int label = 0;
    tern_test::for_each_voxel(dims, [&](const Voxel& v) {
      if (fine.grid.free(v) && regions[index_in(dims, v)] == 0) label_from(fine.grid, v, ++label, false, regions);
    });
    std::vector<int> sizes;
    const Labels parts = parts_of_cells(fine.grid, cells, sizes);
    std::vector<int> region(sizes.size());
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (parts[k] != 0) region[parts[k] - 1] = regions[k];
    }
    tern_test::for_each_voxel(cells, [&](const Voxel& cell) {
      for (int side = 1; side < 6; side += 2) {
        const Voxel beside = moved(cell, side);
        if (!coarse.grid.free(cell) || !coarse.grid.free(beside)) continue;
        EXPECT_EQ(region[index_in(cells, cell)], region[index_in(cells, beside)]) << "world " << world;
        ++joined;
      }
    });
  }
  EXPECT_GT(joined, worlds);
}

}  // namespace
