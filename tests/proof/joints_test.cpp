// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "flight/flight_state.hpp"
#include "proof/proven_joints.hpp"
#include "support/flight_room.hpp"

namespace {

using tern::kDegree;
using tern::Sample;
using tern::Trajectory;
using tern::Vec3;

/// x = t^3 (10 - 15 t + 6 t^2) metres over two seconds, the halves of it one segment each: from rest to rest. The
/// Bernstein coefficients of the whole, raised to degree 7, are 0, 0, 0, 2/7, 5/7, 1, 1, 1.
Trajectory two_halves() {
  const double whole[] = {0.0, 0.0, 0.0, 2.0 / 7.0, 5.0 / 7.0, 1.0, 1.0, 1.0};
  Trajectory t{};
  t.count = 2;
  double row[8];
  for (int i = 0; i < 8; ++i) row[i] = whole[i];
  for (int level = 0; level < 8; ++level) {
    t.segments[0].points[level].x = row[0];
    t.segments[1].points[7 - level].x = row[7 - level];
    for (int i = 0; i + 1 < 8 - level; ++i) row[i] = 0.5 * (row[i] + row[i + 1]);
  }
  t.segments[0].duration = t.segments[1].duration = 1.0;
  return t;
}

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

/// A draft that begins elsewhere, or jumps on its way, is not committed, whatever else was proven of it.
TEST(ProofJoints, DraftThatJumpsIsNotCommitted) {
  for (const bool begins_elsewhere : {true, false}) {
    tern_test::FlightRoom room;
    ASSERT_EQ(room.flight.set_goal({room.start.x + 4.0, room.start.y, room.start.z}), tern::Status::kOk);
    for (int k = 0; k < 200 && room.report.committed == 0; ++k) room.tick();
    ASSERT_GT(room.report.committed, 0u);
    tern::FlightState& state = room.state();
    state.draft.extends = false;
    state.draft.takeover = state.facts.time + 3 * room.spec.tick;
    state.draft.plan = state.facts.plans.latest();
    const Sample at = room.flight.command(state.draft.takeover).sample;
    state.draft.plan.begin = state.draft.takeover;
    state.draft.plan.trajectory = two_halves();
    state.draft.plan.trajectory.origin = at.position;
    const std::uint32_t failed = state.report.failed;
    if (begins_elsewhere) {
      state.draft.plan.trajectory.origin.y += 1e-6;
    } else {
      state.draft.plan.trajectory.segments[1].points[0].y += 1e-3;
    }
    EXPECT_FALSE(state.commit());
    EXPECT_EQ(state.report.failed, failed + 1);
  }
}

}  // namespace
