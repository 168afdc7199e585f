// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The grants by hand, on a map of 100 m and on one 10 000 km from the world's origin.
#include "prove/grants.hpp"

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

TEST(Grants, OfAMapOf100Metres) {
  const Map map(1.0, {0, 0, 0});  // 100 + 50 + 10 m
  EXPECT_DOUBLE_EQ(check_distance(map.grid), 1e-9);
  Trajectory plan{};
  EXPECT_DOUBLE_EQ(place_rounding(map.grid, plan), 1600 * kBit);
  EXPECT_DOUBLE_EQ(face_grant(map.grid, 0.0), 3e-9 + 1600 * kBit);
  Grant grant = grant_to_plan(map.grid, plan);
  EXPECT_DOUBLE_EQ(grant.near, 4e-9 + (2 * 1600 + 512 * 160) * kBit);
  EXPECT_DOUBLE_EQ(grant.outside, 1e-9 + (2 * 1600 + 512 * 160) * kBit);
  EXPECT_DOUBLE_EQ(grant.boundary.upper.x, 100.0 + 3e-9 + (4 * 100 + 1600) * kBit);
  EXPECT_DOUBLE_EQ(grant.boundary.lower.x, -3e-9 - 1600 * kBit);
  EXPECT_DOUBLE_EQ(grant.excess, 3e-8);
  EXPECT_FALSE(grant.is_cut);
  plan.origin = {40, -8, 2};
  EXPECT_DOUBLE_EQ(place_rounding(map.grid, plan), (1600 + 2 * 50) * kBit);
  grant = grant_to_curve(map.grid, plan);
  EXPECT_DOUBLE_EQ(grant.near, 4e-9 + 32 * 210 * kBit);
  EXPECT_DOUBLE_EQ(grant.outside, grant.near);
  EXPECT_DOUBLE_EQ(grant.boundary.upper.y, 50.0 + grant.near);
  EXPECT_DOUBLE_EQ(grant.excess, 4e-8);
  EXPECT_TRUE(grant.is_cut);
}

TEST(Grants, TenThousandKilometresAway) {
  const Map map(1.0, {-1e7, 2e6, 0});  // 1.2e7 m from the origin, 2 units of each
  EXPECT_DOUBLE_EQ(check_distance(map.grid), 1e-9);
  Trajectory plan{};
  plan.origin = {-1e7, 2e6, 5};
  EXPECT_DOUBLE_EQ(place_rounding(map.grid, plan), (1600 + 2.4e7 + 2 * 24000005.0) * kBit);
  EXPECT_LT(place_rounding(map.grid, plan), 2e-8);
  EXPECT_LT(grant_to_plan(map.grid, plan).near, 3e-8);
}

TEST(Grants, GrowWithVoxelsOfMoreThanAMetre) {
  const Trajectory plan{};
  EXPECT_DOUBLE_EQ(check_distance(Map(10.0, {0, 0, 0}).grid), 1e-8);
  EXPECT_NEAR(grant_to_plan(Map(10.0, {0, 0, 0}).grid, plan).near, 4e-8, 1e-9);
  EXPECT_DOUBLE_EQ(check_distance(Map(0.1, {0, 0, 0}).grid), 1e-9) << "and not below a nanometre";
  EXPECT_NEAR(grant_to_plan(Map(0.1, {0, 0, 0}).grid, plan).near, 2.2e-9, 1e-11);
}

TEST(Grants, OfDerivatives) {
  Segment segment{};
  segment.duration = 0.5;
  for (Vec3& point : segment.points) point = {6.0, -7.0, 1.0};
  segment.points[3] = {5.0, -8.0, 2.0};
  // 2 * 7 / 0.5, 2 * 6 / 0.5, 2 * 5 / 0.5
  const double factor[4] = {1.0, 28.0, 28.0 * 24.0, 28.0 * 24.0 * 20.0};
  for (int k = 0; k < 4; ++k) {
    EXPECT_DOUBLE_EQ(derivative_rounding(segment, k), 40 * kBit * 15.0 * factor[k]) << "the largest point, 15 m";
    EXPECT_DOUBLE_EQ(hodograph_rounding(segment, k), 8 * kBit * 1.0 * factor[k]) << "the extent, 1 m";
  }
}

/// Rounding of the control points is what the tolerance covers: a unit in the last place of each, in the worst signs.
TEST(Grants, CoversAUnitInEveryControlPoint) {
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
