// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/problem.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <locale>
#include <map>
#include <set>
#include <sstream>

namespace tern_verify {
namespace {

/// One line of a scenario: a keyword and what follows.
struct Record {
  std::string file;
  int line;
  std::vector<std::string> words;

  [[noreturn]] void refuse(const std::string& reason) const {
    throw InputError(file + ":" + std::to_string(line) + ": " + reason);
  }

  /// The words from `first` on as numbers: the doubles next to them, taken as they are.
  std::vector<Rational> numbers(std::size_t first = 1) const {
    std::vector<Rational> values;
    for (std::size_t i = first; i < words.size(); ++i) {
      std::istringstream stream(words[i]);
      stream.imbue(std::locale::classic());
      double value = 0.0;
      stream >> value;
      if (stream.fail() || !stream.eof() || !std::isfinite(value)) refuse("'" + words[i] + "' is no number");
      values.emplace_back(value);
    }
    return values;
  }

  std::vector<Rational> numbers(std::size_t first, std::size_t count) const {
    std::vector<Rational> values = numbers(first);
    if (values.size() != count) refuse("'" + words[0] + "' needs " + std::to_string(count) + " numbers");
    return values;
  }
};

Point point(const std::vector<Rational>& v, std::size_t first = 0) {
  return {v[first], v[first + 1], v[first + 2]};
}

Box box(const Record& record, const std::vector<Rational>& v) {
  const Box result{point(v), point(v, 3)};
  for (std::size_t a = 0; a < 3; ++a) {
    if (result.lower[a] > result.upper[a]) record.refuse("the box has its corners the wrong way round");
  }
  return result;
}

Fence fence(const Record& record) {
  Fence result{record.words[0] != "keepout_halfspaces", {}};
  if (record.words[0] == "keepin") {
    const Box inside = box(record, record.numbers(1, 6));
    for (std::size_t a = 0; a < 3; ++a) {
      Point axis{0, 0, 0};
      axis[a] = 1;
      result.planes.push_back({axis, inside.upper[a]});
      axis[a] = -1;
      result.planes.push_back({axis, -inside.lower[a]});
    }
    return result;
  }
  const std::vector<Rational> v = record.numbers();
  if (v.empty() || v.size() % 4 != 0) record.refuse("'" + record.words[0] + "' needs 4 numbers a half-space");
  for (std::size_t i = 0; i < v.size(); i += 4) {
    result.planes.push_back({point(v, i), v[i + 3]});
    if (dot(result.planes.back().normal, result.planes.back().normal) == 0) record.refuse("a normal is no direction");
  }
  return result;
}

Via via(const Record& record) {
  std::vector<std::string> words = record.words;
  Via result{{}, 0, false, {}};
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i] == "stop" && i + 1 == words.size()) {
      result.stop = true;
      words.resize(i);
    } else if (words[i] == "velocity") {
      result.velocity = point(record.numbers(i + 1, 3));
      words.resize(i);
    }
  }
  const std::vector<Rational> v = Record{record.file, record.line, words}.numbers();
  if (v.size() != 3 && v.size() != 4) record.refuse("'via' needs a point, and may have a tolerance");
  result.position = point(v);
  if (v.size() == 4) result.tolerance = v[3];
  return result;
}

/// What the other records say, each given once at most.
class Settings {
 public:
  void add(const Record& record) {
    if (!given_.emplace(record.words[0], record).second) record.refuse("'" + record.words[0] + "' is given twice");
  }

  Rational number(const std::string& key, const Rational& otherwise) const {
    const auto found = given_.find(key);
    return found == given_.end() ? otherwise : found->second.numbers(1, 1)[0];
  }

  Point vector(const std::string& key) const {
    const auto found = given_.find(key);
    return found == given_.end() ? Point{0, 0, 0} : point(found->second.numbers(1, 3));
  }

  /// One number for all axes, or one each.
  Point limit(const std::string& key, const Rational& otherwise) const {
    const auto found = given_.find(key);
    if (found == given_.end()) return {otherwise, otherwise, otherwise};
    const std::vector<Rational> v = found->second.numbers();
    if (v.size() == 1) return {v[0], v[0], v[0]};
    return point(found->second.numbers(1, 3));
  }

  bool says(const std::string& key, const std::string& word) const {
    const auto found = given_.find(key);
    return found != given_.end() && found->second.words.size() == 2 && found->second.words[1] == word;
  }

  bool has(const std::string& key) const { return given_.count(key) != 0; }

 private:
  std::map<std::string, Record> given_;
};

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

/// Upper and lower limits of one derivative; a limit of 0 on the jerk or on a norm is none.
void add_bounds(int derivative, const Point& most, const Point& least, const Rational& horizontal, Problem& problem) {
  for (int a = 0; a < 3; ++a) {
    const auto i = static_cast<std::size_t>(a);
    if (derivative == 3 && !(most[i] > 0)) continue;
    problem.bounds.push_back({derivative, a, 1, most[i]});
    problem.bounds.push_back({derivative, a, -1, least[i] < 0 ? Rational(-least[i]) : most[i]});
  }
  if (horizontal > 0) problem.bounds.push_back({derivative, kHorizontal, 1, horizontal});
}

void apply(const Settings& settings, Problem& problem) {
  problem.start = {settings.vector("start"), settings.vector("start_velocity"), settings.vector("start_acceleration"),
                   settings.vector("start_jerk")};
  problem.goal = {settings.vector("goal"), settings.vector("goal_velocity"), settings.vector("goal_acceleration"),
                  settings.vector("goal_jerk")};
  add_bounds(1, settings.limit("v_max", 2), settings.limit("v_min", 0), settings.number("v_horizontal", 0), problem);
  add_bounds(2, settings.limit("a_max", 2), settings.limit("a_min", 0), settings.number("a_horizontal", 0), problem);
  add_bounds(3, settings.limit("j_max", 0), {0, 0, 0}, settings.number("j_horizontal", 0), problem);
  problem.cell = settings.number("resolution", 0.1);
  // The planner adds doubles; a rounding of the sum is no part of what was asked for.
  problem.clearance = settings.number("radius", 0.25) + settings.number("tracking_margin", 0);
  if (problem.clearance <= decimal(1, 9)) problem.clearance = 0;
  problem.may_end_near = settings.says("goal_mode", "nearest");
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
  const std::string& key = record.words[0];
  if (key == "block" || key == "keepout") {
    std::vector<Rational> v = record.numbers();
    if (v.size() != 6 && !(key == "block" && v.size() == 9)) record.refuse("'" + key + "' needs 6 numbers");
    problem.blocks.push_back(box(record, v));
  } else if (key == "keepin" || key == "keepin_halfspaces" || key == "keepout_halfspaces") {
    problem.fences.push_back(fence(record));
  } else if (key == "via") {
    problem.vias.push_back(via(record));
  } else if (key == "boundary") {
    problem.boundary = box(record, record.numbers(1, 6));
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

Problem parse_problem(const std::string& text, const std::string& name) {
  Problem problem;
  problem.name = name;
  Settings settings;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    const Record record{name, number, {std::istream_iterator<std::string>(words), {}}};
    if (!record.words.empty()) add(record, problem, settings);
  }
  for (const char* const key : {"boundary", "start", "goal"}) {
    if (!settings.has(key)) throw InputError(name + ": there is no '" + key + "'");
  }
  apply(settings, problem);
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
