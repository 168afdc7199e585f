// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/moving_worlds.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "host/flight/peopled_worlds.hpp"
#include "host/flight/published_scenes.hpp"
#include "host/text_records.hpp"
#include "host/things/thing_motion.hpp"
#include "host/things/thing_record.hpp"

namespace tern_host {
namespace {

double to_thousandths(double value) {
  return std::round(1000.0 * value) / 1000.0;
}

/// A box of random size on a knot of random size, whose speed is up to 1 to 2 m/s.
Thing knotted_box(int number, Noise& random) {
  const auto draw = [&random](double lower, double upper) { return to_thousandths(random.within(lower, upper)); };
  Thing thing;
  thing.name = std::to_string(number);
  thing.shape = tern::TrackShape::kBox;
  Trefoil knot;
  knot.center = {draw(6.0, 72.0), draw(0.0, 10.0), draw(0.5, 5.5)};
  knot.scale = {draw(1.0, 2.5) / 3.0, draw(1.0, 2.5) / 3.0, draw(0.5, 1.2) / 1.5};
  const double turn = draw(0.0, 6.283);
  thing.half = {draw(0.2, 0.4), draw(0.2, 0.4), draw(0.2, 0.4)};
  thing.motion = knot;
  knot.slower = to_thousandths(ThingMotion(thing).bounds().speed / random.within(1.0, 2.0));
  knot.ahead = to_thousandths(turn * knot.slower);
  thing.motion = knot;
  return thing;
}

/// 75 m through boxes on knots, and pillars: 35 % of all.
std::string box_corridor(int things, Noise& random) {
  const int pillars = static_cast<int>(0.35 * things);
  std::string text =
      record_line("boundary", {-0.25, -0.25, -0.25, 79.25, 10.25, 6.25}) + "body_radius 0.15\ndetection_latency 0\n";
  for (int k = 0; k < pillars; ++k) {
    const double x = random.within(5.0, 72.0);
    text += record_line("cylinder", {x, random.within(0.0, 10.0), -0.25, 6.25, 0.2});
  }
  for (int k = pillars; k < things; ++k) text += thing_line(knotted_box(k, random));
  return text + "start 2 5 3\ngoal 77 5 3\n";
}

/// Balls that steer at the vehicle at their bounds.
std::string hunters(Noise& random) {
  constexpr int kHunters = 8;
  std::string text = record_line("boundary", {-4.0, -12.0, 0.0, 34.0, 12.0, 6.0}) + "time_limit 40\n";
  for (int k = 0; k < kHunters; ++k) {
    const auto draw = [&random](double lower, double upper) { return to_thousandths(random.within(lower, upper)); };
    Thing thing;
    thing.name = std::to_string(k);
    thing.radius = 0.3;
    Hunt hunt;
    hunt.start = {draw(6.0, 30.0), draw(-10.0, 10.0), draw(0.5, 5.5)};
    hunt.acceleration = draw(1.0, 4.0);
    hunt.speed = to_thousandths(0.75 * hunt.acceleration);
    hunt.sight = 9.0;
    thing.motion = hunt;
    text += thing_line(thing);
  }
  return text + "start 0 0 1.5\ngoal 30 0 1.5\n";
}

/// The number at the end of a family's name.
int number_in(const std::string& family) {
  return std::atoi(family.c_str() + family.find_last_not_of("0123456789") + 1);
}

}  // namespace

bool is_moving_family(const std::string& family) {
  const std::string kNames[] = {"T4", "CW", "RX", "MF", "HU", "B50", "B100"};
  const std::string start = family.substr(0, 3);
  return start == "T1-" || start == "T5-" ||
         std::find(std::begin(kNames), std::end(kNames), family) != std::end(kNames);
}

std::string moving_text(const std::string& family, std::uint64_t seed, Noise& random) {
  const auto python_seed = static_cast<std::uint32_t>(seed);
  const std::string start = family.substr(0, 2);
  if (start == "T1") return mader_text(number_in(family), random);
  if (start == "T4") return dynus_text(python_seed);
  if (start == "T5") return sando_text(number_in(family), python_seed);
  if (start == "HU") return hunters(random);
  if (family[0] == 'B') return box_corridor(number_in(family), random);
  return peopled_text(family, random);
}

}  // namespace tern_host
