// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Programmes small enough to solve by hand.
#include <gtest/gtest.h>

#include <cmath>

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

TEST(QpSmall, AHessianOfRankOneIsSolvedWhereAMinimumExists) {
  // H = 1 1': one pivot is 1, and rounding leaves the other two 0. The sum of the unknowns is all that counts.
  QpBench bench;
  bench.start({1.0, 1.0, 1.0});
  bench.problem->hessian[1][1] = bench.problem->hessian[2][1] = bench.problem->hessian[2][2] = 1.0;
  for (int i = 0; i < 3; ++i) bench.pull(1, i, 2.0);
  EXPECT_EQ(bench.solve(), Status::kOk);
  const double* const y = bench.solution->x[1];
  EXPECT_NEAR(y[0] + y[1] + y[2], -2.0, 1e-8);
  EXPECT_NEAR(bench.solution->objective, -2.0, 1e-8);
}

TEST(QpSmall, ACoefficientWhoseSquareOverflowsIsNumerical) {
  // x <= 1 / c: without the pull, x = 0 is the answer, and with it the row must enter.
  for (const double pull : {0.0, -3.0}) {
    QpBench bench;
    bench.start({1.0});
    bench.pull(0, 0, pull);
    bench.add_point({0.0, 0.0, 0.0}, 0, {1e160});
    bench.add_plane({1.0, 0.0, 0.0}, 1.0);
    bench.add_group(0, 1, 0, 1);
    EXPECT_EQ(bench.solve(), pull < 0.0 ? Status::kNumerical : Status::kOk);
  }
}

TEST(QpSmall, AnObjectiveThatOverflowsIsNumerical) {
  // Each axis costs -f^2 / 2 = -7e307; the terms of all three axes add up to more than the largest number.
  QpBench bench;
  bench.start({1.0});
  bench.pull(0, 0, 1.2e154);
  EXPECT_EQ(bench.solve(), Status::kOk);
  EXPECT_NEAR(bench.solution->objective / -7.2e307, 1.0, 1e-12);
  bench.pull(1, 0, 1.2e154);
  bench.pull(2, 0, 1.2e154);
  EXPECT_EQ(bench.solve(), Status::kNumerical);
  EXPECT_FALSE(std::isfinite(bench.solution->objective));
}

TEST(QpSmall, TinyNormalsWhoseSquaresAreZeroProveAContradiction) {
  // x <= -1 and x >= 1, in units of 1e-170: the terms of the certificate underflow, and so its residual is none.
  QpBench bench;
  bench.start({1.0});
  bench.add_point({0.0, 0.0, 0.0}, 0, {1.0});
  bench.add_plane({1e-170, 0.0, 0.0}, -1e-170);
  bench.add_plane({-1e-170, 0.0, 0.0}, -1e-170);
  bench.add_group(0, 1, 0, 2);
  EXPECT_EQ(bench.solve(), Status::kInfeasible);
  EXPECT_EQ(bench.solution->active_count, 2);
  EXPECT_EQ(bench.solution->farkas_residual, 0.0);
  EXPECT_NEAR(bench.solution->farkas_gap / 2e-170, 1.0, 1e-12);
}

TEST(QpSmall, AContradictionWithinRoundingIsNumerical) {
  // x <= 1e6 and x >= 1e6 + 1e-9: too far apart to be met, and too near to be proven. It stalls at the same place when
  // it starts over with more care.
  QpBench bench;
  bench.start({1.0});
  bench.add_point({0.0, 0.0, 0.0}, 0, {1.0});
  bench.add_plane({1.0, 0.0, 0.0}, 1e6);
  bench.add_plane({-1.0, 0.0, 0.0}, -1e6 - 1e-9);
  bench.add_group(0, 1, 0, 2);
  EXPECT_EQ(bench.solve(), Status::kNumerical);
  EXPECT_TRUE(bench.solver->cautious);
}

TEST(QpSmall, ARowThatIsMostlyRoundingIsNumerical) {
  // The point moves by nanometres around a place where coordinates are rounded by a tenth of one.
  QpBench bench;
  bench.start({1.0});
  for (int a = 0; a < 2; ++a) bench.pull(a, 0, -4e-9);
  const tern::Vec3 place{1.1e6, 1.7e6, 0.0};
  const tern::Vec3 normal{0.6, 0.8, 0.0};
  bench.add_point(place, 0, {0.7});
  bench.add_plane(normal, normal.x * place.x + normal.y * place.y - 3e-10);
  bench.add_group(0, 1, 0, 1);
  EXPECT_EQ(bench.solve(), Status::kNumerical);
  EXPECT_EQ(bench.solution->active_count, 1);
  EXPECT_LE(bench.solution->stationarity, tern::kQpStationarity);
  EXPECT_LE(bench.solution->violation, tern::kQpViolation);
  EXPECT_GT(bench.solution->complementarity, tern::kQpComplementarity);
}

TEST(QpSmall, AContradictoryPlaneWithoutAPointIsNoRow) {
  QpBench bench;
  bench.start({1.0});
  bench.pull(0, 0, -3.0);
  bench.add_point({0.0, 0.0, 0.0}, 0, {1.0});
  bench.add_plane({1.0, 0.0, 0.0}, 1.0);
  bench.add_plane({0.0, 0.0, 0.0}, -1.0);
  bench.add_group(0, 1, 0, 1);
  bench.add_group(1, 1, 1, 2);
  EXPECT_EQ(bench.solve(), Status::kOk);
  EXPECT_NEAR(bench.solution->x[0][0], 1.0, 1e-12);
}

/// Groups that share their points: more batches than those whose prices the solver keeps. The last groups' planes are
/// the ones that count.
TEST(QpSmall, MoreBatchesThanPricesAreKept) {
  constexpr int kPoints = 24;
  QpBench bench;
  bench.start({1.0});
  for (int a = 0; a < 3; ++a) bench.pull(a, 0, a - 3.0);
  for (int k = 0; k < kPoints; ++k) bench.add_point({0.01 * k, 0.02 * k, 0.03 * k}, 0, {1.0});
  static_assert(kPoints / tern::kQpBatch * (tern::kQpMaxGroups - 3) > tern::kQpMaxBatches, "the last three are beyond");
  for (int g = 0; g < tern::kQpMaxGroups; ++g) {
    const int a = g - (tern::kQpMaxGroups - 3);
    const tern::Vec3 normal{a == 0 ? 1.0 : 0.0, a == 1 ? 1.0 : 0.0, a == 2 ? 1.0 : 0.0};
    const int plane = a < 0 ? bench.add_plane({0.6, 0.8, 0.0}, 100.0 + g) : bench.add_plane(normal, 0.9);
    bench.add_group(0, kPoints, plane, plane + 1);
  }
  EXPECT_EQ(bench.solve(), Status::kOk);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(bench.solution->x[a][0], 0.9 - 0.01 * (a + 1) * (kPoints - 1), 1e-12) << a;
  ASSERT_EQ(bench.solution->active_count, 3);
  for (int j = 0; j < 3; ++j) EXPECT_EQ(bench.solution->active[j].point, kPoints - 1);
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
