// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/grid_storage.hpp"
#include "support/numbers.hpp"
#include "tern/grid.hpp"

namespace {

using tern::Field;
using tern::Grid;
using tern::GridSpec;
using tern::Status;
using tern::Voxel;
using tern_test::kInfinity;
using tern_test::kNan;
using tern_test::OwnedGrid;
using tern_test::whole_grid;

/// Binds a spec to storage of a fixed size and says what came of it.
struct Outcome {
  Status status;
  Field field;
};

Outcome bind(const GridSpec& spec) {
  std::vector<std::uint64_t> words(4096);
  Grid grid;
  Outcome outcome{Status::kOk, Field::kWorkspace};
  outcome.status = grid.bind(spec, words.data(), words.size(), &outcome.field);
  EXPECT_EQ(grid.bound(), outcome.status == Status::kOk);
  return outcome;
}

void expect_refused(const GridSpec& spec, Status status, Field field) {
  const Outcome outcome = bind(spec);
  EXPECT_EQ(outcome.status, status);
  EXPECT_EQ(outcome.field, field);
}

GridSpec good() {
  return whole_grid({10, 8, 6}, 0.5, 0.3, {-1.0, 2.0, 0.0});
}

TEST(GridWords, CountsBothLayersAndWhatChanged) {
  // Two layers; for each word of a strip of 64 rows a word for what changed; a bit a plane.
  EXPECT_EQ(tern::grid_words({1, 1, 1}), 8u + 2u + 1u + 1u);
  EXPECT_EQ(tern::grid_words({64, 3, 2}), 8u + 12u + 2u + 1u);
  EXPECT_EQ(tern::grid_words({65, 3, 2}), 8u + 24u + 4u + 1u);
  EXPECT_EQ(tern::grid_words({200, 200, 40}), 8u + 2u * 4u * 200u * 40u + 4u * 4u * 40u + 1u);
}

TEST(GridWords, IsZeroForDimensionsThatDoNotFit) {
  EXPECT_EQ(tern::grid_words({0, 1, 1}), 0u);
  EXPECT_EQ(tern::grid_words({1, -1, 1}), 0u);
  EXPECT_EQ(tern::grid_words({1, 1, tern::kMaxDimension + 1}), 0u);
  EXPECT_EQ(tern::grid_words({tern::kMaxDimension, tern::kMaxDimension, tern::kMaxDimension}), 0u);
  EXPECT_EQ(tern::grid_words({std::numeric_limits<std::int32_t>::max(), 2, 2}), 0u);
}

TEST(GridBind, ClearsStorageAndLeavesNothingFreeBeforeInflation) {
  OwnedGrid owned(good());
  ASSERT_EQ(owned.status, Status::kOk);
  EXPECT_EQ(tern_test::count_obstacles(owned.grid), 0);
  EXPECT_EQ(tern_test::count_free(owned.grid), 0);
  EXPECT_FALSE(owned.grid.inflated());
  owned.grid.inflate();
  EXPECT_TRUE(owned.grid.inflated());
  EXPECT_EQ(tern_test::count_free(owned.grid), 10 * 8 * 6);
}

TEST(GridBind, NamesTheFieldThatIsNotFinite) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (double tern::Vec3::*axis : {&tern::Vec3::x, &tern::Vec3::y, &tern::Vec3::z}) {
      GridSpec spec = good();
      spec.origin.*axis = bad;
      expect_refused(spec, Status::kNonFiniteInput, Field::kOrigin);
      spec = good();
      spec.boundary.lower.*axis = bad;
      expect_refused(spec, Status::kNonFiniteInput, Field::kBoundary);
      spec = good();
      spec.boundary.upper.*axis = bad;
      expect_refused(spec, Status::kNonFiniteInput, Field::kBoundary);
    }
    GridSpec spec = good();
    spec.cell = bad;
    expect_refused(spec, Status::kNonFiniteInput, Field::kCell);
    spec = good();
    spec.radius = bad;
    expect_refused(spec, Status::kNonFiniteInput, Field::kRadius);
    spec = good();
    spec.tracking_margin = bad;
    expect_refused(spec, Status::kNonFiniteInput, Field::kTrackingMargin);
  }
}

TEST(GridBind, RefusesDimensionsBeyondCapacity) {
  for (const Voxel dims : {Voxel{0, 8, 6}, Voxel{10, -3, 6}, Voxel{10, 8, tern::kMaxDimension + 1},
                           Voxel{tern::kMaxDimension, tern::kMaxDimension, tern::kMaxDimension}}) {
    GridSpec spec = good();
    spec.dims = dims;
    expect_refused(spec, Status::kInvalidArgument, Field::kDimensions);
  }
}

TEST(GridBind, RefusesNullAndShortStorage) {
  const GridSpec spec = good();
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  Grid grid;
  Field field = Field::kNone;
  EXPECT_EQ(grid.bind(spec, nullptr, words.size(), &field), Status::kInvalidArgument);
  EXPECT_EQ(field, Field::kStorage);
  field = Field::kNone;
  EXPECT_EQ(grid.bind(spec, words.data(), words.size() - 1, &field), Status::kInvalidArgument);
  EXPECT_EQ(field, Field::kStorage);
  EXPECT_EQ(grid.bind(spec, words.data(), words.size()), Status::kOk);
}

TEST(GridBind, RefusesCellsThatAreNone) {
  for (const double cell : {0.0, -0.0, -0.1, 5e-324, 1e-310, 1e-7, 1e7, 1e300}) {
    GridSpec spec = good();
    spec.cell = cell;
    expect_refused(spec, Status::kInvalidArgument, Field::kCell);
  }
}

TEST(GridBind, RefusesRadiiThatAreNone) {
  for (const double radius : {-1e-12, -1.0, 1e6, 1e300}) {
    GridSpec spec = good();
    spec.radius = radius;
    expect_refused(spec, Status::kInvalidArgument, Field::kRadius);
  }
  for (const double radius : {0.0, -0.0, 5e-324, 1e-12, 100.0}) {
    GridSpec spec = good();
    spec.radius = radius;
    EXPECT_EQ(bind(spec).status, Status::kOk) << radius;
  }
}

TEST(GridBind, RefusesTrackingMarginsThatAreNone) {
  GridSpec spec = good();
  spec.tracking_margin = -1e-12;
  expect_refused(spec, Status::kInvalidArgument, Field::kTrackingMargin);
  spec.tracking_margin = 1e6;  // no grid is that wide
  expect_refused(spec, Status::kInvalidArgument, Field::kRadius);
}

TEST(GridBind, RefusesBoundariesInvertedOrOutsideTheGrid) {
  GridSpec spec = good();
  spec.boundary.lower.y = 4.0;
  spec.boundary.upper.y = 3.0;
  expect_refused(spec, Status::kInvalidArgument, Field::kBoundary);
  spec = good();
  spec.boundary.lower.x = -1.001;
  expect_refused(spec, Status::kInvalidArgument, Field::kBoundary);
  spec = good();
  spec.boundary.upper.z = 3.001;
  expect_refused(spec, Status::kInvalidArgument, Field::kBoundary);
  spec = good();
  spec.boundary.lower.x = -1e300;
  spec.boundary.upper.x = 1e300;
  expect_refused(spec, Status::kInvalidArgument, Field::kBoundary);
}

TEST(GridBind, RefusesAnOriginWhereCoordinatesAreCoarserThanCells) {
  GridSpec spec = whole_grid({10, 8, 6}, 0.1, 0.0, {1e9, -1e9, 1e9});
  EXPECT_EQ(bind(spec).status, Status::kOk);
  spec = whole_grid({10, 8, 6}, 0.1, 0.0, {0.0, 0.0, 1e15});
  expect_refused(spec, Status::kInvalidArgument, Field::kOrigin);
}

TEST(GridBind, KeepsARadiusOfANanometreOrLessAsNone) {
  for (const double radius : {-0.0, 0.0, 1e-300, 1e-12, 1e-9}) {
    OwnedGrid owned(whole_grid({10, 8, 6}, 0.1, radius));
    ASSERT_EQ(owned.status, Status::kOk);
    EXPECT_EQ(owned.grid.spec().radius, 0.0);
    EXPECT_FALSE(std::signbit(owned.grid.spec().radius));
  }
  EXPECT_EQ(OwnedGrid(whole_grid({10, 8, 6}, 0.1, 1.1e-9)).grid.spec().radius, 1.1e-9);
  GridSpec spec = good();
  spec.radius = -1e-12;
  expect_refused(spec, Status::kInvalidArgument, Field::kRadius);
}

TEST(GridBind, TakesABoundaryThatMissesTheGridByRounding) {
  // 0.1 * 3 is 0.30000000000000004, a hair above three cells.
  GridSpec spec = whole_grid({3, 3, 3}, 0.1, 0.0);
  spec.boundary.upper = {0.1 * 3, 0.3, 0.1 + 0.1 + 0.1};
  OwnedGrid owned(spec);
  ASSERT_EQ(owned.status, Status::kOk);
  owned.grid.inflate();
  EXPECT_EQ(tern_test::count_free(owned.grid), 27);
  const tern::Box local = owned.grid.local_boundary();
  EXPECT_EQ(local.upper.x, local.upper.y);
  EXPECT_EQ(local.upper.y, local.upper.z);
}

TEST(GridBind, FailsWithoutTouchingAGridThatIsBound) {
  OwnedGrid owned(good());
  ASSERT_EQ(owned.grid.mark_voxel({1, 1, 1}), Status::kOk);
  const std::uint64_t revision = owned.grid.revision();
  GridSpec bad = good();
  bad.cell = -1.0;
  EXPECT_EQ(owned.grid.bind(bad, owned.words.data(), owned.words.size()), Status::kInvalidArgument);
  EXPECT_TRUE(owned.grid.obstacle({1, 1, 1}));
  EXPECT_EQ(owned.grid.revision(), revision);
  EXPECT_EQ(owned.grid.spec().cell, good().cell);
}

TEST(GridBind, RebindingIsAChange) {
  OwnedGrid owned(good());
  owned.grid.inflate();
  const std::uint64_t revision = owned.grid.revision();
  ASSERT_EQ(owned.grid.bind(good(), owned.words.data(), owned.words.size()), Status::kOk);
  EXPECT_GT(owned.grid.revision(), revision);
  EXPECT_FALSE(owned.grid.inflated());
}

TEST(GridFrames, LocalIsWorldMinusOrigin) {
  OwnedGrid owned(good());
  const tern::Vec3 local = owned.grid.to_local({0.25, 3.0, 1.5});
  EXPECT_EQ(local.x, 1.25);
  EXPECT_EQ(local.y, 1.0);
  EXPECT_EQ(local.z, 1.5);
  const tern::Vec3 center = owned.grid.center({2, 0, 5});
  EXPECT_EQ(center.x, 1.25);
  EXPECT_EQ(center.y, 0.25);
  EXPECT_EQ(center.z, 2.75);
}

void expect_voxel(const Voxel& got, const Voxel& wanted) {
  EXPECT_EQ(got.x, wanted.x);
  EXPECT_EQ(got.y, wanted.y);
  EXPECT_EQ(got.z, wanted.z);
}

TEST(GridVoxelOf, FacesBelongToTheVoxelAboveExceptTheBoundarysUpper) {
  OwnedGrid owned(good());
  expect_voxel(owned.grid.voxel_of({0.0, 0.5, 0.49}), {0, 1, 0});
  expect_voxel(owned.grid.voxel_of({-0.0, -0.0, -0.0}), {0, 0, 0});
  expect_voxel(owned.grid.voxel_of({5.0, 4.0, 3.0}), {9, 7, 5});
  expect_voxel(owned.grid.voxel_of({4.99, 3.99, 2.99}), {9, 7, 5});
}

TEST(GridVoxelOf, ABoundaryFaceOnAnInnerPlaneBelongsToTheVoxelBelow) {
  GridSpec spec = good();
  spec.boundary.upper = {3.0, 5.25, 3.0};  // local 4.0 and 3.25: on a plane, and inside voxel 6
  OwnedGrid owned(spec);
  expect_voxel(owned.grid.voxel_of({4.0, 3.25, 0.0}), {7, 6, 0});
  expect_voxel(owned.grid.voxel_of({4.1, 3.3, 0.0}), {8, 6, 0});
}

TEST(GridVoxelOf, TakesAPointThatMissesAFaceByRounding) {
  OwnedGrid owned(whole_grid({10, 10, 10}, 0.1, 0.0));
  // 0.3 / 0.1 is 2.9999999999999996.
  expect_voxel(owned.grid.voxel_of({0.3, 0.7, 0.1 * 6}), {3, 7, 6});
}

TEST(GridVoxelOf, ClampsWhatLiesOutside) {
  OwnedGrid owned(good());
  expect_voxel(owned.grid.voxel_of({-0.01, 1e300, -1e300}), {-1, 8, -1});
  expect_voxel(owned.grid.voxel_of({5.01, kInfinity, kNan}), {10, 8, -1});
}

TEST(GridVoxelOf, RoundTripsCentresFarFromTheWorldsOrigin) {
  for (const double far : {1e6, 1e9}) {
    OwnedGrid owned(whole_grid({20, 20, 20}, 0.1, 0.25, {far, -far, far}));
    ASSERT_EQ(owned.status, Status::kOk);
    for (int k = 0; k < 20; ++k) {
      const tern::Vec3 world{far + (k + 0.5) * 0.1, -far + (k + 0.5) * 0.1, far + (k + 0.5) * 0.1};
      expect_voxel(owned.grid.voxel_of(owned.grid.to_local(world)), {k, k, k});
      expect_voxel(owned.grid.voxel_of(owned.grid.center({k, k, k})), {k, k, k});
    }
  }
}

TEST(Grid, UnboundAnswersEverything) {
  Grid grid;
  EXPECT_FALSE(grid.bound());
  EXPECT_FALSE(grid.inflated());
  EXPECT_FALSE(grid.free({0, 0, 0}));
  EXPECT_FALSE(grid.obstacle({0, 0, 0}));
  grid.inflate();
  EXPECT_FALSE(grid.inflated());
  EXPECT_EQ(grid.mark_voxel({0, 0, 0}), Status::kInvalidArgument);
  EXPECT_EQ(grid.clear_voxel({0, 0, 0}), Status::kInvalidArgument);
  EXPECT_EQ(grid.mark_box({{0, 0, 0}, {1, 1, 1}}), Status::kInvalidArgument);
  EXPECT_EQ(grid.clear_box({{0, 0, 0}, {1, 1, 1}}), Status::kInvalidArgument);
  const tern::Vec3 point{0, 0, 0};
  EXPECT_EQ(grid.mark_points(&point, 1), Status::kInvalidArgument);
  EXPECT_EQ(grid.revision(), 0u);
}

}  // namespace
