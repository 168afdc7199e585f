// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every answer is judged without the solver: a point with small KKT residuals is optimal, a Farkas certificate is a
// proof, and small programmes are solved again by trying every active set.
#include <gtest/gtest.h>

#include "support/random_corridor.hpp"

namespace {

using tern::Status;
using namespace tern_test;

QpRecipe random_recipe(Random& random, int most_unknowns) {
  QpRecipe recipe;
  recipe.unknowns = random.integer(1, most_unknowns);
  recipe.groups = random.integer(1, 4);
  recipe.points = random.integer(1, 9);
  recipe.planes = random.integer(1, 10);
  recipe.scale = random.chance(0.5) ? 1.0 : std::pow(10.0, random.real(0.0, 6.0));
  recipe.room = random.chance(0.3) ? 0.0 : random.real(0.0, 2.0);
  return recipe;
}

/// The answer's status is right by its own evidence.
void expect_proven(const QpBench& bench, Status status) {
  const DenseQp dense = expand(*bench.problem);
  if (status == Status::kOk) {
    const Kkt kkt = judge(dense, *bench.problem, *bench.solution);
    EXPECT_TRUE(kkt.rows_known);
    EXPECT_LE(kkt.stationarity, 1e-8);
    EXPECT_LE(kkt.violation, 1e-9);
    EXPECT_LE(kkt.gap, 1e-8);
    EXPECT_GE(kkt.sign, 0.0);
  }
  if (status == Status::kInfeasible) {
    EXPECT_GT(certified_radius(dense, *bench.solution), 100.0);
    EXPECT_GT(bench.solution->farkas_gap, 0.0);
  }
}

TEST(QpRandom, FeasibleProgrammesAreSolved) {
  Random random(11);
  QpBench bench;
  int active = 0;
  int declined = 0;
  const int cases = scaled(10000);
  for (int n = 0; n < cases; ++n) {
    random_programme(random, random_recipe(random, 16), bench);
    const Status status = bench.solve();
    ASSERT_TRUE(status == Status::kOk || status == Status::kNumerical) << "programme " << n;
    expect_proven(bench, status);
    if (HasFailure()) FAIL() << "programme " << n;
    active += bench.solution->active_count;
    declined += status == Status::kNumerical ? 1 : 0;
  }
  EXPECT_GT(active, cases);
  EXPECT_LE(declined, 1 + cases / 2000);
}

TEST(QpRandom, ContradictionsAreProven) {
  Random random(12);
  QpBench bench;
  int infeasible = 0;
  int declined = 0;
  const int cases = scaled(10000);
  for (int n = 0; n < cases; ++n) {
    QpRecipe recipe = random_recipe(random, 8);
    recipe.room = random.real(-1.0, -0.01);
    random_programme(random, recipe, bench);
    const Status status = bench.solve();
    expect_proven(bench, status);
    if (HasFailure()) FAIL() << "programme " << n;
    infeasible += status == Status::kInfeasible ? 1 : 0;
    declined += status != Status::kInfeasible && status != Status::kOk ? 1 : 0;
  }
  EXPECT_GT(infeasible, cases / 4);
  EXPECT_LE(declined, 1 + cases / 1000);
}

TEST(QpRandom, SmallProgrammesAgreeWithEnumeration) {
  Random random(13);
  QpBench bench;
  for (int n = 0; n < scaled(3000); ++n) {
    QpRecipe recipe;
    recipe.unknowns = 1;
    recipe.groups = random.integer(1, 2);
    recipe.points = 2;
    recipe.planes = 4;
    recipe.room = random.real(-0.3, 1.0);
    random_programme(random, recipe, bench);
    const DenseQp dense = expand(*bench.problem);
    const auto x = enumerate(dense, 1e-7);
    const Status status = bench.solve();
    expect_proven(bench, status);
    if (x) {
      ASSERT_EQ(status, Status::kOk) << "programme " << n;
      const double best = dense_objective(dense, *x);
      ASSERT_NEAR(bench.solution->objective, best, 1e-6 * (1.0 + std::fabs(best))) << "programme " << n;
    } else {
      // Enumeration cannot tell "infeasible" from "all vertices singular": the certificate can.
      ASSERT_TRUE(status == Status::kInfeasible || status == Status::kOk) << "programme " << n;
    }
  }
}

TEST(QpRandom, CorridorsWithUnequalDurationsAreSolved) {
  Random random(14);
  QpBench bench;
  for (int n = 0; n < scaled(400); ++n) {
    tern_host::CorridorProgramme(random_corridor(random, random.integer(2, 10), 100.0), false).assemble(*bench.problem);
    const Status status = bench.solve();
    ASSERT_EQ(status, Status::kOk) << "corridor " << n;
    expect_proven(bench, status);
    if (HasFailure()) FAIL() << "corridor " << n;
  }
}

TEST(QpRandom, DurationsFourDecadesApartAreSolvedOrDeclined) {
  // Rounding leaves little of the long segments' part of H; whatever is answered, flying straight is feasible.
  Random random(15);
  QpBench bench;
  int solved = 0;
  const int cases = scaled(400);
  for (int n = 0; n < cases; ++n) {
    tern_host::CorridorProgramme(random_corridor(random, random.integer(2, 10), 1e4), false).assemble(*bench.problem);
    const Status status = bench.solve();
    ASSERT_TRUE(status == Status::kOk || status == Status::kNumerical) << "corridor " << n;
    if (status == Status::kOk) {
      const DenseQp dense = expand(*bench.problem);
      ASSERT_LE(dense_violation(dense, dense_unknowns(*bench.problem, *bench.solution)), 1e-9) << "corridor " << n;
    }
    solved += status == Status::kOk ? 1 : 0;
  }
  EXPECT_GT(solved, cases * 4 / 5);
}

}  // namespace
