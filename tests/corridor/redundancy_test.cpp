// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which half-spaces bound a polyhedron: by hand, and at random against a list of corners.
#include "corridor/redundancy.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "support/corridor_reference.hpp"
#include "support/random.hpp"
#include "world/facet.hpp"

namespace tern_test {
namespace {

using tern::Halfspace;
using tern::Polyhedron;
using tern::Vec3;

const double kRoot = std::sqrt(0.5);

/// The cube from -1 to 1, then `more`.
Polyhedron cube_and(const std::vector<Halfspace>& more) {
  Polyhedron p{};
  for (int a = 0; a < 3; ++a) {
    const Vec3 n{a == 0 ? 1.0 : 0.0, a == 1 ? 1.0 : 0.0, a == 2 ? 1.0 : 0.0};
    p.planes[p.count++] = {n, 1.0};
    p.planes[p.count++] = {{-n.x, -n.y, -n.z}, 1.0};
  }
  for (const Halfspace& h : more) p.planes[p.count++] = h;
  return p;
}

constexpr Vec3 kOrigin{0.0, 0.0, 0.0};

void drop(Polyhedron& polyhedron, const Vec3& inside) {
  Halfspace scratch[tern::kMaxPlanes];
  drop_redundant(polyhedron, inside, 4.0, scratch);
}

TEST(CorridorRedundancy, KeepsACubeAsItIs) {
  Polyhedron p = cube_and({});
  drop(p, {0.3, -0.9, 0.5});
  EXPECT_EQ(p.count, 6);
}

TEST(CorridorRedundancy, DropsWhatDoesNotReachTheCube) {
  Polyhedron p = cube_and({{{kRoot, kRoot, 0.0}, 1.5}, {{kRoot, 0.0, kRoot}, 1.3}});
  drop(p, kOrigin);
  EXPECT_EQ(p.count, 7);  // an edge is at a distance of sqrt(2)
  EXPECT_EQ(p.planes[6].offset, 1.3);
}

TEST(CorridorRedundancy, TouchingAnEdgeOrACornerBoundsNothing) {
  const double third = std::sqrt(1.0 / 3.0);
  Polyhedron p = cube_and({{{kRoot, kRoot, 0.0}, 2.0 * kRoot}, {{third, third, third}, 3.0 * third}});
  drop(p, kOrigin);
  EXPECT_EQ(p.count, 6);
}

TEST(CorridorRedundancy, KeepsOneOfTwoThatAreEqual) {
  Polyhedron p = cube_and({{{1.0, 0.0, 0.0}, 1.0}, {{1.0, 0.0, 0.0}, 1.0}});
  drop(p, kOrigin);
  EXPECT_EQ(p.count, 6);
}

TEST(CorridorRedundancy, ReplacesAFaceThatIsCutOffWhole) {
  Polyhedron p = cube_and({{{1.0, 0.0, 0.0}, 0.5}});
  drop(p, kOrigin);
  EXPECT_EQ(p.count, 6);
  EXPECT_EQ(p.planes[5].offset, 0.5);
}

TEST(CorridorRedundancy, AFlatPolyhedronKeepsAll) {
  Polyhedron p = cube_and({{{1.0, 0.0, 0.0}, -1.0}, {{0.0, 1.0, 0.0}, 5.0}});
  drop(p, {-1.0, 0.0, 0.0});
  EXPECT_EQ(p.count, 8);
}

TEST(CorridorRedundancy, AThinOneLosesWhatItMay) {
  Polyhedron p = cube_and({{{1.0, 0.0, 0.0}, -1.0 + 1e-6}, {{0.0, 1.0, 0.0}, 5.0}});
  drop(p, {-1.0 + 5e-7, 0.0, 0.0});
  EXPECT_EQ(p.count, 6);
}

TEST(CorridorRedundancy, AgreesWithListedCorners) {
  Random random(5);
  for (int i = 0; i < scaled(3000); ++i) {
    std::vector<Halfspace> more;
    const int count = random.integer(1, 14);
    for (int k = 0; k < count; ++k) {
      const Vec3 n{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(-1.0, 1.0)};
      const double norm = norm3(n);
      if (norm < 0.1) continue;
      more.push_back({{n.x / norm, n.y / norm, n.z / norm}, random.real(0.2, 1.5)});
    }
    Polyhedron p = cube_and(more);
    const Polyhedron all = p;
    drop(p, kOrigin);
    ASSERT_NO_FATAL_FAILURE(expect_no_redundancy(p)) << "case " << i;
    for (const Vec3& corner : vertices_of(p)) {
      for (int k = 0; k < all.count; ++k) ASSERT_LE(signed_excess(all.planes[k], corner), 1e-9) << "case " << i;
    }
  }
}

TEST(CorridorFacet, IsCutToATriangleAndToNothing) {
  tern::Facet facet = tern::square_on({{0.0, 0.0, 1.0}, 2.0}, 1.0);
  EXPECT_EQ(facet.count, 4);
  EXPECT_TRUE(cut({{kRoot, kRoot, 0.0}, -kRoot}, facet));
  EXPECT_EQ(facet.count, 3);
  EXPECT_TRUE(cut({{0.0, 0.0, 1.0}, 2.5}, facet));
  EXPECT_EQ(facet.count, 3);
  EXPECT_FALSE(cut({{0.0, 0.0, 1.0}, 1.5}, facet));
}

}  // namespace
}  // namespace tern_test
