// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Polyhedra around the hulls of control points, against every obstacle voxel and distances found another way.
#include <gtest/gtest.h>

#include <memory>

#include "base/math.hpp"
#include "corridor/hull_polyhedron.hpp"
#include "support/corridor_reference.hpp"
#include "world/fences.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::Hull;
using tern::Polyhedron;
using tern::Status;
using tern::Vec3;

constexpr int kPoints = 8;

struct Bracket {
  double lower, upper;
};

Vec3 nearest_vertex(const Vec3& direction, const Hull& hull, const Box& cube) {
  int best = 0;
  for (int k = 1; k < hull.count; ++k) {
    if (dot3(direction, hull.points[k]) < dot3(direction, hull.points[best])) best = k;
  }
  const Vec3 far{direction.x > 0.0 ? cube.upper.x : cube.lower.x, direction.y > 0.0 ? cube.upper.y : cube.lower.y,
                 direction.z > 0.0 ? cube.upper.z : cube.lower.z};
  return minus3(hull.points[best], far);
}

/// The distance between hull and cube lies between the two: descent along the differences of their vertices.
Bracket distance_of(const Hull& hull, const Box& cube) {
  Vec3 x = minus3(hull.points[0], cube.lower);
  Bracket bracket{0.0, norm3(x)};
  for (int step = 0; step < 500 && bracket.upper - bracket.lower > 1e-4; ++step) {
    const double size = norm3(x);
    if (size < 1e-9) return {0.0, size};
    const Vec3 v = nearest_vertex(x, hull, cube);
    bracket.lower = std::max(bracket.lower, dot3(x, v) / size);
    const Vec3 way = minus3(v, x);
    const double part = std::min(1.0, std::max(0.0, -dot3(x, way) / std::max(dot3(way, way), 1e-30)));
    x = mix3(x, v, part);
    bracket.upper = std::min(bracket.upper, norm3(x));
  }
  return bracket;
}

class HullPolyhedron : public testing::Test {
 protected:
  HullPolyhedron() { tern::reset_counters(*scratch_); }
  Status enclose(const MarkedWorld& world, const Vec3* points, int count) {
    return enclose(tern::World(world.grid), points, count);
  }
  Status enclose(const tern::World& world, const Vec3* points, int count) {
    return tern::enclose_hull(world, {points, count}, 0.0, *scratch_, out_);
  }

  void expect_holds(const Hull& hull) const {
    for (int p = 0; p < out_.count; ++p) {
      ASSERT_NEAR(norm3(out_.planes[p].normal), 1.0, 1e-12);
      for (int k = 0; k < hull.count; ++k) ASSERT_LE(signed_excess(out_.planes[p], hull.points[k]), 1e-15);
    }
  }
  /// Each cube beyond one half-space by the radius.
  void expect_cut_off(const MarkedWorld& world, const std::vector<Box>& cubes) const {
    for (const Box& cube : cubes) {
      double best = -1e9;
      for (int p = 0; p < out_.count; ++p) {
        best = std::max(best, cube_support(out_.planes[p].normal, cube) - out_.planes[p].offset);
      }
      ASSERT_GE(best, world.grid.spec().radius - 2e-9);
    }
  }

  std::unique_ptr<tern::GrowScratch> scratch_ = std::make_unique<tern::GrowScratch>();
  Polyhedron out_;
};

TEST_F(HullPolyhedron, HoldsTheHullAndCutsOffEveryObstacle) {
  Random random(81);
  int held = 0, blocked = 0, oblique = 0;
  for (int i = 0; i < scaled(600); ++i) {
    MarkedWorld world({12, 10, 8}, 0.25, random.chance(0.2) ? 0.0 : random.real(0.02, 0.4));
    for (int k = random.integer(1, 40); k > 0; --k) {
      world.mark(random.integer(0, 11), random.integer(0, 9), random.integer(0, 7));
    }
    world.grid.inflate();
    const double reach = random.real(0.05, 0.6);
    const Vec3 middle{random.real(reach, 3.0 - reach), random.real(reach, 2.5 - reach),
                      random.real(reach, 2.0 - reach)};
    // Along a line, more or less, as a curve's control points are.
    const Vec3 along{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
    const double width = random.real(0.0, 0.3);
    Vec3 points[kPoints];
    for (int k = 0; k < kPoints; ++k) {
      const double t = (1.0 - width) * (2.0 * k / (kPoints - 1) - 1.0);
      points[k] = {middle.x + reach * (t * along.x + width * random.real(-1, 1)),
                   middle.y + reach * (t * along.y + width * random.real(-1, 1)),
                   middle.z + reach * (t * along.z + width * random.real(-1, 1))};
    }
    const Hull hull{points, kPoints};
    const std::vector<Box> cubes = obstacle_cubes(world.grid);
    Bracket nearest{1e9, 1e9};
    for (const Box& cube : cubes) {
      const Bracket one = distance_of(hull, cube);
      nearest = {std::min(nearest.lower, one.lower), std::min(nearest.upper, one.upper)};
    }
    const Status status = enclose(world, points, kPoints);
    const double radius = world.grid.spec().radius;
    if (nearest.lower > radius + 1e-6) {
      ASSERT_EQ(status, Status::kOk) << i << ": " << nearest.lower - radius;
    }
    if (nearest.upper < radius - 1e-6) {
      ASSERT_EQ(status, Status::kCorridorBlocked) << i << ": " << radius - nearest.upper;
    }
    ASSERT_TRUE(status == Status::kOk || status == Status::kCorridorBlocked) << i;
    (status == Status::kOk ? held : blocked) += 1;
    if (status != Status::kOk) continue;
    ASSERT_NO_FATAL_FAILURE(expect_holds(hull)) << i;
    ASSERT_NO_FATAL_FAILURE(expect_cut_off(world, cubes)) << i;
    oblique += out_.count > 6 ? 1 : 0;
  }
  EXPECT_GT(held, scaled(600) / 10);
  EXPECT_GT(blocked, scaled(600) / 10);
  EXPECT_GT(oblique, scaled(600) / 60) << "half-spaces besides the box around the hull";
}

TEST_F(HullPolyhedron, IsTheBoxAroundTheHullWhereNothingIsNear) {
  MarkedWorld world({20, 20, 20}, 0.5, 0.3);
  world.mark(0, 0, 0);
  world.grid.inflate();
  const Vec3 points[] = {{4, 5, 6}, {5, 4, 6.5}, {4.5, 5.5, 7}};
  ASSERT_EQ(enclose(world, points, 3), Status::kOk);
  ASSERT_EQ(out_.count, 6);
  EXPECT_EQ(out_.redundant, 0);
  const double offsets[6] = {5, -4, 5.5, -4, 7, -6};
  for (int p = 0; p < 6; ++p) EXPECT_EQ(out_.planes[p].offset, offsets[p]) << p;
  EXPECT_EQ(out_.from.x, 4.0);
  EXPECT_EQ(out_.to.z, 7.0);
}

TEST_F(HullPolyhedron, RefusesPointsBeyondTheBoundary) {
  MarkedWorld world({8, 8, 8}, 1.0, 0.3, {{1, 1, 1}, {7, 7, 7}});
  world.grid.inflate();
  for (int a = 0; a < 3; ++a) {
    for (const double side : {1.0, 7.0}) {
      const double out = side < 4.0 ? -1.0 : 1.0;
      Vec3 points[] = {{4, 4, 4}, {5, 5, 5}};
      tern::axis(points[1], a) = side;
      EXPECT_EQ(enclose(world, points, 2), Status::kOk) << "on the face";
      tern::axis(points[1], a) = side + 1e-6 * out;
      EXPECT_EQ(enclose(world, points, 2), Status::kOutOfMap) << a << " " << side;
    }
  }
}

/// Cells of 1 m, a post through (2..3, 2..3).
class Grazing : public HullPolyhedron {
 protected:
  Grazing() : world_({8, 8, 8}, 1.0, 0.0) {
    world_.fill({2, 2, 0}, {3, 3, 8});
    world_.grid.inflate();
  }
  MarkedWorld world_;
};

TEST_F(Grazing, TouchesAFace) {
  const Vec3 points[] = {{1, 3, 2}, {2, 3, 3}, {5, 3, 4}};
  ASSERT_EQ(enclose(world_, points, 3), Status::kOk);
  expect_holds({points, 3});
  expect_cut_off(world_, obstacle_cubes(world_.grid));
}

TEST_F(Grazing, TouchesButForRounding) {
  const double y = 3 - 5e-10;  // a face, at the middle of a curve that comes and leaves
  const Vec3 bow[] = {{1, 3.5, 2}, {2, y, 2.5}, {3, y, 3}, {5, 3.2, 4}};
  ASSERT_EQ(enclose(world_, bow, 4), Status::kOk);
  expect_holds({bow, 4});
  expect_cut_off(world_, obstacle_cubes(world_.grid));
  const Vec3 over_edge[] = {{1, 2 - 5e-10, 2.5}, {3, 4 - 5e-10, 4.5}};
  ASSERT_EQ(enclose(world_, over_edge, 2), Status::kOk);
  expect_holds({over_edge, 2});
  expect_cut_off(world_, obstacle_cubes(world_.grid));
}

TEST_F(Grazing, TouchesAnEdge) {
  const Vec3 points[] = {{1, 2, 2.5}, {2, 3, 3.5}, {3, 4, 4.5}};  // in x - y = -1, which the edge (2, 3) lies in
  ASSERT_EQ(enclose(world_, points, 3), Status::kOk);
  expect_holds({points, 3});
  expect_cut_off(world_, obstacle_cubes(world_.grid));
}

TEST_F(Grazing, EntersByLittle) {
  const Vec3 into_face[] = {{1, 3 - 1e-6, 2}, {5, 3 - 1e-6, 4}};
  EXPECT_EQ(enclose(world_, into_face, 2), Status::kCorridorBlocked);
  const Vec3 over_edge[] = {{1, 2 - 1e-6, 2.5}, {3, 4 - 1e-6, 4.5}};
  EXPECT_EQ(enclose(world_, over_edge, 2), Status::kCorridorBlocked);
  const Vec3 through[] = {{1, 2.5, 2.5}, {4, 2.5, 2.5}};
  EXPECT_EQ(enclose(world_, through, 2), Status::kCorridorBlocked);
}

TEST_F(HullPolyhedron, KeepsTheRadiusFromAnEdge) {
  // The edge (2, 3) is sqrt(1/2) away from x - y = -2.
  const Vec3 points[] = {{1, 3, 2.5}, {3, 5, 4.5}};
  for (const double radius : {0.7071, 0.7072}) {
    MarkedWorld world({8, 8, 8}, 1.0, radius);
    world.fill({2, 2, 0}, {3, 3, 8});
    world.grid.inflate();
    EXPECT_EQ(enclose(world, points, 2), radius < 0.70711 ? Status::kOk : Status::kCorridorBlocked) << radius;
  }
}

/// A keep-in x <= 6 and a keep-out box, radius 0.5.
class FencedHull : public HullPolyhedron {
 protected:
  FencedHull() : world_({8, 8, 8}, 1.0, 0.5) {
    world_.grid.inflate();
    tern::box_planes({{2, 2, 2}, {3, 3, 3}}, planes_);
    const tern::Fence list[] = {{&inside_, 1, tern::FenceKind::kKeepIn}, {planes_, 6, tern::FenceKind::kKeepOut}};
    EXPECT_EQ(load_fences(world_.grid, list, 2, *solids_).status, Status::kOk);
  }
  Status leg(const Vec3& from, const Vec3& to) {
    const Vec3 points[] = {from, to};
    return enclose(tern::World(world_.grid, *solids_), points, 2);
  }
  MarkedWorld world_;
  tern::Halfspace inside_{{1, 0, 0}, 6.0};
  tern::Halfspace planes_[tern::kBoxPlanes];
  std::unique_ptr<tern::Solids> solids_ = std::make_unique<tern::Solids>();
};

TEST_F(FencedHull, StaysInAKeepIn) {
  EXPECT_EQ(leg({4, 4, 4}, {6, 5, 4}), Status::kOk) << "the radius plays no part";
  EXPECT_EQ(leg({4, 4, 4}, {6.001, 5, 4}), Status::kCorridorBlocked);
}

TEST_F(FencedHull, KeepsTheRadiusFromAKeepOut) {
  EXPECT_EQ(leg({1, 3.5, 2.5}, {5, 3.5, 2.5}), Status::kOk);
  EXPECT_EQ(leg({1, 3.499, 2.5}, {5, 3.499, 2.5}), Status::kCorridorBlocked);
  // Obliquely past the edge (3, 3): the half-space that cuts the box off.
  const Vec3 points[] = {{2.5, 4.5, 2.5}, {4.5, 2.5, 2.5}};
  ASSERT_EQ(enclose(tern::World(world_.grid, *solids_), points, 2), Status::kOk);
  expect_holds({points, 2});
  expect_cut_off(world_, {{{2, 2, 2}, {3, 3, 3}}});
}

TEST_F(HullPolyhedron, TouchesAnObliqueFaceOfAKeepOutButForRounding) {
  MarkedWorld world({8, 8, 8}, 1.0, 0.0);
  world.grid.inflate();
  const Vec3 n{2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0};
  // Below the plane through (4, 4, 4), within 1 m of there on x and y.
  const tern::Halfspace planes[] = {
      {n, 4 * 11.0 / 7.0}, {{1, 0, 0}, 5}, {{-1, 0, 0}, -3}, {{0, 1, 0}, 5}, {{0, -1, 0}, -3}};
  const tern::Fence fence{planes, 5, tern::FenceKind::kKeepOut};
  const auto solids = std::make_unique<tern::Solids>();
  ASSERT_EQ(load_fences(world.grid, &fence, 1, *solids).status, Status::kOk);
  for (const double depth : {0.0, 5e-10, 1e-6}) {
    const Vec3 touch{4 - depth * n.x, 4 - depth * n.y, 4 - depth * n.z};
    const Vec3 bow[] = {{3.1, 4.2, 5.5}, touch, {touch.x + 0.3, touch.y - 0.2, touch.z}, {4.8, 4.5, 6}};
    const Status status = enclose(tern::World(world.grid, *solids), bow, 4);
    ASSERT_EQ(status, depth < 1e-8 ? Status::kOk : Status::kCorridorBlocked) << depth;
    if (status != Status::kOk) continue;
    expect_holds({bow, 4});
    EXPECT_EQ(out_.count, 7) << "the box around the hull and the face";
    EXPECT_NEAR(out_.planes[6].offset, depth - 4 * 11.0 / 7.0, 1e-12);
  }
}

}  // namespace
}  // namespace tern_test
