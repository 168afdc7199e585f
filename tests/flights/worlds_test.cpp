// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Flights through unknown worlds: no contact, whatever happens, and the invariants of docs/flight.md at every tick.
#include <gtest/gtest.h>

#include <cmath>

#include "support/flights.hpp"

namespace {

using namespace tern;
using tern_test::FlightSettings;
using tern_test::Flown;
using tern_test::forest;
using tern_test::Random;
using tern_test::Scene;
using tern_test::story;

TEST(FlightWorlds, ForestsAreCrossed) {
  for (int k = 0; k < tern_test::scaled(12); ++k) {
    Random random(static_cast<std::uint64_t>(900 + k));
    FlightSettings settings;
    const double speeds[] = {3.0, 5.0, 8.0};
    settings.v = speeds[k % 3];
    settings.a = settings.v > 5.0 ? 8.0 : 6.0;
    Flown flown(forest(random, 30.0, 20.0, 1.0 / 25.0), settings);
    ASSERT_EQ(flown.started, Status::kOk);
    ASSERT_EQ(flown.flight.set_goal({30.0, 0.0, 1.5}), Status::kOk);
    EXPECT_EQ(flown.fly(60.0), FlightReason::kArrived) << k << ": " << story(flown);
    EXPECT_NEAR(flown.position().x, 30.0, 1e-9);
    EXPECT_LE(flown.report.dropped, flown.report.asked / 5);
  }
}

/// The tracking error is part of the radius: body 0.25 and 0.10.
TEST(FlightWorlds, TrackingErrorWithinTheMarginDoesNoHarm) {
  for (int k = 0; k < tern_test::scaled(4); ++k) {
    Random random(static_cast<std::uint64_t>(930 + k));
    FlightSettings settings;
    settings.v = 5.0;
    settings.tracking = 0.1;
    Flown flown(forest(random, 30.0, 20.0, 1.0 / 25.0), settings);
    flown.flight.set_goal({30.0, 0.0, 1.5});
    EXPECT_EQ(flown.fly(60.0), FlightReason::kArrived) << k << ": " << story(flown);
  }
}

TEST(FlightWorlds, LostFramesCostOnlyTime) {
  for (const double drop : {0.5, 0.9}) {
    Random random(950);
    FlightSettings settings;
    settings.v = 5.0;
    Flown flown(forest(random, 30.0, 20.0, 1.0 / 30.0), settings);
    flown.drop = drop;
    flown.flight.set_goal({30.0, 0.0, 1.5});
    EXPECT_EQ(flown.fly(90.0), FlightReason::kArrived) << drop << ": " << story(flown);
  }
}

TEST(FlightWorlds, WithoutFramesFromSomeInstantItComesToRest) {
  Random random(951);
  FlightSettings settings;
  settings.v = 8.0;
  settings.a = 8.0;
  Flown flown(forest(random, 60.0, 20.0, 1.0 / 30.0), settings);
  flown.flight.set_goal({60.0, 0.0, 1.5});
  flown.fly(2.5);
  EXPECT_EQ(flown.report.mode, FlightMode::kFly);
  flown.frames = false;
  EXPECT_EQ(flown.fly(60.0), FlightReason::kMapStale) << story(flown);
}

/// A tree behind a wall's end, where it is seen late.
TEST(FlightWorlds, HiddenCornerIsTurnedWithoutContact) {
  for (const double v : {4.0, 6.0, 8.0}) {
    FlightSettings settings;
    settings.v = v;
    settings.a = 8.0;
    Scene scene;
    scene.boxes.push_back({{8.0, -3.0, 0.0}, {8.5, 10.0, 4.0}});
    scene.cylinders.push_back({9.6, -3.4, 0.3, 5.0});
    scene.cylinders.push_back({9.4, -1.5, 0.3, 5.0});
    Flown flown(scene, settings);
    flown.flight.set_goal({16.0, 3.0, 1.5});
    EXPECT_EQ(flown.fly(60.0), FlightReason::kArrived) << v << ": " << story(flown);
  }
}

/// A keep-out across the straight way, and a band of heights: both hold at every tick.
TEST(FlightWorlds, FencesHold) {
  for (int k = 0; k < tern_test::scaled(4) && !testing::Test::HasFatalFailure(); ++k) {
    Random random(static_cast<std::uint64_t>(955 + k));
    const double left = random.real(1.0, 4.0);
    const double right = random.real(-4.0, -1.0);
    Halfspace out[kBoxPlanes];
    Halfspace band[kBoxPlanes];
    box_planes({{6.0, right, -5.0}, {9.0, left, 20.0}}, out);
    box_planes({{-50.0, -50.0, 1.0}, {50.0, 50.0, 2.2}}, band);
    FlightSettings settings;
    settings.v = random.real(3.0, 6.0);
    settings.fences = {{out, kBoxPlanes, FenceKind::kKeepOut}, {band, kBoxPlanes, FenceKind::kKeepIn}};
    Flown flown(forest(random, 20.0, 20.0, 1.0 / 50.0), settings);
    ASSERT_EQ(flown.started, Status::kOk);
    ASSERT_EQ(flown.flight.set_goal({20.0, 0.0, 1.5}), Status::kOk);
    while (flown.time < 60000000000 && flown.report.reason == FlightReason::kNone && !HasFatalFailure()) {
      flown.tick();
      const Vec3 p = flown.position();
      const double x = std::max({6.0 - p.x, p.x - 9.0, 0.0});
      const double y = std::max({right - p.y, p.y - left, 0.0});
      ASSERT_GE(std::hypot(x, y), settings.radius - 1e-6) << k << ": " << story(flown);
      ASSERT_GE(p.z, 1.0 - 1e-6);
      ASSERT_LE(p.z, 2.2 + 1e-6);
    }
    EXPECT_EQ(flown.report.reason, FlightReason::kArrived) << k << ": " << story(flown);
  }
}

/// A keep-in of no height, or less than a voxel of 0.2 m: past trees, and through a mission's points.
TEST(FlightWorlds, AKeepInThinnerThanAVoxelHoldsTheFlight) {
  const double heights[] = {0.0, 0.06, 0.0, 0.15};
  for (int k = 0; k < tern_test::scaled(4) && !testing::Test::HasFatalFailure(); ++k) {
    Random random(static_cast<std::uint64_t>(965 + k));
    FlightSettings settings;
    settings.v = random.real(3.0, 6.0);
    settings.start.z = k % 2 == 0 ? 1.5 : 1.4;  // anywhere in a voxel, or on its face
    const double lower = settings.start.z - heights[k] * random.unit();
    Halfspace level[kBoxPlanes];
    box_planes({{-50.0, -50.0, lower}, {50.0, 50.0, lower + heights[k]}}, level);
    settings.fences = {{level, kBoxPlanes, FenceKind::kKeepIn}};
    Flown flown(forest(random, 20.0, 20.0, 1.0 / 40.0), settings);
    ASSERT_EQ(flown.started, Status::kOk);
    const double z = settings.start.z;
    Via way[2];
    way[0].position = {7.0, 3.0, z};
    way[1].position = {20.0, 0.0, z};
    const Status asked =
        k < 2 ? flown.flight.set_goal(way[1].position) : flown.flight.set_mission(way, 2, ViaPolicy::kEnd);
    ASSERT_EQ(asked, Status::kOk);
    while (flown.time < 60000000000 && flown.report.reason == FlightReason::kNone && !HasFatalFailure()) {
      flown.tick();
      ASSERT_GE(flown.position().z, lower - 3e-9) << k << ": " << story(flown);
      ASSERT_LE(flown.position().z, lower + heights[k] + 3e-9) << k << ": " << story(flown);
    }
    EXPECT_EQ(flown.report.reason, FlightReason::kArrived) << k << ": " << story(flown);
  }
}

TEST(FlightWorlds, StartOutsideAKeepInIsRefused) {
  Halfspace band[kBoxPlanes];
  box_planes({{-50.0, -50.0, 2.0}, {50.0, 50.0, 3.0}}, band);
  FlightSettings settings;
  settings.fences = {{band, kBoxPlanes, FenceKind::kKeepIn}};
  EXPECT_EQ(Flown(Scene{}, settings).started, Status::kStartFenced);
}

TEST(FlightWorlds, GoalInAnObstacleIsApproached) {
  FlightSettings settings;
  Scene scene;
  scene.cylinders.push_back({10.0, 0.0, 0.5, 5.0});
  Flown flown(scene, settings);
  flown.flight.set_goal({10.0, 0.0, 1.5});
  EXPECT_EQ(flown.fly(60.0), FlightReason::kNearest) << story(flown);
  EXPECT_LT(std::hypot(flown.position().x - 10.0, flown.position().y), 2.0);
}

TEST(FlightWorlds, WalledInItSaysSo) {
  FlightSettings settings;
  Scene scene;
  scene.boxes.push_back({{-3.0, 3.0, 0.0}, {3.0, 3.5, 6.0}});
  scene.boxes.push_back({{-3.0, -3.5, 0.0}, {3.0, -3.0, 6.0}});
  scene.boxes.push_back({{3.0, -3.5, 0.0}, {3.5, 3.5, 6.0}});
  scene.boxes.push_back({{-3.5, -3.5, 0.0}, {-3.0, 3.5, 6.0}});
  Flown flown(scene, settings);
  flown.flight.set_goal({10.0, 0.0, 1.5});
  EXPECT_EQ(flown.fly(120.0), FlightReason::kNearest) << story(flown);
  EXPECT_GT(flown.position().x, 2.0) << story(flown);
}

TEST(FlightWorlds, GoalsMayMoveEveryTickOrMakeNoSense) {
  Random random(960);
  FlightSettings settings;
  settings.v = 5.0;
  Flown flown(forest(random, 30.0, 20.0, 1.0 / 30.0), settings);
  EXPECT_EQ(flown.flight.set_goal({NAN, 0.0, 0.0}), Status::kNonFiniteInput);
  for (int k = 0; k < 1500 && !testing::Test::HasFatalFailure(); ++k) {
    const double far = random.chance(0.2) ? 1e6 : 30.0;
    const Vec3 goal{random.real(-far, far), random.real(-far, far), random.real(-3.0, 6.0)};
    EXPECT_EQ(flown.flight.set_goal(goal), Status::kOk);
    EXPECT_EQ(flown.flight.set_goal({goal.x, INFINITY, goal.z}), Status::kNonFiniteInput);
    flown.tick();
  }
  EXPECT_EQ(flown.flight.set_goal({20.0, 0.0, 1.5}), Status::kOk);
  flown.fly(60.0);
  EXPECT_NE(flown.report.reason, FlightReason::kNone) << story(flown);
}

TEST(FlightWorlds, StopBringsItToRestSoon) {
  Random random(970);
  FlightSettings settings;
  settings.v = 5.0;
  Flown flown(forest(random, 60.0, 20.0, 1.0 / 40.0), settings);
  flown.flight.set_goal({60.0, 0.0, 1.5});
  flown.fly(3.0);
  const double speed = flown.flight.command(flown.time).sample.velocity.x;
  EXPECT_GT(speed, 2.0);
  EXPECT_EQ(flown.flight.stop(), Status::kOk);
  EXPECT_EQ(flown.fly(2.0), FlightReason::kNoGoal) << story(flown);
}

/// Something comes into the tube: the vehicle brakes, and no later than it can.
TEST(FlightWorlds, ThingsThatComeIntoTheWayAreBrakedFor) {
  FlightSettings settings;
  settings.v = 5.0;
  Flown flown(Scene{}, settings);
  flown.flight.set_goal({40.0, 0.0, 1.5});
  flown.fly(2.5);
  const Vec3 p = flown.position();
  flown.scene.cylinders.push_back({p.x + 4.2, 0.0, 0.3, 5.0});
  bool threatened = false;
  for (int k = 0; k < 1500 && !testing::Test::HasFatalFailure(); ++k) {
    flown.tick();
    threatened = threatened || flown.report.mode == FlightMode::kThreat;
  }
  EXPECT_TRUE(threatened);
  EXPECT_EQ(flown.report.reason, FlightReason::kArrived) << story(flown);
}

/// Contract F5: the same input gives the same bits. And F3: how much work a tick may do decides when, not what is safe.
TEST(FlightWorlds, SameInputSameCommands) {
  std::uint64_t hashes[2];
  for (std::uint64_t& hash : hashes) {
    Random random(980);
    Flown flown(forest(random, 20.0, 20.0, 1.0 / 25.0), FlightSettings{});
    flown.flight.set_goal({20.0, 0.0, 1.5});
    EXPECT_EQ(flown.fly(30.0), FlightReason::kArrived);
    hash = flown.hash;
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

/// When the committed plan comes to rest: the first instant with its last position and no speed.
std::int64_t arrival(const Flown& flown) {
  const Vec3 end = flown.flight.rest_position();
  std::int64_t low = flown.time;
  std::int64_t high = flown.time + 60000000000;
  while (high - low > 10) {
    const std::int64_t t = low + (high - low) / 2;
    const Sample s = flown.flight.command(t).sample;
    const bool rests = s.velocity.x == 0.0 && s.velocity.y == 0.0 && s.velocity.z == 0.0 && s.position.x == end.x &&
                       s.position.y == end.y && s.position.z == end.z;
    (rests ? high : low) = t;
  }
  return high;
}

/// Contract F4: on a map that does not change, with a goal that does not, no replan arrives later.
TEST(FlightWorlds, ReplansNeverArriveLater) {
  for (int k = 0; k < tern_test::scaled(8); ++k) {
    Random random(static_cast<std::uint64_t>(990 + k));
    FlightSettings settings;
    settings.v = 5.0;
    settings.assumed = 13.0;
    Flown flown(Scene{}, settings);
    for (int b = 0; b < 12; ++b) {
      const double x = random.real(1.5, 8.0);
      const double y = random.real(-4.0, 4.0);
      const Box box{{x, y, 0.0}, {x + 0.4, y + 0.4, 3.6}};
      ASSERT_EQ(flown.owned.map.mark_box(box), Status::kOk);
      flown.scene.boxes.push_back(box);
    }
    flown.frames = false;
    Vec3 goal{7.5, random.real(-3.0, 3.0), 1.5};
    while (flown.scene.clearance(goal) < 0.7) goal = {random.real(6.0, 8.5), random.real(-3.0, 3.0), 1.5};
    ASSERT_EQ(flown.flight.set_goal(goal), Status::kOk);
    for (int t = 0; t < 30; ++t) flown.tick();
    std::int64_t before = arrival(flown);
    while (flown.time + 20000000 < before && !testing::Test::HasFatalFailure()) {
      flown.tick();
      const std::int64_t after = arrival(flown);
      EXPECT_LE(after, before + 1020) << k << ": " << story(flown);
      before = after;
    }
    EXPECT_EQ(flown.fly(5.0), FlightReason::kArrived) << k << ": " << story(flown);
  }
}

TEST(FlightWorlds, LittleWorkATickStillFliesSafely) {
  Random random(981);
  FlightSettings settings;
  settings.work_per_tick = 1000;
  Flown flown(forest(random, 20.0, 20.0, 1.0 / 30.0), settings);
  flown.flight.set_goal({20.0, 0.0, 1.5});
  flown.fly(60.0);
  EXPECT_NE(flown.report.reason, FlightReason::kNone) << story(flown);
}

}  // namespace
