// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// ASTM F3548: operational intents and constraints, as the interfaces of UTM exchange them. All of their volumes are
// keep-outs: others' flights and restrictions.
#include <string>

#include "host/airspace/formats.hpp"
#include "host/text_records.hpp"

namespace tern_host {
namespace {

void check_word(const JsonNode& of, const char* key, const char* wanted) {
  if (of.at(key).text() != wanted) of.at(key).refuse("this must be '" + std::string(wanted) + "'");
}

ZoneHeight altitude(const JsonNode& node) {
  check_word(node, "units", "M");
  check_word(node, "reference", "W84");
  return {node.at("value").number(), HeightReference::kEllipsoid};
}

Instant time(const JsonNode& node) {
  check_word(node, "format", "RFC3339");
  return node.at("value").instant();
}

GeoPoint corner(const JsonNode& node) {
  const GeoPoint point{node.at("lat").number(), node.at("lng").number()};
  check_point(point, node);
  return point;
}

ZoneArea area_of_volume(const JsonNode& volume) {
  ZoneArea area;
  if (volume.has("outline_polygon") == volume.has("outline_circle")) {
    volume.refuse("a volume needs either an outline_polygon or an outline_circle");
  }
  if (volume.has("outline_circle")) {
    const JsonNode circle = volume.at("outline_circle");
    area.centre = corner(circle.at("center"));
    check_word(circle.at("radius"), "units", "M");
    area.radius = circle.at("radius").at("value").number();
    if (!(area.radius > 0.0)) circle.at("radius").refuse("a radius must be more than 0");
    return area;
  }
  const JsonNode vertices = volume.at("outline_polygon").at("vertices");
  for (const JsonNode& vertex : vertices.items()) area.ring.push_back(corner(vertex));
  if (area.ring.size() < 3) vertices.refuse("an outline needs three corners or more");
  return area;
}

void read_volume(const JsonNode& node, const Zone& like, AirspaceFile& file) {
  Zone zone = like;
  zone.place = node.place();
  const JsonNode volume = node.at("volume");
  zone.areas.push_back(area_of_volume(volume));
  if (volume.has("altitude_lower")) zone.lower = altitude(volume.at("altitude_lower"));
  if (volume.has("altitude_upper")) zone.upper = altitude(volume.at("altitude_upper"));
  Applicability when;
  if (node.has("time_start")) when.from = time(node.at("time_start"));
  if (node.has("time_end")) when.until = time(node.at("time_end"));
  if (when.from && when.until && *when.until < *when.from) node.refuse("time_end is before time_start");
  if (when.from || when.until) zone.times.push_back(when);
  file.zones.push_back(zone);
}

void read_entity(const JsonNode& entity, const char* kind, AirspaceFile& file) {
  Zone zone;
  zone.edges = EdgeRule::kGeodesic;
  const JsonNode details = entity.at("details");
  zone.type = kind;
  if (entity.has("reference")) {
    const JsonNode reference = entity.at("reference");
    zone.name = reference.at("id").text();
    zone.type += reference.has("state") ? ", " + reference.at("state").text() : "";
  } else {
    zone.name = entity.place();
  }
  if (details.has("priority")) zone.type += ", priority " + std::to_string(details.at("priority").whole());
  if (details.has("type")) zone.type += ", " + details.at("type").text();
  const std::size_t before = file.zones.size();
  for (const char* key : {"volumes", "off_nominal_volumes"}) {
    if (!details.has(key)) continue;
    for (const JsonNode& volume : details.at(key).items()) read_volume(volume, zone, file);
  }
  if (file.zones.size() == before) details.refuse("there is no volume in it");
}

}  // namespace

AirspaceFile read_f3548(const JsonNode& document) {
  AirspaceFile file{"F3548", {}, {}, {}};
  const struct {
    const char* one;
    const char* many;
    const char* kind;
  } entities[] = {{"operational_intent", "operational_intents", "intent"}, {"constraint", "constraints", "constraint"}};
  for (const auto& entity : entities) {
    if (document.has(entity.one)) read_entity(document.at(entity.one), entity.kind, file);
    if (!document.has(entity.many)) continue;
    for (const JsonNode& node : document.at(entity.many).items()) read_entity(node, entity.kind, file);
  }
  if (document.has("details")) {
    const bool intent = document.at("details").has("priority") || document.at("details").has("off_nominal_volumes");
    read_entity(document, intent ? "intent" : "constraint", file);
  }
  return file;
}

}  // namespace tern_host
