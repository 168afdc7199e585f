// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Brakes whose time is up, stops while brakes are being tried, and brakes that are tried again.
#include <gtest/gtest.h>

#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::Flying;
using tern_test::kNothing;

constexpr JudgedBrake kNoBrake{-1, 0.0, 0.0, false};
constexpr JudgedBrake kBrake{0, 0.5, 1.0, true};

/// Brakes are pending, and `tried` of them were tried when the time was up.
struct TimeIsUp : Flying {
  TimeIsUp(int tried, bool threat, const JudgedBrake& best) {
    FlightState& s = state();
    s.facts.time = time;
    s.watch.threat = threat;
    s.draft.takeover = time + kEvadeTicks * spec.tick;
    s.watch.contact = {s.draft.takeover + 1000000000, 2.0};
    s.draft.deadline = s.draft.takeover - spec.tick;
    s.evasion.is_running = true;
    s.draft.extends = false;
    s.evasion.was_tried = true;
    s.evasion.number = tried;
    s.evasion.best = best;
  }
};

TEST(FlightLateBrakes, GetMoreTimeUnlessOneCanBeFlown) {
  struct Case {
    int tried;
    bool threat;
    JudgedBrake best;
    bool again;
  };
  // Without a threat, only a proven brake is flown, and that would have been flown at once.
  for (const Case& c : {Case{3, true, kNoBrake, true}, Case{3, true, kBrake, false}, Case{3, false, kBrake, true},
                        Case{3, false, kNoBrake, true}, Case{kEvasions, true, kNoBrake, false}}) {
    TimeIsUp room(c.tried, c.threat, c.best);
    FlightState& state = room.state();
    state.end_evasion();
    EXPECT_FALSE(state.is_busy());
    EXPECT_EQ(state.evasion.missed, c.again ? 2 : 0) << c.tried;
    EXPECT_EQ(state.evasion.was_tried, !c.again);
  }
}

TEST(FlightLateBrakes, TimeGrowsOnlySoFar) {
  TimeIsUp room(3, true, kNoBrake);
  FlightState& state = room.state();
  std::int64_t ticks = state.evasion.ticks(state.facts.spec);
  for (int k = 0; k < 20; ++k) {
    state.evasion.number = 3;
    state.evasion.best = kNoBrake;
    state.end_evasion();
    EXPECT_GE(state.evasion.ticks(state.facts.spec), ticks);
    ticks = state.evasion.ticks(state.facts.spec);
  }
  EXPECT_EQ(state.evasion.missed, 2 * kMostDoublings);
}

/// Where no brake is proven, a stop is tried again once a plan that waits has taken over, and only then: otherwise it
/// would be tried from the same state again and again. A new goal ends the stop.
TEST(FlightLateBrakes, StopIsTriedAgainAfterAPlanThatWaits) {
  for (int bits = 0; bits < 8; ++bits) {
    const bool stops = (bits & 1) != 0;
    const bool waits = (bits & 2) != 0;
    const bool has_goal = (bits & 4) != 0;
    TimeIsUp room(kEvasions, false, kNoBrake);
    FlightState& state = room.state();
    state.evasion.stop_asked = false;
    state.evasion.serves_stop = stops;
    state.facts.plans.has_waiting = waits;
    state.facts.itinerary.has_goal = has_goal;
    state.end_evasion();
    EXPECT_EQ(state.evasion.stop_asked, stops && waits && !has_goal) << bits;
  }
  TimeIsUp room(kEvasions, false, kNoBrake);  // asked for again meanwhile
  room.state().evasion.stop_asked = true;
  room.state().evasion.serves_stop = false;
  room.state().end_evasion();
  EXPECT_TRUE(room.state().evasion.stop_asked);
}

TEST(FlightLateBrakes, MissedStopIsTriedAgainUnlessThereIsANewGoal) {
  for (const bool has_goal : {false, true}) {
    TimeIsUp room(3, false, kNoBrake);
    FlightState& state = room.state();
    state.evasion.stop_asked = false;
    state.evasion.serves_stop = true;
    state.facts.itinerary.has_goal = has_goal;
    state.facts.time = state.draft.deadline + room.spec.tick;  // ticks were skipped
    state.evasion.miss(state.facts.itinerary.has_goal);
    EXPECT_EQ(state.evasion.stop_asked, !has_goal);
    EXPECT_FALSE(state.evasion.was_tried);
  }
}

/// A stop does not take back the brakes that are being tried for a threat.
TEST(FlightLateBrakes, StopLeavesBrakesInWork) {
  Flying room;
  room.state().watch.threat = true;
  room.state().watch.contact = {room.time + 1000000000, 2.0};
  room.state().facts.time = room.time;
  room.state().begin_evasion();
  ASSERT_TRUE(room.state().evasion.is_running);
  EXPECT_EQ(room.flight.stop(), Status::kOk);
  EXPECT_TRUE(room.state().evasion.is_running);
  EXPECT_TRUE(room.state().evasion.stop_asked);
  ASSERT_TRUE(room.tick_until([&] { return room.speed() == 0.0; }, 200));
  EXPECT_EQ(room.report.reason, FlightReason::kNoGoal);
}

/// No brake was proven for the threat, which is what `evaded` says. A stop tries them anew all the same.
TEST(FlightLateBrakes, StopTriesBrakesAnewUnderAThreat) {
  Flying room;
  FlightState& state = room.state();
  state.watch.threat = state.evasion.was_tried = true;
  state.watch.contact = {room.time + 1000000000, 2.0};
  EXPECT_EQ(room.flight.stop(), Status::kOk);
  room.advance(kNothing);
  EXPECT_TRUE(state.evasion.is_running);
  EXPECT_TRUE(state.evasion.serves_stop);
  EXPECT_TRUE(state.evasion.was_tried);
}

/// A box that is marked while brakes are being tried: those that failed may be free now, and the other way round.
TEST(FlightLateBrakes, BrakesAreTriedAnewOnAChangedMap) {
  Flying room;
  FlightState& state = room.state();
  EXPECT_EQ(room.flight.stop(), Status::kOk);
  room.advance(kNothing);
  ASSERT_TRUE(state.evasion.is_running);
  const int first = state.evasion.number;
  state.evasion.try_next(state.facts, state.watch, state.draft, state.tick_work);
  ASSERT_NE(state.evasion.number, first);
  state.evasion.best = kBrake;
  const std::int64_t takeover = state.draft.takeover;
  room.mark({{-10.0, 9.0, 0.0}, {-9.0, 10.0, 1.0}});
  state.prove_anew();
  EXPECT_EQ(state.evasion.number, first);
  EXPECT_LT(state.evasion.best.number, 0);
  EXPECT_EQ(state.draft.takeover, takeover);
  ASSERT_TRUE(room.tick_until([&] { return room.speed() == 0.0; }, 200));
}

/// What is flown until a brake takes over met something on an earlier map. Proven only near what was added, it still
/// does; proven as a whole, it does not.
TEST(FlightLateBrakes, ContactBeforeTheTakeoverIsForgottenOnlyByAWholeProof) {
  for (const bool met : {false, true}) {
    for (const bool added : {false, true}) {
      Flying room;
      FlightState& state = room.state();
      state.facts.plans.waiting = state.facts.plans.in_flight;
      state.facts.plans.waiting.planned.begin = room.time + 5 * room.spec.tick;
      state.facts.plans.waiting.evades = true;
      state.facts.plans.has_waiting = true;
      state.watch.meets_before = met;
      state.watch.has_added = added;
      state.watch.added = {{-10.0, 9.0, 0.0}, {-9.0, 10.0, 1.0}};
      state.facts.time = room.time;
      state.watch.prove(state.facts, Watched::kBefore);
      ASSERT_TRUE(state.watch.is_running);
      Work work{4000};
      ASSERT_EQ(state.watch.proof.step(work), Status::kOk);
      state.end_watched_part();
      EXPECT_EQ(state.watch.meets_before, met && added);
    }
  }
}

}  // namespace
