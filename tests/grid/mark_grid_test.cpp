// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "support/grid_storage.hpp"
#include "tern/grid.hpp"

namespace {

using tern::Field;
using tern::Status;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

/// Two cells along x, 8 x 4 x 4 voxels of 0.25 m, in a coarse grid of as many cells.
class GridMarkGrid : public testing::Test {
 protected:
  OwnedGrid fine_{whole_grid({8, 4, 4}, 0.25, 0.0)};
  OwnedGrid coarse_{whole_grid({2, 1, 1}, 1.0, 0.0)};

  void mark(int x0, int x1, int y0, int y1, int z0, int z1) {
    for (int z = z0; z < z1; ++z) {
      for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) fine_.grid.mark_voxel({x, y, z});
      }
    }
  }
  void expect_closed(bool first, bool second) {
    fine_.grid.inflate();
    ASSERT_EQ(coarse_.grid.mark_grid(fine_.grid), Status::kOk);
    EXPECT_EQ(coarse_.grid.obstacle({0, 0, 0}), first);
    EXPECT_EQ(coarse_.grid.obstacle({1, 0, 0}), second);
  }
};

TEST_F(GridMarkGrid, NothingClosesNothing) {
  expect_closed(false, false);
}

TEST_F(GridMarkGrid, HalfOfACellIsEnough) {
  mark(0, 4, 0, 2, 0, 4);
  expect_closed(false, false);
}

TEST_F(GridMarkGrid, OneVoxelLessThanHalfIsNot) {
  mark(0, 4, 0, 2, 0, 4);
  mark(1, 2, 2, 3, 0, 1);
  expect_closed(true, false);
}

TEST_F(GridMarkGrid, PartsThatAWallPartsDoNotAddUp) {
  mark(0, 4, 2, 3, 0, 4);  // 32 voxels are free on one side, and 16 on the other
  expect_closed(false, false);
  mark(0, 4, 1, 2, 0, 4);  // 16 and 16
  expect_closed(true, false);
}

TEST_F(GridMarkGrid, PartsThatMeetAtAnEdgeAreTwo) {
  mark(0, 2, 0, 2, 0, 4);
  mark(2, 4, 2, 4, 0, 4);
  expect_closed(true, false);
}

TEST_F(GridMarkGrid, AWallBetweenTwoCellsClosesTheSmaller) {
  mark(3, 4, 0, 4, 0, 4);
  mark(7, 8, 0, 1, 0, 1);  // 48 voxels are free in the first, 63 in the second
  expect_closed(true, false);
}

TEST_F(GridMarkGrid, OfEqualOnesTheFurtherIsClosed) {
  mark(3, 4, 0, 4, 0, 4);
  mark(5, 6, 0, 4, 0, 4);
  mark(4, 5, 0, 4, 0, 4);  // the wall is two voxels thick on this side,
  mark(0, 1, 0, 4, 0, 4);  // and there are 32 free voxels on either
  expect_closed(false, true);
}

TEST_F(GridMarkGrid, APassageOfOneVoxelJoins) {
  mark(3, 4, 0, 4, 0, 4);
  fine_.grid.clear_voxel({3, 2, 1});
  expect_closed(false, false);
}

TEST_F(GridMarkGrid, MarksStay) {
  coarse_.grid.mark_voxel({1, 0, 0});
  expect_closed(false, true);
}

TEST_F(GridMarkGrid, TheRadiusCounts) {
  // A passage two voxels wide, of which a body of half a voxel leaves nothing.
  OwnedGrid wide{whole_grid({8, 4, 4}, 0.25, 0.125)};
  for (int x = 0; x < 4; ++x) {
    for (int z = 0; z < 4; ++z) {
      wide.grid.mark_voxel({x, 0, z});
      wide.grid.mark_voxel({x, 3, z});
    }
  }
  wide.grid.inflate();
  ASSERT_EQ(coarse_.grid.mark_grid(wide.grid), Status::kOk);
  EXPECT_TRUE(coarse_.grid.obstacle({0, 0, 0}));
}

TEST_F(GridMarkGrid, RefusesWhatDoesNotFit) {
  const auto field_of = [](const tern::GridSpec& fine, tern::Grid coarse) {
    OwnedGrid grid{fine};
    grid.grid.inflate();
    Field field = Field::kNone;
    EXPECT_EQ(coarse.mark_grid(grid.grid, &field), Status::kInvalidArgument);
    return field;
  };
  EXPECT_EQ(field_of(whole_grid({8, 4, 4}, 0.2, 0.0), coarse_.grid), Field::kCell);
  EXPECT_EQ(field_of(whole_grid({8, 4, 4}, 0.25, 0.0, {0.25, 0.0, 0.0}), coarse_.grid), Field::kOrigin);
  EXPECT_EQ(field_of(whole_grid({8, 4, 4}, 0.25, 0.0, {0.0, 0.0, 1e-6}), coarse_.grid), Field::kOrigin);
  EXPECT_EQ(field_of(whole_grid({8, 4, 4}, 0.25, 0.0), tern::Grid{}), Field::kStorage);
  Field field = Field::kNone;
  EXPECT_EQ(coarse_.grid.mark_grid(fine_.grid, &field), Status::kInvalidArgument);
  EXPECT_EQ(field, Field::kNotInflated);
  EXPECT_EQ(coarse_.grid.mark_grid(tern::Grid{}, &field), Status::kInvalidArgument);
  EXPECT_EQ(field, Field::kStorage);
  EXPECT_EQ(tern_test::count_obstacles(coarse_.grid), 0);
}

TEST_F(GridMarkGrid, PartsOutsideAreIgnored) {
  // The fine grid has the cells -1 to 2 along x, of which the coarse one has 0 and 1; its last voxel is in none.
  OwnedGrid fine{whole_grid({17, 4, 4}, 0.25, 0.0, {-1.0, 0.0, 0.0})};
  fine.grid.mark_box({{-1.0, 0.0, 0.0}, {1.0, 1.0, 1.0}});
  fine.grid.inflate();
  ASSERT_EQ(coarse_.grid.mark_grid(fine.grid), Status::kOk);
  EXPECT_TRUE(coarse_.grid.obstacle({0, 0, 0}));
  EXPECT_FALSE(coarse_.grid.obstacle({1, 0, 0}));
  OwnedGrid far{whole_grid({8, 4, 4}, 0.25, 0.0, {1e7, 0.0, 0.0})};
  far.grid.mark_box({{1e7, 0.0, 0.0}, {2e7, 1.0, 1.0}});
  far.grid.inflate();
  EXPECT_EQ(coarse_.grid.mark_grid(far.grid), Status::kOk);
  EXPECT_FALSE(coarse_.grid.obstacle({1, 0, 0}));
}

}  // namespace
