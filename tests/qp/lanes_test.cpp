// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pairs for targets without registers of two doubles have the bits of those in registers.
#include "qp/lanes.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <vector>

#include "support/random.hpp"

namespace {

using tern::qp::larger_of;
using tern::qp::PlainPair;
using tern::qp::store_two;
using tern::qp::VectorPair;

/// What the solver does with pairs, on two pairs.
template <typename Pair>
std::vector<double> results(const double* a, const double* b) {
  const Pair x = {a[0], a[1]};
  const Pair y = {b[0], b[1]};
  Pair sum = x + y;
  Pair less = x;
  Pair scaled = x;
  sum += x * y;
  less -= y;
  scaled *= y;
  std::vector<double> all;
  const Pair pairs[] = {sum, less, scaled, x - y, -x, larger_of(x, y), larger_of(y, x)};
  for (const Pair& pair : pairs) {
    double two[2];
    store_two(pair, two);
    all.insert(all.end(), {pair[0], pair[1], two[0], two[1]});
  }
  return all;
}

TEST(Lanes, PlainPairsHaveTheBitsOfVectors) {
  tern_test::Random random(7);
  const double special[] = {0.0, -0.0, 1e-310, std::numeric_limits<double>::infinity(), -1e300};
  for (int k = 0; k < 2000; ++k) {
    double a[2], b[2];
    for (double* at : {a, a + 1, b, b + 1}) {
      *at = random.chance(0.1) ? special[random.integer(0, 4)] : random.real(-1e3, 1e3);
    }
    const std::vector<double> plain = results<PlainPair>(a, b);
    const std::vector<double> vector = results<VectorPair>(a, b);
    ASSERT_EQ(std::memcmp(plain.data(), vector.data(), plain.size() * sizeof(double)), 0) << k;
  }
}

}  // namespace
