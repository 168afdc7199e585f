// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "flight/flight_state.hpp"
#include "support/flight_room.hpp"
#include "support/two_halves.hpp"

namespace {

using namespace tern;
using tern_test::two_halves;

/// A draft that begins elsewhere, or jumps on its way, is not committed, whatever else was proven of it.
TEST(FlightJoints, DraftThatJumpsIsNotCommitted) {
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
    state.draft.plan.planned.begin = state.draft.takeover;
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

/// At the limit on speed, still accelerating, and without a limit on jerk: a stop would have to level off in far less
/// than a millisecond. No plan ends like that.
TEST(FlightDraft, PlansEndInNoJolt) {
  tern_test::Flying room;  // up to 2 m/s upwards
  Draft& draft = room.state().draft;
  draft.plan.planned = Trajectory{};
  const double speed = 2.0 - 1e-3;
  const JointState from{{kZero, {0.0, 0.0, speed - 0.15}, {0.0, 0.0, 3.0}, kZero}};
  const JointState to{{{0.0, 0.0, 0.05 * (speed - 0.075)}, {0.0, 0.0, speed}, {0.0, 0.0, 3.0}, kZero}};
  ASSERT_TRUE(append_between(from, to, 0.05, draft.plan.planned));
  ASSERT_TRUE(append_between(to, {{{0.0, 0.0, 2.0}, kZero, kZero, kZero}}, 1.5, draft.plan.planned));
  Stopping scratch;
  int jolts = 0;
  for (int way = 0; way < kBranchShapes; ++way) {
    Trajectory brake{};
    const bool stops = append_stop(to, room.state().facts.limits, way, scratch, brake);
    jolts += stops && scratch.segments[0].duration < 1e-3 ? 1 : 0;
    if (!draft.branch_off(room.state().facts, 0.05, way)) continue;
    const Trajectory& plan = draft.plan.trajectory;
    for (std::int32_t i = 0; i < plan.count; ++i) EXPECT_GE(plan.segments[i].duration, 0.004) << way << ' ' << i;
  }
  EXPECT_GT(jolts, 0);
}

}  // namespace
