// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/problem.hpp"

#include <fstream>
#include <iterator>
#include <set>

#include "verify/records.hpp"

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
                                         "time_weight",
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
  problem.cell = settings.number("resolution", 0.1);
  problem.radius = settings.number("radius", 0.25);
  problem.tracking_margin = settings.number("tracking_margin", 0);
  // The planner adds doubles; a rounding of the sum is no part of what was asked for.
  problem.clearance = problem.radius + problem.tracking_margin;
  if (problem.clearance <= decimal(1, 9)) problem.clearance = 0;
  problem.may_end_near = settings.word("goal_mode") == "nearest";
  if (problem.cell <= 0) throw InputError(problem.name + ": 'resolution' must be more than 0");
}

/// What is free is in map files, which are not read here: a plan cannot be held against unknown space that is solid.
void check_unknown(const Record& record) {
  const bool has_word = record.words.size() == 2;
  if (has_word && record.words[1] == "solid") {
    record.refuse("'unknown solid': space that no map shows is not verified; write it as blocks");
  }
  if (!has_word || record.words[1] != "free") record.refuse("'unknown' needs 'free' or 'solid'");
}

/// Adds a record to the problem, or to the settings.
void add(const Record& record, Problem& problem, Settings& settings) {
  const std::string& key = record.key();
  if (key == "block" || key == "keepout") {
    problem.blocks.push_back(block_from(record));
  } else if (key == "keepin" || key == "keepin_halfspaces" || key == "keepout_halfspaces") {
    problem.fences.push_back(fence_from(record));
  } else if (key == "via") {
    problem.vias.push_back(via_from(record));
  } else if (key == "boundary") {
    problem.boundary = box_from(record, record.numbers(1, 6));
    settings.add(record);
  } else if (key == "octomap" || key == "cloud") {
    record.refuse("'" + key + "': maps of other files are not verified; write them as blocks");
  } else if (key == "unknown") {
    check_unknown(record);
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
  return problem;
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(path + ": cannot be opened");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) throw InputError(path + ": cannot be read");
  return text;
}

Problem read_problem(const std::string& path) {
  return parse_problem(read_file(path), path);
}

}  // namespace tern_verify
