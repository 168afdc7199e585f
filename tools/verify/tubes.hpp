// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The way minus a thing's curve is a Bezier curve, with the distance that is needed as its fourth coordinate. It is
// halved until a plane parts each piece from the shape. Doubles only guess the planes. Numbers are `Rational` or
// `Interval`; what is said of their bounds holds for either.
#ifndef TERN_VERIFY_TUBES_HPP
#define TERN_VERIFY_TUBES_HPP

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "verify/bezier.hpp"
#include "verify/interval.hpp"
#include "verify/tracks.hpp"

namespace tern_verify {

constexpr std::size_t kDegrees = 7;

/// What a bound on a number is: a rational, or a double.
template <typename Number>
using BoundOf = std::decay_t<decltype(below(std::declval<const Number&>()))>;

template <typename Number>
using PointOf = std::array<Number, 3>;

/// x, y, z and the distance that is needed.
template <typename Number>
using Tube = std::vector<std::array<Number, 4>>;

/// The tubes of one stretch of time; what is clear of one of them is clear of the thing.
template <typename Number>
using Tubes = std::vector<Tube<Number>>;

template <typename Number>
PointOf<Number> in_numbers(const Point& p) {
  return {Number(p[0]), Number(p[1]), Number(p[2])};
}

/// A ball is a point here: its radius is part of the distance.
template <typename Number>
struct Shape {
  explicit Shape(const Thing& thing)
      : shape(thing.shape),
        radius(thing.radius),
        half(in_numbers<Number>(thing.half)),
        about{guess(radius), guess(half[0]), guess(half[1]), guess(half[2])} {}

  ThingShape shape;
  Number radius;
  PointOf<Number> half;
  double about[4];  ///< radius and halves, guessed
};

template <typename Number>
Number squared(const Number& a) {
  return a * a;
}

template <typename Number>
Number beyond(const Number& coordinate, const Number& half) {
  return positive_part(Number(abs(coordinate) - half));
}

/// Squared distance from the shape, from above where a cylinder's is no rational.
template <typename Number>
Number square_apart(const Shape<Number>& shape, const std::array<Number, 4>& p) {
  if (shape.shape == ThingShape::kBall) return squared(p[0]) + squared(p[1]) + squared(p[2]);
  const Number up = squared(beyond(p[2], shape.half[2]));
  if (shape.shape == ThingShape::kBox) {
    return squared(beyond(p[0], shape.half[0])) + squared(beyond(p[1], shape.half[1])) + up;
  }
  const Number across = root_above(Number(squared(p[0]) + squared(p[1])));
  return squared(positive_part(Number(across - shape.radius))) + up;
}

template <typename Number>
Number most_room(const Shape<Number>& shape, const std::array<Number, 4>& p) {
  return root_above(square_apart(shape, p)) - p[3];
}

/// A direction from the shape to a point, guessed.
template <typename Number>
PointOf<Number> direction_to(const Shape<Number>& shape, const std::array<Number, 4>& p) {
  double d[3] = {guess(p[0]), guess(p[1]), guess(p[2])};
  const double radius = shape.about[0];
  if (shape.shape != ThingShape::kBall) {
    const auto clip = [](double x, double h) { return x < -h ? x + h : x > h ? x - h : 0.0; };
    d[2] = clip(d[2], shape.about[3]);
    if (shape.shape == ThingShape::kBox) {
      d[0] = clip(d[0], shape.about[1]);
      d[1] = clip(d[1], shape.about[2]);
    } else {
      const double across = std::hypot(d[0], d[1]);
      const double share = across > radius ? 1.0 - radius / across : 0.0;
      d[0] *= share;
      d[1] *= share;
    }
  }
  const double length = std::hypot(std::hypot(d[0], d[1]), d[2]);
  if (!(length > 0.0)) return {0, 0, 1};
  return {Number(d[0] / length), Number(d[1] / length), Number(d[2] / length)};
}

/// How far the shape reaches along a direction, from above.
template <typename Number>
Number reach_along(const Shape<Number>& shape, const PointOf<Number>& n) {
  if (shape.shape == ThingShape::kBall) return 0;
  const Number up = abs(n[2]) * shape.half[2];
  if (shape.shape == ThingShape::kBox) return abs(n[0]) * shape.half[0] + abs(n[1]) * shape.half[1] + up;
  return shape.radius * root_above(Number(n[0] * n[0] + n[1] * n[1])) + up;
}

/// What the plane across the direction to the tube's middle proves for all of it, from below.
template <typename Number>
BoundOf<Number> least_room(const Shape<Number>& shape, const Tube<Number>& tube) {
  const PointOf<Number> n = direction_to(shape, Number(0.5) * (tube[3] + tube[4]));
  const Number reach = reach_along(shape, n);
  const Number square = dot(n, n);
  const Number length_below = root_below(square);
  const Number length_above = root_above(square);
  std::optional<BoundOf<Number>> least;
  for (const std::array<Number, 4>& p : tube) {
    const Number apart = n[0] * p[0] + n[1] * p[1] + n[2] * p[2] - reach;
    const Number room = apart / (below(apart) < 0 ? length_below : length_above) - p[3];
    if (!least || below(room) < *least) least = below(room);
  }
  return *least;
}

/// Looks for the least room in all stretches of time at once, coarsely first: where there is not enough, that shows
/// soon.
template <typename Number>
class Search {
 public:
  using Bound = BoundOf<Number>;

  Search(const Thing& thing, const Rational& enough) : shape_(thing), enough_(above(Number(enough))) {}

  const Shape<Number>& shape() const { return shape_; }

  void add(Tubes<Number> tubes, const Rational& begin, const Rational& length) {
    open_.push_back({std::move(tubes), begins_.size(), 0, 0});
    begins_.push_back(begin);
    lengths_.push_back(length);
  }

  /// Nothing, if more pieces are needed than doubles are good for, or larger numbers.
  std::optional<RoomInTime> look(bool leaves) {
    for (int pieces = 0; !open_.empty(); ++pieces) {
      if (pieces == kPieces && std::is_same_v<Number, Interval>) return std::nullopt;
      const Piece piece = std::move(open_.front());
      open_.pop_front();
      note_most(piece);
      const Bound proven = proven_of(piece.tubes);
      const bool is_done = proven >= enough_ && (proven >= kShare * most_ || proven >= most_ - kNothing);
      if (is_done || proven >= most_ || most_ < enough_ || piece.depth == kHalvings) {
        if (proven < least_) least_ = proven;
      } else {
        halve(piece);
      }
    }
    if (!is_finite(least_) || !is_finite(most_)) return std::nullopt;
    RoomInTime room{Rational(least_), Rational(most_), 0, leaves, noted_};
    if (noted_) room.when = begins_[stretch_] + lengths_[stretch_] * Rational(index_) / Rational(Integer(1) << depth_);
    return room;
  }

 private:
  /// Halvings after which a piece counts with what is proven of it.
  static constexpr int kHalvings = 40;
  /// Pieces that intervals look at. Where an interval is about as wide as the room, halving does not make it tell more.
  static constexpr int kPieces = 10000;

  struct Piece {
    Tubes<Number> tubes;
    std::size_t stretch;
    int depth;
    std::uint64_t index;  ///< the stretch is cut into 2^depth pieces
  };

  void halve(const Piece& piece) {
    Piece first{{}, piece.stretch, piece.depth + 1, 2 * piece.index};
    Piece second{{}, piece.stretch, piece.depth + 1, 2 * piece.index + 1};
    for (const Tube<Number>& tube : piece.tubes) {
      HalvesOf<std::array<Number, 4>> halves = halves_of(tube);
      first.tubes.push_back(std::move(halves.left));
      second.tubes.push_back(std::move(halves.right));
    }
    open_.push_back(std::move(first));
    open_.push_back(std::move(second));
  }

  Bound proven_of(const Tubes<Number>& tubes) const {
    std::optional<Bound> proven;
    for (const Tube<Number>& tube : tubes) {
      const Bound least = least_room(shape_, tube);
      if (!proven || least > *proven) proven = least;
    }
    return *proven;
  }

  void note_most(const Piece& piece) {
    std::optional<Bound> most;
    for (const Tube<Number>& tube : piece.tubes) {
      const Bound room = above(most_room(shape_, tube.front()));
      if (!most || room > *most) most = room;
    }
    if (noted_ && *most >= most_) return;
    if (!noted_) least_ = *most;
    noted_ = true;
    most_ = *most;
    stretch_ = piece.stretch;
    depth_ = piece.depth;
    index_ = piece.index;
  }

  /// A piece is looked at no closer once so much of the least room that was seen is proven of it.
  const Bound kShare = Bound(0.75);
  /// Metres that do not matter.
  const Bound kNothing = Bound(1e-6);

  const Shape<Number> shape_;
  const Bound enough_;
  Bound least_ = 0, most_ = 0;
  std::deque<Piece> open_;
  std::vector<Rational> begins_, lengths_;
  // Where the room is `most_`.
  std::size_t stretch_ = 0;
  int depth_ = 0;
  std::uint64_t index_ = 0;
  bool noted_ = false;
};

}  // namespace tern_verify

#endif
