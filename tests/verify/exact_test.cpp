// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/exact.hpp"

#include <gtest/gtest.h>

#include "verify/bezier.hpp"

namespace tern_verify {
namespace {

TEST(Exact, DoublesAreTheRationalsThatTheyAre) {
  EXPECT_NE(Rational(0.1), Rational(1) / 10);
  EXPECT_EQ(Rational(0.1), Rational(Integer(3602879701896397)) / Rational(Integer(1) << 55));
  EXPECT_EQ(decimal(3, 8) * 100000000, 3);
}

TEST(Exact, RootsLieOnTheirSides) {
  for (const int square : {0, 1, 2, 3, 4, 1000000007}) {
    const Rational below = root_below(square);
    const Rational above = root_above(square);
    EXPECT_LE(below * below, square);
    EXPECT_GE(above * above, square);
    EXPECT_LT(above - below, decimal(1, 35));
  }
  EXPECT_EQ(root_above(Rational(9) / 4), Rational(3) / 2);
  EXPECT_GT(root_above(2), root_below(2));
}

TEST(Exact, FloorsAndCeilingsOfNegativeNumbers) {
  EXPECT_EQ(floor_of(Rational(-7) / 2), -4);
  EXPECT_EQ(ceil_of(Rational(-7) / 2), -3);
  EXPECT_EQ(floor_of(Rational(-4)), -4);
  EXPECT_EQ(ceil_of(Rational(7) / 2), 4);
}

TEST(Exact, PrintedNumbersAreRoundedOutward) {
  const Rational third = Rational(1) / 3;
  EXPECT_EQ(text_below(third), "0.333333333333");
  EXPECT_EQ(text_above(third), "0.333333333334");
  EXPECT_EQ(text_below(-third), "-0.333333333334");
  EXPECT_EQ(text_above(-third), "-0.333333333333");
  EXPECT_EQ(text_above(Rational(1) - decimal(1, 15)), "1");
  EXPECT_EQ(text_below(Rational(1) - decimal(1, 15)), "0.999999999999");
  EXPECT_EQ(text_below(decimal(15, 10)), "1.5e-9");
  EXPECT_EQ(text_below(Rational(12345)), "12345");
  EXPECT_EQ(text_below(Rational(0)), "0");
}

TEST(Bezier, HalvesAreTheCurveAndTheHodographItsDerivative) {
  const Polygon<1> cube = {{0}, {0}, {0}, {1}};  // u^3
  const Halves<1> halves = halves_of(cube);
  EXPECT_EQ(halves.left.back()[0], Rational(1) / 8);
  EXPECT_EQ(halves.right.front()[0], Rational(1) / 8);
  const Rational u = Rational(2) / 7;
  EXPECT_EQ(point_at(halves.left, u)[0], point_at(cube, u / 2)[0]);
  EXPECT_EQ(point_at(halves.right, u)[0], point_at(cube, Rational(1) / 2 + u / 2)[0]);
  EXPECT_EQ(point_at(hodograph(cube, 5), u)[0], 3 * u * u / 5);
}

}  // namespace
}  // namespace tern_verify
