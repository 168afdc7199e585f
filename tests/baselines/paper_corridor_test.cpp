// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "baselines/paper_corridor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random.hpp"

namespace {

using tern::Vec3;
using tern_bench::PaperPolyhedron;

constexpr double kNoBox = std::numeric_limits<double>::infinity();

double room(const tern::Halfspace& plane, const Vec3& p) {
  return plane.offset - (plane.normal.x * p.x + plane.normal.y * p.y + plane.normal.z * p.z);
}

TEST(PaperCorridor, OnePointGivesTheTangentThere) {
  // A segment along x from -1 to 1; a point half a metre above its middle: b = 0.5, and the plane y <= 0.5.
  const PaperPolyhedron p = tern_bench::grow_paper_polyhedron({-1, 0, 0}, {1, 0, 0}, {{0, 0.5, 0}}, kNoBox);
  ASSERT_EQ(p.planes.size(), 1u);
  EXPECT_NEAR(p.semi_axes[0], 1.0, 1e-12);
  EXPECT_NEAR(p.semi_axes[1], 0.5, 1e-12);
  // Across y the ellipsoid is free: the third axis stretches back to the first's length.
  EXPECT_NEAR(p.semi_axes[2], 1.0, 1e-12);
  EXPECT_NEAR(p.planes[0].normal.y, 1.0, 1e-12);
  EXPECT_NEAR(p.planes[0].offset, 0.5, 1e-12);
  EXPECT_EQ(p.shrinks, 1);
}

TEST(PaperCorridor, TheBoxSavesChecksAndCutsOffPointsInIt) {
  tern_test::Random random(11);
  std::vector<Vec3> points;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p{random.real(-10, 10), random.real(-10, 10), random.real(-10, 10)};
    if (std::fabs(p.y) > 0.3 || std::fabs(p.z) > 0.3) points.push_back(p);
  }
  const PaperPolyhedron all = tern_bench::grow_paper_polyhedron({-1, 0, 0}, {1, 0, 0}, points, kNoBox);
  const PaperPolyhedron boxed = tern_bench::grow_paper_polyhedron({-1, 0, 0}, {1, 0, 0}, points, 2.0);
  EXPECT_LT(boxed.checks, all.checks);
  for (const Vec3& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for (const tern::Halfspace& plane : all.planes) least = std::min(least, room(plane, p));
    EXPECT_LE(least, 1e-6);
  }
  for (const tern::Halfspace& plane : all.planes) {
    EXPECT_GT(room(plane, {-1, 0, 0}), -1e-9);
    EXPECT_GT(room(plane, {1, 0, 0}), -1e-9);
  }
}

TEST(PaperCorridor, APointForASegmentGivesNothing) {
  EXPECT_TRUE(tern_bench::grow_paper_polyhedron({1, 1, 1}, {1, 1, 1}, {{2, 2, 2}}, kNoBox).planes.empty());
}

}  // namespace
