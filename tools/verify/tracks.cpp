// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The way minus the thing's curve is a Bezier curve, with the distance that is needed as its fourth coordinate. It is
// halved until a plane parts each piece from the shape. Doubles only guess the planes.
#include "verify/tracks.hpp"

#include <algorithm>
#include <cmath>

namespace tern_verify {
namespace {

/// Halvings after which a piece counts with what is proven of it.
constexpr int kHalvings = 40;
constexpr std::size_t kDegrees = 7;
/// A piece is looked at no closer once so much of the least room that was seen is proven of it.
const Rational kShare = Rational(3) / 4;
/// Metres that do not matter.
const Rational kNothing = decimal(1, 6);

// What docs/tracks.md says of a way that begins too near to a thing.
const Rational kLeaveAfter = 1;
const Rational kLeaveSpeed = Rational(1) / 4;

/// x, y, z and the distance that is needed.
using Tube = Polygon<4>;

Rational squared(const Rational& a) {
  return a * a;
}

Point curve_at(const Thing& thing, const Rational& time) {
  if (thing.pieces.empty()) return thing.position + (time - thing.from) * thing.velocity;
  Rational begin = thing.from;
  for (const TimedCurve& piece : thing.pieces) {
    const Rational end = begin + piece.duration;
    if (time < end) return point_at(piece.points, (time - begin) / piece.duration);
    begin = end;
  }
  return thing.pieces.back().points.back();
}

Rational error_at(const Thing& thing, const Rational& time) {
  const Rational since = time - thing.from;
  return thing.error + since * (thing.error_speed + since * thing.error_growth / 2);
}

/// Whether the thing stays where it is at its end, at this time.
bool is_over(const Thing& thing, const Rational& time) {
  return thing.end != ThingEnd::kGoesOn && time >= thing.until;
}

Polygon<3> thing_part(const Thing& thing, const Rational& from, const Rational& to) {
  if (is_over(thing, from)) return Polygon<3>(kDegrees + 1, curve_at(thing, thing.until));
  if (!thing.pieces.empty()) return chain_part(thing.pieces, thing.from, from, to);
  const Point first = curve_at(thing, from);
  const Point way = curve_at(thing, to) - first;
  Polygon<3> points;
  for (std::size_t i = 0; i <= kDegrees; ++i) points.push_back(first + Rational(i) / kDegrees * way);
  return points;
}

/// A quadratic polynomial from three of its values, as eight control points.
std::vector<Rational> raised(const Rational& first, const Rational& middle, const Rational& last) {
  const Rational between = 2 * middle - (first + last) / 2;
  std::vector<Rational> points;
  for (int k = 0; k <= 7; ++k) {
    points.push_back(
        (Rational((7 - k) * (6 - k)) * first + Rational(2 * k * (7 - k)) * between + Rational(k * (k - 1)) * last) /
        42);
  }
  return points;
}

Rational needed_error(const Thing& thing, const Rational& from, const Rational& time) {
  if (!is_over(thing, from)) return error_at(thing, time);
  const Rational growth = thing.end == ThingEnd::kReach ? thing.reach : Rational(0);
  return error_at(thing, thing.until) + growth * (time - thing.until);
}

template <typename Needed>
Tube tube_of(const Polygon<3>& way, const Polygon<3>& thing, const Rational& from, const Rational& to,
             const Needed& needed) {
  const std::vector<Rational> widths = raised(needed(from), needed((from + to) / 2), needed(to));
  Tube tube;
  for (std::size_t i = 0; i <= kDegrees; ++i) {
    const Point apart = way[i] - thing[i];
    tube.push_back({apart[0], apart[1], apart[2], widths[i]});
  }
  return tube;
}

Rational ball_of(const Thing& thing) {
  return thing.shape == ThingShape::kBall ? thing.radius : Rational(0);
}

Rational beyond(const Rational& coordinate, const Rational& half) {
  return std::max<Rational>(0, abs(coordinate) - half);
}

/// Squared distance from the shape; a ball is a point. Rounded up or down where a cylinder's is no rational.
Rational square_apart(const Thing& thing, const Vector<4>& p, bool above) {
  if (thing.shape == ThingShape::kBall) return squared(p[0]) + squared(p[1]) + squared(p[2]);
  const Rational up = squared(beyond(p[2], thing.half[2]));
  if (thing.shape == ThingShape::kBox) {
    return squared(beyond(p[0], thing.half[0])) + squared(beyond(p[1], thing.half[1])) + up;
  }
  const Rational across = squared(p[0]) + squared(p[1]);
  const Rational out = (above ? root_above(across) : root_below(across)) - thing.radius;
  return (out > 0 ? squared(out) : Rational(0)) + up;
}

Rational most_room(const Thing& thing, const Vector<4>& p) {
  return root_above(square_apart(thing, p, true)) - p[3];
}

/// A direction from the shape to a point, guessed.
Point direction_to(const Thing& thing, const Vector<4>& p) {
  double d[3] = {guess(p[0]), guess(p[1]), guess(p[2])};
  if (thing.shape != ThingShape::kBall) {
    const auto clip = [](double x, double h) { return x < -h ? x + h : x > h ? x - h : 0.0; };
    d[2] = clip(d[2], guess(thing.half[2]));
    if (thing.shape == ThingShape::kBox) {
      d[0] = clip(d[0], guess(thing.half[0]));
      d[1] = clip(d[1], guess(thing.half[1]));
    } else {
      const double across = std::hypot(d[0], d[1]);
      const double share = across > guess(thing.radius) ? 1.0 - guess(thing.radius) / across : 0.0;
      d[0] *= share;
      d[1] *= share;
    }
  }
  const double length = std::hypot(std::hypot(d[0], d[1]), d[2]);
  if (!(length > 0.0)) return {0, 0, 1};
  return {Rational(d[0] / length), Rational(d[1] / length), Rational(d[2] / length)};
}

/// How far the shape reaches along a direction, from above.
Rational reach_along(const Thing& thing, const Point& n) {
  if (thing.shape == ThingShape::kBall) return 0;
  const Rational up = abs(n[2]) * thing.half[2];
  if (thing.shape == ThingShape::kBox) return abs(n[0]) * thing.half[0] + abs(n[1]) * thing.half[1] + up;
  return thing.radius * root_above(n[0] * n[0] + n[1] * n[1]) + up;
}

/// What the plane across the direction to the tube's middle proves for all of it, from below.
Rational least_room(const Thing& thing, const Tube& tube) {
  Vector<4> middle = Rational(1) / 2 * (tube[3] + tube[4]);
  const Point n = direction_to(thing, middle);
  const Rational reach = reach_along(thing, n);
  const Rational square = dot(n, n);
  std::optional<Rational> least;
  for (const Vector<4>& p : tube) {
    const Rational apart = n[0] * p[0] + n[1] * p[1] + n[2] * p[2] - reach;
    const Rational room = apart / (apart < 0 ? root_below(square) : root_above(square)) - p[3];
    if (!least || room < *least) least = room;
  }
  return *least;
}

/// The tubes of one stretch of time; what is clear of one of them is clear of the thing.
using Tubes = std::vector<Tube>;

class Search {
 public:
  Search(const Thing& thing, const Rational& enough, RoomInTime& room) : thing_(thing), enough_(enough), room_(room) {}

  void look(const Tubes& tubes, const Rational& begin, const Rational& length) {
    struct Piece {
      Tubes tubes;
      Rational begin, length;
      int depth;
    };
    std::vector<Piece> open{{tubes, begin, length, 0}};
    while (!open.empty()) {
      const Piece piece = std::move(open.back());
      open.pop_back();
      note_most(piece.tubes, piece.begin);
      std::optional<Rational> proven;
      for (const Tube& tube : piece.tubes) {
        const Rational least = least_room(thing_, tube);
        if (!proven || least > *proven) proven = least;
      }
      const bool is_done =
          *proven >= enough_ && *proven >= std::min<Rational>(kShare * room_.most, room_.most - kNothing);
      if (is_done || *proven >= room_.most || room_.most < enough_ || piece.depth == kHalvings) {
        room_.least = std::min<Rational>(room_.least, *proven);
        continue;
      }
      Piece first{{}, piece.begin, piece.length / 2, piece.depth + 1};
      Piece second{{}, piece.begin + piece.length / 2, piece.length / 2, piece.depth + 1};
      for (const Tube& tube : piece.tubes) {
        const Halves<4> halves = halves_of(tube);
        first.tubes.push_back(halves.left);
        second.tubes.push_back(halves.right);
      }
      open.push_back(std::move(second));
      open.push_back(std::move(first));
    }
  }

 private:
  void note_most(const Tubes& tubes, const Rational& when) {
    std::optional<Rational> most;
    for (const Tube& tube : tubes) {
      const Rational room = most_room(thing_, tube.front());
      if (!most || room > *most) most = room;
    }
    if (room_.noted && *most >= room_.most) return;
    if (!room_.noted) room_.least = *most;
    room_.noted = true;
    room_.most = *most;
    room_.when = when;
  }

  const Thing& thing_;
  const Rational enough_;
  RoomInTime& room_;
};

/// All times between which way and thing are one curve each.
std::vector<Rational> times_of(const TimedWay& way, const Thing& thing, const Rational& end) {
  std::vector<Rational> times{way.begin, end, thing.from, way.begin + kLeaveAfter};
  Rational at = way.begin;
  for (const TimedCurve& curve : way.curves) times.push_back(at += curve.duration);
  at = thing.from;
  for (const TimedCurve& piece : thing.pieces) times.push_back(at += piece.duration);
  if (thing.end != ThingEnd::kGoesOn) times.push_back(thing.until);
  times.erase(std::remove_if(times.begin(), times.end(),
                             [&](const Rational& t) { return t < way.begin || t > end || t < thing.from; }),
              times.end());
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

}  // namespace

Polygon<3> chain_part(const std::vector<TimedCurve>& chain, Rational begin, const Rational& from, const Rational& to) {
  for (const TimedCurve& curve : chain) {
    const Rational end = begin + curve.duration;
    if (from < end) return part_of(curve.points, (from - begin) / curve.duration, (to - begin) / curve.duration);
    begin = end;
  }
  return Polygon<3>(kDegrees + 1, chain.back().points.back());
}

RoomInTime room_beside(const TimedWay& way, const Thing& thing, const Rational& enough) {
  RoomInTime room{0, 0, 0};
  Rational end = way.begin + way.rest;
  for (const TimedCurve& curve : way.curves) end += curve.duration;
  const std::vector<Rational> times = times_of(way, thing, end);
  Search search(thing, enough, room);
  std::optional<Rational> gap;  // at the beginning, where the way leaves the thing
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const Rational& from = times[i];
    const Rational& to = times[i + 1];
    if (is_over(thing, from) && thing.end == ThingEnd::kGone) continue;
    const Polygon<3> mine = chain_part(way.curves, way.begin, from, to);
    const Polygon<3> its = thing_part(thing, from, to);
    const Rational distance = way.clearance + ball_of(thing);
    Tubes tubes{tube_of(mine, its, from, to,
                        [&](const Rational& t) { return Rational(distance + needed_error(thing, from, t)); })};
    if (thing.reach > 0) {
      const Polygon<3> rest(kDegrees + 1, curve_at(thing, thing.from));
      tubes.push_back(tube_of(mine, rest, from, to, [&](const Rational& t) {
        return Rational(distance + thing.error + thing.reach * (t - thing.from));
      }));
    }
    if (from == way.begin) {
      bool touches = true;
      for (const Tube& tube : tubes) touches = touches && most_room(thing, tube.front()) < enough;
      if (touches) gap = root_above(square_apart(thing, tubes.front().front(), true));
      room.leaves = touches;
    }
    if (gap && *gap > ball_of(thing)) {
      const bool grows = from >= way.begin + kLeaveAfter;
      tubes.push_back(tube_of(mine, its, from, to, [&](const Rational& t) {
        return Rational(*gap + (grows ? Rational(kLeaveSpeed * (t - way.begin - kLeaveAfter)) : Rational(0)));
      }));
    }
    search.look(tubes, from - way.begin, to - from);
  }
  return room;
}

Rational whole_nanoseconds(const Rational& seconds) {
  const Rational billion = 1000000000;
  return Rational(floor_of(seconds * billion + Rational(1) / 2)) / billion;
}

}  // namespace tern_verify
