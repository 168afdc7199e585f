// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/published_scenes.hpp"

#include <cmath>
#include <cstdlib>

#include "host/flight/flight_world.hpp"
#include "host/number.hpp"
#include "host/text_records.hpp"
#include "host/things/python_random.hpp"
#include "host/things/thing_record.hpp"

namespace tern_host {
namespace {

constexpr double kMovingPart = 0.65;
constexpr double kUprightPart = 0.35;  // of the bars
constexpr tern::Vec3 kCube{0.4, 0.4, 0.4};
constexpr tern::Vec3 kUpright{0.2, 0.2, 2.0};
/// A millimetre, for rounding.
const std::string kExactVehicle = "tracking perfect\ntracking_margin 0.001\n";

std::string box_on(int number, const tern::Vec3& half, const Trefoil& knot) {
  Thing thing;
  thing.name = std::to_string(number);
  thing.shape = tern::TrackShape::kBox;
  thing.half = half;
  thing.motion = knot;
  return thing_line(thing);
}

/// As Python's round(value, 2).
double to_hundredths(double value) {
  return std::strtod(fixed(value, 2).c_str(), nullptr);
}

/// Nothing that stands still may cover an end of the flight.
bool is_near_end(const tern::Box& box, const tern::Vec3& start, const tern::Vec3& goal) {
  constexpr double kRoom = 0.7;
  return distance_to(box, start) < kRoom || distance_to(box, goal) < kRoom;
}

}  // namespace

std::string mader_text(int things, Noise& random) {
  constexpr double kPi2 = 6.28318530717958648;
  const int moving = static_cast<int>(kMovingPart * things);
  const int bars = things - moving;
  std::string text = record_line("boundary", {-3.0, -10.0, 0.0, 79.0, 10.0, 4.0}) + kExactVehicle +
                     "body_radius 0.05\ndetection_hz 50\ndetection_latency 0\ndetection_error 0 0\n";
  for (int k = 0; k < moving; ++k) {
    const double x = random.within(2.0, 75.0);
    const double y = random.within(-3.0, 3.0);
    const double z = random.within(1.0, 2.0);
    text += box_on(k, kCube, {{x, y, z}, {1.0, 1.0, 1.0}, 1.1, random.within(-kPi2, kPi2), 0.0});
  }
  for (int k = 0; k < bars; ++k) {
    const bool is_upright = k < kUprightPart * bars;
    const double z = is_upright ? kUpright.z : random.within(0.0, 3.0);
    const double x = random.within(1.0, 76.0);
    const double y = random.within(-4.0, 4.0);
    // z - sin(t + phase): three turns of a trefoil that is three times as slow.
    const Trefoil swing{{x, y, z}, {0.0, 0.0, 1.0}, 3.0, random.within(-kPi2, kPi2), 0.0};
    text += box_on(moving + k, is_upright ? kUpright : tern::Vec3{0.2, 4.0, 0.2}, swing);
  }
  return text + "start 0 0 1\ngoal 75 0 1\n";
}

std::string dynus_text(std::uint32_t seed) {
  constexpr int kCubes = 20;
  PythonRandom random(seed);
  std::string text = record_line("boundary", {-34.0, -10.0, 0.0, 34.0, 10.0, 8.0}) + kExactVehicle +
                     "body_radius 0.1\ndetection_latency 0.15\ndetection_error 0.2 0.2\n";
  for (int k = 0; k < kCubes; ++k) {
    const auto draw = [&random](double lower, double upper) { return to_hundredths(random.uniform(lower, upper)); };
    Trefoil knot;
    knot.center.x = -20.0 + 2.0 * k;
    knot.center.y = draw(-5.0, 5.0);
    knot.center.z = draw(2.0, 6.0);
    knot.scale.x = draw(2.0, 4.0) / 6.0;
    knot.scale.y = draw(2.0, 4.0) / 5.0;
    knot.scale.z = draw(0.0, 2.0) / 2.0;
    knot.phase = draw(0.0, 2.0);
    knot.slower = draw(4.0, 6.0);
    text += box_on(k, kCube, knot);
  }
  return text + "start -30 0 3\ngoal 30 0 3\n";
}

std::string sando_text(int obstacles, std::uint32_t seed) {
  constexpr tern::Vec3 kStart{0.0, 0.0, 2.0};
  constexpr tern::Vec3 kGoal{105.0, 0.0, 2.0};
  const int moving = static_cast<int>(kMovingPart * obstacles);
  const int bars = obstacles - moving;
  PythonRandom random(seed);
  std::string text = record_line("boundary", {-5.0, -10.0, 0.0, 110.0, 10.0, 5.0}) + kExactVehicle +
                     "body_radius 0.1\ndetection_hz 50\ndetection_latency 0\ndetection_error 0 0\n";
  for (int k = 0; k < obstacles; ++k) {
    Trefoil knot;
    knot.center.x = random.uniform(5.0, 105.0);
    knot.center.y = random.uniform(-6.0, 6.0);
    knot.center.z = random.uniform(0.5, 4.5);
    if (k < moving) {
      knot.scale.x = random.uniform(2.0, 4.0) / 6.0;
      knot.scale.y = random.uniform(2.0, 4.0) / 5.0;
      knot.scale.z = random.uniform(2.0, 4.0) / 2.0;
      knot.phase = random.uniform(0.0, 3.0);
      knot.slower = random.uniform(10.0, 12.0);
      text += box_on(k, kCube, knot);
      continue;
    }
    const bool is_upright = k - moving < kUprightPart * bars;
    const tern::Vec3 half = is_upright ? kUpright : tern::Vec3{0.2, 2.0, 0.2};
    const tern::Vec3 at{knot.center.x, knot.center.y, is_upright ? kUpright.z : knot.center.z};
    const tern::Box box{{at.x - half.x, at.y - half.y, at.z - half.z}, {at.x + half.x, at.y + half.y, at.z + half.z}};
    if (is_near_end(box, kStart, kGoal)) continue;
    text += record_line("block", {box.lower.x, box.lower.y, box.lower.z, box.upper.x, box.upper.y, box.upper.z});
  }
  return text + record_line("start", {kStart.x, kStart.y, kStart.z}) + record_line("goal", {kGoal.x, kGoal.y, kGoal.z});
}

}  // namespace tern_host
