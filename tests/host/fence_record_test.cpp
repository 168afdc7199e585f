// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geofences of files: how they are read, how far a point is from them, and that simulated flights respect them.
#include "host/fence_record.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host/finding_text.hpp"
#include "host/flight/flight_world.hpp"
#include "host/flight/full_knowledge.hpp"
#include "host/flight/simulated_flight.hpp"
#include "host/nearest_fence.hpp"
#include "host/plan_file.hpp"
#include "host/scenario.hpp"
#include "support/own_folder.hpp"

namespace {

using tern::FenceKind;
using tern_host::add_fence;
using tern_host::FenceRecord;
using tern_host::FlightWorld;

const tern_host::Place kPlace{"world.txt", 7};

FenceRecord fence_of(const std::string& line) {
  std::vector<FenceRecord> fences;
  add_fence(tern_host::split_words(line, false), kPlace, fences);
  return fences.at(0);
}

std::string fence_error(const std::string& line) {
  try {
    fence_of(line);
  } catch (const tern_host::RecordError& error) {
    return error.what();
  }
  return "";
}

TEST(FenceRecord, MayHaveAName) {
  const auto end_of = [](const std::string& line) {
    tern_host::Words words = tern_host::split_words(line, false);
    const tern_host::FenceEnd end = tern_host::take_end(kPlace, words);
    return std::make_pair(end, words.size());
  };
  EXPECT_EQ(end_of("keepout 0 0 0 1 1 1").first.zone, "");
  const auto [named, left] = end_of("keepin_halfspaces 1 0 0 2 during 3 4 zone Closed during  events");
  EXPECT_EQ(named.zone, "Closed during events");
  EXPECT_EQ(named.from, 3000000000);
  EXPECT_EQ(named.until, 4000000000);
  EXPECT_EQ(left, 5u);
  EXPECT_THROW(end_of("keepout 0 0 0 1 1 1 zone"), tern_host::RecordError);
  for (const char* times : {"3 4", "-100 1e999 0.5", "5"}) {
    EXPECT_THROW(end_of(std::string("keepin 0 0 0 1 1 1 zone Lake during ") + times), tern_host::RecordError) << times;
  }

  const tern_host::Scenario scenario = tern_host::parse_scenario(
      "boundary 0 0 0 9 9 9\nstart 1 1 1\ngoal 8 8 8\nkeepin 0 0 0 9 9 9 zone City\nkeepout_halfspaces -1 0 0 -8 "
      "during 3 4 "
      "0.5 zone Old town\nkeepout 3 3 3 4 4 4 zone Tower\nkeepout 5 5 5 6 6 6 during 1 2 zone Crane\n",
      "map.txt");
  ASSERT_EQ(scenario.fences.size(), 2u);
  EXPECT_EQ(tern_host::zone_text(scenario.fences, 0), " (City)");
  EXPECT_EQ(tern_host::zone_text(scenario.fences, 1), " (Old town)");
  EXPECT_EQ(tern_host::zone_text(scenario.fences, tern::kNoFence), "");
  EXPECT_EQ(scenario.blocks.size(), 1u);
  EXPECT_EQ(scenario.tracks.size(), 1u);
}

TEST(FenceRecord, NamesAreInMessages) {
  const std::string map = "boundary 0 0 0 9 9 9\ngoal 8 8 8\n";
  tern_host::Session session;
  const tern_host::PlanResult inside = session.plan(
      tern_host::parse_scenario(map + "start 1 1 1\nkeepout_halfspaces 1 0 0 2 zone Old town\n", "map.txt"));
  EXPECT_EQ(inside.report.status, tern::Status::kStartFenced);
  EXPECT_NE(describe_status(inside).find("; fence: number 1 of the request (Old town)"), std::string::npos)
      << describe_status(inside);
  tern::ProofReport check;
  check.finding = tern::Finding::kFence;
  check.segment = 2;
  check.fence = 0;
  EXPECT_EQ(describe_finding(check, inside.scenario.fences), "segment 2 breaks fence 1 (Old town) from 0 s on, by 0 m");
  EXPECT_EQ(nlohmann::json(fence_json(inside.scenario.fences[0]))["zone"], "Old town");

  // A straight line from x = 4 on; the second fence is over before.
  const tern_host::PlanResult plan = session.plan(tern_host::parse_scenario(
      map + "start 4 8 8\nstart_time 20\nkeepout_halfspaces 1 0 0 1 zone Old town\nkeepout_halfspaces 1 0 0 2 during 1 "
            "2\nkeepin -2 -2 -2 12 12 12\n",
      "map.txt"));
  ASSERT_TRUE(plan.ok());
  const tern_host::NearestFence nearest = nearest_fence(plan.trajectory, plan.scenario);
  EXPECT_EQ(nearest.index, 0);
  EXPECT_NEAR(nearest.gap, 3.0, 1e-9);
}

TEST(FenceRecord, NearestIsNotOverstated) {
  // A wedge that points at a straight way of a kilometre, beside samples a centimetre apart.
  tern_host::Session session;
  for (const double tip : {480.3, 501.2, 523.1}) {
    const std::string x = std::to_string(tip - 3.0), y = std::to_string(-tip - 3.0);
    const tern_host::PlanResult plan = session.plan(tern_host::parse_scenario(
        "boundary 0 -20 0 1000 20 20\nresolution 1\nstart 5 0 10\ngoal 995 0 10\nv_max 10\nkeepout_halfspaces 1 -1 0 " +
            x + " -1 -1 0 " + y + "\n",
        "map.txt"));
    ASSERT_TRUE(plan.ok());
    double least = 1e9;
    for (double t = 0.0; t < tern::duration(plan.trajectory); t += 1e-3) {
      least = std::min(least, fence_gap(plan.scenario.fences[0], tern::evaluate(plan.trajectory, t).position));
    }
    const tern_host::NearestFence nearest = nearest_fence(plan.trajectory, plan.scenario);
    EXPECT_EQ(nearest.index, 0);
    EXPECT_NEAR(nearest.gap, least, tern_host::kGapError) << tip;
  }
}

TEST(FenceRecord, ABoxHasSixPlanes) {
  const FenceRecord fence = fence_of("keepout -1 -2 0 1 2 3");
  EXPECT_EQ(fence.fence.kind, FenceKind::kKeepOut);
  EXPECT_EQ(fence.planes.size(), 6u);
  EXPECT_EQ(fence_of("keepin -1 -2 0 1 2 3").fence.kind, FenceKind::kKeepIn);
  EXPECT_EQ(fence_of("keepin_halfspaces 1 0 0 2").fence.kind, FenceKind::kKeepIn);
  EXPECT_EQ(fence_of("keepout_halfspaces 1 0 0 2 0 1 0 3").planes.size(), 2u);
}

TEST(FenceRecord, ErrorsSayWhere) {
  EXPECT_EQ(fence_error("keepin 0 0 0 1 1"), "world.txt:7: 'keepin' needs 6 numbers, found 5");
  EXPECT_EQ(fence_error("keepout 0 3 0 1 1 1"),
            "world.txt:7: 'keepout' has its corners the wrong way round in y: 3 > 1");
  EXPECT_EQ(fence_error("keepout_halfspaces 0 0 0 1"),
            "world.txt:7: 'keepout_halfspaces' has a normal that is no direction");
  std::vector<FenceRecord> fences;
  const tern_host::Words words = tern_host::split_words("keepin_halfspaces 1 0 0 9", false);
  for (int k = 0; k <= tern::kMaxFences; ++k) {
    EXPECT_EQ(exceeds_capacity(fences), k > tern::kMaxFences);
    add_fence(words, kPlace, fences);
  }
  EXPECT_TRUE(exceeds_capacity(fences));
  while (fences.size() < tern_host::kMostFences) add_fence(words, kPlace, fences);
  EXPECT_THROW(add_fence(words, kPlace, fences), tern_host::RecordError);
}

std::string error_of_all(const std::vector<std::string>& lines) {
  std::vector<FenceRecord> fences;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    add_fence(tern_host::split_words(lines[i], false), {"world.txt", static_cast<int>(i) + 1}, fences);
  }
  try {
    refuse_empty_fences(fences, {{0.0, 0.0, 0.0}, {10.0, 8.0, 3.0}}, 0.3);
  } catch (const tern_host::RecordError& error) {
    return error.what();
  }
  return "";
}

TEST(FenceRecord, EmptyFencesAreNamedWithTheirLine) {
  const std::string pillar = "keepout_halfspaces 1 0 0 6 -1 0 0 -4 0 1 0 6 0 -1 0 -2";
  const std::string clockwise = "keepout_halfspaces -1 0 0 -6 1 0 0 4 0 -1 0 -6 0 1 0 2";
  const std::string wrong = "; is one of them, or the order of the polygon, reversed?";
  EXPECT_EQ(error_of_all({}), "");
  EXPECT_EQ(error_of_all({pillar, "keepin 0 0 0 4 8 3", "keepout 2 2 2 2 2 2", "keepout_halfspaces 1 0 0 0.1"}), "");
  const std::string one_sign = "keepout_halfspaces 1 0 0 6 1 0 0 -4 0 1 0 6 0 -1 0 -2";
  for (const std::string& elsewhere : {one_sign, std::string("keepout_halfspaces 1 0 0 -40")}) {
    EXPECT_EQ(error_of_all({pillar, elsewhere}),
              "world.txt:2: 'keepout_halfspaces' has no part inside the boundary; has one of its half-spaces the wrong "
              "sign? Leave out a fence that is elsewhere");
  }
  EXPECT_EQ(error_of_all({pillar, clockwise, pillar}),
            "world.txt:2: 'keepout_halfspaces' is empty: its half-spaces have no common point" + wrong);
  EXPECT_EQ(
      error_of_all({"keepin 0 0 0 4 8 3", pillar, "keepin 5 0 0 9 8 3"}),
      "world.txt:3: 'keepin' is empty: its half-spaces have no common point with those of the keep-ins before it" +
          wrong);
}

TEST(FenceRecord, WorldsOfFlightsWithEmptyFencesAreRefused) {
  const std::string path = tern_test::own_folder() + "clockwise.txt";
  std::ofstream(path) << "boundary 0 0 0 10 8 3\nstart 1 4 1\n"
                         "keepout_halfspaces -1 0 0 -6 1 0 0 4 0 -1 0 -6 0 1 0 2\ngoal 9 4 1\n";
  try {
    tern_host::read_flight_world(path, {});
    ADD_FAILURE() << "it is read";
  } catch (const tern_host::RecordError& error) {
    EXPECT_EQ(error.place().line, 3);
    EXPECT_NE(error.reason().find("reversed?"), std::string::npos);
  }
}

TEST(FenceGap, OfABox) {
  const FenceRecord out = fence_of("keepout 0 0 0 2 2 2");
  EXPECT_NEAR(fence_gap(out, {3.0, 1.0, 1.0}), 1.0, 1e-12);
  EXPECT_NEAR(fence_gap(out, {3.0, 4.0, 1.0}), std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(fence_gap(out, {3.0, 4.0, 5.0}), std::sqrt(14.0), 1e-12);
  EXPECT_NEAR(fence_gap(out, {1.9, 1.0, 1.0}), -0.1, 1e-12);
  const FenceRecord in = fence_of("keepin 0 0 0 2 2 2");
  EXPECT_NEAR(fence_gap(in, {1.9, 1.0, 1.0}), 0.1, 1e-12);
  EXPECT_NEAR(fence_gap(in, {1.0, 2.5, 1.0}), -0.5, 1e-12);
}

/// Beyond the sharp edge of a wedge of 45 degrees, along no normal: the nearest point is on the edge.
TEST(FenceGap, OfAWedge) {
  const FenceRecord out = fence_of("keepout_halfspaces 0 -2 0 0 3 3 0 0");
  EXPECT_NEAR(fence_gap(out, {3.0, -1.0, 5.0}), std::sqrt(10.0), 1e-9);
  EXPECT_NEAR(fence_gap(out, {-3.0, 4.0, 0.0}), std::sqrt(0.5), 1e-9);
}

FlightWorld fenced_world() {
  FlightWorld world;
  world.name = "fenced";
  world.boundary = {{-2.0, -5.0, 0.0}, {12.0, 5.0, 4.0}};
  world.start = {0.0, 0.0, 1.5};
  world.goal = {9.0, 0.0, 1.5};
  world.settings.cell = 0.2;
  world.settings.window = {25.6, 14.0, 6.0};
  world.settings.hits = 1;
  world.settings.support = world.settings.speckle_filter = 0;
  world.settings.time_limit = 30.0;
  world.fences = {fence_of("keepout 4 -2.5 0 5 1 4"), fence_of("keepin -1 -4 0.5 11 4 3")};
  return world;
}

TEST(FencedFlight, FliesAroundTheKeepOut) {
  const FlightWorld world = fenced_world();
  const tern_host::FlightResult result = tern_host::simulate_flight(world);
  ASSERT_EQ(result.status, "reached") << result.reason;
  double least = 1e9;
  for (const tern_host::TrackPoint& point : result.track) {
    least = std::min(least, fence_gap(world.fences[0], point.position));
    EXPECT_GE(fence_gap(world.fences[1], point.position), -world.settings.tracking_margin);
  }
  EXPECT_GE(least, world.settings.body_radius);
  EXPECT_LT(least, 1.0);
}

TEST(FencedFlight, FullKnowledgeRespectsFencesToo) {
  FlightWorld world = fenced_world();
  const double fenced = full_knowledge_time(world);
  world.fences.clear();
  EXPECT_GT(fenced, full_knowledge_time(world) + 0.1);
}

}  // namespace
