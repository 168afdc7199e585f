// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Missions through unknown worlds: points are passed in order, within their tolerances and with speed, and what cannot
// be reached is left out or ends the mission.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "support/flown.hpp"

namespace {

using namespace tern;
using tern_test::FlightSettings;
using tern_test::Flown;
using tern_test::forest;
using tern_test::Random;
using tern_test::Scene;

Via via(double x, double y, double z, double tolerance = 0.0, bool stop = false) {
  Via point;
  point.position = {x, y, z};
  point.tolerance = tolerance;
  point.stop = stop;
  return point;
}

double gap(const Vec3& a, const Vec3& b) {
  return std::hypot(a.x - b.x, std::hypot(a.y - b.y, a.z - b.z));
}

double speed(const Sample& sample) {
  return std::hypot(sample.velocity.x, std::hypot(sample.velocity.y, sample.velocity.z));
}

/// A flown mission, sampled every half millisecond.
struct Logged {
  Logged(const Scene& scene, const FlightSettings& settings, const std::vector<Via>& way)
      : flown(scene, settings),
        points(way),
        nearest(way.size(), 1e9),
        slowest(way.size(), 1e9),
        speed_there(way.size(), 0.0) {}

  /// Until the vehicle rests for a reason. A point counts as passed only after the samples came within its tolerance,
  /// all points before it done with.
  FlightReason fly(ViaPolicy policy, double seconds) {
    EXPECT_EQ(flown.started, Status::kOk);
    EXPECT_EQ(flown.flight.set_mission(points.data(), static_cast<int32_t>(points.size()), policy), Status::kOk);
    const std::int64_t end = static_cast<std::int64_t>(seconds * 1e9);
    while (flown.time < end && !testing::Test::HasFatalFailure()) {
      const std::int64_t from = flown.time;
      flown.tick();
      look(from);
      check_report(from);
      if (flown.report.mode == FlightMode::kRest && flown.report.reason != FlightReason::kNone) break;
    }
    return flown.report.reason;
  }

  /// Samples of the last tick, for the point that is next.
  void look(std::int64_t from) {
    for (std::int64_t t = from; leg < points.size() && t <= flown.time; t += 500000) {
      const Sample sample = flown.flight.command(t).sample;
      const double away = gap(sample.position, points[leg].position);
      if (away <= reach(leg)) slowest[leg] = std::min(slowest[leg], speed(sample));
      if (away >= nearest[leg]) continue;
      nearest[leg] = away;
      speed_there[leg] = speed(sample);
    }
  }

  /// Several points may be passed in one tick.
  void check_report(std::int64_t from) {
    const bool arrived = flown.report.reason == FlightReason::kArrived;
    EXPECT_EQ(flown.flight.point_state(flown.report.leg) == PointState::kPassed, arrived);
    const std::size_t done = static_cast<std::size_t>(flown.report.leg) + (arrived ? 1 : 0);
    while (leg < done) {
      check_point(leg++);
      look(from);
    }
  }

  /// A tolerance, and what the vehicle flies between two samples.
  double reach(std::size_t i) const { return points[i].tolerance + 1e-9 + 0.0004 * flown.settings.v; }

  void check_point(std::size_t i) {
    const PointState state = flown.flight.point_state(static_cast<int32_t>(i));
    EXPECT_NE(state, PointState::kAhead) << i;
    if (state != PointState::kPassed) return;
    EXPECT_LE(nearest[i], reach(i)) << i;
    EXPECT_LE(slowest[i], points[i].stop ? 0.01 : 1.5 * flown.settings.v) << i;
    ++passed;
  }

  Flown flown;
  std::vector<Via> points;
  std::vector<double> nearest;      ///< while the point was the next one
  std::vector<double> slowest;      ///< of the samples within its tolerance
  std::vector<double> speed_there;  ///< at the nearest sample
  std::size_t leg = 0;
  int passed = 0;
};

TEST(FlightMissions, SpeedCarriesThroughPointsInTheOpen) {
  Logged mission(Scene{}, FlightSettings{},
                 {via(4.0, 0.0, 1.5), via(9.0, 1.0, 1.5, 0.3), via(13.0, 0.0, 1.5), via(18.0, 0.0, 1.5)});
  EXPECT_EQ(mission.fly(ViaPolicy::kEnd, 30.0), FlightReason::kArrived);
  EXPECT_EQ(mission.passed, 4);
  EXPECT_EQ(mission.flown.report.passed, 4);
  EXPECT_EQ(mission.flown.report.skipped, 0);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_GT(mission.speed_there[i], 1.5) << i;
  EXPECT_LT(mission.flown.time, 12000000000);
}

TEST(FlightMissions, StopsAreMade) {
  Logged mission(Scene{}, FlightSettings{}, {via(5.0, 0.0, 1.5, 0.0, true), via(0.0, 0.5, 1.5)});
  EXPECT_EQ(mission.fly(ViaPolicy::kEnd, 30.0), FlightReason::kArrived);
  EXPECT_EQ(mission.passed, 2);
}

TEST(FlightMissions, TheVehicleStaysAtAPointForItsDwell) {
  std::vector<Via> way = {via(3.0, 0.0, 1.5), via(5.0, 0.0, 1.5, 0.2, true), via(5.0, 3.0, 1.5, 0.0, true),
                          via(0.0, 0.5, 1.5)};
  way[1].dwell = 15.0;  // longer than a vehicle may stand still before it looks for a way on
  way[2].dwell = 0.5;
  Logged mission(Scene{}, FlightSettings{}, way);
  std::int64_t rested[4] = {}, longest[4] = {};  // at each point, while it was the next one
  ASSERT_EQ(mission.flown.flight.set_mission(way.data(), 4, ViaPolicy::kEnd), Status::kOk);
  while (mission.flown.time < 60000000000 && mission.flown.report.reason != FlightReason::kArrived) {
    mission.flown.tick();
    const auto leg = static_cast<std::size_t>(mission.flown.report.leg);
    const Sample sample = mission.flown.flight.command(mission.flown.time).sample;
    const bool rests = speed(sample) == 0.0 && gap(sample.position, way[leg].position) <= way[leg].tolerance + 1e-9;
    rested[leg] = rests ? rested[leg] + 10000000 : 0;
    longest[leg] = std::max(longest[leg], rested[leg]);
  }
  EXPECT_EQ(mission.flown.report.reason, FlightReason::kArrived);
  EXPECT_EQ(mission.flown.report.passed, 4);
  EXPECT_LT(longest[0], 20000000) << "passed at speed";
  for (const std::size_t k : {1, 2}) {
    EXPECT_GE(longest[k], static_cast<std::int64_t>(1e9 * way[k].dwell) - 20000000) << k;
    EXPECT_LE(longest[k], static_cast<std::int64_t>(1e9 * way[k].dwell) + 300000000) << k;
  }
}

TEST(FlightMissions, ForestsAreCrossed) {
  for (int k = 0; k < tern_test::scaled(6); ++k) {
    Random random(static_cast<std::uint64_t>(1700 + k));
    FlightSettings settings;
    settings.v = k % 2 == 0 ? 3.0 : 5.0;
    const Scene scene = forest(random, 24.0, 20.0, 1.0 / 30.0);
    std::vector<Via> way;
    for (double x = 4.0; x < 24.0; x += 4.0) {
      Via point = via(x, 0.0, 1.5, k % 3 == 0 ? 0.0 : 0.4);
      do {
        point.position.y = random.real(-4.0, 4.0);
      } while (scene.clearance(point.position) < 0.9);
      way.push_back(point);
    }
    way.push_back(via(24.0, 0.0, 1.5));
    Logged mission(scene, settings, way);
    EXPECT_EQ(mission.fly(ViaPolicy::kEnd, 90.0), FlightReason::kArrived)
        << k << ": leg " << mission.leg << " at " << mission.flown.position().x << " " << mission.flown.position().y;
    EXPECT_EQ(mission.passed, static_cast<int>(way.size())) << k;
  }
}

Scene tree_at(double x, double y) {
  Scene scene;
  scene.cylinders.push_back({x, y, 0.4, 6.0});
  return scene;
}

TEST(FlightMissions, BlockedPointIsSkipped) {
  Logged mission(tree_at(8.0, 0.0), FlightSettings{},
                 {via(4.0, 0.0, 1.5), via(8.0, 0.2, 1.5), via(12.0, 1.0, 1.5), via(15.0, 0.0, 1.5)});
  EXPECT_EQ(mission.fly(ViaPolicy::kSkip, 40.0), FlightReason::kArrived);
  EXPECT_EQ(mission.flown.flight.point_state(1), PointState::kSkipped);
  EXPECT_EQ(mission.passed, 3);
  EXPECT_EQ(mission.flown.report.skipped, 1);
}

TEST(FlightMissions, BlockedPointEndsTheMission) {
  Logged mission(tree_at(8.0, 0.0), FlightSettings{}, {via(4.0, 0.0, 1.5), via(8.0, 0.2, 1.5), via(12.0, 1.0, 1.5)});
  EXPECT_EQ(mission.fly(ViaPolicy::kEnd, 40.0), FlightReason::kViaBlocked);
  EXPECT_EQ(mission.passed, 1);
  EXPECT_EQ(mission.flown.report.leg, 1);
  EXPECT_EQ(speed(mission.flown.flight.command(mission.flown.time).sample), 0.0);
}

/// A point in a closed room that the sensor cannot look into.
Scene closed_room() {
  Scene scene;
  scene.boxes.push_back({{6.0, -2.0, 0.0}, {6.3, 2.0, 4.0}});
  scene.boxes.push_back({{9.7, -2.0, 0.0}, {10.0, 2.0, 4.0}});
  scene.boxes.push_back({{6.0, -2.0, 0.0}, {10.0, -1.7, 4.0}});
  scene.boxes.push_back({{6.0, 1.7, 0.0}, {10.0, 2.0, 4.0}});
  return scene;
}

TEST(FlightMissions, PointWithoutAWayIsSkippedOrEndsTheMission) {
  const std::vector<Via> way{via(4.0, 0.0, 1.5), via(8.0, 0.0, 1.5), via(4.0, 3.0, 1.5), via(0.0, 3.0, 1.5)};
  Logged skips(closed_room(), FlightSettings{}, way);
  EXPECT_EQ(skips.fly(ViaPolicy::kSkip, 200.0), FlightReason::kArrived);
  EXPECT_EQ(skips.flown.flight.point_state(1), PointState::kSkipped);
  EXPECT_EQ(skips.passed, 3);
  Logged ends(closed_room(), FlightSettings{}, way);
  EXPECT_EQ(ends.fly(ViaPolicy::kEnd, 200.0), FlightReason::kViaUnreachable);
  EXPECT_EQ(ends.passed, 1);
}

/// A point is as blocked by the tracking margin as by the body. 3/8 and 1/8 add up in doubles without rounding.
TEST(FlightMissions, TheTrackingMarginBlocksAPointAsTheBodyDoes) {
  const auto flown = [](double margin) {
    FlightSettings settings;
    settings.radius = 0.375;
    settings.margin = margin;
    Scene scene;
    scene.boxes = {{{7.9, -0.1, -1.0}, {8.1, 0.1, 10.0}}};
    auto mission = std::make_unique<Logged>(
        scene, settings, std::vector<Via>{via(4.0, 0.5, 1.5), via(8.0, 0.5, 1.5), via(12.0, 0.5, 1.5)});
    EXPECT_EQ(mission->fly(ViaPolicy::kSkip, 60.0), FlightReason::kArrived);
    EXPECT_EQ(mission->flown.flight.point_state(1), PointState::kSkipped);
    return mission;
  };
  const auto body = flown(0.0);
  const auto both = flown(0.125);
  EXPECT_EQ(both->flown.time, body->flown.time);
  EXPECT_EQ(both->flown.report.committed, body->flown.report.committed);
}

TEST(FlightMissions, FencedPointIsSkipped) {
  Halfspace out[kBoxPlanes];
  box_planes({{7.0, -1.0, -5.0}, {9.0, 1.0, 20.0}}, out);
  FlightSettings settings;
  settings.fences = {{out, kBoxPlanes, FenceKind::kKeepOut}};
  Logged mission(Scene{}, settings, {via(4.0, 0.0, 1.5), via(8.0, 0.0, 1.5), via(12.0, 0.0, 1.5)});
  EXPECT_EQ(mission.fly(ViaPolicy::kSkip, 40.0), FlightReason::kArrived);
  EXPECT_EQ(mission.passed, 2);
  EXPECT_EQ(mission.flown.report.skipped, 1);
}

/// Points anywhere, also in trees; some are skipped, and in the end the vehicle rests for a reason.
TEST(FlightMissions, RandomMissionsEndWithAReason) {
  int passed = 0;
  int skipped = 0;
  for (int k = 0; k < tern_test::scaled(6) && !HasFatalFailure(); ++k) {
    Random random(static_cast<std::uint64_t>(1750 + k));
    FlightSettings settings;
    settings.v = random.real(2.0, 6.0);
    const Scene scene = forest(random, 20.0, 16.0, 1.0 / 12.0);
    std::vector<Via> way;
    for (int i = random.integer(2, 6); i > 0; --i) {
      way.push_back(via(random.real(2.0, 19.0), random.real(-6.0, 6.0), random.real(0.2, 2.6),
                        random.chance(0.5) ? random.real(0.0, 0.6) : 0.0, random.chance(0.2)));
    }
    way.push_back(via(20.0, 0.0, 1.5));
    Logged mission(scene, settings, way);
    const FlightReason reason = mission.fly(k % 4 == 3 ? ViaPolicy::kEnd : ViaPolicy::kSkip, 240.0);
    EXPECT_NE(reason, FlightReason::kNone) << k << ": leg " << mission.leg;
    EXPECT_TRUE(k % 4 == 3 || reason == FlightReason::kArrived) << k << ": leg " << mission.leg;
    passed += mission.flown.report.passed;
    skipped += mission.flown.report.skipped;
  }
  EXPECT_GT(passed, tern_test::scaled(6));
  EXPECT_GE(skipped, tern_test::scaled(6) / 3);  // a part of the missions may have none
}

/// As many points as there may be, some of them twice, and one where the vehicle is.
TEST(FlightMissions, LongestMissionEnds) {
  std::vector<Via> way;
  for (int i = 0; i < kMaxMissionPoints; ++i) way.push_back(via(2.0 * (i / 2), i % 4 < 2 ? 0.0 : 1.5, 1.5, 0.2));
  Logged mission(Scene{}, FlightSettings{}, way);
  EXPECT_EQ(mission.fly(ViaPolicy::kEnd, 90.0), FlightReason::kArrived);
  EXPECT_EQ(mission.flown.report.passed, kMaxMissionPoints);
}

TEST(FlightMissions, NewMissionReplacesTheOldOne) {
  Logged mission(Scene{}, FlightSettings{}, {via(6.0, 0.0, 1.5), via(12.0, 0.0, 1.5)});
  mission.fly(ViaPolicy::kEnd, 1.5);
  EXPECT_EQ(mission.flown.report.mode, FlightMode::kFly);
  ASSERT_EQ(mission.flown.flight.set_goal({0.0, 2.0, 1.5}), Status::kOk);
  EXPECT_EQ(mission.flown.fly(30.0), FlightReason::kArrived);
  EXPECT_EQ(mission.flown.report.passed, 1);
  EXPECT_NEAR(mission.flown.position().y, 2.0, 1e-9);
}

TEST(FlightMissions, WrongMissionsAreRefused) {
  Flown flown(Scene{}, FlightSettings{});
  const Via good = via(3.0, 0.0, 1.5);
  EXPECT_EQ(Flight{}.set_mission(&good, 1, ViaPolicy::kEnd), Status::kInvalidArgument);
  EXPECT_EQ(flown.flight.set_mission(nullptr, 1, ViaPolicy::kEnd), Status::kInvalidArgument);
  EXPECT_EQ(flown.flight.set_mission(&good, 0, ViaPolicy::kEnd), Status::kInvalidArgument);
  EXPECT_EQ(flown.flight.set_mission(&good, 1, static_cast<ViaPolicy>(2)), Status::kInvalidArgument);
  const auto refused = [&flown, &good](const Via& point) {
    const Via points[2] = {point, good};
    return flown.flight.set_mission(points, 2, ViaPolicy::kEnd);
  };
  const std::vector<Via> many(kMaxMissionPoints + 1, good);
  EXPECT_EQ(flown.flight.set_mission(many.data(), kMaxMissionPoints + 1, ViaPolicy::kEnd), Status::kViasFull);
  Via bad = via(3.0, 0.0, 1.5, -0.1);
  EXPECT_EQ(refused(bad), Status::kInvalidArgument);
  bad = good;
  bad.has_velocity = true;
  EXPECT_EQ(refused(bad), Status::kInvalidArgument);
  EXPECT_EQ(flown.flight.set_mission(&bad, 1, ViaPolicy::kEnd), Status::kInvalidArgument) << "the goal, too";
  bad = good;
  bad.dwell = 1.0;
  EXPECT_EQ(refused(bad), Status::kInvalidArgument) << "without a stop";
  bad.stop = true;
  EXPECT_EQ(refused(bad), Status::kOk);
  bad.dwell = -1.0;
  EXPECT_EQ(refused(bad), Status::kInvalidArgument);
  bad.dwell = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refused(bad), Status::kNonFiniteInput);
  bad = via(std::numeric_limits<double>::quiet_NaN(), 0.0, 1.5);
  EXPECT_EQ(refused(bad), Status::kNonFiniteInput);
  ASSERT_EQ(flown.flight.stop(), Status::kOk);
  EXPECT_EQ(flown.fly(0.2), FlightReason::kNoGoal);
  EXPECT_EQ(flown.flight.point_state(-1), PointState::kAhead);
}

}  // namespace
