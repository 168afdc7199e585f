// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The tolerances by hand: what a map of 100 m and one 10 000 km from the world's origin are forgiven.
#include "check/tolerance.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

using namespace tern;

constexpr double kBit = 2.220446049250313e-16;  // 2^-52

struct Map {
  Map(double cell, const Vec3& origin) : words(grid_words({100, 50, 10})) {
    GridSpec spec{};
    spec.origin = origin;
    spec.cell = cell;
    spec.dims = {100, 50, 10};
    spec.boundary = {origin, {origin.x + 100 * cell, origin.y + 50 * cell, origin.z + 10 * cell}};
    EXPECT_EQ(grid.bind(spec, words.data(), words.size()), Status::kOk);
  }
  std::vector<std::uint64_t> words;
  Grid grid;
};

TEST(CheckTolerance, OfAMapOf100Metres) {
  const Map map(1.0, {0, 0, 0});  // 100 + 50 + 10 m
  EXPECT_DOUBLE_EQ(check_distance(map.grid), 1e-9);
  EXPECT_DOUBLE_EQ(grid_rounding(map.grid), 1600 * kBit);
  EXPECT_NEAR(grid_rounding(map.grid), 3.6e-13, 1e-14);
  EXPECT_DOUBLE_EQ(fence_tolerance(map.grid), 1e-9 + (1600 + 512 * 160) * kBit);
  EXPECT_DOUBLE_EQ(lattice_rounding(map.grid), 2e-9);
  Trajectory plan{};
  EXPECT_DOUBLE_EQ(place_rounding(map.grid, plan), 1600 * kBit);
  plan.origin = {40, -8, 2};
  EXPECT_DOUBLE_EQ(place_rounding(map.grid, plan), (1600 + 2 * 50) * kBit);
}

TEST(CheckTolerance, TenThousandKilometresAway) {
  const Map map(1.0, {-1e7, 2e6, 0});  // 1.2e7 m from the origin, 2 units of each
  EXPECT_DOUBLE_EQ(check_distance(map.grid), 1e-9);
  EXPECT_DOUBLE_EQ(grid_rounding(map.grid), (1600 + 2.4e7) * kBit);
  EXPECT_NEAR(grid_rounding(map.grid), 5.3e-9, 1e-10);
  EXPECT_DOUBLE_EQ(fence_tolerance(map.grid), 1e-9 + (1600 + 2.4e7 + 512 * 160) * kBit);
  Trajectory plan{};
  plan.origin = {-1e7, 2e6, 5};
  EXPECT_DOUBLE_EQ(place_rounding(map.grid, plan), (1600 + 2.4e7 + 2 * 24000005.0) * kBit);
  EXPECT_LT(place_rounding(map.grid, plan), 2e-8);
}

TEST(CheckTolerance, GrowsWithVoxelsOfMoreThanAMetre) {
  EXPECT_DOUBLE_EQ(check_distance(Map(10.0, {0, 0, 0}).grid), 1e-8);
  EXPECT_DOUBLE_EQ(lattice_rounding(Map(10.0, {0, 0, 0}).grid), 2e-8);
  EXPECT_DOUBLE_EQ(check_distance(Map(0.1, {0, 0, 0}).grid), 1e-9) << "and not below a nanometre";
  EXPECT_DOUBLE_EQ(lattice_rounding(Map(0.1, {0, 0, 0}).grid), 2e-10);
  EXPECT_DOUBLE_EQ(grid_rounding(Map(0.25, {0, 0, 0}).grid), 400 * kBit);
}

TEST(CheckTolerance, OfDerivatives) {
  Segment segment{};
  segment.duration = 0.5;
  for (Vec3& point : segment.points) point = {6.0, -7.0, 1.0};
  segment.points[3] = {5.0, -8.0, 2.0};
  // 2 * 7 / 0.5, 2 * 6 / 0.5, 2 * 5 / 0.5
  const double factor[4] = {1.0, 28.0, 28.0 * 24.0, 28.0 * 24.0 * 20.0};
  for (int k = 0; k < 4; ++k) {
    EXPECT_DOUBLE_EQ(derivative_rounding(segment, k), 32 * kBit * 8.0 * factor[k]) << "the largest coordinate, 8 m";
    EXPECT_DOUBLE_EQ(hodograph_rounding(segment, k), 8 * kBit * 1.0 * factor[k]) << "the extent, 1 m";
  }
}

/// Rounding of the control points is what the tolerance covers: a unit in the last place of each, in the worst signs.
TEST(CheckTolerance, CoversAUnitInEveryControlPoint) {
  const double duration = 0.05;
  for (int k = 1; k < 4; ++k) {
    double sum = 0.0;  // of the k-th difference's coefficients
    double binomial = 1.0;
    for (int j = 0; j <= k; ++j) {
      sum += binomial;
      binomial = binomial * (k - j) / (j + 1);
    }
    double power = 1.0;
    for (int j = 0; j < k; ++j) power *= (7 - j) / duration;
    Segment segment{};
    segment.duration = duration;
    for (Vec3& point : segment.points) point = {100.0, 0.0, 0.0};
    EXPECT_GE(derivative_rounding(segment, k), sum * power * 100.0 * kBit) << k;
    EXPECT_LE(derivative_rounding(segment, k), 64 * sum * power * 100.0 * kBit) << k;
  }
}

}  // namespace
