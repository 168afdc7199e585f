// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a solve says of its objective while it runs is held against the objective that it ends with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/qp_random.hpp"

namespace tern_test {
namespace {

using tern::Status;

/// Bounds after every unit of work of a solve that has begun.
std::vector<double> bounds_of(QpBench& bench, Status& status) {
  std::vector<double> bounds;
  status = Status::kRunning;
  for (int k = 0; k < 10 * tern::kMaxQpIterations && status == Status::kRunning; ++k) {
    tern::Work work{1};
    status = tern::qp_advance(*bench.solver, *bench.problem, work, *bench.solution);
    const double bound = tern::qp_lower_bound(*bench.solver);
    if (bound > -tern::kQpNoBound) bounds.push_back(bound);
  }
  return bounds;
}

double size_of(const QpBench& bench) {
  double target = 0.0;
  for (int i = 0; i < bench.solver->dimension; ++i) target += bench.solver->target[i] * bench.solver->target[i];
  return 0.5 * target + std::fabs(bench.solution->objective);
}

TEST(QpLowerBound, IsNeverAboveTheObjective) {
  Random random(61);
  QpBench bench;
  int looked_at = 0;
  double tightest = 1e9;
  for (int n = 0; n < scaled(3000); ++n) {
    QpRecipe recipe;
    recipe.unknowns = random.integer(2, 14);
    recipe.planes = random.integer(3, 10);
    random_programme(random, recipe, bench);
    tern::qp_begin(*bench.solver, *bench.problem, nullptr, 0);
    Status status = Status::kRunning;
    const std::vector<double> bounds = bounds_of(bench, status);
    if (status != Status::kOk) continue;
    const double size = size_of(bench);
    for (const double bound : bounds) {
      ++looked_at;
      ASSERT_LE(bound, bench.solution->objective + 1e-9 * size) << n;
      tightest = std::min(tightest, (bench.solution->objective - bound) / (size + 1e-300));
    }
  }
  EXPECT_GT(looked_at, scaled(3000));
  EXPECT_LT(tightest, 1e-6) << "the last steps' bounds come close";
}

TEST(QpLowerBound, HoldsFromWarmStarts) {
  Random random(62);
  QpBench bench;
  for (int n = 0; n < scaled(1000); ++n) {
    QpRecipe recipe;
    recipe.unknowns = random.integer(2, 14);
    random_programme(random, recipe, bench);
    if (bench.solve() != Status::kOk) continue;
    const std::vector<tern::QpConstraint> rows(bench.solution->active,
                                               bench.solution->active + bench.solution->active_count);
    for (int a = 0; a < tern::kQpAxes; ++a) bench.problem->linear[a][0] += random.real(-1.0, 1.0);
    tern::qp_begin(*bench.solver, *bench.problem, rows.data(), static_cast<int>(rows.size()));
    Status status = Status::kRunning;
    const std::vector<double> bounds = bounds_of(bench, status);
    if (status != Status::kOk) continue;
    for (const double bound : bounds) ASSERT_LE(bound, bench.solution->objective + 1e-9 * size_of(bench)) << n;
  }
}

TEST(QpLowerBound, RisesWhereThereIsNoSolution) {
  // x = 0 is cheapest; one row wants x >= 1, another x <= -1.
  QpBench bench;
  bench.start({1.0});
  const int point = bench.add_point({0, 0, 0}, 0, {1.0});
  const int plane = bench.add_plane({-1, 0, 0}, -1.0);
  bench.add_plane({1, 0, 0}, -1.0);
  bench.add_group(point, point + 1, plane, plane + 2);
  tern::qp_begin(*bench.solver, *bench.problem, nullptr, 0);
  EXPECT_LE(tern::qp_lower_bound(*bench.solver), 0.0);
  Status status = Status::kRunning;
  const std::vector<double> bounds = bounds_of(bench, status);
  EXPECT_EQ(status, Status::kInfeasible);
  ASSERT_FALSE(bounds.empty());
  EXPECT_NEAR(*std::max_element(bounds.begin(), bounds.end()), 0.5, 1e-12);
  EXPECT_EQ(tern::qp_lower_bound(*bench.solver), -tern::kQpNoBound) << "it has ended";
}

}  // namespace
}  // namespace tern_test
