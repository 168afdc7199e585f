// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The open list and the node store against the standard library, and the bound on the units of a search.
#include "search/open_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>
#include <vector>

#include "search/search.hpp"
#include "support/path_world.hpp"
#include "support/random.hpp"

namespace {

using tern::NodeStore;
using tern::OpenKey;
using tern::OpenList;
using tern::Voxel;
using tern_test::Random;
using tern_test::random_voxel;

constexpr Voxel kDims{128, 100, 80};
constexpr Voxel kGoal{40, 50, 60};

/// Both structures, in memory that starts as garbage.
struct Fixture {
  Fixture() : store(new NodeStore), open(new OpenList) {
    std::memset(static_cast<void*>(store.get()), 0xA5, sizeof *store);
    std::memset(static_cast<void*>(open.get()), 0xA5, sizeof *open);
    tern::store_reset(*store, kDims);
    tern::open_reset(*open, 0);
  }

  /// Takes the first node off, as a search does; kMaxNodes where there is none.
  std::uint32_t take(tern::Cost& f) {
    for (int k = 0; k < 1 << 20 && open->count > 0; ++k) {
      if (!tern::open_ready(*open, *store, kGoal)) continue;
      const std::uint32_t node = tern::open_take(*open, *store, f);
      if (node != static_cast<std::uint32_t>(tern::kMaxNodes)) return node;
    }
    return static_cast<std::uint32_t>(tern::kMaxNodes);
  }

  std::unique_ptr<NodeStore> store;
  std::unique_ptr<OpenList> open;
};

/// As searches do it: nothing that is put in precedes what was taken last, keys improve, a node that was taken comes
/// back with the same key at most. Jumps reach far: f grows by up to 4000 voxels, so that the ring of bins is gone
/// round.
TEST(PathOpenList, TakesInTotalOrderWithKeysThatImprove) {
  Fixture f;
  Random random(21);
  std::map<std::uint32_t, OpenKey> reference;
  std::map<std::uint32_t, tern::Cost> taken;
  tern::Cost last = 0;
  int improved = 0;
  for (int round = 0; round < 60000; ++round) {
    if (reference.empty() || random.chance(0.55)) {
      // Few voxels and few distinct costs, so that ties and better ways are common.
      const Voxel voxel{round / 100 % 120 + random.integer(0, 5), round / 12000 * 8 + random.integer(0, 5),
                        random.integer(0, 2)};
      const std::uint32_t index = tern::store_find_or_add(*f.store, voxel);
      tern::SearchNode& node = f.store->nodes[index];
      const tern::Cost h = tern::octile(voxel, kGoal);
      const int far = random.chance(0.005) ? 4000 : 3;
      const tern::Cost g = last - (last < h ? last : h) +
                           (static_cast<tern::Cost>(random.integer(0, 4 * far)) << (tern::kCostFraction - 2));
      const OpenKey key = tern::open_key(g, h, node.voxel);
      const auto known = reference.find(index);
      const auto before_now = taken.find(index);
      if (before_now != taken.end() && before_now->second != key.f) continue;
      if (key.f < last || (known != reference.end() && !tern::before(key, known->second))) continue;
      improved += known != reference.end() ? 1 : 0;
      reference[index] = key;
      node.g = g;
      ASSERT_TRUE(tern::open_put(*f.open, *f.store, index, key));
    } else {
      const auto least = std::min_element(reference.begin(), reference.end(), [](const auto& a, const auto& b) {
        return tern::before(a.second, b.second);
      });
      const std::uint32_t node = f.take(last);
      ASSERT_EQ(node, least->first) << "round " << round;
      ASSERT_EQ(last, least->second.f);
      ASSERT_EQ(f.store->nodes[node].open, 0);
      taken[node] = last;
      reference.erase(least);
    }
    ASSERT_GE(f.open->count, static_cast<int>(reference.size()));
  }
  EXPECT_GT(improved, 50);
  EXPECT_GT(last, tern::Cost{100000} << tern::kCostFraction) << "the ring was not gone round";
}

/// Mirror images of a voxel about the goal, all as far from it: nothing but their order is left to decide.
TEST(PathOpenList, TiesAreTakenInTheOrderOfTheirVoxels) {
  Fixture f;
  std::map<std::uint32_t, std::uint32_t> nodes;  // by voxel
  for (const int k : {5, 2, 7, 0, 3, 6, 1, 4}) {
    const Voxel voxel{kGoal.x + ((k & 1) != 0 ? 3 : -3), kGoal.y + ((k & 2) != 0 ? 2 : -2),
                      kGoal.z + ((k & 4) != 0 ? 1 : -1)};
    const std::uint32_t index = tern::store_find_or_add(*f.store, voxel);
    tern::SearchNode& node = f.store->nodes[index];
    node.g = tern::kStraightCost;
    ASSERT_TRUE(
        tern::open_put(*f.open, *f.store, index, tern::open_key(node.g, tern::octile(voxel, kGoal), node.voxel)));
    nodes[node.voxel] = index;
  }
  tern::Cost cost = 0;
  for (const auto& [voxel, node] : nodes) EXPECT_EQ(f.take(cost), node) << voxel;
}

TEST(PathOpenList, PutsBackWhatItTakes) {
  Fixture f;
  tern::Cost cost = 0;
  EXPECT_EQ(f.take(cost), static_cast<std::uint32_t>(tern::kMaxNodes));
  const std::uint32_t node = tern::store_find_or_add(*f.store, kGoal);
  for (int k = 0; k < 3; ++k) {
    ASSERT_TRUE(tern::open_put(*f.open, *f.store, node, tern::open_key(0, 0, f.store->nodes[node].voxel)));
    EXPECT_EQ(f.take(cost), node);
    EXPECT_EQ(f.open->count, 0);
  }
  EXPECT_EQ(f.open->high, 1);
}

/// Opens the voxel (20 + k, 50, 60) with this f, in bins.
std::uint32_t open_at(Fixture& f, int k, std::uint64_t bin) {
  const Voxel voxel{20 + k % 100, 50, 60 - k / 100};
  const std::uint32_t index = tern::store_find_or_add(*f.store, voxel);
  tern::SearchNode& node = f.store->nodes[index];
  const tern::Cost h = tern::octile(voxel, kGoal);
  node.g = (bin << tern::kBinBits) - h;
  EXPECT_TRUE(tern::open_put(*f.open, *f.store, index, tern::open_key(node.g, h, node.voxel)));
  return index;
}

TEST(PathOpenList, IsNotReadyWithoutAnEntry) {
  Fixture f;
  EXPECT_FALSE(tern::open_ready(*f.open, *f.store, kGoal));
  EXPECT_EQ(f.open->count, 0);
}

TEST(PathOpenList, FindsTheBinsOfTheRingThatAreBehind) {
  Fixture f;
  tern::Cost cost = 0;
  const std::uint64_t first = 64 * 1000 + 10;
  const std::uint32_t near = open_at(f, 0, first);
  ASSERT_EQ(f.take(cost), near);
  // All but round: in the ring these lie before the first, in the same word of bins and in the one before.
  const std::uint32_t far = open_at(f, 1, first + tern::kBins - 3);
  const std::uint32_t nearer = open_at(f, 2, first + tern::kBins - 20);
  EXPECT_EQ(f.take(cost), nearer);
  EXPECT_EQ(f.take(cost), far);
  EXPECT_EQ(cost, (first + tern::kBins - 3) << tern::kBinBits);
  EXPECT_EQ(f.open->count, 0);
}

TEST(PathOpenList, PassesOverMoreEntriesThanOneCallMoves) {
  Fixture f;
  tern::Cost cost = 0;
  const std::uint64_t bin = 64 * 1000;
  const std::uint32_t last = open_at(f, 0, bin + 40);
  for (int k = 1; k <= 700; ++k) open_at(f, k, bin + 40);
  for (int k = 1; k <= 700; ++k) open_at(f, k, bin + 20);
  for (int k = 1; k <= 700; ++k) ASSERT_NE(f.take(cost), last);
  EXPECT_EQ(cost, (bin + 20) << tern::kBinBits);
  int calls = 1;
  while (!tern::open_ready(*f.open, *f.store, kGoal)) ++calls;
  EXPECT_EQ(calls, 3) << "256 of 701 entries a call";
  EXPECT_EQ(f.take(cost), last);
  EXPECT_EQ(cost, (bin + 40) << tern::kBinBits);
  EXPECT_EQ(f.open->count, 0);
}

TEST(PathOpenList, OrderIsCostThenHeuristicThenVoxel) {
  const tern::Cost one = tern::kStraightCost;
  EXPECT_TRUE(tern::before(tern::open_key(one, one, 9), tern::open_key(2 * one, one, 1)));
  EXPECT_TRUE(tern::before(tern::open_key(2 * one, one, 9), tern::open_key(one, 2 * one, 1)));
  EXPECT_TRUE(tern::before(tern::open_key(one, one, 1), tern::open_key(one, one, 2)));
  EXPECT_FALSE(tern::before(tern::open_key(one, one, 1), tern::open_key(one, one, 1)));
}

TEST(PathNodeStore, FindsWhatItHolds) {
  Fixture f;
  Random random(22);
  std::map<std::uint32_t, std::uint32_t> reference;
  for (int round = 0; round < 50000; ++round) {
    const Voxel voxel = random_voxel(random, kDims);
    const std::uint32_t index = tern::store_find_or_add(*f.store, voxel);
    const tern::SearchNode& node = f.store->nodes[index];
    const auto number = static_cast<std::uint32_t>(voxel.x + kDims.x * (voxel.y + kDims.y * voxel.z));
    const auto [known, added] = reference.emplace(number, static_cast<std::uint32_t>(reference.size()));
    ASSERT_EQ(index, known->second);
    ASSERT_EQ(node.voxel, number);
    ASSERT_TRUE(tern::same(node.at(), voxel));
    if (added) {
      ASSERT_EQ(node.arrivals, 0u);
      ASSERT_EQ(node.open, 0);
    }
  }
  EXPECT_EQ(f.store->count, reference.size());
}

/// Voxels that all have the same place in their blocks compete for few slots, and are told apart all the same.
TEST(PathNodeStore, FindsVoxelsThatShareTheirPlace) {
  Fixture f;
  std::uint32_t expected = 0;
  for (int pass = 0; pass < 2; ++pass) {
    expected = 0;
    for (int z = 3; z < kDims.z; z += 4) {
      for (int y = 3; y < kDims.y; y += 4) {
        for (int x = 3; x < kDims.x; x += 4) ASSERT_EQ(tern::store_find_or_add(*f.store, {x, y, z}), expected++);
      }
    }
  }
  EXPECT_EQ(f.store->count, expected);
}

TEST(PathNodeStore, ForgetsOnReset) {
  Fixture f;
  for (int x = 0; x < 100; ++x) tern::store_find_or_add(*f.store, {x, 7, 9});
  tern::store_reset(*f.store, kDims);
  EXPECT_EQ(tern::store_find_or_add(*f.store, {99, 7, 9}), 0u);
  EXPECT_EQ(tern::store_find_or_add(*f.store, {5, 7, 9}), 1u);
  EXPECT_EQ(f.store->count, 2u);
}

TEST(PathCost, OctileIsConsistentAndExact) {
  EXPECT_NEAR(static_cast<double>(tern::kPlaneDiagonalCost) / static_cast<double>(tern::kStraightCost), std::sqrt(2.0),
              2e-11);
  EXPECT_NEAR(static_cast<double>(tern::kSpaceDiagonalCost) / static_cast<double>(tern::kStraightCost), std::sqrt(3.0),
              2e-11);
  Random random(23);
  for (int k = 0; k < 20000; ++k) {
    const tern::Voxel a{random.integer(0, 99), random.integer(0, 99), random.integer(0, 99)};
    const tern::Voxel goal{random.integer(0, 99), random.integer(0, 99), random.integer(0, 99)};
    for (int d = 0; d < tern::kDirections; ++d) {
      if (d == tern::kHere) continue;
      EXPECT_LE(tern::octile(a, goal), tern::move_cost(d) + tern::octile(a + tern::offset(d), goal));
    }
  }
}

TEST(SearchBound, EndsTheSearchWithoutAnAnswer) {
  const tern_test::VoxelWorld world({40, 1, 1});
  const std::unique_ptr<tern::Search> search(new tern::Search);
  const auto end = [&](std::uint32_t units_left) {
    tern::search_begin(*search, world.grid, {0, 0, 0}, {5, 0, 0});
    search->units = tern::kExpansionBound - units_left;
    tern::Status status = tern::Status::kRunning;
    tern::Work work;
    while (status == tern::Status::kRunning) status = tern::search_expand(*search, world.grid, work);
    return status;
  };
  // Step by step, each voxel of the corridor takes one unit. All have the same f, so nothing is sorted.
  EXPECT_EQ(end(3), tern::Status::kNodesFull);
  EXPECT_EQ(search->expanded, 3u);
  EXPECT_EQ(search->units, tern::kExpansionBound);
  EXPECT_EQ(end(5), tern::Status::kNodesFull);
  EXPECT_EQ(end(6), tern::Status::kOk) << "the goal is the sixth voxel";
}

}  // namespace
