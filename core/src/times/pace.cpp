// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "times/pace.hpp"

#include "base/math.hpp"
#include "curve/bezier.hpp"

namespace tern {
namespace {

/// A distance larger than that of any place, metres.
constexpr double kFar = 1e300;

int count_pieces(const Pace& pace) {
  return pace.plan->count * kPacePieces;
}

double duration_of(const Pace& pace, int piece) {
  return pace.plan->segments[piece / kPacePieces].duration / kPacePieces;
}

/// The end of the piece, in the chain's frame.
Vec3 end_of(const Pace& pace, int piece) {
  const double u = static_cast<double>(piece % kPacePieces + 1) / kPacePieces;
  return value(curve_of(pace.plan->segments[piece / kPacePieces]), u) + pace.offset;
}

/// The parameter, 0 .. 1, of the point nearest to `place` on the line from `from` to `to`.
double nearest_part(const Vec3& from, const Vec3& to, const Vec3& place) {
  const Vec3 along = to - from;
  const double square = dot(along, along);
  return square > 0.0 ? clamp(dot(place - from, along) / square, 0.0, 1.0) : 0.0;
}

}  // namespace

void pace_begin(const Pace& pace, PaceWalk& walk) noexcept {
  walk = PaceWalk{0, pace.plan->segments[0].points[0] + pace.offset, 0.0, pace.from};
  while (walk.piece < count_pieces(pace) && walk.begin_time + duration_of(pace, walk.piece) <= pace.from) {
    walk.begin_time += duration_of(pace, walk.piece);
    ++walk.piece;
  }
  if (walk.piece > 0) walk.begin = end_of(pace, walk.piece - 1);
}

double pace_to(const Pace& pace, const Vec3& place, PaceWalk& walk, int& pieces) noexcept {
  PaceWalk ahead = walk;
  double nearest = kFar;
  int farther = 0;
  for (; ahead.piece < count_pieces(pace) && farther < kPaceLookahead; ++ahead.piece, ++pieces) {
    const Vec3 end = end_of(pace, ahead.piece);
    const double part = nearest_part(ahead.begin, end, place);
    const double away = distance(place, ahead.begin + part * (end - ahead.begin));
    const double duration = duration_of(pace, ahead.piece);
    ++farther;
    if (away < nearest) {
      nearest = away;
      farther = 0;
      ahead.time = larger(walk.time, ahead.begin_time + part * duration);
      walk = ahead;
    }
    ahead.begin = end;
    ahead.begin_time += duration;
  }
  return nearest;
}

Rival rest_of(const Pace& pace) noexcept {
  Rival rest{};
  double begin = 0.0;
  for (int i = 0; i < pace.plan->count; ++i) {
    const Segment& segment = pace.plan->segments[i];
    const double end = begin + segment.duration;
    if (end > pace.from) {
      const double before = larger(0.0, pace.from - begin);
      Curve snap = snap_of(segment);
      keep_last_part(before / segment.duration, snap.c, snap.degree);
      rest.duration += segment.duration - before;
      rest.snap += integral_of_product(snap, snap, segment.duration - before);
    }
    begin = end;
  }
  return rest;
}

}  // namespace tern
