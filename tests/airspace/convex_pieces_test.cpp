// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Convex pieces beside a count of crossings in exact numbers, which knows nothing of sweeps, levels and pieces.
#include "host/airspace/convex_pieces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support/random.hpp"

namespace {

using tern_host::ConvexPiece;
using tern_host::Corner;
using tern_host::Filled;
using tern_host::Outline;
using tern_host::Side;
using tern_test::Random;

bool even_odd(const std::vector<int>& windings) {
  int sum = 0;
  for (const int w : windings) sum += w;
  return sum % 2 != 0;
}

bool first_without_second(const std::vector<int>& windings) {
  return windings[0] != 0 && windings[1] % 2 == 0;
}

std::int64_t parts(double metres) {
  return std::llround(metres / tern_host::kStep);
}

Outline outline(const std::vector<std::pair<double, double>>& metres, std::size_t layer = 0) {
  Outline out{{}, layer};
  for (const auto& m : metres) out.corners.push_back({parts(m.first), parts(m.second)});
  return out;
}

__int128 area(const Corner& a, const Corner& b, const Corner& c) {
  return static_cast<__int128>(b.x - a.x) * (c.y - a.y) - static_cast<__int128>(b.y - a.y) * (c.x - a.x);
}

bool on_edge(const Corner& a, const Corner& b, const Corner& p) {
  return area(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

bool on_outline(const std::vector<Outline>& outlines, const Corner& p) {
  for (const Outline& o : outlines) {
    for (std::size_t i = 0; i < o.corners.size(); ++i) {
      if (on_edge(o.corners[i], o.corners[(i + 1) % o.corners.size()], p)) return true;
    }
  }
  return false;
}

/// How often each layer winds around the point: edges that a ray in the direction +x crosses.
std::vector<int> windings_around(const std::vector<Outline>& outlines, std::size_t layers, const Corner& p) {
  std::vector<int> windings(layers, 0);
  for (const Outline& o : outlines) {
    for (std::size_t i = 0; i < o.corners.size(); ++i) {
      const Corner& a = o.corners[i];
      const Corner& b = o.corners[(i + 1) % o.corners.size()];
      if (a.y <= p.y && p.y < b.y && area(a, b, p) > 0) ++windings[o.layer];
      if (b.y <= p.y && p.y < a.y && area(a, b, p) < 0) --windings[o.layer];
    }
  }
  return windings;
}

/// `beyond_cuts`: a level or upright side counts as inside only if the point is not on it. It may be a cut that was
/// moved outwards.
bool within_piece(const ConvexPiece& piece, const Corner& p, bool beyond_cuts) {
  return std::all_of(piece.sides.begin(), piece.sides.end(), [&](const Side& s) {
    const __int128 value = static_cast<__int128>(s.a) * p.x + static_cast<__int128>(s.b) * p.y;
    return beyond_cuts && (s.a == 0 || s.b == 0) ? value < s.c : value <= s.c;
  });
}

int pieces_around(const std::vector<ConvexPiece>& cut, const Corner& p, bool beyond_cuts) {
  return static_cast<int>(std::count_if(cut.begin(), cut.end(),
                                        [&](const ConvexPiece& piece) { return within_piece(piece, p, beyond_cuts); }));
}

/// The point is in the pieces if and only if it is in the area, and inside no two of them.
void expect_same(const std::vector<Outline>& outlines, std::size_t layers, const Filled& filled,
                 const std::vector<ConvexPiece>& cut, const Corner& p) {
  if (on_outline(outlines, p)) return;
  if (filled(windings_around(outlines, layers, p))) {
    ASSERT_GE(pieces_around(cut, p, false), 1) << p.x << " " << p.y;
  } else {
    ASSERT_EQ(pieces_around(cut, p, true), 0) << p.x << " " << p.y;
  }
  ASSERT_LE(pieces_around(cut, p, true), 1) << p.x << " " << p.y;
}

/// Points all over, and beside edges and corners.
Corner random_point(Random& random, const std::vector<Outline>& outlines, std::int64_t size) {
  const int near = random.integer(0, 3);
  const double reach = 1.2 * static_cast<double>(size);
  if (near == 0) return {std::llround(random.real(-reach, reach)), std::llround(random.real(-reach, reach))};
  const Outline& o = outlines[static_cast<std::size_t>(random.integer(0, static_cast<int>(outlines.size()) - 1))];
  const std::size_t i = static_cast<std::size_t>(random.integer(0, static_cast<int>(o.corners.size()) - 1));
  const Corner& a = o.corners[i];
  const Corner& b = o.corners[(i + 1) % o.corners.size()];
  const double t = near == 1 ? 0.0 : random.unit();
  return {a.x + std::llround(t * static_cast<double>(b.x - a.x)) + random.integer(-3, 3),
          a.y + std::llround(t * static_cast<double>(b.y - a.y)) + random.integer(-3, 3)};
}

void expect_same_everywhere(Random& random, const std::vector<Outline>& outlines, std::size_t layers,
                            const Filled& filled, std::int64_t size, int points) {
  const std::vector<ConvexPiece> cut = tern_host::convex_pieces(outlines, layers, filled);
  for (const ConvexPiece& piece : cut) {
    EXPECT_LE(piece.sides.size(), tern_host::kMostSides);
    EXPECT_EQ(piece.sides.size(), piece.vertices.size());
    EXPECT_GT(piece.area, -1e-9);
  }
  for (int i = 0; i < points; ++i) {
    expect_same(outlines, layers, filled, cut, random_point(random, outlines, size));
    if (::testing::Test::HasFatalFailure()) return;
  }
}

/// A closed line through random corners, on a coarse lattice so that much coincides.
Outline scribble(Random& random, std::int64_t size, std::size_t layer) {
  Outline out{{}, layer};
  const int corners = random.integer(3, 9);
  const std::int64_t pitch = random.chance(0.5) ? size / 4 : 1;
  for (int i = 0; i < corners; ++i) {
    const auto coordinate = [&] {
      return pitch *
             static_cast<std::int64_t>(std::llround(random.real(-1.0, 1.0) * static_cast<double>(size / pitch)));
    };
    out.corners.push_back({coordinate(), coordinate()});
  }
  return out;
}

/// A star-shaped outline about the origin: it does not cross itself.
Outline star(Random& random, double least, double most, std::size_t layer) {
  std::vector<double> angles;
  const int corners = random.integer(5, 30);
  for (int i = 0; i < corners; ++i) angles.push_back((i + 0.9 * random.unit()) * 6.283185307179586 / corners);
  Outline out{{}, layer};
  for (const double angle : angles) {
    const double r = random.real(least, most);
    out.corners.push_back({parts(r * std::cos(angle)), parts(r * std::sin(angle))});
  }
  if (random.chance(0.5)) std::reverse(out.corners.begin(), out.corners.end());
  return out;
}

double area_of(const Outline& o) {
  __int128 twice = 0;
  for (std::size_t i = 0; i < o.corners.size(); ++i) {
    twice += area({0, 0}, o.corners[i], o.corners[(i + 1) % o.corners.size()]);
  }
  return std::fabs(0.5 * static_cast<double>(twice)) * tern_host::kStep * tern_host::kStep;
}

TEST(ConvexPieces, AConvexPolygonIsOnePiece) {
  for (const bool reversed : {false, true}) {
    Outline o = outline({{0, 0}, {4, 0}, {6, 3}, {2, 5}, {-1, 2}});
    if (reversed) std::reverse(o.corners.begin(), o.corners.end());
    const std::vector<ConvexPiece> cut = tern_host::convex_pieces({o}, 1, even_odd);
    ASSERT_EQ(cut.size(), 1u);
    EXPECT_EQ(cut[0].sides.size(), 5u);
    EXPECT_NEAR(cut[0].area, 22.5, 1e-9);  // (0 + 12 + 24 + 9 + 0) / 2, by the shoelace formula
  }
}

TEST(ConvexPieces, AnLIsTwoPieces) {
  const std::vector<ConvexPiece> cut =
      tern_host::convex_pieces({outline({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}})}, 1, even_odd);
  ASSERT_EQ(cut.size(), 2u);
  EXPECT_NEAR(cut[0].area + cut[1].area, 6.0, 1e-12);
}

TEST(ConvexPieces, ASquareWithASquareHoleIsFourPieces) {
  const std::vector<ConvexPiece> cut = tern_host::convex_pieces(
      {outline({{0, 0}, {6, 0}, {6, 6}, {0, 6}}), outline({{2, 2}, {4, 2}, {4, 4}, {2, 4}}, 1)}, 2,
      first_without_second);
  EXPECT_EQ(cut.size(), 4u);
  double sum = 0.0;
  for (const ConvexPiece& piece : cut) sum += piece.area;
  EXPECT_NEAR(sum, 32.0, 1e-12);
}

TEST(ConvexPieces, ABowTieIsTwoTriangles) {
  const std::vector<ConvexPiece> cut =
      tern_host::convex_pieces({outline({{0, 0}, {4, 4}, {4, 0}, {0, 4}})}, 1, even_odd);
  EXPECT_EQ(cut.size(), 2u);
}

TEST(ConvexPieces, ASpikeWithoutAreaIsNothing) {
  EXPECT_TRUE(tern_host::convex_pieces({outline({{0, 0}, {4, 1}})}, 1, even_odd).empty());
  EXPECT_TRUE(tern_host::convex_pieces({outline({{0, 0}, {4, 0}, {2, 0}})}, 1, even_odd).empty());
  EXPECT_TRUE(tern_host::convex_pieces({}, 1, even_odd).empty());
}

TEST(ConvexPieces, ManySidesAreCut) {
  Outline o{{}, 0};
  for (int i = 0; i < 200; ++i) {
    o.corners.push_back(
        {parts(100.0 * std::cos(i * 0.01 * 3.14159265358979)), parts(100.0 * std::sin(i * 0.01 * 3.14159265358979))});
  }
  Random random(4);
  expect_same_everywhere(random, {o}, 1, even_odd, parts(100.0), tern_test::scaled(500));
}

TEST(ConvexPieces, ScribblesAreFilledAsTheirRuleSays) {
  Random random(5);
  for (int i = 0; i < tern_test::scaled(1500); ++i) {
    const std::int64_t size = random.chance(0.3) ? 64 : parts(random.real(1.0, 30000.0));
    std::vector<Outline> outlines{scribble(random, size, 0)};
    while (random.chance(0.5)) outlines.push_back(scribble(random, size, random.chance(0.5) ? 1 : 0));
    const Filled filled = random.chance(0.5) ? Filled(even_odd) : Filled(first_without_second);
    expect_same_everywhere(random, outlines, 2, filled, size, 200);
    if (HasFatalFailure()) FAIL() << "scribble " << i;
  }
}

/// Many steps that go along or up and down on a lattice: much begins, ends and meets on one level, or coincides.
TEST(ConvexPieces, StepsOnALatticeAreFilledAsTheirRuleSays) {
  Random random(7);
  for (int i = 0; i < tern_test::scaled(600); ++i) {
    const int size = random.integer(3, 12);
    std::vector<Outline> outlines;
    for (int k = random.integer(1, 3); k > 0; --k) {
      Outline steps{{}, static_cast<std::size_t>(random.integer(0, 1))};
      Corner at{0, 0};
      for (int c = random.integer(4, 40); c > 0; --c) {
        const int turn = random.integer(0, 3);  // 0: along, 1: up or down, else to anywhere
        if (turn != 1) at.x = 16 * random.integer(-size, size);
        if (turn != 0) at.y = 16 * random.integer(-size, size);
        steps.corners.push_back(at);
      }
      outlines.push_back(steps);
    }
    const Filled filled = random.chance(0.5) ? Filled(even_odd) : Filled(first_without_second);
    expect_same_everywhere(random, outlines, 2, filled, 16 * size, 200);
    if (HasFatalFailure()) FAIL() << "steps " << i;
  }
}

TEST(ConvexPieces, PolygonsWithHolesKeepTheirArea) {
  Random random(6);
  for (int i = 0; i < tern_test::scaled(1000); ++i) {
    const double size = random.real(10.0, 10000.0);
    const std::vector<Outline> outlines{star(random, 0.5 * size, size, 0), star(random, 0.1 * size, 0.25 * size, 1)};
    const std::vector<ConvexPiece> cut = tern_host::convex_pieces(outlines, 2, first_without_second);
    double sum = 0.0;
    for (const ConvexPiece& piece : cut) sum += piece.area;
    const double wanted = area_of(outlines[0]) - area_of(outlines[1]);
    EXPECT_NEAR(sum, wanted, 1e-9 * size * size);
    expect_same_everywhere(random, outlines, 2, first_without_second, parts(size), 100);
    if (HasFatalFailure()) FAIL() << "polygon " << i;
  }
}

TEST(ConvexPieces, RefusesWhatIsTooFarOrTooMuch) {
  EXPECT_THROW(tern_host::convex_pieces({outline({{0, 0}, {40000, 0}, {0, 1}})}, 1, even_odd), std::invalid_argument);
  Outline many{{}, 0};
  for (std::size_t i = 0; i <= tern_host::kMostCorners; ++i) many.corners.push_back({static_cast<std::int64_t>(i), 0});
  EXPECT_THROW(tern_host::convex_pieces({many}, 1, even_odd), std::invalid_argument);
  many.corners.pop_back();
  EXPECT_NO_THROW(tern_host::convex_pieces({many, {{{0, 0}, {9, 0}, {9, 9}}, 0, true}}, 1, even_odd));
}

/// Teeth of which each level passes all: the most work for so many corners. Each place in them is in one piece.
TEST(ConvexPieces, ThousandsOfTeethAreCut) {
  tern_test::Random random(4410);
  Outline comb{{}, 0};
  const std::int64_t teeth = tern_test::scaled(1000);
  for (std::int64_t i = 0; i < teeth; ++i) {
    comb.corners.push_back({2000000 * i, -1000 * random.integer(1, 100000)});
    comb.corners.push_back({2000000 * i + 1000000, 1000 * random.integer(1, 100000)});
  }
  comb.corners.push_back({2000000 * teeth, 200000000});
  comb.corners.push_back({-1, 200000000});
  const std::vector<ConvexPiece> cut = tern_host::convex_pieces({comb}, 1, even_odd);
  double sum = 0.0;
  for (const ConvexPiece& piece : cut) sum += piece.area;
  double wanted = 0.0;
  for (std::size_t i = 0; i < comb.corners.size(); ++i) {
    const Corner &a = comb.corners[i], &b = comb.corners[(i + 1) % comb.corners.size()];
    wanted += 0.5 * tern_host::kStep * tern_host::kStep * static_cast<double>(a.x * b.y - b.x * a.y);
  }
  EXPECT_NEAR(sum, wanted, 1e-6 * wanted);
  for (int i = 0; i < tern_test::scaled(300); ++i) {
    const Corner among{std::llround(random.real(0.0, 2e6 * static_cast<double>(teeth))),
                       std::llround(random.real(-1.1e8, 2.1e8))};
    expect_same({comb}, 1, even_odd, cut, among);
    expect_same({comb}, 1, even_odd, cut, random_point(random, {comb}, 200000000));
    if (HasFatalFailure()) return;
  }
}

}  // namespace
