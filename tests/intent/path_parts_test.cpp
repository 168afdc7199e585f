// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fewest parts of a way, beside all ways to divide it.
#include "host/intent/path_parts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "intent/path_case.hpp"

namespace {

using tern_host::PartLimits;
using tern_host::PathPart;
using tern_test::PathPiece;
using tern_test::Random;

long double off_chord(const tern::Vec3& a, const tern::Vec3& b, const tern::Vec3& p) {
  long double least = HUGE_VALL;
  const auto away = [&p](long double x, long double y) { return std::hypot(p.x - x, p.y - y); };
  least = std::min(away(a.x, a.y), away(b.x, b.y));
  const long double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  if (square == 0.0L) return least;
  const long double u = ((p.x - a.x) * dx + (p.y - a.y) * dy) / square;
  return u < 0.0L || u > 1.0L ? least : std::min(least, away(a.x + u * dx, a.y + u * dy));
}

bool fits(const std::vector<PathPiece>& pieces, std::size_t first, std::size_t last, const PartLimits& limits) {
  if (pieces[last - 1].end - pieces[first].begin > limits.longest) return false;
  double lower[3] = {1e9, 1e9, 1e9}, upper[3] = {-1e9, -1e9, -1e9};
  long double off = 0.0L;
  for (std::size_t i = first; i < last; ++i) {
    for (const tern::Vec3& p : pieces[i].points) {
      const double at[3] = {p.x, p.y, p.z};
      for (int a = 0; a < 3; ++a) {
        lower[a] = std::min(lower[a], at[a]);
        upper[a] = std::max(upper[a], at[a]);
      }
      off = std::max(off, off_chord(pieces[first].points.front(), pieces[last - 1].points.back(), p));
    }
  }
  const double across = std::max(upper[0] - lower[0], upper[1] - lower[1]);
  return across <= limits.column / std::sqrt(2.0) ||
         (upper[2] - lower[2] <= limits.rise && 2.0L * off <= limits.spread);
}

TEST(PathParts, AreAsFewAsCanBe) {
  Random random(103);
  const int cases = tern_test::scaled(200);
  for (int c = 0; c < cases; ++c) {
    std::vector<PathPiece> pieces;
    tern::Vec3 at{0.0, 0.0, 0.0};
    for (int i = 0; i < 9; ++i) {
      const tern::Vec3 to{at.x + random.real(-1.0, 3.0), at.y + random.real(-1.0, 1.0), at.z + random.real(-1.0, 1.0)};
      pieces.push_back(tern_test::straight(i, i + 1, at, to));
      at = to;
    }
    const PartLimits limits{random.real(2.0, 12.0), random.real(4.0, 8.0), random.real(4.5, 6.0),
                            random.real(2.0, 5.0)};
    std::size_t fewest = 100;
    for (unsigned cuts = 0; cuts < 256; ++cuts) {
      std::size_t first = 0, parts = 0;
      bool all = true;
      for (std::size_t last = 1; last <= 9; ++last) {
        if (last < 9 && (cuts >> (last - 1) & 1u) == 0) continue;
        all = all && fits(pieces, first, last, limits);
        first = last;
        ++parts;
      }
      if (all) fewest = std::min(fewest, parts);
    }
    const std::vector<PathPart> parts = tern_host::fewest_parts(pieces, limits);
    ASSERT_EQ(parts.size(), fewest) << "case " << c;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_EQ(parts[i].first, i == 0 ? 0 : parts[i - 1].last);
      EXPECT_TRUE(fits(pieces, parts[i].first, parts[i].last, limits));
    }
    EXPECT_EQ(parts.back().last, 9u);
  }
}

TEST(PathParts, HalvesAreTheSameWay) {
  Random random(104);
  const int cases = tern_test::scaled(100);
  for (int c = 0; c < cases; ++c) {
    const tern_host::TimedPath path = tern_test::random_path(random);
    const std::vector<PathPiece> pieces = tern_host::halved(path.pieces, {40.0, 10.0, 10.0, 10.0});
    double begin = path.pieces[0].begin;
    for (const PathPiece& piece : pieces) {
      EXPECT_EQ(piece.begin, begin);
      begin = piece.end;
      const double t = 0.5 * (piece.begin + piece.end);
      const auto of =
          std::find_if(path.pieces.begin(), path.pieces.end(), [t](const PathPiece& p) { return t < p.end; });
      const tern::Vec3 p = tern_test::position(piece, t), q = tern_test::position(*of, t);
      EXPECT_NEAR(p.x, q.x, 1e-9);
      EXPECT_NEAR(p.y, q.y, 1e-9);
      EXPECT_NEAR(p.z, q.z, 1e-9);
    }
    EXPECT_EQ(begin, path.pieces.back().end);
  }
}

}  // namespace
