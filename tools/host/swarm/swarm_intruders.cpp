// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/swarm/swarm_intruders.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "host/flight/flight_world.hpp"
#include "host/flight/noise.hpp"
#include "host/flight/vectors.hpp"
#include "host/nanoseconds.hpp"
#include "host/number.hpp"
#include "host/things/thing_record.hpp"
#include "host/yaw/yaw_units.hpp"

namespace tern_host {
namespace {

constexpr double kRadius = 0.3;         // m, of an intruder
constexpr double kHeightApart = 0.5;    // m, from a start
constexpr double kBeyond = 2.0;         // m, from the farthest start or goal, where an intruder turns back
constexpr double kFromStarts = 2.0;     // m, at the beginning
constexpr double kLookAtBlocks = 0.02;  // s
constexpr int kTries = 20000;
constexpr std::uint64_t kIntruderStream = 0x1A7BDE55u;  // apart from links, clocks and restarts
constexpr std::uint32_t kFirstId = 0x40000000u;         // apart from the plans of members

/// Around all starts and goals, as seen from above.
struct Area {
  double x, y, radius;
};

Area area_of(const SwarmWorld& world) {
  std::vector<tern::Vec3> places;
  for (const SwarmTask& task : world.tasks) {
    places.push_back(task.start);
    for (const tern::Via& via : task.mission) places.push_back(via.position);
  }
  tern::Box box{places.front(), places.front()};
  for (const tern::Vec3& p : places) {
    box.lower = {std::min(box.lower.x, p.x), std::min(box.lower.y, p.y), 0.0};
    box.upper = {std::max(box.upper.x, p.x), std::max(box.upper.y, p.y), 0.0};
  }
  Area area{0.5 * (box.lower.x + box.upper.x), 0.5 * (box.lower.y + box.upper.y), 0.0};
  for (const tern::Vec3& p : places) area.radius = std::max(area.radius, std::hypot(p.x - area.x, p.y - area.y));
  return area;
}

/// Through a point in the inner half of the area, to the other side and back.
Walk any_way(const SwarmWorld& world, const Area& area, const IntruderSettings& settings, Noise& random) {
  Walk walk;
  walk.speed = settings.speed * random.within(0.5, 1.0);
  walk.acceleration = settings.acceleration;
  walk.is_loop = true;
  const double start =
      world.tasks[static_cast<std::size_t>(random.below(static_cast<int>(world.tasks.size())))].start.z;
  const double lowest = world.boundary.lower.z + kRadius;
  const double highest = world.boundary.upper.z - kRadius;
  const double z = std::min(std::max(start + random.within(-kHeightApart, kHeightApart), lowest), highest);
  const double stop = 0.5 * walk.speed * walk.speed / walk.acceleration;
  const auto at = [&](double angle, double radius) {
    return WalkPoint{{area.x + radius * std::cos(angle), area.y + radius * std::sin(angle), z}, 0.0};
  };
  const double from = random.within(0.0, kTurn);
  const double until = from + kTurn * random.within(0.4, 0.6);
  const double inside = area.radius * random.within(0.0, 0.5);
  const WalkPoint turn = at(random.within(0.0, kTurn), inside);
  const double outside = area.radius + kBeyond + stop;
  walk.points = {at(from, outside), turn, at(until, outside), turn};
  return walk;
}

/// It can be flown, and touches nothing that stands still.
bool is_possible(const SwarmWorld& world, const Thing& thing) {
  const Walk& walk = std::get<Walk>(thing.motion);
  if (!walk_fault(walk).empty()) return false;
  const ThingMotion motion(thing);
  const tern::Vec3 first = motion.at(0.0).position;
  const auto is_near = [&](const SwarmTask& task) {
    return distance_between(first, task.start) < kFromStarts + kRadius + world.body_radius;
  };
  if (std::any_of(world.tasks.begin(), world.tasks.end(), is_near)) return false;
  const double room = kRadius + walk.speed * kLookAtBlocks;
  const double period = parts_of(walk).back().begin;
  for (double t = 0.0; !world.blocks.empty() && t < period; t += kLookAtBlocks) {
    const tern::Vec3 place = motion.at(t).position;
    for (const tern::Box& block : world.blocks) {
      if (distance_to(block, place) < room) return false;
    }
  }
  return true;
}

Thing any_intruder(const SwarmWorld& world, const Area& area, const IntruderSettings& settings, Noise& random) {
  Thing thing;
  thing.name = "intruder" + std::to_string(world.intruders.size());
  thing.radius = kRadius;
  for (int tries = 0; tries < kTries; ++tries) {
    Walk walk = any_way(world, area, settings, random);
    const double part = random.within(0.0, 1.0);
    if (walk_fault(walk).empty()) walk.ahead = part * parts_of(walk).back().begin;
    thing.motion = walk;
    if (settings.bounds != 1.0) thing.claimed = {settings.bounds * walk.speed, settings.bounds * walk.acceleration};
    if (is_possible(world, thing)) return thing;
  }
  throw std::runtime_error(world.name + ": no way is found for an intruder of up to " + fixed(settings.speed, 1) +
                           " m/s that turns with " + fixed(settings.acceleration, 1) +
                           " m/s^2 and touches nothing that stands still");
}

void check_count(std::size_t count) {
  if (count <= std::size_t{kMostIntruders}) return;
  throw std::runtime_error("there is room for " + std::to_string(kMostIntruders) + " intruders");
}

/// What `tern fly` tells of things, if they are seen everywhere.
FlightWorld seen_world(const SwarmWorld& world, std::uint64_t seed) {
  check_count(world.intruders.size());
  FlightWorld seen = {};
  seen.things = world.intruders;
  seen.settings.seed = seed;
  seen.settings.detection_range = 1e6;
  return seen;
}

}  // namespace

void add_intruders(SwarmWorld& world, const IntruderSettings& settings, std::uint64_t seed) {
  check_count(static_cast<std::size_t>(settings.count));
  IntruderSettings chosen = settings;
  if (!(chosen.speed > 0.0)) chosen.speed = 0.5 * world.limits.v_max.x;
  Noise random(seed ^ kIntruderStream);
  const Area area = area_of(world);
  for (int k = 0; k < settings.count; ++k) world.intruders.push_back(any_intruder(world, area, chosen, random));
}

std::vector<std::string> lines_of(const std::vector<Thing>& things) {
  std::vector<std::string> lines;
  for (const Thing& thing : things) {
    lines.push_back(thing_line(thing));
    lines.back().pop_back();
  }
  return lines;
}

std::vector<tern::Vec3> places_of(const std::vector<ThingMotion>& motions, std::int64_t t) {
  std::vector<tern::Vec3> places;
  for (const ThingMotion& motion : motions) places.push_back(motion.at(seconds_of(t)).position);
  return places;
}

void watch_intruders(const SwarmWorld& world, SwarmWatch& watch) {
  for (const Thing& thing : world.intruders) {
    const ThingMotion motion(thing);
    watch.add_intruder(
        {thing.radius, motion.bounds().speed, [motion](std::int64_t t) { return motion.at(seconds_of(t)).position; }});
  }
}

IntruderReports::IntruderReports(const SwarmWorld& world, std::uint64_t seed, std::int64_t begin, std::int64_t tick)
    : seen_(seen_world(world, seed)),
      motions_(motions_of(seen_.things)),
      detector_(seen_, motions_, begin, kFirstId),
      last_tick_(begin),
      tick_(tick) {}

void IntruderReports::tell(std::int64_t time, const tern::Vec3& place, tern::Flight& flight) {
  // A flight takes nothing from more than a tick after its last one, which is where a late tick begins.
  detector_.take(std::min(time, last_tick_ + tick_), place, place);
  detector_.deliver(time, flight, tape_);
  last_tick_ = time;
}

}  // namespace tern_host
