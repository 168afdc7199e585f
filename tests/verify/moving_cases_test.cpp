// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans among things that move where something degenerates: from behind, head-on, in a tunnel, at the goal. Each plan
// is proven in exact numbers, and is no longer than it should be.
#include <gtest/gtest.h>

#include <string>

#include "host/plan_file.hpp"
#include "host/scenario.hpp"
#include "host/session.hpp"
#include "support/random.hpp"
#include "verify/plan.hpp"
#include "verify/proofs.hpp"

namespace tern_verify {
namespace {

const std::string kRoom =
    "boundary 0 0 0 20 10 3\nresolution 0.2\nradius 0.3\nv_max 2.5 2.5 1.5\na_max 4 4 3\ngoal 18 5 1.5\nrest_clear 1\n";
const std::string kStart = "start 2 5 1.5\n";
/// 1.6 x 1.4 m around the way.
const std::string kTunnel = "block 4 0 0 16 4.2 3\nblock 4 5.8 0 16 10 3\nblock 4 4 2.2 16 6 3\nblock 4 4 0 16 6 0.8\n";
/// Seconds that a plan without things takes here.
constexpr double kAlone = 7.81;

std::string ball(const std::string& place, const std::string& velocity = "0 0 0") {
  return "track a ball 0.3 at " + place + " velocity " + velocity + " error 0.05 0.02 0";
}

struct Answer {
  tern::Status status = tern::Status::kOk;
  double seconds = 0.0;
};

/// What is not refused is proven.
Answer plan(const std::string& records) {
  static tern_host::Session session;
  const std::string text = kRoom + records + "\n";
  const tern_host::PlanResult result = session.plan(tern_host::parse_scenario(text, "case"));
  if (!result.ok()) return {result.report.status, 0.0};
  const Claims claims = prove(parse_problem(text, "case"), parse_plan(tern_host::plan_json(result), "plan"));
  EXPECT_EQ(verdict_of(claims), Verdict::kProven) << records;
  return {result.report.status, tern::duration(result.trajectory)};
}

void expect_within(double most, const std::string& records) {
  const Answer answer = plan(records);
  EXPECT_EQ(answer.status, tern::Status::kOk) << records;
  EXPECT_LE(answer.seconds, most) << records;
}

TEST(MovingCases, InTheOpen) {
  expect_within(kAlone, kStart);
  expect_within(kAlone, kStart + ball("2 2 1.5", "0 1 0"));  // over the start after 3 s
  expect_within(1.01 * kAlone, kStart + ball("18 5 1.5", "-1 0 0"));
  expect_within(1.01 * kAlone, kStart + ball("18 5 1.5", "-1 0 0") + " until 9 stays");
  expect_within(kAlone, kStart + ball("-2 5 1.5", "2.2 0 0"));  // overtakes it, and is at the goal first
  expect_within(15.9, kStart + ball("18 5 1.5") + " until 15 gone");
}

TEST(MovingCases, WallsWithAGapInPlaceOrTime) {
  expect_within(1.01 * kAlone, kStart + "track a box 0.3 4.5 3 at 10 -5 1.5 velocity 0 1 0 error 0.05 0.02 0\n" +
                                   "track b box 0.3 5 3 at 10 6.6 1.5 velocity 0 1 0 error 0.05 0.02 0");
  expect_within(kAlone, kStart + "keepout 9 -1 -1.5 11 11 4.5 during 0 3");
  expect_within(13.5, kStart + "keepout 9 -1 -1.5 11 11 4.5 during 2 9");
  expect_within(34.5, kStart + "keepout 9 -1 -1.5 11 11 4.5 during 0 30");
  expect_within(13.1, kStart + "keepout_halfspaces 1 0.2 0 12 -1 -0.2 0 -10 during 2 9");
  expect_within(12.0, kStart + "keepin 0 0 0 11 10 3 during -1 20\nkeepin 9 0 0 20 10 3 during 8 60");
}

/// The half-spaces of the cuboid between two corners.
std::string faces_of(double x0, double y0, double x1, double y1) {
  const auto text = [](double value) { return " " + std::to_string(value); };
  return " 1 0 0" + text(x1) + " -1 0 0" + text(-x0) + " 0 1 0" + text(y1) + " 0 -1 0" + text(-y0) +
         " 0 0 1 4 0 0 -1 1";
}

/// Around the corners at (9, 6.8) and (11, 6.8), the way is 16.46 m long instead of 16: 0.2 s at 2.5 m/s. Waiting would
/// take 30 s.
TEST(MovingCases, AroundAKeepOutForAWhile) {
  const Answer as_thing = plan(kStart + "keepout 9 2 -1 11 6.5 4 during 2 30");
  const Answer as_fence = plan(kStart + "keepout_halfspaces" + faces_of(9, 2, 11, 6.5) + " during 2 30");
  EXPECT_EQ(as_thing.status, tern::Status::kOk);
  EXPECT_EQ(as_fence.status, tern::Status::kOk);
  EXPECT_LE(as_fence.seconds, kAlone + 0.2);
  EXPECT_NEAR(as_fence.seconds, as_thing.seconds, 1e-6);
  // No box has its slanted side. It ends at x = 11.6 where it begins at y = 2, and at 10.7 at 6.5.
  expect_within(kAlone + 0.2, kStart + "keepout_halfspaces 1 0.2 0 12 -1 -0.2 0 -10 0 -1 0 -2 0 1 0 6.5 during 2 30");
  // Its clock's error: it may be there before 2 s.
  expect_within(kAlone + 0.2, kStart + "keepout_halfspaces" + faces_of(9, 2, 11, 6.5) + " during 5 30 3");
}

TEST(MovingCases, BothSpellingsOfAKeepOutGiveTheSamePlan) {
  tern_test::Random random(5);
  int around = 0;
  for (int i = 0; i < tern_test::scaled(40); ++i) {
    const double x = random.real(4.0, 14.0);
    const double y = random.real(0.5, 5.0);
    const double wide = random.real(1.0, 5.0);
    const std::string during = " during " + std::to_string(random.real(0.0, 3.0)) + " 25";
    const std::string corners = std::to_string(x) + " " + std::to_string(y) + " 1 " + std::to_string(x + 1.5) + " " +
                                std::to_string(y + wide) + " 4";
    const Answer as_thing = plan(kStart + "keepout " + corners + during);
    const Answer as_fence = plan(kStart + "keepout_halfspaces" + faces_of(x, y, x + 1.5, y + wide) + during);
    EXPECT_EQ(as_fence.status, as_thing.status) << corners << during;
    EXPECT_NEAR(as_fence.seconds, as_thing.seconds, 2.5e-2 * as_thing.seconds) << corners << during;
    around += as_fence.seconds > kAlone + 1e-3 && as_fence.seconds < 12.0 ? 1 : 0;
  }
  EXPECT_GT(around, 0);
}

TEST(MovingCases, Tunnels) {
  expect_within(kAlone, kTunnel + kStart + ball("15 5 1.5", "1 0 0"));
  EXPECT_EQ(plan(kTunnel + kStart + ball("10 5 1.5")).status, tern::Status::kNoClearTime);
  // It waits outside, or backs out.
  expect_within(18.5, kTunnel + kStart + ball("15 5 1.5", "-1 0 0"));
  for (const char* const x : {"6.5", "7", "7.5", "8", "8.5", "9", "9.5"}) {
    expect_within(24.0, kTunnel + "start " + x + " 5 1.5\n" + ball("15 5 1.5", "-1 0 0"));
  }
  expect_within(19.0, kTunnel + "start 8 5 1.5\n" + ball("15 5 1.5", "-1 0 0"));
}

/// Something is in the way for good, or drives the vehicle before it.
TEST(MovingCases, NoWayOut) {
  EXPECT_EQ(plan(kStart + ball("2.3 5 1.5")).status, tern::Status::kStartInContact);
  EXPECT_EQ(plan(kStart + ball("2.3 5 1.5", "1 0 0")).status, tern::Status::kStartInContact);
  EXPECT_EQ(plan(kStart + ball("18 5 1.5")).status, tern::Status::kGoalCovered);
  EXPECT_EQ(plan(kStart + "keepin 0 0 0 11 10 3 during -1 200").status, tern::Status::kGoalCovered);
}

}  // namespace
}  // namespace tern_verify
