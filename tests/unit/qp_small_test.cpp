// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Programmes small enough to solve by hand.
#include <gtest/gtest.h>

#include <limits>

#include "support/qp_dense.hpp"

namespace {

using tern::Status;
using tern_test::QpBench;

TEST(QpSmall, NoUnknownsLeaveOnlyChecks) {
  QpBench bench;
  bench.start({});
  EXPECT_EQ(bench.solve(), Status::kOk);
  bench.add_point({1.0, 2.0, 3.0}, 0, {});
  bench.add_plane({0.0, 0.0, 2.0}, 6.0);
  bench.add_group(0, 1, 0, 1);
  EXPECT_EQ(bench.solve(), Status::kOk);
  bench.problem->planes[0].offset = 5.0;
  EXPECT_EQ(bench.solve(), Status::kInfeasible);
  EXPECT_NEAR(bench.solution->farkas_gap, 1.0, 1e-12);
}

TEST(QpSmall, CoupledUnknownsMoveTogether) {
  // H = [2 -1; -1 2]: a row on the second unknown drags the first along by half.
  QpBench bench;
  bench.start({2.0, 2.0});
  bench.problem->hessian[1][1] = -1.0;
  bench.add_point({0.0, 0.0, 0.0}, 1, {1.0});
  bench.add_plane({0.0, -1.0, 0.0}, -4.0);
  bench.add_group(0, 1, 0, 1);
  EXPECT_EQ(bench.solve(), Status::kOk);
  EXPECT_NEAR(bench.solution->x[1][1], 4.0, 1e-12);
  EXPECT_NEAR(bench.solution->x[1][0], 2.0, 1e-12);
  EXPECT_NEAR(bench.solution->x[0][0], 0.0, 1e-12);
  EXPECT_NEAR(bench.solution->multiplier[0], 6.0, 1e-12);
  EXPECT_NEAR(bench.solution->objective, 12.0, 1e-12);
}

TEST(QpSmall, PricingPrefersTheCheaperWay) {
  // Two unknowns, one stiff: both rows are violated by 1, meeting the stiff one costs more and so enters first.
  QpBench bench;
  bench.start({1.0, 100.0});
  bench.add_point({0.0, 0.0, 0.0}, 0, {1.0});
  bench.add_point({0.0, 0.0, 0.0}, 1, {1.0});
  bench.add_plane({1.0, 0.0, 0.0}, -1.0);
  bench.add_group(0, 2, 0, 1);
  EXPECT_EQ(bench.solve(), Status::kOk);
  ASSERT_EQ(bench.solution->active_count, 2);
  EXPECT_EQ(bench.solution->active[0].point, 1);
  EXPECT_NEAR(bench.solution->objective, 50.5, 1e-12);
}

TEST(QpSmall, AnIndefiniteHessianIsNumerical) {
  QpBench bench;
  bench.start({1.0, 1.0});
  bench.problem->hessian[1][1] = 2.0;
  EXPECT_EQ(bench.solve(), Status::kNumerical);
  EXPECT_EQ(bench.solution->active_count, 0);
}

TEST(QpSmall, ASingularHessianIsSolvedWhereAMinimumExists) {
  // H = [1 1; 1 1] is flat along (1, -1): pulling that way has no end, pulling along (1, 1) has.
  QpBench bench;
  bench.start({1.0, 1.0});
  bench.problem->hessian[1][1] = 1.0;
  bench.pull(0, 0, 1.0);
  bench.pull(0, 1, -1.0);
  EXPECT_EQ(bench.solve(), Status::kNumerical);
  bench.pull(0, 1, 1.0);
  EXPECT_EQ(bench.solve(), Status::kOk);
  EXPECT_NEAR(bench.solution->x[0][0] + bench.solution->x[0][1], -1.0, 1e-8);
  EXPECT_NEAR(bench.solution->objective, -0.5, 1e-8);
}

/// Planes through one point, their normals small integers: every row ties with many others at the optimum.
TEST(QpSmall, DegenerateVerticesDoNotCycle) {
  for (const int size : {1, 2}) {
    QpBench bench;
    bench.start({1.0, 1.0});
    bench.problem->hessian[1][1] = 0.5;
    for (int c = 0; c < 3; ++c) bench.pull(c, 0, c - 3.0);
    bench.add_point({0.0, 0.0, 0.0}, 0, {1.0});
    bench.add_point({0.0, 0.0, 0.0}, 0, {1.0, 1.0});
    bench.add_point({0.0, 0.0, 0.0}, 0, {1.0, -1.0});
    for (int x = -size; x <= size; ++x) {
      for (int y = -size; y <= size; ++y) {
        for (int z = -size; z <= size; ++z) bench.add_plane({1.0 * x, 1.0 * y, 1.0 * z}, 0.0);
      }
    }
    bench.add_group(0, 3, 0, bench.problem->plane_count);
    EXPECT_EQ(bench.solve(), Status::kOk);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(bench.solution->x[c][0], 0.0, 1e-9);
    EXPECT_NEAR(bench.solution->objective, 0.0, 1e-9);
    EXPECT_LE(bench.solution->iterations, 40);
  }
}

}  // namespace
