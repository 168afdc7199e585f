// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inflation of worlds whose planes repeat, against a ball around every obstacle voxel: boxes, slabs and scattered
// voxels in one grid, at once and by changes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/grid_storage.hpp"
#include "support/random.hpp"
#include "tern/grid.hpp"

namespace {

using tern::Grid;
using tern::GridSpec;
using tern::Voxel;
using tern_test::OwnedGrid;
using tern_test::Random;
using tern_test::scaled;

/// Squared gaps in cells below this block. Radii here are (n + 0.5) / 10 of a cell, so that no gap is a tie.
double blocking_gap(const GridSpec& spec) {
  return spec.radius * spec.radius / (spec.cell * spec.cell);
}

int gap(int d) {
  return d == 0 ? 0 : std::abs(d) - 1;
}

/// The voxels around an obstacle that it blocks.
std::vector<Voxel> ball(const GridSpec& spec) {
  const int most = static_cast<int>(spec.radius / spec.cell) + 1;
  std::vector<Voxel> offsets;
  for (int z = -most; z <= most; ++z) {
    for (int y = -most; y <= most; ++y) {
      for (int x = -most; x <= most; ++x) {
        const int square = gap(x) * gap(x) + gap(y) * gap(y) + gap(z) * gap(z);
        if (square < blocking_gap(spec)) offsets.push_back({x, y, z});
      }
    }
  }
  return offsets;
}

/// Free voxels by the obstacles alone; the boundary is the grid.
std::vector<bool> reference_free(const Grid& grid) {
  const Voxel dims = grid.spec().dims;
  const std::vector<Voxel> offsets = ball(grid.spec());
  std::vector<bool> free(static_cast<std::size_t>(dims.x) * dims.y * dims.z, true);
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x) {
        if (!grid.obstacle({x, y, z})) continue;
        for (const Voxel& d : offsets) {
          const Voxel v{x + d.x, y + d.y, z + d.z};
          if (grid.inside(v)) free[(static_cast<std::size_t>(v.z) * dims.y + v.y) * dims.x + v.x] = false;
        }
      }
    }
  }
  return free;
}

void expect_reference(const Grid& grid) {
  const Voxel dims = grid.spec().dims;
  const std::vector<bool> expected = reference_free(grid);
  std::size_t wrong = 0;
  std::size_t i = 0;
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      for (int x = 0; x < dims.x; ++x, ++i) wrong += grid.free({x, y, z}) != expected[i] ? 1 : 0;
    }
  }
  ASSERT_EQ(wrong, 0u) << dims.x << 'x' << dims.y << 'x' << dims.z << " radius " << grid.spec().radius;
}

/// A box of voxels, often from the floor or to the ceiling, sometimes a slab through the whole grid.
tern::Box random_box(Random& random, const GridSpec& spec) {
  const auto range = [&](int count, int most, double& lower, double& upper) {
    const int size = random.integer(1, std::min(most, count));
    const int begin = random.integer(0, count - size);
    lower = (begin + 0.25) * spec.cell;
    upper = (begin + size - 0.25) * spec.cell;
  };
  tern::Box box;
  const int wide = random.chance(0.1) ? 1000 : 25;
  range(spec.dims.x, wide, box.lower.x, box.upper.x);
  range(spec.dims.y, wide, box.lower.y, box.upper.y);
  range(spec.dims.z, wide == 25 ? spec.dims.z : 2, box.lower.z, box.upper.z);
  if (random.chance(0.4)) box.lower.z = 0.25 * spec.cell;
  if (random.chance(0.3)) box.upper.z = (spec.dims.z - 0.25) * spec.cell;
  return box;
}

/// Single voxels in some consecutive planes: there no plane equals the one below.
void scatter(Random& random, Grid& grid, int count) {
  const Voxel dims = grid.spec().dims;
  const int planes = random.integer(1, dims.z);
  const int first = random.integer(0, dims.z - planes);
  for (int k = 0; k < count; ++k) {
    grid.mark_voxel(
        {random.integer(0, dims.x - 1), random.integer(0, dims.y - 1), random.integer(first, first + planes - 1)});
  }
}

void change(Random& random, Grid& grid) {
  if (random.chance(0.2)) return scatter(random, grid, random.integer(1, 300));
  for (int k = random.integer(1, 6); k > 0; --k) {
    const tern::Box box = random_box(random, grid.spec());
    if (random.chance(0.7)) {
      grid.mark_box(box);
    } else {
      grid.clear_box(box);
    }
  }
}

void expect_rounds(Random& random, const Voxel& dims, double radius, int rounds) {
  OwnedGrid owned(tern_test::whole_grid(dims, 0.1, radius));
  ASSERT_EQ(owned.status, tern::Status::kOk);
  for (int round = 0; round < rounds; ++round) {
    change(random, owned.grid);
    owned.grid.inflate();
    ASSERT_NO_FATAL_FAILURE(expect_reference(owned.grid)) << "round " << round;
  }
}

double random_radius(Random& random, int most_tenths) {
  return 0.01 * (random.integer(0, most_tenths) + 0.5);
}

TEST(InflationPlanes, EqualsBallsInBoxWorlds) {
  Random random(301);
  constexpr Voxel kShapes[] = {{30, 70, 20}, {64, 64, 30}, {130, 140, 25}, {200, 30, 40}, {70, 66, 15}};
  for (int k = 0; k < scaled(40); ++k) {
    ASSERT_NO_FATAL_FAILURE(expect_rounds(random, kShapes[k % 5], random_radius(random, 45), 3));
  }
}

TEST(InflationPlanes, EqualsBallsInRowsWiderThanAWindow) {
  Random random(302);
  for (int k = 0; k < scaled(20); ++k) {
    const Voxel dims{random.integer(500, 1100), random.integer(5, 20), random.integer(4, 20)};
    ASSERT_NO_FATAL_FAILURE(expect_rounds(random, dims, random_radius(random, 30), 3));
  }
}

TEST(InflationPlanes, EqualsBallsWithReachesUpToAndBeyondTheKeptPlanes) {
  Random random(303);
  for (int k = 0; k < scaled(8); ++k) {
    ASSERT_NO_FATAL_FAILURE(expect_rounds(random, {70, 40, 40}, random_radius(random, 90), 2));
  }
}

TEST(InflationPlanes, EqualsBallsAboveManyPlanesOfScatteredVoxels) {
  Random random(304);
  for (int k = 0; k < scaled(8); ++k) {
    OwnedGrid owned(tern_test::whole_grid({70, 40, 110}, 0.1, random_radius(random, 30)));
    for (int z = 10; z < 40; ++z) {
      for (int n = 0; n < 60; ++n) owned.grid.mark_voxel({random.integer(0, 69), random.integer(0, 39), z});
    }
    for (int n = 0; n < 8; ++n) owned.grid.mark_box(random_box(random, owned.grid.spec()));
    owned.grid.inflate();
    ASSERT_NO_FATAL_FAILURE(expect_reference(owned.grid));
  }
}

}  // namespace
