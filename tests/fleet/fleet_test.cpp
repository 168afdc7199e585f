// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a Fleet answers, step by step: who asks whom, why plans are dropped, what is refused, what traffic it tells of.
#include "tern/fleet.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "fleet/plans.hpp"

namespace {

using namespace tern_test;
using tern::Announcement;
using tern::Fleet;
using tern::FleetBlock;
using tern::Heard;
using tern::Status;
using tern::Vec3;

tern::FleetSpec spec_of(std::uint16_t id) {
  tern::FleetSpec spec;
  spec.id = id;
  spec.incarnation = 1;
  spec.radius = 0.5;
  spec.tick = kSecond / 10;
  return spec;
}

/// Vehicles 1 and 2 at rest 10 m apart, and what each says.
class FleetPair : public testing::Test {
 protected:
  FleetPair() {
    for (int v = 0; v < 2; ++v) begin(v, spec_of(static_cast<std::uint16_t>(v + 1)));
  }
  void begin(int v, const tern::FleetSpec& spec) {
    ASSERT_EQ(fleet(v).begin(spec, resting(places_[v], 0), now_), Status::kOk);
    ASSERT_EQ(fleet(v).add(static_cast<std::uint16_t>(2 - v), now_), Status::kOk);
  }
  Fleet& fleet(int v) { return *fleets_[v]; }
  void say(int from) {
    std::uint8_t packet[1400];
    while (const std::int32_t size = fleet(from).write(packet, sizeof packet)) {
      fleet(1 - from).receive(packet, size, now_);
    }
  }
  void meet() {
    for (const int from : {0, 1, 0, 1}) say(from);
  }
  void advance(int v) {
    tern::Work work(100000);
    fleet(v).advance(now_, work);
  }
  Status announce(int v, const Vec3& to, std::int64_t takeover) {
    const Status status = fleet(v).announce(straight(places_[v], to, takeover, 4.0), takeover, now_);
    advance(v);
    return status;
  }
  void expect_dropped(int v, FleetBlock why, std::uint16_t by) {
    EXPECT_EQ(fleet(v).report().announcement, Announcement::kDropped);
    EXPECT_EQ(fleet(v).report().blocked, why);
    EXPECT_EQ(fleet(v).report().blocked_by, by);
    EXPECT_EQ(fleet(v).announced(), nullptr);
  }

  std::int64_t now_ = kSecond;
  const Vec3 places_[2] = {{0.0, 0.0, 1.0}, {10.0, 0.0, 1.0}};
  std::unique_ptr<Fleet> fleets_[2] = {std::make_unique<Fleet>(), std::make_unique<Fleet>()};
};

TEST_F(FleetPair, NobodyFliesBeforeTheyMet) {
  EXPECT_EQ(announce(0, {0, 5, 1}, 2 * kSecond), Status::kOk);
  expect_dropped(0, FleetBlock::kSilent, 2);
  say(1);  // 2 was heard, but has not heard of 1
  EXPECT_EQ(announce(0, {0, 5, 1}, 2 * kSecond), Status::kOk);
  expect_dropped(0, FleetBlock::kSilent, 2);
  EXPECT_FALSE(fleet(0).neighbour(0).ready);
  meet();
  EXPECT_TRUE(fleet(0).neighbour(0).ready);
  EXPECT_FALSE(fleet(0).neighbour(0).has_right_of_way);
  EXPECT_TRUE(fleet(1).neighbour(0).has_right_of_way);
}

TEST_F(FleetPair, TheFirstOneAsksNobody) {
  meet();
  ASSERT_EQ(announce(0, {0, 5, 1}, 2 * kSecond), Status::kOk);
  EXPECT_EQ(fleet(0).report().announcement, Announcement::kOpen);
  EXPECT_TRUE(fleet(0).report().cleared);
  now_ = 2 * kSecond - 1;
  advance(0);
  EXPECT_EQ(fleet(0).flown()->segments[0].duration, 1.0);
  now_ = 2 * kSecond;
  advance(0);
  EXPECT_EQ(fleet(0).report().announcement, Announcement::kTaken);
  EXPECT_EQ(fleet(0).flown()->segments[0].duration, 4.0);
}

TEST_F(FleetPair, TheSecondOneNeedsAnAnswer) {
  meet();
  ASSERT_EQ(announce(1, {10, 5, 1}, 2 * kSecond), Status::kOk);
  EXPECT_EQ(fleet(1).report().announcement, Announcement::kOpen);
  EXPECT_FALSE(fleet(1).report().cleared);
  say(1);
  advance(0);
  say(0);
  EXPECT_TRUE(fleet(1).report().cleared);
  // What 1 agreed to, it keeps clear of, though it does not know whether 2 takes it over.
  ASSERT_EQ(announce(0, {10, 5, 1}, 3 * kSecond), Status::kOk);
  expect_dropped(0, FleetBlock::kConflict, 2);
  now_ = 2 * kSecond;
  advance(1);
  EXPECT_EQ(fleet(1).report().announcement, Announcement::kTaken);
}

TEST_F(FleetPair, NoAnswerIsNo) {
  meet();
  ASSERT_EQ(announce(1, {10, 5, 1}, 2 * kSecond), Status::kOk);
  now_ = 2 * kSecond;
  advance(1);
  expect_dropped(1, FleetBlock::kUnanswered, 1);
  EXPECT_EQ(fleet(1).flown()->segments[0].duration, 1.0);
}

TEST_F(FleetPair, RefusedByAnAnnouncement) {
  meet();
  ASSERT_EQ(announce(0, {5, 5, 1}, 2 * kSecond), Status::kOk);
  ASSERT_EQ(announce(1, {5, 5, 1}, 2 * kSecond), Status::kOk);
  say(1);
  advance(0);
  say(0);
  advance(1);
  expect_dropped(1, FleetBlock::kRefused, 1);
}

// Once 1 hears that 2 dropped its plan, the space is free.
TEST_F(FleetPair, WithdrawnPlansAreSettled) {
  meet();
  ASSERT_EQ(announce(1, {10, 5, 1}, 2 * kSecond), Status::kOk);
  say(1);
  advance(0);
  fleet(1).withdraw(now_);
  EXPECT_EQ(fleet(1).report().announcement, Announcement::kNone);
  ASSERT_EQ(announce(0, {10, 5, 1}, 3 * kSecond), Status::kOk);
  expect_dropped(0, FleetBlock::kConflict, 2);
  say(1);
  ASSERT_EQ(announce(0, {10, 5, 1}, 3 * kSecond), Status::kOk);
  EXPECT_EQ(fleet(0).report().announcement, Announcement::kOpen);
}

TEST_F(FleetPair, TooLate) {
  meet();
  ASSERT_EQ(announce(0, {0, 5, 1}, 2 * kSecond), Status::kOk);
  now_ = 2 * kSecond + kSecond / 10 + 1;
  advance(0);
  expect_dropped(0, FleetBlock::kLate, 0);
  ASSERT_EQ(fleet(0).announce(straight(places_[0], {0, 5, 1}, 3 * kSecond, 4.0), 3 * kSecond, now_), Status::kOk);
  now_ = 3 * kSecond;
  tern::Work none;
  fleet(0).advance(now_, none);
  expect_dropped(0, FleetBlock::kLate, 0);
}

TEST_F(FleetPair, RestartsAndDeparturesDropWhatIsAnnounced) {
  meet();
  ASSERT_EQ(announce(0, {0, 5, 1}, 2 * kSecond), Status::kOk);
  tern::FleetSpec again = spec_of(2);
  again.incarnation = 2;
  begin(1, again);
  say(1);
  expect_dropped(0, FleetBlock::kRestarted, 2);
  meet();
  ASSERT_EQ(announce(1, {10, 5, 1}, 2 * kSecond), Status::kOk);
  fleet(0).leave(now_);
  EXPECT_EQ(announce(0, {0, 5, 1}, 2 * kSecond), Status::kInvalidArgument);
  say(0);
  expect_dropped(1, FleetBlock::kRestarted, 1);
  // From then on 2 asks nobody, and keeps clear of the place of 1.
  ASSERT_EQ(announce(1, {0.5, 0, 1}, 2 * kSecond), Status::kOk);
  expect_dropped(1, FleetBlock::kConflict, 1);
  ASSERT_EQ(announce(1, {10, 5, 1}, 2 * kSecond), Status::kOk);
  EXPECT_TRUE(fleet(1).report().cleared);
}

TEST_F(FleetPair, PriorityGoesBeforeIds) {
  tern::FleetSpec urgent = spec_of(2);
  urgent.incarnation = 2;
  urgent.priority = 1;
  begin(1, urgent);
  meet();
  EXPECT_TRUE(fleet(0).neighbour(0).has_right_of_way);
  ASSERT_EQ(announce(1, {10, 5, 1}, 2 * kSecond), Status::kOk);
  EXPECT_TRUE(fleet(1).report().cleared);
}

TEST_F(FleetPair, MembersThatGo) {
  EXPECT_EQ(fleet(0).neighbours(), 1);
  EXPECT_EQ(fleet(0).remove(3, now_), Status::kInvalidArgument);
  EXPECT_EQ(fleet(0).remove(2, now_), Status::kOk);
  EXPECT_EQ(fleet(0).neighbours(), 0);
  ASSERT_EQ(announce(0, {0, 5, 1}, 2 * kSecond), Status::kOk);
  EXPECT_TRUE(fleet(0).report().cleared) << "alone";
  EXPECT_EQ(fleet(0).add(3, now_), Status::kOk);
  expect_dropped(0, FleetBlock::kRestarted, 3);
}

// 2 will fly 8 m in 4 s; half a second after its beginning, the wait of the clock's error is over and left out.
// What it agreed to with a member that was removed is forgotten, and the member may remember it.
TEST_F(FleetPair, WhoWasRemovedMeetsAFleetThatBeginsAnew) {
  meet();
  EXPECT_EQ(fleet(0).remove(2, now_), Status::kOk);
  EXPECT_EQ(fleet(0).add(2, now_), Status::kInvalidArgument);
  EXPECT_EQ(fleet(0).add(3, now_), Status::kOk);
  tern::FleetSpec again = spec_of(1);
  again.incarnation = 2;
  begin(0, again);
  EXPECT_EQ(fleet(0).neighbours(), 1);
}

TEST_F(FleetPair, APlanOfItsOwnIsNoBeginning) {
  tern::FleetSpec again = spec_of(1);
  again.incarnation = 2;
  EXPECT_EQ(fleet(0).begin(again, *fleet(0).flown(), now_), Status::kInvalidArgument);
  EXPECT_EQ(fleet(0).neighbours(), 1);
  const tern::Trajectory copy = *fleet(0).flown();
  EXPECT_EQ(fleet(0).begin(again, copy, now_), Status::kOk);
  EXPECT_EQ(fleet(0).neighbours(), 0);
}

TEST_F(FleetPair, TrafficIsWhatMayBeFlown) {
  tern::FleetSpec vague = spec_of(1);
  vague.incarnation = 2;
  vague.clock_error = kSecond / 100;
  vague.speed = 3.0;
  begin(0, vague);
  meet();
  ASSERT_EQ(announce(1, {10, 8, 1}, 2 * kSecond), Status::kOk);
  say(1);
  advance(0);
  tern::Track tracks[2];
  tern::TrackPiece pieces[8];
  std::int32_t count = -1;
  ASSERT_EQ(fleet(0).traffic(now_, tracks, 2, pieces, 8, count), Status::kOk);
  ASSERT_EQ(count, 2);
  EXPECT_EQ(tracks[0].piece_count, 1) << "still resting by its first plan";
  EXPECT_EQ(tracks[0].radius, 0.5);
  EXPECT_EQ(tracks[1].piece_count, 2);
  EXPECT_EQ(tracks[1].measured, 2 * kSecond - kSecond / 100);
  // 2 * (units of 2^-11 m, 14 m/s of the hodograph) and 3 m/s of this vehicle's own, in 10 ms.
  EXPECT_NEAR(tracks[1].error, 2.0 * (0.00042 + 0.14) + 0.03, 0.0001);
  ASSERT_EQ(fleet(0).traffic(now_ + 3 * kSecond / 2, tracks, 2, pieces, 8, count), Status::kOk);
  EXPECT_EQ(tracks[0].piece_count, 0) << "only its place is left";
  EXPECT_EQ(tracks[0].position.x, 10.0);
  EXPECT_EQ(tracks[1].piece_count, 1);
  EXPECT_EQ(tracks[1].measured, 2 * kSecond);
  EXPECT_EQ(fleet(0).traffic(now_, tracks, 1, pieces, 8, count), Status::kTracksFull);
  EXPECT_EQ(count, 1);
  EXPECT_EQ(fleet(0).traffic(now_, tracks, 2, pieces, 2, count), Status::kTrackPiecesFull);
}

TEST_F(FleetPair, WhatPacketsBring) {
  std::uint8_t packet[1400];
  const std::int32_t size = fleet(1).write(packet, sizeof packet);
  EXPECT_EQ(fleet(0).receive(packet, size, now_), Heard::kNews);
  EXPECT_EQ(fleet(0).receive(packet, size, now_), Heard::kOld);
  EXPECT_EQ(fleet(1).receive(packet, size, now_), Heard::kSelf);
  EXPECT_EQ(fleet(0).receive(packet, 5, now_), Heard::kDamaged);
  EXPECT_EQ(fleet(0).receive(nullptr, size, now_), Heard::kDamaged);
  std::uint8_t other[1400];
  std::copy(packet, packet + size, other);
  other[20] ^= 1;
  EXPECT_EQ(fleet(0).receive(other, size, now_), Heard::kOld) << "of a state that is known nothing is read";
  other[3] ^= 1;
  EXPECT_EQ(fleet(0).receive(other, size, now_), Heard::kDamaged);
  std::copy(packet, packet + size, other);
  other[1] = 9;
  EXPECT_EQ(fleet(0).receive(other, size, now_), Heard::kStranger);
  other[0] = 0x20;
  EXPECT_EQ(fleet(0).receive(other, size, now_), Heard::kOtherVersion);
  other[0] = 0x12;  // a beacon: members are by list
  EXPECT_EQ(fleet(0).receive(other, size, now_), Heard::kOld);
  other[0] = 0x14;
  EXPECT_EQ(fleet(0).receive(other, size, now_), Heard::kDamaged);
  other[0] = 0x11;
  other[1] = 2;
  other[7] = other[8] = 0xFF;  // a plan of 65535 bytes
  EXPECT_EQ(fleet(0).receive(other, tern::kFleetPacketBytes, now_), Heard::kTooLong);
  begin(0, [] {
    tern::FleetSpec again = spec_of(1);
    again.incarnation = 2;
    return again;
  }());
  EXPECT_EQ(fleet(0).receive(packet, size, now_ - 1), Heard::kClockAhead);
  EXPECT_EQ(fleet(0).neighbour(0).incarnation, 0u);
}

TEST_F(FleetPair, RefusesWhatIsWrong) {
  const tern::Trajectory rest = resting({}, 0);
  Fleet other;
  EXPECT_EQ(other.add(2, 0), Status::kInvalidArgument) << "before begin()";
  EXPECT_EQ(other.announce(rest, 2, 1), Status::kInvalidArgument);
  EXPECT_EQ(other.flown(), nullptr);
  EXPECT_EQ(other.write(nullptr, 100), 0);
  const auto refused = [&](auto change) {
    tern::FleetSpec spec = spec_of(1);
    change(spec);
    return other.begin(spec, rest, 0) == Status::kInvalidArgument;
  };
  EXPECT_TRUE(refused([](tern::FleetSpec& spec) { spec.incarnation = 0; }));
  EXPECT_TRUE(refused([](tern::FleetSpec& spec) { spec.radius = 0.0; }));
  EXPECT_TRUE(refused([](tern::FleetSpec& spec) { spec.radius = 61.0; }));
  EXPECT_TRUE(refused([](tern::FleetSpec& spec) { spec.clock_error = -1; }));
  EXPECT_TRUE(refused([](tern::FleetSpec& spec) { spec.tick = 0; }));
  EXPECT_TRUE(refused([](tern::FleetSpec& spec) { spec.speed = -1.0; }));
  EXPECT_EQ(other.begin(spec_of(1), rest, -1), Status::kInvalidArgument) << "before the plan begins";
  EXPECT_EQ(fleet(0).add(1, now_), Status::kInvalidArgument) << "itself";
  EXPECT_EQ(fleet(0).announce(rest, now_, now_), Status::kInvalidArgument) << "no time is left";
  tern::Trajectory moves = straight({}, {1, 0, 0}, 2 * kSecond, 1.0);
  moves.segments[0].points[6].x = 0.5;
  EXPECT_EQ(fleet(0).announce(moves, 2 * kSecond, now_), Status::kInvalidArgument) << "ends in motion";
}

}  // namespace
