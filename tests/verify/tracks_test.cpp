// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Room beside things that move: hand-computed, and the core's proofs against exact numbers.
#include "verify/tracks.hpp"

#include <gtest/gtest.h>

#include "support/track_pairs.hpp"
#include "tern/track_proof.hpp"

namespace tern_verify {
namespace {

const Rational kEnough = -decimal(4, 9);

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

Point exact(const tern::Vec3& v) {
  return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

Polygon<3> exact(const tern::Vec3* points, const tern::Vec3& origin) {
  Polygon<3> polygon;
  for (int k = 0; k < tern::kControlPoints; ++k) polygon.push_back(exact(points[k]) + exact(origin));
  return polygon;
}

Rational seconds(std::int64_t time) {
  return Rational(time) / 1000000000;
}

TimedWay way_of(const tern_test::TrackPair& pair) {
  TimedWay way{{}, seconds(pair.plan.begin), Rational(pair.grounds.rest), Rational(pair.grounds.radius)};
  for (int s = 0; s < pair.plan.count; ++s) {
    const tern::Segment& segment = pair.plan.segments[s];
    way.curves.push_back({exact(segment.points, pair.plan.origin), Rational(segment.duration)});
  }
  return way;
}

Thing thing_of(const tern::Track& track) {
  Thing thing;
  thing.shape = static_cast<ThingShape>(track.shape);
  thing.radius = Rational(track.radius);
  thing.half = exact(track.half);
  thing.position = exact(track.position);
  thing.velocity = exact(track.velocity);
  for (int p = 0; p < track.piece_count; ++p) {
    thing.pieces.push_back({exact(track.pieces[p].points, track.position), Rational(track.pieces[p].duration)});
  }
  thing.error = Rational(track.error);
  thing.error_speed = Rational(track.error_speed);
  thing.error_growth = Rational(track.error_growth);
  thing.reach = Rational(track.reach);
  thing.from = seconds(track.measured);
  thing.until = seconds(track.until);
  thing.end = static_cast<ThingEnd>(track.end);
  return thing;
}

/// What the core proves holds in exact numbers, without any rounding. What it refuses has next to no room.
TEST(Tracks, TheCoresProofsHoldExactly) {
  tern_test::Random random(41);
  int proven = 0;
  int refused = 0;
  for (int i = 0; i < tern_test::scaled(500); ++i) {
    tern_test::TrackPair pair = tern_test::random_pair(random);
    tern_test::hold_pieces(pair);
    tern::ProofReport report;
    const double until = tern::clear_until(pair.plan, 0.0, pair.grounds, &report);
    TimedWay way = way_of(pair);
    if (report.finding != tern::Finding::kNone) {
      ++refused;
      const RoomInTime room = room_beside(way, thing_of(pair.track), kEnough);
      EXPECT_TRUE(room.leaves || room.least < Rational(1) / 10000) << "case " << i;
      // The segments before it are proven.
      Rational end = 0;
      std::size_t kept = 0;
      while (kept < way.curves.size() && end + way.curves[kept].duration < Rational(until)) {
        end += way.curves[kept++].duration;
      }
      way.curves.resize(kept);
      way.rest = 0;
      if (kept == 0) continue;
    }
    ++proven;
    const RoomInTime room = room_beside(way, thing_of(pair.track), kEnough);
    EXPECT_TRUE(!room.noted || room.least >= kEnough) << "case " << i << ": " << text_below(room.least);
  }
  EXPECT_GT(proven, refused / 4);
}

}  // namespace
}  // namespace tern_verify
