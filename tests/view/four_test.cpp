// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Four numbers for targets without registers of four have the bits of those in registers.
#include "view/four.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "support/random.hpp"

namespace {

using tern::absolute;
using tern::choose;
using tern::decimal;
using tern::PlainFour;
using tern::VectorFour;
using tern::VectorFourInts;
using tern::whole;

/// What views and maps do with four numbers at a time, as 32 bits each.
template <typename Fours, typename Ints>
std::vector<std::int32_t> results(const float* a, const float* b) {
  const Fours x = {a[0], a[1], a[2], a[3]};
  const Fours y = {b[0], b[1], b[2], b[3]};
  const Ints i = whole(x);
  const Ints j = whole(y);
  Fours raised = x;
  raised += y;
  Ints both = x < y;
  both &= x <= 1.0f;
  const Fours fours[] = {x + y,       x - y,      x * y, x / y, 2.0f - x, x * 0.5f, choose(x > y, x, y),
                         absolute(x), decimal(i), raised};
  const Ints ints[] = {
      i, j, i - 1, i + j, i >> 6, x >= y, (x > 0.0f) | (y < 0.0f), (i >= 3) & (j < 9), choose(i < j, i, j), both};
  std::vector<std::int32_t> all;
  for (int k = 0; k < 4; ++k) {
    for (const Fours& four : fours) {
      const float number = four[k];
      std::int32_t bits;
      std::memcpy(&bits, &number, sizeof bits);
      all.push_back(bits);
    }
    for (const Ints& four : ints) all.push_back(four[k]);
  }
  return all;
}

TEST(Four, PlainOnesHaveTheBitsOfVectors) {
  tern_test::Random random(8);
  for (int k = 0; k < 2000; ++k) {
    float a[4], b[4];
    for (float& number : a) number = random.chance(0.1) ? -0.0f : static_cast<float>(random.real(-1e3, 1e3));
    for (float& number : b) number = random.chance(0.1) ? 1e-40f : static_cast<float>(random.real(-1e3, 1e3));
    const auto plain = results<PlainFour<float>, PlainFour<std::int32_t>>(a, b);
    const auto vectors = results<VectorFour, VectorFourInts>(a, b);
    ASSERT_EQ(plain, vectors) << k;
  }
}

/// The larger or the smaller of two numbers is the second one where they are equal, or where one is NaN.
TEST(Four, LimitsAreThoseOfAComparison) {
  const float none = __builtin_nanf("");
  const tern::Four x = {none, 1.0f, -0.0f, 2.0f};
  const tern::Four y = {1.0f, none, 0.0f, 1.0f};
  EXPECT_EQ(tern::larger(x, y)[0], 1.0f);
  EXPECT_TRUE(tern::smaller(x, y)[1] != tern::smaller(x, y)[1]);
  EXPECT_FALSE(std::signbit(tern::larger(x, y)[2]));
  EXPECT_FALSE(std::signbit(tern::smaller(x, y)[2]));
  EXPECT_EQ(tern::larger(x, y)[3], 2.0f);
  EXPECT_EQ(tern::clamp(x, 0.5f, 1.5f)[0], 0.5f);
  EXPECT_EQ(tern::clamp(x, 0.5f, 1.5f)[3], 1.5f);
}

}  // namespace
