// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Corridor programmes from files, against verdicts and objectives that several independent solvers agreed on.
#include <gtest/gtest.h>

#include "support/corridor_qp_case.hpp"
#include "support/qp_dense.hpp"

namespace {

using tern::Status;
using namespace tern_test;

class QpCorridor : public ::testing::Test {
 protected:
  void SetUp() override {
    lines = read_reference(folder + "reference.csv");
    if (lines.empty()) GTEST_SKIP() << "no corridor programmes in " << folder;
  }

  /// False for a case that this configuration has no room for.
  bool load(const std::string& id) {
    c = CorridorQpCase{};
    EXPECT_TRUE(read_case(folder + id + ".txt", c)) << id;
    return c.segments <= tern::kMaxSegments;
  }

  void expect_answer(bool moved, Status status, bool feasible, double objective) {
    SCOPED_TRACE(c.id + (moved ? " moved" : ""));
    ASSERT_EQ(status, feasible ? Status::kOk : Status::kInfeasible);
    if (!feasible) {
      EXPECT_GT(certified_radius(expand(*bench.problem), *bench.solution), 1e4);
      return;
    }
    const CorridorQp programme(c, moved);
    EXPECT_NEAR(programme.objective(*bench.solution), objective, 1e-6 * objective);
    EXPECT_LE(programme.violation(*bench.solution), 1e-9);
  }

  const std::string folder = TERN_SHARED_DIR "/cases/corridor_qp/";
  std::vector<CorridorQpReference> lines;
  CorridorQpCase c;
  QpBench bench;
};

TEST_F(QpCorridor, ColdAnswersAgreeWithTheReference) {
  for (const CorridorQpReference& line : lines) {
    if (!load(line.id)) continue;
    CorridorQp(c, false).assemble(*bench.problem);
    expect_answer(false, bench.solve(), line.feasible, line.objective);
  }
}

TEST_F(QpCorridor, AnswersFromTheUnshiftedFactorsAgree) {
  for (const CorridorQpReference& line : lines) {
    if (!load(line.id)) continue;
    CorridorQp(c, false).assemble(*bench.problem);
    bench.solve();
    CorridorQp(c, true).assemble(*bench.problem);
    tern::qp_begin_shifted(*bench.solver, *bench.problem);
    expect_answer(true, bench.run(), line.warm_feasible, line.warm_objective);
  }
}

TEST_F(QpCorridor, AnswersFromTheUnshiftedRowsAgree) {
  for (const CorridorQpReference& line : lines) {
    if (!load(line.id)) continue;
    CorridorQp(c, false).assemble(*bench.problem);
    bench.solve();
    const std::vector<tern::QpRow> rows(bench.solution->active, bench.solution->active + bench.solution->active_count);
    CorridorQp(c, true).assemble(*bench.problem);
    expect_answer(true, bench.solve_from(rows), line.warm_feasible, line.warm_objective);
  }
}

}  // namespace
