// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/joints.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/two_halves.hpp"

namespace {

using tern::Sample;
using tern::Trajectory;
using tern_test::two_halves;

TEST(ProofJoints, HoldWhereOneCurveIsCut) {
  EXPECT_TRUE(tern::joints_hold(two_halves()));
}

/// By how much a control point may be off: position by 1e-9 m, velocity 7 times that of the points, acceleration 42.
TEST(ProofJoints, NoticeAJumpOfEachOrder) {
  const struct {
    int point;
    double allowed, refused;
  } kCases[] = {{0, 1e-10, 3e-9}, {1, 1e-7, 2e-7}, {2, 2e-6, 3e-6}};
  for (const auto& c : kCases) {
    Trajectory t = two_halves();
    // The same shift of all points up to this one moves lower orders as well; so only this one is moved.
    t.segments[1].points[c.point].y += c.allowed;
    EXPECT_TRUE(tern::joints_hold(t)) << c.point;
    t.segments[1].points[c.point].y += c.refused - c.allowed;
    EXPECT_FALSE(tern::joints_hold(t)) << c.point;
  }
}

TEST(ProofJoints, NoticeADurationThatDoesNotFit) {
  Trajectory t = two_halves();
  t.segments[1].duration = 1.001;
  EXPECT_FALSE(tern::joints_hold(t));
}

TEST(ProofJoints, NoticeAnEndThatIsNoRest) {
  for (const int point : {5, 6}) {
    Trajectory t = two_halves();
    t.segments[1].points[point].z += 1e-3;
    EXPECT_FALSE(tern::joints_hold(t)) << point;
  }
  Trajectory half = two_halves();
  half.count = 1;
  EXPECT_FALSE(tern::joints_hold(half));
}

TEST(ProofJoints, NoticeWhatIsNoTrajectory) {
  Trajectory t = two_halves();
  for (const int count : {0, -1, tern::kMaxSegments + 1}) {
    t.count = count;
    EXPECT_FALSE(tern::joints_hold(t)) << count;
  }
  t = two_halves();
  t.segments[0].points[7].x = std::nan("");
  EXPECT_FALSE(tern::joints_hold(t));
}

TEST(ProofJoints, SamplesFollowWithinTheJump) {
  Sample a{};
  a.position = {1.0, 2.0, 3.0};
  Sample b = a;
  EXPECT_TRUE(tern::follows(a, b));
  b.position.y += 2e-9;
  EXPECT_FALSE(tern::follows(a, b));
  b = a;
  b.velocity.z = -2e-6;
  EXPECT_FALSE(tern::follows(a, b));
  b = a;
  b.acceleration.x = 2e-4;
  EXPECT_FALSE(tern::follows(a, b));
  b.acceleration.x = std::nan("");
  EXPECT_FALSE(tern::follows(a, b));
}

}  // namespace
