// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What holds for every programme: slices, a dirty workspace and a warm start change nothing that matters.
#include <gtest/gtest.h>

#include <cstring>

#include "support/random_corridor.hpp"

namespace {

using tern::Status;
using namespace tern_test;

/// Programmes of every kind: loose, tight, contradictory, corridors.
void make_programme(Random& random, QpBench& bench) {
  if (random.chance(0.2)) {
    tern_host::CorridorProgramme(random_corridor(random, random.integer(1, 6), 3.0), false).assemble(*bench.problem);
    return;
  }
  QpRecipe recipe;
  recipe.unknowns = random.integer(1, 14);
  recipe.groups = random.integer(1, 5);
  recipe.points = random.integer(1, 9);
  recipe.planes = random.integer(1, 10);
  recipe.room = random.real(-0.2, 1.0);
  random_programme(random, recipe, bench);
}

struct Answer {
  Status status;
  std::vector<double> numbers;
  std::vector<int> rows;
};

Answer answer_of(Status status, const QpBench& bench) {
  const tern::QpSolution& s = *bench.solution;
  Answer answer{status, dense_unknowns(*bench.problem, s), {s.active_count, s.iterations}};
  answer.numbers.insert(answer.numbers.end(), {s.objective, s.stationarity, s.violation, s.complementarity});
  answer.numbers.insert(answer.numbers.end(), {s.farkas_gap, s.farkas_residual});
  for (int j = 0; j < s.active_count; ++j) {
    answer.numbers.push_back(s.multiplier[j]);
    answer.rows.insert(answer.rows.end(), {s.active[j].point, s.active[j].plane});
  }
  return answer;
}

/// Equal to the last bit.
void expect_same(const Answer& a, const Answer& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.rows, b.rows);
  ASSERT_EQ(a.numbers.size(), b.numbers.size());
  EXPECT_EQ(std::memcmp(a.numbers.data(), b.numbers.data(), a.numbers.size() * sizeof(double)), 0);
}

TEST(QpContract, SlicesChangeNothing) {
  Random random(21);
  QpBench bench;
  for (int n = 0; n < scaled(500); ++n) {
    make_programme(random, bench);
    const Answer whole = answer_of(bench.solve(), bench);
    for (const std::uint32_t slice : {1u, 2u, 7u}) {
      tern::qp_begin(*bench.solver, *bench.problem, nullptr, 0);
      expect_same(whole, answer_of(bench.run(slice), bench));
    }
    if (HasFailure()) FAIL() << "programme " << n;
  }
}

TEST(QpContract, StopsAfterAnyIterationAndGoesOn) {
  Random random(22);
  QpBench bench;
  for (int n = 0; n < scaled(60); ++n) {
    make_programme(random, bench);
    const Answer whole = answer_of(bench.solve(), bench);
    const int iterations = bench.solution->iterations;
    for (int budget = 0; budget <= iterations; ++budget) {
      tern::qp_begin(*bench.solver, *bench.problem, nullptr, 0);
      tern::Work work{0xFFFFFFFFu};
      const Status status = tern::qp_advance(*bench.solver, *bench.problem, work, *bench.solution, budget);
      ASSERT_EQ(status, budget < iterations ? Status::kRunning : whole.status);
      tern::Work none{0};
      if (status == Status::kRunning) {
        ASSERT_EQ(tern::qp_advance(*bench.solver, *bench.problem, none, *bench.solution), Status::kRunning);
      }
      expect_same(whole, answer_of(bench.run(), bench));
    }
    if (HasFailure()) FAIL() << "programme " << n;
  }
}

TEST(QpContract, ADirtyWorkspaceChangesNothing) {
  Random random(23);
  QpBench bench;
  for (int n = 0; n < scaled(200); ++n) {
    make_programme(random, bench);
    std::memset(static_cast<void*>(bench.solver.get()), 0, sizeof(tern::QpSolver));
    const Answer clean = answer_of(bench.solve(), bench);
    for (const int pattern : {0xA5, 0xFF, 0x7F}) {
      std::memset(static_cast<void*>(bench.solver.get()), pattern, sizeof(tern::QpSolver));
      expect_same(clean, answer_of(bench.solve(), bench));
    }
    if (HasFailure()) FAIL() << "programme " << n;
  }
}

TEST(QpContract, WarmStartsEndAtTheSameOptimum) {
  Random random(24);
  QpBench bench;
  for (int n = 0; n < scaled(2000); ++n) {
    make_programme(random, bench);
    const Status cold = bench.solve();
    const double objective = bench.solution->objective;
    std::vector<tern::QpConstraint> rows(bench.solution->active, bench.solution->active + bench.solution->active_count);
    for (int extra = random.integer(0, 6); extra > 0; --extra) {
      rows.push_back({random.integer(0, bench.problem->point_count), random.integer(0, bench.problem->plane_count)});
    }
    for (std::size_t k = rows.size(); k > 1; --k) {
      std::swap(rows[k - 1], rows[static_cast<std::size_t>(random.integer(0, static_cast<int>(k) - 1))]);
    }
    ASSERT_EQ(bench.solve_from(rows), cold) << "programme " << n;
    if (cold == Status::kOk) {
      ASSERT_NEAR(bench.solution->objective, objective, 1e-7 * (1.0 + std::fabs(objective))) << "programme " << n;
    }
  }
}

}  // namespace
