// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// How far zones are that have no fence, and which are elsewhere because latitude and longitude are swapped.
#include "host/airspace/zone_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "airspace/airspace_file.hpp"

namespace {

using tern_host::LocalFrame;
using tern_host::Zone;
using tern_host::ZoneArea;
using tern_test::lake_settings;

Zone zone_of(std::vector<tern_host::GeoPoint> ring) {
  Zone zone;
  zone.areas.emplace_back();
  zone.areas[0].ring = std::move(ring);
  return zone;
}

TEST(ZoneDistance, IsThatOfTheNearestPoint) {
  // At the equator, a degree of longitude is 6378137 m times pi / 180, which is 111319.491 m.
  const LocalFrame frame({{0.0, 20.0}, 0.0});
  const Zone strip = zone_of({{-1.0, 21.0}, {1.0, 21.0}, {1.0, 22.0}, {-1.0, 22.0}});
  EXPECT_NEAR(zone_distance(strip, frame).is, 111319.491, 20.0) << "the middle of an edge, not a corner";
  Zone circle;
  circle.areas.emplace_back();
  circle.areas[0].centre = {0.0, 21.0};
  circle.areas[0].radius = 11319.491;
  EXPECT_NEAR(zone_distance(circle, frame).is, 100000.0, 0.01);
  EXPECT_EQ(distance_text(zone_distance(circle, frame)), "100 km from the origin");
}

TEST(ZoneDistance, SeesThatLatitudeAndLongitudeAreSwapped) {
  const LocalFrame frame({{47.366, 8.54}, 0.0});
  const Zone swapped = zone_of({{8.54, 47.367}, {8.541, 47.368}, {8.542, 47.367}});
  EXPECT_TRUE(zone_distance(swapped, frame).is_swapped());
  EXPECT_NE(distance_text(zone_distance(swapped, frame)).find(" km from the origin, and 111 m with latitude and"),
            std::string::npos)
      << distance_text(zone_distance(swapped, frame));
  const Zone elsewhere = zone_of({{46.2, 6.1}, {46.2, 6.2}, {46.3, 6.1}});
  EXPECT_FALSE(zone_distance(elsewhere, frame).is_swapped());
  // A longitude beyond 90 degrees is no latitude.
  EXPECT_FALSE(zone_distance(zone_of({{8.0, 147.0}, {8.0, 147.1}, {8.1, 147.0}}), frame).is_swapped());
  // Where both are alike, nothing is said.
  const LocalFrame diagonal({{10.0, 10.3}, 0.0});
  EXPECT_FALSE(zone_distance(zone_of({{10.3, 10.0}, {10.3, 10.1}, {10.2, 10.0}}), diagonal).is_swapped());
}

std::string feature(const std::string& properties, const std::string& ring) {
  return R"({"type": "Feature", "properties": {)" + properties +
         R"(}, "geometry": {"type": "Polygon", "coordinates": [[)" + ring + "]]}}";
}

TEST(ZoneDistance, IsSaidOfZonesWithoutFences) {
  tern_host::AirspaceSettings settings = lake_settings();
  std::vector<std::string> notes;
  settings.note = [&notes](const std::string& note) { notes.push_back(note); };
  const auto why = [&settings](const std::string& text) {
    return tern_host::make_airspace({tern_host::parse_airspace(text, "z.json")}, settings).entries[0].left_out;
  };
  EXPECT_EQ(why(feature("", "[8.8, 47.366], [8.9, 47.366], [8.9, 47.4]")),
            "not at the boundary: 20 km from the origin");
  EXPECT_EQ(why(feature(R"("lower": 800, "reference": "WGS84")", "[8.53, 47.36], [8.55, 47.36], [8.55, 47.37]")),
            "at the boundary, but at other heights");
  EXPECT_TRUE(notes.empty());
  EXPECT_NE(why(feature(R"("name": "Lake")", "[47.36, 8.53], [47.36, 8.55], [47.37, 8.55]")).find("swapped"),
            std::string::npos);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].rfind("warning: Lake, z.json at /, is ", 0), 0u) << notes[0];
  EXPECT_NE(notes[0].find("does its file, or --origin, have them the wrong way round?"), std::string::npos);
}

TEST(ZoneDistance, IsSaidOfKeepInsThatAreNowhereNear) {
  const std::string text = feature(R"("kind": "keep_in")", "[47.36, 8.53], [47.36, 8.55], [47.37, 8.55]");
  try {
    tern_host::make_airspace({tern_host::parse_airspace(text, "z.json")}, lake_settings());
    ADD_FAILURE() << "not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("leaves no room; it is "), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("with latitude and longitude swapped"), std::string::npos) << error.what();
  }
}

}  // namespace
