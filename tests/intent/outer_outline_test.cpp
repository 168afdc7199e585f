// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/intent/outer_outline.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.hpp"

namespace {

using tern_host::PlanPolygon;
using tern_test::Random;

/// A polygon with corners on a circle of 10 m.
PlanPolygon on_circle(Random& random, int corners) {
  PlanPolygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 6.283185307179586 * (i + random.real(0.0, 0.9)) / corners;
    polygon.push_back({10.0 * std::cos(angle), 10.0 * std::sin(angle)});
  }
  return polygon;
}

double left_of(const PlanPolygon& polygon, double x, double y) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double dx = b.x - a.x, dy = b.y - a.y;
    least = std::min(least, (dx * (y - a.y) - dy * (x - a.x)) / std::hypot(dx, dy));
  }
  return least;
}

TEST(OuterOutline, HoldsTheOriginal) {
  Random random(106);
  const int cases = tern_test::scaled(300);
  for (int c = 0; c < cases; ++c) {
    const PlanPolygon polygon = on_circle(random, random.integer(4, 60));
    const double most = random.real(0.01, 2.0);
    const PlanPolygon outer = tern_host::outer_outline(polygon, 3, most);
    for (const auto& v : polygon) EXPECT_GE(left_of(outer, v.x, v.y), -1e-6);
    for (const auto& v : outer) EXPECT_LE(tern_host::gap_between({v}, polygon), most + 1e-9);
    EXPECT_LE(outer.size(), polygon.size());
  }
}

TEST(OuterOutline, LeavesOutTheShortestSides) {
  // A square of 10 m with a corner cut off by 1 m: that side goes first, at 1 m / sqrt(2) from it.
  const PlanPolygon cut{{0, 0}, {10, 0}, {10, 9}, {9, 10}, {0, 10}};
  EXPECT_EQ(tern_host::outer_outline(cut, 3, 0.7).size(), 5u);
  const PlanPolygon whole = tern_host::outer_outline(cut, 4, 0.71);
  ASSERT_EQ(whole.size(), 4u);
  EXPECT_NEAR(whole[2].x, 10.0, 1e-12);
  EXPECT_NEAR(whole[2].y, 10.0, 1e-12);
  EXPECT_EQ(tern_host::outer_outline(whole, 3, 100.0).size(), 4u) << "parallel sides do not meet";
}

}  // namespace
