// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Floods around an end, against a plain A*: they say that there is no path where there is none, and nothing else. And
// the fast search, which uses them where its guide does not see that an end is walled in.
#include "guide/pocket.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "guide/voxel_search.hpp"
#include "support/path_world.hpp"
#include "support/reference_search.hpp"
#include "support/walled_world.hpp"

namespace {

using tern::Status;
using tern::Voxel;
using tern_test::Random;
using tern_test::scaled;
using tern_test::VoxelWorld;

class Pockets : public testing::Test {
 protected:
  Pockets() : search_(new tern::GuidedSearch) { std::memset(static_cast<void*>(search_.get()), 0xA5, sizeof *search_); }

  Status flood(const tern::Grid& grid, const Voxel& from, const Voxel& to) {
    units_ = 0;
    pocket_begin(*search_, grid, from);
    Status status = Status::kRunning;
    while (status == Status::kRunning && units_ < tern::kPocketBound) {
      ++units_;
      status = pocket_take(*search_, grid, to);
    }
    return status;
  }

  std::unique_ptr<tern::GuidedSearch> search_;
  std::uint32_t units_ = 0;
};

TEST_F(Pockets, NoPathWhereThereIsNone) {
  Random random(21);
  int none = 0;
  int some = 0;
  for (int k = 0; k < scaled(800); ++k) {
    const VoxelWorld world = k % 2 == 0 ? tern_test::random_world(random) : tern_test::walled_world(random);
    Voxel start{};
    Voxel goal{};
    if (!tern_test::random_ends(world.grid, random, start, goal)) continue;
    tern_test::ReferenceSearch reference(world.grid);
    const bool connected = reference.cost(start, goal) >= 0.0;
    const Status status = flood(world.grid, start, goal);
    const bool full = search_->store.count > tern::kPocketPages;
    ASSERT_TRUE(status == Status::kNodesFull || status == Status::kNoPath) << "ends within its bound";
    ASSERT_EQ(status == Status::kNodesFull, connected || full) << "case " << k;
    none += connected ? 0 : 1;
    some += connected && !full ? 1 : 0;
  }
  EXPECT_GT(none, 10);
  EXPECT_GT(some, 10);
}

TEST_F(Pockets, ALargeRoomIsTooMuch) {
  VoxelWorld world({200, 200, 40});
  world.block({190, 0, 0}, {190, 199, 39});
  EXPECT_EQ(flood(world.grid, {10, 10, 10}, {195, 10, 10}), Status::kNodesFull);
  EXPECT_GT(search_->store.count, tern::kPocketPages);
  EXPECT_LE(search_->store.count, tern::kPocketPages + tern::kSides);
}

/// A closed shell of two voxels, which splits the blocks that it passes.
VoxelWorld shell_about(const Voxel& from, std::int32_t inside) {
  VoxelWorld world({200, 200, 40});
  const Voxel to{from.x + inside + 3, from.y + inside + 3, from.z + inside + 3};
  world.block(from, {to.x, to.y, from.z + 1}).block({from.x, from.y, to.z - 1}, to);
  world.block(from, {to.x, from.y + 1, to.z}).block({from.x, to.y - 1, from.z}, to);
  world.block(from, {from.x + 1, to.y, to.z}).block({to.x - 1, from.y, from.z}, to);
  return world;
}

/// Entries that a fast search takes between the voxels, in slices; it must find that there is no path.
std::uint32_t units_of(const VoxelWorld& world, const Voxel& start, const Voxel& goal, std::uint32_t slice) {
  static const std::unique_ptr<tern::VoxelSearch> search(new tern::VoxelSearch);
  std::memset(static_cast<void*>(search.get()), 0xA5, sizeof *search);
  voxel_search_begin(*search, world.grid, start, goal, tern::SearchMode::kFast);
  Status status = Status::kRunning;
  while (status == Status::kRunning) {
    tern::Work work{slice};
    status = voxel_search_advance(*search, world.grid, work);
  }
  EXPECT_EQ(status, Status::kNoPath);
  EXPECT_NE(search->method, tern::SearchMethod::kOptimal);
  return search->entries;
}

TEST(ThinShells, TheFastSearchSeesThemFromInside) {
  const VoxelWorld world = shell_about({90, 90, 9}, 18);
  const Voxel inside{101, 101, 20};
  const Voxel outside{10, 10, 20};
  for (const bool from_inside : {true, false}) {
    const Voxel& start = from_inside ? inside : outside;
    const Voxel& goal = from_inside ? outside : inside;
    const std::uint32_t units = units_of(world, start, goal, 0xFFFFFFFFu);
    EXPECT_LT(units, 20000u) << from_inside;
    EXPECT_EQ(units_of(world, start, goal, 1), units);
    EXPECT_EQ(units_of(world, start, goal, 77), units);
  }
}

}  // namespace
