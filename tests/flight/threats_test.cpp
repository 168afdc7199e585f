// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which brake is flown where none is proven, and what happens while one is about to take over.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Flying;
using tern_test::kNothing;

constexpr double kContact = 2.0;  ///< m/s, on the committed plan

/// A flight under a threat, all of whose brakes were tried.
struct Threatened : Flying {
  Threatened() {
    FlightState& s = state();
    s.facts.time = time;
    s.watch.threat = true;
    s.draft.takeover = time + kEvadeTicks * spec.tick;
    s.watch.contact = {s.draft.takeover + 1000000000, kContact};
    s.draft.deadline = s.draft.takeover - spec.tick;
    s.evasion.is_running = true;
    s.draft.extends = false;
    s.evasion.proves = BrakeProof::kAlarm;
    s.evasion.straight = kStraight;
    s.evasion.along = kSlowDowns;
    s.evasion.number = kEvasions;
  }
  /// Is this brake flown if the committed plan is clear of everything but the alarm, or if it is not?
  bool flies(const JudgedBrake& best, bool known) {
    state().evasion.best = best;
    state().watch.known = known;
    state().end_evasion();
    return state().facts.plans.has_waiting;
  }
};

TEST(FlightThreats, SlowerBrakesAreFlownUnlessTheyMayTouchMore) {
  const auto flies = [](const JudgedBrake& best, bool known) { return Threatened().flies(best, known); };
  constexpr double kSlower = 1.0;
  constexpr double kFaster = 2.5;
  EXPECT_TRUE(flies({0, 0.1, kSlower, true}, true));
  EXPECT_TRUE(flies({0, 0.1, kSlower, true}, false));
  EXPECT_TRUE(flies({0, 0.1, kSlower, false}, false));
  EXPECT_FALSE(flies({0, 0.1, kSlower, false}, true));
  EXPECT_FALSE(flies({0, 0.1, kFaster, true}, true));
  EXPECT_FALSE(flies({0, 0.1, kFaster, false}, true));
  EXPECT_FALSE(flies({0, 0.1, kFaster, false}, false));
  EXPECT_TRUE(flies({0, 0.1, kFaster, true}, false));  // the committed plan touches more than the alarm
  EXPECT_FALSE(flies({-1, 0.1, kSlower, true}, false));
}

TEST(FlightThreats, UnprovenBrakeKeepsTheThreat) {
  Threatened room;
  FlightState& state = room.state();
  state.watch.has_alarm = true;
  ASSERT_TRUE(room.flies({0, 0.25, 1.0, true}, false));
  EXPECT_TRUE(state.watch.threat);
  EXPECT_TRUE(state.watch.has_alarm);
  EXPECT_TRUE(state.watch.known);
  EXPECT_TRUE(state.facts.plans.waiting.evades);
  EXPECT_EQ(state.watch.contact.time, state.draft.takeover + 250000000);
  EXPECT_EQ(state.watch.contact.speed, 1.0);
}

/// What is flown has its contact before any brake begins: the sharpest brake is flown, slower by then or not. The
/// report has the first contact until the takeover.
TEST(FlightThreats, ContactBeforeTheTakeoverIsBrakedFor) {
  Threatened room;
  FlightState& state = room.state();
  const std::int64_t first = room.time + room.spec.tick;
  state.watch.contact = {first, kContact};
  ASSERT_TRUE(room.flies({0, 0.0, kContact + 0.1, true}, true));
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kThreat);
  EXPECT_EQ(room.report.contact_time, first);
  EXPECT_EQ(room.report.contact_speed, kContact);
  room.time = state.facts.plans.waiting.begin();
  room.tick();
  EXPECT_EQ(room.report.contact_time, state.watch.contact.time);
}

/// The vehicle is on such a brake already: another one would only begin anew.
TEST(FlightThreats, BrakeThatComesTooLateIsNotRepeated) {
  for (const bool evades : {false, true}) {
    Threatened room;
    FlightState& state = room.state();
    state.watch.contact = {room.time, kContact};
    state.facts.plans.in_flight.evades = evades;
    EXPECT_EQ(room.flies({0, 0.0, kContact, true}, true), !evades);
  }
}

/// The same of a plan that is proven from its takeover on: the threat ends there.
TEST(FlightThreats, ContactBeforeAProvenPlanStaysAThreatUntilItsTakeover) {
  for (const bool extends : {false, true}) {
    Threatened room;
    FlightState& state = room.state();
    const std::int64_t first = room.time + room.spec.tick;
    state.watch.contact = {first, kContact};
    state.evasion.was_tried = true;
    state.draft.plan = state.facts.plans.in_flight;
    state.draft.plan.planned.begin = extends ? state.facts.plans.in_flight.begin() : state.draft.takeover;
    state.draft.extends = extends;
    state.enter_draft();
    EXPECT_EQ(state.facts.plans.has_waiting, !extends);
    for (int k = 0; k < kEvadeTicks; ++k) {
      room.tick();
      EXPECT_EQ(room.report.mode, FlightMode::kThreat) << k;
      EXPECT_EQ(room.report.contact_time, first) << k;
    }
    room.tick();
    EXPECT_EQ(room.report.mode == FlightMode::kThreat, extends);
  }
}

/// A box that is marked between two ticks, while a draft is being proven, is in no part of that proof: what was proven
/// before must not end the threat.
TEST(FlightThreats, BoxMarkedDuringAProofStaysAThreat) {
  int marked = 0;
  for (int pieces = 0; pieces < 40; ++pieces) {
    tern_test::Flying room;
    FlightState& state = room.state();
    const auto proves = [&] {
      return state.cycle.job == Job::kProve || state.cycle.job == Job::kBranch || state.cycle.job == Job::kConfirm;
    };
    for (int k = 0; k < 100000 && !proves(); ++k) room.advance(1);
    ASSERT_TRUE(proves());
    for (int k = 0; k < pieces && proves(); ++k) room.advance(1);
    if (!proves()) break;
    ++marked;
    const double wall = room.flight.rest_position().x - 0.5;
    room.mark({{wall, room.start.y - 8.0, -2.0}, {wall + 0.3, room.start.y + 8.0, 4.0}});
    state.tick_work = tern::Work{};
    room.watch(4000);
    ASSERT_TRUE(state.watch.threat);
    room.advance(4000);
    EXPECT_TRUE(state.watch.threat || (state.facts.plans.has_waiting && state.facts.plans.waiting.evades)) << pieces;
  }
  EXPECT_GT(marked, 0);
}

/// Without a threat, the committed plan is proven: a brake for stop() that is not is not flown.
TEST(FlightThreats, UnprovenStopIsNotFlown) {
  Threatened room;
  room.state().watch.threat = false;
  EXPECT_FALSE(room.flies({0, 0.1, 1.0, true}, false));
  EXPECT_FALSE(room.state().is_busy());
}

/// Something else became solid, and is still to be proven, while the brake is committed: then all of the brake is.
TEST(FlightThreats, CommitThatInterruptsAProofIsProvenAsAWhole) {
  Threatened room;
  FlightState& state = room.state();
  room.mark({{-10.0, 9.0, 0.0}, {-9.0, 10.0, 1.0}});
  room.watch(kNothing);
  ASSERT_TRUE(state.watch.is_running);
  state.watch.covers_all = false;
  ASSERT_TRUE(room.flies({0, 0.1, 1.0, true}, false));
  EXPECT_FALSE(state.watch.is_running);
  EXPECT_TRUE(state.watch.covers_all);
}

/// A brake that touches at most the alarm comes first, then the slowest contact, then the latest one.
TEST(FlightThreats, BrakesAreCompared) {
  Threatened room;
  FlightState& state = room.state();
  const JudgedBrake best{7, 0.5, 1.0, true};
  const auto replaces = [&](const JudgedBrake& tried, const JudgedBrake& other) {
    state.evasion.is_running = true;
    state.watch.threat = false;  // none is flown in the end
    state.evasion.number = kEvasions - 1;
    state.evasion.straight = kStraight;
    state.evasion.along = kSlowDowns;
    state.evasion.tried = tried;
    state.evasion.best = other;
    state.evasion.proves = BrakeProof::kAlarm;
    // Resting is proven where all is free, and not beyond the window.
    Trajectory rest = state.facts.plans.in_flight.trajectory;
    rest.count = 1;
    for (Vec3& point : rest.segments[0].points) point = {0.0, 0.0, 0.0};
    rest.origin = tried.known ? room.start : Vec3{1e3, 0.0, 0.0};
    EXPECT_EQ(state.draft.begin_proof(state.facts, rest, 0.0), Status::kRunning);
    state.tick_work = Work{4000};
    EXPECT_EQ(state.run_evasion(), Progress::kDone);
    return state.evasion.best.number == tried.number;
  };
  const JudgedBrake none{-1, 0.0, 0.0, false};
  EXPECT_TRUE(replaces({3, 0.1, 9.0, false}, none));
  EXPECT_TRUE(replaces({3, 0.5, 0.9, true}, best));
  EXPECT_FALSE(replaces({3, 0.6, 1.1, true}, best));
  EXPECT_TRUE(replaces({3, 0.6, 1.0, true}, best));
  EXPECT_FALSE(replaces({3, 0.5, 1.0, true}, best));
  EXPECT_FALSE(replaces({3, 0.4, 1.0, true}, best));
  EXPECT_FALSE(replaces({3, 0.6, 0.1, false}, best));
  EXPECT_TRUE(replaces({3, 0.1, 9.0, true}, {7, 0.5, 1.0, false}));
}

/// Straight ahead from the sharpest one on, until one is judged; then those along the path, then the other ones.
TEST(FlightThreats, BrakesAreTriedInOrder) {
  for (const int judged : {0, 3, kStraight}) {
    Threatened room;
    FlightState& state = room.state();
    state.evasion.best.number = -1;
    state.evasion.straight = state.evasion.along = 0;
    std::vector<int> numbers;
    for (int k = 0; k < kEvasions; ++k) {
      numbers.push_back(state.evasion.number_of_next());
      if (numbers.back() == judged) state.evasion.best.number = judged;
    }
    std::vector<int> expected;
    const int first = std::min(judged + 1, kStraight);
    for (int k = 0; k < first; ++k) expected.push_back(k);
    for (int k = 0; k < kSlowDowns; ++k) expected.push_back(kStraight + k);
    for (int k = first; k < kStraight; ++k) expected.push_back(k);
    EXPECT_EQ(numbers, expected) << judged;
    EXPECT_EQ(state.evasion.number_of_next(), kEvasions);
  }
}

/// A brake that is not proven, for a stop: there is no alarm that may be pardoned.
TEST(FlightThreats, WithoutAnAlarmNothingIsPardoned) {
  for (const bool has_alarm : {false, true}) {
    Threatened room;
    FlightState& state = room.state();
    const Vec3 p = room.position();
    const Box wall{{p.x + 1.0, p.y - 3.0, -2.0}, {p.x + 2.0, p.y + 3.0, 4.0}};
    room.mark(wall);
    state.watch.threat = state.watch.has_alarm = has_alarm;
    state.watch.alarm = {wall, room.map().seen_rows()};
    state.evasion.best.number = -1;
    state.evasion.number = 0;
    state.evasion.straight = 1;
    ASSERT_TRUE(state.draft.brake(state.facts, state.evasion.number, state.watch.threat, state.tick_work));
    ASSERT_TRUE(state.evasion.begin_brake_proof(BrakeProof::kClear, state.facts, state.watch, state.draft));
    state.tick_work = Work{4000};
    EXPECT_EQ(state.run_evasion(), Progress::kDone);
    ASSERT_EQ(state.evasion.proves, BrakeProof::kLimits);
    EXPECT_EQ(state.run_evasion(), Progress::kDone);
    EXPECT_EQ(state.evasion.proves, has_alarm ? BrakeProof::kAlarm : BrakeProof::kClear);
    EXPECT_EQ(state.evasion.best.number, has_alarm ? -1 : 0);
    EXPECT_FALSE(state.evasion.best.known && !has_alarm);
  }
}

/// A wall across the way, which is known from now on.
void wall_at(FlightRoom& room, double x) {
  room.mark({{x, -4.0, -2.0}, {x + 0.5, 4.0, 4.0}});
}

/// A contact is 1.9 s away, and a pending plan takes over in 0.1 s: from there, the vehicle may brake for 1.1 s, if it
/// must. Where the contact is 0.7 s away, it brakes at once.
TEST(FlightThreats, PlanInWorkGoesOnWhereItLeavesTimeToBrake) {
  for (const bool is_far : {true, false}) {
    Flying room;
    FlightState& state = room.state();
    for (int k = 0; k < 1000 && state.cycle.job != Job::kPlan; ++k) room.advance(40);
    ASSERT_EQ(state.cycle.job, Job::kPlan);
    wall_at(room, room.position().x + (is_far ? 6.0 : 2.5));
    room.watch(4000);
    ASSERT_TRUE(state.watch.threat);
    room.advance(kNothing);
    EXPECT_EQ(state.cycle.job, is_far ? Job::kPlan : Job::kIdle);
    EXPECT_EQ(state.evasion.is_running, !is_far);
    EXPECT_EQ(state.evasion.was_tried, !is_far);
  }
}

/// Something appears within the radius behind the vehicle, which has a plan that is about to take over. The plan is
/// dropped for a brake that is proven, although the ticks before it are not.
TEST(FlightThreats, BrakeIsFlownWhereWhatComesBeforeItIsNotProven) {
  Flying room;
  FlightState& state = room.state();
  const double cell = FlightRoom::kCell;
  double face = 0.0;
  const auto is_ready = [&] {
    face = (std::floor(room.position().x / cell) - 1.0) * cell;
    const double gap = room.position().x - face;
    return state.facts.plans.has_waiting && !state.facts.plans.waiting.evades && gap > 0.43 && gap < 0.47;
  };
  for (int k = 0; k < 10 && !is_ready(); ++k) {
    room.flight.set_goal({8.125, k % 2 == 0 ? 0.25 : -0.25, 1.125});
    room.tick_until(is_ready, 12);
  }
  ASSERT_TRUE(is_ready());
  room.mark({{face - 0.5, -0.5, 0.5}, {face - 0.01, 0.5, 1.5}});
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kThreat);
  ASSERT_TRUE(state.facts.plans.has_waiting);
  EXPECT_TRUE(state.facts.plans.waiting.evades);
  const std::int64_t begin = state.facts.plans.waiting.begin();
  EXPECT_EQ(
      clear_until(room.map().safe(), state.facts.plans.waiting.trajectory, 0.0, &room.spec.limits, Beyond::kSolid),
      duration(state.facts.plans.waiting.trajectory));
  EXPECT_EQ(clear_until(room.map().safe(), state.facts.plans.in_flight.trajectory,
                        seconds_between(state.facts.plans.in_flight.begin(), room.time)),
            seconds_between(state.facts.plans.in_flight.begin(), room.time));
  const FlightReport met = room.report;
  EXPECT_LT(met.contact_time, begin);
  EXPECT_GT(met.contact_speed, 2.0);
  for (; room.time < begin; room.tick()) {
    ASSERT_TRUE(state.facts.plans.has_waiting);
    EXPECT_EQ(state.facts.plans.waiting.begin(), begin);
    EXPECT_EQ(room.report.mode, FlightMode::kThreat);
    EXPECT_EQ(room.report.contact_time, met.contact_time);
    EXPECT_EQ(room.report.contact_speed, met.contact_speed);
  }
  room.tick();
  EXPECT_NE(room.report.mode, FlightMode::kThreat);
  EXPECT_EQ(room.fly(), FlightReason::kArrived);
}

/// Something comes into the way of a brake that is about to take over. It takes over all the same; brakes from there
/// are tried then.
TEST(FlightThreats, BrakeThatIsAboutToTakeOverIsNotReplaced) {
  Flying room;
  FlightState& state = room.state();
  const double x = room.position().x;
  room.mark({{x + 2.5, -4.0, -2.0}, {x + 3.0, 4.0, 4.0}});
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kThreat);
  ASSERT_TRUE(state.facts.plans.has_waiting);
  ASSERT_TRUE(state.facts.plans.waiting.evades);
  const std::int64_t begin = state.facts.plans.waiting.begin();
  const double end = room.flight.rest_position().x;
  ASSERT_LT(end, x + 2.0);
  room.mark({{end + 0.3, -4.0, -2.0}, {x + 2.5, 4.0, 4.0}});
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kThreat);
  EXPECT_TRUE(state.facts.plans.has_waiting);
  EXPECT_EQ(state.facts.plans.waiting.begin(), begin);
  EXPECT_EQ(room.flight.rest_position().x, end);
  EXPECT_TRUE(state.watch.threat);
  EXPECT_TRUE(state.watch.known);  // but for what came into the way, it is clear
  EXPECT_FALSE(state.evasion.was_tried);
  ASSERT_TRUE(room.tick_until([&] { return !state.facts.plans.has_waiting; }, 3));
  EXPECT_TRUE(room.tick_until([&] { return state.evasion.was_tried || !state.watch.threat; }, 3));
}

/// Something comes into the way of a plan that is about to take over, and not into the way of the one that is flown:
/// that one goes on, as if there had been no other, and no brake is tried.
TEST(FlightThreats, PlanThatIsFlownIsKeptWhereOnlyTheNextOneIsBlocked) {
  Flying room;
  FlightState& state = room.state();
  const Vec3 end = room.flight.rest_position();
  state.facts.plans.waiting = state.facts.plans.in_flight;
  state.facts.plans.waiting.planned.begin = room.time + 3 * room.spec.tick;
  state.facts.plans.waiting.trajectory.origin.y -= 6.0;
  state.facts.plans.has_waiting = true;
  room.mark({{4.0, -7.0, -2.0}, {5.0, -5.0, 4.0}});
  room.tick();
  EXPECT_EQ(room.report.mode, FlightMode::kThreat);  // in this tick alone
  EXPECT_FALSE(state.watch.threat);
  EXPECT_FALSE(state.facts.plans.has_waiting);
  EXPECT_FALSE(state.evasion.is_running);
  EXPECT_EQ(room.flight.rest_position().y, end.y);
  room.tick();
  EXPECT_NE(room.report.mode, FlightMode::kThreat);
}

/// A brake that would exceed a limit, before its contact or after it, is not flown.
TEST(FlightThreats, BrakesBeyondALimitAreNotFlown) {
  for (const bool is_weak : {false, true}) {
    for (const BrakeProof proves : {BrakeProof::kClear, BrakeProof::kLimits}) {
      Threatened room;
      FlightState& state = room.state();
      const Vec3 p = room.position();
      room.mark({{p.x + 1.0, p.y - 3.0, -2.0}, {p.x + 2.0, p.y + 3.0, 4.0}});
      state.evasion.best.number = -1;
      state.evasion.number = 0;
      ASSERT_TRUE(state.draft.brake(state.facts, state.evasion.number, state.watch.threat, state.tick_work));
      if (is_weak)
        state.facts.spec.limits.a_max = {0.5, 0.5, 0.5};  // for the proof alone: brakes are made by state.facts.limits
      state.evasion.tried = {0, 0.0, 1.0, true};
      ASSERT_TRUE(state.evasion.begin_brake_proof(proves, state.facts, state.watch, state.draft));
      state.tick_work = Work{4000};
      EXPECT_EQ(state.run_evasion(), Progress::kDone);
      if (proves == BrakeProof::kClear) {
        EXPECT_EQ(state.evasion.proves, is_weak ? BrakeProof::kClear : BrakeProof::kLimits);
      }
      if (proves == BrakeProof::kLimits) {
        EXPECT_EQ(state.evasion.best.number, is_weak ? -1 : 0);
      }
    }
  }
}

}  // namespace
