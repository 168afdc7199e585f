// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What stages ask of a world, and a world that is made in slices.
#include "world/world.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "grid/lattice.hpp"
#include "support/corridor_reference.hpp"
#include "support/random.hpp"
#include "world/fences.hpp"

namespace tern_test {
namespace {

using tern::FenceKind;
using tern::Halfspace;
using tern::Status;
using tern::Vec3;
using tern::Voxel;

/// 3 x 3 x 2 m at 0.1 m, radius 0.15, with a keep-in about its middle and two oblique keep-outs.
struct FencedWorld {
  explicit FencedWorld(Random& random) : marked({30, 30, 20}, 0.1, 0.15) {
    marked.fill({10, 10, 0}, {12, 12, 20});
    marked.grid.inflate();
    for (const Vec3& middle : {Vec3{1.5, 1.5, 1.0}, Vec3{0.7, 0.8, 1.0}, Vec3{2.2, 2.1, 0.6}}) {
      const bool inside = fences.empty();
      planes.emplace_back();
      for (int k = 0; k < 5; ++k) {
        const Vec3 n{random.real(-1.0, 1.0), random.real(-1.0, 1.0), random.real(0.1, 1.0)};
        planes.back().push_back({n, dot3(n, middle) + (inside ? 1.2 : random.real(0.05, 0.3)) * norm3(n)});
      }
      fences.push_back({nullptr, 5, inside ? FenceKind::kKeepIn : FenceKind::kKeepOut});
    }
    for (std::size_t f = 0; f < fences.size(); ++f) fences[f].planes = planes[f].data();
    world_begin(*memory, marked.grid);
    EXPECT_EQ(world_add(*memory, fences.data(), 3).status, Status::kOk);
    EXPECT_EQ(world_prepare(*memory), Status::kOk);
  }
  tern::World world() const { return world_of(*memory); }

  MarkedWorld marked;
  std::vector<std::vector<Halfspace>> planes;
  std::vector<tern::Fence> fences;
  std::unique_ptr<tern::WorldMemory> memory = std::make_unique<tern::WorldMemory>();
};

TEST(World, OfVoxelsAloneIsTheCallersGrid) {
  const MarkedWorld marked({30, 30, 20}, 0.1, 0.15);
  const auto memory = std::make_unique<tern::WorldMemory>();
  world_begin(*memory, marked.grid);
  const tern::World world = world_of(*memory);
  EXPECT_EQ(&world.voxels(), &marked.grid);
  EXPECT_FALSE(world.has_solids());
  EXPECT_EQ(world.wall_count() + world.solid_count(), 0);
  EXPECT_EQ(world.first_broken({-1.0, 9.0, 0.0}, {4.0, 4.0, 4.0}), tern::kNoSolid);
  EXPECT_TRUE(world.line_clear({0.0, 0.0, 0.0}, {3.0, 3.0, 2.0}));
  EXPECT_FALSE(world.line_clear({0.0, 0.0, 0.0}, {3.0, 3.0, 2.1})) << "beyond the boundary";
}

TEST(World, NamesTheFirstThatAPointBreaks) {
  Random random(31);
  const FencedWorld fenced(random);
  const tern::World world = fenced.world();
  EXPECT_EQ(world.first_broken({1.5, 1.5, 1.0}, {1.5, 1.5, 1.0}), tern::kNoSolid);
  EXPECT_EQ(world.first_broken({0.7, 0.8, 1.0}, {0.7, 0.8, 1.0}), 1);
  EXPECT_EQ(world.first_broken({2.2, 2.1, 0.6}, {2.2, 2.1, 0.6}), 2);
  EXPECT_EQ(world.first_broken({0.7, 0.8, 1.0}, {9.0, 9.0, 9.0}), 0) << "walls come first";
}

/// A cube that breaks nothing is free in the blocked layer, and one that breaks a wall is not.
TEST(World, BlocksWhatCubesBreak) {
  Random random(32);
  for (int i = 0; i < scaled(20); ++i) {
    const FencedWorld fenced(random);
    tern::Work all{0xFFFFFFFFu};
    ASSERT_EQ(world_advance(*fenced.memory, all), tern::Progress::kDone);
    const tern::World world = fenced.world();
    for (int k = 0; k < 2000; ++k) {
      const Voxel v{random.integer(0, 29), random.integer(0, 29), random.integer(0, 19)};
      const std::int32_t over = world.first_over(cube_of(world.voxels(), v));
      if (over == tern::kNoSolid) {
        ASSERT_EQ(world.voxels().free(v), fenced.marked.grid.free(v));
      }
      if (over == 0) {
        ASSERT_FALSE(world.voxels().free(v));
      }
    }
  }
}

TEST(World, IsTheSameInSlices) {
  Random random(33);
  const FencedWorld once(random);
  Random again(33);
  const FencedWorld sliced(again);
  tern::Work all{0xFFFFFFFFu};
  ASSERT_EQ(world_advance(*once.memory, all), tern::Progress::kDone);
  std::uint32_t slices = 0;
  tern::Progress progress = tern::Progress::kMore;
  for (; progress == tern::Progress::kMore; ++slices) {
    tern::Work one_piece = tern::Work{1}.within(1);
    progress = world_advance(*sliced.memory, one_piece);
  }
  EXPECT_EQ(slices, 3u * 20u) << "a plane of voxels of each step";
  EXPECT_EQ(sliced.memory->steps, 3);
  for (int z = 0; z < 20; ++z) {
    for (int y = 0; y < 30; ++y) {
      ASSERT_EQ(once.world().voxels().blocked_row(y, z)[0], sliced.world().voxels().blocked_row(y, z)[0]);
    }
  }
}

}  // namespace
}  // namespace tern_test
