// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What adds nothing to a map is said, with counts and the likely reason.
#include "host/map/map_warnings.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>

#include "host/flight/flight_world.hpp"
#include "host/map/map_files.hpp"
#include "support/own_folder.hpp"

namespace {

using tern::Vec3;
using tern_host::RecordError;
using tern_host::Scenario;

const std::string kOwnFolder = tern_test::own_folder();

/// A wall of points across a room of 10 x 8 x 3 m, each as `change` says.
std::string wall(const std::function<Vec3(const Vec3&)>& change) {
  std::string rows;
  int count = 0;
  for (int y = 0; y < 20; ++y) {
    for (int z = 0; z < 10; ++z, ++count) {
      const Vec3 p = change({4.05, 0.05 + 0.4 * y, 0.05 + 0.3 * z});
      rows += std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
    }
  }
  return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS " + std::to_string(count) + "\nDATA ascii\n" + rows;
}

std::vector<std::string> warnings_of(const std::string& records, const std::string& cloud = "") {
  const std::string boundary = "boundary 0 0 0 10 8 3\nstart 1 4 1\ngoal 9 4 1\nradius 0.3\n";
  std::ofstream(kOwnFolder + "map_warnings.pcd") << cloud;
  Scenario scenario = tern_host::parse_scenario(boundary + records, kOwnFolder + "map_warnings.txt");
  tern_host::load_map_files(scenario);
  return scenario.warnings;
}

void expect_one(const std::vector<std::string>& warnings, const std::string& line, const std::string& part) {
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].find(kOwnFolder + "map_warnings.txt" + line), 0u) << warnings[0];
  EXPECT_NE(warnings[0].find(part), std::string::npos) << warnings[0];
}

void expect_of_cloud(const std::function<Vec3(const Vec3&)>& change, const std::string& part) {
  expect_one(warnings_of("cloud map_warnings.pcd\n", wall(change)), ":5: 'map_warnings.pcd'", part);
}

Vec3 scaled(const Vec3& p, double by) {
  return {by * p.x, by * p.y, by * p.z};
}

TEST(MapWarnings, NothingIsSaidOfWhatAddsSomething) {
  EXPECT_TRUE(warnings_of("cloud map_warnings.pcd\n", wall([](const Vec3& p) { return p; })).empty());
  // Nearer to the boundary than the radius, or across it, or just a third of it outside.
  EXPECT_TRUE(warnings_of("block -1 0 0 -0.1 8 3\nkeepout -5 0 0 1 1 1\nkeepout_halfspaces 1 0 0 -0.1\n").empty());
  EXPECT_TRUE(warnings_of("keepin 0 0 0 10 8 3\nkeepin_halfspaces 0 0 1 90\n").empty());
  EXPECT_TRUE(warnings_of("cloud map_warnings.pcd\n", wall([](const Vec3& p) {
                            return Vec3{p.x, p.y + 3, p.z};
                          }))
                  .empty());
}

TEST(MapWarnings, CloudsOfAnotherUnitOrOtherAxes) {
  expect_of_cloud([](const Vec3& p) { return scaled(p, 1000); },
                  "adds nothing to the map: of its 200 points, 0 are not finite and 200 are outside the boundary; they "
                  "lie at (4050, 50, 50) to (4050, 7650, 2750): are they in millimetres, not metres?");
  expect_of_cloud([](const Vec3& p) { return scaled(p, 100); }, "in centimetres");
  expect_of_cloud([](const Vec3& p) { return scaled(p, 0.001); }, "adds next to nothing");
  expect_of_cloud([](const Vec3& p) { return Vec3{p.x, p.z, -p.y}; }, "As (x, -z, y) they would be inside");
  expect_of_cloud([](const Vec3& p) { return Vec3{-p.x, -p.y, p.z}; }, "As (-x, -y, z) they would be inside");
  expect_of_cloud([](const Vec3& p) { return Vec3{p.x, p.y, p.z - 3}; }, "is mostly left out");
  expect_of_cloud([](const Vec3& p) { return Vec3{p.x + 500, p.y, p.z}; }, "they lie at (504.05");
  const std::string none = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS ";
  expect_one(warnings_of("cloud map_warnings.pcd\n", none + "0\nDATA ascii\n"), ":5: ", "of its 0 points");
  expect_one(warnings_of("cloud map_warnings.pcd\n", none + "2\nDATA ascii\nnan 0 0\n0 0 inf\n"),
             ":5: ", "of its 2 points, 2 are not finite and 0 are outside the boundary");
  std::string turned = wall([](const Vec3& p) { return p; });
  turned.insert(0, "VIEWPOINT 0 0 1 1 0 0 0\n");
  turned.insert(0, "VERSION 0.7\n");
  expect_one(warnings_of("cloud map_warnings.pcd\n", turned), ":5: ", "its points are taken as they are");
}

TEST(MapWarnings, OctoMaps) {
  // The whole world is one free cube of the tree, or one occupied corner of it far away.
  const auto tree = [](const std::string& size, const std::string& kinds) {
    return "# Octomap OcTree binary file\nid OcTree\nsize " + size + "\nres 0.1\ndata\n" + kinds;
  };
  const std::string free = tree("2", std::string("\0\x40", 2));
  const std::string far = tree("3", std::string("\x03\0\x02\0", 4));
  expect_one(warnings_of("octomap map_warnings.pcd\n", free), ":5: ", "of its 0 occupied leaves 0 are outside");
  EXPECT_TRUE(warnings_of("octomap map_warnings.pcd\nunknown solid\n", free).empty());
  expect_one(warnings_of("octomap map_warnings.pcd\n", far),
             ":5: ", "of its 1 occupied leaves 1 are outside the boundary; they lie at (-3276.8, ");
}

TEST(MapWarnings, RecordsOutside) {
  expect_one(warnings_of("block 4000 0 0 5000 6000 3000\nblock 1 1 1 2 2 2\n"),
             ":5: 1 of 2 'block' records adds nothing", "in millimetres");
  expect_one(warnings_of("block 1 1 1 2 2 2\nkeepout 1 1 1 2 2 2\nkeepout 4 0 -2 5 6 -1\nkeepout 0 9 0 1 10 1\n"),
             ":7: 2 of 3 'keepout' records add nothing", "outside the boundary");
}

TEST(MapWarnings, KeepInsThatKeepNothingInAndFitInAnotherUnit) {
  expect_one(warnings_of("keepin 0 0 0 10000 8000 3000\n"), ":5: 1 of 1 'keepin' records adds nothing",
             "around all of the boundary: are they in millimetres, not metres?");
  EXPECT_TRUE(warnings_of("keepin -1e5 -1e5 -1e5 1e5 1e5 1e5\nkeepin 100 100 100 8000 7000 2000\n").empty());
}

/// The same warnings for a flight's world.
TEST(MapWarnings, RecordsOfFlightWorlds) {
  const std::string path = kOwnFolder + "map_warnings_world.txt";
  const auto of = [&path](const std::string& records) {
    std::ofstream(path) << "boundary 0 0 0 10 8 3\nstart 1 4 1\ngoal 9 4 1\n" << records;
    return tern_host::read_flight_world(path, {}).warnings;
  };
  const auto expect = [&of, &path](const std::string& records, const std::string& warning) {
    const std::vector<std::string> warnings = of(records);
    ASSERT_EQ(warnings.size(), 1u) << records;
    EXPECT_EQ(warnings[0], path + warning);
  };
  const std::string nothing = " nothing to the map, first this one: ";
  const std::string outside = nothing + "outside the boundary";
  EXPECT_TRUE(of("block -1 0 0 -0.1 8 3\ncylinder 5 9 0 3 1.2\nkeepin 0 0 0 10 8 3\nkeepout -5 0 0 1 1 1\n").empty());
  expect("block 1 1 1 2 2 2\nblock 4000 0 0 5000 6000 3000\n",
         ":5: 1 of 2 'block' records adds" + outside + ": are they in millimetres, not metres?");
  expect("cylinder 500 400 0 300 50\n",
         ":4: 1 of 1 'cylinder' records adds" + outside + ": are they in centimetres, not metres?");
  expect("keepout 5 -2 1 6 -1 2\nkeepout 5 -2 1 6 -1 2\n",
         ":4: 2 of 2 'keepout' records add" + outside + ": have they other axes? As (x, -y, z) they would be inside");
  expect("appear 2 cylinder 50 4 0 3 1\n", ":4: 1 of 1 'appear' records adds" + outside);
  expect("keepin 0 0 0 10000 8000 3000\n", ":4: 1 of 1 'keepin' records adds" + nothing +
                                               "around all of the boundary: are they in millimetres, not metres?");
}

TEST(MapWarnings, GitLfsPointersAreRefused) {
  const std::string pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
  for (const char* record : {"cloud map_warnings.pcd\n", "octomap map_warnings.pcd\n"}) {
    try {
      warnings_of(record, pointer);
      ADD_FAILURE();
    } catch (const RecordError& error) {
      EXPECT_NE(
          std::string(error.what()).find("map_warnings.txt:5: " + kOwnFolder + "map_warnings.pcd: a Git LFS pointer"),
          std::string::npos)
          << error.what();
      EXPECT_NE(std::string(error.what()).find("`git lfs pull`"), std::string::npos);
    }
  }
  EXPECT_THROW(tern_host::read_scenario(kOwnFolder + "map_warnings.pcd"), RecordError);
}

}  // namespace
