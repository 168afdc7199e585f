// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A hand-made plan, at rest at both ends, past a wall at exactly the radius and at exactly its speed limit; then the
// same plan with one thing wrong.
#include "verify/proofs.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tern_verify {
namespace {

constexpr const char* kFencedScenario =
    "boundary 0 0 0 10 4 4\n"
    "block 4 0 0 5 1.5 4\n"
    "start 1 2 2\n"
    "goal 9 2 2\n"
    "radius 0.5\n"
    "resolution 0.125\n"
    "v_max 2\n";

/// 8 m along x in 8.75 s: at most 35 / 16 * 8 / 8.75 = 2 m/s. Cut into halves at its middle.
Plan straight_plan() {
  Plan plan;
  plan.name = "plan";
  plan.origin = {1, 2, 2};
  Polygon<3> whole;
  for (int i = 0; i < 8; ++i) whole.push_back({i < 4 ? 0 : 8, 0, 0});
  const Halves<3> halves = halves_of(whole);
  const Rational duration = Rational(35) / 8;
  plan.segments = {{halves.left, duration}, {halves.right, duration}};
  return plan;
}

Problem problem_of(const std::string& more = "") {
  return parse_problem(kFencedScenario + more, "scenario");
}

Claim claim_in(const Claims& claims, const std::string& what) {
  const auto found = std::find_if(claims.begin(), claims.end(), [&](const Claim& claim) { return claim.what == what; });
  EXPECT_NE(found, claims.end()) << what;
  return found == claims.end() ? Claim{} : *found;
}

void expect_refuted(const std::string& what, const Plan& plan, const Problem& problem) {
  const Claim claim = claim_in(prove(problem, plan), what);
  EXPECT_EQ(claim.verdict(), Verdict::kRefuted) << line_of(claim);
}

TEST(Proofs, AllOfAPlanThatTouchesItsLimitsIsProven) {
  const Claims claims = prove(problem_of(), straight_plan());
  for (const Claim& claim : claims) EXPECT_EQ(claim.verdict(), Verdict::kProven) << line_of(claim);
  EXPECT_EQ(verdict_of(claims), Verdict::kProven);
  EXPECT_LT(abs(claim_in(claims, "curve off obstacles").least), decimal(2, 12));
  EXPECT_LT(abs(claim_in(claims, "velocity +x").most), decimal(2, 12));
  EXPECT_LE(claim_in(claims, "velocity +x").least, 0);
  EXPECT_EQ(claim_in(claims, "velocity -x").most, 2);
}

TEST(Proofs, ACurveThatIsThreeNanometresTooNear) {
  Plan plan = straight_plan();
  plan.origin[1] -= decimal(3, 9);
  expect_refuted("curve off obstacles", plan, problem_of());
  expect_refuted("start position", plan, problem_of());
}

TEST(Proofs, ACurveIntoTheWall) {
  Plan plan = straight_plan();
  for (std::size_t i = 2; i < 8; ++i) plan.segments[0].points[i][1] = -Rational(1) / 2;
  const Claim claim = claim_in(prove(problem_of(), plan), "curve off obstacles");
  EXPECT_EQ(claim.verdict(), Verdict::kRefuted);
  EXPECT_LT(claim.most, -Rational(2) / 5);
}

/// Without a radius, the curve may touch the wall, but not enter it.
TEST(Proofs, ACurveAlongTheWallWithoutARadius) {
  Problem problem = problem_of("block 0 0 0 10 2 4\n");
  problem.clearance = 0;
  Plan plan = straight_plan();
  EXPECT_EQ(claim_in(prove(problem, plan), "curve off obstacles").verdict(), Verdict::kProven);
  plan.origin[1] -= decimal(3, 9);
  const Claim claim = claim_in(prove(problem, plan), "curve off obstacles");
  EXPECT_EQ(claim.verdict(), Verdict::kRefuted) << line_of(claim);
  EXPECT_LE(abs(claim.most + decimal(3, 9)), decimal(1, 12));
}

TEST(Proofs, AJointIsBrokenBeyondItsToleranceByAnything) {
  const Rational least = Rational(1) / Rational(Integer(1) << 300);
  for (const int derivative : {0, 1, 2, 3}) {
    const auto k = static_cast<std::size_t>(derivative);
    Plan plan = straight_plan();
    const Rational allowed =
        joint_tolerance(plan.segments[0], derivative) + joint_tolerance(plan.segments[1], derivative);
    // Moving point k by d changes derivative k by d * 7! / (7 - k)! / duration^k, and none below.
    Rational per_metre = 1;
    for (int i = 0; i < derivative; ++i) per_metre *= Rational(7 - i) / plan.segments[1].duration;
    const char* const names[] = {"joint position", "joint velocity", "joint acceleration", "joint jerk"};
    plan.segments[1].points[k][2] = allowed / per_metre;
    EXPECT_EQ(claim_in(prove(problem_of(), plan), names[k]).verdict(), Verdict::kProven) << names[k];
    plan.segments[1].points[k][2] = (allowed + least) / per_metre;
    expect_refuted(names[k], plan, problem_of());
  }
}

TEST(Proofs, ALimitIsExceededByAMillionth) {
  Problem slower = problem_of();
  for (Bound& bound : slower.bounds) {
    if (bound.derivative == 1) bound.most -= decimal(1, 6);
  }
  expect_refuted("velocity +x", straight_plan(), slower);
  expect_refuted("velocity horizontal", straight_plan(), problem_of("v_horizontal 1.999999\n"));
  EXPECT_EQ(verdict_of(prove(problem_of("v_horizontal 2\n"), straight_plan())), Verdict::kProven);
}

TEST(Proofs, LimitsOfAccelerationAndJerkAndDownwards) {
  // The acceleration is 7.513188404399293 * 8 / 8.75^2, whose factor is 84 sqrt(5) / 25.
  const Claim claim = claim_in(prove(problem_of("a_max 1\n"), straight_plan()), "acceleration +x");
  const Rational root = root_below(5);
  const Rational peak = 84 * root / 25 * 8 * 16 / 1225;
  EXPECT_LT(abs(1 - claim.least - peak), decimal(1, 12));
  expect_refuted("acceleration -x", straight_plan(), problem_of("a_min -0.78 -1 -1\n"));
  expect_refuted("jerk +x", straight_plan(), problem_of("j_max 0.5\n"));
  EXPECT_EQ(claim_in(prove(problem_of("j_max 2\n"), straight_plan()), "jerk -y").least, 2);
}

TEST(Proofs, ThrustTiltAndBodyRates) {
  // The acceleration's peak, 0.785 m/s^2, tilts by 0.0800; its jerk at rest's thrust turns by 0.0799 rad/s at most.
  const Problem kept = problem_of("thrust_max 9.84\nthrust_min 9.8\ntilt_tangent 0.0801\nrate_max 0.08\n");
  EXPECT_EQ(verdict_of(prove(kept, straight_plan())), Verdict::kProven);
  expect_refuted("acceleration thrust", straight_plan(), problem_of("thrust_max 9.837\n"));
  expect_refuted("tilt", straight_plan(), problem_of("tilt_tangent 0.0799\n"));
  expect_refuted("body rate", straight_plan(), problem_of("thrust_min 5\nrate_max 0.0637\n"));
}

TEST(Proofs, BothEnds) {
  Plan plan = straight_plan();
  plan.segments[1].points[7][2] += decimal(1, 12);
  expect_refuted("goal position", plan, problem_of());
  plan = straight_plan();
  plan.segments[0].points[1][0] += decimal(1, 12);
  expect_refuted("start velocity", plan, problem_of());
  expect_refuted("goal velocity", straight_plan(), problem_of("goal_velocity 0 0 0.001\n"));
}

/// The goal is beside the way, and the plan says of itself that it could not get there.
constexpr const char* kElsewhere = "boundary 0 0 0 10 4 4\nstart 1 2 2\ngoal 9 3 2\n";

Plan plan_that_missed() {
  Plan plan = straight_plan();
  plan.reachable = Point{9, 2, 2};
  return plan;
}

Problem nearest_problem(const std::string& scenario = kElsewhere) {
  return parse_problem(scenario + "goal_mode nearest\n", "near");
}

bool mentions(const Claims& claims, const std::string& what) {
  return std::any_of(claims.begin(), claims.end(), [&](const Claim& claim) { return claim.what == what; });
}

TEST(Proofs, APlanCannotSayItselfThatItMayEndElsewhere) {
  for (const char* const mode : {"", "goal_mode exact\n"}) {
    const Problem problem = parse_problem(std::string(kElsewhere) + mode, "exact");
    expect_refuted("goal position", plan_that_missed(), problem);
    EXPECT_FALSE(mentions(prove(problem, plan_that_missed()), "reachable position")) << mode;
    EXPECT_TRUE(assumed_of(problem, plan_that_missed()).empty()) << mode;
  }
}

TEST(Proofs, WhereAPlanMayEndElsewhereItsOwnPointIsNamedAsSuch) {
  const Claims claims = prove(nearest_problem(), plan_that_missed());
  for (const char* const what :
       {"reachable position", "reachable velocity", "reachable acceleration", "reachable jerk", "reachable distance"}) {
    EXPECT_EQ(claim_in(claims, what).verdict(), Verdict::kProven) << what;
  }
  EXPECT_FALSE(mentions(claims, "goal position")) << "the goal itself is not proven";
  const std::string assumed = assumed_of(nearest_problem(), plan_that_missed()).at(0);
  EXPECT_NE(assumed.find("own 'reachable' point, 1 m from the goal"), std::string::npos) << assumed;
  EXPECT_NE(assumed.find("not proven"), std::string::npos) << assumed;
}

TEST(Proofs, APlanThatDoesNotSayThatItMissedTheGoalMustEndThere) {
  expect_refuted("goal position", straight_plan(), nearest_problem());
  EXPECT_TRUE(assumed_of(nearest_problem(), straight_plan()).empty());
}

TEST(Proofs, APlanThatEndsElsewhereEndsAtItsOwnPointAtRest) {
  Plan plan = plan_that_missed();
  (*plan.reachable)[1] += decimal(1, 12);
  expect_refuted("reachable position", plan, nearest_problem());
  plan = plan_that_missed();
  plan.segments[1].points[6][0] -= decimal(1, 12);
  expect_refuted("reachable velocity", plan, nearest_problem());
  const Claims claims = prove(nearest_problem(std::string(kElsewhere) + "goal_velocity 1 0 0\n"), plan_that_missed());
  EXPECT_EQ(claim_in(claims, "reachable velocity").verdict(), Verdict::kProven) << "whatever the goal's was to be";
}

TEST(Proofs, APlanThatLeadsAwayFromTheGoalDidNotMissItByNecessity) {
  // Start and end are 8 m apart with the goal between them. A plan may lose 2.5 sqrt(3) voxels: 0.433 m.
  const auto goal_at = [](const char* x) {
    return nearest_problem("boundary 0 0 0 10 4 4\nstart 1 2 2\ngoal " + std::string(x) + " 2 2\n");
  };
  const Claim claim = claim_in(prove(goal_at("4.784"), plan_that_missed()), "reachable distance");
  EXPECT_EQ(claim.verdict(), Verdict::kProven) << line_of(claim);
  EXPECT_LT(claim.most, 0);
  expect_refuted("reachable distance", plan_that_missed(), goal_at("4.783"));
}

TEST(Proofs, Vias) {
  EXPECT_EQ(verdict_of(prove(problem_of("via 5 2 2\n"), straight_plan())), Verdict::kProven);
  EXPECT_EQ(verdict_of(prove(problem_of("via 5 2.25 2 0.25 velocity 2 0 0\n"), straight_plan())), Verdict::kProven);
  expect_refuted("via 1", straight_plan(), problem_of("via 5 2.25 2 0.24\n"));
  expect_refuted("via 1", straight_plan(), problem_of("via 5 2 2 stop\n"));
  // In order: the goal comes last.
  expect_refuted("via 2", straight_plan(), problem_of("via 9 2 2\nvia 5 2 2\n"));
}

TEST(Proofs, Fences) {
  EXPECT_EQ(verdict_of(prove(problem_of("keepin 0 2 0 10 4 4\n"), straight_plan())), Verdict::kProven);
  expect_refuted("fence 1", straight_plan(), problem_of("keepin 0 2.00000001 0 10 4 4\n"));
  // A prism whose edge is at (5, 1.5): exactly the radius below the way.
  const std::string prism = "keepout_halfspaces 1 1 0 6.5 -1 1 0 -3.5\n";
  EXPECT_EQ(verdict_of(prove(problem_of(prism), straight_plan())), Verdict::kProven);
  expect_refuted("fence 1", straight_plan(), problem_of("keepout_halfspaces 1 1 0 6.50000001 -1 1 0 -3.49999999\n"));
}

/// A prism whose edge climbs past the way: at (5, y), the edge is at z = y + 1.125 and the way at y = z = 2.
TEST(Proofs, AnEdgeAcrossTheWay) {
  const auto prism_at = [](const std::string& y, const std::string& x) {
    return problem_of("keepout_halfspaces 4 1 -1 " + y + " -4 1 -1 " + x + "\n");
  };
  const Claim claim = claim_in(prove(prism_at("18.875", "-21.125"), straight_plan()), "fence 1");
  const Rational room = Rational(9) / 8 * root_below(Rational(1) / 2) - Rational(1) / 2;
  EXPECT_EQ(claim.verdict(), Verdict::kProven);
  EXPECT_LT(abs(claim.least - room), decimal(2, 10)) << line_of(claim);
  expect_refuted("fence 1", straight_plan(), prism_at("19.2928933", "-20.7071067"));
  EXPECT_EQ(verdict_of(prove(prism_at("19.2928932", "-20.7071068"), straight_plan())), Verdict::kProven);
}

TEST(Proofs, AKeepOutHasAnInsideInAFlatBoundaryAndAFlatKeepIn) {
  const std::string slab = "keepout_halfspaces 1 0 0 6 -1 0 0 -5\n";
  const Plan plan = straight_plan();
  Problem problem = problem_of(slab);
  problem.clearance = 0;
  problem.boundary.lower[2] = problem.boundary.upper[2] = 2;
  expect_refuted("fence 1", plan, problem);
  problem = problem_of(slab + "keepin 0 0 2 10 4 2\n");
  problem.clearance = 0;
  expect_refuted("fence 1", plan, problem);
}

TEST(Proofs, ThePlanMustStayInTheBoundary) {
  Problem problem = problem_of();
  problem.boundary.lower[1] = 2 + decimal(1, 8);
  expect_refuted("boundary", straight_plan(), problem);
}

TEST(Scenarios, WhatIsWrongIsNamedWithItsLine) {
  const auto message = [](const std::string& text) -> std::string {
    try {
      parse_problem(text, "s.txt");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message("boundary 0 0 0 1 1 1\nblok 1\n"), "s.txt:2: unknown record 'blok'");
  EXPECT_EQ(message("boundary 0 0 0 1 1 x\n"), "s.txt:1: 'x' is no number");
  EXPECT_EQ(message("track a ball 1 error 0.1 plan b\n"), "s.txt:1: 'plan' is no number, as 'error' needs");
  EXPECT_EQ(message("track a ball 1 until 6\n"), "s.txt:1: the record ends where something of 'until' is missing");
  EXPECT_EQ(message("track a ball 1 plan none.json\n"), "s.txt:1: the plan of track 'a': none.json: cannot be opened");
  EXPECT_EQ(message("boundary 0 0 0 1 1 1\nstart 0 0 0\n"), "s.txt: there is no 'goal'");
  EXPECT_EQ(message("boundary 0 0 0 1 1 1\ncloud none.pcd\n"), "none.pcd: cannot be opened");
  EXPECT_EQ(message("boundary 0 0 0 1 1 1\ncloud a b\n"), "s.txt:2: 'cloud' needs the name of a file");
  EXPECT_EQ(message(std::string(kFencedScenario) + "unknown solid\n"),
            "s.txt: 'unknown solid' needs an 'octomap', which says what is free");
  EXPECT_EQ(message("unknown\n"), "s.txt:1: 'unknown' needs 'free' or 'solid'");
  EXPECT_EQ(message("unknown space\n"), "s.txt:1: 'unknown' needs 'free' or 'solid'");
  EXPECT_EQ(message(std::string(kFencedScenario) + "unknown free\n"), "");
  EXPECT_NE(message("unknown free\nunknown free\n").find("given twice"), std::string::npos);
}

}  // namespace
}  // namespace tern_verify
