// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A piece of a curve and a solid are as far apart as any direction says: the least of the piece's control points along
// it, less the most of the solid. Doubles only guess directions, and where to look first.
#include "verify/nearest.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tern_verify {
namespace {

constexpr int kSamples = 64;  ///< of each curve, to begin with
/// Halvings after which a piece counts with what is proven of it.
constexpr int kMostSplits = 60;

/// A solid with its size in doubles.
struct Body {
  explicit Body(const Solid& s)
      : solid(&s), lower(guess(s.box.lower)), upper(guess(s.box.upper)), radius(guess(s.radius)) {}

  const Solid* solid;
  Guess lower, upper;
  double radius;

  /// From the body's nearest point to `p`.
  Guess towards(const Guess& p) const {
    Guess way;
    for (std::size_t a = 0; a < 3; ++a) way[a] = p[a] - std::clamp(p[a], lower[a], upper[a]);
    const double horizontal = std::hypot(way[0], way[1]);
    const double left = horizontal > radius ? 1.0 - radius / horizontal : 0.0;
    return {left * way[0], left * way[1], way[2]};
  }

  double distance(const Guess& p) const {
    Guess gap;
    for (std::size_t a = 0; a < 3; ++a) gap[a] = std::max(lower[a] - p[a], p[a] - upper[a]);
    const double beside = std::hypot(std::max(gap[0], 0.0), std::max(gap[1], 0.0)) - radius;
    const double horizontal = radius > 0.0 || beside > 0.0 ? beside : std::max(gap[0], gap[1]);
    if (horizontal <= 0.0 && gap[2] <= 0.0) return std::max(horizontal, gap[2]);
    return std::hypot(std::max(horizontal, 0.0), std::max(gap[2], 0.0));
  }
};

Rational positive(const Rational& number) {
  return std::max<Rational>(number, 0);
}

/// A distance that is no less than that of a point from a solid, by less than 2^-118 m.
Rational distance_above(const Point& p, const Solid& solid) {
  Point gap;
  for (std::size_t a = 0; a < 3; ++a) gap[a] = std::max<Rational>(solid.box.lower[a] - p[a], p[a] - solid.box.upper[a]);
  const Rational x = positive(gap[0]);
  const Rational y = positive(gap[1]);
  const Rational z = positive(gap[2]);
  const Rational square = x * x + y * y;
  if (solid.radius == 0) {
    const Rational most = std::max<Rational>({gap[0], gap[1], gap[2]});
    return most <= 0 ? most : root_above(square + z * z);
  }
  const Rational beside = root_above(square) - solid.radius;
  if (beside <= 0 && gap[2] <= 0) return std::max<Rational>(beside, gap[2]);
  return root_above(positive(beside) * positive(beside) + z * z);
}

/// True where one coordinate alone shows that a solid is at least so far from all of a box.
bool apart(const Box& box, const Solid& solid, const Rational& distance) {
  for (std::size_t a = 0; a < 3; ++a) {
    const Rational least = a < 2 ? Rational(distance + solid.radius) : distance;
    if (solid.box.lower[a] - box.upper[a] >= least || box.lower[a] - solid.box.upper[a] >= least) return true;
  }
  return false;
}

/// A distance that no point of the hull is nearer to the solid than, from the axes.
Rational distance_by_axes(const Box& hull, const Solid& solid) {
  Rational most = std::max<Rational>(solid.box.lower[2] - hull.upper[2], hull.lower[2] - solid.box.upper[2]);
  for (std::size_t a = 0; a < 2; ++a) {
    const Rational gap = std::max<Rational>(solid.box.lower[a] - hull.upper[a], hull.lower[a] - solid.box.upper[a]);
    most = std::max<Rational>(most, gap - solid.radius);
  }
  return most;
}

/// The same from one direction of any length but 0.
Rational distance_along(const Point& direction, const Polygon<3>& hull, const Solid& solid) {
  const Rational square = dot(direction, direction);
  Rational reach = 0;
  for (std::size_t a = 0; a < 3; ++a)
    reach += direction[a] * (direction[a] > 0 ? solid.box.upper[a] : solid.box.lower[a]);
  if (solid.radius > 0) {
    reach += solid.radius * root_above(direction[0] * direction[0] + direction[1] * direction[1]);
  }
  Rational least = dot(direction, hull.front());
  for (const Point& point : hull) least = std::min<Rational>(least, dot(direction, point));
  return (least - reach) / (least < reach ? root_below(square) : root_above(square));
}

/// The middle of a curve in doubles.
Guess middle_of(const Polygon<3>& curve) {
  std::vector<Guess> points;
  for (const Point& point : curve) points.push_back(guess(point));
  for (std::size_t last = points.size() - 1; last > 0; --last) {
    for (std::size_t i = 0; i < last; ++i) {
      for (std::size_t a = 0; a < 3; ++a) points[i][a] = 0.5 * (points[i][a] + points[i + 1][a]);
    }
  }
  return points.front();
}

class Search {
 public:
  Search(const std::vector<Polygon<3>>& curves, const std::vector<Solid>& solids) : curves_(curves) {
    for (const Solid& solid : solids) bodies_.emplace_back(solid);
    for (std::size_t c = 0; c < curves.size(); ++c) sample(c);
    reach(point_at(curves_[curve_guess_], u_guess_), curve_guess_, u_guess_, solid_guess_);
  }

  Nearest run() {
    std::vector<std::size_t> all(bodies_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    for (std::size_t c = 0; c < curves_.size(); ++c) {
      curve_ = c;
      search(curves_[c], 0, 1, all, 0);
    }
    nearest_.least = std::min<Rational>(proven_, nearest_.most - close_);
    return nearest_;
  }

 private:
  /// Where a curve seems to come nearest.
  void sample(std::size_t c) {
    for (int i = 0; i <= kSamples; ++i) {
      const Rational u = Rational(i) / kSamples;
      const Guess p = guess(point_at(curves_[c], u));
      for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const double distance = bodies_[b].distance(p);
        if (distance >= distance_guess_) continue;
        distance_guess_ = distance;
        curve_guess_ = c;
        solid_guess_ = b;
        u_guess_ = u;
      }
    }
  }

  /// A point of a curve: the least distance is that of this point at most.
  void reach(const Point& point, std::size_t curve, const Rational& u, std::size_t body) {
    const Rational distance = distance_above(point, *bodies_[body].solid);
    if (begun_ && distance >= nearest_.most) return;
    begun_ = true;
    nearest_ = {0, distance, curve, body, u};
    distance_guess_ = guess(distance);
  }

  /// The bodies that a piece may come nearer to than any point so far.
  std::vector<std::size_t> candidates(const Polygon<3>& piece, const std::vector<std::size_t>& bodies, bool last) {
    Box hull{piece.front(), piece.front()};
    for (const Point& p : piece) {
      for (std::size_t a = 0; a < 3; ++a) {
        hull.lower[a] = std::min(hull.lower[a], p[a]);
        hull.upper[a] = std::max(hull.upper[a], p[a]);
      }
    }
    const Guess middle = middle_of(piece);
    std::vector<std::size_t> left;
    for (const std::size_t b : bodies) {
      const Solid& solid = *bodies_[b].solid;
      if (apart(hull, solid, nearest_.most)) continue;
      const Guess way = bodies_[b].towards(middle);
      const double length = std::hypot(way[0], std::hypot(way[1], way[2]));
      Point direction{0, 0, 0};
      // Single precision is short to multiply with, and guess enough.
      for (std::size_t a = 0; a < 3 && length > 0.0; ++a) direction[a] = static_cast<float>(way[a] / length);
      Rational distance = distance_by_axes(hull, solid);
      if (length > 0.0) distance = std::max<Rational>(distance, distance_along(direction, piece, solid));
      if (distance >= nearest_.most - close_) continue;
      if (last) proven_ = std::min(proven_, distance);
      left.push_back(b);
    }
    return left;
  }

  void search(const Polygon<3>& piece, const Rational& u, const Rational& width, const std::vector<std::size_t>& bodies,
              int halvings) {
    const bool last = halvings == kMostSplits;
    const std::vector<std::size_t> left = candidates(piece, bodies, last);
    if (left.empty() || last) return;
    const Halves<3> halves = halves_of(piece);
    const Guess between = guess(halves.right.front());
    for (const std::size_t b : left) {
      // With a little to spare: a guess must not hide the point that is nearest.
      if (bodies_[b].distance(between) > distance_guess_ + 1e-9) continue;
      reach(halves.right.front(), curve_, u + width / 2, b);
    }
    search(halves.left, u, width / 2, left, halvings + 1);
    search(halves.right, u + width / 2, width / 2, left, halvings + 1);
  }

  const std::vector<Polygon<3>>& curves_;
  std::vector<Body> bodies_;
  const Rational close_ = decimal(5, 13);
  Nearest nearest_{};
  Rational proven_ = decimal(1, 0) * 1000000000;
  std::size_t curve_ = 0;
  bool begun_ = false;
  double distance_guess_ = HUGE_VAL;
  std::size_t curve_guess_ = 0, solid_guess_ = 0;
  Rational u_guess_ = 0;
};

}  // namespace

Nearest nearest_of(const std::vector<Polygon<3>>& curves, const std::vector<Solid>& solids) {
  return Search(curves, solids).run();
}

Nearest nearest_point(const std::vector<Point>& points, const std::vector<Solid>& solids) {
  static const Rational kRoot = Rational(1) / Rational(Integer(1) << 118);
  Nearest nearest{0, distance_above(points[0], solids[0]), 0, 0, 0};
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t s = 0; s < solids.size(); ++s) {
      if (apart({points[p], points[p]}, solids[s], nearest.most)) continue;
      const Rational distance = distance_above(points[p], solids[s]);
      if (distance < nearest.most) nearest = {0, distance, p, s, 0};
    }
  }
  nearest.least = nearest.most - kRoot;
  return nearest;
}

}  // namespace tern_verify
