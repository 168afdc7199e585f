// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/mission_worlds.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/text_records.hpp"
#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

struct Place2 {
  double x, y;
};

/// Trees over a rectangle, none within `clear` of a place or within the radius `kept` of the middle.
std::string trees(int count, Place2 half, const std::vector<Place2>& places, double clear, double kept, Noise& random) {
  std::string text;
  for (int k = 0; k < count; ++k) {
    const Place2 tree{random.within(-half.x, half.x), random.within(-half.y, half.y)};
    const double radius = random.within(0.2, 0.4);
    bool fits = std::hypot(tree.x, tree.y) > kept;
    for (const Place2& p : places) fits = fits && std::hypot(tree.x - p.x, tree.y - p.y) > clear + radius;
    if (fits) text += record_line("cylinder", {tree.x, tree.y, 0.0, 5.0, radius});
  }
  return text;
}

/// Four lines of 32 m, 5 m apart, to and fro over a field with some trees, and back to the start.
std::string survey(Noise& random) {
  constexpr double kHalf = 16.0;
  constexpr double kApart = 5.0;
  std::vector<Place2> ends;
  for (int line = 0; line < 4; ++line) {
    const double y = kApart * (line - 1.5);
    const double side = line % 2 == 0 ? -kHalf : kHalf;
    ends.push_back({side, y});
    ends.push_back({-side, y});
  }
  const Place2 home{-kHalf - 3.0, -kApart * 1.5};
  std::vector<Place2> places = ends;
  places.push_back(home);
  std::string text = record_line("boundary", {-23.0, -14.0, 0.0, 23.0, 14.0, 5.0}) +
                     trees(18, {20.0, 11.0}, places, 1.5, 0.0, random) + record_line("start", {home.x, home.y, 2.0}) +
                     record_line("goal", {home.x, home.y, 2.0});
  for (const Place2& end : ends) text += record_line("via", {end.x, end.y, 2.0, 0.5});
  return text + "yaw unseen\n";
}

struct Gate {
  Place2 middle;
  Place2 left, right;  ///< its posts
};

/// Gate k of a lap, in its part of a bent oval.
Gate gate_of_lap(int k, int gates, Noise& random) {
  constexpr double kHalfWidth = 1.2;
  const double angle = kTurn * (k + random.within(0.3, 0.7)) / gates;
  const double wide = random.within(0.85, 1.1);
  const Place2 at{14.0 * wide * std::cos(angle), 9.0 * wide * std::sin(angle)};
  const double ahead = std::atan2(9.0 * std::cos(angle), -14.0 * std::sin(angle)) + random.within(-0.3, 0.3);
  const Place2 side{-kHalfWidth * std::sin(ahead), kHalfWidth * std::cos(ahead)};
  return {at, {at.x + side.x, at.y + side.y}, {at.x - side.x, at.y - side.y}};
}

/// Ten gates of two posts, 2.4 m apart, at various heights: through all of them and back to the start.
std::string lap(Noise& random) {
  constexpr int kGates = 10;
  constexpr Place2 kStart{14.0, -1.0};
  constexpr double kClear = 0.8;  // m about the start, for the vehicle and the errors of its camera
  const auto clear = [&](const Place2& post) { return std::hypot(post.x - kStart.x, post.y - kStart.y) > kClear; };
  std::string text = record_line("boundary", {-20.0, -14.0, 0.0, 20.0, 14.0, 5.0});
  std::string vias;
  for (int k = 0; k < kGates; ++k) {
    Gate gate = gate_of_lap(k, kGates, random);
    while (!clear(gate.left) || !clear(gate.right)) gate = gate_of_lap(k, kGates, random);
    for (const Place2& post : {gate.left, gate.right}) text += record_line("cylinder", {post.x, post.y, 0.0, 4.0, 0.1});
    vias += record_line("via", {gate.middle.x, gate.middle.y, random.within(1.2, 2.8), 0.3});
  }
  return text + record_line("start", {kStart.x, kStart.y, 1.5}) + record_line("goal", {kStart.x, kStart.y, 1.5}) +
         "yaw unseen\n" + vias;
}

/// Eight views of a tower from all sides, with the nose towards it, among trees. The camera has a wide view: it must
/// show the way beside the tower.
std::string inspection(Noise& random) {
  constexpr int kViews = 8;
  const double half = random.within(1.0, 1.6);
  const double away = random.within(5.0, 6.0);
  std::vector<Place2> places{{-14.0, 0.0}};
  std::string vias;
  for (int k = 0; k < kViews; ++k) {
    const double angle = 0.5 * kTurn + kTurn * k / kViews;
    const Place2 at{away * std::cos(angle), away * std::sin(angle)};
    places.push_back(at);
    vias += record_line("via", {at.x, at.y, random.within(1.5, 3.0), 0.3});
  }
  return record_line("boundary", {-18.0, -14.0, 0.0, 18.0, 14.0, 5.0}) +
         record_line("block", {-half, -half, 0.0, half, half, 5.0}) +
         trees(25, {16.0, 12.0}, places, 1.5, away + 1.2, random) + "start -14 0 1.5\ngoal -14 0 1.5\n" + vias +
         "sensor_fov 2.443460952792061 1.2915436464758039\nyaw point 0 0 1.5\n";
}

/// Through a forest to a place, a stop there, and back.
std::string delivery(Noise& random) {
  const Place2 there{20.0, random.within(-6.0, 6.0)};
  return record_line("boundary", {-23.0, -14.0, 0.0, 23.0, 14.0, 5.0}) +
         trees(34, {20.0, 12.0}, {{-20.0, 0.0}, there}, 2.0, 0.0, random) +
         "start -20 0 1.5\ngoal -20 0 1.5\nyaw unseen\n" + record_line("via", {there.x, there.y, 1.0, 0.0}, " stop");
}

}  // namespace

std::string mission_text(char family, Noise& random) {
  switch (family) {
    case 'L':
      return survey(random);
    case 'G':
      return lap(random);
    case 'I':
      return inspection(random);
    default:
      return delivery(random);
  }
}

}  // namespace tern_host
