// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Which format a file is in, by its content.
#include <algorithm>

#include "host/airspace/formats.hpp"
#include "host/text_records.hpp"

namespace tern_host {
namespace {

constexpr const char* kJsonFormats = "GeoJSON, ED-269, ED-318, F3548 or a plan of QGroundControl";

/// By what no other GeoJSON has, so that a misspelt member is refused as one of ED-318: as GeoJSON, circles and
/// heights would not be read.
bool is_geozone(const JsonNode& feature) {
  if (feature.has("geometry") && feature.at("geometry").has("layer")) return true;
  if (!feature.has("properties")) return false;
  const JsonNode properties = feature.at("properties");
  return properties.has("zoneAuthority") || properties.has("limitedApplicability") ||
         (properties.has("identifier") && properties.has("country") && properties.has("type"));
}

/// By what no GeoJSON has, likewise.
bool is_ed269(const JsonNode& feature) {
  if (feature.has("identifier") && feature.has("restriction")) return true;
  const bool is_feature = feature.has("type") && feature.at("type").is_text() && feature.at("type").text() == "Feature";
  return !is_feature && (feature.has("identifier") || feature.has("restriction") || feature.has("applicability"));
}

/// GeoJSON may have any other keys as well.
bool is_geojson(const JsonNode& document) {
  if (!document.has("type") || !document.at("type").is_text()) return false;
  const std::string& type = document.at("type").text();
  return type == "FeatureCollection" || type == "Feature";
}

AirspaceFile read_json(const JsonNode& document) {
  if (!is_geojson(document)) {
    if (document.has("fileType") || document.has("geoFence")) return read_qgc_plan(document);
    for (const char* key : {"operational_intent", "operational_intents", "constraint", "constraints", "details"}) {
      if (document.has(key)) return read_f3548(document);
    }
    if (document.has("UASZoneList")) return read_ed269(document);
  }
  if (document.has("features") && document.at("features").is_array()) {
    const std::vector<JsonNode> features = document.at("features").items();
    if (std::any_of(features.begin(), features.end(), is_ed269)) return read_ed269(document);
    if (std::any_of(features.begin(), features.end(), is_geozone)) return read_ed318(document);
  }
  if (document.has("type")) return read_geojson(document);
  document.refuse("this is none of the JSON formats that are read: " + std::string(kJsonFormats));
}

}  // namespace

AirspaceFile parse_airspace(const std::string& bytes, const std::string& name) {
  if (bytes.compare(0, 2, "PK") == 0) return read_kml(kml_of_kmz(bytes, name), name);
  std::size_t first = bytes.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0;
  first = bytes.find_first_not_of(" \t\r\n", first);
  if (first == std::string::npos) throw RecordError({name, 0}, "the file is empty");
  if (bytes.compare(0, 2, "\xFF\xFE") == 0 || bytes.compare(0, 2, "\xFE\xFF") == 0) {
    throw RecordError({name, 0}, "the file is in UTF-16: save it in UTF-8");
  }
  if (bytes[first] == '<') return read_kml(bytes, name);
  const bool may_be_json = bytes[first] == '{' || bytes[first] == '[';
  const std::string advice = may_be_json ? "" : std::string("What is read is KML, KMZ, and JSON: ") + kJsonFormats;
  const nlohmann::json document = parse_json(bytes, name, advice);
  return read_json(JsonNode(document, name));
}

AirspaceFile read_airspace(const std::string& path) {
  return parse_airspace(read_bytes(path, kMaxTextBytes), path);
}

}  // namespace tern_host
