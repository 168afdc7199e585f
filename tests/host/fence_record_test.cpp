// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Geofences of files: how they are read, how far a point is from them, and that simulated flights respect them.
#include "host/fence_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "host/flight/flight_world.hpp"
#include "host/flight/full_knowledge.hpp"
#include "host/flight/simulated_flight.hpp"
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
