// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "prove/track_motion.hpp"

#include "base/math.hpp"
#include "prove/bernstein.hpp"

namespace tern {
namespace {

double sum_of_sizes(const Vec3& v) {
  return (absolute(v.x) + absolute(v.y)) + absolute(v.z);
}

/// position - origin + velocity * time, rounded once.
Vec3 place_after(const Track& track, const Vec3& origin, const DoubleDouble& time) {
  Vec3 place;
  for (int a = 0; a < 3; ++a) {
    const DoubleDouble from = exact_sum(axis(track.position, a), -axis(origin, a));
    axis(place, a) = (from + DoubleDouble(axis(track.velocity, a)) * time).high;
  }
  return place;
}

Vec3 base_of(const Track& track, const Vec3& origin) {
  return track.position - origin;
}

double error_after(const Track& track, double time) {
  return track.error + time * (track.error_speed + 0.5 * track.error_growth * time);
}

/// The thing rests at `place`.
void rest_at(const Vec3& place, ThingMotion& motion) {
  for (Vec3& point : motion.points) point = place;
  motion.size = sum_of_sizes(place);
}

/// Along a velocity: the points lie evenly on the line.
void move_straight(const Track& track, const Vec3& origin, const DoubleDouble& from, const DoubleDouble& to,
                   ThingMotion& motion) {
  const Vec3 first = place_after(track, origin, from);
  const Vec3 last = place_after(track, origin, to);
  for (int i = 0; i < kControlPoints; ++i) motion.points[i] = first + (i / 7.0) * (last - first);
  motion.size = sum_of_sizes(first) + sum_of_sizes(last);
}

/// Along a part of a piece.
void move_along(const Track& track, const Vec3& origin, std::int32_t piece, double u, double v, ThingMotion& motion) {
  const Vec3 base = base_of(track, origin);
  double size = 0.0;
  for (int i = 0; i < kControlPoints; ++i) {
    const Vec3& point = track.pieces[piece].points[i];
    motion.points[i] = base + point;
    size = larger(size, sum_of_sizes(point));
  }
  motion.size = sum_of_sizes(base) + size;
  take_part(motion.points, u, v);
}

/// Where the curve is at the end of its validity, `since` after Track::measured.
Vec3 place_at(const Track& track, const Vec3& origin, const DoubleDouble& since) {
  if (track.piece_count == 0) return place_after(track, origin, since);
  DoubleDouble begin(0.0);
  for (std::int32_t p = 0; p < track.piece_count; ++p) {
    const TrackPiece& piece = track.pieces[p];
    const DoubleDouble end = begin + DoubleDouble(piece.duration);
    if (since < end) {
      Vec3 points[kControlPoints];
      Vec3 after[kControlPoints];
      for (int i = 0; i < kControlPoints; ++i) points[i] = piece.points[i];
      cut(points, kDegree, share_of(since, begin, piece.duration), after);
      return base_of(track, origin) + after[0];
    }
    begin = end;
  }
  return base_of(track, origin) + track.pieces[track.piece_count - 1].points[kDegree];
}

/// A quadratic polynomial with these three control points has these eight.
void raise_degree(double first, double middle, double last, double* out) {
  for (int k = 0; k < kControlPoints; ++k) {
    const double before = (7 - k) * (6 - k) / 42.0;
    const double between = 2 * k * (7 - k) / 42.0;
    const double behind = k * (k - 1) / 42.0;
    out[k] = (before * first + between * middle) + behind * last;
  }
}

/// The error from `since` seconds after Track::measured on, for `length` seconds.
void let_error_grow(const Track& track, double since, double length, double* error) {
  const double first = error_after(track, since);
  const double rise = length * (track.error_speed + track.error_growth * since);
  raise_degree(first, first + 0.5 * rise, first + rise + 0.5 * track.error_growth * length * length, error);
}

/// Past its validity, the error keeps its size or grows evenly.
void keep_error(const Track& track, double known, double since, double length, double* error) {
  const double speed = track.end == TrackEnd::kReach ? track.reach : 0.0;
  const double first = error_after(track, known) + speed * since;
  raise_degree(first, first + 0.5 * speed * length, first + speed * length, error);
}

}  // namespace

DoubleDouble seconds_between(std::int64_t from, std::int64_t to) noexcept {
  const bool is_later = to >= from;
  // The difference may not fit into 63 bits; unsigned, it is exact.
  const auto a = static_cast<std::uint64_t>(from);
  const auto b = static_cast<std::uint64_t>(to);
  const std::uint64_t apart = is_later ? b - a : a - b;
  const double high = static_cast<double>(apart >> 32) * 4294967296.0;
  const auto low = static_cast<double>(apart & 0xFFFFFFFFu);
  const DoubleDouble seconds = exact_sum(high, low) / DoubleDouble(1e9);
  return is_later ? seconds : -seconds;
}

TrackSpan span_at(const Track& track, const TrackTimes& times, std::int32_t piece, DoubleDouble begin,
                  const DoubleDouble& at) noexcept {
  if (at < times.measured) return {SpanKind::kAbsent, 0, times.measured, times.measured};
  const bool ends = track.end != TrackEnd::kGoesOn;
  if (ends && !(at < times.until)) {
    return {track.end == TrackEnd::kGone ? SpanKind::kAbsent : SpanKind::kStays, piece, begin, never()};
  }
  const DoubleDouble last = ends ? times.until : never();
  if (track.piece_count == 0) return {SpanKind::kMoves, 0, times.measured, last};
  for (std::int32_t p = piece; p < track.piece_count; ++p) {
    const DoubleDouble end = begin + DoubleDouble(track.pieces[p].duration);
    if (at < end) return {SpanKind::kMoves, p, begin, end < last ? end : last};
    begin = end;
  }
  return {SpanKind::kRests, track.piece_count, begin, last};
}

void move_thing(const Track& track, const Vec3& origin, const TrackTimes& times, const TrackSpan& span,
                const DoubleDouble& at, const DoubleDouble& to, ThingMotion& motion) noexcept {
  const double length = (to - at).high;
  if (span.kind == SpanKind::kStays) {
    const DoubleDouble known = times.until - times.measured;
    rest_at(place_at(track, origin, known), motion);
    return keep_error(track, known.high, (at - times.until).high, length, motion.error);
  }
  let_error_grow(track, (at - times.measured).high, length, motion.error);
  if (span.kind == SpanKind::kRests) {
    const Vec3& place = track.pieces[track.piece_count - 1].points[kDegree];
    rest_at(base_of(track, origin) + place, motion);
    motion.size += sum_of_sizes(place);
  } else if (track.piece_count == 0) {
    move_straight(track, origin, at - times.measured, to - times.measured, motion);
  } else {
    const double duration = track.pieces[span.piece].duration;
    move_along(track, origin, span.piece, share_of(at, span.begin, duration), share_of(to, span.begin, duration),
               motion);
  }
}

void sketch_motion(const Track& track, const Vec3& origin, double from, double to, ThingMotion& motion) noexcept {
  const Vec3 base = base_of(track, origin);
  motion.points[0] = base + from * track.velocity;
  motion.points[kDegree] = base + to * track.velocity;
  motion.error[0] = error_after(track, from);
  motion.error[kDegree] = error_after(track, to);
  motion.size = sum_of_sizes(base) + (absolute(from) + absolute(to)) * sum_of_sizes(track.velocity);
}

Vec3 first_place(const Track& track, const Vec3& origin) noexcept {
  return track.piece_count == 0 ? base_of(track, origin) : base_of(track, origin) + track.pieces[0].points[0];
}

void take_part(Vec3* points, double u, double v) noexcept {
  Vec3 rest[kControlPoints];
  if (v < 1.0) cut(points, kDegree, v, rest);
  if (!(u > 0.0)) return;
  cut(points, kDegree, smaller(u / v, 1.0), rest);
  for (int i = 0; i < kControlPoints; ++i) points[i] = rest[i];
}

double share_of(const DoubleDouble& at, const DoubleDouble& begin, double duration) noexcept {
  return clamp((at - begin).high / duration, 0.0, 1.0);
}

}  // namespace tern
