// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/fault_records.hpp"

#include <algorithm>
#include <cmath>

#include "host/fence_record.hpp"
#include "host/number.hpp"

namespace tern_host {
namespace {

using tern::Vec3;

constexpr double kOutside = 5.0;  // metres beyond the boundary

/// Without a second number, it goes on for ever.
void set_goal_jitter(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = numbers(words, place);
  if (values.empty() || values.size() > 2) throw_count(words[0], "one or two numbers", values.size(), place);
  s.goal_jitter.size = within(words[0], values[0], {0.0, 1000.0}, place);
  s.goal_jitter.until = values.size() == 2 ? within(words[0], values[1], {0.0, kLongestFlight}, place) : kLongestFlight;
}

void set_pose_jump(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = two_numbers(words, place);
  s.pose_jump.size = within(words[0], values[0], {0.0, 10.0}, place);
  s.pose_jump.every = within(words[0], values[1], {0.01, kLongestFlight}, place);
}

void set_tick_skip(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = two_numbers(words, place);
  const double share = within(words[0], values[0], {0.0, 1.0}, place);
  s.tick_skip.longest = static_cast<int>(whole_within(words[0], values[1], {1.0, 50.0}, place));
  // With a tick behind every run.
  const double mean = 0.5 * (1.0 + s.tick_skip.longest);
  const double most = mean / (mean + 1.0);
  if (share > most) {
    throw RecordError(place, words[0] + ": with runs of up to " + std::to_string(s.tick_skip.longest) +
                                 " ticks, at most " + fixed(most, 3) + " of all are skipped");
  }
  s.tick_skip.share = share;
}

void set_appear_ahead(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = two_numbers(words, place);
  s.appear_ahead.time = within(words[0], values[0], {0.0, kLongestFlight}, place);
  s.appear_ahead.distance = within(words[0], values[1], {0.0, 1000.0}, place);
}

void set_goal_place(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<std::string> places = {"given", "occupied", "outside"};
  if (words.size() != 2 || std::find(places.begin(), places.end(), words[1]) == places.end()) {
    throw RecordError(place, "goal_place is given, occupied or outside");
  }
  s.goal_place = words[1];
}

double between(double low, double high, double at) {
  return std::min(std::max(at, low), high);
}

/// The middle of the obstacle that is nearest, at the goal's height where the obstacle has it.
Vec3 inside_nearest(const FlightWorld& world) {
  const Vec3& goal = world.goal;
  double nearest = 1e300;
  Vec3 inside = goal;
  const auto note = [&](const Vec3& middle, double bottom, double top) {
    const double distance = std::hypot(middle.x - goal.x, middle.y - goal.y);
    if (!(distance < nearest)) return;
    nearest = distance;
    inside = {middle.x, middle.y, between(bottom, top, goal.z)};
  };
  for (const tern::Box& b : world.blocks) {
    note({0.5 * (b.lower.x + b.upper.x), 0.5 * (b.lower.y + b.upper.y), 0.0}, b.lower.z, b.upper.z);
  }
  for (const Cylinder& c : world.cylinders) note({c.x, c.y, 0.0}, c.bottom, c.top);
  return inside;
}

/// Beyond the side of the boundary that is nearest.
Vec3 outside_of(const tern::Box& b, const Vec3& goal) {
  const double to_sides[4] = {goal.x - b.lower.x, b.upper.x - goal.x, goal.y - b.lower.y, b.upper.y - goal.y};
  const auto side = std::min_element(std::begin(to_sides), std::end(to_sides)) - std::begin(to_sides);
  Vec3 moved = goal;
  if (side == 0) moved.x = b.lower.x - kOutside;
  if (side == 1) moved.x = b.upper.x + kOutside;
  if (side == 2) moved.y = b.lower.y - kOutside;
  if (side == 3) moved.y = b.upper.y + kOutside;
  return moved;
}

}  // namespace

void add_fault_setters(Setters& setters) {
  setters["pose_jump"] = set_pose_jump;
  setters["pose_drift"] = real(&FlightSettings::pose_drift, 0.0, 10.0);
  setters["pose_lag"] = real(&FlightSettings::pose_lag, 0.0, 1.0);
  setters["tick_skip"] = set_tick_skip;
  setters["goal_jitter"] = set_goal_jitter;
  setters["appear_ahead"] = set_appear_ahead;
  setters["goal_place"] = set_goal_place;
  setters["frames_until"] = real(&FlightSettings::frames_until, 0.0, kLongestFlight);
}

Cylinder read_cylinder(const Words& words, const Place& place) {
  const std::vector<double> v = numbers(words, place);
  if (v.size() != 5) throw_count(words[0], "x y z0 z1 r", v.size(), place);
  if (v[2] > v[3] || !(v[4] > 0.0)) throw RecordError(place, "cylinder: z0 above z1, or no radius");
  return {v[0], v[1], v[2], v[3], v[4]};
}

Appearance read_appearance(const Words& words, const Place& place) {
  const bool is_known = words.size() > 3 && (words[2] == "block" || words[2] == "cylinder");
  if (!is_known) throw RecordError(place, "appear is followed by a time, and by a block or a cylinder");
  Appearance appearance{};
  appearance.time = within("appear", number(words[1], place), {0.0, kLongestFlight}, place);
  appearance.is_block = words[2] == "block";
  const Words rest(words.begin() + 2, words.end());
  if (appearance.is_block) {
    appearance.block = block_box(rest, place);
  } else {
    appearance.cylinder = read_cylinder(rest, place);
  }
  return appearance;
}

void place_goal(FlightWorld& world, const Place& place) {
  if (world.settings.goal_place == "outside") world.goal = outside_of(world.boundary, world.goal);
  if (world.settings.goal_place != "occupied") return;
  if (world.blocks.empty() && world.cylinders.empty()) {
    throw RecordError(place, "goal_place occupied: there is no obstacle");
  }
  world.goal = inside_nearest(world);
}

}  // namespace tern_host
