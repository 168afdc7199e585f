// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Intents as documents: what is written is read again, and has what the public schema of F3548 wants.
#include "host/intent/intent_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "host/intent/tube_volumes.hpp"
#include "host/text_records.hpp"
#include "intent/path_case.hpp"

namespace {

using nlohmann::json;
using tern_host::LocalFrame;
using tern_host::UtmEntity;
using tern_host::Zone;
using tern_test::straight;

UtmEntity intent() {
  const LocalFrame frame({{47.0, 8.0}, 400.0});
  tern_host::TubeSettings settings;
  settings.epoch = *tern_host::parse_instant("2026-03-01T12:00:00Z");
  settings.longest = 15.0;
  const tern_host::TimedPath path{
      "p", {straight(0, 10, {0, 0, 0}, {0, 0, 50}), straight(10, 30, {0, 0, 50}, {100, 30, 50})}, 0.5, {}};
  UtmEntity e;
  e.id = "2f8343be-6482-4d1b-a474-16847e01af1e";
  e.manager = "uss1";
  e.state = "Accepted";
  e.base_url = "https://uss1.example.com/utm";
  e.priority = 7;
  e.volumes = tube_volumes(path, frame, settings);
  return e;
}

TEST(IntentJson, IsReadAgainToTheBit) {
  UtmEntity e = intent();
  e.ovn = "9d158f59-80b7-4c11-9c0c-8a2b4d936b2d";
  e.version = 3;
  const json document = json::parse(tern_host::intent_json(e));
  const std::vector<UtmEntity> read = read_utm_entities(tern_host::JsonNode(document, "intent.json"));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].kind, tern_host::EntityKind::kIntent);
  EXPECT_EQ(read[0].id, e.id);
  EXPECT_EQ(read[0].manager, e.manager);
  EXPECT_EQ(read[0].state, e.state);
  EXPECT_EQ(read[0].ovn, e.ovn);
  EXPECT_EQ(read[0].base_url, e.base_url);
  EXPECT_EQ(read[0].version, 3);
  EXPECT_EQ(read[0].priority, 7);
  ASSERT_EQ(read[0].volumes.size(), e.volumes.size());
  for (std::size_t i = 0; i < e.volumes.size(); ++i) {
    const Zone& a = e.volumes[i];
    const Zone& b = read[0].volumes[i];
    EXPECT_EQ(a.lower->metres, b.lower->metres);
    EXPECT_EQ(a.upper->metres, b.upper->metres);
    EXPECT_EQ(a.times[0].from, b.times[0].from);
    EXPECT_EQ(a.times[0].until, b.times[0].until);
    EXPECT_EQ(a.areas[0].radius, b.areas[0].radius);
    EXPECT_EQ(a.areas[0].centre.latitude, b.areas[0].centre.latitude);
    ASSERT_EQ(a.areas[0].ring.size(), b.areas[0].ring.size());
    for (std::size_t k = 0; k < a.areas[0].ring.size(); ++k) {
      EXPECT_EQ(a.areas[0].ring[k].latitude, b.areas[0].ring[k].latitude);
      EXPECT_EQ(a.areas[0].ring[k].longitude, b.areas[0].ring[k].longitude);
    }
  }
}

void expect_time(const json& time) {
  EXPECT_EQ(time.at("format"), "RFC3339");
  EXPECT_TRUE(tern_host::parse_instant(time.at("value").get<std::string>()));
}

TEST(IntentJson, HasWhatTheSchemaWants) {
  const json document = json::parse(tern_host::intent_json(intent()));
  const json& reference = document.at("operational_intent").at("reference");
  for (const char* key : {"id", "manager", "uss_availability", "version", "state", "time_start", "time_end",
                          "uss_base_url", "subscription_id"}) {
    EXPECT_TRUE(reference.contains(key)) << key;
  }
  EXPECT_FALSE(reference.contains("ovn")) << "it has none before the DSS gives it one";
  EXPECT_TRUE(tern_host::is_entity_id(reference.at("subscription_id")));
  expect_time(reference.at("time_start"));
  expect_time(reference.at("time_end"));
  const json& details = document.at("operational_intent").at("details");
  EXPECT_TRUE(details.at("off_nominal_volumes").empty());
  ASSERT_EQ(details.at("volumes").size(), 3u);
  for (const json& entry : details.at("volumes")) {
    expect_time(entry.at("time_start"));
    expect_time(entry.at("time_end"));
    const json& volume = entry.at("volume");
    EXPECT_NE(volume.contains("outline_circle"), volume.contains("outline_polygon"));
    for (const char* key : {"altitude_lower", "altitude_upper"}) {
      EXPECT_EQ(volume.at(key).at("reference"), "W84");
      EXPECT_EQ(volume.at(key).at("units"), "M");
      EXPECT_TRUE(volume.at(key).at("value").is_number());
    }
  }
  EXPECT_EQ(details.at("volumes")[0].at("volume").at("outline_circle").at("radius").at("units"), "M");
  EXPECT_GE(details.at("volumes")[1].at("volume").at("outline_polygon").at("vertices").size(), 3u);
}

TEST(IntentJson, KnowsIds) {
  EXPECT_TRUE(tern_host::is_entity_id("2f8343be-6482-4d1b-a474-16847e01af1e"));
  EXPECT_TRUE(tern_host::is_entity_id("2F8343BE-6482-4D1B-B474-16847E01AF1E"));
  EXPECT_FALSE(tern_host::is_entity_id("2f8343be-6482-1d1b-a474-16847e01af1e")) << "version 1";
  EXPECT_FALSE(tern_host::is_entity_id("2f8343be-6482-4d1b-c474-16847e01af1e")) << "variant";
  EXPECT_FALSE(tern_host::is_entity_id("2f8343be-6482-4d1b-a474-16847e01af1"));
  EXPECT_FALSE(tern_host::is_entity_id("2f8343be_6482-4d1b-a474-16847e01af1e"));
  EXPECT_FALSE(tern_host::is_entity_id("gf8343be-6482-4d1b-a474-16847e01af1e"));
}

/// The reason why a plan file is refused.
std::string refusal(const std::string& text) {
  try {
    tern_host::parse_timed_path(text, "p.json");
  } catch (const tern_host::RecordError& error) {
    return error.what();
  }
  return "";
}

TEST(TimedPath, ReadsPlansAndRefusesOthers) {
  json segment = {{"duration", 2.0}, {"control_points", json::array()}};
  for (int i = 0; i < 8; ++i) segment["control_points"].push_back({i, 2.0 * i, 3.0});
  json plan = {{"format", "tern-plan/1"}, {"status", "ok"},     {"robot_radius", 0.3},
               {"tracking_margin", 0.2},  {"start_time", 12.0}, {"segments", {segment, segment}}};
  const tern_host::TimedPath path = tern_host::parse_timed_path(plan.dump(), "p.json");
  EXPECT_DOUBLE_EQ(path.radius, 0.5);
  ASSERT_EQ(path.pieces.size(), 2u);
  EXPECT_EQ(path.pieces[1].begin, 14.0);
  EXPECT_EQ(path.pieces[1].end, 16.0);
  EXPECT_EQ(path.pieces[1].points[3].y, 6.0);

  json bad = plan;
  bad["format"] = "else";
  EXPECT_NE(refusal(bad.dump()).find("tern-plan/1"), std::string::npos);
  bad = plan;
  bad.erase("start_time");
  EXPECT_NE(refusal(bad.dump()).find("it does not say when it begins ('start_time')"), std::string::npos);
  bad = plan;
  bad["status"] = "no_path";
  EXPECT_NE(refusal(bad.dump()).find("no trajectory"), std::string::npos);
  bad = plan;
  bad["segments"][1]["duration"] = 0.0;
  EXPECT_NE(refusal(bad.dump()).find("at /segments/1/duration: a duration must be more than 0"), std::string::npos);
  bad = plan;
  bad["segments"][0]["control_points"].erase(7);
  EXPECT_NE(refusal(bad.dump()).find("eight control points"), std::string::npos);
  bad = plan;
  bad["segments"][0]["control_points"][2].push_back(1.0);
  EXPECT_NE(refusal(bad.dump()).find("three coordinates"), std::string::npos);
  bad = plan;
  bad["segments"] = json::array();
  EXPECT_NE(refusal(bad.dump()).find("no segments"), std::string::npos);
  bad = plan;
  bad["robot_radius"] = -1.0;
  EXPECT_NE(refusal(bad.dump()).find("0 or more"), std::string::npos);
}

}  // namespace
