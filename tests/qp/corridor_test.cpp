// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Corridor programmes from files, against verdicts and objectives that several independent solvers agreed on.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "host/corridor_programme.hpp"
#include "support/qp_dense.hpp"

namespace {

using tern::Status;
using tern_host::CorridorProgramme;
using namespace tern_test;

/// A line of reference.csv; `warm` is of the shifted start.
struct CorridorQpReference {
  std::string id;
  bool feasible = false;
  double objective = 0.0;
  bool warm_feasible = false;
  double warm_objective = 0.0;
};

std::vector<CorridorQpReference> read_reference(const std::string& path) {
  std::vector<CorridorQpReference> lines;
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');) fields.push_back(field);
    if (fields.size() < 8) continue;
    const auto number = [](const std::string& text) { return text.empty() ? 0.0 : std::stod(text); };
    lines.push_back(
        {fields[0], fields[1] == "feasible", number(fields[2]), fields[5] == "feasible", number(fields[6])});
  }
  return lines;
}

class QpCorridor : public ::testing::Test {
 protected:
  void SetUp() override {
    lines = read_reference(folder + "reference.csv");
    if (lines.empty()) GTEST_SKIP() << "no corridor programmes in " << folder;
  }

  /// False for a case that this configuration has no room for.
  bool load(const std::string& id) {
    try {
      c = tern_host::read_corridor_case(folder + id + ".txt");
    } catch (const tern_host::RecordError& error) {
      EXPECT_NE(error.reason().find("TERN_MAX_"), std::string::npos) << error.what();
      return false;
    }
    return true;
  }

  void expect_answer(bool moved, Status status, bool feasible, double objective) {
    SCOPED_TRACE(c.id + (moved ? " moved" : ""));
    ASSERT_EQ(status, feasible ? Status::kOk : Status::kInfeasible);
    if (!feasible) {
      EXPECT_GT(certified_radius(expand(*bench.problem), *bench.solution), 1e4);
      return;
    }
    const CorridorProgramme programme(c, moved);
    EXPECT_NEAR(programme.objective(*bench.solution), objective, 1e-6 * objective);
    EXPECT_LE(programme.violation(*bench.solution), 1e-9);
  }

  const std::string folder = TERN_SHARED_DIR "/cases/corridor_qp/";
  std::vector<CorridorQpReference> lines;
  tern_host::CorridorCase c;
  QpBench bench;
};

TEST_F(QpCorridor, ColdAnswersAgreeWithTheReference) {
  for (const CorridorQpReference& line : lines) {
    if (!load(line.id)) continue;
    CorridorProgramme(c, false).assemble(*bench.problem);
    expect_answer(false, bench.solve(), line.feasible, line.objective);
  }
}

TEST_F(QpCorridor, AnswersFromTheUnshiftedRowsAgree) {
  for (const CorridorQpReference& line : lines) {
    if (!load(line.id)) continue;
    CorridorProgramme(c, false).assemble(*bench.problem);
    bench.solve();
    const std::vector<tern::QpConstraint> rows(bench.solution->active,
                                               bench.solution->active + bench.solution->active_count);
    CorridorProgramme(c, true).assemble(*bench.problem);
    expect_answer(true, bench.solve_from(rows), line.warm_feasible, line.warm_objective);
  }
}

}  // namespace
