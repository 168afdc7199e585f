// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/relative_corridor.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "base/math.hpp"
#include "support/box_corridor.hpp"
#include "support/random.hpp"
#include "support/same.hpp"

namespace {

using namespace tern;
using tern_test::box_around;
using tern_test::expect_same;
using tern_test::Random;
using tern_test::scaled;

class RelativeCorridor : public testing::Test {
 protected:
  void add(const Vec3& from, const Vec3& to, double margin) {
    in_->polyhedra[in_->count++] = box_around(from, to, margin);
  }
  void move(const Vec3& origin, const Vec3& start, const Vec3& goal) {
    relative_corridor(*in_, origin, start, goal, via_joints_, *out_);
  }

  ViaJoints via_joints_;
  std::unique_ptr<Corridor> in_ = std::make_unique<Corridor>();
  std::unique_ptr<Corridor> out_ = std::make_unique<Corridor>();
};

TEST_F(RelativeCorridor, MovesHalfSpacesWithTheOrigin) {
  add({10, 20, 30}, {12, 20, 30}, 0.5);
  add({12, 20, 30}, {12, 24, 30}, 0.25);
  move({10, 20, 30}, {0, 0, 0}, {2, 4, 0});
  ASSERT_EQ(out_->count, 2);
  ASSERT_EQ(out_->polyhedra[0].count, 6);
  // Faces of the boxes, each a reserve nearer: +x, -x, +y, -y, +z, -z.
  const double first[6] = {2.5, 0.5, 0.5, 0.5, 0.5, 0.5};
  const double second[6] = {2.25, -1.75, 4.25, 0.25, 0.25, 0.25};
  for (int p = 0; p < 6; ++p) {
    EXPECT_NEAR(out_->polyhedra[0].planes[p].offset, first[p] - 1e-9, 2e-15) << p;
    EXPECT_NEAR(out_->polyhedra[1].planes[p].offset, second[p] - 1e-9, 2e-15) << p;
    expect_same(out_->polyhedra[1].planes[p].normal, in_->polyhedra[1].planes[p].normal);
  }
}

TEST_F(RelativeCorridor, EndsAreTheGivenBits) {
  add({10, 20, 30}, {12, 20, 30}, 0.5);
  add({12, 20, 30}, {12.5, 24, 30}, 0.5);
  add({12.5, 24, 30}, {13, 25, 31}, 0.5);
  // What the caller knows better than the grid: the ends before they were rounded to its frame.
  const Vec3 start{1e-17, -2e-16, 0.0};
  const Vec3 goal{3.0000000000000004, 5.0, 1.0000000000000002};
  move({10, 20, 30}, start, goal);
  expect_same(out_->polyhedra[0].from, start);
  expect_same(out_->polyhedra[0].to, {2, 0, 0});
  expect_same(out_->polyhedra[1].from, {2, 0, 0});
  expect_same(out_->polyhedra[1].to, {2.5, 4, 0});
  expect_same(out_->polyhedra[2].from, {2.5, 4, 0});
  expect_same(out_->polyhedra[2].to, goal);
}

TEST_F(RelativeCorridor, ASinglePolyhedronHasBothEnds) {
  add({10, 20, 30}, {12, 20, 30}, 0.5);
  move({10, 20, 30}, {1e-17, 0, 0}, {2, 1e-17, 0});
  expect_same(out_->polyhedra[0].from, {1e-17, 0, 0});
  expect_same(out_->polyhedra[0].to, {2, 1e-17, 0});
}

TEST_F(RelativeCorridor, ReservesOnlyWhereTheSegmentLeavesRoom) {
  add({10, 20, 30}, {12, 20, 30}, 0.0);
  in_->polyhedra[0].planes[2].offset = 20.0 + 0.4e-9;  // less than the reserve above the segment
  in_->polyhedra[0].planes[3].offset = -20.0 + 5e-9;   // and more below it
  move({10, 20, 30}, {0, 0, 0}, {2, 0, 0});
  const Halfspace* planes = out_->polyhedra[0].planes;
  EXPECT_EQ(planes[0].offset, 2.0) << "through the goal";
  EXPECT_EQ(planes[1].offset, 0.0) << "through the start";
  EXPECT_EQ(planes[2].offset, 0.0) << "no further than the segment";
  EXPECT_NEAR(planes[3].offset, 4e-9, 5e-15);
}

TEST_F(RelativeCorridor, HoldsStartAndGoalExactlyFarFromTheOrigin) {
  Random random(71);
  for (int i = 0; i < scaled(500); ++i) {
    const Vec3 origin{random.real(-1e7, 1e7), random.real(-1e7, 1e7), random.real(-1e7, 1e7)};
    const Vec3 goal{random.real(-9, 9), random.real(-9, 9), random.real(-9, 9)};
    Polyhedron& polyhedron = in_->polyhedra[0];
    in_->count = 1;
    polyhedron.from = origin;
    polyhedron.to = origin + goal;
    polyhedron.count = 0;
    // Oblique planes through the start or the goal, in the grid's frame: rounded to nanometres there.
    for (int p = 0; p < 8; ++p) {
      Vec3 n{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
      n = (1.0 / length(n)) * n;
      const Vec3& through = dot(n, goal) > 0.0 ? polyhedron.to : polyhedron.from;
      polyhedron.planes[polyhedron.count++] = {n, dot(n, through)};
    }
    move(origin, {0, 0, 0}, goal);
    for (int p = 0; p < 8; ++p) {
      const Halfspace& plane = out_->polyhedra[0].planes[p];
      ASSERT_GE(plane.offset, 0.0) << p;
      ASSERT_GE(plane.offset, dot(plane.normal, goal)) << p;
      // Rounding of three products of 1e7 m apart, it is the plane that it was.
      ASSERT_LE(plane.offset, larger(0.0, dot(plane.normal, goal)) + 2e-8) << p;
    }
  }
}

}  // namespace
