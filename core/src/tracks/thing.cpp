// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracks/thing.hpp"

#include "curve/bezier.hpp"

namespace tern {
namespace {

constexpr double kNever = __builtin_inf();
constexpr std::int64_t kSecond = 1000000000;

/// An error of second degree: value, slope and half the growth.
struct ErrorCurve {
  double value;
  double slope;
  double growth;
};

/// s seconds after it was measured.
ErrorCurve error_after(const Track& track, double s) {
  return {track.error + s * (track.error_speed + 0.5 * track.error_growth * s),
          track.error_speed + s * track.error_growth, track.error_growth};
}

/// Adds a curve of second degree over `length` seconds as one of degree 7.
void add_error(const ErrorCurve& error, double length, double* need) {
  const double first = error.value;
  const double middle = first + 0.5 * length * error.slope;
  const double last = first + length * (error.slope + 0.5 * length * error.growth);
  for (int k = 0; k < kControlPoints; ++k) {
    const double a = (7 - k) * (6 - k) / 42.0;
    const double b = 2.0 * k * (7 - k) / 42.0;
    const double c = k * (k - 1) / 42.0;
    need[k] += (a * first + b * middle) + c * last;
  }
}

/// The centre's place `s` seconds after it was measured, on a straight line.
Vec3 straight(const Track& track, const Vec3& base, double s) {
  return base + s * track.velocity;
}

void copy_piece(const TrackPiece& piece, const Vec3& base, Vec3* points) {
  for (int k = 0; k < kControlPoints; ++k) points[k] = base + piece.points[k];
}

/// The centre along what the span names.
void move_centre(const Track& track, const ThingSpan& span, const Vec3& base, double measured, double from, double to,
                 Vec3* points) {
  if (track.piece_count == 0) {
    const Vec3 a = straight(track, base, from - measured);
    const Vec3 b = straight(track, base, to - measured);
    for (int k = 0; k < kControlPoints; ++k) points[k] = a + (k / 7.0) * (b - a);
    return;
  }
  if (span.kind == ThingSpan::kRests) {
    const Vec3 end = base + track.pieces[track.piece_count - 1].points[kDegree];
    for (int k = 0; k < kControlPoints; ++k) points[k] = end;
    return;
  }
  const TrackPiece& piece = track.pieces[span.piece];
  const double u = clamp((from - span.piece_begin) / piece.duration, 0.0, 1.0);
  const double v = clamp((to - span.piece_begin) / piece.duration, u, 1.0);
  copy_piece(piece, base, points);
  if (v < 1.0) keep_first_part(v, points);
  if (u > 0.0 && v > 0.0) keep_last_part(u / v, points);
}

/// The span just before Track::until.
ThingSpan last_span(const Track& track, double measured, double until) {
  double begin = measured;
  for (std::int32_t p = 0; p < track.piece_count; ++p) {
    if (until <= begin + track.pieces[p].duration) return {ThingSpan::kMoves, until, p, begin};
    begin += track.pieces[p].duration;
  }
  return {track.piece_count > 0 ? ThingSpan::kRests : ThingSpan::kMoves, until, 0, measured};
}

}  // namespace

double seconds_to(std::int64_t time, std::int64_t begin) noexcept {
  const std::int64_t whole = time / kSecond - begin / kSecond;
  const std::int64_t rest = time % kSecond - begin % kSecond;
  return static_cast<double>(whole) + 1e-9 * static_cast<double>(rest);
}

ThingSpan thing_at(const Track& track, std::int64_t begin, double at) noexcept {
  const double measured = seconds_to(track.measured, begin);
  const double until = track.end == TrackEnd::kGoesOn ? kNever : seconds_to(track.until, begin);
  if (at < measured) return {ThingSpan::kAbsent, measured, 0, measured};
  if (!(at < until)) return {track.end == TrackEnd::kGone ? ThingSpan::kAbsent : ThingSpan::kStays, kNever, 0, until};
  double piece_begin = measured;
  for (std::int32_t p = 0; p < track.piece_count; ++p) {
    const double end = piece_begin + track.pieces[p].duration;
    if (at < end) return {ThingSpan::kMoves, smaller(end, until), p, piece_begin};
    piece_begin = end;
  }
  return {track.piece_count > 0 ? ThingSpan::kRests : ThingSpan::kMoves, until, 0, measured};
}

ThingPart part_of(const Things& things, const Track& track, const ThingSpan& span, double from, double to) noexcept {
  ThingPart part;
  const Vec3 base = track.position - things.origin;
  const double measured = seconds_to(track.measured, things.begin);
  const double fixed = things.radius + (track.shape == TrackShape::kBall ? track.radius : 0.0);
  for (double& need : part.need) need = fixed;
  if (span.kind == ThingSpan::kStays) {
    const double until = seconds_to(track.until, things.begin);
    move_centre(track, last_span(track, measured, until), base, measured, until, until, part.points);
    const double growth = track.end == TrackEnd::kReach ? track.reach : 0.0;
    const double error = error_after(track, until - measured).value + growth * (from - until);
    add_error({error, growth, 0.0}, to - from, part.need);
    return part;
  }
  const double middle = 0.5 * (from + to) - measured;
  const bool is_nearer = track.reach > 0.0 && track.error + track.reach * middle < error_after(track, middle).value;
  if (is_nearer) {  // the ball that it can reach
    const Vec3 first = track.piece_count > 0 ? base + track.pieces[0].points[0] : base;
    for (Vec3& point : part.points) point = first;
    add_error({track.error + track.reach * (from - measured), track.reach, 0.0}, to - from, part.need);
    return part;
  }
  move_centre(track, span, base, measured, from, to, part.points);
  add_error(error_after(track, from - measured), to - from, part.need);
  return part;
}

bool thing_now(const Things& things, const Track& track, double at, Vec3& place, double& need) noexcept {
  const ThingSpan span = thing_at(track, things.begin, at);
  if (span.kind == ThingSpan::kAbsent) return false;
  if (span.kind == ThingSpan::kMoves && track.piece_count == 0 && !(track.reach > 0.0)) {
    const double s = at - seconds_to(track.measured, things.begin);
    place = straight(track, track.position - things.origin, s);
    need = error_after(track, s).value + things.radius + (track.shape == TrackShape::kBall ? track.radius : 0.0);
    return true;
  }
  const ThingPart part = part_of(things, track, span, at, at);
  place = part.points[0];
  need = part.need[0];
  return true;
}

Box extent_of(const Things& things, const Track& track) noexcept {
  if (track.shape == kConvex) {
    const Hull& hull = things.solid_of(track).hull;
    Box box{hull.points[0], hull.points[0]};
    for (int k = 1; k < hull.count; ++k) {
      for (int a = 0; a < 3; ++a) {
        axis(box.lower, a) = smaller(axis(box.lower, a), axis(hull.points[k], a));
        axis(box.upper, a) = larger(axis(box.upper, a), axis(hull.points[k], a));
      }
    }
    return box;
  }
  Vec3 half = kZero;
  if (track.shape == TrackShape::kBox) half = track.half;
  if (track.shape == TrackShape::kCylinder) half = {track.radius, track.radius, track.half.z};
  return {-1.0 * half, half};
}

}  // namespace tern
