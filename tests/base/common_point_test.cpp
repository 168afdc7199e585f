// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Half-spaces with and without a point in common, against an exact elimination of the coordinates in integers.
#include "base/common_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::CommonPoint;
using tern::Halfspace;
using tern::Vec3;

constexpr double kMargin = 1e-12;
constexpr double kScale = 20.0;

/// The number of the half-space that leaves nothing; -1 where there is a common point within reach, -2 beyond.
int first_empty(const std::vector<Halfspace>& planes, const Vec3& center = {}, double margin = kMargin) {
  CommonPoint common(center, margin, kScale);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (!common.add(planes[p])) return static_cast<int>(p);
  }
  return common.within_reach() ? -1 : -2;
}

/// a x + b y + c z <= d in integers.
using Row = std::array<std::int64_t, 4>;

std::int64_t divisor_of(const Row& row) {
  std::int64_t divisor = 0;
  for (const std::int64_t n : row) {
    std::int64_t a = std::abs(n);
    while (a != 0) {
      const std::int64_t rest = divisor % a;
      divisor = a;
      a = rest;
    }
  }
  return std::max<std::int64_t>(divisor, 1);
}

/// Fourier and Motzkin: each pair of rows that bound a coordinate from either side becomes a row without it.
bool have_a_point(std::vector<Row> rows) {
  for (std::size_t a = 0; a < 3; ++a) {
    std::vector<Row> left;
    for (const Row& row : rows) {
      if (row[a] == 0) left.push_back(row);
    }
    for (const Row& upper : rows) {
      for (const Row& lower : rows) {
        if (upper[a] <= 0 || lower[a] >= 0) continue;
        Row sum;
        for (std::size_t k = 0; k < 4; ++k) sum[k] = upper[k] * -lower[a] + lower[k] * upper[a];
        const std::int64_t divisor = divisor_of(sum);
        for (std::int64_t& n : sum) n /= divisor;
        left.push_back(sum);
      }
    }
    std::sort(left.begin(), left.end());
    left.erase(std::unique(left.begin(), left.end()), left.end());
    rows = left;
  }
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row[3] >= 0; });
}

/// About an integer point; scaled by a power of two, without rounding.
Halfspace plane_of(const Row& row, const std::array<std::int64_t, 3>& center, double scale) {
  std::int64_t offset = row[3];
  for (std::size_t k = 0; k < 3; ++k) offset += row[k] * center[k];
  return {
      {static_cast<double>(row[0]) * scale, static_cast<double>(row[1]) * scale, static_cast<double>(row[2]) * scale},
      static_cast<double>(offset) * scale};
}

/// Also where the half-spaces are at the ends of the earth, and their order makes no difference to the answer.
TEST(CommonPointTest, AgreesWithExactElimination) {
  Random random(5);
  int empty = 0;
  const int cases = scaled(20000);
  for (int i = 0; i < cases; ++i) {
    std::vector<Row> rows;
    for (int k = random.integer(2, 7); k > 0; --k) {
      const int most = random.chance(0.5) ? 1 : 4;
      const Row row{random.integer(-most, most), random.integer(-most, most), random.integer(-most, most),
                    random.integer(-6, 12)};
      if (row[0] != 0 || row[1] != 0 || row[2] != 0) rows.push_back(row);
    }
    const std::int64_t far = random.chance(0.5) ? 0 : 1000000007;
    const std::array<std::int64_t, 3> center{far, -far, random.integer(-3, 3)};
    std::vector<Halfspace> planes;
    for (const Row& row : rows) planes.push_back(plane_of(row, center, std::ldexp(1.0, random.integer(-12, 12))));
    const bool has_point = have_a_point(rows);
    const Vec3 about{static_cast<double>(far), static_cast<double>(-far), random.real(-5.0, 5.0)};
    const int found = first_empty(planes, about);
    ASSERT_EQ(found == -1, has_point) << "case " << i << ": " << found;
    ASSERT_NE(found, -2) << "case " << i;
    if (found < 0) continue;
    ++empty;
    // The prefix before it has a point.
    ASSERT_TRUE(have_a_point({rows.begin(), rows.begin() + found})) << "case " << i;
    ASSERT_FALSE(have_a_point({rows.begin(), rows.begin() + found + 1})) << "case " << i;
  }
  EXPECT_GT(empty, cases / 10);
  EXPECT_LT(empty, cases * 9 / 10);
}

/// As many half-spaces as there may be, around a common point or short of it by less than any tolerance would forgive.
TEST(CommonPointTest, AsManyAsThereMayBe) {
  Random random(6);
  for (int i = 0; i < scaled(200); ++i) {
    const Vec3 point{random.real(-9.0, 9.0), random.real(-9.0, 9.0), random.real(-9.0, 9.0)};
    std::vector<Halfspace> planes;
    while (static_cast<int>(planes.size()) < tern::kMaxFencePlanes) {
      const Vec3 n{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
      planes.push_back({n, n.x * point.x + n.y * point.y + n.z * point.z});
    }
    ASSERT_EQ(first_empty(planes), -1) << "case " << i << ": flat but for rounding";
    for (Halfspace& plane : planes) plane.offset -= 1e-9;
    ASSERT_GE(first_empty(planes), 1) << "case " << i;
  }
}

TEST(CommonPointTest, FlatIsNotEmptyAndReversedIs) {
  for (const double far : {0.0, 5e6, 1e9}) {
    const Vec3 about{far, 0.0, 0.0};
    EXPECT_EQ(first_empty({{{1.0, 0.0, 0.0}, far + 2.0}, {{-1.0, 0.0, 0.0}, -far - 2.0}}, about), -1) << far;
    EXPECT_EQ(first_empty({{{1.0, 0.0, 0.0}, far + 2.0}, {{-1.0, 0.0, 0.0}, -far - 3.0}}, about), 1) << far;
  }
  EXPECT_EQ(first_empty({{{1.0, 0.0, 0.0}, 2.0}, {{-3.0, 0.0, 0.0}, -6.0 - 2e-12}}), -1);
  EXPECT_EQ(first_empty({{{1.0, 0.0, 0.0}, 2.0}, {{-3.0, 0.0, 0.0}, -6.0 - 2e-11}}), 1);
  EXPECT_EQ(first_empty({{{1.0, 0.0, 0.0}, 2.0}, {{-1.0, 0.0, 0.0}, -2.0}}, {}, 0.0), -1);
}

/// A polygon of upright sides, or of oblique ones, drawn the wrong way round.
TEST(CommonPointTest, PolygonsTheWrongWayRound) {
  for (int sides = 3; sides <= 12; ++sides) {
    for (const double lean : {0.0, 0.1}) {
      std::vector<Halfspace> planes;
      std::vector<Halfspace> reversed;
      for (int k = 0; k < sides; ++k) {
        const double angle = 2.0 * 3.14159265358979 * k / sides;
        const Vec3 n{std::cos(angle), std::sin(angle), lean};
        planes.push_back({n, 3.0 * n.x + 4.0 * n.y + 2.0});
        reversed.push_back({{-n.x, -n.y, -n.z}, -planes.back().offset});
      }
      reversed.push_back({{0.0, 0.0, 1.0}, 3.0});
      reversed.push_back({{0.0, 0.0, -1.0}, 0.0});
      EXPECT_EQ(first_empty(planes), -1) << sides;
      EXPECT_GE(first_empty(reversed), 2) << sides;
    }
  }
}

/// Faces that should be parallel meet somewhere, where rounding turned them.
TEST(CommonPointTest, NearlyParallelPlanesMeetOutOfReach) {
  for (const double turn : {1e-16, 1e-12, 1e-7, 1e-6}) {
    EXPECT_EQ(first_empty({{{1.0, turn, 0.0}, -2.0}, {{-1.0, 0.0, 0.0}, -2.0}}), -2) << turn;
  }
  EXPECT_EQ(first_empty({{{1.0, 1e-5, 0.0}, -2.0}, {{-1.0, 0.0, 0.0}, -2.0}}), -1);
}

TEST(CommonPointTest, FarAwayIsNotEmpty) {
  EXPECT_EQ(first_empty({}), -1);
  for (const double far : {1e3, 1e9, 1e18, 1e99}) {
    EXPECT_EQ(first_empty({{{-1.0, 0.0, 0.0}, -far}}), -1) << far;
    EXPECT_EQ(first_empty({{{-1.0, 0.0, 0.0}, -far}, {{1.0, 0.0, 0.0}, 1.5 * far}, {{0.0, 1.0, 0.0}, -far}}), -1)
        << far;
    EXPECT_EQ(first_empty({{{-1.0, 0.0, 0.0}, -far}, {{1.0, 0.0, 0.0}, 0.5 * far}}), 1) << far;
  }
  EXPECT_EQ(first_empty({{{1e-6, 0.0, 0.0}, -1e300}}), -1);
  EXPECT_EQ(first_empty({{{1e6, 0.0, 0.0}, 1e307}, {{-1.0, 0.0, 0.0}, -1e300}}), -1);
}

}  // namespace
}  // namespace tern_test
