// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/pixel_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tern_host {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Depths from `enter` to `leave`; none where enter > leave.
struct Interval {
  double enter = kInfinity;
  double leave = -kInfinity;

  void take(double depth) {
    enter = std::min(enter, depth);
    leave = std::max(leave, depth);
  }
  void take(const Interval& other) {
    enter = std::min(enter, other.enter);
    leave = std::max(leave, other.leave);
  }
};

/// A place on the ground as the camera sees it.
struct GroundPoint {
  double ahead, right;
};

/// What is nearer than `reach` along the ground, and so may be seen: most of a world is not. Blocks, cylinders and
/// boundary alone.
FlightWorld nearby(const FlightWorld& world, const tern::Vec3& eye, double reach) {
  FlightWorld near;
  near.boundary = world.boundary;
  for (const tern::Box& b : world.blocks) {
    const double x = std::max({b.lower.x - eye.x, eye.x - b.upper.x, 0.0});
    const double y = std::max({b.lower.y - eye.y, eye.y - b.upper.y, 0.0});
    if (x * x + y * y < reach * reach) near.blocks.push_back(b);
  }
  for (const Cylinder& c : world.cylinders) {
    const double x = c.x - eye.x;
    const double y = c.y - eye.y;
    const double most = reach + c.radius;
    if (x * x + y * y < most * most) near.cylinders.push_back(c);
  }
  return near;
}

/// Cuts the range down to where from + t along lies between two planes.
void cut(double from, double along, double lower, double upper, Interval& range) {
  if (along < 0.0 || along > 0.0) {
    const double a = (lower - from) / along;
    const double b = (upper - from) / along;
    range.enter = std::max(range.enter, std::min(a, b));
    range.leave = std::min(range.leave, std::max(a, b));
  } else if (from < lower || from > upper) {
    range.leave = -kInfinity;
  }
}

/// Where factor t <= most.
void keep_below(double factor, double most, Interval& range) {
  if (factor > 0.0) {
    range.leave = std::min(range.leave, most / factor);
  } else if (factor < 0.0) {
    range.enter = std::max(range.enter, most / factor);
  } else if (most < 0.0) {
    range.leave = -kInfinity;
  }
}

}  // namespace

/// The camera, seen from above.
struct PixelColumns::View {
  tern::Vec3 eye;
  double cosine, sine, far;
  const std::vector<double>& borders;

  GroundPoint place(double x, double y) const {
    const double dx = x - eye.x;
    const double dy = y - eye.y;
    return {dx * cosine + dy * sine, dx * sine - dy * cosine};
  }
  /// Along a border, for each metre ahead.
  double x_of(double right) const { return cosine + right * sine; }
  double y_of(double right) const { return sine - right * cosine; }

  /// Where a border cuts a thing's outline on the ground.
  Interval along(const tern::Box& b, double right) const {
    Interval range{0.0, far};
    cut(eye.x, x_of(right), b.lower.x, b.upper.x, range);
    cut(eye.y, y_of(right), b.lower.y, b.upper.y, range);
    return range;
  }
  Interval along(const Cylinder& c, double right) const {
    const GroundPoint center = place(c.x, c.y);
    const double square = 1.0 + right * right;
    const double mixed = center.ahead + center.right * right;
    const double apart = center.right - right * center.ahead;
    const double rest = square * c.radius * c.radius - apart * apart;
    if (rest < 0.0) return {};
    const double half = std::sqrt(rest);
    return {std::max(0.0, (mixed - half) / square), std::min(far, (mixed + half) / square)};
  }
  /// The places of a thing's outline at which its depth may be least or greatest between two borders.
  std::array<GroundPoint, 4> ends(const tern::Box& b) const {
    return {place(b.lower.x, b.lower.y), place(b.lower.x, b.upper.y), place(b.upper.x, b.lower.y),
            place(b.upper.x, b.upper.y)};
  }
  std::array<GroundPoint, 2> ends(const Cylinder& c) const {
    const GroundPoint center = place(c.x, c.y);
    return {GroundPoint{center.ahead - c.radius, center.right}, GroundPoint{center.ahead + c.radius, center.right}};
  }
};

namespace {

double bottom_of(const tern::Box& b) {
  return b.lower.z;
}
double bottom_of(const Cylinder& c) {
  return c.bottom;
}
double top_of(const tern::Box& b) {
  return b.upper.z;
}
double top_of(const Cylinder& c) {
  return c.top;
}

}  // namespace

/// What lies between two borders is convex, seen from above: its depth is least and greatest on a border or at an end.
template <typename Thing>
void PixelColumns::add(const Thing& thing, const View& view) {
  const std::size_t columns = things_.size();
  std::vector<Interval> ranges(columns);
  for (std::size_t k = 0; k <= columns; ++k) {
    const Interval on_border = view.along(thing, view.borders[k]);
    if (on_border.enter > on_border.leave) continue;
    if (k > 0) ranges[k - 1].take(on_border);
    if (k < columns) ranges[k].take(on_border);
  }
  for (const GroundPoint& end : view.ends(thing)) {
    if (!(end.ahead > 0.0)) continue;
    const double right = end.right / end.ahead;
    if (right < view.borders.front() || right > view.borders.back()) continue;
    const auto next = std::upper_bound(view.borders.begin() + 1, view.borders.end() - 1, right);
    ranges[static_cast<std::size_t>(next - view.borders.begin()) - 1].take(end.ahead);
  }
  for (std::size_t k = 0; k < columns; ++k) {
    const Interval& range = ranges[k];
    if (range.enter <= range.leave && range.enter < view.far) {
      things_[k].push_back({range.enter, range.leave, bottom_of(thing), top_of(thing)});
    }
  }
}

PixelColumns::PixelColumns(const FlightWorld& world, const tern::Vec3& eye, double yaw, double far,
                           const std::vector<double>& borders)
    : height_(eye.z),
      bottom_(world.boundary.lower.z),
      top_(world.boundary.upper.z),
      walls_(borders.size() - 1, far),
      things_(borders.size() - 1) {
  const View view{eye, std::cos(yaw), std::sin(yaw), far, borders};
  const double widest = std::hypot(1.0, std::max(std::abs(borders.front()), std::abs(borders.back())));
  const FlightWorld near = nearby(world, eye, far * widest);
  for (std::size_t k = 0; k < walls_.size(); ++k) {
    const double left = view.along(world.boundary, borders[k]).leave;
    const double right = view.along(world.boundary, borders[k + 1]).leave;
    walls_[k] = std::max(0.0, std::min(left, right));
  }
  for (const tern::Box& block : near.blocks) add(block, view);
  for (const Cylinder& cylinder : near.cylinders) add(cylinder, view);
  for (std::vector<DepthRange>& column : things_) {
    std::sort(column.begin(), column.end(), [](const DepthRange& a, const DepthRange& b) { return a.enter < b.enter; });
  }
}

double PixelColumns::depth(int column, double upper, double lower) const {
  Interval inside{0.0, walls_[static_cast<std::size_t>(column)]};
  keep_below(lower, height_ - bottom_, inside);
  keep_below(-upper, top_ - height_, inside);
  double best = std::max(0.0, inside.leave);
  for (const DepthRange& thing : things_[static_cast<std::size_t>(column)]) {
    if (thing.enter >= best) break;
    best = std::min(best, depth_of(thing, upper, lower));
  }
  return best;
}

double PixelColumns::depth_of(const DepthRange& thing, double upper, double lower) const {
  Interval range{thing.enter, thing.leave};
  keep_below(upper, height_ - thing.bottom, range);
  keep_below(-lower, thing.top - height_, range);
  return range.enter <= range.leave ? range.enter : kInfinity;
}

/// Of what is in the area at one depth, the nearest is nearest to the eye's height. That is no nearer at a greater
/// depth: so the nearest point of all has the least depth.
double PixelColumns::distance_of(const DepthRange& thing, double upper, double lower) const {
  const double ahead = depth_of(thing, upper, lower);
  if (!(ahead < kInfinity)) return kInfinity;
  const double least = std::max(height_ - thing.top, upper * ahead);
  const double most = std::min(height_ - thing.bottom, lower * ahead);
  return std::hypot(ahead, std::max({0.0, least, -most}));
}

double PixelColumns::distance(int column, double upper, double lower) const {
  const auto at = static_cast<std::size_t>(column);
  const DepthRange beyond[3] = {{walls_[at], kInfinity, -kInfinity, kInfinity},
                                {0.0, kInfinity, -kInfinity, bottom_},
                                {0.0, kInfinity, top_, kInfinity}};
  double best = kInfinity;
  for (const DepthRange& side : beyond) best = std::min(best, distance_of(side, upper, lower));
  for (const DepthRange& thing : things_[at]) {
    if (thing.enter >= best) break;
    best = std::min(best, distance_of(thing, upper, lower));
  }
  return best;
}

}  // namespace tern_host
