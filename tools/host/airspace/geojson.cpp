// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// GeoJSON (RFC 7946). It has no fences of its own: each polygon is a keep-out without heights and times, unless its
// properties say otherwise (docs/airspace.md).
#include <string>

#include "host/airspace/formats.hpp"
#include "host/text_records.hpp"

namespace tern_host {
namespace {

/// A name that any of the usual properties gives.
std::string name_of(const JsonNode& feature, std::size_t index) {
  if (feature.has("properties")) {
    const JsonNode properties = feature.at("properties");
    for (const char* key : {"name", "Name", "title", "id"}) {
      if (properties.has(key) && properties.at(key).is_text()) return properties.at(key).text();
    }
  }
  if (feature.has("id") && feature.at("id").is_text()) return feature.at("id").text();
  return "feature " + std::to_string(index);
}

void read_kind(const JsonNode& properties, Zone& zone) {
  if (!properties.has("kind")) return;
  const std::string& kind = properties.at("kind").text();
  if (kind != "keep_in" && kind != "keep_out") {
    properties.at("kind").refuse(quote(kind) + " is neither keep_in nor keep_out");
  }
  zone.kind = kind == "keep_in" ? ZoneKind::kKeepIn : ZoneKind::kKeepOut;
}

/// `lower` and `upper` in metres above `reference`, `from` and `until`.
void read_limits(const JsonNode& properties, Zone& zone) {
  const auto height = [&properties](const char* key) {
    return ZoneHeight{properties.at(key).number(), reference_of(properties.at("reference"))};
  };
  if (properties.has("lower")) zone.lower = height("lower");
  if (properties.has("upper")) zone.upper = height("upper");
  Applicability when;
  if (properties.has("from")) when.from = properties.at("from").instant();
  if (properties.has("until")) when.until = properties.at("until").instant();
  if (when.from || when.until) zone.times.push_back(when);
}

class GeojsonReader {
 public:
  void feature(const JsonNode& feature, std::size_t index) {
    if (feature.at("type").text() != "Feature") feature.at("type").refuse("this must be 'Feature'");
    Zone zone;
    zone.name = name_of(feature, index);
    zone.type = "area";
    zone.place = feature.place();
    zone.edges = EdgeRule::kDegrees;
    if (feature.has("properties")) {
      read_kind(feature.at("properties"), zone);
      read_limits(feature.at("properties"), zone);
    }
    if (!feature.has("geometry")) return leave_out(zone, "it has no geometry");
    geometry(feature.at("geometry"), zone, true);
    if (!zone.areas.empty()) file_.zones.push_back(zone);
  }

  void geometry(const JsonNode& geometry, Zone& zone, bool outermost) {
    const std::string& type = geometry.at("type").text();
    if (type == "Polygon" || type == "MultiPolygon") {
      for (ZoneArea& area : geojson_areas(geometry)) zone.areas.push_back(std::move(area));
    } else if (type == "GeometryCollection" && outermost) {
      for (const JsonNode& part : geometry.at("geometries").items()) this->geometry(part, zone, false);
    } else if (type == "GeometryCollection") {
      geometry.refuse("a collection within a collection is not read");
    } else if (type == "Point" || type == "MultiPoint" || type == "LineString" || type == "MultiLineString") {
      leave_out(zone, "a " + type + " has no area");
    } else {
      geometry.at("type").refuse(quote(type) + " is no geometry of GeoJSON");
    }
  }

  AirspaceFile take() { return std::move(file_); }

 private:
  void leave_out(const Zone& zone, const std::string& reason) {
    file_.left_out.push_back(zone.name + ", " + zone.place + ": " + reason);
  }

  AirspaceFile file_{"GeoJSON", {}, {}, {}};
};

}  // namespace

AirspaceFile read_geojson(const JsonNode& document) {
  GeojsonReader reader;
  const std::string& type = document.at("type").text();
  if (type == "FeatureCollection") {
    const std::vector<JsonNode> features = document.at("features").items();
    for (std::size_t i = 0; i < features.size(); ++i) reader.feature(features[i], i);
  } else if (type == "Feature") {
    reader.feature(document, 0);
  } else {
    document.at("type").refuse("this must be 'FeatureCollection' or 'Feature'");
  }
  return reader.take();
}

}  // namespace tern_host
