// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plan files say what was planned, to the last bit, in the world frame.
#include "host/plan_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "host/closed_way.hpp"
#include "host/figures.hpp"
#include "host/finding_text.hpp"
#include "host/peaks.hpp"
#include "support/random.hpp"

namespace {

using nlohmann::json;
using tern::Status;
using tern_host::PlanResult;

std::uint64_t bits(double value) {
  std::uint64_t word;
  std::memcpy(&word, &value, sizeof word);
  return word;
}

/// A result with awkward numbers in every place; not a plan that any planner would make.
PlanResult awkward_result(std::uint64_t seed) {
  tern_test::Random random(seed);
  const auto number = [&random] { return random.real(-1.0, 1.0) * std::pow(10.0, random.integer(-12, 6)); };
  const auto vec = [&number] { return tern::Vec3{number(), number(), number()}; };
  PlanResult result;
  result.scenario.name = "maps/\"odd\" name.txt";
  result.scenario.resolution = 0.1;
  result.scenario.start = {vec(), vec(), vec()};
  result.scenario.goal = {vec(), vec(), vec()};
  result.grid.origin = vec();
  result.report.status = Status::kOk;
  result.report.quality = tern::Quality::kOptimised;
  result.report.diagnostics.stages[static_cast<int>(tern::Stage::kTrajectory)].work = 17;
  result.report.diagnostics.stages[static_cast<int>(tern::Stage::kSearch)].work = 4321;
  result.timing.inflate = 1.5;
  result.timing.stages[static_cast<int>(tern::Stage::kCheck)] = 2.25;
  result.path = std::make_unique<tern::Path>();
  result.path->raw_count = 3;
  result.path->count = 2;
  for (int i = 0; i < 3; ++i) result.path->raw[i] = vec();
  for (int i = 0; i < 2; ++i) result.path->points[i] = vec();
  result.corridor = std::make_unique<tern::Corridor>();
  result.corridor->count = 1;
  result.corridor->polyhedra[0].count = 2;
  for (int i = 0; i < 2; ++i) result.corridor->polyhedra[0].planes[i] = {vec(), number()};
  result.trajectory.count = 2;
  result.trajectory.origin = result.grid.origin;
  for (int s = 0; s < 2; ++s) {
    result.trajectory.segments[s].duration = 0.1 + std::fabs(number());
    for (tern::Vec3& point : result.trajectory.segments[s].points) point = vec();
  }
  return result;
}

void expect_bits(const json& array, const tern::Vec3& v) {
  ASSERT_EQ(array.size(), 3u);
  EXPECT_EQ(bits(array[0].get<double>()), bits(v.x));
  EXPECT_EQ(bits(array[1].get<double>()), bits(v.y));
  EXPECT_EQ(bits(array[2].get<double>()), bits(v.z));
}

tern::Vec3 sum(const tern::Vec3& a, const tern::Vec3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

TEST(PlanFile, NumbersReadBackToTheSameBits) {
  for (int seed = 0; seed < tern_test::scaled(200); ++seed) {
    const PlanResult result = awkward_result(static_cast<std::uint64_t>(seed));
    const json plan = json::parse(tern_host::plan_json(result));
    const tern::Vec3& origin = result.grid.origin;
    expect_bits(plan["start_state"]["velocity"], result.scenario.start.velocity);
    expect_bits(plan["goal_state"]["acceleration"], result.scenario.goal.acceleration);
    for (int i = 0; i < 3; ++i) expect_bits(plan["search"]["jps_path"][i], sum(result.path->raw[i], origin));
    for (int i = 0; i < 2; ++i) expect_bits(plan["search"]["path"][i], sum(result.path->points[i], origin));
    for (int s = 0; s < 2; ++s) {
      const tern::Segment& segment = result.trajectory.segments[s];
      EXPECT_EQ(bits(plan["segments"][s]["duration"].get<double>()), bits(segment.duration));
      for (int p = 0; p < tern::kControlPoints; ++p) {
        expect_bits(plan["segments"][s]["control_points"][p], sum(segment.points[p], origin));
      }
    }
    EXPECT_EQ(bits(plan["cost"]["snap"].get<double>()), bits(tern::snap_cost(result.trajectory)));
  }
}

TEST(PlanFile, HasEveryPartOfTheFormat) {
  const json plan = json::parse(tern_host::plan_json(awkward_result(1)));
  EXPECT_EQ(plan["format"], "tern-plan/1");
  EXPECT_EQ(plan["status"], "ok");
  EXPECT_EQ(plan["detail"], "");
  EXPECT_EQ(plan["scenario"], "maps/\"odd\" name.txt");
  EXPECT_EQ(plan["robot_radius"], 0.25);
  EXPECT_EQ(plan["start_time"], 0.0);
  EXPECT_EQ(plan["tracking_margin"], 0.0);
  EXPECT_EQ(plan["limits"]["v_max"], json({2.0, 2.0, 2.0}));
  EXPECT_EQ(plan["limits"]["v_min"], json({-2.0, -2.0, -2.0}));
  EXPECT_FALSE(plan["limits"].contains("v_horizontal"));
  EXPECT_EQ(plan["search"]["work"], 4321);
  EXPECT_EQ(plan["corridor"].size(), 1u);
  EXPECT_EQ(plan["qp"]["work"], 17);
  for (const char* stage : {"inflate", "search", "shortcut", "corridor", "time_allocation", "optimization", "check",
                            "world", "detour", "previous", "stop_first", "reach"}) {
    EXPECT_TRUE(plan["timing_us"][stage].is_number()) << stage;
  }
  EXPECT_EQ(plan["timing_us"]["total"], 3.75);
}

TEST(PlanFile, HalfspacesMoveWithTheOrigin) {
  PlanResult result = awkward_result(2);
  result.grid.origin = {10.0, -20.0, 0.5};
  result.corridor->polyhedra[0].planes[0] = {{0.6, 0.0, 0.8}, 1.0};
  const json plan = json::parse(tern_host::plan_json(result));
  // The local point (0, 0, 1.25) lies on the plane; so must its world position (10, -20, 1.75).
  EXPECT_NEAR(plan["corridor"][0]["halfspaces"][0][3].get<double>(), 0.6 * 10.0 + 0.8 * 1.75, 1e-12);
}

TEST(PlanFile, FailureCarriesStatusDetailAndThePartsReached) {
  PlanResult result = awkward_result(3);
  result.report.status = Status::kGoalOccupied;
  result.report.stage = tern::Stage::kSearch;
  result.report.field = tern::Field::kGoalPosition;
  result.report.has_nearest_free = true;
  result.report.nearest_free = {1.5, 2.5, 3.5};
  result.path.reset();
  result.corridor.reset();
  const json plan = json::parse(tern_host::plan_json(result));
  EXPECT_EQ(plan["format"], "tern-plan/1");
  EXPECT_EQ(plan["status"], "goal_occupied");
  const std::string detail = plan["detail"];
  EXPECT_NE(detail.find("goal position"), std::string::npos) << detail;
  EXPECT_NE(detail.find("(1.5, 2.5, 3.5)"), std::string::npos) << detail;
  EXPECT_NE(detail.find("too close"), std::string::npos) << detail;
  for (const char* part : {"search", "corridor", "segments", "cost", "qp", "check"})
    EXPECT_FALSE(plan.contains(part)) << part;
}

TEST(PlanFile, SaysHowNearItComesToAGoalThatCannotBePlannedTo) {
  const std::string text = "boundary 0 0 0 6 3 2\nblock 3 0 0 3.2 3 2\nstart 1 1 1\ngoal 5 1.02 1.02\n";
  tern_host::Session session;
  const json exact = json::parse(tern_host::plan_json(session.plan(tern_host::parse_scenario(text, "walled"))));
  EXPECT_EQ(exact["status"], "no_path");
  EXPECT_NEAR(exact["reachable"][0].get<double>(), 2.65, 1e-12);
  EXPECT_NE(exact["detail"].get<std::string>().find("a path comes as near as (2.65, 1.05, 1.05)"), std::string::npos)
      << exact["detail"];
  EXPECT_FALSE(exact.contains("goal_missed"));
  const tern_host::PlanResult near = session.plan(tern_host::parse_scenario(text + "goal_mode nearest\n", "walled"));
  const json nearest = json::parse(tern_host::plan_json(near));
  EXPECT_EQ(nearest["status"], "ok");
  EXPECT_EQ(nearest["goal_missed"], "no_path");
  EXPECT_EQ(nearest["reachable"], exact["reachable"]);
  EXPECT_EQ(nearest["detail"].get<std::string>().rfind("not at the goal but at (2.65, 1.05, 1.05)", 0), 0u);
}

/// A wall with a slit, the robot's radius 0.25 m: of 0.54 m, which voxels of 0.1 m close, of 0.43 m, or none; or a
/// fence.
TEST(PlanFile, SaysWhatWouldOpenAClosedWay) {
  const std::string ends = "boundary 0 0 0 6 4 2\nstart 1 2 1\ngoal 5 2 1\nradius 0.25\n";
  const std::string wall = ends + "block 2.9 0 0 3.1 1.77 2\n";
  const std::pair<std::string, std::string> cases[] = {
      {wall + "block 2.9 2.31 0 3.1 4 2\n", "a resolution of 0.025 m opens it"},
      {wall + "block 2.9 2.2 0 3.1 4 2\n", "radius and tracking margin together may be 0.099 m"},
      {wall + "block 2.9 1.77 0 3.1 4 2\n", "close every way at this resolution, even for a point"},
      {ends + "keepout_halfspaces 1 0 0 3.1 -1 0 0 -2.9\n", "without the geofences there is a way"}};
  tern_host::Session session;
  for (const auto& [text, says] : cases) {
    const tern_host::Scenario scenario = tern_host::parse_scenario(text, "closed");
    PlanResult result = session.plan(scenario);
    ASSERT_EQ(result.report.status, Status::kNoPath) << text;
    result.closed_way = tern_host::describe_closed_way(scenario);
    const std::string detail = json::parse(tern_host::plan_json(result))["detail"];
    EXPECT_NE(detail.find(says), std::string::npos) << detail;
  }
  const std::string finer = cases[0].first + "resolution 0.025\n";
  EXPECT_TRUE(session.plan(tern_host::parse_scenario(finer, "open")).ok());
}

TEST(PlanFile, HasTheViasAndTheirPassages) {
  PlanResult result = awkward_result(18);
  result.scenario.vias = {{{1, 2, 3}, 0.25, false, false, {}}, {{4, 5, 6}, 0.0, false, true, {0.5, 0, -1}}};
  result.report.vias[0] = {1.5, 0.125};
  result.report.vias[1] = {2.5, 0.0};
  const json plan = json::parse(tern_host::plan_json(result));
  ASSERT_EQ(plan["vias"].size(), 2u);
  EXPECT_EQ(plan["vias"][0]["position"], json({1, 2, 3}));
  EXPECT_EQ(plan["vias"][0]["tolerance"], 0.25);
  EXPECT_EQ(plan["vias"][0]["time"], 1.5);
  EXPECT_EQ(plan["vias"][0]["distance"], 0.125);
  EXPECT_FALSE(plan["vias"][0].contains("velocity"));
  EXPECT_EQ(plan["vias"][1]["velocity"], json({0.5, 0, -1}));
  result.report.status = Status::kNoPath;
  result.report.via = 1;
  const json failed = json::parse(tern_host::plan_json(result));
  EXPECT_FALSE(failed["vias"][0].contains("time"));
  EXPECT_NE(failed["detail"].get<std::string>().find("via: number 2"), std::string::npos);
}

TEST(PlanFile, SaysWhatTheCheckFound) {
  PlanResult result = awkward_result(5);
  result.report.quality = tern::Quality::kStopAndGo;
  result.report.optimiser = Status::kCheckFailed;
  tern::ProofReport& check = result.report.check;
  check.finding = tern::Finding::kObstacle;
  check.until = 2.5;
  check.segment = 2;
  check.voxel = {20, 9, 0};
  check.excess = 0.125;
  const json plan = json::parse(tern_host::plan_json(result));
  const std::string detail = plan["detail"];
  const char* const words = "segment 2 is too near to the obstacle in voxel (20, 9, 0) from 2.5 s on, by 0.125 m";
  EXPECT_NE(detail.find(words), std::string::npos) << detail;
  EXPECT_EQ(plan["check"]["finding"], "obstacle");
  EXPECT_EQ(plan["check"]["segment"], 2);
  EXPECT_EQ(plan["check"]["time"], 2.5);
  EXPECT_EQ(plan["check"]["voxel"], json({20, 9, 0}));
  EXPECT_EQ(plan["check"]["excess"], 0.125);
  EXPECT_TRUE(plan["check"]["fence"].is_null());
}

TEST(PlanFile, SaysThatAnArrivalIsNoStopAndGo) {
  PlanResult result = awkward_result(5);
  result.report.quality = tern::Quality::kStopAndGo;
  result.report.optimiser = Status::kOk;
  const std::string detail = json::parse(tern_host::plan_json(result))["detail"];
  EXPECT_NE(detail.find("into the goal's motion"), std::string::npos) << detail;
  EXPECT_EQ(detail.find("stop to stop"), std::string::npos) << detail;
  EXPECT_EQ(detail.find("ended with"), std::string::npos) << detail;
}

/// The clause for a finding about a derivative of segment 3.
std::string clause(tern::Finding finding, int derivative, int axis) {
  tern::ProofReport check;
  check.finding = finding;
  check.segment = 3;
  check.derivative = derivative;
  check.axis = axis;
  check.excess = 0.5;
  return tern_host::describe_finding(check);
}

TEST(PlanFile, FindingsInWords) {
  EXPECT_EQ(clause(tern::Finding::kVelocity, 1, 3),
            "velocity of segment 3 in the horizontal norm is beyond its limit by 0.5 m/s");
  EXPECT_EQ(clause(tern::Finding::kJoint, 3, 2),
            "jerk of segment 3 on the z axis jumps from the segment before by 0.5 m/s^3");
  EXPECT_EQ(clause(tern::Finding::kBoundary, 0, 0),
            "position of segment 3 on the x axis misses the state that was asked for by 0.5 m");
  EXPECT_EQ(clause(tern::Finding::kOutside, -1, 1),
            "segment 3 is outside the boundary on the y axis from 0 s on, by 0.5 m");
  EXPECT_EQ(clause(tern::Finding::kMalformed, -1, -1), "segment 3 is malformed");
  tern::ProofReport met;
  met.finding = tern::Finding::kTrack;
  met.segment = 3;
  met.track = 0;
  tern_host::TrackRecord man;
  man.id = "man";
  EXPECT_EQ(tern_host::describe_finding(met), "segment 3 is too near to track 1 from 0 s on, by 0 m");
  EXPECT_EQ(tern_host::describe_finding(met, {}, {man}), "segment 3 is too near to man from 0 s on, by 0 m");
  EXPECT_EQ(tern_host::describe_finding({}), "");
}

TEST(PlanFile, SaysUntilWhenTheStartIsClosed) {
  // Two zones that the start is in, one after the other, and one that is elsewhere.
  const std::string map =
      "boundary 0 0 0 40 40 10\nstart 5 5 5\ngoal 35 35 5\nresolution 0.5\nradius 0.5\n"
      "keepout_halfspaces -1 0 0 -2 1 0 0 8 0 -1 0 -2 0 1 0 8 during -10 60 1 zone Market\n"
      "keepout_halfspaces -1 0 0 -2 1 0 0 8 0 -1 0 -2 0 1 0 8 during 50 90.5 zone Fair\n"
      "keepout_halfspaces -1 0 0 -30 0 1 0 10 during 0 500 zone Port\n";
  tern_host::Session session;
  const auto detail = [&](const std::string& more) {
    const tern_host::PlanResult result = session.plan(tern_host::parse_scenario(map + more, "map.txt"));
    return result.ok() ? "" : describe_status(result);
  };
  const std::string closed = detail("epoch 2026-03-02T09:00:00Z\n");
  EXPECT_NE(closed.find("(Market), 0 s after the beginning; it is closed until 61.000 s of the clock "
                        "(2026-03-02T09:01:01Z); the start is in it: it is free at 90.500 s of the clock "
                        "(2026-03-02T09:01:30.500Z). Begin then (start_time 90.5), or elsewhere"),
            std::string::npos)
      << closed;
  EXPECT_NE(detail("epoch 2026-03-02T09:00:00.3Z\n").find("90.500 s of the clock (2026-03-02T09:01:30.800Z)"),
            std::string::npos);
  EXPECT_NE(detail("start_time 90.4\n").find("start_time 90.5)"), std::string::npos);
  EXPECT_EQ(detail("start_time 90.5\n"), "") << "a plan, after all";
  const std::string late = "keepout_halfspaces -1 0 0 -2 1 0 0 8 0 -1 0 -2 0 1 0 8 during 80 1234567890.0121\n";
  EXPECT_NE(detail(late).find("it is free at 1234567890.013 s of the clock. Begin then (start_time 1234567890.013)"),
            std::string::npos)
      << detail(late);
}

TEST(PlanFile, InvalidUtf8InANameStaysJson) {
  PlanResult result = awkward_result(4);
  result.scenario.name = "bad\xff.txt";
  EXPECT_TRUE(json::accept(tern_host::plan_json(result)));
}

}  // namespace
