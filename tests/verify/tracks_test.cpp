// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Room beside things that move: hand-computed, and the core's proofs against exact numbers.
#include "verify/tracks.hpp"

#include <gtest/gtest.h>

#include "exact_pair.hpp"

namespace tern_verify {
namespace {

const Rational kEnough = enough_room();

/// 4 m along x in 2 s.
TimedWay along_x(const Rational& begin = 0) {
  TimedCurve curve{{}, 2};
  for (int k = 0; k < 8; ++k) curve.points.push_back({Rational(4 * k) / 7, 0, 0});
  return {{curve}, begin, 0, Rational(1) / 2};
}

Thing ball(const Point& place, const Rational& radius) {
  Thing thing;
  thing.position = place;
  thing.radius = radius;
  return thing;
}

void expect_room(const RoomInTime& room, const Rational& exact) {
  EXPECT_LE(room.least, exact);
  EXPECT_GE(room.most, exact);
  EXPECT_GE(room.least, Rational(3) / 4 * room.most);
  EXPECT_LT(room.most - exact, Rational(1) / 10);
}

TEST(Tracks, StandingThings) {
  expect_room(room_beside(along_x(), ball({2, 3, 0}, Rational(1) / 2), kEnough), 2);
  Thing box = ball({2, 3, 4}, 0);
  box.shape = ThingShape::kBox;
  box.half = {1, 0, 0};
  expect_room(room_beside(along_x(), box, kEnough), Rational(9) / 2);
  Thing post = ball({2, 4, 4}, 1);
  post.shape = ThingShape::kCylinder;
  post.half = {0, 0, 0};
  expect_room(room_beside(along_x(), post, kEnough), Rational(9) / 2);
}

TEST(Tracks, MovingThings) {
  // Beside it at the same speed, with an error that grows: 3 - 1/2 - 1/2 - (2 + 2) at the end.
  Thing beside = ball({0, 3, 0}, Rational(1) / 2);
  beside.velocity = {2, 0, 0};
  expect_room(room_beside(along_x(), beside, kEnough), 2);
  beside.error_growth = 1;
  beside.error_speed = Rational(1) / 2;
  const RoomInTime room = room_beside(along_x(), beside, kEnough);
  EXPECT_LT(room.most, 0);
  EXPECT_GT(room.when, 1);
  beside.end = ThingEnd::kGone;
  beside.until = 0;
  EXPECT_FALSE(room_beside(along_x(), beside, kEnough).noted);
  beside.end = ThingEnd::kStays;
  // It stays at (0, 3).
  expect_room(room_beside(along_x(), beside, kEnough), 2);
  beside.from = 3;
  beside.until = 4;
  EXPECT_FALSE(room_beside(along_x(), beside, kEnough).noted);
}

TEST(Tracks, TheSmallerOfTwoTubesCounts) {
  Thing thing = ball({0, 3, 0}, Rational(1) / 2);
  thing.error_growth = 100;
  thing.reach = Rational(1) / 4;
  // The room in the ball that it can reach, sqrt(9 + 4 t^2) - 1 - t / 4, is least after 0.189 s.
  const RoomInTime room = room_beside(along_x(), thing, kEnough);
  EXPECT_LT(room.least, decimal(19766, 4));
  EXPECT_GT(room.most, decimal(19764, 4));
}

/// Intervals and exact numbers bound the same least room, and answer alike.
void expect_alike(const RoomInTime& fast, const RoomInTime& exact) {
  EXPECT_EQ(fast.noted, exact.noted);
  EXPECT_EQ(fast.leaves, exact.leaves);
  EXPECT_LE(fast.least, exact.most);
  EXPECT_LE(exact.least, fast.most);
  EXPECT_EQ(fast.least >= kEnough, exact.least >= kEnough);
}

TEST(Tracks, IntervalsFindWhatExactNumbersDo) {
  tern_test::Random random(42);
  for (int i = 0; i < tern_test::scaled(300); ++i) {
    SCOPED_TRACE(i);
    const tern_test::TrackPair pair = tern_test::random_pair(random);
    tern::Track track = pair.track;
    track.pieces = pair.pieces.data();
    const TimedWay way = way_of(pair);
    const Thing thing = thing_of(track);
    expect_alike(room_beside(way, thing, kEnough), room_beside(way, thing, kEnough, Numbers::kExact));
  }
}

/// A tangent, a picometre more or less than what is needed, near the origin and far from it.
TEST(Tracks, APicometreCounts) {
  for (const int far : {0, 10000000}) {
    TimedWay way = along_x();
    for (Point& p : way.curves[0].points) p = p + Point{far, far, far};
    for (const int sign : {-1, 1}) {
      const Rational aside = 1 + kEnough + sign * decimal(1, 12);
      const RoomInTime room = room_beside(way, ball({far + 2, far + aside, far}, Rational(1) / 2), kEnough);
      EXPECT_EQ(room.least >= kEnough, sign > 0);
      EXPECT_EQ(room.most < kEnough, sign < 0);
    }
  }
}

/// Beyond 1e150 m, squares overflow, so intervals know nothing.
TEST(Tracks, ExactNumbersAreAskedWhereIntervalsDoNotTell) {
  const Rational far = Rational(Integer(1) << 600);
  const RoomInTime room = room_beside(along_x(), ball({0, far, 0}, 0), kEnough);
  EXPECT_GE(room.least, Rational(3) / 4 * far);
  EXPECT_LE(room.least, far);
}

/// It begins 1e160 m away, whose square overflows, and comes within 0.1 m above the vehicle, where 0.3 are needed.
TEST(Tracks, WhatOverflowsProvesNothing) {
  const TimedWay way{{{Polygon<3>(8, {0, 0, 0}), 1}}, 0, 0, decimal(3, 1)};
  Thing thing = ball({0, 0, 0}, Rational(1) / 2);
  thing.shape = ThingShape::kCylinder;
  thing.half = {0, 0, Rational(1) / 2};
  TimedCurve curve{{}, 1};
  for (int k = 0; k < 8; ++k) curve.points.push_back({Rational(k < 4 ? 1e160 : -1e160), 0, decimal(-6, 1)});
  thing.pieces = {curve};
  for (const Numbers numbers : {Numbers::kIntervalsFirst, Numbers::kExact}) {
    EXPECT_LT(room_beside(way, thing, kEnough, numbers).most, kEnough);
  }
}

/// What the core proves holds in exact numbers, without any rounding. What it refuses has next to no room.
TEST(Tracks, TheCoresProofsHoldExactly) {
  tern_test::Random random(41);
  int proven = 0;
  int refused = 0;
  for (int i = 0; i < tern_test::scaled(500); ++i) {
    tern_test::TrackPair pair = tern_test::random_pair(random);
    tern_test::hold_pieces(pair);
    const PairFinding finding = prove_exactly(pair);
    proven += finding.proven ? 1 : 0;
    refused += finding.refused ? 1 : 0;
    EXPECT_FALSE(finding.is_unsound) << "case " << i;
    EXPECT_FALSE(finding.is_timid) << "case " << i;
  }
  EXPECT_GT(proven, refused / 4);
}

}  // namespace
}  // namespace tern_verify
