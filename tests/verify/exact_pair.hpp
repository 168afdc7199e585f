// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The core's proof of a plan beside a track, against exact numbers.
#ifndef TERN_TESTS_VERIFY_EXACT_PAIR_HPP
#define TERN_TESTS_VERIFY_EXACT_PAIR_HPP

#include "support/track_pairs.hpp"
#include "tern/track_proof.hpp"
#include "verify/tracks.hpp"

namespace tern_verify {

/// What a curve may lack and yet be proven (docs/tracks.md): 4 nm.
inline Rational enough_room() {
  return -decimal(4, 9);
}

inline Point exact(const tern::Vec3& v) {
  return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

inline Polygon<3> exact(const tern::Vec3* points, const tern::Vec3& origin) {
  Polygon<3> polygon;
  for (int k = 0; k < tern::kControlPoints; ++k) polygon.push_back(exact(points[k]) + exact(origin));
  return polygon;
}

inline Rational exact_seconds(std::int64_t time) {
  return Rational(time) / 1000000000;
}

inline TimedWay way_of(const tern_test::TrackPair& pair) {
  TimedWay way{{}, exact_seconds(pair.plan.begin), Rational(pair.grounds.rest), Rational(pair.grounds.radius)};
  for (int s = 0; s < pair.plan.count; ++s) {
    const tern::Segment& segment = pair.plan.segments[s];
    way.curves.push_back({exact(segment.points, pair.plan.origin), Rational(segment.duration)});
  }
  return way;
}

inline Thing thing_of(const tern::Track& track) {
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
  thing.from = exact_seconds(track.measured);
  thing.until = exact_seconds(track.until);
  thing.end = static_cast<ThingEnd>(track.end);
  return thing;
}

struct PairFinding {
  bool refused = false;     ///< the core proves no more than some segments, or nothing
  bool proven = false;      ///< the core proves something
  bool is_unsound = false;  ///< what it proves is not so, in exact numbers, without any rounding
  bool is_timid = false;    ///< what it refuses has 0.1 mm of room
};

inline PairFinding prove_exactly(const tern_test::TrackPair& pair) {
  PairFinding finding;
  tern::ProofReport report;
  const double until = tern::clear_until(pair.plan, 0.0, pair.grounds, &report);
  TimedWay way = way_of(pair);
  const Thing thing = thing_of(pair.track);
  finding.refused = report.finding != tern::Finding::kNone;
  if (finding.refused) {
    const RoomInTime room = room_beside(way, thing, enough_room());
    finding.is_timid = !room.leaves && room.least >= Rational(1) / 10000;
    // The segments before it are proven.
    Rational end = 0;
    std::size_t kept = 0;
    while (kept < way.curves.size() && end + way.curves[kept].duration < Rational(until)) {
      end += way.curves[kept++].duration;
    }
    way.curves.resize(kept);
    way.rest = 0;
    if (kept == 0) return finding;
  }
  finding.proven = true;
  const RoomInTime room = room_beside(way, thing, enough_room());
  finding.is_unsound = room.noted && room.least < enough_room();
  return finding;
}

}  // namespace tern_verify

#endif
