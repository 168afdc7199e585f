// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// False alarms: pixels that show something where nothing is, in narrow passages where few brakes have room. The world
// stands still, so nothing may be touched: Flown asserts that at every tick.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "support/flown.hpp"

namespace {

using namespace tern;
using tern_test::FlightSettings;
using tern_test::Flown;
using tern_test::Random;
using tern_test::Scene;

/// A corridor that turns left.
Scene corner(Random& random) {
  const double width = random.real(1.6, 3.0);
  const double inner = random.real(7.0, 11.0);
  const double half = 0.5 * width;
  Scene scene;
  scene.boxes.push_back({{-2.0, half, 0.0}, {inner, half + 0.3, 4.0}});
  scene.boxes.push_back({{-2.0, -half - 0.3, 0.0}, {inner + width, -half, 4.0}});
  scene.boxes.push_back({{inner + width, -half - 0.3, 0.0}, {inner + width + 0.3, 20.0, 4.0}});
  scene.boxes.push_back({{inner - 0.3, half, 0.0}, {inner, 20.0, 4.0}});
  scene.boxes.push_back({{-2.3, -half, 0.0}, {-2.0, half, 4.0}});
  return scene;
}

/// Shows something on the way for a few frames, again and again.
void fly_with_alarms(Flown& flown, Random& random, int& alarms, int& threats) {
  bool was_threat = false;
  for (int pause = 0, left = 0; flown.time < 25000000000 && !testing::Test::HasFatalFailure();) {
    if (left == 0 && pause == 0) {
      const Sample ahead = flown.flight.command(flown.time + 10000000 * random.integer(15, 70)).sample;
      const Vec3& p = ahead.position;
      flown.ghosts = {{p.x + random.real(-0.3, 0.3), p.y + random.real(-0.3, 0.3), random.real(0.1, 0.3), 3.0}};
      left = random.integer(1, 20);
      pause = random.integer(20, 120);
      ++alarms;
    }
    if (left > 0 && --left == 0) flown.ghosts.clear();
    if (left == 0 && pause > 0) --pause;
    flown.tick();
    const bool is_threat = flown.report.mode == FlightMode::kThreat;
    threats += is_threat && !was_threat ? 1 : 0;
    was_threat = is_threat;
    if (flown.report.mode == FlightMode::kRest && flown.report.reason == FlightReason::kArrived) return;
  }
}

TEST(FlightAlarms, ThingsThatAreNotThereLeadIntoNothing) {
  int alarms = 0;
  int threats = 0;
  for (int k = 0; k < tern_test::scaled(30) && !HasFatalFailure(); ++k) {
    SCOPED_TRACE(k);
    Random random(static_cast<std::uint64_t>(1500 + k));
    FlightSettings settings;
    settings.v = random.real(3.0, 8.0);
    settings.a = 8.0;
    settings.jerk = k % 2 == 0 ? 40.0 : 0.0;
    const Scene scene = corner(random);
    Flown flown(scene, settings);
    ASSERT_EQ(flown.started, Status::kOk);
    const double end = 0.5 * (scene.boxes[2].lower.x + scene.boxes[3].upper.x);
    ASSERT_EQ(flown.flight.set_goal({end, 16.0, 1.5}), Status::kOk);
    fly_with_alarms(flown, random, alarms, threats);
    EXPECT_GE(flown.least_clearance, settings.radius - 1e-6);
  }
  EXPECT_GT(threats, tern_test::scaled(30));
  RecordProperty("alarms", alarms);
  RecordProperty("threats", threats);
}

}  // namespace
