// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Map files of scenarios. The files in tests/support/maps were written by OctoMap's own library, and by hand.
#include "host/map/map_files.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host/closed_way.hpp"
#include "host/map/cloud_file.hpp"
#include "host/map/known_space.hpp"
#include "host/map/octomap_file.hpp"
#include "host/map/scenario_grid.hpp"
#include "host/picture/map_picture.hpp"
#include "host/session.hpp"
#include "support/map_bytes.hpp"

namespace {

using tern::Vec3;
using tern_host::GridMap;
using tern_host::Octomap;
using tern_host::OctomapLeaf;
using tern_host::RecordError;
using tern_host::Scenario;
using tern_test::bytes_of;
using tern_test::contains;
using tern_test::kMapFolder;

/// Why bytes are refused; empty where they are not.
template <typename Parse>
std::string reason(Parse parse, const std::string& bytes) {
  try {
    parse(bytes, tern_host::Place{"it", 0});
  } catch (const RecordError& error) {
    EXPECT_EQ(error.place().file, "it");
    return error.reason();
  }
  return "";
}

std::string octomap_reason(const std::string& bytes) {
  return reason(tern_host::parse_octomap, bytes);
}

Scenario parse(const std::string& records) {
  const std::string ends = "boundary 0 0 0 4 3 2\nstart 0.5 0.5 1\ngoal 3.5 0.5 1\nradius 0.2\n";
  Scenario scenario = tern_host::parse_scenario(ends + records, kMapFolder + "room.txt");
  tern_host::load_map_files(scenario);
  return scenario;
}

std::string scenario_reason(const std::string& records) {
  try {
    parse(records);
  } catch (const tern_host::ScenarioError& error) {
    return error.what();
  }
  return "";
}

/// The room of the files: 40 x 30 x 20 cells of 0.1 m, of which those beyond x = 3, y = 2 were never seen.
int state_in_room(int x, int y) {
  if (x >= 30 && y >= 20) return -1;
  return x >= 16 && x < 24 && y >= 8 && y < 16 ? 1 : 0;
}

TEST(OctomapFile, BothFormsSayWhatTheLibraryWrote) {
  for (const char* name : {"room.bt", "room.ot"}) {
    const Octomap map = tern_host::parse_octomap(bytes_of(name), {name, 0});
    EXPECT_EQ(map.resolution, 0.1);
    EXPECT_EQ(map.leaves.size(), 321u) << name;
    std::vector<int> cells(40 * 30 * 20, -1);
    for (const OctomapLeaf& leaf : map.leaves) {
      for (std::uint32_t k = 0; k < leaf.size * leaf.size * leaf.size; ++k) {
        const int x = static_cast<int>(leaf.key[0] + k % leaf.size) - 32768;
        const int y = static_cast<int>(leaf.key[1] + k / leaf.size % leaf.size) - 32768;
        const int z = static_cast<int>(leaf.key[2] + k / leaf.size / leaf.size) - 32768;
        ASSERT_TRUE(x >= 0 && y >= 0 && z >= 0 && x < 40 && y < 30 && z < 20);
        cells[static_cast<std::size_t>(x + 40 * (y + 30 * z))] = leaf.occupied ? 1 : 0;
      }
    }
    for (int i = 0; i < 40 * 30 * 20; ++i) {
      ASSERT_EQ(cells[static_cast<std::size_t>(i)], state_in_room(i % 40, i / 40 % 30)) << name << " " << i;
    }
  }
}

TEST(OctomapFile, BoxesLieInTheWorld) {
  const Octomap map{0.5, {}};
  const tern::Box box = map.box({{32768, 32766, 32770}, 2, true});
  EXPECT_EQ(box.lower.x, 0.0);
  EXPECT_EQ(box.lower.y, -1.0);
  EXPECT_EQ(box.lower.z, 1.0);
  EXPECT_EQ(box.upper.z, 2.0);
}

TEST(OctomapFile, BrokenFilesAreRefused) {
  for (const char* name : {"room.bt", "room.ot"}) {
    const std::string whole = bytes_of(name);
    EXPECT_EQ(octomap_reason(whole), "");
    for (std::size_t n = 0; n < whole.size(); ++n) ASSERT_NE(octomap_reason(whole.substr(0, n)), "") << n;
    EXPECT_TRUE(contains(octomap_reason(whole.substr(0, whole.size() - 1)), "cut off after"));
    // Any single byte of the tree may be wrong: an answer, and no more reading than there is.
    for (std::size_t n = whole.find("\ndata\n") + 6; n < whole.size(); ++n) {
      for (const char wrong : {'\0', '\xFF', '\x55'}) {
        std::string broken = whole;
        broken[n] = wrong;
        octomap_reason(broken);
      }
    }
  }
}

TEST(OctomapFile, HeadersThatContradictThemselvesAreRefused) {
  const std::string head = "# Octomap OcTree binary file\n";
  EXPECT_TRUE(contains(octomap_reason("pgm"), "not an OctoMap file"));
  for (const char* res : {"0", "-1", "1e-5", "1e5"}) {
    EXPECT_TRUE(contains(octomap_reason(head + "id OcTree\nsize 1\nres " + res + "\ndata\n"), "'res' is")) << res;
  }
  EXPECT_TRUE(contains(octomap_reason(head + "id OcTree\nsize 1\nres 0,1\ndata\n"), "'0,1' is not a number"));
  EXPECT_TRUE(contains(octomap_reason(head + "size 1\nres 1\ndata\n"), "has no 'id'"));
  EXPECT_TRUE(contains(octomap_reason(head + "id OcTree\nres 1\ndata\n"), "has no 'size'"));
  EXPECT_TRUE(contains(octomap_reason(head + "id OcTree\nsize 0\ndata\n"), "has no 'res'"));
  EXPECT_TRUE(contains(octomap_reason(head + "id OcTree\nsize 1\nsize 2\nres 1\ndata\n"), "'size' is given twice"));
  EXPECT_TRUE(contains(octomap_reason(head + "id OcTree\nsize 1.5\nres 1\ndata\n"), "'1.5' is not a whole number"));
  EXPECT_TRUE(contains(octomap_reason(head + "id OcTree\nsize 1e300\nres 1\ndata\n"), "not a whole number up to"));
  EXPECT_TRUE(contains(octomap_reason(head + "id OcTree\nsize 0\nres 1\nscale 2\ndata\n"), "unknown word 'scale'"));
  EXPECT_TRUE(
      contains(octomap_reason(head + "id OcTree\nsize 0\nres 1\ndata\n" + std::string(2, '\0')), "2 bytes more"));
  EXPECT_TRUE(contains(octomap_reason(bytes_of("room.bt") + "x"), "1 bytes more"));
  const std::string full = "# Octomap OcTree file\nid OcTree\nsize 1\nres 1\ndata\n";
  EXPECT_TRUE(contains(octomap_reason(full + std::string("\0\0\xC0\x7F\0", 5)), "neither free nor occupied"));
  EXPECT_TRUE(contains(octomap_reason(head + "id CountingOcTree\nsize 1\nres 1\ndata\n"), "'CountingOcTree'"));
  EXPECT_TRUE(contains(octomap_reason(head + "id OcTree\nsize x\nres 1\ndata\n"), "'x' is not a number"));
  EXPECT_TRUE(contains(octomap_reason(head + "id OcTree\nsize 2\nres 1\ndata\n" + std::string(2, '\0')), "broken"));
  EXPECT_EQ(octomap_reason(head + "id OcTree\nsize 0\nres 1\ndata\n"), "");
  // A chain of first children that goes below the smallest cubes.
  std::string deep = head + "id OcTree\nsize 99\nres 1\ndata\n";
  for (int k = 0; k < 20; ++k) deep += std::string("\x03\x00", 2);
  EXPECT_TRUE(contains(octomap_reason(deep), "below the smallest"));
}

TEST(MapFiles, TheUnknownIsFreeOrSolid) {
  const GridMap open(parse("octomap room.bt\n"));
  EXPECT_EQ(open.voxels, 40 * 30 * 20);
  EXPECT_EQ(open.occupied_count, 8 * 8 * 20);
  EXPECT_EQ(open.unknown_count, 10 * 10 * 20);
  EXPECT_TRUE(open.is_unknown({35, 25, 3}));
  EXPECT_FALSE(open.grid.obstacle({35, 25, 3}));
  // The unknown corner, and what lies beyond the boundary: the grid is three voxels wider.
  const GridMap shut(parse("octomap room.bt\nunknown solid\n"));
  EXPECT_EQ(shut.grid.spec().dims.x, 46);
  EXPECT_EQ(shut.voxels, open.voxels);
  EXPECT_EQ(shut.occupied_count, open.occupied_count);
  EXPECT_EQ(shut.unknown_count, open.unknown_count);
  EXPECT_TRUE(shut.grid.obstacle({0, 0, 10}));
  EXPECT_TRUE(shut.grid.obstacle({38, 28, 6}));
  EXPECT_GT(shut.blocked_count, open.blocked_count);
}

TEST(MapFiles, AVoxelIsFreeOnlyWhereAllOfItIs) {
  // Voxels of 0.25 m: the one from 2.75 to 3 m is all seen, the one from 3 to 3.25 is not.
  const GridMap map(parse("octomap room.bt\nresolution 0.25\n"));
  EXPECT_FALSE(map.is_unknown({11, 9, 2}));
  EXPECT_TRUE(map.is_unknown({12, 9, 2}));
  EXPECT_FALSE(map.is_unknown({12, 7, 2}));  // up to y = 2
  EXPECT_TRUE(map.is_unknown({12, 8, 2}));
}

TEST(MapFiles, PointsAreVoxels) {
  const Scenario scenario = parse("cloud points_text.pcd\n");
  ASSERT_EQ(scenario.blocks.size(), 1u);  // twice one point; the others are far away
  EXPECT_NEAR(scenario.blocks[0].box.lower.x, 0.2, 1e-12);
  const GridMap map(scenario);
  EXPECT_EQ(map.occupied_count, 1);
  EXPECT_TRUE(map.grid.obstacle({2, 5, 7}));
  EXPECT_EQ(map.unknown_count, 0);
}

TEST(MapFiles, PlansGoRoundWhatTheyHold) {
  const tern_host::PlanResult round = tern_host::Session().plan(parse("octomap room.ot\n"));
  EXPECT_TRUE(round.ok());
  const Scenario corner = parse("octomap room.bt\nunknown solid\ngoal_mode nearest\n");
  EXPECT_TRUE(tern_host::Session().plan(corner).ok());
}

TEST(MapFiles, FaultsNameTheRecordAndTheFile) {
  EXPECT_TRUE(
      contains(scenario_reason("cloud none.pcd\n"), "room.txt:5: " + kMapFolder + "none.pcd: cannot be opened"));
  EXPECT_TRUE(contains(scenario_reason("octomap points_text.pcd\n"), "points_text.pcd: not an OctoMap file"));
  EXPECT_TRUE(contains(scenario_reason("cloud room.bt\n"), "room.bt: neither a PCD file nor a PLY file"));
  EXPECT_TRUE(contains(scenario_reason("cloud two words\n"), "needs one file name"));
  EXPECT_TRUE(contains(scenario_reason("cloud points_text.pcd\nunknown solid\n"), "room.txt:6: 'unknown solid' needs"));
  EXPECT_TRUE(contains(scenario_reason("unknown maybe\n"), "'unknown' is 'free' or 'solid'"));
}

/// Around the wall, the way leads through the part that was never seen.
TEST(MapFiles, SaysThatUnknownSpaceClosesTheWay) {
  const std::string wall = "octomap room.bt\nblock 3 0 0 3.1 2 2\n";
  tern_host::Session session;
  EXPECT_TRUE(session.plan(parse(wall)).ok());
  const Scenario scenario = parse(wall + "unknown solid\n");
  EXPECT_EQ(session.plan(scenario).report.status, tern::Status::kNoPath);
  EXPECT_TRUE(contains(tern_host::describe_closed_way(scenario), "space that the map does not know"));
}

TEST(MapPicture, ShowsSlicesAndTheUnknown) {
  const Scenario scenario = parse("octomap room.bt\n");
  const std::string svg = tern_host::map_svg(scenario, GridMap(scenario));
  EXPECT_TRUE(contains(svg, "Slice at z = 0.25 m"));
  EXPECT_TRUE(contains(svg, "class=\"unknown\""));
  EXPECT_TRUE(contains(svg, "class=\"block-top\""));
  const Scenario known = parse("block 1 1 0 2 2 1\n");
  EXPECT_FALSE(contains(tern_host::map_svg(known, GridMap(known)), "class=\"unknown\""));
}

}  // namespace
