// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random trajectories beside random tracks: straight ones and pieces, all shapes, tangents, far from the origin, long
// after the measurement, and very short pieces.
#ifndef TERN_TESTS_SUPPORT_TRACK_PAIRS_HPP
#define TERN_TESTS_SUPPORT_TRACK_PAIRS_HPP

#include <cstdint>
#include <vector>

#include "support/random.hpp"
#include "tern/track.hpp"
#include "tern/trajectory.hpp"

namespace tern_test {

struct TrackPair {
  tern::Trajectory plan{};
  std::vector<tern::TrackPiece> pieces;
  tern::Track track;
  tern::TrackGrounds grounds;
};

inline tern::Vec3 random_place(Random& random, double size) {
  return {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
}

/// Eight points along a velocity, each a little off.
inline void wander(Random& random, double duration, double off, tern::Vec3& at, tern::Vec3& velocity,
                   tern::Vec3* points) {
  for (int k = 0; k < tern::kControlPoints; ++k) {
    points[k] = at;
    if (k == tern::kDegree) break;
    const tern::Vec3 aside = random_place(random, off);
    const double step = duration / tern::kDegree;
    at = {at.x + step * velocity.x + aside.x, at.y + step * velocity.y + aside.y, at.z + step * velocity.z + aside.z};
  }
  const tern::Vec3 turn = random_place(random, 1.0);
  velocity = {velocity.x + turn.x, velocity.y + turn.y, velocity.z + turn.z};
}

inline void size_thing(Random& random, tern::Track& track) {
  track.shape = static_cast<tern::TrackShape>(random.integer(0, 2));
  track.radius = track.shape == tern::TrackShape::kBox ? 0.0 : random.real(0.1, 0.5);
  if (track.shape != tern::TrackShape::kBall) {
    track.half = {random.real(0.1, 0.5), random.real(0.1, 0.5), random.real(0.1, 1.0)};
  }
  track.error = random.chance(0.3) ? 0.0 : random.real(0.0, 0.1);
  track.error_speed = random.chance(0.3) ? 0.0 : random.real(0.0, 0.1);
  track.error_growth = random.chance(0.3) ? 0.0 : random.real(0.0, 0.3);
  track.reach = random.chance(0.2) ? random.real(0.1, 3.0) : 0.0;
}

/// The plan: up to four segments. `scale`: how much shorter than usual they are.
inline void wander_along(Random& random, double far, double scale, tern::Trajectory& plan) {
  plan.count = random.integer(1, 4);
  plan.origin = random_place(random, far);
  tern::Vec3 at{0.0, 0.0, 0.0};
  tern::Vec3 velocity = random_place(random, 2.0);
  for (int s = 0; s < plan.count; ++s) {
    tern::Segment& segment = plan.segments[s];
    segment.duration = random.chance(0.1) ? 1e-6 : scale * random.real(0.2, 1.5);
    segment.polyhedron = tern::kNoPolyhedron;
    wander(random, segment.duration, segment.duration * (random.chance(0.2) ? 0.0 : 0.1), at, velocity, segment.points);
  }
}

/// The thing crosses the plan somewhere near, or moves beside it.
inline void move_across(Random& random, double scale, TrackPair& pair) {
  tern::Track& track = pair.track;
  const double age = random.chance(0.2) ? random.real(0.0, 1e9) : random.real(-0.5, 2.0) * scale;
  const tern::Vec3 near = random_place(random, 3.0 * (scale < 1.0 ? 0.4 : 1.0));
  const tern::Vec3 velocity = random_place(random, age > 10.0 ? 1e-3 : 2.0);
  track.measured = pair.plan.begin - static_cast<std::int64_t>(age * 1e9);
  if (age > 10.0) track.error_speed = track.error_growth = 0.0;
  track.velocity = velocity;
  const tern::Vec3& origin = pair.plan.origin;
  track.position = {origin.x + near.x - age * velocity.x, origin.y + near.y - age * velocity.y,
                    origin.z + near.z - age * velocity.z};
  if (random.chance(0.5)) return;
  track.measured = pair.plan.begin - static_cast<std::int64_t>(random.real(-0.2, 1.0) * scale * 1e9);
  track.position = {origin.x + near.x, origin.y + near.y, origin.z + near.z};
  tern::Vec3 at{0.0, 0.0, 0.0};
  tern::Vec3 heading = random_place(random, 2.0);
  const int count = random.integer(1, 4);
  for (int p = 0; p < count; ++p) {
    tern::TrackPiece piece{};
    piece.duration = random.chance(0.1) ? 1e-6 : scale * random.real(0.2, 1.5);
    wander(random, piece.duration, 0.1 * piece.duration, at, heading, piece.points);
    pair.pieces.push_back(piece);
  }
  track.pieces = pair.pieces.data();
  track.piece_count = count;
}

/// A ball that stands beside a straight plan, at the distance that is needed but for nanometres.
inline void touch(Random& random, TrackPair& pair) {
  tern::Trajectory& plan = pair.plan;
  plan.count = 1;
  plan.segments[0].duration = random.real(0.5, 2.0);
  const double length = random.real(1.0, 4.0);
  for (int k = 0; k < tern::kControlPoints; ++k) plan.segments[0].points[k] = {k / 7.0 * length, 0.0, 0.0};
  tern::Track& track = pair.track;
  track.shape = tern::TrackShape::kBall;
  track.measured = plan.begin;
  track.error_speed = track.error_growth = track.reach = 0.0;
  constexpr double kOff[] = {0.0, 1e-9, -1e-9, -3.9e-9, -4.1e-9, -1e-8, 1e-6, -1e-6};
  const double aside = pair.grounds.radius + track.radius + track.error + kOff[random.integer(0, 7)];
  track.position = {plan.origin.x + random.real(0.2, 0.8) * length, plan.origin.y + aside, plan.origin.z};
  track.velocity = {0.0, 0.0, 0.0};
}

inline TrackPair random_pair(Random& random) {
  TrackPair pair;
  const double far = random.chance(0.3) ? 1e7 : 50.0;
  const double scale = random.chance(0.15) ? 1e-5 : 1.0;
  pair.plan.begin = random.chance(0.3) ? 1000000000000000000 : static_cast<std::int64_t>(random.real(-1e12, 1e12));
  pair.grounds.radius = random.real(0.1, 0.4);
  pair.grounds.rest = random.chance(0.5) ? random.real(0.0, 1.0) * scale : 0.0;
  wander_along(random, far, scale, pair.plan);
  size_thing(random, pair.track);
  if (random.chance(0.15)) {
    pair.plan.origin = random.chance(0.5) ? tern::Vec3{1e7, -1e7, 64.0} : tern::Vec3{};
    touch(random, pair);
  } else {
    move_across(random, scale, pair);
  }
  pair.track.end = static_cast<tern::TrackEnd>(random.integer(0, 3));
  const std::int64_t least = pair.track.measured < pair.plan.begin ? pair.plan.begin : pair.track.measured;
  pair.track.until = least + static_cast<std::int64_t>(random.real(0.0, 2.0) * scale * 1e9);
  return pair;
}

/// The track and its pieces are where they are now: a pair that was moved points elsewhere.
inline void hold_pieces(TrackPair& pair) {
  pair.track.pieces = pair.pieces.empty() ? nullptr : pair.pieces.data();
  pair.grounds.tracks = &pair.track;
  pair.grounds.count = 1;
}

}  // namespace tern_test

#endif
