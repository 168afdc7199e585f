// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/nearest.hpp"

#include <gtest/gtest.h>

namespace tern_verify {
namespace {

const Rational kClose = decimal(2, 12);

Polygon<3> line(const Point& from, const Point& to) {
  const Rational third = Rational(1) / 3;
  return {from, from + third * (to - from), to - third * (to - from), to};
}

void expect_distance_squared(const Nearest& nearest, const Rational& square) {
  EXPECT_LE(nearest.least * nearest.least, square);
  EXPECT_GE(nearest.most * nearest.most, square);
  EXPECT_LT(nearest.most - nearest.least, kClose);
}

TEST(Nearest, LinePastACornerOfABox) {
  // From (3, 0, 1) to (0, 3, 1), past the corner (1, 1, 1): 1 / sqrt 2 away, in the middle.
  const Nearest nearest = nearest_of({line({3, 0, 1}, {0, 3, 1})}, {{{{0, 0, 0}, {1, 1, 1}}, 0}});
  expect_distance_squared(nearest, Rational(1) / 2);
  EXPECT_LT(abs(nearest.u - Rational(1) / 2), decimal(1, 5));
}

TEST(Nearest, TheNearestOfManyAndTheCurveThatReachesIt) {
  const std::vector<Polygon<3>> curves = {line({0, 0, 0}, {4, 0, 0}), line({4, 0, 0}, {9, 1, 0})};
  std::vector<Solid> solids;
  for (int i = 0; i < 9; ++i) solids.push_back({{{i, 5, 0}, {i + 1, 6 - i % 2, 1}}, 0});
  solids.push_back({{{Rational(17) / 2, Rational(3) / 2, 0}, {9, 2, 0}}, 0});
  const Nearest nearest = nearest_of(curves, solids);
  EXPECT_EQ(nearest.solid, 9u);
  EXPECT_EQ(nearest.curve, 1u);
  // At its end, (9, 1), the line is half a metre below the box.
  expect_distance_squared(nearest, Rational(1) / 4);
}

TEST(Nearest, CylindersAreRound) {
  const Solid cylinder{{{0, 0, 0}, {0, 0, 2}}, 1};
  // Off the axis by sqrt 2 at the nearest.
  const Nearest beside = nearest_of({line({2, 0, 1}, {0, 2, 1})}, {cylinder});
  EXPECT_LE((beside.least + 1) * (beside.least + 1), 2);
  EXPECT_GE((beside.most + 1) * (beside.most + 1), 2);
  EXPECT_LT(beside.most - beside.least, kClose);
  expect_distance_squared(nearest_of({line({-3, 0, 5}, {3, 0, 5})}, {cylinder}), 9);
  // Over the rim: a metre beside it and two above.
  expect_distance_squared(nearest_of({line({2, -3, 4}, {2, 3, 4})}, {cylinder}), 5);
}

/// From (-1, 0) to (3, 1): deepest where it is as far from the near face as from the far one.
TEST(Nearest, ACurveThatEntersIsAsFarInsideAsTheWayOut) {
  const Nearest nearest = nearest_of({line({-1, 0, 0}, {3, 1, 0})}, {{{{0, -1, -1}, {1, 1, 1}}, 0}});
  EXPECT_LE(nearest.least, -Rational(1) / 2);
  EXPECT_GE(nearest.most, -Rational(1) / 2);
  EXPECT_LT(nearest.most - nearest.least, kClose);
  EXPECT_LT(abs(nearest.u - Rational(3) / 8), decimal(1, 9));
  const Solid cylinder{{{0, 0, 0}, {0, 0, 9}}, 1};
  const Nearest round = nearest_of({line({-3, Rational(1) / 4, 4}, {3, Rational(1) / 4, 4})}, {cylinder});
  EXPECT_LE(round.least, -Rational(3) / 4);
  EXPECT_GE(round.most, -Rational(3) / 4);
}

TEST(Nearest, ADipThatNoSampleMeets) {
  // Nearest to the box at u = 3/7, between samples.
  Polygon<3> curve;
  for (int i = 0; i < 8; ++i) curve.push_back({i, i == 3 ? Rational(1) : Rational(2), 0});
  const Solid box{{{-9, -9, -9}, {9, 0, 9}}, 0};
  // C(7, 3) u^3 (1 - u)^4 is largest at 3/7: 35 * 27 * 256 / 7^7.
  const Rational least = 2 - Rational(35 * 27 * 256) / (7 * 7 * 7 * 7 * 7 * 7 * 7);
  const Nearest nearest = nearest_of({curve}, {box});
  EXPECT_LE(nearest.least, least);
  EXPECT_GE(nearest.most, least);
  EXPECT_LT(nearest.most - nearest.least, kClose);
}

TEST(Nearest, OfPointsAlone) {
  const std::vector<Solid> solids = {{{{0, 0, 0}, {1, 1, 1}}, 0}, {{{5, 0, 0}, {5, 0, 9}}, 1}};
  const Nearest nearest = nearest_point({{2, 2, 2}, {3, 0, 4}, {2, 2, 5}}, solids);
  EXPECT_EQ(nearest.curve, 1u);
  EXPECT_EQ(nearest.solid, 1u);
  EXPECT_EQ(nearest.most, 1);
  EXPECT_LT(1 - nearest.least, decimal(1, 30));
  EXPECT_EQ(nearest_point({{5, 0, 4}}, solids).most, -1) << "inside";
}

}  // namespace
}  // namespace tern_verify
