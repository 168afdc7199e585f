// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "host/page/flight_film.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "host/flight/flight_world.hpp"
#include "host/page/replayed_run.hpp"
#include "host/picture/flight_picture.hpp"

namespace {

using Json = nlohmann::json;

/// A short flight through a forest, filmed.
class FlightFilmTest : public testing::Test {
 protected:
  void SetUp() override {
    result_ = tern_host::simulate_flight(world_, [this](const tern_host::FlightMoment& m) { film_.note(m); });
    run_ = Json::parse(film_.run(result_));
  }

  const Json& film(const char* part) const { return run_.at("film").at(part); }

  tern_host::FlightWorld world_ = tern_host::read_flight_world("P36@3:2", {"time_limit=3"});
  tern_host::FlightFilm film_{world_};
  tern_host::FlightResult result_;
  Json run_;
};

TEST_F(FlightFilmTest, TheFilmChangesNothing) {
  EXPECT_EQ(tern_host::simulate_flight(world_).commands_hash, result_.commands_hash);
}

TEST_F(FlightFilmTest, WhatIsInTheWayAtTheEndIsMarked) {
  EXPECT_TRUE(run_.at("blocked").is_null());
  result_.blocked_by = tern::BlockedBy::kUnseen;
  result_.blocked_at = {1.25, -2.5, 1.5};
  EXPECT_EQ(Json::parse(film_.run(result_)).at("blocked"), Json({1.25, -2.5, 1.5}));
  const std::string mark = ">in the way at the end<";
  EXPECT_NE(tern_host::flight_svg(world_, result_).find(mark), std::string::npos);
  result_.status = "reached";
  EXPECT_TRUE(Json::parse(film_.run(result_)).at("blocked").is_null());
  EXPECT_EQ(tern_host::flight_svg(world_, result_).find(mark), std::string::npos);
}

TEST_F(FlightFilmTest, TheMotionIsTheTrack) {
  const Json& columns = run_.at("motion").at("columns");
  EXPECT_DOUBLE_EQ(run_.at("motion").at("step").get<double>(), 0.01);
  ASSERT_EQ(columns.at("px").size(), result_.track.size());
  for (std::size_t i = 0; i < result_.track.size(); i += 50) {
    EXPECT_NEAR(columns.at("px")[i].get<double>(), result_.track[i].position.x, 5.1e-4);
    double norm = 0.0;
    for (const char* const name : {"qw", "qx", "qy", "qz"}) norm += std::pow(columns.at(name)[i].get<double>(), 2);
    EXPECT_NEAR(norm, 1.0, 1e-3);
    EXPECT_NEAR(columns.at("clearance")[i].get<double>(), tern_host::clearance(world_, result_.track[i].position),
                5.1e-4);
  }
}

/// The film of the record, flown again: the same plans, and the vehicle where it was told to be.
TEST_F(FlightFilmTest, TheRecordShowsTheSamePlans) {
  std::string record;
  tern_host::simulate_flight(world_, {}, &record);
  const Json run = Json::parse(tern_host::replayed_run("wood.record", record));
  EXPECT_EQ(run.at("name"), "wood.record");
  EXPECT_EQ(run.at("goal"), run_.at("goal"));
  ASSERT_GT(film("commits").size(), 3u);
  EXPECT_EQ(run.at("film").at("commits"), film("commits"));
  EXPECT_EQ(run.at("film").at("dropped"), film("dropped"));
  EXPECT_GT(run.at("film").at("known").size(), 0u);
  const Json& columns = run.at("motion").at("columns");
  ASSERT_GE(columns.at("px").size(), result_.track.size() - 1);
  for (std::size_t i = 0; i + 1 < result_.track.size(); i += 50) {
    EXPECT_NEAR(columns.at("px")[i].get<double>(), result_.track[i].commanded.x, 5.1e-4);
    EXPECT_TRUE(columns.at("clearance")[i].is_null());
  }
}

/// A commit's points begin within the tracking error of the vehicle, and end slowly: at rest.
TEST_F(FlightFilmTest, CommitsLeadFromTheVehicleToARest) {
  ASSERT_EQ(film("commits").size(), result_.committed);
  ASSERT_GT(result_.committed, 5u);
  for (const Json& commit : film("commits")) {
    const auto tick = static_cast<std::size_t>(std::lround(100.0 * commit.at("t").get<double>()));
    const Json& points = commit.at("points");
    const tern::Vec3& at = result_.track[tick].position;
    const double off = std::hypot(points[0].get<double>() - at.x, points[1].get<double>() - at.y);
    EXPECT_LE(off, world_.settings.tracking_margin + 1e-3);
    const std::size_t n = points.size();
    ASSERT_GE(n, 6u);
    EXPECT_LT(std::hypot(points[n - 3].get<double>() - points[n - 6].get<double>(),
                         points[n - 2].get<double>() - points[n - 5].get<double>()),
              0.1);
  }
}

/// Every voxel that is known lies beside a tree or a wall.
TEST_F(FlightFilmTest, WhatIsKnownIsThere) {
  const Json& known = film("known");
  const double cell = known.at("cell").get<double>();
  const Json& origin = known.at("origin");
  ASSERT_GT(known.at("blocks").size(), 7u);
  for (std::size_t i = 0; i < known.at("blocks").size(); i += 7) {
    const auto number = [&](std::size_t k) { return known.at("blocks")[i + k].get<double>(); };
    for (double row = 0.0; row < number(3); row += 1.0) {
      const tern::Vec3 middle{origin[0].get<double>() + cell * (number(0) + 0.5),
                              origin[1].get<double>() + cell * (number(1) + row + 0.5),
                              origin[2].get<double>() + cell * (number(2) + 0.5)};
      EXPECT_LT(tern_host::clearance(world_, middle), 2.0 * cell);
    }
  }
}

/// Things are where they truly are, and the picture has them.
TEST(FlightFilmAmongThings, ShowsThem) {
  const tern_host::FlightWorld world = tern_host::read_flight_world("T4:0", {"time_limit=2"});
  tern_host::FlightFilm film(world);
  const tern_host::FlightResult result =
      tern_host::simulate_flight(world, [&film](const tern_host::FlightMoment& m) { film.note(m); });
  const Json run = Json::parse(film.run(result));
  const Json& things = run.at("things");
  ASSERT_EQ(things.size(), world.things.size());
  const Json& first = things[0];
  EXPECT_EQ(first.at("shape"), "box");
  EXPECT_EQ(first.at("half"), Json({0.4, 0.4, 0.4}));
  EXPECT_EQ(first.at("step").get<double>(), 0.1);
  ASSERT_EQ(first.at("rows").size(), 21u);
  const tern_host::ThingMotion motion(world.things[0]);
  for (std::size_t k = 0; k < 21; ++k) {
    EXPECT_NEAR(first.at("rows")[k][0].get<double>(), motion.at(0.1 * static_cast<double>(k)).position.x, 5.1e-4);
  }
  // The tubes of the plan that is flown: a thing's centre is in each that is shown, and there is none at first, because
  // measurements come 0.15 s late.
  const Json& tubes = run.at("film").at("tubes");
  ASSERT_GT(tubes.size(), 0u);
  int shown = 0;
  for (const Json& tube : tubes) {
    ASSERT_EQ(tube.at("rows").size(), 21u);
    EXPECT_TRUE(tube.at("rows")[1].is_null());
    for (std::size_t k = 0; k < 21; ++k) {
      const Json& row = tube.at("rows")[k];
      if (row.is_null()) continue;
      ++shown;
      EXPECT_TRUE(std::any_of(things.begin(), things.end(), [&](const Json& thing) {
        const Json& at = thing.at("rows")[k];
        if (at.is_null()) return false;
        double square = 0.0;
        for (std::size_t a = 0; a < 3; ++a) square += std::pow(at[a].get<double>() - row[a].get<double>(), 2.0);
        return std::sqrt(square) <= row[3].get<double>() + 0.01;
      })) << k;
    }
  }
  EXPECT_GT(shown, 20);
  const std::string picture = tern_host::flight_svg(world, result);
  EXPECT_NE(picture.find("class=\"thing\""), std::string::npos);
  EXPECT_NE(picture.find(">what moves, at the end, and its way<"), std::string::npos);
}

}  // namespace
