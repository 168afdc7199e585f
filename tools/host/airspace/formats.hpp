// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// One reader for each JSON format, from the whole document. All throw RecordError.
#ifndef TERN_HOST_AIRSPACE_FORMATS_HPP
#define TERN_HOST_AIRSPACE_FORMATS_HPP

#include <string>

#include "host/airspace/json_node.hpp"
#include "host/airspace/zone.hpp"

namespace tern_host {

AirspaceFile read_geojson(const JsonNode& document);
AirspaceFile read_ed318(const JsonNode& document);
AirspaceFile read_ed269(const JsonNode& document);
AirspaceFile read_f3548(const JsonNode& document);
AirspaceFile read_qgc_plan(const JsonNode& document);

/// KML, as text.
AirspaceFile read_kml(const std::string& text, const std::string& name);
/// The KML of a KMZ archive: `doc.kml`, or else its first file of that kind.
std::string kml_of_kmz(const std::string& bytes, const std::string& name);

/// A GeoJSON Polygon's or MultiPolygon's areas.
std::vector<ZoneArea> geojson_areas(const JsonNode& geometry);

/// The parts of a day of ED-269 (`day`, `startTime`, `endTime`) and ED-318 (those, `startEvent` and `endEvent`).
std::vector<DaySchedule> day_schedule(const JsonNode& schedule);

/// Metres, for a unit M, KM, FT or NM in any case.
double metres_of(double value, const JsonNode& unit);

/// AGL, AMSL, WGS84 or W84 in any case.
HeightReference reference_of(const JsonNode& word);

}  // namespace tern_host

#endif
