// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/fine_parts.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/grid_storage.hpp"
#include "support/random.hpp"

namespace {

using tern_test::OwnedGrid;
using tern_test::whole_grid;

/// Plates that part cells and neighbours, all over 520 x 8 x 8 m, and walls where parts end.
void mark_plates(tern::Grid& fine) {
  tern_test::Random random(12);
  for (int k = 0; k < 900; ++k) {
    const double x = random.real(0.0, 520.0);
    const double y = random.real(0.0, 8.0);
    const double z = random.real(0.0, 8.0);
    const double wide = random.real(1.0, 9.0);
    const bool is_along = random.chance(0.4);
    fine.mark_box({{x, y, z}, {x + (is_along ? wide : 0.5), y + wide, z + wide}});
  }
  for (const double x : {252.0, 256.0, 504.0, 508.0, 512.0}) fine.mark_box({{x - 0.5, 0.0, 0.0}, {x, 8.0, 8.0}});
}

TEST(FineParts, PartsTogetherAreTheWhole) {
  OwnedGrid in_parts{whole_grid({130, 2, 2}, 4.0, 0.0)};
  tern_host::mark_from_fine(in_parts.grid, mark_plates);
  OwnedGrid at_once{whole_grid({130, 2, 2}, 4.0, 0.0)};
  OwnedGrid fine{whole_grid({520, 8, 8}, 1.0, 0.0)};
  mark_plates(fine.grid);
  fine.grid.inflate();
  ASSERT_EQ(at_once.grid.mark_grid(fine.grid), tern::Status::kOk);
  const int closed = tern_test::count_obstacles(at_once.grid);
  EXPECT_GT(closed, 100);
  EXPECT_LT(closed, 420);
  tern_test::for_each_voxel({130, 2, 2}, [&](const tern::Voxel& v) {
    EXPECT_EQ(in_parts.grid.obstacle(v), at_once.grid.obstacle(v)) << v.x << ' ' << v.y << ' ' << v.z;
  });
  EXPECT_TRUE(in_parts.grid.inflated());
}

/// A wall that ends at the ceiling, below the upper half of its cells.
TEST(FineParts, WallsUnderALowCeilingStay) {
  tern::GridSpec spec = whole_grid({5, 3, 1}, 4.0, 0.0);
  spec.boundary.upper.z = 2.0;
  OwnedGrid flat{spec};
  tern_host::mark_from_fine(flat.grid, [](tern::Grid& grid) { grid.mark_box({{8.0, 0.0, 0.0}, {9.0, 12.0, 2.0}}); });
  for (int y = 0; y < 3; ++y) {
    EXPECT_TRUE(flat.grid.free({1, y, 0}));
    EXPECT_TRUE(flat.grid.obstacle({2, y, 0}));
  }
}

TEST(FineParts, CellsThatAreTooSmallAreRefused) {
  OwnedGrid coarse{whole_grid({2, 2, 2}, 2.0 * tern::kMinCell, 0.0)};
  EXPECT_THROW(tern_host::mark_from_fine(coarse.grid, mark_plates), std::runtime_error);
}

}  // namespace
