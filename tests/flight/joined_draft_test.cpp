// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "flight/flight_state.hpp"
#include "support/flight_room.hpp"
#include "support/two_halves.hpp"

namespace {

using tern::Sample;
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

}  // namespace
