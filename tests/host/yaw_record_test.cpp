// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Yaw in scenarios, tables, plan files and pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "host/picture/picture.hpp"
#include "host/plan_file.hpp"

namespace {

using tern_host::parse_scenario;
using tern_host::PlanResult;
using tern_host::Scenario;

const std::string kRoom = "boundary 0 0 0 8 6 3\nstart 1 1 1\ngoal 7 5 1\n";

std::string yaw_error(const std::string& record) {
  try {
    parse_scenario(kRoom + record, "map.txt");
  } catch (const tern_host::ScenarioError& error) {
    return error.what();
  }
  return "";
}

PlanResult planned(const std::string& records) {
  return tern_host::Session().plan(parse_scenario(kRoom + records, "map.txt"));
}

TEST(YawRecord, EveryModeIsRead) {
  EXPECT_FALSE(parse_scenario(kRoom, "map.txt").has_yaw);
  EXPECT_EQ(parse_scenario(kRoom + "yaw motion\n", "map.txt").yaw.mode, tern::YawMode::kAlongMotion);
  const Scenario fixed = parse_scenario(kRoom + "yaw fixed -1.5\nstart_yaw 0.5\nstart_yaw_rate 0.25\n", "map.txt");
  EXPECT_EQ(fixed.yaw.mode, tern::YawMode::kFixed);
  EXPECT_EQ(fixed.yaw.heading, -1.5);
  EXPECT_EQ(fixed.yaw.start, 0.5);
  EXPECT_EQ(fixed.yaw.start_rate, 0.25);
  const Scenario point = parse_scenario(kRoom + "yaw point 4 3 2\nyaw_rate_max 3\n", "map.txt");
  EXPECT_EQ(point.yaw.mode, tern::YawMode::kTowardsPoint);
  EXPECT_EQ(point.yaw.point.y, 3.0);
  EXPECT_EQ(point.yaw.rate_max, 3.0);
  const Scenario timed = parse_scenario(kRoom + "yaw timed 1 0 2.5 3.14\n", "map.txt");
  ASSERT_EQ(timed.yaw.timed.size(), 2u);
  EXPECT_EQ(timed.yaw.timed[1].time, 2.5);
  EXPECT_EQ(timed.yaw.timed[1].heading.cosine, std::cos(3.14));
}

TEST(YawRecord, ErrorsNameTheRecord) {
  EXPECT_EQ(yaw_error("yaw\n"), "map.txt:4: 'yaw' is 'motion', 'fixed', 'point' or 'timed', found ''");
  EXPECT_EQ(yaw_error("yaw sideways\n"), "map.txt:4: 'yaw' is 'motion', 'fixed', 'point' or 'timed', found 'sideways'");
  EXPECT_EQ(yaw_error("yaw fixed\n"), "map.txt:4: 'yaw fixed' needs 1 number, found 0");
  EXPECT_EQ(yaw_error("yaw point 1 2\n"), "map.txt:4: 'yaw point' needs 3 numbers, found 2");
  EXPECT_EQ(yaw_error("yaw timed 1 2 3\n"),
            "map.txt:4: 'yaw timed' needs a time and an angle, any number of times, found 3");
  EXPECT_EQ(yaw_error("yaw motion\nyaw motion\n"), "map.txt:5: 'yaw' is given twice (first in line 4)");
  EXPECT_EQ(yaw_error("start_yaw 1\n"), "map.txt:4: 'start_yaw' needs a 'yaw', which says where the nose should point");
}

TEST(YawRecord, DegreesAreRefused) {
  EXPECT_EQ(yaw_error("yaw fixed 90\n"),
            "map.txt:4: 'yaw fixed' is in rad, at most 6.2832, found 90; if that is in degrees, write 1.5708");
  EXPECT_EQ(yaw_error("yaw fixed 6.2832\nstart_yaw -6.2832\nyaw_rate_max 31.4\nyaw_acceleration_max 100\n"), "");
  for (const char* record : {"fixed -7", "timed 1 0 2 7", "timed 1 -90", "fixed 180"}) {
    EXPECT_NE(yaw_error(std::string("yaw ") + record + "\n").find("is in rad, at most"), std::string::npos) << record;
  }
  EXPECT_NE(yaw_error("yaw motion\nstart_yaw 45\n").find("map.txt:5: 'start_yaw' is in rad,"), std::string::npos);
  for (const char* record : {"start_yaw_rate -45", "yaw_rate_max 90"}) {
    EXPECT_NE(yaw_error(std::string("yaw motion\n") + record + "\n").find("is in rad/s, at most"), std::string::npos);
  }
  for (const char* record : {"start_yaw_acceleration 180", "yaw_acceleration_max 360"}) {
    EXPECT_NE(yaw_error(std::string("yaw motion\n") + record + "\n").find("is in rad/s^2, at most"), std::string::npos);
  }
}

TEST(YawRecord, ThePlanKeepsTheLimitsAndPointsWhereItShould) {
  const PlanResult result = planned("yaw point 4 0 1\nyaw_rate_max 2\nyaw_acceleration_max 4\n");
  ASSERT_NE(result.yaw, nullptr);
  const tern_host::YawPeaks peaks = tern_host::yaw_peaks(*result.yaw);
  EXPECT_LE(peaks.rate, 2.0 + 1e-9);
  EXPECT_LE(peaks.acceleration, 4.0 + 1e-9);
  const double middle = 0.5 * tern::duration(result.trajectory);
  const tern::Vec3 at = tern::evaluate(result.trajectory, middle).position;
  EXPECT_NEAR(tern::evaluate(*result.yaw, middle).angle, std::atan2(0.0 - at.y, 4.0 - at.x), 0.05);
}

TEST(YawRecord, ARefusedWishSaysWhy) {
  const PlanResult result = planned("yaw motion\nyaw_rate_max 0\n");
  EXPECT_TRUE(result.ok());
  EXPECT_EQ(result.yaw, nullptr);
  EXPECT_EQ(result.yaw_status, tern::Status::kLimitsInvalid);
}

TEST(YawRecord, TheTableHasThreeColumnsMoreAndRunsUntilTheNoseRests) {
  const PlanResult result = planned("yaw fixed 2\n");
  ASSERT_NE(result.yaw, nullptr);
  const std::string csv = tern_host::trajectory_csv(result.trajectory, 0.5, result.yaw.get());
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "t,px,py,pz,vx,vy,vz,ax,ay,az,jx,jy,jz,sx,sy,sz,yaw,yaw_rate,yaw_acceleration");
  const std::string last = csv.substr(csv.rfind('\n', csv.size() - 2) + 1);
  std::vector<double> values;
  std::stringstream words(last);
  for (std::string word; std::getline(words, word, ',');) values.push_back(std::stod(word));
  ASSERT_EQ(values.size(), 19u);
  EXPECT_DOUBLE_EQ(values[0], tern::duration(*result.yaw));
  EXPECT_NEAR(values[16], 2.0, 1e-6);
  EXPECT_NEAR(values[17], 0.0, 1e-9);
}

TEST(YawRecord, ThePlanFileHasTheSpline) {
  const PlanResult result = planned("yaw motion\n");
  ASSERT_NE(result.yaw, nullptr);
  const nlohmann::json plan = nlohmann::json::parse(tern_host::plan_json(result));
  EXPECT_EQ(plan["yaw"]["mode"], "motion");
  EXPECT_EQ(plan["yaw"]["step"].get<double>(), result.yaw->step);
  EXPECT_EQ(plan["yaw"]["points"].size(), static_cast<std::size_t>(result.yaw->count) + 3);
  EXPECT_EQ(plan["yaw"]["points"].back().get<double>(), result.yaw->points[result.yaw->count + 2]);
  EXPECT_FALSE(nlohmann::json::parse(tern_host::plan_json(planned(""))).contains("yaw"));
}

TEST(YawRecord, ThePictureShowsNosesAndProfiles) {
  const std::string with = tern_host::plan_svg(planned("yaw motion\n"));
  const std::string without = tern_host::plan_svg(planned(""));
  EXPECT_NE(with.find("class=\"nose\""), std::string::npos);
  EXPECT_NE(with.find(">Turning: peaks and limits<"), std::string::npos);
  EXPECT_EQ(without.find("class=\"nose\""), std::string::npos);
  EXPECT_EQ(without.find(">Turning: peaks and limits<"), std::string::npos);
}

}  // namespace
