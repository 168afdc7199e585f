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

constexpr Evasion kNoBrake{-1, 0.0, 0.0, false};
constexpr Evasion kBrake{0, 0.5, 1.0, true};

/// Brakes are in work, and `tried` of them were tried when the time was up.
struct TimeIsUp : Flying {
  TimeIsUp(int tried, bool threat, const Evasion& best) {
    FlightState& s = state();
    s.time = time;
    s.threat = threat;
    s.takeover = time + kEvadeTicks * spec.tick;
    s.contact = {s.takeover + 1000000000, 2.0};
    s.deadline = s.takeover - spec.tick;
    s.job = Job::kEvade;
    s.extends = false;
    s.evaded = true;
    s.branch = tried;
    s.best = best;
  }
};

TEST(FlightLateBrakes, GetMoreTimeUnlessOneCanBeFlown) {
  struct Case {
    int tried;
    bool threat;
    Evasion best;
    bool again;
  };
  // Without a threat, only a proven brake is flown, and that would have been flown at once.
  for (const Case& c : {Case{3, true, kNoBrake, true}, Case{3, true, kBrake, false}, Case{3, false, kBrake, true},
                        Case{3, false, kNoBrake, true}, Case{kEvasions, true, kNoBrake, false}}) {
    TimeIsUp room(c.tried, c.threat, c.best);
    FlightState& state = room.state();
    state.end_evade();
    EXPECT_EQ(state.job, Job::kIdle);
    EXPECT_EQ(state.missed, c.again ? 2 : 0) << c.tried;
    EXPECT_EQ(state.evaded, !c.again);
  }
}

TEST(FlightLateBrakes, TimeGrowsOnlySoFar) {
  TimeIsUp room(3, true, kNoBrake);
  FlightState& state = room.state();
  std::int64_t ticks = state.evade_ticks();
  for (int k = 0; k < 20; ++k) {
    state.branch = 3;
    state.best = kNoBrake;
    state.end_evade();
    EXPECT_GE(state.evade_ticks(), ticks);
    ticks = state.evade_ticks();
  }
  EXPECT_EQ(state.missed, 2 * kMostDoublings);
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
    state.stopping = false;
    state.stops = stops;
    state.has_next = waits;
    state.has_goal = has_goal;
    state.end_evade();
    EXPECT_EQ(state.stopping, stops && waits && !has_goal) << bits;
  }
  TimeIsUp room(kEvasions, false, kNoBrake);  // asked for again meanwhile
  room.state().stopping = true;
  room.state().stops = false;
  room.state().end_evade();
  EXPECT_TRUE(room.state().stopping);
}

TEST(FlightLateBrakes, MissedStopIsTriedAgainUnlessThereIsANewGoal) {
  for (const bool has_goal : {false, true}) {
    TimeIsUp room(3, false, kNoBrake);
    FlightState& state = room.state();
    state.stopping = false;
    state.stops = true;
    state.has_goal = has_goal;
    state.time = state.deadline + room.spec.tick;  // ticks were skipped
    state.miss_evasion();
    EXPECT_EQ(state.stopping, !has_goal);
    EXPECT_FALSE(state.evaded);
  }
}

/// A stop does not take back the brakes that are being tried for a threat.
TEST(FlightLateBrakes, StopLeavesBrakesInWork) {
  Flying room;
  room.state().threat = true;
  room.state().contact = {room.time + 1000000000, 2.0};
  room.state().time = room.time;
  room.state().begin_evade();
  ASSERT_EQ(room.state().job, Job::kEvade);
  EXPECT_EQ(room.flight.stop(), Status::kOk);
  EXPECT_EQ(room.state().job, Job::kEvade);
  EXPECT_TRUE(room.state().stopping);
  ASSERT_TRUE(room.tick_until([&] { return room.speed() == 0.0; }, 200));
  EXPECT_EQ(room.report.reason, FlightReason::kNoGoal);
}

/// No brake was proven for the threat, which is what `evaded` says. A stop tries them anew all the same.
TEST(FlightLateBrakes, StopTriesBrakesAnewUnderAThreat) {
  Flying room;
  FlightState& state = room.state();
  state.threat = state.evaded = true;
  state.contact = {room.time + 1000000000, 2.0};
  EXPECT_EQ(room.flight.stop(), Status::kOk);
  room.advance(kNothing);
  EXPECT_EQ(state.job, Job::kEvade);
  EXPECT_TRUE(state.stops);
  EXPECT_TRUE(state.evaded);
}

/// A box that is marked while brakes are being tried: those that failed may be free now, and the other way round.
TEST(FlightLateBrakes, BrakesAreTriedAnewOnAChangedMap) {
  Flying room;
  FlightState& state = room.state();
  EXPECT_EQ(room.flight.stop(), Status::kOk);
  room.advance(kNothing);
  ASSERT_EQ(state.job, Job::kEvade);
  const int first = state.branch;
  state.next_evasion();
  ASSERT_NE(state.branch, first);
  state.best = kBrake;
  const std::int64_t takeover = state.takeover;
  room.mark({{-10.0, 9.0, 0.0}, {-9.0, 10.0, 1.0}});
  state.note_changed_map();
  EXPECT_EQ(state.branch, first);
  EXPECT_LT(state.best.number, 0);
  EXPECT_EQ(state.takeover, takeover);
  ASSERT_TRUE(room.tick_until([&] { return room.speed() == 0.0; }, 200));
}

/// What is flown until a brake takes over met something on an earlier map. Proven only near what was added, it still
/// does; proven as a whole, it does not.
TEST(FlightLateBrakes, ContactBeforeTheTakeoverIsForgottenOnlyByAWholeProof) {
  for (const bool met : {false, true}) {
    for (const bool added : {false, true}) {
      Flying room;
      FlightState& state = room.state();
      state.next = state.now;
      state.next.begin = room.time + 5 * room.spec.tick;
      state.next.evades = true;
      state.has_next = true;
      state.meets_before = met;
      state.has_added = added;
      state.added = {{-10.0, 9.0, 0.0}, {-9.0, 10.0, 1.0}};
      state.time = room.time;
      state.watch_part(Watched::kBefore);
      ASSERT_TRUE(state.watching);
      Work work{4000};
      ASSERT_EQ(state.step_proof(state.watch, work), Progress::kDone);
      state.end_part();
      EXPECT_EQ(state.meets_before, met && added);
    }
  }
}

}  // namespace
