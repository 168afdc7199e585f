// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/earth_frame.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "host/number.hpp"

namespace tern_host {

bool are_same(const EarthOrigin& a, const EarthOrigin& b) {
  constexpr double kSameDegrees = 1e-9;
  return std::fabs(a.latitude - b.latitude) <= kSameDegrees &&
         std::fabs(std::remainder(a.longitude - b.longitude, 360.0)) <= kSameDegrees;
}

bool are_same_heights(double a, double b) {
  constexpr double kSameHeight = 1e-4;
  return std::fabs(a - b) <= kSameHeight;
}

std::string origin_text(const EarthOrigin& origin) {
  return shortest(origin.latitude) + ", " + shortest(origin.longitude);
}

bool is_earth_record(const std::string& key) {
  return key == "frame" || key == "epoch";
}

void add_earth_record(const Words& words, const Place& place, EarthFrame& frame) {
  const bool is_epoch = words.front() == "epoch";
  if (is_epoch ? !frame.epoch.empty() : frame.origin.has_value()) {
    throw RecordError(place, "'" + words.front() + "' is given twice");
  }
  if (is_epoch) {
    const bool is_read = words.size() == 2 && parse_instant(words[1]).has_value();
    if (!is_read) throw RecordError(place, "'epoch' must be like 2026-03-01T09:30:00Z, with a time zone");
    frame.epoch = words[1];
    return;
  }
  const std::vector<double> v = numbers(words, place);
  if (v.size() != 2 && v.size() != 3) throw_count("frame", "latitude, longitude and maybe a height", v.size(), place);
  if (!(std::fabs(v[0]) <= 90.0)) {
    throw RecordError(place, "the latitude " + brief(v[0]) + " is beyond 90 degrees; it comes before the longitude");
  }
  if (!(std::fabs(v[1]) <= 360.0)) throw RecordError(place, "the longitude " + brief(v[1]) + " is beyond 360 degrees");
  frame.origin = EarthOrigin{v[0], v[1]};
  if (v.size() == 3) frame.height = v[2];
}

nlohmann::ordered_json earth_json(const EarthFrame& frame) {
  nlohmann::ordered_json json;
  if (frame.origin) {
    json["latitude"] = frame.origin->latitude;
    json["longitude"] = frame.origin->longitude;
  }
  if (frame.height) json["height"] = *frame.height;
  if (!frame.epoch.empty()) json["epoch"] = frame.epoch;
  return json;
}

}  // namespace tern_host
