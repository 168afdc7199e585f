// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Intervals hold what exact arithmetic on their members gives.
#include "verify/interval.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/random.hpp"

namespace tern_verify {
namespace {

/// Of any size: ordinary, tiny, below the normal numbers, or 0.
double any_double(tern_test::Random& random) {
  if (random.chance(0.1)) return 0.0;
  const int exponent = random.chance(0.6) ? random.integer(-4, 4) : random.integer(-540, 200);
  return std::ldexp(random.real(-1.0, 1.0), exponent);
}

/// A number that is no double, most of the time.
Rational any_number(tern_test::Random& random) {
  const Rational number(any_double(random));
  return random.chance(0.3) ? number : Rational(number / 3);
}

void expect_holds(const Interval& interval, const Rational& exact) {
  ASSERT_LE(interval.low(), interval.high());
  if (std::isfinite(interval.low())) {
    EXPECT_LE(Rational(interval.low()), exact);
  }
  if (std::isfinite(interval.high())) {
    EXPECT_GE(Rational(interval.high()), exact);
  }
}

TEST(Intervals, HoldWhatExactNumbersGive) {
  tern_test::Random random(7);
  for (int i = 0; i < tern_test::scaled(20000); ++i) {
    const Rational x = any_number(random), y = any_number(random);
    const Interval a(x), b(y);
    expect_holds(a, x);
    expect_holds(a + b, x + y);
    expect_holds(a - b, x - y);
    expect_holds(a * b, x * y);
    if (y != 0) {
      expect_holds(a / b, x / y);
    }
    expect_holds(abs(a), abs(x));
    expect_holds(positive_part(a), positive_part(x));
    const Interval wide = a - a + b;
    expect_holds(wide * wide, y * y);
    const Interval side = root(abs(a));
    EXPECT_LE(Rational(side.low()) * Rational(side.low()), abs(x));
    EXPECT_GE(Rational(side.high()) * Rational(side.high()), abs(x));
  }
}

/// The ends of wide intervals of any signs, every one with every other one.
TEST(Intervals, HoldWhatTheirEndsGive) {
  tern_test::Random random(8);
  for (int i = 0; i < tern_test::scaled(5000); ++i) {
    const double xs[] = {any_double(random), any_double(random)};
    const double ys[] = {any_double(random), any_double(random)};
    const Interval a = Interval::between(std::min(xs[0], xs[1]), std::max(xs[0], xs[1]));
    const Interval b = Interval::between(std::min(ys[0], ys[1]), std::max(ys[0], ys[1]));
    for (const Rational& x : {Rational(xs[0]), Rational(xs[1])}) {
      expect_holds(abs(a), abs(x));
      expect_holds(positive_part(a), positive_part(x));
      EXPECT_LE(Rational(root(a).low()) * Rational(root(a).low()), positive_part(x));
      EXPECT_GE(Rational(root(a).high()) * Rational(root(a).high()), x);
      for (const Rational& y : {Rational(ys[0]), Rational(ys[1])}) {
        expect_holds(a + b, x + y);
        expect_holds(a - b, x - y);
        expect_holds(a * b, x * y);
        if (y != 0) {
          expect_holds(a / b, x / y);
        }
      }
    }
  }
}

TEST(Intervals, AreNarrow) {
  const Interval third(Rational(1) / 3);
  const Interval one = third + third + third;
  EXPECT_LT(one.high() - one.low(), 1e-14);
  EXPECT_EQ((Interval(0.0) * third).high(), 0.0);
  EXPECT_EQ(root(Interval(0.0)).high(), 0.0);
}

TEST(Intervals, HoldAllNumbersWhereNothingIsKnown) {
  const double most = std::numeric_limits<double>::max();
  const Interval all = Interval(0.0) / Interval(0.0);
  const Interval positive = positive_part(all);
  for (const Interval& interval :
       {Interval(most) * Interval(most) - Interval(most) * Interval(most),
        Interval(1.0) / (Interval(Rational(1) / 3) - Interval(Rational(1) / 3)), Interval(Rational(Integer(1) << 2000)),
        positive * positive, positive / (Interval(1.0) + positive), all * Interval::between(0.0, 1.0)}) {
    EXPECT_EQ(interval.low(), -std::numeric_limits<double>::infinity());
    EXPECT_EQ(interval.high(), std::numeric_limits<double>::infinity());
  }
}

}  // namespace
}  // namespace tern_verify
