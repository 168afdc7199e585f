// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bad files are refused with the place, and zones that cannot be fences with what to do.
#include <gtest/gtest.h>

#include <stdexcept>

#include "airspace/airspace_file.hpp"
#include "host/text_records.hpp"

namespace {

using tern_host::AirspaceSettings;
using tern_test::content;
using tern_test::lake_settings;

void expect_error(const std::string& bytes, const std::string& part) {
  try {
    tern_host::parse_airspace(bytes, "bad.json");
    ADD_FAILURE() << "not refused: " << part;
  } catch (const tern_host::RecordError& error) {
    EXPECT_EQ(error.place().file, "bad.json");
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

/// The file with one text in it replaced.
std::string spoiled(const std::string& name, const std::string& from, const std::string& to) {
  std::string text = content(name);
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(AirspaceErrors, NameTheirPlace) {
  expect_error("", "the file is empty");
  expect_error("\xFF\xFE<", "in UTF-16: save it in UTF-8");
  expect_error("{\"type\": \"FeatureCollection\", \"features\": [",
               "not JSON: the file ends before it is complete (byte 44): it may be cut off");
  expect_error("[1, 2]", "none of the JSON formats");
  expect_error("{\"a\": 1e999}", "not JSON: a number is beyond all ranges");
  expect_error("{\"type\": \"Polygon\"}", "at /type: this must be 'FeatureCollection' or 'Feature'");
  expect_error(
      spoiled("zones.geojson", "[8.550, 47.360]", "[138.5, -138.5]"),
      "at /features/0/geometry/coordinates/0/1: the latitude -138.5 is beyond 90 degrees; is it the longitude?");
  expect_error(spoiled("zones.geojson", "[8.550, 47.360]", "[8.55]"),
               "/features/0/geometry/coordinates/0/1: a position");
  expect_error(spoiled("zones.geojson", "\"AGL\"", "\"FL\""),
               "at /features/0/properties/reference: 'FL' is no reference");
  expect_error(spoiled("zones.geojson", ", \"reference\": \"AGL\"", ""),
               "at /features/0/properties: 'reference' is missing");
  expect_error(spoiled("zones.geojson", "\"keep_in\"", "\"geocage\""), "'geocage' is neither keep_in nor keep_out");
  expect_error(spoiled("zones.geojson", "\"Point\"", "\"Sphere\""),
               "at /features/3/geometry/type: 'Sphere' is no geometry");
  expect_error(spoiled("zones.geojson", "12:00:00Z", "12:00:00"),
               "at /features/1/properties/until: '2026-03-01T12:00:00' is no");
}

/// As a sample of the Swiss CIS has them.
TEST(AirspaceErrors, HeightsInQuotesAreRead) {
  const std::string quoted = spoiled("geozones.ed269.json", "\"upperLimit\": 120", "\"upperLimit\": \"120\"");
  EXPECT_EQ(tern_host::parse_airspace(quoted, "quoted.json").zones[0].upper->metres, 120.0);
}

TEST(AirspaceErrors, OfGeozones) {
  expect_error(spoiled("geozones.ed269.json", "\"upperLimit\": 120", "\"upperLimit\": \"120 m\""),
               "upperLimit: this must be a number");
  expect_error(spoiled("geozones.ed269.json", "\"PROHIBITED\"", "\"FORBIDDEN\""),
               "at /features/1/restriction: 'FORBIDDEN'");
  expect_error(spoiled("geozones.ed269.json", "\"M\", \"lowerLimit\"", "\"yd\", \"lowerLimit\""),
               "uomDimensions: 'yd' is no unit");
  expect_error(spoiled("geozones.ed269.json", "\"radius\": 150", "\"radius\": -1"),
               "horizontalProjection/radius: a radius must be more than 0");
  expect_error(spoiled("geozones.ed269.json", "\"MON\", \"TUE\", \"WED\"", "\"MON\", \"DAY\", \"WED\""),
               "schedule/0/day/1: 'DAY' is no day");
  expect_error(spoiled("geozones.ed269.json", "\"07:00:00.00Z\"", "\"7 am\""),
               "startTime: '7 am' is no time of the day");
  expect_error(spoiled("geozones.ed269.json", "\"permanent\": \"NO\"", "\"permanent\": \"MAYBE\""),
               "permanent: this must be YES or NO");
  expect_error(spoiled("geozones.ed318.json", "\"Circle\"", "\"Ellipse\""), "extent/subType: this must be 'Circle'");
  expect_error(spoiled("geozones.ed318.json", "\"startEvent\": \"SR\", ", ""),
               "'startTime' or 'startEvent' is missing");
  expect_error(spoiled("geozones.ed318.json", "\"uom\": \"m\"", "\"uom\": 1"), "layer/uom: this must be a text");
}

/// With each of all such members misspelt.
std::string misspelt(std::string text, const std::string& member, const std::string& as) {
  for (std::size_t at = text.find(member); at != std::string::npos; at = text.find(member, at + 1)) {
    text.replace(at, member.size(), as);
  }
  return text;
}

TEST(AirspaceErrors, SayWhatIsRead) {
  expect_error(spoiled("geozones.ed269.json", "\"radius\": 150", "\"radius\": null"),
               "horizontalProjection: 'radius' is null: it needs a value");
  for (const char* const text : {"QGC WPL 110\n0\t1\t0\n", "name,latitude\n"}) {
    expect_error(text,
                 "What is read is KML, KMZ, and JSON: GeoJSON, ED-269, ED-318, F3548 or a plan of QGroundControl");
  }
}

TEST(AirspaceErrors, OfMisspeltMembers) {
  const std::string older = content("geozones.ed269.json"), newer = content("geozones.ed318.json");
  expect_error(misspelt(older, "\"identifier\"", "\"identifer\""),
               "at /features/0: 'identifier' is missing; is 'identifer' meant for it?");
  expect_error(misspelt(older, "\"restriction\"", "\"restrictions\""),
               "at /features/0: 'restriction' is missing; is 'restrictions' meant for it?");
  expect_error(misspelt(older, "\"horizontalProjection\"", "\"horizontalProyection\""),
               "at /features/0/geometry/0: 'horizontalProjection' is missing; is 'horizontalProyection' meant for it?");
  expect_error(misspelt(newer, "\"identifier\"", "\"identifer\""),
               "at /features/0/properties: 'identifier' is missing; is 'identifer' meant for it?");
  expect_error(misspelt(newer, "\"type\": \"REQ", "\"typ\": \"REQ"),
               "at /features/0/properties: 'type' is missing; is 'typ' meant for it?");
  expect_error(misspelt(older, "\"identifier\"", "\"id\""), "at /features/0: 'identifier' is missing");
  EXPECT_EQ(tern_host::parse_airspace(spoiled("geozones.ed318.json", "\"country\"", "\"county\""), "a").zones[0].name,
            "NFZ1 Station")
      << "a country is not needed";
  EXPECT_EQ(tern_host::parse_airspace(content("zones.geojson"), "a").format, "GeoJSON");
}

TEST(AirspaceErrors, OfVolumes) {
  expect_error(spoiled("volumes.f3548.json", "\"W84\"", "\"SFC\""), "altitude_lower/reference: this must be 'W84'");
  expect_error(spoiled("volumes.f3548.json", "\"units\": \"M\"", "\"units\": \"FT\""),
               "altitude_lower/units: this must be 'M'");
  expect_error(spoiled("volumes.f3548.json", "09:12:30.250Z", "08:12:30.250Z"),
               "volumes/0: time_end is before time_start");
  expect_error(spoiled("volumes.f3548.json", "outline_polygon", "outline"), "volumes/0/volume: a volume needs either");
  expect_error("{\"constraint\": {\"details\": {\"volumes\": []}}}",
               "at /constraint/details: there is no volume in it");
}

TEST(AirspaceErrors, OfEntities) {
  expect_error(spoiled("volumes.f3548.json", "\"altitude_upper\": {\"value\": ", "\"altitude_upper\": {\"value\": -9"),
               "altitude_upper is below altitude_lower");
}

TEST(AirspaceErrors, OfPlans) {
  expect_error(spoiled("mission.plan", "\"command\": 19", "\"command\": 17"),
               "at /mission/items/4/command: the command 17 is not read");
  expect_error(spoiled("mission.plan", "\"frame\": 3", "\"frame\": 8"),
               "at /mission/items/0/frame: the frame is none of");
  expect_error(spoiled("mission.plan", "\"firmwareType\": 12", "\"firmwareType\": 0"),
               "at /geoFence: there are several inclusions");
  expect_error(spoiled("mission.plan", "TransectStyleComplexItem\": {", "Structure\": {"),
               "at /mission/items/3: only SimpleItem is read");
  expect_error(spoiled("mission.plan", "\"inclusion\": false", "\"inclusion\": 0"),
               "inclusion: this must be true or false");
  expect_error(spoiled("mission.plan", "[12.5, 2, 0, null", "[12.5, 2, 0"), "params: a command has seven parameters");
}

TEST(AirspaceErrors, OfOtherVersionsOfPlans) {
  expect_error(spoiled("mission.plan", "\"version\": 1", "\"version\": 2"), "at /version: the version 2 of the format");
  expect_error(spoiled("mission.plan", "\"version\": 2", "\"version\": 1"),
               "at /mission/version: the version 1 of the format");
}

TEST(AirspaceErrors, OfKml) {
  expect_error("<kml><Placemark>", "bad.json:1: not XML");
  expect_error("<gpx></gpx>", "bad.json:1: the outermost element must be 'kml'");
  expect_error(spoiled("zones.kml", "8.554,47.352,100", "8.554, 47.352,100"),
               "bad.json:12: in 'coordinates': '8.554,' is no longitude");
  expect_error(spoiled("zones.kml", "8.554,47.352,100", "8.554,47.x,100"), "in 'coordinates': '47.x' is no number");
  expect_error(spoiled("zones.kml", "8.554,47.352,100", "47.352,98.554"), "the latitude 98.554 is beyond 90");
  expect_error(spoiled("zones.kml", "2026-03-02</begin>", "March</begin>"),
               "bad.json:8: in 'begin': 'March' is neither");
  expect_error(spoiled("zones.kml", "<innerBoundaryIs>", "<outerBoundaryIs>"), "not XML");
  std::string twice = spoiled("zones.kml", "<innerBoundaryIs>", "<outerBoundaryIs>");
  twice.replace(twice.find("</innerBoundaryIs>"), 18, "</outerBoundaryIs>");
  expect_error(twice, "bad.json:16: in 'outerBoundaryIs': a Polygon has one outerBoundaryIs");
  expect_error("PK\x03\x04", "not a KMZ archive");
  expect_error(content("zones.kmz").substr(0, 300), "not a KMZ archive");
}

TEST(AirspaceErrors, OfZonesSayWhatToDo) {
  const auto expect = [](const std::string& name, AirspaceSettings settings, const std::string& part) {
    try {
      tern_host::make_airspace({tern_host::parse_airspace(content(name), name)}, settings);
      ADD_FAILURE() << "not refused: " << part;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  AirspaceSettings settings = lake_settings();
  settings.epoch.reset();
  expect("volumes.f3548.json", settings, "/operational_intents/0/details/volumes/0: it has times: give --epoch");
  settings = lake_settings();
  settings.events.erase("SS");
  expect("geozones.ed318.json", settings, "nothing says when 'SS' is: give --event SS=HH:MMZ");
  settings = lake_settings();
  settings.heights.ground.reset();
  expect("zones.geojson", settings, "Lake, zones.geojson at /features/0: heights above the ground need the ground");
  settings.origin.reset();
  expect("zones.geojson", settings, "give --origin");
  settings = lake_settings();
  settings.leave_out = {"Lak"};
  expect("zones.geojson", settings, "no zone is named 'Lak': there are 'Lake', 'market'");
}

}  // namespace
