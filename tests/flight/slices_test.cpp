// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans, proofs and brakes that take several ticks, and what comes in between.
#include <gtest/gtest.h>

#include "flight/balls.hpp"
#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Flying;
using tern_test::kNothing;

/// Away from all that is flown here.
const Box kAside{{-10.0, 9.0, 0.0}, {-9.0, 10.0, 1.0}};

/// A watch that is not done goes on in the next tick; until then no plan begins.
TEST(FlightSlices, NoPlanBeginsWhileWhatIsFlownIsProvenAnew) {
  Flying room;
  FlightState& state = room.state();
  room.mark(kAside);
  room.watch(kNothing);
  EXPECT_TRUE(state.watch.is_running);
  const std::uint32_t asked = state.report.asked;
  room.advance(kNothing);
  EXPECT_EQ(state.report.asked, asked);
  EXPECT_FALSE(state.is_busy());
  room.watch(kNothing);
  EXPECT_TRUE(state.watch.is_running);
  room.watch(4000);
  EXPECT_FALSE(state.watch.is_running);
  EXPECT_FALSE(state.watch.threat);
  room.advance(kNothing);
  EXPECT_EQ(state.report.asked, asked + 1);
  EXPECT_EQ(state.cycle.job, Job::kCopy);
}

/// Neither a plan nor a brake begins before the window is done with its slide.
TEST(FlightSlices, NothingBeginsWhileTheWindowSlides) {
  Flying room;
  FlightState& state = room.state();
  ASSERT_EQ(room.map().follow({16.0, 0.0, 1.0}), Status::kRunning);
  const std::uint32_t asked = state.report.asked;
  room.advance(4000);
  EXPECT_EQ(state.report.asked, asked);
  room.flight.stop();
  room.advance(4000);
  EXPECT_FALSE(state.is_busy());
  EXPECT_TRUE(state.evasion.stop_asked);
  while (room.map().step(100000) == Status::kRunning) {
  }
  room.advance(kNothing);
  EXPECT_TRUE(state.evasion.is_running);
  EXPECT_FALSE(state.evasion.stop_asked);
}

TEST(FlightSlices, NoBrakeBeginsWhileWhatIsFlownIsProvenAnew) {
  Flying room;
  room.mark(kAside);
  room.watch(kNothing);
  room.flight.stop();
  room.advance(kNothing);
  EXPECT_FALSE(room.state().is_busy());
  room.watch(4000);
  room.advance(kNothing);
  EXPECT_TRUE(room.state().evasion.is_running);
}

/// What comes before the takeover is being proven when it is flown already: then all of the rest is proven instead.
TEST(FlightSlices, TakeoverEndsTheProofOfWhatComesBeforeIt) {
  for (const bool is_before : {true, false}) {
    FlightRoom room;
    FlightState& state = room.state();
    room.flight.set_goal({8.125, 0.125, 1.125});
    ASSERT_TRUE(room.tick_until([&] { return state.facts.plans.has_waiting; }, 100));
    room.mark(kAside);
    Work work{is_before ? kNothing : 4000};
    state.facts.time = room.time;
    state.tick_work = Work{kNothing};
    state.run_watch();
    EXPECT_EQ(state.watch.part, Watched::kBefore);
    if (!is_before) {
      EXPECT_EQ(state.watch.proof.step(work), Status::kOk);
      state.end_watched_part();
      EXPECT_EQ(state.watch.part, Watched::kLatest);
    }
    EXPECT_TRUE(state.watch.is_running);
    state.watch.covers_all = false;
    state.facts.time = state.facts.plans.waiting.begin();
    EXPECT_TRUE(state.facts.plans.take_over(state.facts.time));
    state.watch.note_takeover();
    EXPECT_FALSE(state.facts.plans.has_waiting);
    EXPECT_EQ(state.watch.is_running, !is_before);
    EXPECT_EQ(state.watch.covers_all, is_before);
  }
}

/// A stop whose brakes are not proven in time: the committed plan goes on, and they are tried again with twice the
/// lead.
TEST(FlightSlices, BrakeThatIsNotDoneInTimeGetsMoreTime) {
  Flying room;
  FlightState& state = room.state();
  const Vec3 end = room.flight.rest_position();
  const std::uint32_t committed = state.report.committed;
  room.flight.stop();
  room.advance(kNothing);
  EXPECT_TRUE(state.evasion.is_running);
  EXPECT_EQ(state.draft.takeover, room.time + kEvadeTicks * room.spec.tick);
  room.time += room.spec.tick;
  room.advance(kNothing);
  EXPECT_TRUE(state.evasion.is_running);
  room.time = state.draft.deadline;
  room.advance(kNothing);
  EXPECT_FALSE(state.is_busy());
  EXPECT_EQ(state.report.committed, committed);
  EXPECT_EQ(state.report.dropped, 0u);
  EXPECT_EQ(room.flight.rest_position().x, end.x);
  room.time += room.spec.tick;
  room.advance(kNothing);
  EXPECT_TRUE(state.evasion.is_running);
  EXPECT_EQ(state.draft.takeover, room.time + 2 * kEvadeTicks * room.spec.tick);
  room.advance(4000);
  EXPECT_EQ(state.report.committed, committed + 1);
  EXPECT_EQ(state.evasion.missed, 0);
}

/// So may those for a threat, of which none was judged. What is flown is still being proven to touch only the alarm.
TEST(FlightSlices, BrakesThatAreNotJudgedInTimeGetMoreTime) {
  Flying room;
  FlightState& state = room.state();
  const Vec3 p = room.position();
  room.mark({{p.x + 1.0, p.y - 3.0, -2.0}, {p.x + 2.0, p.y + 3.0, 4.0}});
  room.watch(4000);
  ASSERT_TRUE(state.watch.threat);
  room.advance(kNothing);
  ASSERT_TRUE(state.evasion.is_running);
  room.time = state.draft.deadline;
  room.advance(kNothing);
  EXPECT_FALSE(state.is_busy());
  EXPECT_FALSE(state.evasion.was_tried);
  EXPECT_FALSE(state.facts.plans.has_waiting);
  room.time += room.spec.tick;
  room.advance(kNothing);
  EXPECT_EQ(state.draft.takeover, room.time + 2 * kEvadeTicks * room.spec.tick);
  room.advance(4000);
  EXPECT_TRUE(state.facts.plans.has_waiting);
}

/// The brake begins as late as its work asks for, next to a yaw plan's quarter of each tick: 900 units after a tick.
TEST(FlightSlices, BrakesBeginLaterWithLittleWork) {
  const struct {
    std::uint32_t units;
    int ticks;
  } kCases[] = {{256, 6}, {300, 5}, {399, 4}, {400, 4}, {598, 4}, {599, 3}, {4000, 3}};
  for (const auto& c : kCases) {
    FlightRoom room(FlightRoom::flight_spec(c.units));
    EXPECT_EQ(room.state().evasion.ticks(room.state().facts.spec), c.ticks) << c.units;
  }
}

/// What touches at most the alarm is not proven yet: a brake that touches more is not flown for it.
TEST(FlightSlices, BrakesBeginWhileTheAlarmIsProven) {
  for (const bool is_known : {true, false}) {
    Flying room;
    FlightState& state = room.state();
    const Vec3 p = room.position();
    room.mark({{p.x + 1.0, p.y - 3.0, -2.0}, {p.x + 2.0, p.y + 3.0, 4.0}});
    // Enough for the threat, and not for all of the committed plan.
    for (int k = 0; k < 1000 && !state.watch.threat; ++k) room.watch(6);
    ASSERT_TRUE(state.watch.threat);
    ASSERT_TRUE(state.watch.is_running);
    ASSERT_EQ(state.watch.part, Watched::kAlarm);
    room.advance(kNothing);
    ASSERT_TRUE(state.evasion.is_running);
    EXPECT_TRUE(helps({0, 0.1, 0.5, true}, state.facts, state.watch, state.draft.takeover));
    EXPECT_FALSE(helps({0, 0.1, 0.5, false}, state.facts, state.watch, state.draft.takeover));
    if (!is_known) state.watch.alarm.box = {{-9.0, -9.0, 0.0}, {-8.0, -8.0, 1.0}};
    if (!is_known) state.watch.prove(state.facts, Watched::kAlarm);
    room.watch(4000);
    ASSERT_FALSE(state.watch.is_running);
    EXPECT_EQ(state.watch.known, is_known);
    EXPECT_EQ(helps({0, 0.1, 0.5, false}, state.facts, state.watch, state.draft.takeover), !is_known);
  }
}

/// Ticks were skipped: the brake is dropped and tried again, with twice the lead after every second time. Plans get no
/// more time for it.
TEST(FlightSlices, BrakeThatIsLateIsTriedAgain) {
  Flying room;
  FlightState& state = room.state();
  room.flight.stop();
  room.advance(kNothing);
  for (const int lead : {1, 1, 2, 2, 4, 4, 8, 8, 8}) {
    EXPECT_TRUE(state.evasion.is_running);
    EXPECT_EQ(state.draft.takeover - room.time, lead * kEvadeTicks * room.spec.tick);
    room.time = state.draft.takeover;
    room.advance(kNothing);
  }
  EXPECT_EQ(state.report.dropped, 9u);
  EXPECT_EQ(state.cycle.lead.late, 0);
  room.advance(4000);
  EXPECT_TRUE(state.facts.plans.waiting.branch == 0.0 && state.facts.plans.has_waiting);
  EXPECT_EQ(state.evasion.missed, 0);
}

/// With a new goal, there is no reason to brake any more.
TEST(FlightSlices, BrakeThatIsLateIsNotTriedAgainWithANewGoal) {
  Flying room;
  FlightState& state = room.state();
  room.flight.stop();
  room.advance(kNothing);
  EXPECT_TRUE(state.evasion.is_running);
  room.flight.set_goal({8.125, 0.125, 1.125});
  room.time = state.draft.takeover;
  room.advance(kNothing);
  EXPECT_FALSE(state.evasion.is_running);
  EXPECT_FALSE(state.evasion.stop_asked);
}

/// A plan from rest is about to take over: it is dropped, and the vehicle stays.
TEST(FlightSlices, StopBeforeTheTakeoverKeepsTheVehicleAtRest) {
  FlightRoom room;
  tern_test::add_far_ball(room);
  room.flight.set_goal({8.125, 0.125, 1.125});
  ASSERT_TRUE(room.tick_until([&] { return room.state().facts.plans.has_waiting; }, 100));
  EXPECT_GT(room.flight.rest_position().x, 2.0);
  room.flight.stop();
  for (int k = 0; k < 100; ++k) {
    room.tick();
    EXPECT_NEAR(room.position().x, room.start.x, 1e-9);
    EXPECT_NEAR(room.flight.rest_position().x, room.start.x, 1e-9);
  }
  EXPECT_EQ(room.report.mode, FlightMode::kRest);
  EXPECT_EQ(room.report.reason, FlightReason::kNoGoal);
}

/// The vehicle is on a brake: there is nothing to stop any more.
TEST(FlightSlices, StopOnABrakeChangesNothing) {
  Flying room;
  FlightState& state = room.state();
  room.flight.stop();
  ASSERT_TRUE(
      room.tick_until([&] { return !state.facts.plans.has_waiting && state.facts.plans.in_flight.branch <= 0.0; }, 10));
  const std::uint32_t committed = state.report.committed;
  EXPECT_GT(room.speed(), 1.0);
  room.flight.stop();
  EXPECT_EQ(room.fly(400), FlightReason::kNoGoal);
  EXPECT_EQ(state.report.committed, committed);
  EXPECT_EQ(room.speed(), 0.0);
}

/// The remainder of the committed plan is chosen again and again, and changes nothing: that is no commit.
TEST(FlightSlices, PlanThatIsFlownIsNotCommittedAgain) {
  for (const double way : {0.0, 0.05, 4.0}) {
    FlightRoom room;
    room.flight.set_goal({room.start.x + way, room.start.y, room.start.z});
    std::uint32_t committed = 0;
    std::int64_t begin = room.state().facts.plans.latest().begin();
    int changes = 0;
    while (room.report.reason == FlightReason::kNone && room.time < 20000000000) {
      room.tick();
      const Commitment& latest = room.state().facts.plans.latest();
      const bool changed = latest.begin() != begin;
      EXPECT_EQ(room.report.committed - committed, changed ? 1u : 0u) << room.time;
      changes += changed ? 1 : 0;
      begin = latest.begin();
      committed = room.report.committed;
    }
    EXPECT_EQ(room.report.reason, FlightReason::kArrived);
    EXPECT_GT(room.report.asked, 5u);
    EXPECT_GE(changes, 1);
  }
}

/// The whole of a draft is proven once more before it is flown: here something stands in its way by then.
TEST(FlightSlices, DraftThatIsNotProvenAsAWholeIsNotFlown) {
  for (const bool is_free : {true, false}) {
    Flying room;
    FlightState& state = room.state();
    const std::uint32_t committed = state.report.committed;
    state.draft.extends = true;
    state.draft.plan = state.facts.plans.in_flight;
    state.facts.plans.in_flight.branch -= 0.25;
    state.draft.takeover = room.time;
    if (!is_free) room.mark({{7.0, -1.0, 0.0}, {8.0, 1.0, 2.0}});
    ASSERT_EQ(state.draft.begin_proof(state.facts, state.draft.plan.trajectory, state.draft.start_of_proof()),
              Status::kRunning);
    state.cycle.job = Job::kConfirm;
    state.tick_work = Work{4000};
    EXPECT_EQ(state.run_confirm(), Progress::kDone);
    EXPECT_EQ(state.cycle.job, is_free ? Job::kIdle : Job::kBranch);
    EXPECT_EQ(state.report.committed, committed + (is_free ? 1 : 0));
  }
}

}  // namespace
