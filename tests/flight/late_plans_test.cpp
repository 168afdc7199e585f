// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans that take longer than their lead.
#include <gtest/gtest.h>

#include "flight/balls.hpp"
#include "support/flight_room.hpp"
#include "support/same.hpp"

namespace {

using namespace tern;
using tern_test::add_far_ball;
using tern_test::FlightRoom;

FlightSpec slow_spec() {
  FlightSpec spec = FlightRoom::flight_spec(256);
  spec.plan_work = 2048;
  return spec;
}

/// Half of a tick's units for 2048 units of a plan are 16 ticks; two more, and twice as many after each dropped plan,
/// up to eight times.
TEST(FlightLatePlans, AmongThingsAreDroppedAndGetMoreTime) {
  FlightRoom room(slow_spec());
  add_far_ball(room);
  room.flight.set_goal({8.0, 0.0, 1.0});
  std::uint32_t dropped = 0;
  for (const std::int64_t ticks : {18, 34, 66, 130, 130, 130}) {
    room.tick();
    EXPECT_EQ(room.report.dropped, dropped++);
    EXPECT_EQ(room.state().draft.takeover, room.time + (ticks - 1) * room.spec.tick);
    room.time = room.state().draft.takeover;
  }
  EXPECT_EQ(room.report.committed, 0u);
}

/// Where nothing changes with time, the same plan gets these ticks while the vehicle rests, and is dropped after them.
TEST(FlightLatePlans, FromRestGoOn) {
  FlightRoom room(slow_spec());
  const std::int64_t began = room.time;
  room.flight.set_goal({8.0, 0.0, 1.0});
  for (const std::int64_t ticks : {18, 34, 66, 130}) {
    room.tick();
    EXPECT_EQ(room.report.asked, 1u);
    EXPECT_EQ(room.report.dropped, 0u);
    EXPECT_EQ(room.state().draft.takeover, began + ticks * room.spec.tick);
    EXPECT_EQ(room.state().draft.deadline, began + (ticks - 1) * room.spec.tick);
    room.time = room.state().draft.takeover;
  }
  room.tick();
  EXPECT_EQ(room.report.asked, 2u);
  EXPECT_EQ(room.report.dropped, 1u);
}

/// A late one takes over one tick after its commit, and is flown from there as it was proven.
TEST(FlightLatePlans, FromRestDoNotWaitForTheirTakeover) {
  FlightRoom room(slow_spec());
  FlightState& state = room.state();
  room.flight.set_goal({8.0, 0.0, 1.0});
  room.tick();
  room.time = state.draft.takeover;
  ASSERT_TRUE(room.tick_until([&] { return state.facts.plans.has_waiting; }, 20));
  EXPECT_EQ(state.cycle.lead.late, 1);
  EXPECT_EQ(room.report.dropped, 0u);
  const Commitment waiting = state.facts.plans.waiting;
  EXPECT_EQ(waiting.begin(), room.time);
  EXPECT_EQ(waiting.trajectory.begin, room.time);
  EXPECT_EQ(waiting.planned.begin, room.time);
  tern_test::expect_same(room.position(), room.start);
  room.tick();
  EXPECT_EQ(state.facts.plans.in_flight.begin(), waiting.begin());
}

/// A plan that is proven among things is flown when it was proven, even if the things were forgotten since.
TEST(FlightLatePlans, ProvenAmongThingsWaitForTheirTakeover) {
  FlightRoom room(slow_spec());
  FlightState& state = room.state();
  add_far_ball(room);
  room.flight.set_goal({8.0, 0.0, 1.0});
  room.tick();
  room.time = state.draft.takeover;
  room.tick();
  room.time = state.facts.time = state.draft.takeover - 4 * room.spec.tick;  // too late for half of its lead
  for (int part = 0; part < 2000 && state.cycle.job != Job::kProve; ++part) {
    state.tick_work = Work{1};
    state.advance();
  }
  ASSERT_EQ(state.cycle.job, Job::kProve);
  ASSERT_EQ(state.cycle.lead.late, 1);
  const std::int64_t takeover = state.draft.takeover;
  ASSERT_EQ(room.flight.forget_track(1), Status::kOk);
  ASSERT_TRUE(room.tick_until([&] { return state.facts.plans.has_waiting; }, 3));
  EXPECT_EQ(state.facts.plans.waiting.tubes.count, 1);
  EXPECT_EQ(state.facts.plans.waiting.begin(), takeover);
}

}  // namespace
