// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// ASTM F3548: operational intents and constraints, as the interfaces of UTM exchange them. All of their volumes are
// keep-outs: others' flights and restrictions.
#include "host/airspace/f3548.hpp"

#include <algorithm>
#include <cctype>
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

Zone read_volume(const JsonNode& node, const Zone& like) {
  Zone zone = like;
  zone.place = node.place();
  const JsonNode volume = node.at("volume");
  zone.areas.push_back(area_of_volume(volume));
  if (volume.has("altitude_lower")) zone.lower = altitude(volume.at("altitude_lower"));
  if (volume.has("altitude_upper")) zone.upper = altitude(volume.at("altitude_upper"));
  if (zone.lower && zone.upper && zone.upper->metres < zone.lower->metres) {
    volume.refuse("altitude_upper is below altitude_lower");
  }
  Applicability when;
  if (node.has("time_start")) when.from = time(node.at("time_start"));
  if (node.has("time_end")) when.until = time(node.at("time_end"));
  if (when.from && when.until && *when.until < *when.from) node.refuse("time_end is before time_start");
  if (when.from || when.until) zone.times.push_back(when);
  return zone;
}

void read_reference(const JsonNode& reference, UtmEntity& entity) {
  entity.id = entity_id(reference.at("id").text());
  if (entity.id.empty()) reference.at("id").refuse("an id must not be empty");
  entity.manager = reference.text_or("manager", "");
  entity.state = reference.text_or("state", "");
  entity.ovn = reference.text_or("ovn", "");
  entity.base_url = reference.text_or("uss_base_url", "");
  if (reference.has("version")) entity.version = reference.at("version").whole();
}

/// An entity's zones say in words what it is.
std::string words_for(const UtmEntity& entity) {
  std::string words = entity.kind == EntityKind::kIntent ? "intent" : "constraint";
  if (!entity.state.empty()) words += ", " + entity.state;
  if (entity.priority != 0) words += ", priority " + std::to_string(entity.priority);
  return words + (entity.type.empty() ? "" : ", " + entity.type);
}

UtmEntity read_entity(const JsonNode& node, EntityKind kind) {
  UtmEntity entity;
  entity.kind = kind;
  entity.id = node.place();
  const JsonNode details = node.at("details");
  if (node.has("reference")) read_reference(node.at("reference"), entity);
  if (details.has("priority")) entity.priority = details.at("priority").whole();
  entity.type = details.text_or("type", "");
  Zone zone;
  zone.edges = EdgeRule::kGeodesic;
  zone.name = entity.id;
  zone.type = words_for(entity);
  for (const char* key : {"volumes", "off_nominal_volumes"}) {
    if (!details.has(key)) continue;
    for (const JsonNode& volume : details.at(key).items()) entity.volumes.push_back(read_volume(volume, zone));
  }
  if (entity.volumes.empty()) details.refuse("there is no volume in it");
  return entity;
}

}  // namespace

std::vector<UtmEntity> read_utm_entities(const JsonNode& document) {
  std::vector<UtmEntity> out;
  const struct {
    const char* one;
    const char* many;
    EntityKind kind;
  } entities[] = {{"operational_intent", "operational_intents", EntityKind::kIntent},
                  {"constraint", "constraints", EntityKind::kConstraint}};
  for (const auto& entity : entities) {
    if (document.has(entity.one)) out.push_back(read_entity(document.at(entity.one), entity.kind));
    if (!document.has(entity.many)) continue;
    for (const JsonNode& node : document.at(entity.many).items()) out.push_back(read_entity(node, entity.kind));
  }
  if (document.has("details")) {
    const bool intent = document.at("details").has("priority") || document.at("details").has("off_nominal_volumes");
    out.push_back(read_entity(document, intent ? EntityKind::kIntent : EntityKind::kConstraint));
  }
  return out;
}

std::string entity_id(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::vector<UtmEntity> read_utm_file(const std::string& path) {
  const nlohmann::json json = parse_json(read_bytes(path, kMaxTextBytes), path,
                                         "Others are operational intents or constraints of ASTM F3548, in JSON");
  const JsonNode document(json, path);
  std::vector<UtmEntity> entities = read_utm_entities(document);
  if (entities.empty() && !document.has("operational_intents") && !document.has("constraints")) {
    document.refuse("no operational_intent, operational_intents, constraint or constraints, and no details of one");
  }
  return entities;
}

TimeSpan span_of(const Zone& volume) {
  TimeSpan span{*parse_instant("1900-01-01T00:00:00Z"), *parse_instant("2200-01-01T00:00:00Z")};
  if (volume.times.empty()) return span;
  return {volume.times[0].from.value_or(span.from), volume.times[0].until.value_or(span.until)};
}

AirspaceFile read_f3548(const JsonNode& document) {
  AirspaceFile file{"F3548", {}, {}, {}};
  for (const UtmEntity& entity : read_utm_entities(document)) {
    file.zones.insert(file.zones.end(), entity.volumes.begin(), entity.volumes.end());
  }
  return file;
}

}  // namespace tern_host
