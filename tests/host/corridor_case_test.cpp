// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/corridor_case.hpp"

#include <gtest/gtest.h>

#include <string>

#include "host/corridor_solver.hpp"
#include "tern/config.hpp"

namespace {

using tern_host::CorridorCase;
using tern_host::parse_corridor_case;

const std::string kHead = "id line class straight\nM 2 degree 7\nvmax 10 amax 100\nstart_p 0 0 0\n";
const std::string kJoints = "wp 0 0 0\nwp 1 0 0\nwp 2 0 0\n";
const std::string kLine = kHead + "goal_p 2 0 0\nT 1 1\n" + kJoints;

std::string case_error(const std::string& text) {
  try {
    parse_corridor_case(text, "case.txt");
  } catch (const tern_host::RecordError& error) {
    return error.what();
  }
  return "";
}

TEST(CorridorCase, ReadsEveryRecord) {
  const CorridorCase c = parse_corridor_case(
      "id a class thin\nM 1 c4 0 start_jerk_fixed 0 goal_jerk_fixed 1 # free\nvmax 2 amax 6 alpha 1.5\n"
      "start_p 1 2 3\nstart_v 4 5 6\nstart_a 7 8 9\nstart_j 10 11 12\ngoal_p 13 14 15\nwarm_dp 16 17 18\nT 2.5\n"
      "wp 1 2 3\nwp 13 14 15\nhs 0 0 0 1 7\n",
      "a.txt");
  EXPECT_EQ(c.id, "a");
  EXPECT_EQ(c.kind, "thin");
  EXPECT_FALSE(c.start_jerk_fixed);
  EXPECT_TRUE(c.goal_jerk_fixed);
  EXPECT_EQ(c.v_max, 2.0);
  EXPECT_EQ(c.a_max, 6.0);
  for (int d = 0; d < 4; ++d) EXPECT_EQ(c.start[d].y, 2.0 + 3.0 * d);
  EXPECT_EQ(c.goal.z, 15.0);
  EXPECT_EQ(c.shift.x, 16.0);
  EXPECT_EQ(c.durations, std::vector<double>{2.5});
  ASSERT_EQ(c.planes.size(), 1u);
  EXPECT_EQ(c.planes[0].at(0).normal.z, 1.0);
  EXPECT_EQ(c.planes[0].at(0).offset, 7.0);
}

TEST(CorridorCase, ErrorsNameFileLineAndReason) {
  EXPECT_EQ(case_error(kLine + "hs 0 1 0 0\n"), "case.txt:10: 'hs' needs 5 numbers: segment, normal, offset, found 4");
  EXPECT_EQ(case_error(kLine + "hs 2 1 0 0 1\n"), "case.txt:10: no segment '2'; 'M' gave 2");
  EXPECT_EQ(case_error(kLine + "hs 0 1 0 0 nan\n"), "case.txt:10: 'nan' is not a finite number");
  EXPECT_EQ(case_error(kLine + "T 1 1\n"), "case.txt:10: 'T' is given twice");
  EXPECT_EQ(case_error(kLine + "turn 1\n"), "case.txt:10: unknown record 'turn'");
  EXPECT_EQ(case_error(kLine + "start_v 1 2\n"), "case.txt:10: 'start_v' needs 3 numbers, found 2");
  EXPECT_EQ(case_error(kHead + "T 1 1\n" + kJoints), "case.txt:8: the file ends without a 'goal_p'");
  EXPECT_EQ(case_error(kHead + "goal_p 2 0 0\nT 1\n" + kJoints), "case.txt:9: 'T' needs one number a segment, found 1");
  EXPECT_EQ(case_error(kHead + "T 1 0\n"), "case.txt:5: 'T' must be more than 0");
  EXPECT_EQ(case_error("M 2 c4 1\n"), "case.txt:1: 'c4' must be 0: joints are C3");
  EXPECT_EQ(case_error("M 2 degree 5\n"), "case.txt:1: 'degree' must be 7, found '5'");
  EXPECT_EQ(case_error("M 1.5\n"), "case.txt:1: '1.5' is not a count above 0");
  EXPECT_EQ(case_error("vmax 2\n"), "case.txt:1: 'vmax' needs a 'amax' with a value");
}

TEST(CorridorCase, WhatExceedsACapacityNamesTheConstant) {
  const std::string most = std::to_string(tern::kMaxSegments);
  EXPECT_EQ(case_error("M " + std::to_string(tern::kMaxSegments + 1) + "\n"),
            "case.txt:1: more than " + most + " (TERN_MAX_SEGMENTS)");
  std::string planes = kLine;
  for (int i = 0; i <= tern::kMaxPlanes; ++i) planes += "hs 1 1 0 0 5\n";
  EXPECT_NE(case_error(planes).find("(TERN_MAX_PLANES)"), std::string::npos);
}

TEST(CorridorSolver, SolvesAStraightLineFromRestToRest) {
  // One polynomial of degree 7 over 2 m and 2 s: 100800 * 2^2 / 2^7, over the Gram matrix's largest element.
  tern_host::CorridorSolver solver;
  CorridorCase c = parse_corridor_case(kLine, "line.txt");
  c.shift = {-2.0, 0.0, 0.0};
  const tern_host::CorridorAnswers answers = solver.solve(c, 2);
  EXPECT_EQ(answers.cold.status, tern::Status::kOk);
  EXPECT_NEAR(answers.cold.objective, 3150.0 / 2116800.0, 1e-12);
  EXPECT_NEAR(answers.warm.objective, 4.0 * 3150.0 / 2116800.0, 1e-12);
  EXPECT_EQ(answers.cold.iterations, 0);
  EXPECT_EQ(answers.cold.violation, 0.0);
}

}  // namespace
