// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The public 3D voxel benchmark: published optimal lengths, every tenth query. Skipped where the files are absent.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "support/path_world.hpp"

namespace {

using tern::Status;
using tern::Voxel;
using tern_test::PathRunner;
using tern_test::scaled;
using tern_test::VoxelWorld;

std::string file(const std::string& name) {
  return std::string(TERN_SHARED_DIR) + "/voxel/" + name;
}

void expect_published_lengths(const std::string& name) {
  std::ifstream map(file(name));
  std::ifstream queries(file(name + ".3dscen"));
  if (!map || !queries) GTEST_SKIP() << "no voxel benchmark in " << TERN_SHARED_DIR;
  std::string word;
  Voxel dims{};
  map >> word >> dims.x >> dims.y >> dims.z;
  VoxelWorld world(dims);
  for (Voxel v{}; map >> v.x >> v.y >> v.z;) ASSERT_EQ(world.grid.mark_voxel(v), Status::kOk);
  world.grid.inflate();
  // "version 1" and the map's name come before the queries.
  queries >> word >> word >> word;
  const int stride = scaled(1000) == 1000 ? 10 : 100;
  PathRunner runner;
  Voxel a{};
  Voxel b{};
  double length = 0.0;
  double ratio = 0.0;
  int read = 0;
  int met = 0;
  for (; queries >> a.x >> a.y >> a.z >> b.x >> b.y >> b.z >> length >> ratio; ++read) {
    if (read % stride != 0) continue;
    const Status status = runner.run(world.grid, a, b);
    ASSERT_TRUE(status == Status::kOk || status == Status::kSegmentsFull) << "query " << read;
    // Eight decimals are printed, of a sum of moves whose costs were rounded to eight decimals too.
    ASSERT_NEAR(runner.path().grid_length, length, 1e-8 + 5e-9 * length) << "query " << read;
    ++met;
  }
  EXPECT_EQ(read, 10000);
  EXPECT_EQ(met, 10000 / stride);
}

TEST(PathVoxelBenchmark, Simple) {
  expect_published_lengths("Simple.3dmap");
}
TEST(PathVoxelBenchmark, Complex) {
  expect_published_lengths("Complex.3dmap");
}

}  // namespace
