// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// First in intervals of doubles, all places seen from where the way begins, so that they stay narrow. What they leave
// open is found in exact numbers, by the same code.
#include "verify/tracks.hpp"

#include <algorithm>

#include "verify/tubes.hpp"

namespace tern_verify {
namespace {

// What docs/tracks.md says of a way that begins too near to a thing.
const Rational kLeaveAfter = 1;
const Rational kLeaveSpeed = Rational(1) / 4;

/// Whether the thing stays where it is at its end, at this time.
bool is_over(const Thing& thing, const Rational& time) {
  return thing.end != ThingEnd::kGoesOn && time >= thing.until;
}

/// How far off a thing may be of its curve, or of where it was measured.
template <typename Number>
struct Errors {
  explicit Errors(const Thing& of)
      : thing(of), error(of.error), speed(of.error_speed), growth(of.error_growth), reach(of.reach) {}

  Number of_curve(const Rational& time) const {
    const Number since(Rational(time - thing.from));
    return error + since * (speed + Number(0.5) * since * growth);
  }
  /// At a time of a stretch that begins `from`.
  Number of_curve(const Rational& from, const Rational& time) const {
    if (!is_over(thing, from)) return of_curve(time);
    const Number ended = of_curve(thing.until);
    return thing.end == ThingEnd::kReach ? ended + reach * Number(Rational(time - thing.until)) : ended;
  }
  Number of_place(const Rational& time) const { return error + reach * Number(Rational(time - thing.from)); }

  const Thing& thing;
  Number error, speed, growth, reach;
};

/// A quadratic polynomial from three of its values, as eight control points.
template <typename Number>
std::vector<Number> raised(const Number& first, const Number& middle, const Number& last) {
  const Number between = Number(2) * middle - Number(0.5) * (first + last);
  std::vector<Number> points;
  for (int k = 0; k <= 7; ++k) {
    points.push_back(
        (Number((7 - k) * (6 - k)) * first + Number(2 * k * (7 - k)) * between + Number(k * (k - 1)) * last) /
        Number(42));
  }
  return points;
}

template <typename Number, typename Needed>
Tube<Number> tube_of(const std::vector<PointOf<Number>>& way, const std::vector<PointOf<Number>>& thing,
                     const Rational& from, const Rational& to, const Needed& needed) {
  const std::vector<Number> widths = raised<Number>(needed(from), needed(Rational((from + to) / 2)), needed(to));
  Tube<Number> tube;
  for (std::size_t i = 0; i <= kDegrees; ++i) {
    const PointOf<Number> apart = way[i] - thing[i];
    tube.push_back({apart[0], apart[1], apart[2], widths[i]});
  }
  return tube;
}

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

/// A chain of curves, seen from a place.
template <typename Number>
class Chain {
 public:
  Chain(const std::vector<TimedCurve>& curves, const Rational& begin, const Point& origin) {
    times_.push_back(begin);
    for (const TimedCurve& curve : curves) {
      times_.push_back(times_.back() + curve.duration);
      points_.emplace_back();
      for (const Point& p : curve.points) points_.back().push_back(in_numbers<Number>(p - origin));
    }
  }

  PointOf<Number> at(const Rational& time) const {
    const std::size_t i = index_at(time);
    if (i == points_.size()) return points_.back().back();
    return time == times_[i] ? points_[i].front() : point_at(points_[i], share(i, time));
  }

  /// From one time to another within one of the curves: at rest past the last one.
  std::vector<PointOf<Number>> part(const Rational& from, const Rational& to) const {
    const std::size_t i = index_at(from);
    if (i == points_.size()) return {kDegrees + 1, points_.back().back()};
    if (from == times_[i] && to == times_[i + 1]) return points_[i];
    return part_of(points_[i], share(i, from), share(i, to));
  }

 private:
  std::size_t index_at(const Rational& time) const {
    std::size_t i = 0;
    while (i < points_.size() && time >= times_[i + 1]) ++i;
    return i;
  }

  Number share(std::size_t i, const Rational& time) const {
    return Number(Rational(time - times_[i])) / Number(Rational(times_[i + 1] - times_[i]));
  }

  std::vector<std::vector<PointOf<Number>>> points_;
  std::vector<Rational> times_;
};

/// Way and thing in one kind of numbers, seen from the way's first point.
template <typename Number>
class Pair {
 public:
  Pair(const TimedWay& way, const Thing& thing, const Rational& enough)
      : way_(way),
        thing_(thing),
        enough_(Number(enough)),
        ball_(thing.shape == ThingShape::kBall ? thing.radius : Rational(0)),
        distance_(Rational(way.clearance + ball_)),
        errors_(thing),
        origin_(way.curves.front().points.front()),
        mine_(way.curves, way.begin, origin_),
        its_(thing.pieces, thing.from, origin_),
        search_(thing, enough) {}

  /// Nothing, where these numbers do not decide.
  std::optional<RoomInTime> room() {
    Rational end = way_.begin + way_.rest;
    for (const TimedCurve& curve : way_.curves) end += curve.duration;
    const std::vector<Rational> times = times_of(way_, thing_, end);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      if (is_over(thing_, times[i]) && thing_.end == ThingEnd::kGone) continue;
      search_.add(tubes_of(times[i], times[i + 1]), times[i] - way_.begin, times[i + 1] - times[i]);
    }
    if (open_) return std::nullopt;
    return search_.look(leaves_);
  }

 private:
  /// Where bounds overlap, the answer is open.
  bool is_less(const Number& a, const Number& b) {
    if (above(a) < below(b)) return true;
    open_ = open_ || below(a) < above(b);
    return false;
  }

  PointOf<Number> thing_at(const Rational& time) const {
    if (!thing_.pieces.empty()) return its_.at(time);
    return in_numbers<Number>(thing_.position + (time - thing_.from) * thing_.velocity - origin_);
  }

  std::vector<PointOf<Number>> thing_part(const Rational& from, const Rational& to) const {
    if (is_over(thing_, from)) return std::vector<PointOf<Number>>(kDegrees + 1, thing_at(thing_.until));
    if (!thing_.pieces.empty()) return its_.part(from, to);
    const PointOf<Number> first = thing_at(from);
    const PointOf<Number> way = thing_at(to) - first;
    std::vector<PointOf<Number>> points;
    for (std::size_t i = 0; i <= kDegrees; ++i) points.push_back(first + Number(Rational(i) / kDegrees) * way);
    return points;
  }

  Tubes<Number> tubes_of(const Rational& from, const Rational& to) {
    const std::vector<PointOf<Number>> mine = mine_.part(from, to);
    const std::vector<PointOf<Number>> its = thing_part(from, to);
    Tubes<Number> tubes{
        tube_of<Number>(mine, its, from, to, [&](const Rational& t) { return distance_ + errors_.of_curve(from, t); })};
    if (thing_.reach > 0) {
      const std::vector<PointOf<Number>> rest(kDegrees + 1, thing_at(thing_.from));
      tubes.push_back(
          tube_of<Number>(mine, rest, from, to, [&](const Rational& t) { return distance_ + errors_.of_place(t); }));
    }
    if (from == way_.begin) leave(tubes);
    if (gap_) {
      const bool grows = from >= way_.begin + kLeaveAfter;
      tubes.push_back(tube_of<Number>(mine, its, from, to, [&](const Rational& t) {
        return *gap_ + Number(grows ? Rational(kLeaveSpeed * (t - way_.begin - kLeaveAfter)) : Rational(0));
      }));
    }
    return tubes;
  }

  /// Whether the way leaves the thing, seen from its beginning.
  void leave(const Tubes<Number>& tubes) {
    leaves_ = true;
    for (const Tube<Number>& tube : tubes) {
      leaves_ = leaves_ && is_less(most_room(search_.shape(), tube.front()), enough_);
    }
    if (!leaves_) return;
    const Number gap = root_above(square_apart(search_.shape(), tubes.front().front()));
    if (is_less(Number(ball_), gap)) gap_ = gap;
  }

  const TimedWay& way_;
  const Thing& thing_;
  const Number enough_;
  const Rational ball_;
  const Number distance_;
  const Errors<Number> errors_;
  const Point origin_;
  const Chain<Number> mine_, its_;
  Search<Number> search_;
  std::optional<Number> gap_;  ///< at the beginning, where the way leaves the thing
  bool leaves_ = false;
  bool open_ = false;
};

}  // namespace

Polygon<3> chain_part(const std::vector<TimedCurve>& chain, Rational begin, const Rational& from, const Rational& to) {
  return Chain<Rational>(chain, begin, {0, 0, 0}).part(from, to);
}

RoomInTime room_beside(const TimedWay& way, const Thing& thing, const Rational& enough, Numbers numbers) {
  if (numbers == Numbers::kIntervalsFirst) {
    const std::optional<RoomInTime> room = Pair<Interval>(way, thing, enough).room();
    if (room && (!room->noted || room->least >= enough || room->most < enough)) return *room;
  }
  return *Pair<Rational>(way, thing, enough).room();
}

Rational whole_nanoseconds(const Rational& seconds) {
  const Rational billion = 1000000000;
  return Rational(floor_of(seconds * billion + Rational(1) / 2)) / billion;
}

}  // namespace tern_verify
