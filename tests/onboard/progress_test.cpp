// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What an operator is told of a flight that does not arrive.
#include "tern_onboard/progress.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "onboard/onboard_sky.hpp"

namespace {

using tern::FlightMode;
using tern::FlightReason;
using tern_onboard::Progress;
using tern_test::kMs;
using tern_test::Sky;

std::string note(Progress& progress, FlightMode mode, FlightReason reason, double away, double seconds) {
  tern::FlightReport report{};
  report.mode = mode;
  report.reason = reason;
  const char* const text = progress.note(report, away, static_cast<std::int64_t>(1e9 * seconds));
  return text == nullptr ? "" : text;
}

TEST(Progress, NoticesOnceThatTheVehicleRestsBeforeItsGoal) {
  Progress progress;
  EXPECT_EQ(note(progress, FlightMode::kFly, FlightReason::kNone, 9.0, 0.0), "");
  EXPECT_EQ(note(progress, FlightMode::kRest, FlightReason::kNoProgress, 8.0, 1.0),
            "the vehicle rests before its goal");
  for (double t = 2.0; t < 100.0; t += 1.0) {
    EXPECT_EQ(note(progress, FlightMode::kRest, FlightReason::kNoProgress, 8.0, t), "");
  }
  EXPECT_EQ(note(progress, FlightMode::kFly, FlightReason::kNone, 8.0, 100.0), "");
  EXPECT_NE(note(progress, FlightMode::kRest, FlightReason::kNearest, 8.0, 101.0), "");
  EXPECT_EQ(note(progress, FlightMode::kRest, FlightReason::kArrived, 8.0, 102.0), "");
}

TEST(Progress, NoticesEachHalfMinuteWithoutProgress) {
  Progress progress;
  int said = 0;
  for (double t = 0.0; t < 100.0; t += 0.1) {
    const double away = t < 20.0 ? 50.0 - t : 30.0 + std::sin(t);  // it flies back and forth
    said += note(progress, FlightMode::kFly, FlightReason::kNone, away, t).empty() ? 0 : 1;
  }
  EXPECT_EQ(said, 2);
  progress.restart();
  EXPECT_EQ(note(progress, FlightMode::kFly, FlightReason::kNone, 90.0, 200.0), "");
  EXPECT_EQ(note(progress, FlightMode::kRest, FlightReason::kArrived, 90.0, 300.0), "");
}

TEST(Progress, KnowsHowWideAWayMustBe) {
  tern_onboard::MapSettings map;
  map.cell = 0.1;
  map.radius = 0.3;
  map.tracking_margin = 0.15;
  EXPECT_NEAR(tern_onboard::narrowest_way(map), 1.1, 1e-12);
  map.tracking_margin = 0.1;
  EXPECT_NEAR(tern_onboard::narrowest_way(map), 0.9, 1e-12);
  EXPECT_NE(tern_onboard::narrowest_way_text(map).find("more than 0.90 m wide"), std::string::npos);
}

TEST(Progress, IsToldWithWhatIsInTheWayAndWhatToDo) {
  Sky sky("P25:20001");
  sky.send_pose();
  tern::Vec3 trunk = sky.world.goal;
  for (const tern_host::Cylinder& c : sky.world.cylinders) {
    if (std::abs(c.x - sky.world.start.x - 10.0) < 3.0) trunk = {c.x, c.y, 1.5};
  }
  ASSERT_TRUE(sky.onboard.set_goal(trunk, sky.now).ok);
  EXPECT_EQ(sky.fly(60.0), FlightReason::kNearest);
  std::string said;
  for (const tern_onboard::Notice& notice : sky.onboard.take_notices()) said += notice.text + "\n";
  EXPECT_NE(said.find("the flight begins at"), std::string::npos);
  EXPECT_NE(said.find("; a way must be"), std::string::npos);
  EXPECT_NE(said.find("the vehicle rests before its goal (rest: "), std::string::npos);
  EXPECT_NE(said.find("lower tracking_margin"), std::string::npos) << said;
}

}  // namespace
