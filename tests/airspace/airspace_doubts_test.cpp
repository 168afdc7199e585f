// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What is most likely a mistake: `tern airspace` warns of it.
#include <gtest/gtest.h>

#include "airspace/airspace_file.hpp"

namespace {

using tern_host::HeightReference;
using tern_host::ZoneHeight;
using tern_test::lake_settings;

struct Doubts {
  tern_host::Airspace airspace;
  std::vector<std::string> notes;
};

Doubts doubts_of(const tern_host::AirspaceFile& file, tern_host::AirspaceSettings settings) {
  Doubts doubts;
  settings.note = [&doubts](const std::string& note) { doubts.notes.push_back(note); };
  doubts.airspace = tern_host::make_airspace({file}, settings);
  return doubts;
}

/// A zone over the origin of lake_settings(), where the ground is 400 to 420 m above mean sea level.
tern_host::AirspaceFile low_zone(std::optional<ZoneHeight> lower, ZoneHeight upper) {
  tern_host::AirspaceFile file;
  tern_host::Zone zone;
  zone.name = "Low";
  zone.place = "z.json at /";
  zone.lower = lower;
  zone.upper = upper;
  zone.areas.emplace_back();
  zone.areas[0].ring = {{47.36, 8.53}, {47.36, 8.55}, {47.37, 8.55}, {47.37, 8.53}};
  file.zones = {zone};
  return file;
}

TEST(AirspaceDoubts, AZoneEndsBelowTheGround) {
  const ZoneHeight ground{0.0, HeightReference::kGround};
  const auto low = doubts_of(low_zone(ground, {120.0, HeightReference::kSeaLevel}), lake_settings());
  ASSERT_EQ(low.notes.size(), 1u);
  EXPECT_EQ(low.notes[0],
            "warning: Low, z.json at /: its top, 120 AMSL, is not above the ground, 400.0 to 420.0 AMSL or 447.3 to "
            "467.3 WGS84: are its heights right?");
  EXPECT_EQ(low.airspace.fence_count(), 0);
  // 447 m above the ellipsoid are 399.7 m above mean sea level.
  EXPECT_EQ(doubts_of(low_zone({}, {447.0, HeightReference::kEllipsoid}), lake_settings()).notes.size(), 1u);
  EXPECT_TRUE(doubts_of(low_zone({}, {448.0, HeightReference::kEllipsoid}), lake_settings()).notes.empty());
  EXPECT_TRUE(doubts_of(low_zone(ground, {400.1, HeightReference::kSeaLevel}), lake_settings()).notes.empty());
  EXPECT_TRUE(doubts_of(low_zone(ground, {1.0, HeightReference::kGround}), lake_settings()).notes.empty());

  tern_host::AirspaceSettings settings = lake_settings();
  settings.heights.ground.reset();
  EXPECT_TRUE(doubts_of(low_zone(ground, {120.0, HeightReference::kSeaLevel}), settings).notes.empty())
      << "the ground is not known";
  settings = lake_settings();
  settings.fit.boundary = {{1500.0, 1500.0, -30.0}, {2000.0, 2000.0, 120.0}};
  EXPECT_TRUE(doubts_of(low_zone(ground, {120.0, HeightReference::kSeaLevel}), settings).notes.empty())
      << "the zone is elsewhere";
}

TEST(AirspaceDoubts, AnEmptyGeozoneIsTakenForAllHeights) {
  const tern_host::AirspaceSettings settings = lake_settings();
  for (const char* const name : {"geozones.ed269.json", "geozones.ed318.json"}) {
    EXPECT_TRUE(tern_host::parse_airspace(tern_test::content(name), name).zones[0].empty_is_all) << name;
  }
  tern_host::AirspaceFile file =
      low_zone(ZoneHeight{0.0, HeightReference::kGround}, {120.0, HeightReference::kSeaLevel});
  file.zones[0].empty_is_all = true;
  const Doubts doubts = doubts_of(file, settings);
  ASSERT_EQ(doubts.notes.size(), 1u);
  EXPECT_NE(doubts.notes[0].find("WGS84: taken for all heights"), std::string::npos) << doubts.notes[0];
  EXPECT_EQ(doubts.airspace.fence_count(), 1);
  const std::string table = airspace_table(doubts.airspace);
  EXPECT_NE(table.find("its top is not above the ground: taken for all heights"), std::string::npos) << table;
}

TEST(AirspaceDoubts, TheGroundDoesNotHoldTheOrigin) {
  const auto none = low_zone({}, {600.0, HeightReference::kEllipsoid});
  tern_host::AirspaceSettings settings = lake_settings();
  EXPECT_TRUE(doubts_of(none, settings).notes.empty());
  settings.heights.ground = tern_host::HeightRange{105.0, 125.0};
  const Doubts doubts = doubts_of(none, settings);
  ASSERT_EQ(doubts.notes.size(), 1u);
  EXPECT_EQ(doubts.notes[0],
            "warning: the origin is 407.7 m above mean sea level, but the ground from 105 to 125 m: are --ground and "
            "the origin's height right?");
}

TEST(AirspaceDoubts, HomeIsAtAnotherHeightThanTheOrigin) {
  const auto mission = tern_host::parse_airspace(tern_test::content("mission.plan"), "mission.plan");
  tern_host::AirspaceSettings settings = lake_settings();
  settings.heights.ground.reset();
  EXPECT_TRUE(doubts_of(mission, settings).notes.empty()) << "408 m and 407.7 m";
  settings.heights.undulation = 0.0;
  const Doubts doubts = doubts_of(mission, settings);
  ASSERT_GE(doubts.notes.size(), 1u);
  EXPECT_EQ(doubts.notes[0],
            "warning: the mission's home is 408.0 m above mean sea level, but the origin, at the same place, 455.0 m: "
            "are the origin's height and the geoid or undulation right?");
  settings.origin = tern_host::GeoPoint{47.367, 8.54};
  const Doubts away = doubts_of(mission, settings);
  for (const std::string& note : away.notes) EXPECT_EQ(note.find("home"), std::string::npos) << note;
}

TEST(AirspaceDoubts, PointsOfAMissionAreElsewhere) {
  auto mission = tern_host::parse_airspace(tern_test::content("mission.plan"), "mission.plan");
  tern_host::AirspaceSettings settings = lake_settings();
  settings.fit.boundary = {{-500.0, -500.0, 0.0}, {500.0, 500.0, 45.5}};
  const Doubts high = doubts_of(mission, settings);
  ASSERT_EQ(high.notes.size(), 1u) << "two points are 50 m high";
  EXPECT_EQ(high.notes[0].rfind("warning: point 2 of the mission, at 226.", 0), 0u) << high.notes[0];
  EXPECT_NE(high.notes[0].find(", 50.3, is outside the boundary (the first of 2)"), std::string::npos) << high.notes[0];

  for (auto* points : {&mission.mission->points, &mission.mission->rally}) {
    for (tern_host::ItineraryPoint& p : *points) std::swap(p.point.latitude, p.point.longitude);
  }
  const Doubts swapped = doubts_of(mission, lake_settings());
  ASSERT_EQ(swapped.notes.size(), 2u);
  EXPECT_EQ(swapped.notes[0].rfind("warning: point 1 of the mission is ", 0), 0u) << swapped.notes[0];
  EXPECT_NE(swapped.notes[0].find("with latitude and longitude swapped"), std::string::npos) << swapped.notes[0];
  mission.mission->points.clear();
  const Doubts rally = doubts_of(mission, lake_settings());
  ASSERT_EQ(rally.notes.size(), 1u);
  EXPECT_EQ(rally.notes[0].rfind("warning: rally point 1 of the mission is ", 0), 0u) << rally.notes[0];
}

}  // namespace
