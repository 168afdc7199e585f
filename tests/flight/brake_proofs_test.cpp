// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What ends the proof of a brake, and what is proven anew of the committed plan.
#include <gtest/gtest.h>

#include "support/flight_room.hpp"

namespace {

using namespace tern;
using tern_test::FlightRoom;
using tern_test::Flying;
using tern_test::kNothing;

/// A flight whose sharpest brake is about to be proven.
struct Braking : Flying {
  Braking() {
    FlightState& s = state();
    s.facts.time = time;
    s.watch.threat = true;
    s.draft.takeover = time + kEvadeTicks * spec.tick;
    s.draft.deadline = s.draft.takeover - spec.tick;
    s.evasion.is_running = true;
    s.draft.extends = false;
    s.evasion.best.number = -1;
    s.evasion.number = 0;
    EXPECT_TRUE(s.draft.brake(s.facts, s.evasion.number, s.watch.threat, s.tick_work));
  }
  /// What ends the proof, and that the brake's limits are proven next.
  void expect_contact(Finding end) {
    FlightState& s = state();
    ASSERT_TRUE(s.evasion.begin_brake_proof(BrakeProof::kClear, s.facts, s.watch, s.draft));
    s.tick_work = Work{4000};
    EXPECT_EQ(s.run_evasion(), Progress::kDone);
    EXPECT_EQ(s.evasion.tried.number, 0);
    EXPECT_GT(s.evasion.tried.speed, 0.0);
    ASSERT_EQ(s.evasion.proves, BrakeProof::kLimits);
    EXPECT_EQ(s.draft.proof.report().until, s.evasion.tried.until);
    EXPECT_EQ(clear_end(), end);
    s.tick_work = Work{4000};
    EXPECT_EQ(s.run_evasion(), Progress::kDone);
    EXPECT_EQ(s.evasion.best.number, 0);
    EXPECT_FALSE(s.evasion.best.known);
  }
  /// The same proof by itself.
  Finding clear_end() {
    Proof proof;
    FlightState& s = state();
    EXPECT_EQ(proof.begin(map().safe(), s.draft.plan.trajectory, 0.0, &s.facts.spec.limits, Beyond::kSolid,
                          grounds_of(s.facts.spec, s.draft.plan)),
              Status::kRunning);
    while (proof.step(4000) == Status::kRunning) {
    }
    return proof.report().finding;
  }
};

TEST(FlightBrakeProofs, ObstacleIsAContact) {
  Braking room;
  const Vec3 p = room.position();
  room.mark({{p.x + 1.0, p.y - 3.0, -2.0}, {p.x + 2.0, p.y + 3.0, 4.0}});
  room.expect_contact(Finding::kObstacle);
}

TEST(FlightBrakeProofs, FenceIsAContact) {
  Braking room;
  const Halfspace plane{{1.0, 0.0, 0.0}, room.position().x + 0.7};
  const Fence fence{&plane, 1, FenceKind::kKeepIn};
  room.state().facts.spec.fences = &fence;
  room.state().facts.spec.fence_count = 1;
  room.expect_contact(Finding::kFence);
}

/// The brake comes to rest half of the radius before the window's face.
TEST(FlightBrakeProofs, EndOfTheWindowIsAContact) {
  Braking room;
  const GridSpec& window = room.map().safe().spec();
  Trajectory& brake = room.state().draft.plan.trajectory;
  const double way = brake.segments[brake.count - 1].points[kDegree].x;
  brake.origin.x = window.origin.x + window.cell * window.dims.x - 0.5 * FlightRoom::kRadius - way;
  room.expect_contact(Finding::kOutside);
}

/// Nothing became solid, but all is to be proven.
TEST(FlightBrakeProofs, AllIsProvenAnewWhereThatIsAskedFor) {
  Flying room;
  FlightState& state = room.state();
  room.watch(kNothing);
  ASSERT_FALSE(state.watch.is_running);
  state.watch.covers_all = true;
  room.watch(kNothing);
  EXPECT_TRUE(state.watch.is_running);
  EXPECT_FALSE(state.watch.covers_all);
  EXPECT_FALSE(state.watch.has_added);
  EXPECT_EQ(state.watch.part, Watched::kLatest);
  room.watch(4000);
  EXPECT_FALSE(state.watch.is_running);
  EXPECT_FALSE(state.watch.threat);
}

/// Something appears where the vehicle is, and not in the way of what is about to take over, 6 m beside it. If that is
/// a brake, it was proven, and answers for the committed plan until then, whose contact is reported; a plan is dropped.
TEST(FlightBrakeProofs, BrakeThatTakesOverAnswersForWhatComesBefore) {
  for (const bool evades : {true, false}) {
    Flying room;
    FlightState& state = room.state();
    state.facts.plans.waiting = state.facts.plans.in_flight;
    state.facts.plans.waiting.planned.begin = room.time + kEvadeTicks * room.spec.tick;
    state.facts.plans.waiting.trajectory.origin.y -= 6.0;
    state.facts.plans.waiting.evades = evades;
    state.facts.plans.has_waiting = true;
    const Vec3 p = room.position();
    room.mark({{p.x - 0.5, p.y - 0.5, p.z - 0.5}, {p.x + 0.5, p.y + 0.5, p.z + 0.5}});
    room.watch(4000);
    EXPECT_FALSE(state.watch.is_running);
    EXPECT_EQ(state.facts.plans.has_waiting, evades);
    EXPECT_EQ(state.watch.threat, !evades);
    EXPECT_EQ(state.watch.alarmed, !evades);
    EXPECT_EQ(state.watch.meets_before, evades);
    EXPECT_EQ((evades ? state.watch.before : state.watch.contact).time, room.time);
    state.finish_report(0);
    EXPECT_EQ(state.report.mode, FlightMode::kThreat);
    // Near something else that became solid, it is not seen again.
    room.mark({{-10.0, 9.0, 0.0}, {-9.0, 10.0, 1.0}});
    room.watch(4000);
    EXPECT_EQ(state.watch.meets_before, evades);
  }
}

}  // namespace
