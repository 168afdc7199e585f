// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The programme's two capacities, with 12 active rows and 40 iterations.
#include <gtest/gtest.h>

#include "support/tiny_cases.hpp"

namespace {

using tern::Status;
using namespace tern_test;

/// Six unknowns per axis, each a point of its own inside `planes` planes of its own.
void separate_points(QpBench& bench) {
  bench.start({1.0, 1.0, 1.0, 1.0, 1.0, 1.0});
  for (int i = 0; i < 6; ++i) {
    bench.add_point({0.0, 0.0, 0.0}, i, {1.0});
  }
}

TEST(TinyQp, AsManyActiveRowsAsThereIsRoomForAreFound) {
  QpBench bench;
  separate_points(bench);
  bench.add_plane({-1.0, 0.0, 0.0}, -1.0);
  bench.add_plane({0.0, -1.0, 0.0}, -1.0);
  bench.add_group(0, 6, 0, 2);
  static_assert(tern::kMaxActive == 12, "six points, two planes");
  EXPECT_EQ(bench.solve(), Status::kOk);
  EXPECT_EQ(bench.solution->active_count, 12);
}

TEST(TinyQp, OneMoreIsWorkingSetFull) {
  QpBench bench;
  separate_points(bench);
  bench.add_plane({-1.0, 0.0, 0.0}, -1.0);
  bench.add_plane({0.0, -1.0, 0.0}, -1.0);
  bench.add_plane({0.0, 0.0, -1.0}, -1.0);
  bench.add_group(0, 6, 0, 3);
  EXPECT_EQ(bench.solve(), Status::kWorkingSetFull);
  EXPECT_EQ(bench.solution->active_count, tern::kMaxActive);
}

TEST(TinyQp, AContradictionIsStillProvenWithAFullWorkingSet) {
  QpBench bench;
  separate_points(bench);
  bench.add_plane({-1.0, 0.0, 0.0}, -2.0);
  bench.add_plane({0.0, -1.0, 0.0}, -2.0);
  bench.add_plane({1.0, 1.0, 0.0}, 3.5);
  bench.add_group(0, 6, 0, 2);
  bench.add_group(5, 6, 2, 3);
  EXPECT_EQ(bench.solve(), Status::kInfeasible);
  EXPECT_EQ(bench.solution->active_count, 3);
}

TEST(TinyQp, IterationsEndAtTheirLimit) {
  QpBench bench;
  Random random(31);
  int limited = 0;
  for (int n = 0; n < 200; ++n) {
    const Status status = solve_tight_programme(random, bench);
    EXPECT_LE(bench.solution->iterations, tern::kMaxQpIterations);
    EXPECT_LE(bench.solution->active_count, tern::kMaxActive + 1);
    if (status == Status::kIterationLimit) {
      EXPECT_EQ(bench.solution->iterations, tern::kMaxQpIterations);
      tern::Work work{100};
      EXPECT_EQ(tern::qp_advance(*bench.solver, *bench.problem, work, *bench.solution), Status::kIterationLimit);
      EXPECT_EQ(work.units(), 100u);
      ++limited;
    }
  }
  EXPECT_GT(limited, 0);
}

}  // namespace
