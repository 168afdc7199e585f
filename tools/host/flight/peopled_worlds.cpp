// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
// People walk through each other, but neither through walls nor through trees.
#include "host/flight/peopled_worlds.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "host/flight/vectors.hpp"
#include "host/text_records.hpp"
#include "host/things/thing_motion.hpp"
#include "host/things/thing_record.hpp"

namespace tern_host {
namespace {

constexpr double kPersonHeight = 1.8;
constexpr double kPersonRadius = 0.3;
constexpr double kPersonAcceleration = 3.0;

/// With three decimals.
double drawn(double lower, double upper, Noise& random) {
  return std::round(1000.0 * random.within(lower, upper)) / 1000.0;
}

Thing person(const std::string& name, Noise& random) {
  Thing thing;
  thing.name = name;
  thing.shape = tern::TrackShape::kCylinder;
  thing.radius = kPersonRadius;
  thing.half.z = 0.5 * kPersonHeight;
  Walk walk;
  walk.speed = drawn(0.7, 1.4, random);
  walk.acceleration = kPersonAcceleration;
  walk.ahead = drawn(0.0, 60.0, random);
  walk.is_loop = true;
  thing.motion = walk;
  return thing;
}

WalkPoint standing_at(double x, double y, double wait) {
  return {{x, y, 0.5 * kPersonHeight}, wait};
}

/// Ten rooms on both sides of a corridor, each with a door onto it.
class Offices {
 public:
  explicit Offices(Noise& random) {
    for (double& door : doors_) door = drawn(1.2, kRoom - 1.4, random);
  }

  std::string walls() const {
    const auto wall = [](double x0, double y0, double x1, double y1) {
      return record_line("block", {x0, y0, 0.0, x1, y1, kHeight});
    };
    std::string text = record_line("boundary", {0.0, 0.0, 0.0, kRoom * kColumns, kDepth, kHeight});
    for (int k = 0; k < kColumns; ++k) {
      for (const bool upper : {false, true}) {
        const double y = upper ? kUpperWall : kLowerWall;
        const double x = door(k, upper);
        text += wall(kRoom * k, y - kHalf, x - kHalfDoor, y + kHalf);
        text += wall(x + kHalfDoor, y - kHalf, kRoom * (k + 1), y + kHalf);
      }
      if (k == 0) continue;
      text += wall(kRoom * k - kHalf, 0.0, kRoom * k + kHalf, kLowerWall) +
              wall(kRoom * k - kHalf, kUpperWall, kRoom * k + kHalf, kDepth);
    }
    return text;
  }
  std::string ends() const {
    return record_line("start", {1.5, 1.5, 1.2}) + record_line("goal", {kRoom * kColumns - 1.5, kDepth - 1.5, 1.2});
  }
  /// From a room to another one and back, through their doors, not through those with the ends of the flight.
  std::string walker(const std::string& name, Noise& random) const {
    Thing thing = person(name, random);
    Walk& walk = std::get<Walk>(thing.motion);
    const int from = random.below(kColumns);
    const int to = (from + 1 + random.below(kColumns - 1)) % kColumns;
    const double lane = drawn(kLowerWall + 0.8, kUpperWall - 0.8, random);
    const WalkPoint first = in_room(from, random);
    const WalkPoint last = in_room(to, random);
    const WalkPoint out = standing_at(first.place.x, lane, 0.0);
    const WalkPoint in = standing_at(last.place.x, lane, 0.0);
    walk.points = {first, out, in, last, in, out};
    return thing_line(thing);
  }

 private:
  static constexpr int kColumns = 5;
  static constexpr double kRoom = 6.0;
  static constexpr double kDepth = 14.0;
  static constexpr double kHeight = 3.0;
  static constexpr double kLowerWall = 5.5;
  static constexpr double kUpperWall = 8.5;
  static constexpr double kHalf = 0.1;  // of a wall
  static constexpr double kHalfDoor = 0.7;

  double door(int column, bool upper) const { return kRoom * column + doors_[2 * column + (upper ? 1 : 0)]; }
  WalkPoint in_room(int column, Noise& random) const {
    // The first lower room and the last upper one have the ends of the flight.
    const bool upper = column == 0 || (column != kColumns - 1 && random.chance(0.5));
    const double deep = drawn(2.6, 4.5, random);
    return standing_at(door(column, upper), upper ? kUpperWall + deep : kLowerWall - deep, drawn(1.0, 8.0, random));
  }

  double doors_[2 * kColumns];
};

std::string offices(Noise& random) {
  constexpr int kWalkers = 10;
  const Offices rooms(random);
  std::string text = rooms.walls();
  for (int k = 0; k < kWalkers; ++k) text += rooms.walker("person" + std::to_string(k), random);
  return text + rooms.ends();
}

/// A road under a low bridge, with a lane each way: what is higher than a car cannot be flown over.
std::string road(Noise& random) {
  constexpr double kLane = 3.5;
  constexpr double kFar = 2000.0;       // from where cars come, and to where they go
  constexpr double kUpstream = 1500.0;  // what passes in a flight
  std::string text =
      record_line("boundary", {-25.0, -16.0, 0.0, 25.0, 16.0, 3.0}) + "detection_range 70\ndetection_error 0.1 0.3\n";
  int number = 0;
  for (const double side : {-1.0, 1.0}) {
    const double speed = drawn(7.0, 13.0, random);
    for (double x = -kUpstream; x < 100.0; x += drawn(20.0, 70.0, random)) {
      Thing thing;
      const bool is_van = random.chance(0.3);
      thing.name = (is_van ? "van" : "car") + std::to_string(number++);
      thing.shape = tern::TrackShape::kBox;
      thing.half = is_van ? tern::Vec3{3.0, 1.1, 1.3} : tern::Vec3{2.2, 0.9, 0.75};
      Walk walk;
      walk.speed = speed;
      walk.acceleration = 3.0;
      walk.ahead = std::round(1000.0 * (kFar + x) / speed) / 1000.0;
      const double y = 0.5 * side * kLane;
      walk.points = {{{-side * kFar, y, thing.half.z}, 0.0}, {{side * kFar, y, thing.half.z}, 0.0}};
      thing.motion = walk;
      text += thing_line(thing);
    }
  }
  const double from = drawn(-3.0, 3.0, random);
  const double to = drawn(-3.0, 3.0, random);
  return text + record_line("start", {from, -12.0, 1.5}) + record_line("goal", {to, 12.0, 1.5});
}

struct Tree {
  double x, y, radius;

  /// From the line between two points.
  double distance_from(const tern::Vec3& a, const tern::Vec3& b) const {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double part = std::clamp(((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(a.x + part * dx - x, a.y + part * dy - y) - radius;
  }
};

/// Trees, and among them people who stroll, carts and birds.
class PeopledForest {
 public:
  std::string text(Noise& random) {
    std::string all = record_line("boundary", {-23.0, -13.0, 0.0, 23.0, 13.0, 5.0});
    for (int k = 0; k < 24; ++k) {
      const Tree tree{random.within(-18.0, 18.0), random.within(-10.0, 10.0), random.within(0.2, 0.4)};
      trees_.push_back(tree);
      all += record_line("cylinder", {tree.x, tree.y, 0.0, 5.0, tree.radius});
    }
    for (int k = 0; k < 8; ++k) all += walker(person("person" + std::to_string(k), random), random);
    for (int k = 0; k < 3; ++k) all += walker(cart(k, random), random);
    for (int k = 0; k < 4; ++k) all += bird(k, random);
    return all + "start -20 0 1.5\ngoal 20 0 1.5\n";
  }

 private:
  static Thing cart(int number, Noise& random) {
    Thing thing = person("cart" + std::to_string(number), random);
    thing.shape = tern::TrackShape::kBox;
    thing.half = {0.5, 0.5, 0.4};
    std::get<Walk>(thing.motion).speed = drawn(1.2, 2.0, random);
    return thing;
  }

  static std::string bird(int number, Noise& random) {
    Thing thing;
    thing.name = "bird" + std::to_string(number);
    thing.radius = 0.2;
    Trefoil knot;
    knot.center = {drawn(-15.0, 15.0, random), drawn(-8.0, 8.0, random), drawn(2.5, 4.0, random)};
    knot.scale = {drawn(1.0, 2.0, random), drawn(1.0, 2.0, random), drawn(0.1, 0.4, random)};
    knot.slower = drawn(3.0, 5.0, random);
    knot.phase = drawn(0.0, 6.283, random);
    thing.motion = knot;
    return thing_line(thing);
  }

  /// A round of three to six points, clear of trees.
  std::string walker(Thing thing, Noise& random) const {
    constexpr double kRoom = 0.8;
    constexpr double kLeast = 3.0;  // m from point to point
    constexpr int kTries = 400;
    Walk& walk = std::get<Walk>(thing.motion);
    const auto is_way = [this](const tern::Vec3& a, const tern::Vec3& b) {
      if (length(along(a, -1.0, b)) < kLeast) return false;
      return std::all_of(trees_.begin(), trees_.end(), [&](const Tree& t) { return t.distance_from(a, b) > kRoom; });
    };
    const auto wanted = static_cast<std::size_t>(3 + random.below(4));
    for (int k = 0; k < kTries && walk.points.size() < wanted; ++k) {
      const tern::Vec3 place{drawn(-18.0, 18.0, random), drawn(-10.0, 10.0, random), thing.half.z};
      const double wait = random.chance(0.3) ? drawn(0.5, 5.0, random) : 0.0;
      const bool is_last = walk.points.size() + 1 == wanted;
      if (!walk.points.empty() && !is_way(walk.points.back().place, place)) continue;
      if (is_last && !is_way(place, walk.points.front().place)) continue;
      walk.points.push_back({place, wait});
    }
    const bool closes = walk.points.size() > 1 && is_way(walk.points.back().place, walk.points.front().place);
    return closes && walk_fault(walk).empty() ? thing_line(thing) : "";
  }

  std::vector<Tree> trees_;
};

}  // namespace

std::string peopled_text(const std::string& family, Noise& random) {
  if (family == "CW") return offices(random);
  if (family == "RX") return road(random);
  return PeopledForest().text(random);
}

}  // namespace tern_host
