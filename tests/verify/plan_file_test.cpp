// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a plan file says beside its curve: it must be the same curve, for the same request.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "verify/plan.hpp"
#include "verify/world.hpp"

namespace tern_verify {
namespace {

using Json = nlohmann::json;

constexpr const char* kScenario =
    "boundary 0 0 0 10 4 4\nstart 1.1 2 2\ngoal 9.1 2 2\nradius 0.5\nresolution 0.125\ntracking_margin 0.1\n"
    "v_max 2\nv_min 0 0 -1\na_max 3\na_horizontal 4\nj_max 0 0 9\nvia 5 2 2 0.5 stop\n";

Json state(double x) {
  const Json none = {0.0, 0.0, 0.0};
  return {{"position", {x, 2.0, 2.0}}, {"velocity", none}, {"acceleration", none}, {"jerk", none}};
}

Json plan_json() {
  Json relative = Json::array(), world = Json::array();
  for (int i = 0; i < 8; ++i) {
    const double x = i * 0.1;
    relative.push_back({x, 0.0, -1e-17});
    world.push_back({x + 1.1, 2.0, 2.0});
  }
  return {{"format", "tern-plan/1"},
          {"status", "ok"},
          {"resolution", 0.125},
          {"robot_radius", 0.5},
          {"tracking_margin", 0.1},
          {"limits",
           {{"v_max", {2.0, 2.0, 2.0}},
            {"v_min", {-2.0, -2.0, -1.0}},
            {"a_max", {3.0, 3.0, 3.0}},
            {"a_min", {-3.0, -3.0, -3.0}},
            {"a_horizontal", 4.0},
            {"j_max", {0.0, 0.0, 9.0}}}},
          {"start_state", state(1.1)},
          {"goal_state", state(9.1)},
          {"vias", {{{"position", {5.0, 2.0, 2.0}}, {"tolerance", 0.5}, {"stop", true}}}},
          {"origin", {1.1, 2.0, 2.0}},
          {"segments", {{{"duration", 4.0}, {"control_points", world}, {"relative_points", relative}}}}};
}

std::string message(const std::string& text) {
  try {
    require_same_request(parse_problem(kScenario, "s.txt"), parse_plan(text, "p.json"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Why a scenario, or a flight's world, is refused.
template <typename Read>
std::string refusal(Read read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FenceCover, HoldsBoundaryAndClearance) {
  const auto scenario = [](const std::string& more) {
    return refusal([&] { parse_problem("boundary 0 0 0 4 3 2\nstart 1 1 1\ngoal 3 2 1\n" + more, "s.txt"); });
  };
  const auto world = [](const std::string& more, const std::vector<std::string>& settings = {}) {
    return refusal([&] { parse_world("boundary 0 0 0 4 3 2\nstart 1 1 1\ngoal 3 2 1\n" + more, "w.txt", settings); });
  };
  const std::string less = "fences_within 0 0 0 4 3 2 0.3\n", low = "fences_within 0 0 0 4 3 1.5 1\n";
  EXPECT_EQ(scenario(less + "radius 0.1\ntracking_margin 0.2\n"), "");
  EXPECT_EQ(scenario(less + "radius 0.25\ntracking_margin 0.25\n"),
            "s.txt:4: the fences were made for a clearance of 0.3 m, but the flight keeps 0.5 m: zones may be missing");
  EXPECT_EQ(scenario(low),
            "s.txt:4: the boundary reaches beyond the one that the fences were made for: zones may be missing");
  EXPECT_EQ(scenario(less + less), "s.txt:5: 'fences_within' is given twice");
  EXPECT_EQ(world("fences_within 0 0 0 4 3 2 0.35\n"), "") << "body_radius and tracking_margin as they are by default";
  EXPECT_NE(world("fences_within 0 0 0 4 3 2 0.35\n", {"pose_margin=0.2"}).find("a clearance of 0.35 m"),
            std::string::npos);
  EXPECT_NE(world(low).find("w.txt:4: the boundary reaches beyond"), std::string::npos);
}

TEST(PlanFiles, WhatIsMissingIsNamed) {
  EXPECT_NE(message("{").find("p.json: not a plan file"), std::string::npos);
  EXPECT_NE(message(R"({"format": "tern-plan/1", "status": "no_path"})").find("no trajectory"), std::string::npos);
  Json json = plan_json();
  json["segments"][0].erase("relative_points");
  EXPECT_NE(message(json.dump()).find("relative_points"), std::string::npos);
  json = plan_json();
  json.erase("limits");
  EXPECT_NE(message(json.dump()).find("limits"), std::string::npos);
}

TEST(PlanFiles, BothSetsOfControlPointsAreOneCurve) {
  EXPECT_EQ(message(plan_json().dump()), "");
  const std::string refused = "p.json: 'control_points' of a segment are not its 'origin' plus its 'relative_points'";
  Json json = plan_json();
  for (Json& point : json["segments"][0]["control_points"]) point[1] = 12.0;
  EXPECT_EQ(message(json.dump()), refused);
  json = plan_json();
  json["segments"][0]["control_points"][3][0] = std::nextafter(0.1 * 3 + 1.1, 2.0);
  EXPECT_EQ(message(json.dump()), refused);
  json = plan_json();
  json["segments"][0]["control_points"].erase(7);
  EXPECT_EQ(message(json.dump()), refused);
}

TEST(PlanFiles, ThePlanWasMadeForTheScenario) {
  const auto differs = [](const char* const where, const Json& value) {
    Json json = plan_json();
    json[Json::json_pointer(where)] = value;
    const std::string said = message(json.dump());
    const std::string head = "p.json: it differs from s.txt in '";
    return said.rfind(head, 0) == 0 ? said.substr(head.size(), said.size() - head.size() - 1) : said;
  };
  EXPECT_EQ(differs("/resolution", 0.1), "resolution");
  EXPECT_EQ(differs("/frame", {{"latitude", 47.366}, {"longitude", 8.54}}), "frame");
  EXPECT_EQ(differs("/frame", {{"epoch", "2026-03-02T09:00:00Z"}}), "frame");
  EXPECT_EQ(differs("/robot_radius", 0.01), "robot_radius");
  EXPECT_EQ(differs("/tracking_margin", 0.0), "tracking_margin");
  EXPECT_EQ(differs("/limits/v_max/0", 20.0), "limits");
  EXPECT_EQ(differs("/limits/v_min/2", -2.0), "limits");
  EXPECT_EQ(differs("/limits/v_horizontal", 20.0), "limits");
  EXPECT_EQ(differs("/limits/a_horizontal", 40.0), "limits");
  EXPECT_EQ(differs("/limits/j_max/2", 0.0), "limits");
  EXPECT_EQ(differs("/start_state/velocity/1", 1.0), "start_state");
  EXPECT_EQ(differs("/goal_state/position/0", 9.0), "goal_state");
  EXPECT_EQ(differs("/vias/0/stop", false), "vias");
  EXPECT_EQ(differs("/vias/0/velocity", {1.0, 0.0, 0.0}), "vias");
  EXPECT_EQ(differs("/vias", Json::array()), "vias");
  EXPECT_EQ(differs("/start_time", 0), "");
  EXPECT_EQ(differs("/start_time", 1e-10), "") << "whole nanoseconds";
  EXPECT_EQ(differs("/start_time", 1037.747123456),
            "p.json: the plan begins at 1037.747123456 s, s.txt at 0 s: if it should, put 'start_time 1037.747123456' "
            "into the scenario");
}

}  // namespace
}  // namespace tern_verify
