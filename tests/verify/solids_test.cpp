// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The verifier's voxels are the grid's, though neither knows the other.
#include "verify/solids.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "host/grid_layout.hpp"
#include "host/map/map_files.hpp"
#include "host/map/octomap_file.hpp"
#include "host/map/scenario_grid.hpp"
#include "host/scenario.hpp"
#include "support/own_folder.hpp"

namespace tern_verify {
namespace {

/// Faces anywhere, on the lattice, and beside it by less than its tolerance and by more.
double coordinate(std::mt19937& random, double origin, double cell) {
  const double at = origin + cell * std::uniform_int_distribution<int>(-3, 24)(random);
  constexpr double kParts[] = {0.0, 0.0, 5e-10, -5e-10, 1e-6, -1e-6, 0.37};
  return at + cell * kParts[std::uniform_int_distribution<int>(0, 6)(random)];
}

std::string random_scenario(std::mt19937& random) {
  constexpr double kOrigins[] = {0.0, -0.3, 12345.6, -1e6};
  constexpr double kCells[] = {0.1, 0.25, 0.07};
  const double origin = kOrigins[std::uniform_int_distribution<int>(0, 3)(random)];
  const double cell = kCells[std::uniform_int_distribution<int>(0, 2)(random)];
  const bool inside = random() % 2 == 0;
  const double end = origin + 20 * cell;
  std::ostringstream text;
  text.precision(17);
  const auto triple = [&](double v) { text << ' ' << v << ' ' << v << ' ' << v; };
  text << "boundary";
  triple(origin);
  triple(end);
  text << "\nstart";
  triple(origin);
  text << "\ngoal";
  triple(end);
  text << "\nresolution " << cell << "\nradius 0.2\n";
  for (int b = 0; b < 6; ++b) {
    double lower[3], upper[3];
    for (int a = 0; a < 3; ++a) {
      double p = coordinate(random, origin, cell), q = random() % 4 == 0 ? p : coordinate(random, origin, cell);
      if (inside) p = std::clamp(p, origin, end), q = std::clamp(q, origin, end);
      lower[a] = std::min(p, q);
      upper[a] = std::max(p, q);
    }
    text << "block";
    for (const double v : lower) text << ' ' << v;
    for (const double v : upper) text << ' ' << v;
    text << '\n';
  }
  return text.str();
}

bool is_solid(const std::vector<Cells>& solid, const tern::Voxel& v) {
  const long index[3] = {v.x, v.y, v.z};
  for (const Cells& cells : solid) {
    bool within = true;
    for (std::size_t a = 0; a < 3; ++a) within = within && index[a] >= cells.begin[a] && index[a] < cells.end[a];
    if (within) return true;
  }
  return false;
}

void expect_same_voxels(const std::string& text, const std::string& name) {
  tern_host::Scenario scenario = tern_host::parse_scenario(text, name);
  tern_host::load_map_files(scenario);
  const tern::GridSpec spec = tern_host::lay_out_grid(scenario);
  std::vector<std::uint64_t> words(tern::grid_words(spec.dims));
  tern::Grid grid;
  ASSERT_EQ(grid.bind(spec, words.data(), words.size()), tern::Status::kOk);
  ASSERT_EQ(tern_host::fill_grid(scenario, grid), tern::Status::kOk);
  const Problem problem = parse_problem(text, name);
  const Lattice lattice = lattice_of(problem);
  const std::vector<Cells> solid = solid_cells(problem, lattice);
  ASSERT_EQ(lattice.dims, (std::array<long, 3>{spec.dims.x, spec.dims.y, spec.dims.z})) << text;
  for (std::int32_t z = 0; z < spec.dims.z; ++z) {
    for (std::int32_t y = 0; y < spec.dims.y; ++y) {
      for (std::int32_t x = 0; x < spec.dims.x; ++x) {
        ASSERT_EQ(is_solid(solid, {x, y, z}), grid.obstacle({x, y, z})) << text << x << ' ' << y << ' ' << z;
      }
    }
  }
}

TEST(Solids, AreTheVoxelsThatTheGridMarks) {
  std::mt19937 random(7);
  for (int k = 0; k < 60; ++k) expect_same_voxels(random_scenario(random), "s");
}

/// The nodes of an `.ot` from a cube on: down to random leaves, some of them missing, near the origin alone.
void append_nodes(std::mt19937& random, std::int64_t key, std::int64_t size, std::string& nodes, int& count) {
  const bool deep = size > 8 || (size > 1 && random() % 3 == 0);
  const float odds = random() % 3 == 0 ? 1.0f : -1.0f;
  nodes.append(reinterpret_cast<const char*>(&odds), sizeof odds);
  ++count;
  const std::size_t mask = nodes.size();
  nodes += '\0';
  for (int child = 0; deep && child < 8; ++child) {
    // Of a large cube the children that touch the origin; of a small one, most.
    const bool there = size > 32 ? (size == 65536 || child == 7 - (key >> 32 & 7)) : random() % 8 != 0;
    if (!there) continue;
    nodes[mask] = static_cast<char>(nodes[mask] | 1 << child);
    append_nodes(random, size == 65536 ? std::int64_t{child} << 32 : key, size / 2, nodes, count);
  }
}

/// A tree around the origin of cubes of `resolution`.
std::string random_octree(std::mt19937& random, double resolution) {
  std::string nodes;
  int count = 0;
  append_nodes(random, 0, 65536, nodes, count);
  std::ostringstream head;
  head << "# Octomap OcTree file\nid OcTree\nsize " << count << "\nres " << resolution << "\ndata\n";
  return head.str() + nodes;
}

std::string random_cloud(std::mt19937& random) {
  std::ostringstream rows;
  for (int i = 0; i < 30; ++i) {
    for (int a = 0; a < 3; ++a) rows << coordinate(random, -1.0, 0.1) << ' ';
    rows << '\n';
  }
  return "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nPOINTS 31\nDATA ascii\nnan 0 0\n" + rows.str();
}

TEST(Solids, AreTheVoxelsOfMapFiles) {
  const std::string folder = tern_test::own_folder() + "verify_solids_";
  std::mt19937 random(11);
  for (int k = 0; k < 40; ++k) {
    std::ofstream(folder + "a.ot", std::ios::binary) << random_octree(random, k % 2 == 0 ? 0.1 : 0.07);
    std::ofstream(folder + "b.ot", std::ios::binary) << random_octree(random, 0.15);
    std::ofstream(folder + "c.pcd") << random_cloud(random);
    const std::string files[] = {"cloud verify_solids_c.pcd\n", "octomap verify_solids_a.ot\n",
                                 "octomap verify_solids_a.ot\noctomap verify_solids_b.ot\ncloud verify_solids_c.pcd\n"};
    std::string text = "boundary -1 -1 -1 1 1 1\nstart 0 0 0\ngoal 1 1 1\nradius 0.2\nblock 0.2 0.2 0.2 0.3 0.4 0.5\n";
    text += k % 3 == 0 ? "resolution 0.1\n" : "resolution 0.125\n";
    text += files[k % 4 % 3];
    if (k % 8 > 3 && k % 4 % 3 > 0) text += "unknown solid\n";
    expect_same_voxels(text, folder + "s.txt");
  }
}

TEST(MapFiles, AreReadAsThePlannerReadsThem) {
  const std::string folder = std::string(TERN_SOURCE_DIR) + "/tests/support/maps/";
  for (const char* name : {"points_text.pcd", "points_binary.pcd", "points_packed.pcd", "points_text.ply",
                           "points_little.ply", "points_big.ply"}) {
    const std::vector<CloudPoint> points = read_cloud(read_file(folder + name), name);
    ASSERT_EQ(points.size(), 4u) << name;
    EXPECT_EQ(points[1], (CloudPoint{1.0, -2.0, 3.5})) << name;
    EXPECT_EQ(points[2], (CloudPoint{1000.0, 2.0, -0.125})) << name;
  }
  for (const char* name : {"room.bt", "room.ot"}) {
    const std::string bytes = read_file(folder + name);
    const Octree tree = read_octree(bytes, name);
    const tern_host::Octomap map = tern_host::parse_octomap(bytes, {name, 0});
    EXPECT_EQ(tree.resolution, map.resolution);
    EXPECT_EQ(tree.leaves.size(), map.leaves.size());
    for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_THROW(read_octree(bytes.substr(0, n), name), InputError) << n;
  }
}

TEST(MapFiles, BrokenOnesAreRefused) {
  const std::string pcd = "FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nPOINTS 1\nDATA ascii\n";
  EXPECT_EQ(read_cloud(pcd + "1 2 inf\n", "it").size(), 0u);
  for (const char* row : {"1,0 2 3\n", "1 2\n", "1 2 3 4\n", "1 2 0x10\n", "1 2 1e\n", ""}) {
    EXPECT_THROW(read_cloud(pcd + row, "it"), InputError) << row;
  }
  EXPECT_THROW(read_cloud("FIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nDATA ascii\n1 2 3\n", "it"), InputError);
  EXPECT_THROW(parse_problem("boundary 0 0 0 1 1 1\nstart 0 0 0\ngoal 1 1 1\nunknown solid\n", "it"), InputError);
  EXPECT_THROW(parse_problem("boundary 0 0 0 1 1 1\ncloud none.pcd\n", "it"), InputError);
}

}  // namespace
}  // namespace tern_verify
