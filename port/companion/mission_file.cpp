// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "companion/mission_file.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace tern_companion {
namespace {

bool read_number(const std::string& word, double& number) {
  char* end = nullptr;
  number = std::strtod(word.c_str(), &end);
  return !word.empty() && *end == '\0' && std::isfinite(number);
}

bool read_point(std::istream& words, tern::Vec3& point) {
  std::string x, y, z;
  words >> x >> y >> z;
  return read_number(x, point.x) && read_number(y, point.y) && read_number(z, point.z);
}

/// What is wrong with the rest of a via's line; empty if nothing is.
std::string read_rest(std::istream& words, tern::Via& via) {
  std::string word;
  bool first = true;
  for (; words >> word; first = false) {
    double number = 0.0;
    if (word == "stop") {
      via.stop = true;
    } else if (word == "dwell") {
      std::string seconds;
      words >> seconds;
      if (!read_number(seconds, via.dwell) || via.dwell < 0.0) return "dwell needs seconds, 0 or more";
      via.stop = true;
    } else if (first && read_number(word, number) && number >= 0.0) {
      via.tolerance = number;
    } else {
      return "'" + word + "' is not known here; after the point come [TOLERANCE] [stop] [dwell SECONDS]";
    }
  }
  return "";
}

std::string read_line(std::istringstream& words, std::vector<tern::Via>& points, bool& ended) {
  std::string word;
  if (!(words >> word)) return "";
  if (word != "via" && word != "goal") return "'" + word + "' is not known; lines begin with via or goal";
  if (ended) return "the goal is the last line";
  tern::Via via{};
  if (!read_point(words, via.position)) return word + " needs three numbers: EAST NORTH UP, in metres";
  ended = word == "goal";
  points.push_back(via);
  if (!ended) return read_rest(words, points.back());
  return words >> word ? "'" + word + "' is too much after the goal's three numbers" : "";
}

}  // namespace

bool read_point(const std::string& text, tern::Vec3& point) {
  std::string blanks = text;
  for (char& c : blanks) c = c == ',' ? ' ' : c;
  std::istringstream words(blanks);
  std::string more;
  return read_point(words, point) && !(words >> more);
}

std::vector<tern::Via> read_mission(std::istream& file, const std::string& name) {
  std::vector<tern::Via> points;
  std::string line;
  bool ended = false;
  for (int number = 1; std::getline(file, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    const std::string fault = read_line(words, points, ended);
    if (!fault.empty()) throw std::runtime_error(name + ":" + std::to_string(number) + ": " + fault);
  }
  if (!ended) throw std::runtime_error(name + ": no goal; its last line is 'goal EAST NORTH UP'");
  return points;
}

}  // namespace tern_companion
