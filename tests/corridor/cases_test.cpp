// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The shared corridor cases: maps of cuboids with segments between them. Skipped where the files are absent.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "corridor/grow.hpp"
#include "support/at_once.hpp"
#include "support/corridor_case.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"

namespace tern_test {
namespace {

using tern::Box;
using tern::GrowScratch;
using tern::Polyhedron;
using tern::Status;
using tern::Vec3;

bool enclosed(const tern::Grid& grid, int x, int y, int z) {
  return grid.obstacle({x - 1, y, z}) && grid.obstacle({x + 1, y, z}) && grid.obstacle({x, y - 1, z}) &&
         grid.obstacle({x, y + 1, z}) && grid.obstacle({x, y, z - 1}) && grid.obstacle({x, y, z + 1});
}

/// The cubes on obstacles' surfaces around the local box. Those inside are asserted about in the random worlds.
std::vector<Box> cubes_near(const tern::Grid& grid, const Vec3& from, const Vec3& to) {
  std::vector<Box> near;
  const double c = grid.spec().cell;
  const auto index = [c](double v) { return static_cast<int>(std::floor(v / c)); };
  const double reach = tern::kLocalMargin + 2.0 * c;
  for (int z = index(std::min(from.z, to.z) - reach); z <= index(std::max(from.z, to.z) + reach); ++z) {
    for (int y = index(std::min(from.y, to.y) - reach); y <= index(std::max(from.y, to.y) + reach); ++y) {
      for (int x = index(std::min(from.x, to.x) - reach); x <= index(std::max(from.x, to.x) + reach); ++x) {
        if (!grid.obstacle({x, y, z}) || enclosed(grid, x, y, z)) continue;
        near.push_back({{x * c, y * c, z * c}, {(x + 1) * c, (y + 1) * c, (z + 1) * c}});
      }
    }
  }
  return near;
}

void expect_case_solved(const CorridorCase& c, Random& random, std::size_t stride) {
  const auto scratch = std::make_unique<GrowScratch>();
  const auto polyhedron = std::make_unique<Polyhedron>();
  const double cell = 0.1;
  const tern::Voxel dims{static_cast<int>(std::lround(c.boundary.upper.x / cell)),
                         static_cast<int>(std::lround(c.boundary.upper.y / cell)),
                         static_cast<int>(std::lround(c.boundary.upper.z / cell))};
  MarkedWorld world(dims, cell, 0.0, c.boundary);
  for (const Box& block : c.blocks) ASSERT_EQ(world.grid.mark_box(block), Status::kOk);
  const std::vector<std::array<Vec3, 2>> segments = all_segments(c);
  for (std::size_t i = 0; i < segments.size(); i += stride) {
    const auto& segment = segments[i];
    reset_counters(*scratch);
    ASSERT_EQ(tern_test::grow_polyhedron(tern::World(world.grid), segment[0], segment[1], *scratch, *polyhedron),
              Status::kOk);
    const std::vector<Box> near = cubes_near(world.grid, segment[0], segment[1]);
    const double clearance = segment_clearance(segment[0], segment[1], near, 1e9);
    ASSERT_GT(clearance, 0.04);  // segments keep 0.1 m, pieces of polylines about half of it
    ASSERT_NO_FATAL_FAILURE(expect_holds_segment(world.grid, *polyhedron, clearance));
    ASSERT_NO_FATAL_FAILURE(expect_no_redundancy(*polyhedron));
    ASSERT_NO_FATAL_FAILURE(expect_cut_off(*polyhedron, near, 0.0));
    if (i % (8 * stride) == 0) {
      ASSERT_NO_FATAL_FAILURE(expect_clear(*polyhedron, near, 0.0, random));
    }
  }
}

TEST(CorridorCases, EverySegmentHasAPolyhedron) {
  Random random(1);
  int files = 0;
  const std::size_t stride = scaled(100) >= 100 ? 3 : 30;
  for (const char* size : {"small", "medium", "large"}) {
    for (const char* density : {"10", "30"}) {
      for (int m = 0; m < 3; ++m) {
        const std::string name = std::string(TERN_SHARED_DIR) + "/cases/corridor/" + size + "_" + density + "_m" +
                                 std::to_string(m) + ".txt";
        CorridorCase c;
        if (!read_corridor_case(name, c)) continue;
        ++files;
        SCOPED_TRACE(name);
        ASSERT_NO_FATAL_FAILURE(expect_case_solved(c, random, stride));
      }
    }
  }
  if (files == 0) GTEST_SKIP() << "no corridor cases under " << TERN_SHARED_DIR;
}

}  // namespace
}  // namespace tern_test
