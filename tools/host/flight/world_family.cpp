// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/flight/world_family.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "host/flight/family_worlds.hpp"
#include "host/flight/moving_worlds.hpp"
#include "host/number.hpp"
#include "host/text_records.hpp"

namespace tern_host {
namespace {

/// How a family is flown.
struct Flown {
  const char* name;
  double speed;               ///< where none is given, m/s
  double range;               ///< of the sensor, m
  double acceleration = 0.0;  ///< limits at any speed, m/s^2
  double jerk = 0.0;          ///< and m/s^3; where the acceleration is 0, both go with the speed
};

constexpr Flown kFamilies[] = {{"P49", 5.0, 10.0},
                               {"P36", 5.0, 10.0},
                               {"P25", 5.0, 10.0},
                               {"P12", 5.0, 10.0},
                               {"S05", 5.0, 10.0, 15.0, 60.0},
                               {"S10", 5.0, 10.0, 15.0, 60.0},
                               {"S20", 5.0, 10.0, 15.0, 60.0},
                               {"C", 6.0, 10.0},
                               {"B", 5.0, 8.0},
                               {"O", 3.0, 8.0},
                               {"M", 3.0, 8.0},
                               {"L", 4.0, 10.0},
                               {"G", 4.0, 10.0},
                               {"I", 3.0, 10.0},
                               {"D", 5.0, 10.0},
                               {"V", 3.0, 10.0},
                               {"F", 5.0, 10.0},
                               {"H", 3.0, 10.0},
                               {"T30", 3.0, 10.0},
                               {"E", 5.0, 10.0},
                               {"R", 5.0, 10.0},
                               {"W", 3.0, 8.0},
                               {"N", 3.0, 8.0},
                               {"Q", 3.0, 8.0},
                               {"X", 3.0, 8.0},
                               {"U", 3.0, 8.0},
                               {"K", 3.0, 10.0},
                               {"T1-50", 3.5, 10.0, 20.0, 0.0},
                               {"T1-100", 3.5, 10.0, 20.0, 0.0},
                               {"T1-150", 3.5, 10.0, 20.0, 0.0},
                               {"T1-200", 3.5, 10.0, 20.0, 0.0},
                               {"T1-250", 3.5, 10.0, 20.0, 0.0},
                               {"T4", 5.0, 10.0, 20.0, 100.0},
                               {"T5-50", 5.0, 10.0, 20.0, 100.0},
                               {"T5-100", 5.0, 10.0, 20.0, 100.0},
                               {"T5-200", 5.0, 10.0, 20.0, 100.0},
                               {"CW", 3.0, 8.0},
                               {"RX", 5.0, 10.0},
                               {"MF", 3.0, 10.0},
                               {"HU", 4.0, 10.0, 8.0, 30.0},
                               {"B50", 3.5, 10.0, 8.0, 0.0},
                               {"B100", 3.5, 10.0, 8.0, 0.0},
                               {"Y", 8.0, 20.0}};

const Flown* find_family(const std::string& name) {
  for (const Flown& family : kFamilies) {
    if (name == family.name) return &family;
  }
  return nullptr;
}

/// Acceleration and jerk that go with a speed.
std::string limits_text(const FamilyMember& member) {
  const double v = member.speed;
  const Flown& family = *find_family(member.family);
  double a = v <= 4.0 ? 6.0 : std::max(8.0, v);
  double j = v <= 5.0 ? 30.0 : (v <= 8.0 ? 40.0 : 60.0);
  if (family.acceleration > 0.0) {
    a = family.acceleration;
    j = family.jerk;
  }
  return "v_max " + brief(v) + "\na_max " + brief(a) + "\nj_max " + brief(j) + "\n";
}

bool parse_whole(const std::string& text, std::uint64_t& value) {
  if (text.empty() || text.size() > 15 || text.find_first_not_of("0123456789") != std::string::npos) return false;
  value = std::strtoull(text.c_str(), nullptr, 10);
  return true;
}

}  // namespace

const std::vector<std::string>& family_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Flown& family : kFamilies) all.push_back(family.name);
    return all;
  }();
  return names;
}

bool parse_family(const std::string& text, FamilyMember& member) {
  const std::size_t at = text.find('@');
  const Flown* const family = find_family(text.substr(0, at));
  if (family == nullptr) return false;
  member.family = family->name;
  member.speed = family->speed;
  if (at == std::string::npos) return true;
  return parse_number(text.substr(at + 1), member.speed) == NumberError::kNone && member.speed > 0.0;
}

bool parse_member(const std::string& text, FamilyMember& member) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos || !parse_whole(text.substr(colon + 1), member.seed)) return false;
  return parse_family(text.substr(0, colon), member);
}

bool is_member(const std::string& path, FamilyMember& member) {
  if (parse_member(path, member)) return true;
  if (std::filesystem::exists(path)) return false;
  const Place place{path, 0};
  if (parse_family(path, member)) throw RecordError(place, "a family's world needs a seed, such as " + path + ":7");
  const std::size_t colon = path.find(':');
  if (find_family(path.substr(0, path.find_first_of("@:"))) != nullptr) {
    throw RecordError(place,
                      "no file; a family's world has a seed of 0 or more and may have a speed above 0: P25:7, P25@8:7");
  }
  if (colon != std::string::npos && parse_whole(path.substr(colon + 1), member.seed)) {
    std::string names;
    for (const std::string& name : family_names()) names += (names.empty() ? "" : ", ") + name;
    throw RecordError(place, "no file, and no family of worlds; these are " + names);
  }
  return false;
}

std::string world_text(const FamilyMember& member) {
  Noise random(member.seed * 1000003 + static_cast<std::uint64_t>(find_family(member.family) - kFamilies));
  const std::string world = is_moving_family(member.family) ? moving_text(member.family, member.seed, random)
                                                            : obstacles_text(member.family, random);
  return "# " + member.family + ", seed " + std::to_string(member.seed) + "\n" + world + limits_text(member) +
         "sensor_range " + brief(find_family(member.family)->range) + "\nseed " + std::to_string(member.seed) + "\n";
}

}  // namespace tern_host
