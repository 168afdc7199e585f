// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The frame of an intent: what files and users say of it, and that they say the same.
#include "host/intent/intent_frame.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "host/intent/intent_text.hpp"
#include "host/intent/timed_path.hpp"
#include "host/plan_file.hpp"

namespace {

using tern_host::EarthFrame;
using tern_host::EarthOrigin;
using tern_host::IntentFrame;
using tern_host::ToldFrame;

const EarthFrame kInFile{EarthOrigin{47.366, 8.54}, 455.0, "2026-03-02T09:00:00Z"};

std::string refusal(const ToldFrame& told, const EarthFrame& in_file) {
  try {
    tern_host::intent_frame(told, in_file, "p.json");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

ToldFrame told(const std::function<void(ToldFrame&)>& change) {
  ToldFrame all{kInFile, {}};
  change(all);
  return all;
}

TEST(IntentFrame, IsThatOfTheFile) {
  const IntentFrame frame = tern_host::intent_frame({}, kInFile, "p.json");
  EXPECT_EQ(frame.heights.frame().origin().point.latitude, 47.366);
  EXPECT_EQ(frame.heights.frame().origin().point.longitude, 8.54);
  EXPECT_EQ(frame.heights.frame().origin().height, 455.0);
  EXPECT_EQ(frame.epoch, *tern_host::parse_instant("2026-03-02T09:00:00Z"));
}

TEST(IntentFrame, IsCompletedByTheUser) {
  EXPECT_EQ(refusal({}, {}), "p.json: it does not say where its frame is: give --origin LATITUDE LONGITUDE");
  EXPECT_EQ(refusal({{EarthOrigin{1, 2}, 3.0, ""}, {}}, {}),
            "p.json: it does not say when its clock is 0: give --epoch, such as 2026-03-01T09:30:00Z");
  EXPECT_EQ(refusal({}, {EarthOrigin{47.366, 8.54}, {}, "2026-03-02T09:00:00Z"}),
            "p.json: it does not say how high its origin is: give --height, or --height-amsl");
  EXPECT_EQ(refusal({kInFile, {}}, {}), "");
  EXPECT_EQ(refusal({kInFile, {}}, kInFile), "");
}

TEST(IntentFrame, IsRefusedWhereTheFileSaysAnother) {
  EXPECT_EQ(
      refusal(told([](ToldFrame& t) {
                t.frame.origin = EarthOrigin{47.367, 8.54};
              }),
              kInFile),
      "p.json: the origin of its frame is 47.366, 8.54, not 47.367, 8.54: use the frame that the plan was made in");
  EXPECT_EQ(refusal(told([](ToldFrame& t) { t.frame.origin = EarthOrigin{47.366, 368.54}; }), kInFile), "");
  EXPECT_EQ(refusal(told([](ToldFrame& t) { t.frame.height = 408.0; }), kInFile).substr(0, 69),
            "p.json: its origin's height above the ellipsoid is 455 m, not 408 m: ");
  EXPECT_EQ(refusal(told([](ToldFrame& t) { t.frame.epoch = "2026-03-02T09:00:00+01:00"; }), kInFile).substr(0, 64),
            "p.json: its epoch is 2026-03-02T09:00:00Z, not 2026-03-02T08:00:");
  EXPECT_EQ(refusal(told([](ToldFrame& t) { t.frame.epoch = "2026-03-02T10:00:00+01:00"; }), kInFile), "");
}

TEST(IntentFrame, HeightsMayBeAboveMeanSeaLevel) {
  ToldFrame sea;
  sea.heights.origin_sea_level = 407.7;
  EXPECT_NE(refusal(sea, kInFile).find("need a geoid"), std::string::npos);
  sea.heights.undulation = 47.3;
  const IntentFrame frame = tern_host::intent_frame(sea, kInFile, "p.json");
  EXPECT_NEAR(frame.heights.frame().origin().height, 455.0, 1e-9);
  sea.heights.undulation = 48.3;
  EXPECT_NE(refusal(sea, kInFile).find("above the ellipsoid is 455 m, not 456"), std::string::npos);

  tern_host::UtmEntity intent;
  tern_host::Zone zone;
  zone.areas.emplace_back();
  zone.areas[0].centre = {47.366, 8.54};
  zone.areas[0].radius = 10.0;
  zone.lower = {463.0, tern_host::HeightReference::kEllipsoid};
  zone.upper = {486.4, tern_host::HeightReference::kEllipsoid};
  zone.times.push_back({frame.epoch, frame.epoch + tern_host::kSecond, {}});
  intent.volumes.push_back(zone);
  EXPECT_NE(volumes_text(intent, frame.heights).find("463.0 to 486.4 m (415.7 to 439.1 m AMSL), circle"),
            std::string::npos)
      << volumes_text(intent, frame.heights);
}

TEST(IntentFrame, GoesThroughScenarioAndPlan) {
  const std::string text =
      "frame 47.366 8.54 455\nepoch 2026-03-02T09:00:00Z\nboundary 0 0 0 4 3 2\nstart 1 1 1\ngoal 3 2 1\nrest_clear "
      "7\n";
  tern_host::Session session;
  const tern_host::PlanResult result = session.plan(tern_host::parse_scenario(text, "s.txt"));
  ASSERT_TRUE(result.ok());
  const tern_host::TimedPath path = tern_host::parse_timed_path(plan_json(result), "p.json");
  EXPECT_EQ(path.rest, 7.0);
  EXPECT_EQ(timed_path_of(result).rest, 7.0);
  for (const EarthFrame& earth : {path.earth, timed_path_of(result).earth}) {
    ASSERT_TRUE(earth.origin.has_value());
    EXPECT_EQ(earth.origin->latitude, 47.366);
    EXPECT_EQ(earth.origin->longitude, 8.54);
    EXPECT_EQ(earth.height, 455.0);
    EXPECT_EQ(earth.epoch, "2026-03-02T09:00:00Z");
  }
}

}  // namespace
