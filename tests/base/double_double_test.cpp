// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Arithmetic of twice a double's precision, against numbers known by hand.
#include "base/double_double.hpp"

#include <gtest/gtest.h>

namespace tern {
namespace {

constexpr double kTiny = 1.0 / (1024.0 * 1024.0 * 1024.0 * 1024.0);  // 2^-40

TEST(DoubleDouble, SumsAndProductsLoseNothing) {
  const DoubleDouble sum = exact_sum(1e16, 1.0);
  EXPECT_EQ(sum.high, 1e16);
  EXPECT_EQ(sum.low, 1.0);
  const DoubleDouble square = exact_product(1.0 + kTiny, 1.0 + kTiny);  // 1 + 2^-39 + 2^-80
  EXPECT_EQ(square.high, 1.0 + 2.0 * kTiny);
  EXPECT_EQ(square.low, kTiny * kTiny);
}

TEST(DoubleDouble, ArithmeticIsGoodToTwiceTheDigits) {
  const DoubleDouble third = DoubleDouble(1.0) / DoubleDouble(3.0);
  const DoubleDouble rest = DoubleDouble(1.0) - DoubleDouble(3.0) * third;
  EXPECT_LT(rest.high < 0.0 ? -rest.high : rest.high, 1e-31);
  const DoubleDouble large(1e20);
  const DoubleDouble small = (large * large + DoubleDouble(1e12)) - large * large;
  EXPECT_NEAR(small.high, 1e12, 1e9);  // 1e-31 of 1e40
  EXPECT_EQ((large + DoubleDouble(0.5) - large).high, 0.5);
}

TEST(DoubleDouble, ComparesByBothParts) {
  const DoubleDouble a = exact_sum(1.0, kTiny * kTiny);
  EXPECT_TRUE(DoubleDouble(1.0) < a);
  EXPECT_FALSE(a < DoubleDouble(1.0));
  EXPECT_FALSE(a < a);
  EXPECT_TRUE(-a < DoubleDouble(0.0));
}

TEST(DoubleDouble, DepthsDoNotDependOnHowFarThePlaneIs) {
  const Vec3 normal{3.0, -4.0, 0.1};
  const Vec3 far{1e12 + 0.25, 3e11, 0.0};
  const double offset = 3.0 * 1e12 + 0.75 - 4.0 * 3e11 + 0.5;  // exact: all are multiples of 1/4 below 2^53
  EXPECT_EQ(depth_of(offset, normal, far).high, 0.5);
}

}  // namespace
}  // namespace tern
