// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_world.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "host/flight/flight_world.hpp"
#include "host/flight/noise.hpp"
#include "host/flight/vectors.hpp"
#include "host/swarm/swarm_mazes.hpp"

namespace tern_host {
namespace {

constexpr double kTurn = 6.28318530717958648;

tern::Via goal_at(const tern::Vec3& place) {
  tern::Via via;
  via.position = place;
  return via;
}

tern::Limits limits_of(double velocity, double acceleration, double jerk) {
  tern::Limits limits{{velocity, velocity, velocity}, {acceleration, acceleration, acceleration}};
  limits.j_max = {jerk, jerk, jerk};
  return limits;
}

/// Vehicles on a circle about the origin, each with the opposite place as its goal.
void add_circle(SwarmWorld& world, int count, double radius, double height, double apart) {
  for (int k = 0; k < count; ++k) {
    const double x = radius * std::cos(kTurn * k / count);
    const double y = radius * std::sin(kTurn * k / count);
    world.tasks.push_back({{x, y, height}, {goal_at({-x, -y, height})}, apart * k, 0});
  }
}

/// Upright posts with square bases, none within `room` of a start or goal.
void add_posts(SwarmWorld& world, int count, double half, double reach, double room, Noise& random) {
  for (int tries = 0, placed = 0; placed < count && tries < 100 * count; ++tries) {
    const double x = random.within(-reach, reach);
    const double y = random.within(-reach, reach);
    const tern::Box post{{x - half, y - half, world.boundary.lower.z}, {x + half, y + half, world.boundary.upper.z}};
    const auto is_near = [&](const SwarmTask& task) {
      return distance_to(post, task.start) < room || distance_to(post, task.mission.back().position) < room;
    };
    if (std::any_of(world.tasks.begin(), world.tasks.end(), is_near)) continue;
    world.blocks.push_back(post);
    ++placed;
  }
}

/// RMADER's exchange on a circle: 10 m, 10 m/s, a box of 0.25 m, here the ball around it.
SwarmWorld rmader(int count, Noise&) {
  SwarmWorld world;
  world.boundary = {{-14.0, -14.0, -1.0}, {14.0, 14.0, 5.0}};
  world.limits = limits_of(10.0, 20.0, 30.0);
  world.body_radius = 0.217;
  world.horizon = 22.0;
  add_circle(world, count, 10.0, 1.0, 0.25);
  return world;
}

/// EGO-Swarm's exchange on a circle of 12 m, at 1.5 m/s, with pillars in the middle.
SwarmWorld ego(int count, Noise& random) {
  SwarmWorld world;
  world.boundary = {{-15.0, -15.0, 0.0}, {15.0, 15.0, 4.0}};
  world.limits = limits_of(1.5, 6.0, 20.0);
  world.body_radius = 0.15;
  world.cell = 0.15;
  world.horizon = 26.0;
  world.time_limit = 120.0;
  add_circle(world, count, 12.0, 1.5, 0.0);
  add_posts(world, count > 10 ? 13 : 3, 0.3, count > 10 ? 7.5 : 2.0, 1.0, random);
  return world;
}

/// HDSM's exchange: a circle of 22 m, 5 m/s, 180 posts in 30 x 30 m.
SwarmWorld hdsm(int count, Noise& random) {
  SwarmWorld world;
  world.boundary = {{-26.0, -26.0, 0.0}, {26.0, 26.0, 4.0}};
  world.limits = limits_of(5.0, 15.0, 60.0);
  world.horizon = 46.0;
  add_circle(world, count, 22.0, 1.5, 0.0);
  add_posts(world, 180, 0.05, 15.0, 1.0, random);
  return world;
}

/// LSC's forests: a circle of 4 m, 1 m/s, 40 posts of 0.5 m.
SwarmWorld lsc(int count, Noise& random) {
  SwarmWorld world;
  world.boundary = {{-5.5, -5.5, 0.0}, {5.5, 5.5, 2.0}};
  world.limits = limits_of(1.0, 2.0, 10.0);
  world.body_radius = 0.15;
  world.cell = 0.1;
  world.horizon = 9.0;
  world.time_limit = 120.0;
  add_circle(world, count, 4.0, 1.0, 0.0);
  add_posts(world, 40, 0.25, 5.0, 0.6, random);
  return world;
}

/// LSC's circle in mazes. Theirs are planar; here, too, none can pass over another one.
SwarmWorld maze(int count, double part, Noise& random) {
  SwarmWorld world;
  world.boundary = {{-5.0, -5.0, 0.7}, {5.0, 5.0, 1.3}};
  world.limits = limits_of(1.0, 2.0, 10.0);
  world.body_radius = 0.15;
  world.cell = 0.1;
  world.horizon = 9.0;
  world.time_limit = 180.0;
  add_circle(world, count, 4.0, 1.0, 0.0);
  add_maze(world, 8, 1.25, part, 0.3, random);
  return world;
}

SwarmWorld sparse_maze(int count, Noise& random) {
  return maze(count, 0.4, random);
}

SwarmWorld dense_maze(int count, Noise& random) {
  return maze(count, 0.8, random);
}

/// LSC's narrow gap, as wide as high: half of them on each side of a wall, all to the other side.
SwarmWorld gap(int count, Noise&) {
  SwarmWorld world;
  world.boundary = {{-6.0, -6.0, 0.0}, {6.0, 6.0, 2.0}};
  world.limits = limits_of(1.0, 2.0, 10.0);
  world.body_radius = 0.15;
  world.cell = 0.1;
  world.horizon = 9.0;
  world.time_limit = 180.0;
  const int half = (count + 1) / 2;
  for (int k = 0; k < count; ++k) {
    const double side = k < half ? -1.0 : 1.0;
    const double y = 0.5 * (k % half) - 0.25 * (half - 1);
    world.tasks.push_back({{3.0 * side, y, 1.0}, {goal_at({-3.0 * side, -y, 1.0})}, 0.0, 0});
  }
  constexpr double kOpen = 0.4;  // half of the opening
  world.blocks = {{{-0.1, -6.0, 0.0}, {0.1, -kOpen, 2.0}},
                  {{-0.1, kOpen, 0.0}, {0.1, 6.0, 2.0}},
                  {{-0.1, -kOpen, 0.0}, {0.1, kOpen, 1.0 - kOpen}},
                  {{-0.1, -kOpen, 1.0 + kOpen}, {0.1, kOpen, 2.0}}};
  return world;
}

/// Swaps in empty space, as the prototypes of design papers fly them: 8 m, 2.5 m/s.
SwarmWorld swap(int count, Noise&) {
  SwarmWorld world;
  world.boundary = {{-11.0, -11.0, 0.0}, {11.0, 11.0, 5.0}};
  world.limits = limits_of(2.5, 4.0, 20.0);
  world.limits.v_max.z = 1.5;
  world.limits.a_max.z = 3.0;
  world.body_radius = 0.3;
  world.horizon = 18.0;
  add_circle(world, count, 8.0, 2.5, 0.0);
  return world;
}

/// Vehicles that come in from a circle one after the other, stand on a pad in the middle for a second, and leave for
/// the opposite place.
SwarmWorld pad(int count, Noise& random) {
  SwarmWorld world = swap(count, random);
  world.time_limit = 30.0 + 15.0 * count;
  tern::Via stop = goal_at({0.0, 0.0, 1.0});
  stop.tolerance = 0.1;
  stop.stop = true;
  stop.dwell = 1.0;
  for (SwarmTask& task : world.tasks) task.mission.insert(task.mission.begin(), stop);
  return world;
}

/// Vehicles at random places of a square, with goals 15 m away on average.
SwarmWorld scattered(int count, double half, Noise& random) {
  SwarmWorld world;
  world.boundary = {{-half, -half, 0.0}, {half, half, 6.0}};
  world.limits = limits_of(3.0, 6.0, 30.0);
  world.body_radius = 0.3;
  const auto is_free = [&](const tern::Vec3& place) {
    return std::none_of(world.tasks.begin(), world.tasks.end(), [&](const SwarmTask& task) {
      const tern::Vec3& goal = task.mission.back().position;
      return distance_between(place, task.start) < 1.2 || distance_between(place, goal) < 1.2;
    });
  };
  const auto any_place = [&] {
    tern::Vec3 place{};
    for (int tries = 0; tries < 1000; ++tries) {
      place = {random.within(1.0 - half, half - 1.0), random.within(1.0 - half, half - 1.0), random.within(1.0, 5.0)};
      if (is_free(place)) break;
    }
    return place;
  };
  for (int k = 0; k < count; ++k) {
    const tern::Vec3 start = any_place();
    tern::Vec3 goal = any_place();
    for (int tries = 0; tries < 10000 && std::hypot(goal.x - start.x, goal.y - start.y) > 20.0; ++tries)
      goal = any_place();
    world.tasks.push_back({start, {goal_at(goal)}, 0.0, 0});
  }
  return world;
}

/// On a field that grows with their number: 23 m² for each.
SwarmWorld field(int count, Noise& random) {
  return scattered(count, std::max(10.0, 1.6 * std::sqrt(static_cast<double>(count)) * 1.5), random);
}

/// The same with 100 m² for each. No vehicle's map holds more than it needs.
SwarmWorld plain(int count, Noise& random) {
  SwarmWorld world = scattered(count, std::max(10.0, 5.0 * std::sqrt(static_cast<double>(count))), random);
  world.around = 10.0;
  return world;
}

struct Family {
  const char* name;
  const char* text;
  SwarmWorld (*make)(int count, Noise& random);
};
constexpr Family kFamilies[] = {
    {"T3", "RMADER's circle of 10 m at 10 m/s, started 0.25 s apart", rmader},
    {"T7", "EGO-Swarm's circle of 12 m at 1.5 m/s, pillars in the middle", ego},
    {"T9", "HDSM's circle of 22 m at 5 m/s, 180 posts", hdsm},
    {"T10", "LSC's circle of 4 m at 1 m/s, 40 posts", lsc},
    {"T10S", "the same in sparse mazes, in which none can pass over another one", sparse_maze},
    {"T10D", "the same in dense mazes", dense_maze},
    {"gap", "LSC's narrow gap at 1 m/s: half of them on each side, all to the other side", gap},
    {"swap", "a circle of 8 m at 2.5 m/s, empty", swap},
    {"pad", "a landing pad that all visit in turn", pad},
    {"field", "random starts and goals at 3 m/s in a field that grows with the number", field},
    {"plain", "the same with four times as much room", plain},
};

/// The digits of a text from one place until another. False if that is not all there is, or too large.
template <typename Whole>
bool read_whole(const std::string& text, std::size_t from, std::size_t until, Whole& value) {
  if (from >= until) return false;
  const char* const last = text.data() + until;
  const std::from_chars_result read = std::from_chars(text.data() + from, last, value);
  return read.ec == std::errc() && read.ptr == last;
}

}  // namespace

std::string swarm_families() {
  std::string text;
  for (const Family& family : kFamilies) text += std::string(family.name) + "-N:SEED  " + family.text + "\n";
  return text;
}

SwarmWorld swarm_world(const std::string& name) {
  const std::size_t dash = std::min(name.find('-'), name.size());
  const std::size_t colon = std::min(name.find(':', dash), name.size());
  const std::string family = name.substr(0, dash);
  int count = 0;
  std::uint64_t seed = 0;
  const bool is_name = read_whole(name, dash + 1, colon, count) && read_whole(name, colon + 1, name.size(), seed);
  for (const Family& known : kFamilies) {
    if (!is_name || known.name != family || count < 1 || count > 1000) continue;
    Noise random(seed);
    SwarmWorld world = known.make(count, random);
    world.name = name;
    return world;
  }
  throw std::runtime_error("there is no swarm '" + name +
                           "': give a family, the number of vehicles and a seed, as in " + "swap-8:1. Families:\n" +
                           swarm_families());
}

double swarm_clearance(const SwarmWorld& world, const tern::Vec3& p) {
  double nearest = room_within(world.boundary, p);
  for (const tern::Box& block : world.blocks) nearest = std::min(nearest, distance_to(block, p));
  return nearest;
}

}  // namespace tern_host
