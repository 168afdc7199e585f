// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The guided search against a plain A*: the same verdict, legal moves, a cost that is never below the optimum, and the
// same path whatever the memory held and however the work was cut.
#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "guide/guided_search.hpp"
#include "support/path_world.hpp"
#include "support/reference_search.hpp"
#include "support/walked_path.hpp"
#include "support/walled_world.hpp"

namespace {

using tern::Status;
using tern::Voxel;
using tern_test::Random;
using tern_test::random_ends;
using tern_test::random_world;
using tern_test::ReferenceSearch;
using tern_test::scaled;
using tern_test::VoxelWorld;
using tern_test::walled_world;

/// Runs the guided search in memory that starts as garbage.
class GuidedRunner {
 public:
  GuidedRunner() : search_(new tern::GuidedSearch), path_(new tern::Path) { fill(0xA5); }

  void fill(unsigned char byte) {
    std::memset(static_cast<void*>(search_.get()), byte, sizeof *search_);
    std::memset(static_cast<void*>(path_.get()), byte, sizeof *path_);
  }

  Status run(const tern::Grid& grid, const Voxel& start, const Voxel& goal, std::uint32_t slice = 0xFFFFFFFFu) {
    if (!guided_begin(*search_, grid, start, goal)) return Status::kInvalidArgument;
    Status status = Status::kRunning;
    while (status == Status::kRunning) {
      tern::Work work{slice};
      status = guided_advance(*search_, grid, work);
    }
    units = search_->entries;
    path_->raw_count = 0;
    return status == Status::kOk ? guided_extract(*search_, grid, 0, *path_) : status;
  }

  const tern::GuidedSearch& search() const { return *search_; }
  const tern::Path& path() const { return *path_; }
  std::uint32_t units = 0;

 private:
  std::unique_ptr<tern::GuidedSearch> search_;
  std::unique_ptr<tern::Path> path_;
};

/// What runs prove: a limit may end a search, but no verdict is wrong and no move illegal.
class Verdicts {
 public:
  void check(const VoxelWorld& world, Random& random) {
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) return;
    ReferenceSearch reference(world.grid);
    const double optimum = reference.cost(start, goal);
    const Status status = runner_.run(world.grid, start, goal);
    ++runs;
    undecided += status == Status::kNodesFull ? 1 : 0;
    if (status == Status::kNodesFull) return;
    ASSERT_EQ(status, optimum < 0.0 ? Status::kNoPath : Status::kOk);
    none += optimum < 0.0 ? 1 : 0;
    if (optimum < 0.0) return;
    const double walked = tern_test::walked_cost(world.grid, reference, runner_.path());
    ASSERT_NEAR(walked, runner_.path().grid_length, 1e-9);
    ASSERT_GE(walked, optimum - 1e-9);
    ASSERT_TRUE(tern::same(world.grid.voxel_of(runner_.path().raw[0]), start));
    ASSERT_TRUE(tern::same(world.grid.voxel_of(runner_.path().raw[runner_.path().raw_count - 1]), goal));
    ASSERT_LE(runner_.units, tern::kGuidedBound);
    excess += optimum > 0.0 ? walked / optimum - 1.0 : 0.0;
    taken += runner_.search().taken;
    expanded += runner_.search().expanded;
  }

  int runs = 0;
  int none = 0;
  int undecided = 0;
  double excess = 0.0;  ///< relative, sum over all paths
  /// Entries taken off the open list, and voxels expanded: a voxel is entered again only where it costs less than
  /// before.
  std::uint64_t taken = 0;
  std::uint64_t expanded = 0;

 private:
  GuidedRunner runner_;
};

TEST(GuidedSearch, SmallWorlds) {
  Random random(11);
  Verdicts verdicts;
  for (int k = 0; k < scaled(12000) && !HasFatalFailure(); ++k) verdicts.check(random_world(random), random);
  EXPECT_GT(verdicts.none, verdicts.runs / 100);
  EXPECT_LT(verdicts.undecided, verdicts.runs / 10);
  EXPECT_LT(verdicts.excess, 0.1 * verdicts.runs);
  EXPECT_LT(2 * verdicts.taken, 3 * verdicts.expanded);
}

TEST(GuidedSearch, ThinWalls) {
  Random random(12);
  Verdicts verdicts;
  for (int k = 0; k < scaled(1500) && !HasFatalFailure(); ++k) verdicts.check(walled_world(random), random);
  EXPECT_GT(verdicts.none, verdicts.runs / 100);
  // Walls of one voxel lead most guides astray soon; what is decided has to be right all the same.
  EXPECT_GT(verdicts.runs - verdicts.undecided, verdicts.runs / 4);
  EXPECT_LT(verdicts.excess, 0.1 * verdicts.runs);
  EXPECT_LT(verdicts.taken, 2 * verdicts.expanded);
}

TEST(GuidedSearch, NeitherSlicesNorMemoryChangeThePath) {
  GuidedRunner whole;
  GuidedRunner other;
  Random random(13);
  for (int k = 0; k < scaled(200); ++k) {
    const VoxelWorld world = k % 2 == 0 ? random_world(random) : walled_world(random);
    Voxel start{};
    Voxel goal{};
    if (!random_ends(world.grid, random, start, goal)) continue;
    const Status status = whole.run(world.grid, start, goal);
    const unsigned char bytes[] = {0x00, 0x01, 0xFF};
    const std::uint32_t slices[] = {1, 3, 50};
    for (int way = 0; way < 3; ++way) {
      other.fill(bytes[way]);
      ASSERT_EQ(other.run(world.grid, start, goal, slices[way]), status);
      ASSERT_EQ(other.units, whole.units);
      if (status == Status::kOk) tern_test::expect_same_raw(whole.path(), other.path());
    }
  }
}

/// The guide alone tells that the goal is walled in, and the search of voxels that the start is.
TEST(GuidedSearch, PocketsEndEarly) {
  GuidedRunner runner;
  VoxelWorld world({200, 200, 40});
  world.block({92, 92, 12}, {104, 104, 24});
  for (int z = 16; z < 20; ++z) {
    for (int y = 96; y < 100; ++y) {
      for (int x = 96; x < 100; ++x) world.grid.clear_voxel({x, y, z});
    }
  }
  world.grid.inflate();
  EXPECT_EQ(runner.run(world.grid, {10, 10, 10}, {98, 98, 18}), Status::kNoPath);
  EXPECT_LE(runner.units, 2u);
  EXPECT_EQ(runner.run(world.grid, {98, 98, 18}, {10, 10, 10}), Status::kNoPath);
  EXPECT_EQ(runner.search().expanded, 0u) << "no block of the goal's leads to the start's";
}

TEST(GuidedSearch, GridsWithTooManyBlocksHaveNoGuide) {
  VoxelWorld world({1, 2048, 2048});
  GuidedRunner runner;
  EXPECT_EQ(runner.run(world.grid, {0, 0, 0}, {0, 5, 5}), Status::kInvalidArgument);
}

}  // namespace
