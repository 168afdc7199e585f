// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <functional>
#include <map>

#include "host/flight/flight_world.hpp"
#include "host/text_records.hpp"

namespace tern_host {
namespace {

/// What a setting of one number may be.
struct Range {
  double least;
  double most;
};

double number_within(const Words& words, const Range& range, const Place& place) {
  const std::vector<double> values = numbers(words, place);
  if (values.size() != 1) throw_count(words[0], "one number", values.size(), place);
  if (values[0] >= range.least && values[0] <= range.most) return values[0];
  throw RecordError(place, words[0] + " " + words[1] + " is not within " + std::to_string(range.least) + " .. " +
                               std::to_string(range.most));
}

using Setter = std::function<void(FlightSettings&, const Words&, const Place&)>;

Setter real(double FlightSettings::*field, double least, double most) {
  return [=](FlightSettings& s, const Words& words, const Place& place) {
    s.*field = number_within(words, {least, most}, place);
  };
}

Setter whole(int FlightSettings::*field, double least, double most) {
  return [=](FlightSettings& s, const Words& words, const Place& place) {
    s.*field = static_cast<int>(std::lround(number_within(words, {least, most}, place)));
  };
}

/// Two numbers of one record.
std::vector<double> pair(const Words& words, double least, double most, const Place& place) {
  const std::vector<double> values = numbers(words, place);
  if (values.size() != 2) throw_count(words[0], "two numbers", values.size(), place);
  for (const double value : values) {
    if (value < least || value > most) throw RecordError(place, words[0] + ": out of range");
  }
  return values;
}

void set_fov(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = pair(words, 10.0, 150.0, place);
  s.fov_horizontal = values[0];
  s.fov_vertical = values[1];
}

void set_size(FlightSettings& s, const Words& words, const Place& place) {
  const std::vector<double> values = pair(words, 8.0, 1000.0, place);
  s.width = static_cast<int>(std::lround(values[0]));
  s.height = static_cast<int>(std::lround(values[1]));
}

void set_window(FlightSettings& s, const Words& words, const Place& place) {
  s.window = vector(words, place);
  if (!(s.window.x > 0.0 && s.window.y > 0.0 && s.window.z > 0.0)) throw RecordError(place, "window: not positive");
}

void set_tracking(FlightSettings& s, const Words& words, const Place& place) {
  if (words.size() != 2 || (words[1] != "perfect" && words[1] != "bounded")) {
    throw RecordError(place, "tracking is perfect or bounded");
  }
  s.tracking = words[1];
}

const std::map<std::string, Setter>& setters() {
  using S = FlightSettings;
  static const std::map<std::string, Setter> all = {
      {"body_radius", real(&S::body_radius, 0.01, 10.0)},
      {"tracking_margin", real(&S::tracking_margin, 0.0, 10.0)},
      {"pose_margin", real(&S::pose_margin, 0.0, 10.0)},
      {"depth_margin", real(&S::depth_margin, 0.0, 10.0)},
      {"cell", real(&S::cell, 0.01, 10.0)},
      {"sensor_range", real(&S::sensor_range, 0.5, 1000.0)},
      {"sensor_hz", real(&S::sensor_hz, 0.1, 1000.0)},
      {"sensor_latency", real(&S::sensor_latency, 0.0, 10.0)},
      {"depth_noise", real(&S::depth_noise, 0.0, 0.5)},
      {"dropout", real(&S::dropout, 0.0, 1.0)},
      {"outliers", real(&S::outliers, 0.0, 1.0)},
      {"hits", whole(&S::hits, 1.0, 4.0)},
      {"v_max", real(&S::v_max, 0.01, 100.0)},
      {"a_max", real(&S::a_max, 0.01, 100.0)},
      {"j_max", real(&S::j_max, 0.0, 1e6)},
      {"yaw_rate", real(&S::yaw_rate, 0.01, 100.0)},
      {"tick_hz", real(&S::tick_hz, 1.0, 1000.0)},
      {"work_per_tick", whole(&S::work_per_tick, 128.0, 1e8)},
      {"time_limit", real(&S::time_limit, 0.1, 1e4)},
      {"goal_tolerance", real(&S::goal_tolerance, 1e-9, 10.0)},
      {"sensor_fov", set_fov},
      {"sensor_size", set_size},
      {"window", set_window},
      {"tracking", set_tracking},
      {"seed", [](S& s, const Words& words, const Place& place) {
         s.seed = static_cast<std::uint64_t>(number_within(words, {0.0, 9e15}, place));
       }}};
  return all;
}

tern::Box box_of(const Words& words, const Place& place) {
  const std::vector<double> v = numbers(words, place);
  if (v.size() != 6) throw_count(words[0], "six numbers", v.size(), place);
  if (v[0] > v[3] || v[1] > v[4] || v[2] > v[5]) throw RecordError(place, words[0] + ": lower corner above the upper");
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

Cylinder cylinder_of(const Words& words, const Place& place) {
  const std::vector<double> v = numbers(words, place);
  if (v.size() != 5) throw_count(words[0], "x y z0 z1 r", v.size(), place);
  if (v[2] > v[3] || !(v[4] > 0.0)) throw RecordError(place, "cylinder: z0 above z1, or no radius");
  return {v[0], v[1], v[2], v[3], v[4]};
}

void add_record(const Words& words, const Place& place, FlightWorld& world) {
  const std::string& key = words[0];
  const auto setter = setters().find(key);
  if (setter != setters().end()) return setter->second(world.settings, words, place);
  if (key == "boundary") {
    world.boundary = box_of(words, place);
  } else if (key == "block") {
    world.blocks.push_back(box_of(words, place));
  } else if (key == "cylinder") {
    world.cylinders.push_back(cylinder_of(words, place));
  } else if (key == "start") {
    world.start = vector(words, place);
  } else if (key == "goal") {
    world.goal = vector(words, place);
  } else {
    throw RecordError(place, "there is no record " + quote(key) + " for flights");
  }
}

Words words_of(const std::string& override_text, const Place& place) {
  const std::size_t equals = override_text.find('=');
  if (equals == std::string::npos) throw RecordError(place, quote(override_text) + " is not KEY=VALUE");
  Words words = split_words(override_text.substr(equals + 1), true);
  words.insert(words.begin(), override_text.substr(0, equals));
  return words;
}

/// A storey has doors, which coarse voxels close.
constexpr double kStorey = 3.5;

void choose_voxels(FlightWorld& world) {
  FlightSettings& s = world.settings;
  const bool indoors = world.boundary.upper.z - world.boundary.lower.z <= kStorey;
  if (!(s.cell > 0.0)) s.cell = indoors ? 0.1 : 0.2;
  if (!(s.window.x > 0.0)) s.window = indoors ? tern::Vec3{25.6, 20.0, 8.0} : tern::Vec3{51.2, 30.0, 8.0};
}

}  // namespace

FlightWorld read_flight_world(const std::string& path, const std::vector<std::string>& overrides) {
  FlightWorld world;
  world.name = path;
  const Place end = for_each_record(read_text(path), path,
                                    [&](const Words& words, const Place& place) { add_record(words, place, world); });
  for (const std::string& text : overrides) {
    const Place place{"--set", 0};
    const Words words = words_of(text, place);
    if (setters().count(words[0]) == 0) throw RecordError(place, "there is no setting " + quote(words[0]));
    add_record(words, place, world);
  }
  const tern::Box& b = world.boundary;
  if (!(b.upper.x > b.lower.x && b.upper.y > b.lower.y && b.upper.z > b.lower.z)) {
    throw RecordError(end, "there is no boundary");
  }
  choose_voxels(world);
  return world;
}

}  // namespace tern_host
