// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A zone of the air as a file has it, in degrees: what all readers make of their formats.
#ifndef TERN_HOST_AIRSPACE_ZONE_HPP
#define TERN_HOST_AIRSPACE_ZONE_HPP

#include <optional>
#include <string>
#include <vector>

#include "host/airspace/local_frame.hpp"
#include "host/airspace/zone_times.hpp"

namespace tern_host {

enum class ZoneKind { kKeepOut, kKeepIn };

/// What lies between two corners of an outline.
enum class EdgeRule {
  kDegrees,   ///< the line straight in latitude and longitude
  kGeodesic,  ///< the shortest line on the ellipsoid
  kEither,    ///< the format does not say: what is between the two belongs to the zone, or not, on the safe side
};

enum class HeightReference {
  kEllipsoid,  ///< above the WGS84 ellipsoid
  kSeaLevel,   ///< above mean sea level: the geoid
  kGround,     ///< above the ground below
  kHome,       ///< above the place of take-off of a mission
};

/// Metres above a reference.
struct ZoneHeight {
  double metres;
  HeightReference reference;
};

/// A circle, or a polygon with holes. Rings may run either way round, and do not repeat their first corner.
struct ZoneArea {
  std::vector<GeoPoint> ring;
  std::vector<std::vector<GeoPoint>> holes;
  GeoPoint centre{};
  double radius = 0.0;  ///< metres along the ellipsoid; more than 0: a circle, without a ring
};

/// All areas together are the zone, from the lower height to the upper. Without a height, it has no end there.
struct Zone {
  std::string name;
  std::vector<std::string> aliases;  ///< parts of the name that it answers to as well
  std::string type;                  ///< in the words of the format
  std::string place;                 ///< the file, and where in it
  ZoneKind kind = ZoneKind::kKeepOut;
  EdgeRule edges = EdgeRule::kEither;
  std::vector<ZoneArea> areas;
  std::optional<ZoneHeight> lower;
  std::optional<ZoneHeight> upper;
  bool empty_is_all = false;         ///< its format means all heights by a top that is not above the bottom
  bool slants = false;               ///< its top is not level, and `upper` the highest place of it
  std::vector<Applicability> times;  ///< none: always
  std::vector<std::string> notes;    ///< what the reader made of things that a format leaves open
};

/// True if a user who says this means the zone.
bool answers_to(const Zone& zone, const std::string& said);

/// A point of a mission to fly through.
struct ItineraryPoint {
  GeoPoint point;
  ZoneHeight height;
  double tolerance;  ///< metres
  double dwell;      ///< seconds at rest; 0: no stop
};

/// What a file with a mission says beside its zones.
struct Itinerary {
  std::optional<GeoPoint> home;
  double home_height = 0.0;  ///< metres above mean sea level
  std::vector<ItineraryPoint> points;
  std::vector<ItineraryPoint> rally;
};

/// All that a file holds. `left_out` are entries that are no fences, each with its place and the reason.
struct AirspaceFile {
  std::string format;
  std::vector<Zone> zones;
  std::optional<Itinerary> mission;
  std::vector<std::string> left_out;
};

/// Reads a file in any of the formats of docs/airspace.md. Throws RecordError with the place in the file.
AirspaceFile read_airspace(const std::string& path);

/// The same of its bytes; `name` is for messages.
AirspaceFile parse_airspace(const std::string& bytes, const std::string& name);

}  // namespace tern_host

#endif
