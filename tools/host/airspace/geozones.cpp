// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// EUROCAE ED-269 and ED-318: geographical zones for unmanned aircraft. A restriction that only an authority or a
// condition lifts is a keep-out; who has leave to fly there leaves the zone out by name.
#include <cctype>
#include <string>

#include "host/airspace/formats.hpp"
#include "host/text_records.hpp"

namespace tern_host {
namespace {

/// ED-318 has this for "no limit"; files of ED-269 use it, too.
constexpr double kUnlimited = 99999.0;

enum class Restriction { kKeepOut, kNone };

Restriction restriction_of(const JsonNode& word) {
  const std::string& text = word.text();
  // ED-269 and ED-318 spell an authorisation differently.
  for (const char* known : {"PROHIBITED", "REQ_AUTHORISATION", "REQ_AUTHORIZATION", "CONDITIONAL"}) {
    if (text == known) return Restriction::kKeepOut;
  }
  for (const char* known : {"NO_RESTRICTION", "USPACE"}) {
    if (text == known) return Restriction::kNone;
  }
  word.refuse(quote(text) + " is no restriction that is read");
}

/// Heights from two members and their references, in one unit.
void read_heights(const JsonNode& layer, const char* lower, const char* lower_reference, const char* upper,
                  const char* upper_reference, const char* unit, Zone& zone) {
  const auto height = [&](const char* key, const char* reference) {
    return ZoneHeight{metres_of(layer.at(key).number_or_text(), layer.at(unit)), reference_of(layer.at(reference))};
  };
  if (layer.has(lower)) zone.lower = height(lower, lower_reference);
  if (layer.has(upper) && layer.at(upper).number_or_text() < kUnlimited) zone.upper = height(upper, upper_reference);
  zone.empty_is_all = true;
  const bool empty = zone.lower && zone.upper && zone.lower->reference == zone.upper->reference &&
                     zone.upper->metres <= zone.lower->metres;
  if (!empty) return;
  // Authorities write 0 for both where nothing may fly at all.
  zone.notes.push_back("its upper height is not above its lower: taken for all heights");
  zone.lower.reset();
  zone.upper.reset();
}

Applicability dates(const JsonNode& period) {
  Applicability when;
  if (!period.text_or("startDateTime", "").empty()) when.from = period.at("startDateTime").instant();
  if (!period.text_or("endDateTime", "").empty()) when.until = period.at("endDateTime").instant();
  for (const char* key : {"schedule", "dailyPeriod"}) {
    if (period.has(key)) when.schedule = day_schedule(period.at(key));
  }
  return when;
}

/// A text, or the first of texts in several languages.
std::string own_name(const JsonNode& zone) {
  if (!zone.has("name")) return "";
  const JsonNode name = zone.at("name");
  if (name.is_text()) return name.text();
  const bool translated = name.is_array() && name.size() > 0 && name.at(std::size_t{0}).has("text");
  return translated ? name.at(std::size_t{0}).at("text").text() : "";
}

/// "CHE LS001 Heliport": country, identifier and name, each as far as there is one.
void read_name(const JsonNode& node, Zone& zone) {
  const std::string country = node.text_or("country", ""), identifier = node.at("identifier").text();
  const std::string whole = country.empty() ? identifier : country + " " + identifier, name = own_name(node);
  zone.name = name.empty() ? whole : whole + " " + name;
  zone.aliases = {identifier, whole};
  if (!name.empty()) zone.aliases.push_back(name);
}

/// A period that says nothing is for good: on the safe side.
void add_times(const JsonNode& period, Zone& zone, bool& always) {
  const Applicability when = dates(period);
  if (when.from || when.until || !when.schedule.empty()) return zone.times.push_back(when);
  zone.notes.push_back("it says no times when it applies: taken for always");
  always = true;
}

void read_ed269_times(const JsonNode& period, Zone& zone, bool& always) {
  const std::string permanent = period.text_or("permanent", "NO");
  if (permanent != "YES" && permanent != "NO") period.at("permanent").refuse("this must be YES or NO");
  if (permanent == "NO") return add_times(period, zone, always);
  if (period.has("schedule") && period.at("schedule").size() > 0) {
    zone.notes.push_back("it is permanent and has a schedule: taken for permanent");
  }
  always = true;
}

ZoneArea ed269_area(const JsonNode& projection) {
  const std::string& type = projection.at("type").text();
  if (type == "Polygon") return geojson_areas(projection).front();
  if (type != "Circle") projection.at("type").refuse(quote(type) + " is neither Polygon nor Circle");
  ZoneArea area;
  area.centre = projection.at("center").longitude_latitude();
  area.radius = projection.at("radius").number();
  if (!(area.radius > 0.0)) projection.at("radius").refuse("a radius must be more than 0");
  return area;
}

void read_ed269_feature(const JsonNode& feature, AirspaceFile& file) {
  Zone zone;
  read_name(feature, zone);
  zone.type = feature.at("restriction").text();
  zone.place = feature.place();
  if (restriction_of(feature.at("restriction")) == Restriction::kNone) {
    file.left_out.push_back(zone.name + ", " + zone.place + ": " + zone.type + " restricts nothing");
    return;
  }
  bool always = !feature.has("applicability");
  if (!always) {
    const JsonNode applicability = feature.at("applicability");
    // Some files have one period without an array around it.
    if (applicability.is_array()) {
      for (const JsonNode& period : applicability.items()) read_ed269_times(period, zone, always);
    } else {
      read_ed269_times(applicability, zone, always);
    }
  }
  if (always) zone.times.clear();
  for (const JsonNode& volume : feature.at("geometry").items()) {
    Zone part = zone;
    part.place = volume.place();
    read_heights(volume, "lowerLimit", "lowerVerticalReference", "upperLimit", "upperVerticalReference",
                 "uomDimensions", part);
    part.areas.push_back(ed269_area(volume.at("horizontalProjection")));
    if (part.areas[0].radius > 0.0) part.areas[0].radius = metres_of(part.areas[0].radius, volume.at("uomDimensions"));
    file.zones.push_back(part);
  }
}

void read_ed318_geometry(const JsonNode& geometry, const Zone& zone, AirspaceFile& file) {
  const std::string& type = geometry.at("type").text();
  Zone part = zone;
  part.place = geometry.place();
  if (geometry.has("layer")) {
    read_heights(geometry.at("layer"), "lower", "lowerReference", "upper", "upperReference", "uom", part);
  }
  if (type == "Polygon" || type == "MultiPolygon") {
    part.areas = geojson_areas(geometry);
  } else if (type == "Point") {
    const JsonNode extent = geometry.at("extent");
    const std::string& shape = extent.at("subType").text();
    if (shape != "Circle" && shape != "Circles") extent.at("subType").refuse("this must be 'Circle'");
    ZoneArea area;
    area.centre = geometry.at("coordinates").longitude_latitude();
    area.radius = extent.at("radius").number();
    if (!(area.radius > 0.0)) extent.at("radius").refuse("a radius must be more than 0");
    part.areas.push_back(area);
  } else {
    geometry.at("type").refuse(quote(type) + " bounds no zone: Polygon, MultiPolygon, or Point with an extent");
  }
  file.zones.push_back(part);
}

void read_ed318_feature(const JsonNode& feature, AirspaceFile& file) {
  const JsonNode properties = feature.at("properties");
  Zone zone;
  zone.edges = EdgeRule::kDegrees;
  read_name(properties, zone);
  zone.type = properties.at("type").text();
  zone.place = feature.place();
  if (restriction_of(properties.at("type")) == Restriction::kNone) {
    file.left_out.push_back(zone.name + ", " + zone.place + ": " + zone.type + " restricts nothing by itself");
    return;
  }
  if (properties.has("limitedApplicability")) {
    bool always = false;
    for (const JsonNode& period : properties.at("limitedApplicability").items()) add_times(period, zone, always);
    if (always) zone.times.clear();
  }
  const JsonNode geometry = feature.at("geometry");
  if (geometry.at("type").text() != "GeometryCollection") return read_ed318_geometry(geometry, zone, file);
  for (const JsonNode& part : geometry.at("geometries").items()) read_ed318_geometry(part, zone, file);
}

}  // namespace

AirspaceFile read_ed269(const JsonNode& document) {
  AirspaceFile file{"ED-269", {}, {}, {}};
  // An earlier form of the format has other names for two members.
  const char* const list = document.has("UASZoneList") ? "UASZoneList" : "features";
  for (const JsonNode& feature : document.at(list).items()) read_ed269_feature(feature, file);
  return file;
}

AirspaceFile read_ed318(const JsonNode& document) {
  AirspaceFile file{"ED-318", {}, {}, {}};
  for (const JsonNode& feature : document.at("features").items()) read_ed318_feature(feature, file);
  return file;
}

}  // namespace tern_host
