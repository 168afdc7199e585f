// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tracks/approach.hpp"

#include "curve/bezier.hpp"

namespace tern {
namespace {

/// Instants of a stretch that are looked at first.
constexpr int kInstants = 32;
/// Then the nearest one's surroundings are cut into this many parts, this many times.
constexpr int kFiner = 8;
constexpr int kFinerTimes = 3;
/// Steps of Gilbert's towards the point of the hull that is nearest to the shape.
constexpr int kHullSteps = 12;
/// m: a shorter vector has no direction.
constexpr double kNoLength = 1e-9;
constexpr double kNoRoom = -1e300;

struct Basis {
  double weight[kInstants + 1][kControlPoints];
};

constexpr Basis make_basis() {
  Basis basis{};
  constexpr double kChoose[kControlPoints] = {1, 7, 21, 35, 35, 21, 7, 1};
  for (int i = 0; i <= kInstants; ++i) {
    const double u = static_cast<double>(i) / kInstants;
    for (int k = 0; k < kControlPoints; ++k) {
      double weight = kChoose[k];
      for (int j = 0; j < k; ++j) weight *= u;
      for (int j = k; j < kDegree; ++j) weight *= 1.0 - u;
      basis.weight[i][k] = weight;
    }
  }
  return basis;
}

constexpr Basis kBasis = make_basis();

/// The stretch at one instant.
struct Instant {
  Vec3 point;
  double need;
};

Instant at_instant(const Stretch& stretch, int i) {
  Instant at{kZero, 0.0};
  for (int k = 0; k < kControlPoints; ++k) {
    at.point = at.point + kBasis.weight[i][k] * stretch.points[k];
    at.need += kBasis.weight[i][k] * stretch.need[k];
  }
  return at;
}

Instant at_share(const Stretch& stretch, double u) {
  Vec3 points[kControlPoints];
  double need[kControlPoints];
  for (int k = 0; k < kControlPoints; ++k) {
    points[k] = stretch.points[k];
    need[k] = stretch.need[k];
  }
  keep_last_part(u, points);
  keep_last_part(u, need);
  return {points[0], need[0]};
}

double room_at(const Things& things, const Track& track, const Instant& at) {
  return distance(at.point, closest_in(things, track, at.point)) - at.need;
}

/// The most by which the room changes from an instant that is looked at to halfway to the next: no derivative is larger
/// than the longest edge between control points times the degree.
double reach_between(const Stretch& stretch) {
  double most = 0.0;
  for (int k = 0; k < kDegree; ++k) {
    const double edge = distance(stretch.points[k], stretch.points[k + 1]);
    most = larger(most, edge + absolute(stretch.need[k + 1] - stretch.need[k]));
  }
  return 0.5 * kDegree * most / kInstants;
}

/// The room of the control points along a normal.
double room_along(const Things& things, const Track& track, const Stretch& stretch, const Vec3& normal) {
  const double support = support_of(things, track, normal);
  double room = dot(normal, stretch.points[0]) - stretch.need[0];
  for (int k = 1; k < kControlPoints; ++k) {
    room = smaller(room, dot(normal, stretch.points[k]) - stretch.need[k]);
  }
  return room - support;
}

/// The best normal so far.
struct Choice {
  Vec3 normal;
  double room;
};

void consider(const Things& things, const Track& track, const Stretch& stretch, const Vec3& direction, Choice& best) {
  const double size = length(direction);
  if (!(size > kNoLength)) return;
  const Vec3 normal = (1.0 / size) * direction;
  const double room = room_along(things, track, stretch, normal);
  if (room > best.room) best = {normal, room};
}

/// Walks from `from` to the point of the control points' hull that is nearest to the shape.
void approach_hull(const Things& things, const Track& track, const Stretch& stretch, const Vec3& from, Choice& best) {
  Vec3 at = from;
  for (int step = 0; step < kHullSteps; ++step) {
    const Vec3 away = at - closest_in(things, track, at);
    if (!(length(away) > kNoLength)) return;
    int lowest = 0;
    for (int k = 1; k < kControlPoints; ++k) {
      if (dot(away, stretch.points[k]) < dot(away, stretch.points[lowest])) lowest = k;
    }
    const Vec3 edge = stretch.points[lowest] - at;
    const double squared = dot(edge, edge);
    if (!(squared > kNoLength * kNoLength)) return;
    const double share = clamp(-dot(away, edge) / squared, 0.0, 1.0);
    if (!(share > 0.0)) return;
    at = at + share * edge;
    consider(things, track, stretch, at - closest_in(things, track, at), best);
  }
}

/// If the thing is on the way: to its sides, level ones first.
void consider_sides(const Things& things, const Track& track, const Stretch& stretch, Choice& best) {
  const Vec3 along = stretch.points[kDegree] - stretch.points[0];
  const Vec3 level{-along.y, along.x, 0.0};
  const Vec3 up = cross(along, level);
  consider(things, track, stretch, level, best);
  consider(things, track, stretch, -1.0 * level, best);
  consider(things, track, stretch, up, best);
  consider(things, track, stretch, -1.0 * up, best);
}

}  // namespace

bool next_stretch(const Things& things, const Track& track, const TimedCurve& curve, double from, Stretch& stretch,
                  Operations& spent) noexcept {
  const double end = curve.begin + curve.duration;
  double at = from;
  for (int i = 0; i < kMostSpans && at < end; ++i) {
    const ThingSpan span = thing_at(track, things.begin, at);
    const double to = smaller(span.end, end);
    spent += ops::kTurn * track.piece_count + ops::kPiece;
    if (span.kind != ThingSpan::kAbsent && to - at > kLeastStretch) {
      spent += kStretchOperations;
      const ThingPart part = part_of(things, track, span, at, to);
      stretch.begin = at;
      stretch.end = to;
      stretch.u = clamp((at - curve.begin) / curve.duration, 0.0, 1.0);
      stretch.v = to < end ? clamp((to - curve.begin) / curve.duration, stretch.u, 1.0) : 1.0;
      for (int k = 0; k < kControlPoints; ++k) {
        stretch.points[k] = curve.points[k];
        stretch.need[k] = part.need[k];
      }
      if (stretch.v < 1.0) keep_first_part(stretch.v, stretch.points);
      if (stretch.u > 0.0 && stretch.v > 0.0) keep_last_part(stretch.u / stretch.v, stretch.points);
      for (int k = 0; k < kControlPoints; ++k) stretch.points[k] = stretch.points[k] - part.points[k];
      return true;
    }
    at = to;
  }
  return false;
}

bool is_far_from(const Things& things, const Track& track, const TimedCurve& curve, const Box& box, double spare,
                 Operations& spent) noexcept {
  const double end = curve.begin + curve.duration;
  const Box extent = extent_of(things, track);
  double at = curve.begin;
  for (int i = 0; i < kMostSpans && at < end; ++i) {
    const ThingSpan span = thing_at(track, things.begin, at);
    const double to = smaller(span.end, end);
    spent += ops::kTurn * track.piece_count + kPartOperations;
    if (span.kind != ThingSpan::kAbsent && to > at) {
      const ThingPart part = part_of(things, track, span, at, to);
      double need = part.need[0];
      for (const double other : part.need) need = larger(need, other);
      need *= 1.0 + spare;
      bool is_apart = false;
      for (int a = 0; a < 3; ++a) {
        double low = axis(part.points[0], a);
        double high = low;
        for (const Vec3& point : part.points) {
          low = smaller(low, axis(point, a));
          high = larger(high, axis(point, a));
        }
        low += axis(extent.lower, a) - need;
        high += axis(extent.upper, a) + need;
        is_apart = is_apart || low > axis(box.upper, a) || high < axis(box.lower, a);
      }
      if (!is_apart) return false;
    }
    at = to;
  }
  return !(at < end);
}

Approach approach_of(const Things& things, const Track& track, const Stretch& stretch) noexcept {
  Approach least{1e300, 0.0};
  for (int i = 0; i <= kInstants; ++i) {
    const double room = room_at(things, track, at_instant(stretch, i));
    if (room < least.room) least = {room, static_cast<double>(i) / kInstants};
  }
  // Between two instants, the room changes by no more than half of what the points move.
  if (least.room > reach_between(stretch)) return least;
  double step = 1.0 / kInstants;
  for (int turn = 0; turn < kFinerTimes; ++turn) {
    const double middle = least.u;
    for (int i = 1 - kFiner; i < kFiner; ++i) {
      const double u = middle + i * (step / kFiner);
      if (i == 0 || u < 0.0 || u > 1.0) continue;
      const double room = room_at(things, track, at_share(stretch, u));
      if (room < least.room) least = {room, u};
    }
    step /= kFiner;
  }
  return least;
}

Vec3 parting_normal(const Things& things, const Track& track, const Stretch& stretch, double& room) noexcept {
  Choice best{{1.0, 0.0, 0.0}, kNoRoom};
  Vec3 nearest = stretch.points[0];
  double least = 1e300;
  for (int i = 0; i <= kInstants; ++i) {
    const Vec3 point = at_instant(stretch, i).point;
    const Vec3 away = point - closest_in(things, track, point);
    if (length(away) < least) {
      least = length(away);
      nearest = point;
    }
    consider(things, track, stretch, away, best);
  }
  approach_hull(things, track, stretch, nearest, best);
  if (best.room < 0.0) consider_sides(things, track, stretch, best);
  room = best.room;
  return best.normal;
}

}  // namespace tern
