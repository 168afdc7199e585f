// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tern_onboard/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace tern_onboard {
namespace {

// A row of the table: name, unit, range, whole or not, the field, what it means.
#define TERN_ROW(of, name, unit, least, most, whole, field, meaning)                          \
  Parameter<of> {                                                                             \
    name, unit, least, most, whole, [](const of& s) { return static_cast<double>(s.field); }, \
        [](of& s, double value) { s.field = static_cast<decltype(s.field)>(value); }, meaning \
  }
#define TERN_NUMBER(name, unit, least, most, field, meaning) \
  TERN_ROW(Settings, name, unit, least, most, false, field, meaning)
#define TERN_WHOLE(name, unit, least, most, field, meaning) \
  TERN_ROW(Settings, name, unit, least, most, true, field, meaning)

// clang-format off
const std::vector<Parameter<Settings>> kParameters = {
  TERN_NUMBER("cell", "m", 0.02, 2.0, map.cell, "edge of a voxel"),
  TERN_NUMBER("window_x", "m", 4.0, 1000.0, map.window.x, "length of the map's window along x; at least 128 voxels"),
  TERN_NUMBER("window_y", "m", 2.0, 1000.0, map.window.y, "along y"),
  TERN_NUMBER("window_z", "m", 1.0, 200.0, map.window.z, "along z"),
  TERN_NUMBER("radius", "m", 0.05, 10.0, map.radius, "of the body, and the error of its pose"),
  TERN_NUMBER("tracking_margin", "m", 0.0, 10.0, map.tracking_margin, "how far the vehicle may be off the command"),
  TERN_NUMBER("range", "m", 0.5, 200.0, map.range, "up to which depths are used; at most half of the window"),
  TERN_NUMBER("depth_margin", "m", 0.0, 2.0, map.depth_margin, "error of a depth, constant part"),
  TERN_NUMBER("depth_margin_square", "1/m", 0.0, 1.0, map.depth_margin_square, "error of a depth, part that grows with its square"),
  TERN_NUMBER("pose_margin", "m", 0.0, 2.0, map.pose_margin, "error of a frame's position within the map"),
  TERN_NUMBER("angle_margin", "rad", 0.0, 0.5, map.angle_margin, "error of a frame's attitude"),
  TERN_NUMBER("scan_pixel", "rad", 0.002, 1.0, map.scan_pixel, "for scans of points: twice the angle between beams"),
  TERN_WHOLE("image_pixels", "", 256, 4000000, map.image_pixels, "pixels of an image in the map; larger images are made smaller"),
  TERN_WHOLE("hits", "", 1, 4, map.hits, "hits that block a voxel; 2 if pixels may be wrong"),
  TERN_WHOLE("misses", "", 1, 4, map.misses, "misses that clear a blocked voxel"),
  TERN_WHOLE("support", "", 0, 8, map.support, "neighbours that a pixel needs; 1 if pixels may be wrong"),
  TERN_NUMBER("age", "s", 0.0, 86400.0, map.age, "how long a voxel counts as seen; 0: for ever"),
  TERN_NUMBER("free_radius", "m", 0.0, 1000.0, map.free_radius, "ball around the start that you state to be free"),

  TERN_NUMBER("speed", "m/s", 0.05, 50.0, fly.speed, "limit, horizontal"),
  TERN_NUMBER("climb", "m/s", 0.05, 50.0, fly.climb, "limit, upwards"),
  TERN_NUMBER("sink", "m/s", 0.05, 50.0, fly.sink, "limit, downwards"),
  TERN_NUMBER("acceleration", "m/s^2", 0.05, 50.0, fly.acceleration, "limit, horizontal"),
  TERN_NUMBER("acceleration_z", "m/s^2", 0.05, 50.0, fly.acceleration_z, "limit, up and down"),
  TERN_NUMBER("jerk", "m/s^3", 0.0, 1000.0, fly.jerk, "limit along each axis; 0: none"),
  TERN_NUMBER("time_weight", "", 0.001, 1e6, fly.time_weight, "how much time counts against smoothness"),
  TERN_NUMBER("horizon", "m", 0.5, 500.0, fly.horizon, "how far ahead plans lead; about 0.8 of range, less than half of window_x"),
  TERN_NUMBER("ground", "m", -1000.0, 10000.0, fly.ground, "height of the ground: the body stays above it; -1000: unknown"),
  TERN_NUMBER("ceiling", "m", -999.0, 10000.0, fly.ceiling, "greatest height of the body's centre; 1000 or more: none"),
  TERN_NUMBER("yaw_rate", "rad/s", 0.01, 100.0, fly.yaw_rate, "limit"),
  TERN_NUMBER("yaw_acceleration", "rad/s^2", 0.01, 1000.0, fly.yaw_acceleration, "limit"),
  TERN_NUMBER("field_of_view", "rad", 0.0, 6.2831853, fly.field_of_view, "horizontal field of view of the sensor; 0: it sees all around"),
  TERN_NUMBER("view_height", "rad", 0.1, 3.0, fly.view_height, "vertical field of view of the sensor"),
  TERN_NUMBER("view_pitch", "rad", -1.5, 1.5, fly.view_pitch, "how far the sensor is pitched up; negative: down"),
  TERN_NUMBER("view_raised", "rad", -1.5, 1.5, fly.view_raised, "lidar: how far the middle of its vertical view is above its level; 0.39 for a Livox Mid-360"),
  TERN_NUMBER("tick_rate", "Hz", 5.0, 500.0, fly.tick_rate, "ticks a second"),
  TERN_WHOLE("work_per_tick", "units", 256, 1000000, fly.work_per_tick, "work of a tick, about a thousand instructions each"),
  TERN_WHOLE("plan_work", "units", 256, 10000000, fly.plan_work, "work after which a plan is dropped"),

  TERN_NUMBER("pose_age", "s", 0.02, 10.0, watch.pose_age, "a pose that is older is lost: the vehicle brakes"),
  TERN_NUMBER("pose_gap", "s", 0.005, 2.0, watch.pose_gap, "frames between poses further apart are left out"),
  TERN_NUMBER("pose_jump", "m", 0.02, 100.0, watch.pose_jump, "a step of the estimate beyond this is a jump"),
  TERN_NUMBER("heading_jump", "rad", 0.02, 3.2, watch.heading_jump, "a turn of the estimate beyond this ends the flight"),
  TERN_NUMBER("frame_age", "s", 0.02, 10.0, watch.frame_age, "frames that are older are left out"),
  TERN_NUMBER("stale_after", "s", 0.0, 1000.0, watch.stale_after, "time without frames after which the map is stale; 0: never"),
  TERN_WHOLE("slow_when_straying", "", 0, 1, watch.slow_when_straying, "1: fly slower while the vehicle is off the command by most of tracking_margin"),
  TERN_NUMBER("stray", "m", 0.05, 100.0, watch.stray, "a vehicle further off the command is lost: the flight ends"),

  TERN_NUMBER("thing_sigmas", "", 1.0, 10.0, things.sigmas, "errors of things that move: so many standard deviations"),
  TERN_NUMBER("thing_memory", "s", 0.0, 3600.0, things.memory, "a thing that nobody reports for so long is gone: you vouch for it; 0: never"),
  TERN_NUMBER("thing_range", "m", 0.0, 100000.0, things.range, "things further away are left out; 0: all are"),
  TERN_NUMBER("beyond_speed", "m/s", 0.0, 1000.0, things.beyond_speed, "fly no faster than lets the vehicle stop for things this fast from beyond detector_range; 0: as fast as ever"),
  TERN_NUMBER("beyond_size", "m", 0.0, 1000.0, things.beyond_size, "of these things: from the centre to the farthest point, and the error of the measured place"),
  TERN_NUMBER("detector_range", "m", 0.1, 100000.0, things.detector_range, "within it, each such thing is reported"),
  TERN_NUMBER("detector_delay", "s", 0.0, 60.0, things.detector_delay, "from one report to the next, and until the flight has it"),
};

const std::vector<Parameter<SensorSettings>> kSensorParameters = {
  TERN_ROW(SensorSettings, "least", "m", 0.0, 50.0, false, least, "depths below it are no measurement"),
  TERN_ROW(SensorSettings, "most", "m", 0.1, 1000.0, false, most, "nor are those from here on"),
  TERN_ROW(SensorSettings, "no_return", "m", 0.0, 1000.0, false, no_return, "nothing is nearer where a pixel is 0 or +infinity: you vouch for it; 0: nothing is known"),
  TERN_ROW(SensorSettings, "time_offset", "s", -10.0, 10.0, false, time_offset, "added to the stamps of its frames"),
};
// clang-format on

/// A number as short as it can be read.
std::string brief(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string with_unit(double value, const char* unit) {
  return brief(value) + (*unit == '\0' ? "" : " ") + unit;
}

template <typename Of>
std::string set(const std::vector<Parameter<Of>>& table, Of& of, const std::string& name, double value,
                const std::string& shown) {
  for (const Parameter<Of>& row : table) {
    if (name != row.name) continue;
    const bool whole = !row.whole || value == std::floor(value);
    if (value >= row.least && value <= row.most && whole) {
      row.put(of, value);
      return {};
    }
    return "parameter " + shown + " = " + with_unit(value, row.unit) + " is refused: allowed are " +
           (row.whole ? "whole numbers " : "") + "from " + brief(row.least) + " to " + with_unit(row.most, row.unit) +
           ". It is: " + row.meaning;
  }
  return "there is no parameter " + shown;
}

template <typename Of>
std::string rows(const std::vector<Parameter<Of>>& table) {
  std::string text;
  const Of defaults{};
  for (const Parameter<Of>& row : table) {
    text += std::string("| `") + row.name + "` | " + with_unit(row.get(defaults), row.unit) + " | " + brief(row.least) +
            " to " + brief(row.most) + " | " + row.meaning + " |\n";
  }
  return text;
}

/// Null if there is none of that name.
const WordParameter* word_parameter(const std::string& name) {
  for (const WordParameter& row : word_parameters()) {
    if (name == row.name) return &row;
  }
  return nullptr;
}

/// "a, b and c", with `last` before the last one.
std::string listed(const WordParameter& row, const std::string& last) {
  std::string text = row.allowed.front();
  for (std::size_t k = 1; k < row.allowed.size(); ++k) {
    text += (k + 1 == row.allowed.size() ? last : ", ") + row.allowed[k];
  }
  return text;
}

std::string word_rows() {
  std::string text;
  Settings defaults;
  for (const WordParameter& row : word_parameters()) {
    text += std::string("| `") + row.name + "` | " + row.of(defaults) + " | " + listed(row, ", ") + " | " +
            row.meaning + " |\n";
  }
  return text;
}

}  // namespace

const std::vector<Parameter<Settings>>& parameters() {
  return kParameters;
}

const std::vector<Parameter<SensorSettings>>& sensor_parameters() {
  return kSensorParameters;
}

const std::vector<std::string>& yaw_words() {
  static const std::vector<std::string> words = {"unseen", "motion", "point", "heading"};
  return words;
}

const std::vector<std::string>& class_words() {
  static const std::vector<std::string> words = {"person", "cyclist", "car", "truck", "bird", "drone", "aircraft"};
  return words;
}

const std::vector<WordParameter>& word_parameters() {
  static const auto with_none = [](std::vector<std::string> words) {
    words.insert(words.begin(), "none");
    return words;
  };
  static const std::vector<WordParameter> words = {
      {"yaw", yaw_words(), [](Settings& s) -> std::string& { return s.fly.yaw; }, "where the nose points"},
      {"clusters", with_none(class_words()), [](Settings& s) -> std::string& { return s.things.clusters; },
       "what the sensors see move is tracked, and taken to be of this class; none: it is not"},
  };
  return words;
}

std::string set_parameter(Settings& settings, const std::string& name, double value) {
  return set(kParameters, settings, name, value, name);
}

std::string set_parameter(SensorSettings& settings, const std::string& name, double value, const std::string& prefix) {
  return set(kSensorParameters, settings, name, value, prefix + name);
}

std::string set_word(Settings& settings, const std::string& name, const std::string& word) {
  const WordParameter* const row = word_parameter(name);
  if (row == nullptr) return "there is no parameter " + name;
  if (std::find(row->allowed.begin(), row->allowed.end(), word) == row->allowed.end()) {
    return "parameter " + name + " = \"" + word + "\" is refused: allowed are " + listed(*row, " and ");
  }
  row->of(settings) = word;
  return {};
}

std::string set_parameter_text(Settings& settings, const std::string& name, const std::string& text) {
  if (word_parameter(name) != nullptr) return set_word(settings, name, text);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') return "parameter " + name + " = \"" + text + "\" is refused: it is no number";
  return set_parameter(settings, name, value);
}

std::string settings_fault(const Settings& settings) {
  const MapSettings& map = settings.map;
  const FlySettings& fly = settings.fly;
  if (!(fly.horizon < 0.5 * map.window.x)) {
    return "parameter horizon = " + with_unit(fly.horizon, "m") +
           " is refused: it must be less than half of window_x, " + with_unit(map.window.x, "m");
  }
  const double keeps = map.radius + map.tracking_margin;
  const double edges[] = {map.window.x, map.window.y, map.window.z};
  for (int k = 0; k < 3; ++k) {
    const double least = 2.0 * (keeps + 2.0 * map.cell);
    if (edges[k] >= least) continue;
    return std::string("parameter window_") + "xyz"[k] + " = " + with_unit(edges[k], "m") +
           " is refused: it must be at least " + with_unit(least, "m") +
           ", twice radius + tracking_margin + two voxels";
  }
  if (!(map.free_radius >= keeps + 2.0 * map.cell)) {
    return "parameter free_radius = " + with_unit(map.free_radius, "m") + " is refused: it must be at least " +
           with_unit(keeps + 2.0 * map.cell, "m") + ", which is radius + tracking_margin + two voxels";
  }
  if (!(fly.ceiling >= fly.ground + keeps)) {
    return "parameter ceiling = " + with_unit(fly.ceiling, "m") + " is refused: it must be at least " +
           with_unit(fly.ground + keeps, "m") + ", which is ground + radius + tracking_margin";
  }
  if (settings.things.clusters != "none" && !(settings.things.range > 0.0)) {
    return "parameter clusters = \"" + settings.things.clusters +
           "\" is refused: thing_range is 0, so all that is tracked would be left out. Raise it";
  }
  if (!(settings.watch.stray > map.tracking_margin)) {
    return "parameter stray = " + with_unit(settings.watch.stray, "m") +
           " is refused: it must be above tracking_margin, " + with_unit(map.tracking_margin, "m");
  }
  return {};
}

std::string parameter_table() {
  const std::string head = "| parameter | default | allowed | meaning |\n| --- | --- | --- | --- |\n";
  return head + rows(kParameters) + word_rows() + "\nOf each sensor:\n\n" + head + rows(kSensorParameters);
}

}  // namespace tern_onboard
