// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/problem.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "verify/fence_records.hpp"
#include "verify/track_records.hpp"

namespace tern_verify {
namespace {

/// Records that ask nothing of a plan's curve, and those that Settings reads.
const std::set<std::string> kSettings = {"start",
                                         "goal",
                                         "start_velocity",
                                         "start_acceleration",
                                         "start_jerk",
                                         "goal_velocity",
                                         "goal_acceleration",
                                         "goal_jerk",
                                         "resolution",
                                         "radius",
                                         "tracking_margin",
                                         "v_max",
                                         "a_max",
                                         "v_min",
                                         "a_min",
                                         "v_horizontal",
                                         "a_horizontal",
                                         "j_max",
                                         "j_horizontal",
                                         "thrust_max",
                                         "thrust_min",
                                         "tilt_tangent",
                                         "rate_max",
                                         "time_weight",
                                         "start_time",
                                         "rest_clear",
                                         "fences_within",
                                         "frame",
                                         "epoch",
                                         "search",
                                         "goal_mode",
                                         "yaw",
                                         "start_yaw",
                                         "start_yaw_rate",
                                         "start_yaw_acceleration",
                                         "yaw_rate_max",
                                         "yaw_acceleration_max"};

void apply(const Settings& settings, Problem& problem) {
  problem.start = {settings.vector("start"), settings.vector("start_velocity"), settings.vector("start_acceleration"),
                   settings.vector("start_jerk")};
  problem.goal = {settings.vector("goal"), settings.vector("goal_velocity"), settings.vector("goal_acceleration"),
                  settings.vector("goal_jerk")};
  std::vector<Bound>& bounds = problem.bounds;
  add_bounds(1, settings.limit("v_max", 2), settings.limit("v_min", 0), settings.number("v_horizontal", 0), bounds);
  add_bounds(2, settings.limit("a_max", 2), settings.limit("a_min", 0), settings.number("a_horizontal", 0), bounds);
  add_bounds(3, settings.limit("j_max", 0), {0, 0, 0}, settings.number("j_horizontal", 0), bounds);
  add_bounds({settings.number("thrust_max", 0), settings.number("thrust_min", 0), settings.number("tilt_tangent", 0),
              settings.number("rate_max", 0)},
             bounds);
  problem.cell = settings.number("resolution", 0.1);
  problem.radius = settings.number("radius", 0.25);
  problem.tracking_margin = settings.number("tracking_margin", 0);
  // The planner adds doubles; a rounding of the sum is no part of what was asked for.
  problem.clearance = problem.radius + problem.tracking_margin;
  if (problem.clearance <= decimal(1, 9)) problem.clearance = 0;
  keep_distance(problem.clearance, problem.fences);
  if (settings.has("frame")) problem.frame = settings.record("frame")->numbers();
  problem.epoch = settings.word("epoch");
  problem.start_time = whole_nanoseconds(settings.number("start_time", 0));
  problem.rest_clear = settings.number("rest_clear", 0);
  for (Thing& thing : problem.things) {
    if (!thing.has_from) thing.from = problem.start_time;
  }
  problem.may_end_near = settings.word("goal_mode") == "nearest";
  if (problem.cell <= 0) throw InputError(problem.name + ": 'resolution' must be more than 0");
}

bool is_solid(const Record& record) {
  const bool has_word = record.words.size() == 2;
  if (!has_word || (record.words[1] != "free" && record.words[1] != "solid")) {
    record.refuse("'unknown' needs 'free' or 'solid'");
  }
  return record.words[1] == "solid";
}

void add_map_file(const Record& record, Problem& problem) {
  if (record.words.size() != 2) record.refuse("'" + record.key() + "' needs the name of a file");
  const std::string path = (std::filesystem::path(record.file).parent_path() / record.words[1]).string();
  const std::string bytes = read_file(path);
  if (record.key() == "octomap") {
    problem.octrees.push_back(read_octree(bytes, path));
  } else {
    const std::vector<CloudPoint> points = read_cloud(bytes, path);
    problem.points.insert(problem.points.end(), points.begin(), points.end());
  }
}

/// Adds a record to the problem, or to the settings.
void add(const Record& record, Problem& problem, Settings& settings) {
  const std::string& key = record.key();
  if (key == "keepout") ++problem.keepouts;
  if (is_track_record(record)) {
    add_track_record(record, problem.keepouts, problem.things);
  } else if (key == "block" || key == "keepout") {
    Record block = record;
    if (key == "keepout") take_zone(block);
    problem.blocks.push_back(block_from(block));
  } else if (is_fence(key)) {
    problem.fences.push_back(fence_from(record));
  } else if (key == "via") {
    problem.vias.push_back(via_from(record));
  } else if (key == "boundary") {
    problem.boundary = box_from(record, record.numbers(1, 6));
    settings.add(record);
  } else if (key == "octomap" || key == "cloud") {
    add_map_file(record, problem);
  } else if (key == "unknown") {
    problem.unknown_is_solid = is_solid(record);
    settings.add(record);
  } else if (kSettings.count(key) != 0) {
    settings.add(record);
  } else {
    record.refuse("unknown record '" + key + "'");
  }
}

}  // namespace

void add_bounds(int derivative, const Point& most, const Point& least, const Rational& horizontal,
                std::vector<Bound>& bounds) {
  for (int a = 0; a < 3; ++a) {
    const auto i = static_cast<std::size_t>(a);
    if (derivative == 3 && !(most[i] > 0)) continue;
    bounds.push_back({derivative, a, 1, most[i]});
    bounds.push_back({derivative, a, -1, least[i] < 0 ? Rational(-least[i]) : most[i]});
  }
  if (horizontal > 0) bounds.push_back({derivative, kHorizontal, 1, horizontal});
}

Rational gravity() {
  return Rational(9.80665);
}

void add_bounds(const VehicleLimits& limits, std::vector<Bound>& bounds) {
  const bool has_thrust = limits.thrust_max > 0 || limits.thrust_min > 0 || limits.tilt_tangent > 0;
  const Rational fall = gravity() - limits.thrust_min;
  for (Bound& bound : bounds) {
    const bool is_fall = bound.derivative == 2 && bound.axis == 2 && bound.sign < 0;
    if (has_thrust && is_fall) bound.most = std::min<Rational>(bound.most, fall);
  }
  if (limits.thrust_max > 0) bounds.push_back({2, kThrust, 1, limits.thrust_max});
  if (limits.tilt_tangent > 0) bounds.push_back({2, kTilt, 1, limits.tilt_tangent});
  if (limits.rate_max > 0) bounds.push_back({3, kTurn, 1, limits.rate_max});
}

Problem parse_problem(const std::string& text, const std::string& name) {
  Problem problem;
  problem.name = name;
  Settings settings;
  std::vector<Record> fences;
  for (const Record& record : records_of(text, name)) {
    add(record, problem, settings);
    if (problem.fences.size() > fences.size()) fences.push_back(record);
  }
  for (const char* const key : {"boundary", "start", "goal"}) {
    if (!settings.has(key)) throw InputError(name + ": there is no '" + key + "'");
  }
  apply(settings, problem);
  refuse_empty(problem.fences, fences, problem.boundary);
  const Record* const cover = settings.record("fences_within");
  if (cover != nullptr) require_cover(*cover, problem.boundary, problem.clearance);
  if (problem.unknown_is_solid && problem.octrees.empty()) {
    throw InputError(name + ": 'unknown solid' needs an 'octomap', which says what is free");
  }
  return problem;
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be opened");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) throw InputError(path + ": cannot be read");
  if (text.rfind("version https://git-lfs.github.com/spec/", 0) == 0) {
    throw InputError(path + ": a Git LFS pointer, not the file itself: run `git lfs pull` where it was cloned");
  }
  return text;
}

Problem read_problem(const std::string& path) {
  return parse_problem(read_file(path), path);
}

}  // namespace tern_verify
