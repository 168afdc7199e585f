// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/scenario_records.hpp"

#include <algorithm>

#include "host/number.hpp"
#include "host/via_record.hpp"
#include "host/yaw/yaw_units.hpp"
#include "tern/config.hpp"

namespace tern_host {
namespace {

std::string first_given(const Place& place) {
  return place.line > 0 ? " (first in line " + std::to_string(place.line) + ")" : std::string();
}

}  // namespace

ScenarioBuilder::ScenarioBuilder(const std::string& name)
    : choices_{{"search", {"fast", "optimal"}, 0, false, {}},
               {"goal_mode", {"exact", "nearest"}, 0, false, {}},
               {"unknown", {"free", "solid"}, 0, false, {}}} {
  scenario_.name = name;
  Scenario& s = scenario_;
  settings_ = {
      {"start", Shape::kVector, nullptr, &s.start.position, true, false, {}},
      {"goal", Shape::kVector, nullptr, &s.goal.position, true, false, {}},
      {"start_velocity", Shape::kVector, nullptr, &s.start.velocity, false, false, {}},
      {"start_acceleration", Shape::kVector, nullptr, &s.start.acceleration, false, false, {}},
      {"start_jerk", Shape::kVector, nullptr, &s.start.jerk, false, false, {}},
      {"goal_velocity", Shape::kVector, nullptr, &s.goal.velocity, false, false, {}},
      {"goal_acceleration", Shape::kVector, nullptr, &s.goal.acceleration, false, false, {}},
      {"goal_jerk", Shape::kVector, nullptr, &s.goal.jerk, false, false, {}},
      {"resolution", Shape::kScalar, &s.resolution, nullptr, false, false, {}},
      {"radius", Shape::kScalar, &s.radius, nullptr, false, false, {}},
      {"tracking_margin", Shape::kScalar, &s.tracking_margin, nullptr, false, false, {}},
      {"v_max", Shape::kLimit, nullptr, &s.limits.v_max, false, false, {}},
      {"a_max", Shape::kLimit, nullptr, &s.limits.a_max, false, false, {}},
      {"v_min", Shape::kLimit, nullptr, &s.limits.v_min, false, false, {}},
      {"a_min", Shape::kLimit, nullptr, &s.limits.a_min, false, false, {}},
      {"v_horizontal", Shape::kScalar, &s.limits.v_horizontal, nullptr, false, false, {}},
      {"a_horizontal", Shape::kScalar, &s.limits.a_horizontal, nullptr, false, false, {}},
      {"j_max", Shape::kLimit, nullptr, &s.limits.j_max, false, false, {}},
      {"j_horizontal", Shape::kScalar, &s.limits.j_horizontal, nullptr, false, false, {}},
      {"thrust_max", Shape::kScalar, &s.limits.thrust_max, nullptr, false, false, {}},
      {"thrust_min", Shape::kScalar, &s.limits.thrust_min, nullptr, false, false, {}},
      {"tilt_tangent", Shape::kScalar, &s.limits.tilt_tangent, nullptr, false, false, {}},
      {"rate_max", Shape::kScalar, &s.limits.rate_max, nullptr, false, false, {}},
      {"start_time", Shape::kScalar, &s.start_time, nullptr, false, false, {}},
      {"rest_clear", Shape::kScalar, &s.rest_clear, nullptr, false, false, {}},
      {"time_weight", Shape::kScalar, &s.time_weight, nullptr, false, false, {}},
      {"start_yaw", Shape::kScalar, &s.yaw.start, nullptr, false, false, {}},
      {"start_yaw_rate", Shape::kScalar, &s.yaw.start_rate, nullptr, false, false, {}},
      {"start_yaw_acceleration", Shape::kScalar, &s.yaw.start_acceleration, nullptr, false, false, {}},
      {"yaw_rate_max", Shape::kScalar, &s.yaw.rate_max, nullptr, false, false, {}},
      {"yaw_acceleration_max", Shape::kScalar, &s.yaw.acceleration_max, nullptr, false, false, {}},
  };
}

ScenarioBuilder::Setting* ScenarioBuilder::find(const std::string& key) {
  for (Setting& setting : settings_) {
    if (key == setting.key) return &setting;
  }
  return nullptr;
}

ScenarioBuilder::Choice* ScenarioBuilder::find_choice(const std::string& key) {
  for (Choice& choice : choices_) {
    if (key == choice.key) return &choice;
  }
  return nullptr;
}

void ScenarioBuilder::add(const std::vector<std::string>& words, const Place& place) {
  const std::string& key = words.front();
  if (key == "boundary") return add_boundary(words, place);
  if (key == "track") return scenario_.tracks.push_back(read_track(words, place));
  if (key == "track_piece") return add_track_piece(words, place, scenario_.tracks);
  if (is_fence(key)) return add_fence_record(words, place);
  if (key == "block") return add_block(words, place);
  if (key == "via") return add_via(words, place);
  if (is_earth_record(key)) return add_earth_record(words, place, scenario_.earth);
  if (key == "fences_within") return add_fence_cover(words, place);
  if (key == "octomap" || key == "cloud") return add_map_file(words, place);
  if (key == "yaw") {
    if (scenario_.has_yaw) throw ScenarioError(place, "'yaw' is given twice" + first_given(yaw_place_));
    return set_yaw(words, place);
  }
  if (Choice* const choice = find_choice(key)) {
    if (choice->given) throw ScenarioError(place, "'" + key + "' is given twice" + first_given(choice->place));
    return choose(*choice, words, place);
  }
  Setting* const setting = find(key);
  if (setting == nullptr) {
    const bool is_zones = key[0] == '{' || key[0] == '[' || key[0] == '<';
    throw ScenarioError(place, "unknown record " + quote(key) + " in a scenario; " +
                                   (is_zones ? "`tern airspace` reads zones and missions in JSON or KML"
                                             : "`tern fly` reads flight worlds"));
  }
  if (setting->given) {
    throw ScenarioError(place, "'" + key + "' is given twice" + first_given(setting->place));
  }
  assign(*setting, numbers(words, place), place);
}

void ScenarioBuilder::override_setting(const std::string& key, const std::vector<std::string>& values,
                                       const Place& place) {
  std::vector<std::string> words{key};
  words.insert(words.end(), values.begin(), values.end());
  if (key == "yaw") return set_yaw(words, place);
  if (Choice* const choice = find_choice(key)) return choose(*choice, words, place);
  Setting* const setting = find(key);
  if (setting == nullptr) throw ScenarioError(place, "unknown or not a setting: " + quote(key));
  assign(*setting, numbers(words, place), place);
}

void ScenarioBuilder::add_boundary(const std::vector<std::string>& words, const Place& place) {
  if (has_boundary_) {
    throw ScenarioError(place, "'boundary' is given twice" + first_given(scenario_.boundary_place));
  }
  const std::vector<double> values = numbers(words, place);
  if (values.size() != 6) throw_count(words.front(), "6 numbers", values.size(), place);
  scenario_.boundary = box_of(values, words.front(), place);
  scenario_.boundary_place = place;
  has_boundary_ = true;
}

void ScenarioBuilder::choose(Choice& choice, const std::vector<std::string>& words, const Place& place) {
  const std::string first = choice.words[0];
  const std::string second = choice.words[1];
  const bool known = words.size() == 2 && (words[1] == first || words[1] == second);
  if (!known) throw ScenarioError(place, std::string("'") + choice.key + "' is '" + first + "' or '" + second + "'");
  choice.chosen = words[1] == first ? 0 : 1;
  choice.given = true;
  choice.place = place;
}

void ScenarioBuilder::set_yaw(const std::vector<std::string>& words, const Place& place) {
  read_yaw_record(words, place, scenario_.yaw);
  scenario_.has_yaw = true;
  yaw_place_ = place;
}

void ScenarioBuilder::add_map_file(const std::vector<std::string>& words, const Place& place) {
  const std::string& key = words.front();
  if (words.size() != 2) throw ScenarioError(place, "'" + key + "' needs one file name, without blanks");
  if (scenario_.map_files.size() == kMaxMapFiles) {
    throw ScenarioError(place, "more than " + std::to_string(kMaxMapFiles) + " map files");
  }
  const MapFileKind kind = key == "octomap" ? MapFileKind::kOctomap : MapFileKind::kCloud;
  scenario_.map_files.push_back({kind, words[1], place});
}

void ScenarioBuilder::add_via(const std::vector<std::string>& words, const Place& place) {
  const tern::Via via = read_via(words, place);
  if (scenario_.vias.size() == std::size_t{tern::kMaxVias}) {
    throw ScenarioError(place, "more than " + std::to_string(tern::kMaxVias) + " vias");
  }
  scenario_.vias.push_back(via);
}

/// A cloud does not say what is free.
void ScenarioBuilder::check_unknown() const {
  if (scenario_.unknown == Unknown::kFree) return;
  for (const MapFile& file : scenario_.map_files) {
    if (file.kind == MapFileKind::kOctomap) return;
  }
  throw ScenarioError(choices_[2].place, "'unknown solid' needs an 'octomap', which says what is free");
}

/// A box to keep out of is a block of voxels; for a while, it is a thing that stands there.
void ScenarioBuilder::add_fence_record(const std::vector<std::string>& words, const Place& place) {
  std::vector<std::string> fence = words;
  const FenceEnd end = take_end(place, fence);
  if (words.front() == "keepout") {
    const std::string name = keepout_name(++keepouts_, end.zone);
    if (end.has_times()) return scenario_.tracks.push_back(read_timed_keepout(fence, end, name, place));
    scenario_.keepouts.push_back(name);
    return add_block(fence, place);
  }
  add_fence(fence, place, scenario_.fences, end);
  if (words.front() != "keepin" || end.has_times()) return;
  boxes_.push_back({"keepin", box_of(numbers(fence, place), "keepin", place), place.line});
}

void ScenarioBuilder::add_fence_cover(const std::vector<std::string>& words, const Place& place) {
  const auto& before = scenario_.fences_within;
  if (before) throw ScenarioError(place, "'fences_within' is given twice" + first_given(before->place));
  scenario_.fences_within = read_fence_cover(words, place);
}

/// Limits that are too low are the planner's to refuse.
void ScenarioBuilder::check_yaw() const {
  for (const Setting& setting : settings_) {
    const std::string key = setting.key;
    if (key == "start_yaw") yaw_angle(key, *setting.scalar, setting.place);
    if (key == "start_yaw_rate" || key == "yaw_rate_max") yaw_rate(key, *setting.scalar, setting.place);
    if (key == "start_yaw_acceleration" || key == "yaw_acceleration_max") {
      yaw_acceleration(key, *setting.scalar, setting.place);
    }
  }
  if (scenario_.has_yaw) return;
  for (const Setting& setting : settings_) {
    const std::string key = setting.key;
    if (!setting.given || key.find("yaw") == std::string::npos) continue;
    throw ScenarioError(setting.place, "'" + key + "' needs a 'yaw', which says where the nose should point");
  }
}

void ScenarioBuilder::add_block(const std::vector<std::string>& words, const Place& place) {
  const bool keepout = words.front() == "keepout";
  const tern::Box box = keepout ? box_of(numbers(words, place), words.front(), place) : block_box(words, place);
  if (scenario_.blocks.size() == kMaxStrips) {
    throw ScenarioError(place, "more than " + std::to_string(kMaxStrips) + " blocks");
  }
  scenario_.blocks.push_back({box, keepout});
  boxes_.push_back({keepout ? "keepout" : "block", box, place.line});
}

void ScenarioBuilder::assign(Setting& setting, const std::vector<double>& values, const Place& place) {
  const std::size_t n = values.size();
  switch (setting.shape) {
    case Shape::kScalar:
      if (n != 1) throw_count(setting.key, "1 number", n, place);
      *setting.scalar = values[0];
      break;
    case Shape::kVector:
      if (n != 3) throw_count(setting.key, "3 numbers", n, place);
      *setting.vector = {values[0], values[1], values[2]};
      break;
    case Shape::kLimit:
      if (n != 1 && n != 3) throw_count(setting.key, "1 or 3 numbers", n, place);
      *setting.vector =
          n == 1 ? tern::Vec3{values[0], values[0], values[0]} : tern::Vec3{values[0], values[1], values[2]};
      break;
  }
  setting.given = true;
  setting.place = place;
}

void ScenarioBuilder::check_ranges() const {
  for (const Setting& setting : settings_) {
    const std::string key = setting.key;
    if (key == "resolution" && !(*setting.scalar > 0.0)) {
      throw ScenarioError(setting.place, "'resolution' must be more than 0");
    }
    if (key == "start_time" && !(*setting.scalar >= -9e9 && *setting.scalar <= 9e9)) {
      throw ScenarioError(setting.place, "'start_time' is too far away");
    }
    if ((key == "radius" || key == "tracking_margin") && !(*setting.scalar >= 0.0)) {
      throw ScenarioError(setting.place, "'" + key + "' must not be less than 0");
    }
  }
}

Scenario ScenarioBuilder::finish(const Place& end, Ends ends) {
  if (!has_boundary_) throw ScenarioError(end, "the file ends without a 'boundary'");
  for (const Setting& setting : settings_) {
    if (setting.required && !setting.given && ends == Ends::kRequired) {
      throw ScenarioError(end, std::string("the file ends without a '") + setting.key + "'");
    }
  }
  check_ranges();
  scenario_.search = static_cast<tern::SearchMode>(find_choice("search")->chosen);
  scenario_.goal_mode = static_cast<tern::GoalMode>(find_choice("goal_mode")->chosen);
  scenario_.unknown = find_choice("unknown")->chosen == 0 ? Unknown::kFree : Unknown::kSolid;
  check_unknown();
  complete_tracks(scenario_.start_time, scenario_.tracks);
  check_yaw();
  scenario_.resolution_place = find("resolution")->place;
  const double clearance = scenario_.clearance();
  if (scenario_.fences_within) {
    check_fence_cover(*scenario_.fences_within, scenario_.boundary, clearance, "radius + tracking_margin");
  }
  refuse_empty_fences(scenario_.fences, scenario_.boundary, clearance);
  warn_of_records(boxes_, scenario_.boundary, reach_of(scenario_), scenario_.name, scenario_.warnings);
  return scenario_;
}

}  // namespace tern_host
