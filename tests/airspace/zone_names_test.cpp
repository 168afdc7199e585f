// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What zones are called: which of them a name means, and what becomes of names in fences.
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "airspace/airspace_file.hpp"
#include "host/scenario.hpp"

namespace {

using tern_host::Airspace;
using tern_host::AirspaceFile;
using tern_host::AirspaceSettings;
using tern_test::content;
using tern_test::lake_settings;

TEST(Airspace, LeavesOutAndKeepsInAsTold) {
  AirspaceSettings settings = lake_settings();
  settings.leave_out = {"Lake"};
  settings.keep_in = {"Islands"};
  const std::vector<AirspaceFile> files{tern_host::parse_airspace(content("zones.geojson"), "a"),
                                        tern_host::parse_airspace(content("zones.kml"), "b")};
  const Airspace airspace = tern_host::make_airspace(files, settings);
  EXPECT_EQ(airspace.entries[0].left_out, "left out, as told");
  EXPECT_TRUE(airspace.entries[0].fit.fences.empty());
  EXPECT_EQ(airspace.entries.back().zone.kind, tern_host::ZoneKind::kKeepIn);
  EXPECT_EQ(airspace.entries.back().fit.fences[0].kind, tern::FenceKind::kKeepIn);
}

/// Why these names are refused; empty if they are not.
std::string name_refusal(const std::vector<std::string>& leave_out, const std::vector<AirspaceFile>& files) {
  AirspaceSettings settings = lake_settings();
  settings.leave_out = leave_out;
  try {
    tern_host::make_airspace(files, settings);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Airspace, GeozonesAnswerToNameAndIdentifier) {
  for (const char* file : {"geozones.ed269.json", "geozones.ed318.json"}) {
    const std::vector<AirspaceFile> files{tern_host::parse_airspace(content(file), file)};
    const bool older = std::string(file) == "geozones.ed269.json";
    const std::string whole = older ? "CHE LS001 Heliport" : "CHE NFZ1 Station";
    EXPECT_EQ(files[0].zones[0].name, whole);
    for (const std::string& said :
         {whole, whole.substr(0, older ? 9 : 8), whole.substr(4, older ? 5 : 4), whole.substr(older ? 10 : 9)}) {
      AirspaceSettings settings = lake_settings();
      settings.leave_out = {said};
      const Airspace airspace = tern_host::make_airspace(files, settings);
      EXPECT_EQ(airspace.entries[0].left_out, "left out, as told") << said;
      EXPECT_EQ(airspace.entries[1].left_out, "left out, as told") << said << ": its other volume";
      EXPECT_EQ(airspace.entries[2].left_out, "") << said;
    }
  }
}

TEST(Airspace, NamesThatMeanNoZoneOrSeveralAreRefused) {
  std::vector<AirspaceFile> files{tern_host::parse_airspace(content("geozones.ed269.json"), "a")};
  EXPECT_EQ(name_refusal({"Heliprt"}, files),
            "no zone is named 'Heliprt': there are 'CHE LS001 Heliport', 'CHE LS002 School'");
  EXPECT_EQ(name_refusal({"School"}, files), "");
  std::string other = content("geozones.ed269.json");
  for (std::size_t at = other.find("CHE"); at != std::string::npos; at = other.find("CHE")) other.replace(at, 3, "AUT");
  files.push_back(tern_host::parse_airspace(other, "b"));
  EXPECT_EQ(name_refusal({"School"}, files),
            "several zones are named 'School', say which: 'CHE LS002 School', 'AUT LS002 School'");
  EXPECT_EQ(name_refusal({"AUT LS002"}, files), "");
  files[0].zones.resize(1);
  files.resize(1);
  EXPECT_EQ(name_refusal({"x"}, files), "no zone is named 'x': there is 'CHE LS001 Heliport'");
  for (int i = 0; i < 14; ++i) {
    files[0].zones.push_back(files[0].zones[0]);
    files[0].zones.back().name = "zone " + std::to_string(i);
  }
  EXPECT_NE(name_refusal({"x"}, files).find("'zone 10' and 3 more"), std::string::npos) << name_refusal({"x"}, files);
}

TEST(Airspace, NamesAreNoTimes) {
  std::vector<AirspaceFile> files{tern_host::parse_airspace(content("zones.geojson"), "a")};
  for (tern_host::Zone& zone : files[0].zones) zone.name = "during it, during 3 4 " + zone.name;
  const std::string text = tern_host::fences_text(tern_host::make_airspace(files, lake_settings()));
  EXPECT_NE(text.find(" zone During it, During 3 4 Lake\n"), std::string::npos) << text;
  EXPECT_NO_THROW(tern_host::parse_scenario(text + "start -900 -900 50\ngoal 900 -500 50\n", "lake.txt"));
}

}  // namespace
