// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Programmes of one unknown, solved by hand.
#include <gtest/gtest.h>

#include <limits>

#include "support/qp_dense.hpp"

namespace {

using tern::Status;
using tern_test::QpBench;

/// One unknown: minimise |p|^2 / 2 - (3, 2, 1) . p over the point p itself.
class OnePoint : public ::testing::Test {
 protected:
  OnePoint() {
    bench.start({1.0});
    bench.pull(0, 0, -3.0);
    bench.pull(1, 0, -2.0);
    bench.pull(2, 0, -1.0);
    bench.add_point({0.0, 0.0, 0.0}, 0, {1.0});
  }
  /// The point inside all planes added so far.
  void bound() { bench.add_group(0, 1, 0, bench.problem->plane_count); }
  void expect_point(double x, double y, double z) {
    EXPECT_NEAR(bench.solution->x[0][0], x, 1e-12);
    EXPECT_NEAR(bench.solution->x[1][0], y, 1e-12);
    EXPECT_NEAR(bench.solution->x[2][0], z, 1e-12);
  }
  QpBench bench;
};

TEST_F(OnePoint, WithoutRowsIsTheUnconstrainedMinimum) {
  EXPECT_EQ(bench.solve(), Status::kOk);
  expect_point(3.0, 2.0, 1.0);
  EXPECT_NEAR(bench.solution->objective, -7.0, 1e-12);
  EXPECT_EQ(bench.solution->active_count, 0);
  EXPECT_EQ(bench.solution->iterations, 0);
}

TEST_F(OnePoint, StopsAtAPlane) {
  bench.add_plane({1.0, 0.0, 0.0}, 1.0);
  bound();
  EXPECT_EQ(bench.solve(), Status::kOk);
  expect_point(1.0, 2.0, 1.0);
  ASSERT_EQ(bench.solution->active_count, 1);
  EXPECT_NEAR(bench.solution->multiplier[0], 2.0, 1e-12);
  EXPECT_NEAR(bench.solution->objective, -5.0, 1e-12);
}

TEST_F(OnePoint, MultipliersBelongToTheRowAsGiven) {
  bench.add_plane({4.0, 0.0, 0.0}, 4.0);
  bound();
  EXPECT_EQ(bench.solve(), Status::kOk);
  expect_point(1.0, 2.0, 1.0);
  EXPECT_NEAR(bench.solution->multiplier[0], 0.5, 1e-12);
}

TEST_F(OnePoint, AnInactivePlaneChangesNothing) {
  bench.add_plane({1.0, 1.0, 1.0}, 100.0);
  bound();
  EXPECT_EQ(bench.solve(), Status::kOk);
  expect_point(3.0, 2.0, 1.0);
  EXPECT_EQ(bench.solution->active_count, 0);
  EXPECT_LE(bench.solution->violation, 0.0);
}

TEST_F(OnePoint, AVertexHoldsWithMorePlanesThanItNeeds) {
  for (int i = 0; i < 2; ++i) {
    bench.add_plane({1.0, 0.0, 0.0}, 1.0);
    bench.add_plane({0.0, 1.0, 0.0}, 1.0);
    bench.add_plane({0.0, 0.0, 1.0}, 1.0);
    bench.add_plane({1.0, 1.0, 0.0}, 2.0);
    bench.add_plane({1.0, 1.0, 1.0}, 3.0);
  }
  bound();
  EXPECT_EQ(bench.solve(), Status::kOk);
  expect_point(1.0, 1.0, 1.0);
  EXPECT_NEAR(bench.solution->objective, 1.5 - 6.0, 1e-12);
}

TEST_F(OnePoint, ARowThatEnteredMayLeaveAgain) {
  // The first plane is violated most, yet the second alone decides.
  bench.add_plane({0.6, 0.8, 0.0}, 1.0);
  bench.add_plane({1.0, 0.0, 0.0}, -3.0);
  bound();
  EXPECT_EQ(bench.solve(), Status::kOk);
  expect_point(-3.0, 2.0, 1.0);
  ASSERT_EQ(bench.solution->active_count, 1);
  EXPECT_EQ(bench.solution->active[0].plane, 1);
  EXPECT_NEAR(bench.solution->multiplier[0], 6.0, 1e-12);
}

TEST_F(OnePoint, OppositePlanesThatMeetLeaveASlab) {
  bench.add_plane({1.0, 0.0, 0.0}, 1.0);
  bench.add_plane({-1.0, 0.0, 0.0}, -1.0);
  bound();
  EXPECT_EQ(bench.solve(), Status::kOk);
  expect_point(1.0, 2.0, 1.0);
}

TEST_F(OnePoint, OppositePlanesApartAreInfeasibleByTheirSum) {
  bench.add_plane({2.0, 0.0, 0.0}, 2.0);
  bench.add_plane({-1.0, 0.0, 0.0}, -1.5);
  bound();
  EXPECT_EQ(bench.solve(), Status::kInfeasible);
  // 2 x <= 2 and -x <= -1.5: half the first plus the second is 0 <= -0.5.
  ASSERT_EQ(bench.solution->active_count, 2);
  for (int j = 0; j < 2; ++j) {
    EXPECT_NEAR(bench.solution->multiplier[j], bench.solution->active[j].plane == 0 ? 0.5 : 1.0, 1e-12);
  }
  EXPECT_NEAR(bench.solution->farkas_gap, 0.5, 1e-12);
  EXPECT_LE(bench.solution->farkas_residual, 1e-15);
}

TEST_F(OnePoint, FourPlanesOfAnEmptyTetrahedronAreInfeasible) {
  bench.add_plane({1.0, 0.0, 0.0}, -1.0);
  bench.add_plane({0.0, 1.0, 0.0}, -1.0);
  bench.add_plane({0.0, 0.0, 1.0}, -1.0);
  bench.add_plane({-1.0, -1.0, -1.0}, 2.0);
  bound();
  EXPECT_EQ(bench.solve(), Status::kInfeasible);
  EXPECT_NEAR(bench.solution->farkas_gap, 1.0, 1e-12);
  EXPECT_EQ(bench.solution->active_count, 4);
}

TEST_F(OnePoint, TiesGoToTheLowestRow) {
  bench.pull(1, 0, -3.0);
  bench.pull(2, 0, -3.0);
  bench.add_plane({0.0, 0.0, 1.0}, 1.0);
  bench.add_plane({0.0, 1.0, 0.0}, 1.0);
  bench.add_plane({1.0, 0.0, 0.0}, 1.0);
  bound();
  EXPECT_EQ(bench.solve(), Status::kOk);
  ASSERT_EQ(bench.solution->active_count, 3);
  for (int j = 0; j < 3; ++j) EXPECT_EQ(bench.solution->active[j].plane, j);
}

TEST_F(OnePoint, AZeroNormalWithRoomIsNoRow) {
  bench.add_plane({0.0, 0.0, 0.0}, 0.0);
  bench.add_plane({0.0, 0.0, 0.0}, 1.0);
  bound();
  EXPECT_EQ(bench.solve(), Status::kOk);
  expect_point(3.0, 2.0, 1.0);
}

TEST_F(OnePoint, AZeroNormalWithoutRoomIsItsOwnCertificate) {
  bench.add_plane({1.0, 0.0, 0.0}, 1.0);
  bench.add_plane({0.0, 0.0, 0.0}, -1e-30);
  bound();
  EXPECT_EQ(bench.solve(), Status::kInfeasible);
  ASSERT_EQ(bench.solution->active_count, 1);
  EXPECT_EQ(bench.solution->active[0].plane, 1);
  EXPECT_NEAR(bench.solution->farkas_gap, 1e-30, 1e-40);
}

TEST_F(OnePoint, AZeroNormalOutsideEveryGroupIsNotARow) {
  bound();
  bench.add_plane({0.0, 0.0, 0.0}, -1.0);
  EXPECT_EQ(bench.solve(), Status::kOk);
}

TEST_F(OnePoint, TinyAndHugeNormalsCountByTheirDirection) {
  bench.add_plane({1e-160, 0.0, 0.0}, 1e-160);
  bench.add_plane({0.0, 1e160, 0.0}, 1e160);
  bound();
  EXPECT_EQ(bench.solve(), Status::kOk);
  expect_point(1.0, 1.0, 1.0);
}

TEST_F(OnePoint, ConstantPointsAreOnlyChecked) {
  bench.add_point({1.0, 1.0, 1.0}, 0, {});
  bench.add_point({1.0, 1.0, 1.0}, 0, {0.0});
  bench.add_plane({1.0, 0.0, 0.0}, 2.0);
  bench.add_group(1, 3, 0, 1);
  EXPECT_EQ(bench.solve(), Status::kOk);
  expect_point(3.0, 2.0, 1.0);
  for (int point = 1; point <= 2; ++point) {
    bench.problem->points[point].offset.x = 2.0 + 2e-9;
    EXPECT_EQ(bench.solve(), Status::kInfeasible);
    ASSERT_EQ(bench.solution->active_count, 1);
    EXPECT_EQ(bench.solution->active[0].point, point);
    EXPECT_NEAR(bench.solution->farkas_gap, 2e-9, 1e-15);
    bench.problem->points[point].offset.x = 2.0;
  }
}

TEST_F(OnePoint, WarmStartTakesAnyRows) {
  bench.add_plane({1.0, 0.0, 0.0}, 1.0);
  bench.add_plane({1.0, 0.0, 0.0}, 1.0);
  bench.add_plane({-1.0, 0.0, 0.0}, 5.0);
  bench.add_plane({0.0, 0.0, 0.0}, 5.0);
  bound();
  // The optimal row, its twin, a row that would pull, one without direction, and three that do not exist.
  EXPECT_EQ(bench.solve_from({{0, 2}, {0, 0}, {0, 1}, {0, 3}, {0, 7}, {-1, 0}, {5, -5}}), Status::kOk);
  expect_point(1.0, 2.0, 1.0);
  EXPECT_EQ(bench.solve_from({{0, 0}}), Status::kOk);
  EXPECT_EQ(bench.solution->iterations, 1);
}

TEST_F(OnePoint, ProgrammesThatAreNoneAreNumerical) {
  bench.add_plane({1.0, 0.0, 0.0}, 1.0);
  bound();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, 0.0, -1.0}) {
    bench.problem->hessian[0][0] = bad;
    EXPECT_EQ(bench.solve(), Status::kNumerical);
  }
  bench.problem->hessian[0][0] = 1.0;
  for (const double bad : {nan, infinity, -infinity}) {
    bench.problem->planes[0].offset = bad;
    EXPECT_EQ(bench.solve(), Status::kNumerical);
    bench.problem->planes[0].offset = 1.0;
    bench.problem->planes[0].normal.y = bad;
    EXPECT_EQ(bench.solve(), Status::kNumerical);
    bench.problem->planes[0].normal.y = 0.0;
    bench.pull(0, 0, bad);
    EXPECT_EQ(bench.solve(), Status::kNumerical);
    bench.pull(0, 0, -3.0);
    bench.problem->points[0].coefficient[0] = bad;
    EXPECT_EQ(bench.solve(), Status::kNumerical);
    bench.problem->points[0].coefficient[0] = 1.0;
    bench.problem->points[0].offset.x = bad;
    EXPECT_EQ(bench.solve(), Status::kNumerical);
    bench.problem->points[0].offset.x = 0.0;
  }
  EXPECT_EQ(bench.solve(), Status::kOk);
}

}  // namespace
