// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Things as the planner reads them, against places and errors that are computed from their definition.
#include "tracks/thing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/random.hpp"
#include "tracks/approach.hpp"

namespace {

using namespace tern;
using tern_test::Random;

constexpr std::int64_t kNano = 1000000000;

/// A value of a curve of degree 7, by its Bernstein polynomials.
double bernstein(const double* c, double u) {
  constexpr double kChoose[8] = {1, 7, 21, 35, 35, 21, 7, 1};
  double sum = 0.0;
  for (int k = 0; k < 8; ++k) sum += kChoose[k] * std::pow(u, k) * std::pow(1.0 - u, 7 - k) * c[k];
  return sum;
}

Vec3 bernstein(const Vec3* c, double u) {
  double of[3][8];
  for (int a = 0; a < 3; ++a) {
    for (int k = 0; k < 8; ++k) of[a][k] = axis(c[k], a);
  }
  return {bernstein(of[0], u), bernstein(of[1], u), bernstein(of[2], u)};
}

Vec3 random_vector(Random& random, double size) {
  return {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
}

struct Thing {
  Track track;
  std::vector<TrackPiece> pieces;
};

Thing random_thing(Random& random) {
  Thing thing;
  Track& track = thing.track;
  track.measured = static_cast<std::int64_t>(random.integer(-5, 5)) * kNano;
  track.position = random_vector(random, 10.0);
  track.velocity = random_vector(random, 2.0);
  track.radius = random.real(0.1, 0.5);
  track.half = {random.real(0.1, 1.0), random.real(0.1, 1.0), random.real(0.1, 1.0)};
  track.shape = static_cast<TrackShape>(random.integer(0, 2));
  track.error = random.real(0.0, 0.2);
  track.error_speed = random.real(0.0, 0.2);
  track.error_growth = random.real(0.0, 0.2);
  track.end = static_cast<TrackEnd>(random.integer(0, 2));
  track.until = track.measured + static_cast<std::int64_t>(random.integer(0, 8)) * kNano;
  for (int p = random.integer(0, 2); p > 0; --p) {
    TrackPiece piece{random.real(0.5, 4.0), {}};
    for (Vec3& point : piece.points) point = random_vector(random, 3.0);
    thing.pieces.push_back(piece);
  }
  track.pieces = thing.pieces.data();
  track.piece_count = static_cast<std::int32_t>(thing.pieces.size());
  return thing;
}

/// Where the centre is, and its error, straight from the definition. False if the thing is not there.
bool look_up(const Thing& thing, double time, Vec3& place, double& error) {
  const Track& track = thing.track;
  const double until = 1e-9 * static_cast<double>(track.until);
  if (time < 1e-9 * static_cast<double>(track.measured)) return false;
  if (track.end == TrackEnd::kGone && time >= until) return false;
  const double clock = track.end == TrackEnd::kGoesOn || time < until ? time : until;
  double s = clock - 1e-9 * static_cast<double>(track.measured);
  error = track.error + track.error_speed * s + 0.5 * track.error_growth * s * s;
  place = track.position;
  if (thing.pieces.empty()) {
    place = place + s * track.velocity;
    return true;
  }
  for (const TrackPiece& piece : thing.pieces) {
    if (s <= piece.duration) {
      place = place + bernstein(piece.points, s / piece.duration);
      return true;
    }
    s -= piece.duration;
  }
  place = place + thing.pieces.back().points[7];
  return true;
}

TEST(Things, AreWhereTheirDefinitionSays) {
  Random random(1);
  const int cases = tern_test::scaled(400);
  int seen = 0;
  for (int n = 0; n < cases; ++n) {
    const Thing thing = random_thing(random);
    Things things;
    things.radius = random.real(0.1, 0.5);
    things.origin = random_vector(random, 10.0);
    things.begin = static_cast<std::int64_t>(random.integer(-3, 3)) * kNano;
    const double fixed = things.radius + (thing.track.shape == TrackShape::kBall ? thing.track.radius : 0.0);
    for (int i = 0; i < 8; ++i) {
      const double from = random.real(0.0, 10.0);
      const ThingSpan span = thing_at(thing.track, things.begin, from);
      const double to = std::min(span.end, from + random.real(0.01, 3.0));
      ASSERT_GT(to, from);
      const double u = random.real(0.0, 0.999);
      const double at = from + u * (to - from) + 1e-9 * static_cast<double>(things.begin);
      Vec3 place{};
      double error = 0.0;
      ASSERT_EQ(look_up(thing, at, place, error), span.kind != ThingSpan::kAbsent);
      if (span.kind == ThingSpan::kAbsent) continue;
      const ThingPart part = part_of(things, thing.track, span, from, to);
      EXPECT_LT(distance(bernstein(part.points, u), place - things.origin), 1e-9);
      EXPECT_NEAR(bernstein(part.need, u), fixed + error, 1e-9);
      ++seen;
    }
  }
  EXPECT_GT(seen, cases);
}

TEST(Things, ReachBoundsWhatGrowsFaster) {
  Track track;
  track.velocity = {1.0, 0.0, 0.0};
  track.error_growth = 2.0;
  track.reach = 3.0;
  Things things;
  const ThingPart near = part_of(things, track, thing_at(track, 0, 1.0), 1.0, 1.0);
  EXPECT_DOUBLE_EQ(near.points[3].x, 1.0);
  EXPECT_DOUBLE_EQ(near.need[3], 1.0);
  const ThingPart late = part_of(things, track, thing_at(track, 0, 5.0), 5.0, 5.0);
  EXPECT_DOUBLE_EQ(late.points[3].x, 0.0);
  EXPECT_DOUBLE_EQ(late.need[3], 15.0);
}

TEST(Things, StayAndGrowAfterTheirMotionIsKnown) {
  Track track;
  track.velocity = {1.0, 0.0, 0.0};
  track.end = TrackEnd::kReach;
  track.until = 2 * kNano;
  track.reach = 0.5;
  track.error = 0.25;
  Things things;
  const ThingPart part = part_of(things, track, thing_at(track, 0, 4.0), 4.0, 6.0);
  for (const Vec3& point : part.points) EXPECT_DOUBLE_EQ(point.x, 2.0);
  EXPECT_DOUBLE_EQ(part.need[0], 1.25);
  EXPECT_DOUBLE_EQ(part.need[7], 2.25);
}

/// A stretch of 2 s along x, past a ball of 0.3 m that rests at the origin.
Stretch passing(const Things& things, const Track& track, const Vec3& from, const Vec3& to) {
  Vec3 points[kControlPoints];
  for (int k = 0; k < kControlPoints; ++k) points[k] = from + (k / 7.0) * (to - from);
  Stretch stretch;
  Operations spent = 0;
  EXPECT_TRUE(next_stretch(things, track, {points, 0.0, 2.0}, 0.0, stretch, spent));
  return stretch;
}

TEST(Approach, FindsTheLeastRoomAndThePlaneThere) {
  Track track;
  track.radius = 0.3;
  Things things;
  things.radius = 0.2;
  const Stretch stretch = passing(things, track, {-3.0, 0.55, 0.0}, {2.0, 0.55, 0.0});
  const Approach approach = approach_of(things, track, stretch);
  EXPECT_NEAR(approach.room, 0.05, 1e-6);
  EXPECT_NEAR(approach.u, 0.6, 1e-2);
  double room = 0.0;
  const Vec3 normal = parting_normal(things, track, stretch, room);
  EXPECT_NEAR(room, 0.05, 1e-3);
  EXPECT_GT(normal.y, 0.999);
  // What is far off is not looked at so closely.
  const Approach far = approach_of(things, track, passing(things, track, {-3.0, 0.8, 0.0}, {2.0, 0.8, 0.0}));
  EXPECT_GE(far.room, 0.3);
  EXPECT_LT(far.room, 0.31);
}

TEST(Approach, PassesBesideWhatIsOnTheWay) {
  Track track;
  track.radius = 0.3;
  Things things;
  const Stretch stretch = passing(things, track, {-2.0, 0.0, 0.0}, {2.0, 0.0, 0.0});
  double room = 0.0;
  const Vec3 normal = parting_normal(things, track, stretch, room);
  EXPECT_NEAR(std::fabs(normal.y), 1.0, 1e-12);
  EXPECT_NEAR(room, -0.3, 1e-12);
}

TEST(Approach, NoSampleIsNearerAndNoPlaneLies) {
  Random random(2);
  const int cases = tern_test::scaled(300);
  int parted = 0;
  for (int n = 0; n < cases; ++n) {
    const Thing thing = random_thing(random);
    Things things;
    things.radius = 0.3;
    Vec3 points[kControlPoints];
    for (Vec3& point : points) point = thing.track.position + random_vector(random, 4.0);
    Stretch stretch;
    Operations spent = 0;
    if (!next_stretch(things, thing.track, {points, 1.0, 2.0}, 1.0, stretch, spent)) continue;
    const Approach approach = approach_of(Things{}, thing.track, stretch);
    double least = 1e300;
    double room = 0.0;
    const Vec3 normal = parting_normal(Things{}, thing.track, stretch, room);
    EXPECT_NEAR(length(normal), 1.0, 1e-12);
    for (int i = 0; i <= 1000; ++i) {
      const Vec3 point = bernstein(stretch.points, i / 1000.0);
      const double need = bernstein(stretch.need, i / 1000.0);
      least = std::min(least, distance(point, closest_in(Things{}, thing.track, point)) - need);
      // A plane that parts the control points parts the curve.
      EXPECT_GE(distance(point, closest_in(Things{}, thing.track, point)) - need, room - 1e-9);
    }
    EXPECT_LT(approach.room, least + 5e-2);
    parted += room > 0.0 ? 1 : 0;
  }
  EXPECT_GT(parted, cases / 20);
}

TEST(Approach, AFarThingIsKnownByItsBox) {
  Track track;
  track.radius = 0.3;
  track.velocity = {0.0, 1.0, 0.0};
  Things things;
  things.radius = 0.2;
  Vec3 points[kControlPoints];
  for (int k = 0; k < kControlPoints; ++k) points[k] = {static_cast<double>(k), 5.0, 0.0};
  const Box box{points[0], points[7]};
  Operations spent = 0;
  // Within 2 s, the thing comes to y = 2; at 0.5 m it would be too near.
  EXPECT_TRUE(is_far_from(things, track, {points, 0.0, 2.0}, box, 0.0, spent));
  EXPECT_FALSE(is_far_from(things, track, {points, 0.0, 4.6}, box, 0.0, spent));
  EXPECT_TRUE(is_far_from(things, track, {points, 0.0, 4.4}, box, 0.0, spent));
  EXPECT_FALSE(is_far_from(things, track, {points, 0.0, 4.4}, box, 1.0, spent));
}

}  // namespace
