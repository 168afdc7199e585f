// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Files of each format: what becomes of good ones, kept beside them; that bad ones are refused with their place; and
// that spoiled ones are read or refused, but never worse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "airspace/airspace_file.hpp"
#include "host/scenario.hpp"
#include "host/text_records.hpp"
#include "support/random.hpp"

namespace {

using tern_host::Airspace;
using tern_host::AirspaceFile;
using tern_host::AirspaceSettings;
using tern_test::content;
using tern_test::lake_settings;
using tern_test::Random;

const char* const kFiles[] = {"geozones.ed269.json", "geozones.ed318.json", "mission.plan", "volumes.f3548.json",
                              "zones.geojson",       "zones.kml",           "zones.kmz"};

/// Words are equal, or numbers that differ by no more than a micrometre: libraries may round the last digits.
void expect_like(const std::string& text, const std::string& kept) {
  std::istringstream words(text), wanted(kept);
  std::string word, other;
  while (wanted >> other) {
    ASSERT_TRUE(static_cast<bool>(words >> word)) << "ends before " << other;
    if (word == other) continue;
    char* end = nullptr;
    const double a = std::strtod(word.c_str(), &end);
    ASSERT_EQ(*end, '\0') << word << " instead of " << other;
    ASSERT_NEAR(a, std::strtod(other.c_str(), &end), 1e-6);
    ASSERT_EQ(*end, '\0') << word << " instead of " << other;
  }
  ASSERT_FALSE(static_cast<bool>(words >> word)) << "goes on with " << word;
}

class AirspaceFiles : public ::testing::TestWithParam<const char*> {};

TEST_P(AirspaceFiles, AreReadAsKept) {
  const std::string name = GetParam();
  const Airspace airspace = tern_host::make_airspace({tern_host::parse_airspace(content(name), name)}, lake_settings());
  const std::string text = tern_host::airspace_table(airspace) + tern_host::fences_text(airspace);
  const std::string kept = content("kept/" + name + ".txt");
  expect_like(text, kept);
  if (HasFatalFailure()) {
    std::ofstream(name + ".txt") << text;
    FAIL() << "what it is now stands in " << std::filesystem::current_path() / (name + ".txt");
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, AirspaceFiles, ::testing::ValuesIn(kFiles), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

TEST(Airspace, SaysWhatBecomesOfAHoldAtTheFirstPoint) {
  std::string plan = content("mission.plan");
  const std::string takeoff = "\"command\": 22, \"frame\": 3, \"autoContinue\": true, \"doJumpId\": 1, \"params\": [0,";
  const std::string hold = "\"command\": 16, \"frame\": 3, \"autoContinue\": true, \"doJumpId\": 1, \"params\": [5,";
  ASSERT_NE(plan.find(takeoff), std::string::npos);
  plan.replace(plan.find(takeoff), takeoff.size(), hold);
  const Airspace airspace = tern_host::make_airspace({tern_host::parse_airspace(plan, "a")}, lake_settings());
  EXPECT_NE(fences_text(airspace).find("\n# held for 5 s before: begin that much later (start_time)\nvia"),
            std::string::npos);
  EXPECT_NE(airspace_table(airspace).find(", 5 s before the plan begins\n"), std::string::npos);
}

TEST(Airspace, ZonesThatSayNoTimesHoldAlways) {
  const auto first = [](const std::string& applicability) {
    std::string text = content("geozones.ed269.json");
    const std::string permanent = "[{\"permanent\": \"YES\"}]";
    text.replace(text.find(permanent), permanent.size(), applicability);
    return tern_host::parse_airspace(text, "a").zones[0];
  };
  const std::string said = "it says no times when it applies: taken for always";
  for (const char* none : {"[{\"permanent\": \"NO\"}]", "[{\"permanent\": \"NO\", \"schedule\": []}]", "[{}]"}) {
    EXPECT_TRUE(first(none).times.empty()) << none;
    EXPECT_EQ(first(none).notes, std::vector<std::string>{said}) << none;
  }
  const std::string dated = "{\"permanent\": \"NO\", \"startDateTime\": \"2026-01-05T00:00:00Z\"}";
  EXPECT_EQ(first("[" + dated + "]").times.size(), 1u);
  EXPECT_TRUE(first("[" + dated + ", {\"permanent\": \"NO\"}]").times.empty()) << "one period of all is always";
}

TEST(Airspace, WritesRecordsOfAScenario) {
  AirspaceSettings settings = lake_settings();
  settings.epoch = tern_host::parse_instant("2026-03-01T08:00:00Z");
  const Airspace airspace =
      tern_host::make_airspace({tern_host::parse_airspace(content("zones.geojson"), "a")}, settings);
  const tern_host::Scenario scenario = tern_host::parse_scenario(
      tern_host::fences_text(airspace) + "start -900 -900 50\ngoal 900 -500 50\n", "lake.txt");
  ASSERT_EQ(static_cast<int>(scenario.fences.size()), airspace.fence_count());
  std::size_t next = 0;
  for (const tern_host::AirspaceEntry& entry : airspace.entries) {
    for (const tern_host::FittedFence& fence : entry.fit.fences) {
      const tern_host::FenceRecord& record = scenario.fences[next++];
      EXPECT_EQ(record.fence.kind, fence.kind);
      EXPECT_EQ(tern::is_timed(record.fence), !entry.spans.empty());
      ASSERT_EQ(record.planes.size(), fence.planes.size());
      for (std::size_t i = 0; i < fence.planes.size(); ++i) {
        EXPECT_EQ(record.planes[i].normal.x, fence.planes[i].normal.x);
        EXPECT_EQ(record.planes[i].normal.y, fence.planes[i].normal.y);
        EXPECT_EQ(record.planes[i].offset, fence.planes[i].offset);
      }
      if (entry.spans.empty()) continue;
      EXPECT_EQ(record.fence.from, entry.spans[0].from - *settings.epoch);
      EXPECT_EQ(record.fence.until, entry.spans[0].until - *settings.epoch);
      EXPECT_EQ(record.fence.clock_error, 2.0);
    }
  }
}

TEST(Airspace, ListsRingsThatAreNoPolygons) {
  const AirspaceFile file = tern_host::parse_airspace(
      "<kml><Placemark><name>Ring</name><LinearRing><coordinates>8,47 9,47 "
      "9,48</coordinates></LinearRing></Placemark></kml>",
      "ring.kml");
  EXPECT_TRUE(file.zones.empty());
  ASSERT_EQ(file.left_out.size(), 1u);
  EXPECT_EQ(file.left_out[0], "Ring, ring.kml:1: a LinearRing has no area");
}

TEST(Airspace, SaysWhatItHasAlready) {
  const AirspaceFile file = tern_host::parse_airspace(content("zones.kml"), "zones.kml");
  const Airspace once = tern_host::make_airspace({file}, lake_settings());
  const Airspace twice = tern_host::make_airspace({file, file}, lake_settings());
  EXPECT_EQ(twice.fence_count(), once.fence_count());
  EXPECT_EQ(twice.entries.back().left_out, "as Islands, zones.kml:23");
}

/// The first element of a drawing with an attribute twice, which is no XML; empty if there is none.
std::string element_with_an_attribute_twice(const std::string& svg) {
  const std::regex element("<[a-z][^>]*>");
  const std::regex attribute(" ([a-z-]+)=\"");
  for (std::sregex_iterator e(svg.begin(), svg.end(), element), end; e != end; ++e) {
    const std::string text = e->str();
    std::set<std::string> names;
    for (std::sregex_iterator a(text.begin(), text.end(), attribute); a != end; ++a) {
      if (!names.insert((*a)[1].str()).second) return text;
    }
  }
  return "";
}

TEST(Airspace, DrawsMissionsAsXml) {
  const Airspace airspace =
      tern_host::make_airspace({tern_host::parse_airspace(content("mission.plan"), "mission.plan")}, lake_settings());
  const std::string svg = tern_host::airspace_svg(airspace);
  EXPECT_NE(svg.find("<polyline"), std::string::npos);
  for (const char* caption : {">keep out<", ">keep in<", ">mission<", ">rally point<"}) {
    EXPECT_NE(svg.find(caption), std::string::npos) << caption;
  }
  EXPECT_EQ(svg.find(">keep out for a while<"), std::string::npos) << "there is none in the picture";
  EXPECT_EQ(element_with_an_attribute_twice(svg), "");
  EXPECT_EQ(element_with_an_attribute_twice("<a b=\"1\" b=\"2\"/>"), "<a b=\"1\" b=\"2\"/>");
}

TEST(Airspace, DrawsWhatItHas) {
  const Airspace airspace =
      tern_host::make_airspace({tern_host::parse_airspace(content("zones.kml"), "zones.kml")}, lake_settings());
  const std::string svg = tern_host::airspace_svg(airspace);
  EXPECT_NE(svg.find("keepout-for-a-while"), std::string::npos);
  EXPECT_NE(svg.find("Zürichhorn &amp; park"), std::string::npos);
}

TEST(Airspace, CountsOneAsOne) {
  AirspaceFile file;
  tern_host::Zone zone;
  zone.name = "Half";
  zone.lower = tern_host::ZoneHeight{500.0, tern_host::HeightReference::kEllipsoid};
  zone.areas.emplace_back();
  zone.areas[0].ring = {{47.3, 8.4}, {47.3, 8.6}, {47.4, 8.6}, {47.4, 8.4}};
  file.zones = {zone};
  const std::string table = airspace_table(tern_host::make_airspace({file}, lake_settings()));
  EXPECT_NE(table.find("\n1 fence with 1 half-space\n"), std::string::npos) << table;
}

TEST(Airspace, PrintsNoControlCharacters) {
  EXPECT_EQ(tern_host::printable("a\x1b[31m\n"), "a?[31m?");
  EXPECT_EQ(tern_host::printable("\xC2\x9B\xC2\xB0 \xE2\x82\xAC \xFF\xC3"), "??\xC2\xB0 \xE2\x82\xAC ??");
  EXPECT_EQ(tern_host::printable("Zürich", 2), "Zü...");
}

/// Bytes changed, dropped, doubled or replaced by what readers trip over.
void spoil(Random& random, std::string& bytes) {
  const char* const hostile[] = {"null", "-1", "1e308", "[]", "{}", "\"\"", "true",    "99999",
                                 "<",    ">",  "/>",    "\"", "0",  "NaN",  "\\u0000", "\xFF"};
  const auto place = [&] { return static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()))); };
  const std::size_t at = place();
  switch (random.integer(0, 4)) {
    case 0:
      bytes.resize(at);
      break;
    case 1:
      bytes.erase(at, static_cast<std::size_t>(random.integer(1, 30)));
      break;
    case 2:
      bytes.insert(at, bytes.substr(place(), static_cast<std::size_t>(random.integer(1, 60))));
      break;
    case 3:
      if (at < bytes.size()) bytes[at] = static_cast<char>(random.integer(0, 255));
      break;
    default:
      bytes.replace(at, std::min<std::size_t>(bytes.size() - at, 4), hostile[random.integer(0, 15)]);
  }
}

TEST(Airspace, SpoiledFilesAreReadOrRefused) {
  Random random(31);
  int read = 0, refused = 0;
  for (int i = 0; i < tern_test::scaled(4000); ++i) {
    std::string bytes = content(kFiles[i % 7]);
    for (int k = random.integer(1, 3); k > 0; --k) spoil(random, bytes);
    try {
      const Airspace airspace =
          tern_host::make_airspace({tern_host::parse_airspace(bytes, "spoiled")}, lake_settings());
      for (const tern_host::AirspaceEntry& entry : airspace.entries) {
        ASSERT_TRUE(entry.left_out.empty() != entry.fit.fences.empty());
        for (const tern_host::FittedFence& fence : entry.fit.fences) {
          for (const tern::Halfspace& h : fence.planes)
            ASSERT_TRUE(std::isfinite(h.normal.x + h.normal.y + h.normal.z + h.offset));
        }
      }
      ASSERT_FALSE(tern_host::fences_text(airspace).empty());
      ++read;
    } catch (const tern_host::RecordError& error) {
      ASSERT_EQ(error.place().file, "spoiled");
      ASSERT_FALSE(error.reason().empty());
      ++refused;
    } catch (const std::invalid_argument& error) {
      ASSERT_FALSE(std::string(error.what()).empty());
      ++refused;
    }
  }
  EXPECT_GT(read, 0);
  EXPECT_GT(refused, 0);
}

tern_host::Airspace with_kml(const std::string& coordinates, const std::vector<std::string>& keep_in = {}) {
  tern_host::AirspaceSettings settings = lake_settings();
  settings.keep_in = keep_in;
  return tern_host::make_airspace(
      {tern_host::parse_airspace("<kml><Placemark><name>Square</name><Polygon><extrude>true</extrude>"
                                 "<altitudeMode>absolute</altitudeMode><outerBoundaryIs><LinearRing><coordinates>" +
                                     coordinates +
                                     "</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark></kml>",
                                 "square.kml")},
      settings);
}

std::string square(const std::string& third_height) {
  return "8.535,47.363,600 8.545,47.363,600 8.545,47.369," + third_height + " 8.535,47.369,600 8.535,47.363,600";
}

TEST(Airspace, TextsOfKmlMayHaveCommentsAndCdata) {
  const double area = with_kml(square("600")).entries[0].fit.area;
  EXPECT_GT(area, 1e5);
  EXPECT_EQ(with_kml(square("600 <!-- north-east --> ")).entries[0].fit.area, area);
  EXPECT_EQ(with_kml("<![CDATA[" + square("600") + "]]>").entries[0].fit.area, area);
  EXPECT_EQ(with_kml(square("600 <![CDATA[ ]]> ")).entries[0].fit.area, area);
}

TEST(Airspace, AKeepInOfKmlHasALevelTop) {
  EXPECT_EQ(with_kml(square("600"), {"Square"}).entries[0].fit.fences.size(), 1u);
  EXPECT_EQ(with_kml(square("550")).entries[0].zone.upper->metres, 600.0) << "a keep-out's highest corner";
  EXPECT_THROW(with_kml(square("550"), {"Square"}), std::invalid_argument);
}

TEST(Airspace, GeojsonMayHaveKeysOfOtherFormats) {
  for (const char* key : {"constraints", "operational_intents", "UASZoneList", "geoFence", "fileType", "details"}) {
    const std::string text = std::string("{\"type\": \"FeatureCollection\", \"") + key +
                             "\": [], \"features\": [{\"type\": \"Feature\", \"properties\": null, \"geometry\": "
                             "{\"type\": \"Polygon\", \"coordinates\": [[[8.5, 47], [8.6, 47], [8.6, 48]]]}}]}";
    EXPECT_EQ(tern_host::parse_airspace(text, "foreign.json").zones.size(), 1u) << key;
  }
}

TEST(Airspace, ZonesCountAsLongAsTheClockMayBeOff) {
  tern_host::AirspaceSettings settings = lake_settings();
  settings.clock_error = 5.0;
  const auto fences = [&settings](const char* key, const char* time) {
    const std::string text = std::string("{\"type\": \"Feature\", \"properties\": {\"") + key + "\": \"" + time +
                             "\"}, \"geometry\": {\"type\": \"Polygon\", \"coordinates\": [[[8.53, 47.36], "
                             "[8.55, 47.36], [8.55, 47.37]]]}}";
    return tern_host::make_airspace({tern_host::parse_airspace(text, "zone.json")}, settings).fence_count();
  };
  // The flight's clock is 0 at 08:00:00, and the flight ends by 16:00:00.
  EXPECT_EQ(fences("until", "2026-03-02T07:59:56Z"), 1);
  EXPECT_EQ(fences("until", "2026-03-02T07:59:54Z"), 0);
  EXPECT_EQ(fences("from", "2026-03-02T16:00:04Z"), 1);
  EXPECT_EQ(fences("from", "2026-03-02T16:00:06Z"), 0);
}

}  // namespace
