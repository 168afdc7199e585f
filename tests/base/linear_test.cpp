// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The core's own sums over vectors, against numbers known by hand.
#include "base/linear.hpp"

#include <gtest/gtest.h>

namespace tern {
namespace {

/// Added up from the left it is 0: the 1 is lost beside 1e16. From the right it is 1.
const Vector kLost(1.0, 1e16, -1e16);
const Vector kOnes(1.0, 1.0, 1.0);

TEST(Linear, SumsRunFromTheLeft) {
  EXPECT_EQ(dot(kLost, kOnes), 0.0);
  EXPECT_EQ(dot(Vector(1e16, -1e16, 1.0), kOnes), 1.0);
  Matrix m;
  m << 1.0, 1e16, -1e16, 1e16, -1e16, 1.0, 0.0, 2.0, 3.0;
  EXPECT_EQ(multiply(m, kOnes), Vector(0.0, 1.0, 5.0));
}

TEST(Linear, ProductsOfVectors) {
  EXPECT_EQ(cross(Vector::UnitX(), Vector::UnitY()), Vector(0.0, 0.0, 1.0));
  EXPECT_EQ(cross(Vector(1.0, 2.0, 3.0), Vector(4.0, 5.0, 7.0)), Vector(-1.0, 5.0, -3.0));
  EXPECT_EQ(length(Vector(2.0, 3.0, 6.0)), 7.0);
  Matrix square;
  square << 1.0, 2.0, 3.0, 2.0, 4.0, 6.0, 3.0, 6.0, 9.0;
  EXPECT_EQ(outer(Vector(1.0, 2.0, 3.0)), square);
}

TEST(Linear, ViewsReachTheArraysBehindThem) {
  double numbers[5] = {0.0, 1.0, 2.0, 3.0, 4.0};
  vector_at(numbers + 1) += Vector(10.0, 20.0, 30.0);
  EXPECT_EQ(numbers[0], 0.0);
  EXPECT_EQ(numbers[1], 11.0);
  EXPECT_EQ(numbers[3], 33.0);
  EXPECT_EQ(numbers[4], 4.0);
  double rows[3][3] = {};
  Matrix m;
  m << 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0;
  matrix_of(rows) = m;
  EXPECT_EQ(rows[0][2], 3.0);
  EXPECT_EQ(rows[2][0], 7.0);
}

}  // namespace
}  // namespace tern
