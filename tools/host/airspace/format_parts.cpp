// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What GeoJSON, ED-269 and ED-318 share: polygons, units, references and schedules.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "host/airspace/formats.hpp"
#include "host/text_records.hpp"

namespace tern_host {
namespace {

std::string upper_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

ZoneArea polygon_area(const JsonNode& rings) {
  ZoneArea area;
  const std::vector<JsonNode> all = rings.items();
  if (all.empty()) rings.refuse("a polygon needs an outline");
  area.ring = ring_of(all[0], &JsonNode::longitude_latitude);
  for (std::size_t i = 1; i < all.size(); ++i) area.holes.push_back(ring_of(all[i], &JsonNode::longitude_latitude));
  return area;
}

const char* const kDays[7] = {"MON", "TUE", "WED", "THU", "FRI", "SAT", "SUN"};

void mark_day(const JsonNode& word, DaySchedule& part) {
  const std::string day = upper_case(word.text());
  bool known = false;
  for (int i = 0; i < 7; ++i) {
    if (day != kDays[i] && day != "ANY") continue;
    part.days[i] = true;
    known = true;
  }
  if (!known) word.refuse(quote(word.text()) + " is no day: MON, TUE, WED, THU, FRI, SAT, SUN or ANY");
}

DayTime day_time(const JsonNode& part, const char* time, const char* event) {
  if (part.has(time)) return {part.at(time).day_time(), ""};
  if (part.has(event)) return {{}, part.at(event).text()};
  part.refuse("'" + std::string(time) + "' or '" + event + "' is missing");
}

}  // namespace

std::vector<ZoneArea> geojson_areas(const JsonNode& geometry) {
  const std::string& type = geometry.at("type").text();
  const JsonNode coordinates = geometry.at("coordinates");
  std::vector<ZoneArea> areas;
  if (type == "Polygon") {
    areas.push_back(polygon_area(coordinates));
  } else {
    for (const JsonNode& rings : coordinates.items()) areas.push_back(polygon_area(rings));
  }
  if (areas.empty()) coordinates.refuse("there is no polygon in it");
  return areas;
}

std::vector<DaySchedule> day_schedule(const JsonNode& schedule) {
  std::vector<DaySchedule> parts;
  for (const JsonNode& entry : schedule.items()) {
    DaySchedule part{{}, day_time(entry, "startTime", "startEvent"), day_time(entry, "endTime", "endEvent")};
    const JsonNode day = entry.at("day");
    if (day.is_text()) {
      mark_day(day, part);
    } else {
      for (const JsonNode& word : day.items()) mark_day(word, part);
    }
    if (std::none_of(part.days, part.days + 7, [](bool on) { return on; })) day.refuse("there is no day in it");
    parts.push_back(part);
  }
  return parts;
}

double metres_of(double value, const JsonNode& unit) {
  const std::string word = upper_case(unit.text());
  if (word == "M") return value;
  if (word == "FT") return value * 0.3048;
  if (word == "KM") return value * 1000.0;
  if (word == "NM") return value * 1852.0;
  unit.refuse(quote(unit.text()) + " is no unit of length that is read: M, KM, FT or NM");
}

HeightReference reference_of(const JsonNode& word) {
  const std::string reference = upper_case(word.text());
  if (reference == "AGL") return HeightReference::kGround;
  if (reference == "AMSL") return HeightReference::kSeaLevel;
  if (reference == "WGS84" || reference == "W84") return HeightReference::kEllipsoid;
  word.refuse(quote(word.text()) + " is no reference of heights that is read: AGL, AMSL or WGS84");
}

}  // namespace tern_host
