// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/met_text.hpp"

#include <gtest/gtest.h>

namespace {

using tern::Status;
using tern_host::describe_met;
using tern_host::PlanResult;

/// The answer of a planner that met thing 0, or fence 0, after 4 s on a plan that begins at 1 s.
std::string met(const std::string& records, Status status = Status::kNoClearTime) {
  PlanResult result;
  result.scenario = tern_host::parse_scenario(
      "boundary 0 0 0 20 10 4\nstart 2 5 2\ngoal 18 5 2\nradius 0.3\nstart_time 1\n" + records, "things.txt");
  result.report.status = status;
  (result.scenario.tracks.empty() ? result.report.fence : result.report.track) = 0;
  result.report.conflict = 4.0;
  return describe_met(result);
}

/// What moves on, leaves, or has not come to where it stays may be waited for.
TEST(MetText, AdvisesToWaitForWhatLeaves) {
  const std::string when = "; track: man, 4 s after the beginning";
  EXPECT_EQ(met("track man ball 1 at 9 5 2 velocity 0 0.1 0\n"), when + "; wait, or choose another goal");
  EXPECT_EQ(met("track man ball 1 at 9 5 2 velocity 0 0.1 0 error 0.1 0.1 0\n"),
            when + "; wait, or choose another goal");
  EXPECT_EQ(met("track man ball 1 at 9 5 2 until 500 gone\n"),
            when + "; it is there until 500.000 s of the clock; wait, or choose another goal");
  EXPECT_EQ(met("track man ball 1 at 9 5 2 velocity 0 0.1 0 until 5.1 stays\n"),
            when + "; wait, or choose another goal");
  EXPECT_EQ(met("track man ball 1 at 18 5 2 until 9 gone\n", Status::kGoalCovered),
            when + "; the goal was not found free within an hour; it is there until 9.000 s of the clock");
  EXPECT_EQ(met("track man ball 1 at 2 5 2\n", Status::kStartInContact), when);
  EXPECT_EQ(met("track man ball 1 at 2 5 2\n", Status::kNoPath), "");
}

TEST(MetText, SaysWhatStaysForGood) {
  const std::string stays =
      "; track: man, 4 s after the beginning; it stays there for good, so waiting does not help: ";
  const std::string leaves = ", or say when it leaves (`until T gone`)";
  const std::string around = stays + "choose another goal, make it a `block` to find ways around it" + leaves;
  EXPECT_EQ(met("track man ball 1 at 9 5 2\n"), around);
  EXPECT_EQ(met("track man ball 1 at 9 5 2 velocity 0 0.1 0 until 5 stays\n"), around);
  const std::string zeros = " 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n";
  EXPECT_EQ(met("track man ball 1 from 1\ntrack_piece man 4" + zeros), around);
  EXPECT_NE(met("track man ball 1 from 1\ntrack_piece man 4.1" + zeros), around);
  EXPECT_EQ(met("track man ball 1 at 18 5 2\n", Status::kGoalCovered), stays + "choose another goal" + leaves);
}

/// Errors of 0.1 + 0.2 t + t^2 / 2 after 4 s, of 0.1 + 1.5 t, and of 2 m/s since 2 s ago.
TEST(MetText, SaysWhatGrowsWithoutEnd) {
  const std::string when = "; track: car, 4 s after the beginning";
  const std::string anew =
      " by then, so waiting does not help for long: measure it anew, or say when it leaves "
      "(`until T gone`)";
  EXPECT_EQ(met("track car ball 1 at 9 5 2 velocity 9 0 0 error 0.1 0.2 1\n"),
            when + "; its error grows without end, to 8.90 m" + anew);
  EXPECT_EQ(met("track car ball 1 at 9 5 2 velocity 1 0 0 error 0.1 1.5 0\n"),
            when + "; its error grows without end, to 6.10 m" + anew);
  EXPECT_EQ(met("track car ball 1 at 9 5 2 reach 2 until 3 reach\n"),
            when + "; it stays there for good, and its error grows without end, to 4.00 m" + anew);
}

/// The clearance is 0.3 m, and man a ball of 1 m: vias are covered up to 1.3 m away, less their tolerance.
TEST(MetText, NamesTheViasThatAreCovered) {
  const std::string man = "track man ball 1 at 9 5 2 until 9 gone\n";
  const std::string covered = "; it covers via ";
  EXPECT_NE(met(man + "via 10.2 5 2\nvia 4 5 2\nvia 9 6.2 2\n").find(covered + "1, 3 then"), std::string::npos);
  EXPECT_EQ(met(man + "via 10.4 5 2\n").find(covered), std::string::npos);
  EXPECT_EQ(met(man + "via 10.2 5 2 0.2\n").find(covered), std::string::npos);
  EXPECT_EQ(met("track man ball 1 at 9 5 2 until 4 gone\nvia 9 5 2\n").find(covered), std::string::npos);
  EXPECT_NE(met("track man ball 1 at 9 5 2\nvia 9 5 2\n").find("leave that via out, or move it"), std::string::npos);
  // With a reach, both tubes must cover it: the curve is 4 m away by then, and the ball of the reach 0.4 m wider.
  const std::string moves = "track man ball 1 at 9 5 2 velocity 1 0 0 reach ";
  EXPECT_EQ(met(moves + "0.1 error 0 9 0\nvia 9 7 2\n").find(covered), std::string::npos);
  EXPECT_NE(met(moves + "0.2 error 0 9 0\nvia 9 7 2\n").find(covered), std::string::npos);
  EXPECT_EQ(met(moves + "9 error 0 0.1 0\nvia 9 5 2\n").find(covered), std::string::npos);
}

TEST(MetText, NamesTheViasInAFence) {
  const std::string fence = "keepout_halfspaces 1 0 0 11 -1 0 0 -9 during 0 100\n";
  EXPECT_EQ(met(fence + "via 11.2 5 2\n"), ", 4 s after the beginning; it covers via 1 then");
  EXPECT_EQ(met(fence + "via 11.4 5 2\n"), ", 4 s after the beginning");
  EXPECT_EQ(met("keepin 0 0 0 8 10 4 during 0 100\nvia 11 5 2\n"), ", 4 s after the beginning");
}

}  // namespace
