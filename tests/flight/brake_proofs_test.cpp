// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What ends the proof of a brake, and what is proven anew of what is flown.
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
    s.time = time;
    s.threat = true;
    s.takeover = time + kEvadeTicks * spec.tick;
    s.deadline = s.takeover - spec.tick;
    s.job = Job::kEvade;
    s.extends = false;
    s.best.number = -1;
    s.branch = 0;
    EXPECT_TRUE(s.make_evasion());
  }
  /// What ends the proof, and that the brake's limits are proven next.
  void expect_contact(ProofEnd end) {
    FlightState& s = state();
    ASSERT_TRUE(s.begin_brake_proof(BrakeProof::kClear));
    Work proof{4000};
    EXPECT_EQ(s.run_evade(proof), Progress::kDone);
    EXPECT_EQ(s.tried.number, 0);
    EXPECT_GT(s.tried.speed, 0.0);
    ASSERT_EQ(s.proves, BrakeProof::kLimits);
    EXPECT_EQ(s.proof.report().until, s.tried.until);
    EXPECT_EQ(clear_end(), end);
    Work limits{4000};
    EXPECT_EQ(s.run_evade(limits), Progress::kDone);
    EXPECT_EQ(s.best.number, 0);
    EXPECT_FALSE(s.best.known);
  }
  /// The same proof by itself.
  ProofEnd clear_end() {
    Proof proof;
    FlightState& s = state();
    EXPECT_EQ(proof.begin(map().safe(), s.draft.flown, 0.0, &s.spec.limits, Beyond::kSolid, s.grounds_of(s.draft)),
              Status::kRunning);
    while (proof.step(4000) == Status::kRunning) {
    }
    return proof.report().end;
  }
};

TEST(FlightBrakeProofs, ObstacleIsAContact) {
  Braking room;
  const Vec3 p = room.position();
  room.mark({{p.x + 1.0, p.y - 3.0, -2.0}, {p.x + 2.0, p.y + 3.0, 4.0}});
  room.expect_contact(ProofEnd::kObstacle);
}

TEST(FlightBrakeProofs, FenceIsAContact) {
  Braking room;
  const Halfspace plane{{1.0, 0.0, 0.0}, room.position().x + 0.7};
  const Fence fence{&plane, 1, FenceKind::kKeepIn};
  room.state().spec.fences = &fence;
  room.state().spec.fence_count = 1;
  room.expect_contact(ProofEnd::kFence);
}

/// The brake comes to rest half of the radius before the window's face.
TEST(FlightBrakeProofs, EndOfTheWindowIsAContact) {
  Braking room;
  const GridSpec& window = room.map().safe().spec();
  Trajectory& brake = room.state().draft.flown;
  const double way = brake.segments[brake.count - 1].points[kDegree].x;
  brake.origin.x = window.origin.x + window.cell * window.dims.x - 0.5 * FlightRoom::kRadius - way;
  room.expect_contact(ProofEnd::kOutside);
}

/// Nothing became solid, but all is to be proven.
TEST(FlightBrakeProofs, AllIsProvenAnewWhereThatIsAskedFor) {
  Flying room;
  FlightState& state = room.state();
  room.watch(kNothing);
  ASSERT_FALSE(state.watching);
  state.watch_all = true;
  room.watch(kNothing);
  EXPECT_TRUE(state.watching);
  EXPECT_FALSE(state.watch_all);
  EXPECT_FALSE(state.has_added);
  EXPECT_EQ(state.watched_part, Watched::kLatest);
  room.watch(4000);
  EXPECT_FALSE(state.watching);
  EXPECT_FALSE(state.threat);
}

/// Something appears where the vehicle is, and not in the way of what is about to take over, 6 m beside it. If that is
/// a brake, it was proven, and answers for what is flown until then, whose contact is reported; a plan is dropped.
TEST(FlightBrakeProofs, BrakeThatTakesOverAnswersForWhatComesBefore) {
  for (const bool evades : {true, false}) {
    Flying room;
    FlightState& state = room.state();
    state.next = state.now;
    state.next.begin = room.time + kEvadeTicks * room.spec.tick;
    state.next.flown.origin.y -= 6.0;
    state.next.evades = evades;
    state.has_next = true;
    const Vec3 p = room.position();
    room.mark({{p.x - 0.5, p.y - 0.5, p.z - 0.5}, {p.x + 0.5, p.y + 0.5, p.z + 0.5}});
    room.watch(4000);
    EXPECT_FALSE(state.watching);
    EXPECT_EQ(state.has_next, evades);
    EXPECT_EQ(state.threat, !evades);
    EXPECT_EQ(state.alarmed, !evades);
    EXPECT_EQ(state.meets_before, evades);
    EXPECT_EQ((evades ? state.before : state.contact).time, room.time);
    EXPECT_EQ(state.mode(), FlightMode::kThreat);
    // Near something else that became solid, it is not seen again.
    room.mark({{-10.0, 9.0, 0.0}, {-9.0, 10.0, 1.0}});
    room.watch(4000);
    EXPECT_EQ(state.meets_before, evades);
  }
}

}  // namespace
