// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans among more fences than a request takes: clear of all of them, by distances that no plan is made with.
#include "host/fence_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host/session.hpp"
#include "support/random.hpp"

namespace {

using tern_host::FenceRecord;
using tern_host::PlanResult;
using tern_host::Scenario;
using tern_test::Random;

FenceRecord box(const tern::Vec3& lower, const tern::Vec3& upper) {
  FenceRecord record;
  tern::Halfspace planes[tern::kBoxPlanes];
  tern::box_planes({lower, upper}, planes);
  // Zones stand on the ground and have no top: four sides.
  record.planes = {planes, planes + 4};
  record.fence.kind = tern::FenceKind::kKeepOut;
  return record;
}

/// How far a place is from such a box, in plan.
double distance(const FenceRecord& zone, const tern::Vec3& p) {
  double x = 0.0, y = 0.0;
  for (const tern::Halfspace& side : zone.planes) {
    const double beyond = side.normal.x * p.x + side.normal.y * p.y - side.offset;
    double& along = side.normal.x != 0.0 ? x : y;
    along = std::max(along, beyond);
  }
  return std::hypot(x, y);
}

Scenario open_field() {
  return tern_host::parse_scenario(
      "boundary 0 0 0 1000 1000 60\nstart 20 20 30\ngoal 980 980 30\nresolution 5\nradius 1\nv_max 12\na_max 4\n",
      "field");
}

Scenario random_zones(Random& random, int count) {
  Scenario scenario = open_field();
  while (static_cast<int>(scenario.fences.size()) < count) {
    const double x = random.real(0.0, 1000.0), y = random.real(0.0, 1000.0), size = random.real(3.0, 12.0);
    const FenceRecord zone = box({x, y, -1.0}, {x + size, y + size, 100.0});
    if (distance(zone, scenario.start.position) < 10.0 || distance(zone, scenario.goal.position) < 10.0) continue;
    scenario.fences.push_back(zone);
  }
  return scenario;
}

std::string record_refusal(const tern_host::Session& session, const PlanResult& result) {
  try {
    session.record(result);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// The time at which a plan is in a zone while it holds, or a negative one. Seconds of the plan.
double broken_at(const PlanResult& result) {
  const double end = tern::duration(result.trajectory);
  for (int i = 0; i <= 5000; ++i) {
    const double t = end * i / 5000;
    const tern::Vec3 p = tern::evaluate(result.trajectory, t).position;
    for (const FenceRecord& zone : result.scenario.fences) {
      const bool always = zone.fence.from == zone.fence.until;
      const auto now = static_cast<std::int64_t>(t * 1e9);
      const bool holds = always || (now >= zone.fence.from && now <= zone.fence.until);
      if (holds && distance(zone, p) < 1.0 - 1e-6) return t;
    }
  }
  return -1.0;
}

TEST(FenceChoice, PlansKeepClearOfHundredsOfZones) {
  Random random(107);
  const int cases = tern_test::scaled(4);
  tern_host::Session session;
  for (int c = 0; c < cases; ++c) {
    const Scenario scenario = random_zones(random, 500);
    const PlanResult result = session.plan(scenario);
    EXPECT_EQ(result.scenario.fences.size(), 500u);
    ASSERT_TRUE(result.ok()) << "case " << c << ": " << tern::status_name(result.report.status);
    ASSERT_LT(broken_at(result), 0.0) << "case " << c;
  }
}

/// Walls across the way, open at the one end and at the other in turns.
Scenario slalom(int walls) {
  Scenario scenario = open_field();
  scenario.start.position = {20, 500, 30};
  scenario.goal.position = {980, 500, 30};
  for (int i = 0; i < walls; ++i) {
    const double x = 50.0 * (i + 1), y = i % 2 == 0 ? -10.0 : 480.0;
    scenario.fences.push_back(box({x, y, -1.0}, {x + 2.0, y + 530.0, 100.0}));
  }
  return scenario;
}

TEST(FenceChoice, MarksWhatARequestTakesNoMore) {
  const Scenario scenario = slalom(18);
  tern_host::Session session;
  const PlanResult result = session.plan(scenario);
  ASSERT_TRUE(result.ok()) << tern::status_name(result.report.status);
  EXPECT_EQ(result.scenario.marked.size() + tern::kMaxFences, 18u) << "all of them matter";
  EXPECT_EQ(result.scenario.fences.size(), 18u);
  EXPECT_LT(broken_at(result), 0.0);
}

TEST(FenceChoice, ClosesWhatLeavesNoClearTime) {
  Random random(110);
  const int cases = tern_test::scaled(3);
  tern_host::Session session;
  for (int c = 0; c < cases; ++c) {
    Scenario scenario = random_zones(random, 500);
    for (std::size_t i = 0; i < scenario.fences.size(); i += 10) {
      const double from = random.real(-60.0, 60.0);
      scenario.fences[i].fence.from = static_cast<std::int64_t>(from * 1e9);
      scenario.fences[i].fence.until = static_cast<std::int64_t>((from + random.real(200.0, 2000.0)) * 1e9);
    }
    const PlanResult result = session.plan(scenario);
    ASSERT_TRUE(result.ok()) << "case " << c << ": " << tern::status_name(result.report.status);
    EXPECT_LT(broken_at(result), 0.0) << "case " << c;
  }
}

TEST(FenceChoice, GoesAroundALargeZoneForAWhile) {
  // So large that no flood in time finds the way around it. There is only this fence.
  Scenario scenario = tern_host::parse_scenario(
      "boundary -300 -300 0 300 300 120\nstart -250 0 50\ngoal 250 0 50\nresolution 5\nradius 1\ntracking_margin 0.5\n"
      "v_max 10\na_max 3\n",
      "field");
  FenceRecord zone = box({-67.3, -178.2, -1.0}, {67.3, 149.4, 200.0});
  zone.fence.from = -100000000000;
  zone.fence.until = 900000000000;
  scenario.fences = {zone};
  tern_host::Session session;
  const PlanResult result = session.plan(scenario);
  ASSERT_TRUE(result.ok()) << tern::status_name(result.report.status);
  EXPECT_TRUE(tern::is_timed(result.scenario.fences[0].fence)) << "the scenario is as it was given";
  for (int k = 0; k <= 1000; ++k) {
    const tern::Vec3 at = tern::evaluate(result.trajectory, tern::duration(result.trajectory) * k / 1000).position;
    EXPECT_GE(distance(zone, at), 1.5 - 1e-6) << k;
  }
  EXPECT_FALSE(session.record(result).empty());
  // Across the whole boundary, there is no way around.
  scenario.fences[0] = box({-67.3, -400.0, -1.0}, {67.3, 400.0, 200.0});
  scenario.fences[0].fence.from = zone.fence.from;
  scenario.fences[0].fence.until = zone.fence.until;
  const PlanResult none = session.plan(scenario);
  EXPECT_EQ(none.report.status, tern::Status::kNoClearTime);
  EXPECT_EQ(none.report.fence, 0);
  EXPECT_FALSE(session.record(none).empty());
}

TEST(FenceChoice, MarksWhatHoldsForAWhileAsClosed) {
  Scenario scenario = slalom(18);
  for (FenceRecord& wall : scenario.fences) {
    wall.fence.from = -1000000000;
    wall.fence.until = 1000000000000;
  }
  tern_host::Session session;
  const PlanResult result = session.plan(scenario);
  ASSERT_TRUE(result.ok()) << tern::status_name(result.report.status);
  EXPECT_LT(broken_at(result), 0.0);
}

/// One keep-out with a side for each of these directions, all as far from the origin.
FenceRecord around_origin(double first, double step, int sides, double far) {
  FenceRecord record;
  for (int i = 0; i < sides; ++i) {
    const tern::Vec3 n{std::cos(first + i * step), std::sin(first + i * step), 0.0};
    record.planes.push_back({n, far});
  }
  record.fence.kind = tern::FenceKind::kKeepOut;
  return record;
}

TEST(FenceChoice, MarksWhereCornersAreTooMany) {
  // Fewer half-spaces than a request takes, with more corners: a fan of forty sides, and strips below it.
  Scenario scenario = tern_host::parse_scenario(
      "boundary -400 -400 0 400 400 110\nstart -390 -390 20\ngoal 390 390 20\nresolution 4\nradius 0.5\n"
      "v_max 12\na_max 6\n",
      "fan");
  const double step = 6.283185307179586 / 100.0, up = 1.5707963267948966;
  scenario.fences.push_back(around_origin(up - 19.5 * step, step, 40, 200.0));
  scenario.fences[0].planes.push_back({{0.0, -1.0, 0.0}, 0.0});
  for (int i = 0; i < 5; ++i) {
    const double slope = (i + 1) * step;
    FenceRecord strip = around_origin(-slope, 2.0 * up + 2.0 * slope, 2, 200.0);
    strip.planes.push_back({{0.0, 1.0, 0.0}, -2.0 * i});
    strip.planes.push_back({{0.0, -1.0, 0.0}, 2.0 * i + 2.0});
    scenario.fences.push_back(strip);
  }
  ASSERT_FALSE(tern_host::exceeds_capacity(scenario.fences));
  tern_host::Session session;
  const PlanResult result = session.plan(scenario);
  ASSERT_TRUE(result.ok()) << tern::status_name(result.report.status);
  EXPECT_EQ(result.scenario.fences.size(), 6u);
  EXPECT_EQ(record_refusal(session, result),
            std::string("this query cannot be recorded: ") + tern::status_meaning(tern::Status::kFencePlanesFull));
  const double end = tern::duration(result.trajectory);
  for (int i = 0; i <= 2000; ++i) {
    const tern::Vec3 p = tern::evaluate(result.trajectory, end * i / 2000).position;
    for (const FenceRecord& fence : scenario.fences) ASSERT_GE(tern_host::fence_gap(fence, p), 0.5 - 1e-6);
  }
}

TEST(FenceChoice, NumbersFencesAsTheyWereGiven) {
  Random random(108);
  Scenario scenario = random_zones(random, 40);
  scenario.fences.push_back(box({975, 975, -1.0}, {985, 985, 100.0}));
  tern_host::Session session;
  const PlanResult result = session.plan(scenario);
  EXPECT_EQ(result.report.status, tern::Status::kGoalFenced);
  EXPECT_EQ(result.report.fence, 40);
}

TEST(FenceChoice, KnowsWindows) {
  Random random(109);
  Scenario scenario = random_zones(random, 40);
  scenario.rest_clear = 5.0;
  // Across the way at the wrong time, and across it while the plan is there.
  FenceRecord closed = box({490, 400, -1.0}, {510, 600, 100.0});
  closed.fence.from = 1000000000000;
  closed.fence.until = 2000000000000;
  scenario.fences.push_back(closed);
  tern_host::Session session;
  const PlanResult before = session.plan(scenario);
  ASSERT_TRUE(before.ok());
  scenario.fences.back().fence.from = 0;
  const PlanResult after = session.plan(scenario);
  ASSERT_TRUE(after.ok());
  bool passed = false;
  for (int i = 0; i <= 2000; ++i) {
    const double u = static_cast<double>(i) / 2000;
    const tern::Vec3 p = tern::evaluate(before.trajectory, u * tern::duration(before.trajectory)).position;
    const tern::Vec3 q = tern::evaluate(after.trajectory, u * tern::duration(after.trajectory)).position;
    passed = passed || distance(closed, p) < 1.0;
    ASSERT_GE(distance(closed, q), 1.0 - 1e-6);
  }
  EXPECT_TRUE(passed) << "the zone is not in the way";
}

/// Links of 50 m that hold for 10 s each, one second of which they share: 5.5 m/s is neither too fast nor too slow.
TEST(FenceChoice, FliesMoreSlowlyThroughAChain) {
  std::string text = "boundary -20 -20 0 270 20 20\nresolution 1\nradius 0.5\nstart 0 0 5\ngoal 245 0 5\na_max 6\n";
  const int links = 5;
  for (int k = 0; k < links; ++k) {
    text += "keepin " + std::to_string(50 * k - 10) + " -10 0 " + std::to_string(50 * k + 60) + " 10 20 during " +
            std::to_string(k == 0 ? -1 : 9 * k) + " " + std::to_string(k + 1 == links ? 1000 : 9 * k + 10) + "\n";
  }
  tern_host::Session session;
  int slowed = 0;
  for (const int speed : {8, 12, 16, 20}) {
    const Scenario scenario = tern_host::parse_scenario(text + "v_max " + std::to_string(speed) + "\n", "chain");
    const PlanResult result = session.plan(scenario);
    ASSERT_TRUE(result.ok()) << speed;
    EXPECT_EQ(result.scenario.limits.v_max.x, speed);
    EXPECT_LE(result.limits.v_max.x, speed);
    slowed += result.limits.v_max.x < speed ? 1 : 0;
    for (double t = 0.0; t < tern::duration(result.trajectory); t += 0.05) {
      const double x = tern::evaluate(result.trajectory, t).position.x;
      bool is_in = false;
      for (int k = 0; k < links; ++k) {
        const bool holds = t >= (k == 0 ? -1 : 9 * k) && t <= (k + 1 == links ? 1000 : 9 * k + 10);
        is_in = is_in || (holds && x >= 50 * k - 10 && x <= 50 * k + 60);
      }
      ASSERT_TRUE(is_in) << speed << " m/s, " << t << " s, " << x << " m";
    }
  }
  EXPECT_GT(slowed, 0);
}

}  // namespace
